// Images whose colours are sRGB-encoded (EXT_sRGB): textures, renderbuffers, what is drawn to them.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

// 188 is the encoding of 0.5029, 137 that of 0.2502; 64 that of 0.0513.
constexpr uint32_t kEncoded = 0x804089bcu, kLinear = 0x800d4080u;

class Srgb : public CallTest {
 protected:
  void SetUp() override {
    CallTest::SetUp();
    glColor4f(1, 1, 1, 1);
  }

  static GLuint texture(GLenum format = GL_SRGB_ALPHA_EXT, uint32_t texel = kEncoded) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), 1, 1, 0, format, GL_UNSIGNED_BYTE,
                 &texel);
    glEnable(GL_TEXTURE_2D);
    EXPECT_ERROR(GL_NO_ERROR);
    return name;
  }
  static void bind_framebuffer(GLuint texture) {
    GLuint name = 0;
    glGenFramebuffersOES(1, &name);
    glBindFramebufferOES(GL_FRAMEBUFFER_OES, name);
    glFramebufferTexture2DOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, texture,
                              0);
  }
  static void bind_renderbuffer(GLenum internal) {
    GLuint name = 0, framebuffer = 0;
    glGenRenderbuffersOES(1, &name);
    glBindRenderbufferOES(GL_RENDERBUFFER_OES, name);
    glRenderbufferStorageOES(GL_RENDERBUFFER_OES, internal, kSize, kSize);
    glGenFramebuffersOES(1, &framebuffer);
    glBindFramebufferOES(GL_FRAMEBUFFER_OES, framebuffer);
    glFramebufferRenderbufferOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_RENDERBUFFER_OES,
                                 name);
  }
  static GLint encoding(GLenum attachment = GL_COLOR_ATTACHMENT0_OES) {
    GLint value = -1;
    glGetFramebufferAttachmentParameterivOES(GL_FRAMEBUFFER_OES, attachment,
                                             GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING_EXT, &value);
    EXPECT_ERROR(GL_NO_ERROR);
    return value;
  }
  static void clear_to(uint32_t linear) {
    glClearColor(
        static_cast<float>(linear & 255) / 255, static_cast<float>(linear >> 8 & 255) / 255,
        static_cast<float>(linear >> 16 & 255) / 255, static_cast<float>(linear >> 24) / 255);
    glClear(GL_COLOR_BUFFER_BIT);
  }
};

TEST_F(Srgb, TexturesAreDecoded) {
  texture();
  draw_quad();
  EXPECT_EQ(pixel(3, 3), kLinear);
  texture(GL_SRGB_EXT);
  draw_quad();
  EXPECT_EQ(pixel(3, 3), kLinear | 0xff000000u);
  const uint32_t other = kLinear;
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_SRGB_EXT, GL_UNSIGNED_BYTE, &other);
  draw_quad();
  EXPECT_EQ(pixel(3, 3), 0xff010d37u);  // 128, 64 and 13 decoded
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &other);
  draw_quad();
  EXPECT_EQ(pixel(3, 3), other);
}

// The texture of one unit is, that of the other is not.
TEST_F(Srgb, UnitsDiffer) {
  texture();
  glActiveTexture(GL_TEXTURE1);
  one_colour_texture(kEncoded);
  draw_quad();
  EXPECT_EQ(pixel(3, 3), kEncoded);
  glDisable(GL_TEXTURE_2D);
  draw_quad();
  EXPECT_EQ(pixel(3, 3), kLinear);
}

TEST_F(Srgb, FramebuffersOfTextures) {
  bind_framebuffer(texture());
  EXPECT_EQ(glCheckFramebufferStatusOES(GL_FRAMEBUFFER_OES),
            static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE_OES));
  EXPECT_EQ(encoding(), GL_SRGB_EXT);
  EXPECT_EQ(pixel(0, 0), kEncoded);  // as it is stored
  glViewport(0, 0, 1, 1);
  clear_to(0xff00ff00u);
  EXPECT_EQ(pixel(0, 0), 0xff00ff00u);
  clear_to(0xff0d4080u);
  EXPECT_EQ(pixel(0, 0), 0xff4089bcu);
  glDisable(GL_TEXTURE_2D);
  glColor4ub(0x80, 0x40, 0x0d, 0x80);
  draw_quad();
  EXPECT_EQ(pixel(0, 0), kEncoded);
}

TEST_F(Srgb, Renderbuffers) {
  bind_renderbuffer(GL_SRGB8_ALPHA8_EXT);
  EXPECT_EQ(glCheckFramebufferStatusOES(GL_FRAMEBUFFER_OES),
            static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE_OES));
  EXPECT_EQ(encoding(), GL_SRGB_EXT);
  for (const GLenum size : {GL_RENDERBUFFER_RED_SIZE_OES, GL_RENDERBUFFER_GREEN_SIZE_OES,
                            GL_RENDERBUFFER_BLUE_SIZE_OES, GL_RENDERBUFFER_ALPHA_SIZE_OES}) {
    GLint bits = 0;
    glGetRenderbufferParameterivOES(GL_RENDERBUFFER_OES, size, &bits);
    EXPECT_EQ(bits, 8);
  }
  clear_to(0xff808080u);
  EXPECT_EQ(pixel(0, 0), 0xffbcbcbcu);
  // Half of white over it: 188 is 0.5029.
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glColor4f(1, 1, 1, 0.5f);
  draw_quad();
  const double mean = 1.055 * std::pow(0.5 + 0.5 * 0.5029, 1 / 2.4) - 0.055;
  EXPECT_NEAR(pixel(0, 0) & 255, mean * 255, 0.51);
}

TEST_F(Srgb, OtherFramebuffersAreLinear) {
  bind_renderbuffer(GL_RGBA8_OES);
  EXPECT_EQ(encoding(), GL_LINEAR);
  clear_to(0x80808080u);
  EXPECT_EQ(pixel(0, 0), 0x80808080u);
  GLuint depth = 0;
  glGenRenderbuffersOES(1, &depth);
  glBindRenderbufferOES(GL_RENDERBUFFER_OES, depth);
  glRenderbufferStorageOES(GL_RENDERBUFFER_OES, GL_DEPTH_COMPONENT24_OES, kSize, kSize);
  glFramebufferRenderbufferOES(GL_FRAMEBUFFER_OES, GL_DEPTH_ATTACHMENT_OES, GL_RENDERBUFFER_OES,
                               depth);
  EXPECT_EQ(encoding(GL_DEPTH_ATTACHMENT_OES), GL_LINEAR);
  bind_framebuffer(one_colour_texture(kWhite));
  EXPECT_EQ(encoding(), GL_LINEAR);
}

// A texture that is drawn to, given in another format of the same size: no more encoded.
TEST_F(Srgb, TheFormatOfATargetChanges) {
  const GLuint name = texture();
  bind_framebuffer(name);
  glViewport(0, 0, 1, 1);
  glDisable(GL_TEXTURE_2D);
  glColor4ub(0x80, 0x40, 0x0d, 0x80);
  for (const GLenum format : {GL_SRGB_ALPHA_EXT, GL_RGBA, GL_SRGB_ALPHA_EXT}) {
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), 1, 1, 0, format, GL_UNSIGNED_BYTE,
                 nullptr);
    draw_quad();
    EXPECT_EQ(pixel(0, 0), format == GL_RGBA ? kLinear : kEncoded);
  }
}

TEST_F(Srgb, SeveralSamples) {
  const GLuint name = texture();
  GLuint framebuffer = 0;
  glGenFramebuffersOES(1, &framebuffer);
  glBindFramebufferOES(GL_FRAMEBUFFER_OES, framebuffer);
  glFramebufferTexture2DMultisampleEXT(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D,
                                       name, 0, 4);
  glViewport(0, 0, 1, 1);
  glDisable(GL_TEXTURE_2D);
  clear_to(0xff000000u);
  const float kHalf[] = {-1, -1, 0, -1, -1, 1, 0, 1};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, kHalf);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  EXPECT_EQ(pixel(0, 0), 0xffbcbcbcu);  // 0.5, encoded
}

// 3.7.11: mipmaps of encoded colours are not generated.
TEST_F(Srgb, NoMipmapIsGenerated) {
  texture();
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  const auto image = [](GLenum format) {
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), 4, 4, 0, format, GL_UNSIGNED_BYTE,
                 texels(kEncoded, 4).data());
  };
  image(GL_SRGB_ALPHA_EXT);
  clear_to(kRed);
  glColor4ub(0, 255, 0, 255);
  draw_quad();
  EXPECT_EQ(pixel(0, 0), kGreen);  // not complete
  image(GL_RGBA);
  draw_quad();
  EXPECT_EQ(pixel(0, 0), kEncoded);
}

}  // namespace
}  // namespace clearpipe::api
