// EGLImages of pixmaps (EGL_KHR_image_pixmap): textures and renderbuffers that hold what the server
// draws, and what they give back to it.
// SPDX-License-Identifier: MIT
#include "icd/x11_test.h"

namespace clearpipe::icd {
namespace {

class X11ImageTest : public X11Test {
 protected:
  void SetUp() override {
    X11Test::SetUp();
    depth_ = static_cast<unsigned>(DefaultDepth(x_, DefaultScreen(x_)));
    pixmap_ = XCreatePixmap(x_, DefaultRootWindow(x_), 20, 12, depth_);
    fill(0, 0, 0, 20, 12);
    surface_ = window_surface(window());
    ASSERT_TRUE(eglMakeCurrent(display, surface_, surface_, context()));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
  void fill(unsigned long value, int x, int y, unsigned width, unsigned height) {
    const GC gc = XCreateGC(x_, pixmap_, 0, nullptr);
    XSetForeground(x_, gc, value);
    XFillRectangle(x_, pixmap_, gc, x, y, width, height);
    XFreeGC(x_, gc);
    XSync(x_, False);
  }
  unsigned long red() { return DefaultVisual(x_, DefaultScreen(x_))->red_mask; }
  unsigned long green() { return DefaultVisual(x_, DefaultScreen(x_))->green_mask; }
  EGLImageKHR image_of(Pixmap pixmap, const EGLint* list = nullptr, EGLContext ctx = nullptr) {
    return create_(display, ctx, EGL_NATIVE_PIXMAP_KHR, reinterpret_cast<EGLClientBuffer>(pixmap),
                   list);
  }
  // The bound texture over all of the window, which is 16 pixels wide and high.
  static void draw() {
    const GLfloat corners[] = {-1, -1, 1, -1, -1, 1, 1, 1}, places[] = {0, 0, 1, 0, 0, 1, 1, 1};
    glEnable(GL_TEXTURE_2D);
    glColor4f(1, 1, 1, 1);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, corners);
    glTexCoordPointer(2, GL_FLOAT, 0, places);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glDisable(GL_TEXTURE_2D);
  }
  static uint32_t drawn(int x, int y) {
    draw();
    return pixel(x, y);
  }

  unsigned depth_ = 24;
  Pixmap pixmap_ = 0;
  EGLSurface surface_ = nullptr;
  PFNEGLCREATEIMAGEKHRPROC create_ = proc<PFNEGLCREATEIMAGEKHRPROC>("eglCreateImageKHR");
  PFNEGLDESTROYIMAGEKHRPROC destroy_ = proc<PFNEGLDESTROYIMAGEKHRPROC>("eglDestroyImageKHR");
  PFNGLEGLIMAGETARGETTEXTURE2DOESPROC texture_ =
      proc<PFNGLEGLIMAGETARGETTEXTURE2DOESPROC>("glEGLImageTargetTexture2DOES");
  PFNGLEGLIMAGETARGETRENDERBUFFERSTORAGEOESPROC renderbuffer_ =
      proc<PFNGLEGLIMAGETARGETRENDERBUFFERSTORAGEOESPROC>("glEGLImageTargetRenderbufferStorageOES");
  PFNGLBINDFRAMEBUFFEROESPROC bind_framebuffer_ =
      proc<PFNGLBINDFRAMEBUFFEROESPROC>("glBindFramebufferOES");
  PFNGLFRAMEBUFFERTEXTURE2DOESPROC attach_texture_ =
      proc<PFNGLFRAMEBUFFERTEXTURE2DOESPROC>("glFramebufferTexture2DOES");
  PFNGLFRAMEBUFFERRENDERBUFFEROESPROC attach_renderbuffer_ =
      proc<PFNGLFRAMEBUFFERRENDERBUFFEROESPROC>("glFramebufferRenderbufferOES");
  PFNGLBINDRENDERBUFFEROESPROC bind_renderbuffer_ =
      proc<PFNGLBINDRENDERBUFFEROESPROC>("glBindRenderbufferOES");
};

TEST_F(X11ImageTest, Offered) {
  const auto names = words(eglQueryString(display, EGL_EXTENSIONS));
  EXPECT_EQ(names.count("EGL_KHR_image_pixmap"), 1u);
  EXPECT_EQ(names.count("EGL_KHR_image"), 1u);
  EXPECT_EQ(names.count("EGL_KHR_image_base"), 1u);
}

// A texture has the pixmap's lower row at t = 0, as surfaces of pixmaps have it at y = 0.
TEST_F(X11ImageTest, ATextureHoldsWhatTheServerDrew) {
  fill(red(), 0, 0, 20, 6);
  const EGLint preserved[] = {EGL_IMAGE_PRESERVED, EGL_TRUE, EGL_GL_TEXTURE_LEVEL, 9, EGL_NONE};
  const EGLImageKHR image = image_of(pixmap_, preserved);
  ASSERT_NE(image, EGL_NO_IMAGE_KHR);
  texture_(GL_TEXTURE_2D, image);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  EXPECT_EQ(drawn(3, 15), kRed);
  EXPECT_EQ(drawn(3, 0), kBlack);
  // The server draws: seen after eglWaitNative.
  fill(green(), 0, 6, 10, 6);
  EXPECT_EGL_OK(eglWaitNative(EGL_CORE_NATIVE_ENGINE));
  EXPECT_EQ(drawn(3, 0), kGreen);
  EXPECT_EQ(drawn(12, 0), kBlack);
  EXPECT_EQ(drawn(3, 15), kRed);
  // Or by whoever makes a texture of it next.
  fill(red(), 0, 6, 20, 6);
  GLuint other = 0;
  glGenTextures(1, &other);
  glBindTexture(GL_TEXTURE_2D, other);
  texture_(GL_TEXTURE_2D, image);
  glBindTexture(GL_TEXTURE_2D, 0);
  EXPECT_EQ(drawn(3, 0), kRed);
  // Without its handle it is still the pixmap's.
  EXPECT_EGL_OK(destroy_(display, image));
  fill(green(), 0, 0, 20, 12);
  EXPECT_EGL_OK(eglWaitNative(EGL_CORE_NATIVE_ENGINE));
  EXPECT_EQ(drawn(3, 3), kGreen);
}

TEST_F(X11ImageTest, WhatIsDrawnComesToThePixmap) {
  const EGLImageKHR image = image_of(pixmap_);
  texture_(GL_TEXTURE_2D, image);
  bind_framebuffer_(GL_FRAMEBUFFER_OES, 1);
  attach_texture_(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, 0, 0);
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  texture_(GL_TEXTURE_2D, image);
  attach_texture_(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, name, 0);
  clear(kGreen);
  clear_part(kRed, 0, 0, 5, 4);
  glFlush();
  EXPECT_EQ(shown(pixmap_, 0, 11), kRed);
  EXPECT_EQ(shown(pixmap_, 4, 8), kRed);
  EXPECT_EQ(shown(pixmap_, 5, 11), kGreen);
  EXPECT_EQ(shown(pixmap_, 0, 0), kGreen);
  clear(kBlue);
  glFinish();
  EXPECT_EQ(shown(pixmap_, 0, 0), kBlue);
  clear(kWhite);
  EXPECT_EGL_OK(eglWaitClient());
  EXPECT_EQ(shown(pixmap_, 7, 7), kWhite);
  bind_framebuffer_(GL_FRAMEBUFFER_OES, 0);
  // Uploads count as well.
  const uint32_t texel = kRed;
  glTexSubImage2D(GL_TEXTURE_2D, 0, 2, 1, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, &texel);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  glFlush();
  EXPECT_EQ(shown(pixmap_, 2, 10), kRed);
  EXPECT_EQ(shown(pixmap_, 2, 9), kWhite);
  // A renderbuffer of the same image sees it, and what the server draws, and is drawn to.
  bind_renderbuffer_(GL_RENDERBUFFER_OES, 1);
  renderbuffer_(GL_RENDERBUFFER_OES, image);
  bind_framebuffer_(GL_FRAMEBUFFER_OES, 2);
  attach_renderbuffer_(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_RENDERBUFFER_OES, 1);
  EXPECT_EQ(pixel(2, 1), kRed);
  fill(green(), 2, 10, 1, 1);
  EXPECT_EGL_OK(eglWaitNative(EGL_CORE_NATIVE_ENGINE));
  EXPECT_EQ(pixel(2, 1), kGreen);
  clear_part(kBlue, 3, 3, 1, 1);
  EXPECT_EGL_OK(eglMakeCurrent(display, nullptr, nullptr, nullptr));
  EXPECT_EQ(shown(pixmap_, 3, 8), kBlue);
  EXPECT_EQ(shown(pixmap_, 2, 10), kGreen);
}

TEST_F(X11ImageTest, ImageErrors) {
  EXPECT_EGL_FAIL(image_of(0), EGL_NO_IMAGE_KHR, EGL_BAD_PARAMETER);
  EXPECT_EGL_FAIL(image_of(0x1ffffff0), EGL_NO_IMAGE_KHR, EGL_BAD_PARAMETER);
  const Pixmap bitmap = XCreatePixmap(x_, DefaultRootWindow(x_), 4, 4, 1);
  EXPECT_EGL_FAIL(image_of(bitmap), EGL_NO_IMAGE_KHR, EGL_BAD_PARAMETER);
  EXPECT_EGL_FAIL(image_of(pixmap_, nullptr, eglGetCurrentContext()), EGL_NO_IMAGE_KHR,
                  EGL_BAD_PARAMETER);
  const EGLint bad[] = {EGL_IMAGE_PRESERVED, 2, EGL_NONE};
  EXPECT_EGL_FAIL(image_of(pixmap_, bad), EGL_NO_IMAGE_KHR, EGL_BAD_PARAMETER);
}

// The pixmap goes, or the display: what textures hold stays, and nobody is troubled.
TEST_F(X11ImageTest, WithoutThePixmap) {
  fill(red(), 0, 0, 20, 12);
  const EGLImageKHR image = image_of(pixmap_);
  texture_(GL_TEXTURE_2D, image);
  EXPECT_EQ(drawn(0, 0), kRed);
  XFreePixmap(x_, pixmap_);
  XSync(x_, False);
  EXPECT_EGL_OK(eglWaitNative(EGL_CORE_NATIVE_ENGINE));
  EXPECT_EQ(drawn(0, 0), kRed);
  bind_framebuffer_(GL_FRAMEBUFFER_OES, 1);
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  texture_(GL_TEXTURE_2D, image);
  attach_texture_(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, name, 0);
  clear(kBlue);
  glFlush();
  EXPECT_EQ(pixel(), kBlue);
  EXPECT_EGL_OK(eglTerminate(display));
  clear(kGreen);
  glFlush();
  EXPECT_EGL_OK(eglMakeCurrent(display, nullptr, nullptr, nullptr));
  ASSERT_TRUE(eglInitialize(display, nullptr, nullptr));
}

}  // namespace
}  // namespace clearpipe::icd
