// EXT_multisampled_render_to_texture: textures and renderbuffers with samples, and what becomes of
// the samples when the texture is used otherwise.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <set>

#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

constexpr GLenum kFb = GL_FRAMEBUFFER_OES, kRb = GL_RENDERBUFFER_OES;
constexpr GLenum kColourPoint = GL_COLOR_ATTACHMENT0_OES;

class MultisampledTexture : public CallTest {
 protected:
  using Picture = std::array<uint32_t, kSize * kSize>;

  void SetUp() override {
    CallTest::SetUp();
    glGenFramebuffersOES(1, &framebuffer_);
    glBindFramebufferOES(kFb, framebuffer_);
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    fill_texture(0xff000000u, kSize);
  }
  void attach(GLsizei samples = 4, GLint level = 0) {
    glFramebufferTexture2DMultisampleEXT(kFb, kColourPoint, GL_TEXTURE_2D, texture_, level,
                                         samples);
  }
  static GLuint renderbuffer(GLenum point, GLenum format, GLsizei samples) {
    GLuint name = 0;
    glGenRenderbuffersOES(1, &name);
    glBindRenderbufferOES(kRb, name);
    glRenderbufferStorageMultisampleEXT(kRb, samples, format, kSize, kSize);
    glFramebufferRenderbufferOES(kFb, point, kRb, name);
    return name;
  }
  static GLenum status() { return glCheckFramebufferStatusOES(kFb); }
  static GLint integer(GLenum name) {
    GLint value = -1;
    glGetIntegerv(name, &value);
    return value;
  }
  static GLint attached(GLenum name) {
    GLint value = -1;
    glGetFramebufferAttachmentParameterivOES(kFb, kColourPoint, name, &value);
    return value;
  }
  static GLint samples_of_renderbuffer() {
    GLint value = -1;
    glGetRenderbufferParameterivOES(kRb, GL_RENDERBUFFER_SAMPLES_EXT, &value);
    return value;
  }
  // Half of the picture, below a slanted edge, or above it.
  static void draw_slanted(bool above = false) {
    const float lower[] = {-1, -1, 1, -1, 1, 0.45f, -1, -1, 1, 0.45f, -1, -0.45f};
    const float upper[] = {-1, -0.45f, 1, 0.45f, 1, 1, -1, -0.45f, 1, 1, -1, 1};
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, above ? upper : lower);
    glDrawArrays(GL_TRIANGLES, 0, 6);
  }
  static Picture read() {
    Picture picture{};
    glReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
    return picture;
  }
  static std::set<uint32_t> colours(const Picture& picture) {
    return {picture.begin(), picture.end()};
  }
  // What the texture shows when it is drawn.
  Picture sampled() {
    glBindFramebufferOES(kFb, 0);
    glEnable(GL_TEXTURE_2D);
    draw_quad();
    glDisable(GL_TEXTURE_2D);
    const Picture picture = read();
    glBindFramebufferOES(kFb, framebuffer_);
    return picture;
  }
  static void add_colours() {
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
  }

  static inline const std::set<uint32_t> kSteps = {0xff000000u, 0xff404040u, 0xff808080u,
                                                   0xffbfbfbfu, 0xffffffffu};
  GLuint framebuffer_ = 0, texture_ = 0;
};

TEST_F(MultisampledTexture, QueriesTellTheSamples) {
  EXPECT_EQ(integer(GL_MAX_SAMPLES_EXT), 4);
  for (const GLsizei samples : {0, 1, 2, 3, 4}) {
    const GLint kept = samples == 0 ? 0 : 4;
    attach(samples);
    EXPECT_EQ(attached(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_SAMPLES_EXT), kept);
    EXPECT_EQ(attached(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME_OES), static_cast<GLint>(texture_));
    renderbuffer(GL_DEPTH_ATTACHMENT_OES, GL_DEPTH_COMPONENT16_OES, samples);
    EXPECT_EQ(samples_of_renderbuffer(), kept);
    EXPECT_EQ(status(), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE_OES));
    EXPECT_EQ(integer(GL_SAMPLES), kept);
    EXPECT_EQ(integer(GL_SAMPLE_BUFFERS), kept / 4);
  }
  // The commands without samples take them away.
  glRenderbufferStorageOES(kRb, GL_DEPTH_COMPONENT16_OES, kSize, kSize);
  EXPECT_EQ(samples_of_renderbuffer(), 0);
  glFramebufferTexture2DOES(kFb, kColourPoint, GL_TEXTURE_2D, texture_, 0);
  EXPECT_EQ(attached(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_SAMPLES_EXT), 0);
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(MultisampledTexture, SamplesOfAllAttachmentsMustBeTheSame) {
  attach(4);
  renderbuffer(GL_DEPTH_ATTACHMENT_OES, GL_DEPTH24_STENCIL8_OES, 0);
  EXPECT_EQ(status(), static_cast<GLenum>(GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE_EXT));
  glClear(GL_COLOR_BUFFER_BIT);
  EXPECT_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION_OES);
  attach(0);
  EXPECT_EQ(status(), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE_OES));
  renderbuffer(GL_STENCIL_ATTACHMENT_OES, GL_DEPTH24_STENCIL8_OES, 2);
  EXPECT_EQ(status(), static_cast<GLenum>(GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE_EXT));
}

TEST_F(MultisampledTexture, EdgesAreResolvedIntoTheTexture) {
  attach();
  draw_slanted();
  const Picture drawn = read();
  EXPECT_EQ(colours(drawn), kSteps);
  EXPECT_EQ(sampled(), drawn);
}

TEST_F(MultisampledTexture, RenderbuffersHaveSamples) {
  renderbuffer(kColourPoint, GL_RGB8_OES, 4);
  renderbuffer(GL_DEPTH_ATTACHMENT_OES, GL_DEPTH_COMPONENT24_OES, 4);
  ASSERT_EQ(status(), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE_OES));
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  draw_slanted();
  EXPECT_EQ(colours(read()), kSteps);
  // Behind it: nothing shines through.
  glDepthFunc(GL_GREATER);
  glColor4f(1, 0, 0, 1);
  const Picture before = read();
  draw_slanted();
  EXPECT_EQ(before, read());
}

// Drawn in two calls the halves meet, as long as nothing happens in between that discards samples.
// Reading might; here it does not.
TEST_F(MultisampledTexture, SamplesAreKeptBetweenDraws) {
  attach();
  add_colours();
  draw_slanted(false);
  EXPECT_EQ(colours(read()), kSteps);
  draw_slanted(true);
  EXPECT_EQ(colours(read()), (std::set<uint32_t>{0xffffffffu}));
}

// What was there before counts for every sample.
TEST_F(MultisampledTexture, DrawingStartsFromTheTexture) {
  fill_texture(0xff204060u, kSize);
  attach();
  add_colours();
  glColor4f(0.25f, 0, 0, 1);
  draw_slanted();
  for (const uint32_t colour : read()) EXPECT_EQ(colour & 0xffffff00u, 0xff204000u);
  EXPECT_EQ(read()[0], 0xff2040a0u);
}

// After other uses each sample is what the texture holds for its pixel.
TEST_F(MultisampledTexture, OtherUsesReplaceTheSamples) {
  attach();
  draw_slanted();
  glFinish();
  const uint32_t texel = 0xff123456u;
  glTexSubImage2D(GL_TEXTURE_2D, 0, 8, 8, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &texel);
  add_colours();
  glColor4f(0, 0, 0, 0);
  draw_quad();
  EXPECT_EQ(pixel(8, 8), texel);

  fill_texture(0xff888888u, kSize);
  draw_quad();
  EXPECT_EQ(colours(read()), (std::set<uint32_t>{0xff888888u}));

  // Drawn to without samples meanwhile.
  glFramebufferTexture2DOES(kFb, kColourPoint, GL_TEXTURE_2D, texture_, 0);
  glDisable(GL_BLEND);
  glColor4f(0, 1, 0, 1);
  draw_quad();
  attach();
  add_colours();
  glColor4f(1, 0, 0, 0);
  draw_slanted();
  EXPECT_EQ(pixel(0, kSize - 1), kGreen);
  EXPECT_EQ(pixel(0, 0), 0xff00ffffu);

  // And through another framebuffer object.
  GLuint other = 0;
  glGenFramebuffersOES(1, &other);
  glBindFramebufferOES(kFb, other);
  glFramebufferTexture2DOES(kFb, kColourPoint, GL_TEXTURE_2D, texture_, 0);
  glClearColor(0, 0, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glBindFramebufferOES(kFb, framebuffer_);
  glColor4f(1, 0, 0, 0);
  draw_slanted();
  EXPECT_EQ(pixel(0, kSize - 1), kBlue);
  EXPECT_EQ(pixel(0, 0), 0xffff00ffu);
}

// The level takes another size while it is attached.
TEST_F(MultisampledTexture, TheBufferFollowsTheSizeOfTheLevel) {
  attach();
  draw_slanted();
  fill_texture(0xff000000u, 200);
  glViewport(0, 0, 200, 200);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  draw_slanted();
  std::vector<uint32_t> all(200 * 200);
  glReadPixels(0, 0, 200, 200, GL_RGBA, GL_UNSIGNED_BYTE, all.data());
  EXPECT_EQ(std::set<uint32_t>(all.begin(), all.end()), kSteps);
  EXPECT_EQ(pixel(199, 199), 0xff000000u);
  EXPECT_EQ(pixel(199, 0), 0xffffffffu);
}

TEST_F(MultisampledTexture, AnyLevelHasSamples) {
  glTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, kSize / 2, kSize / 2, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               texels(0xff000000u, kSize / 2).data());
  attach(4, 1);
  EXPECT_EQ(attached(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL_OES), 1);
  glViewport(0, 0, kSize / 2, kSize / 2);
  draw_slanted();
  std::set<uint32_t> found;
  for (int y = 0; y < kSize / 2; ++y) {
    for (int x = 0; x < kSize / 2; ++x) found.insert(pixel(x, y));
  }
  EXPECT_TRUE(found.count(0xff404040u) && found.count(0xffbfbfbfu));
}

TEST_F(MultisampledTexture, FacesOfCubeMapsHaveSamples) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_CUBE_MAP_OES, name);
  const auto black = texels(0xff000000u, kSize);
  for (GLenum face = 0; face < 6; ++face) {
    glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face, 0, GL_RGBA, kSize, kSize, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, black.data());
  }
  const auto attach_face = [name](GLenum face) {
    glFramebufferTexture2DMultisampleEXT(kFb, kColourPoint, face, name, 0, 4);
  };
  attach_face(GL_TEXTURE_CUBE_MAP_NEGATIVE_Y_OES);
  add_colours();
  draw_slanted(false);
  const Picture half = read();
  EXPECT_EQ(colours(half), kSteps);
  attach_face(GL_TEXTURE_CUBE_MAP_POSITIVE_Z_OES);
  EXPECT_EQ(colours(read()), (std::set<uint32_t>{0xff000000u}));
  attach_face(GL_TEXTURE_CUBE_MAP_NEGATIVE_Y_OES);
  EXPECT_EQ(attached(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_SAMPLES_EXT), 4);
  EXPECT_EQ(read(), half);
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(MultisampledTexture, DeletionWhileAttached) {
  attach();
  draw_slanted();
  glDeleteTextures(1, &texture_);
  EXPECT_EQ(status(), static_cast<GLenum>(GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT_OES));
  EXPECT_EQ(integer(GL_SAMPLES), 0);
}

}  // namespace
}  // namespace clearpipe::api
