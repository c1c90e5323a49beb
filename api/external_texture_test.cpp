// External textures (OES_EGL_image_external, 3.7.14): they have the image of an EGLImage and no
// other, one level, and no repetition.
// SPDX-License-Identifier: MIT
#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

constexpr GLenum kExternal = GL_TEXTURE_EXTERNAL_OES;
constexpr uint32_t kBlack = 0xff000000u;

class ExternalTexture : public CallTest {
 protected:
  void TearDown() override {
    destroy_egl_image(&image_);
    CallTest::TearDown();
  }
  // Shares a new texture of one colour. It is bound, and not enabled.
  GLuint share(uint32_t colour, GLsizei size = 1) {
    const GLuint name = one_colour_texture(colour, size);
    glDisable(k2D);
    EXPECT_EQ(create_egl_image(context_, ImageSource::kTexture2D, name, 0, &image_),
              ImageError::kNone);
    return name;
  }
  // A new external texture, bound and enabled.
  static GLuint external() {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(kExternal, name);
    glEnable(kExternal);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    return name;
  }
  static GLint parameter(GLenum pname, GLenum target = kExternal) {
    GLint value = -1;
    glGetTexParameteriv(target, pname, &value);
    return value;
  }
  static uint32_t drawn() {
    glClear(GL_COLOR_BUFFER_BIT);
    draw_quad();
    return pixel(3, 5);
  }
  char image_ = 0;  // its address is the handle
};

TEST_F(ExternalTexture, InitialState) {
  for (const bool named : {false, true}) {
    if (named) external();
    EXPECT_EQ(parameter(GL_TEXTURE_MIN_FILTER), GL_LINEAR);
    EXPECT_EQ(parameter(GL_TEXTURE_MAG_FILTER), GL_LINEAR);
    EXPECT_EQ(parameter(GL_TEXTURE_WRAP_S), GL_CLAMP_TO_EDGE);
    EXPECT_EQ(parameter(GL_TEXTURE_WRAP_T), GL_CLAMP_TO_EDGE);
    EXPECT_EQ(parameter(GL_GENERATE_MIPMAP), GL_FALSE);
    for (const GLenum target : {k2D, kCube, kExternal}) {
      EXPECT_EQ(parameter(GL_REQUIRED_TEXTURE_IMAGE_UNITS_OES, target), 1);
    }
  }
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(ExternalTexture, BlackWithoutAnImage) {
  external();
  glClearColor(1, 1, 1, 0);
  EXPECT_EQ(drawn(), kBlack);
  EXPECT_ERROR(GL_NO_ERROR);
  // As the object that is there from the start is.
  glBindTexture(kExternal, 0);
  EXPECT_EQ(drawn(), kBlack);
  // It has no size that rectangles could be measured with.
  const GLint crop[] = {0, 0, 5, 5};
  glTexParameteriv(kExternal, GL_TEXTURE_CROP_RECT_OES, crop);
  glClear(GL_COLOR_BUFFER_BIT);
  glDrawTexiOES(0, 0, 0, kSize, kSize);
  EXPECT_EQ(pixel(3, 5), kBlack);
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(ExternalTexture, HasTheImage) {
  share(kGreen);
  external();
  glEGLImageTargetTexture2DOES(kExternal, &image_);
  EXPECT_ERROR(GL_NO_ERROR);
  EXPECT_EQ(drawn(), kGreen);
  // What is uploaded to the source shows.
  glTexSubImage2D(k2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &kBlue);
  EXPECT_EQ(drawn(), kBlue);
  // The default object takes one as well, and is another object.
  glBindTexture(kExternal, 0);
  EXPECT_EQ(drawn(), kBlack);
  glEGLImageTargetTexture2DOES(kExternal, &image_);
  EXPECT_EQ(drawn(), kBlue);
}

TEST_F(ExternalTexture, ImagesWithoutAlphaAreOpaque) {
  const GLuint name = one_colour_texture(kRed);
  glDisable(k2D);
  const uint8_t rgb[] = {255, 0, 255};
  glTexImage2D(k2D, 0, GL_RGB, 1, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, rgb);
  ASSERT_EQ(create_egl_image(context_, ImageSource::kTexture2D, name, 0, &image_),
            ImageError::kNone);
  external();
  glEGLImageTargetTexture2DOES(kExternal, &image_);
  EXPECT_EQ(drawn(), 0xffff00ffu);
}

TEST_F(ExternalTexture, GoesBeforeTheOtherTargets) {
  share(kRed);
  glEnable(k2D);
  EXPECT_EQ(drawn(), kRed);
  const GLuint name = external();  // of other targets' bindings nothing has changed
  EXPECT_EQ(drawn(), kBlack);
  glEnable(kCube);
  EXPECT_EQ(drawn(), kBlack);
  glDisable(kCube);
  EXPECT_TRUE(glIsEnabled(kExternal));
  glDisable(kExternal);
  EXPECT_EQ(drawn(), kRed);
  GLint bound = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_EXTERNAL_OES, &bound);
  EXPECT_EQ(static_cast<GLuint>(bound), name);
  glDeleteTextures(1, &name);
  glGetIntegerv(GL_TEXTURE_BINDING_EXTERNAL_OES, &bound);
  EXPECT_EQ(bound, 0);
}

// Units have bindings of their own, and each its environment.
TEST_F(ExternalTexture, OnTheSecondUnit) {
  share(0xff808080u);
  glEnable(k2D);
  glActiveTexture(GL_TEXTURE1);
  external();
  glEGLImageTargetTexture2DOES(kExternal, &image_);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);
  EXPECT_EQ(drawn() & 0xffffffu, 0xffffffu);
  glActiveTexture(GL_TEXTURE0);
  GLint bound = -1;
  glGetIntegerv(GL_TEXTURE_BINDING_EXTERNAL_OES, &bound);
  EXPECT_EQ(bound, 0);
}

TEST_F(ExternalTexture, FilteredAndClamped) {
  const GLuint name = one_colour_texture(0);
  glDisable(k2D);
  const uint32_t columns[] = {kRed, kBlue};
  glTexImage2D(k2D, 0, GL_RGBA, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, columns);
  ASSERT_EQ(create_egl_image(context_, ImageSource::kTexture2D, name, 0, &image_),
            ImageError::kNone);
  external();
  glEGLImageTargetTexture2DOES(kExternal, &image_);
  drawn();
  EXPECT_EQ(pixel(1, 1), kRed);  // the edge, not the mean with the other side
  EXPECT_EQ(pixel(kSize - 2, 1), kBlue);
  const uint32_t middle = pixel(kSize / 2, 1);
  EXPECT_NEAR(middle & 255, 120, 16);
  EXPECT_NEAR(middle >> 16 & 255, 136, 16);
  glTexParameteri(kExternal, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(kExternal, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  drawn();
  EXPECT_EQ(pixel(kSize / 2, 1), kBlue);
  EXPECT_ERROR(GL_NO_ERROR);
}

// Drawing to the source while the external texture samples it: what is there at each draw.
TEST_F(ExternalTexture, SourceIsDrawnTo) {
  const GLuint source = share(kRed, 4);
  external();
  glEGLImageTargetTexture2DOES(kExternal, &image_);
  GLuint framebuffer = 0;
  glGenFramebuffersOES(1, &framebuffer);
  for (const float green : {0.0f, 1.0f}) {
    glBindFramebufferOES(GL_FRAMEBUFFER_OES, framebuffer);
    glFramebufferTexture2DOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, k2D, source, 0);
    glClearColor(0, green, 1 - green, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glBindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
    draw_half(static_cast<int>(green));
  }
  EXPECT_EQ(left(), kBlue);
  EXPECT_EQ(right(), kGreen);
}

}  // namespace
}  // namespace clearpipe::api
