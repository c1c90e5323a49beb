// Pixmaps of X11: drawn to (3.5.4), copied to (3.10.2), and as textures
// (EGL_NOK_texture_from_pixmap). SPDX-License-Identifier: MIT
#include "icd/x11_test.h"

namespace clearpipe::icd {
namespace {

class X11PixmapTest : public X11Test {
 protected:
  void SetUp() override {
    X11Test::SetUp();
    config = choose_window({}, EGL_PIXMAP_BIT);
    depth_ = static_cast<unsigned>(DefaultDepth(x_, DefaultScreen(x_)));
  }
  Pixmap pixmap(unsigned width = 16, unsigned height = 16) {
    const Pixmap made = XCreatePixmap(x_, DefaultRootWindow(x_), width, height, depth_);
    fill(made, 0, width, height);
    return made;
  }
  // With a pixel value of the server's.
  void fill(Pixmap pixmap, unsigned long value, unsigned width = 16, unsigned height = 16) {
    const GC gc = XCreateGC(x_, pixmap, 0, nullptr);
    XSetForeground(x_, gc, value);
    XFillRectangle(x_, pixmap, gc, 0, 0, width, height);
    XFreeGC(x_, gc);
    XSync(x_, False);
  }
  unsigned long red_value() { return DefaultVisual(x_, DefaultScreen(x_))->red_mask; }
  EGLSurface pixmap_surface(Pixmap of, std::vector<EGLint> list = {}) {
    list.push_back(EGL_NONE);
    return eglCreatePixmapSurface(display, config, of, list.data());
  }

  unsigned depth_ = 24;
};

TEST_F(X11PixmapTest, DrawnTo) {
  const Pixmap on = pixmap(20, 12);
  fill(on, red_value(), 20, 12);
  const EGLSurface surface = pixmap_surface(on);
  ASSERT_NE(surface, EGL_NO_SURFACE);
  EXPECT_EQ(query(surface, EGL_WIDTH), 20);
  EXPECT_EQ(query(surface, EGL_HEIGHT), 12);
  EXPECT_EQ(query(surface, EGL_RENDER_BUFFER), EGL_SINGLE_BUFFER);
  const EGLContext ctx = context();
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, ctx));
  EGLint buffer = 0;
  EXPECT_EGL_OK(eglQueryContext(display, ctx, EGL_RENDER_BUFFER, &buffer));
  EXPECT_EQ(buffer, EGL_SINGLE_BUFFER);
  EXPECT_EQ(pixel(), kRed);  // what it held is what the surface holds
  clear_part(kGreen, 0, 0, 5, 5);
  glFinish();
  EXPECT_EQ(shown(on, 0, 11), kGreen);
  EXPECT_EQ(shown(on, 4, 7), kGreen);
  EXPECT_EQ(shown(on, 5, 11), kRed);
  EXPECT_EQ(shown(on, 0, 6), kRed);
  clear(kBlue);
  EXPECT_EGL_OK(eglWaitClient());
  EXPECT_EQ(shown(on, 0, 0), kBlue);
  clear(kWhite);
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));  // a flush, no more
  EXPECT_EQ(shown(on, 0, 0), kWhite);
  // What the window system draws comes with eglWaitNative, and is not drawn over.
  EXPECT_EQ(pixel(), kWhite);
  fill(on, red_value(), 20, 12);
  EXPECT_EGL_OK(eglWaitNative(EGL_CORE_NATIVE_ENGINE));
  EXPECT_EQ(pixel(3, 3), kRed);
  // Released, it has all that was drawn.
  clear(kGreen);
  ASSERT_TRUE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
  EXPECT_EQ(shown(on, 9, 9), kGreen);
}

TEST_F(X11PixmapTest, Refused) {
  EXPECT_EGL_FAIL(pixmap_surface(0), EGL_NO_SURFACE, EGL_BAD_NATIVE_PIXMAP);
  EXPECT_EGL_FAIL(pixmap_surface(0x1ffffff0), EGL_NO_SURFACE, EGL_BAD_NATIVE_PIXMAP);
  EXPECT_EGL_FAIL(eglCreatePlatformPixmapSurface(display, config, nullptr, nullptr), EGL_NO_SURFACE,
                  EGL_BAD_NATIVE_PIXMAP);
  const Pixmap bitmap = XCreatePixmap(x_, DefaultRootWindow(x_), 4, 4, 1);
  EXPECT_EGL_FAIL(pixmap_surface(bitmap), EGL_NO_SURFACE, EGL_BAD_MATCH);
  EXPECT_EGL_FAIL(pixmap_surface(pixmap(), {EGL_WIDTH, 4}), EGL_NO_SURFACE, EGL_BAD_ATTRIBUTE);
  const Pixmap on = pixmap();
  EXPECT_NE(pixmap_surface(on), EGL_NO_SURFACE);
  EXPECT_EGL_FAIL(pixmap_surface(on), EGL_NO_SURFACE, EGL_BAD_ALLOC);
  Pixmap by_pointer = pixmap();
  EXPECT_NE(eglCreatePlatformPixmapSurface(display, config, &by_pointer, nullptr), EGL_NO_SURFACE);
  config = choose_window({EGL_SAMPLES, 4});
  EXPECT_EGL_FAIL(pixmap_surface(pixmap()), EGL_NO_SURFACE, EGL_BAD_MATCH);
}

// Freed under the surface: drawing goes on, and nobody is killed.
TEST_F(X11PixmapTest, FreedPixmap) {
  const Pixmap on = pixmap();
  const EGLSurface surface = pixmap_surface(on);
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, context()));
  XFreePixmap(x_, on);
  XSync(x_, False);
  clear(kRed);
  glFinish();
  EXPECT_EQ(pixel(), kRed);
  EXPECT_EGL_OK(eglWaitNative(EGL_CORE_NATIVE_ENGINE));
  EXPECT_EGL_OK(eglDestroySurface(display, surface));
}

TEST_F(X11PixmapTest, CopiedTo) {
  const EGLSurface surface = pbuffer(16, 16), other = pbuffer(choose({EGL_SAMPLES, 4}), 16, 16);
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, context()));
  clear(kRed);
  clear_part(kGreen, 0, 0, 4, 4);
  const Pixmap target = pixmap();
  EXPECT_EGL_OK(eglCopyBuffers(display, surface, target));
  EXPECT_EQ(shown(target, 0, 15), kGreen);
  EXPECT_EQ(shown(target, 15, 0), kRed);
  EXPECT_EQ(pixel(), kGreen);  // the buffer is as it was
  EXPECT_EGL_FAIL(eglCopyBuffers(display, surface, pixmap(17, 16)), EGL_FALSE, EGL_BAD_MATCH);
  EXPECT_EGL_FAIL(eglCopyBuffers(display, surface, 0x1ffffff0), EGL_FALSE, EGL_BAD_NATIVE_PIXMAP);
  EXPECT_EGL_FAIL(eglCopyBuffers(display, surface, 0), EGL_FALSE, EGL_BAD_NATIVE_PIXMAP);
  EXPECT_EGL_FAIL(eglCopyBuffers(display, other, target), EGL_FALSE, EGL_BAD_SURFACE);
  const Window on = window();
  const EGLSurface of_window = current_surface(on);
  clear(kBlue);
  EXPECT_EGL_OK(eglCopyBuffers(display, of_window, target));
  EXPECT_EQ(shown(target, 8, 8), kBlue);
}

// eglChooseConfig can be told a pixmap that the config must fit (3.4.1.1).
TEST_F(X11PixmapTest, ConfigsThatMatch) {
  const auto matching = [&](EGLint pixmap) {
    const EGLint list[] = {EGL_MATCH_NATIVE_PIXMAP, pixmap, EGL_SURFACE_TYPE, EGL_PIXMAP_BIT,
                           EGL_NONE};
    EGLint count = -1;
    EXPECT_TRUE(eglChooseConfig(display, list, nullptr, 0, &count));
    return count;
  };
  EXPECT_GT(matching(static_cast<EGLint>(pixmap())), 0);
  const EGLint list[] = {EGL_MATCH_NATIVE_PIXMAP, 0x1ffffff0, EGL_NONE};
  EGLint count = 0;
  EXPECT_EGL_FAIL(eglChooseConfig(display, list, nullptr, 0, &count), EGL_FALSE, EGL_BAD_ATTRIBUTE);
}

TEST_F(X11PixmapTest, AsTexture) {
  EXPECT_TRUE(words(eglQueryString(display, EGL_EXTENSIONS)).count("EGL_NOK_texture_from_pixmap"));
  config = choose_window({EGL_ALPHA_SIZE, 0}, EGL_PIXMAP_BIT);
  const Pixmap of = pixmap();
  fill(of, red_value());
  const EGLSurface surface =
      pixmap_surface(of, {EGL_TEXTURE_FORMAT, EGL_TEXTURE_RGB, EGL_TEXTURE_TARGET, EGL_TEXTURE_2D});
  ASSERT_NE(surface, EGL_NO_SURFACE);
  EXPECT_EQ(query(surface, EGL_TEXTURE_FORMAT), EGL_TEXTURE_RGB);
  const EGLSurface screen = pbuffer(8, 8);
  ASSERT_TRUE(eglMakeCurrent(display, screen, screen, context()));
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  const auto look = [&] {
    static const float kQuad[] = {-1, -1, 1, -1, -1, 1, 1, 1};
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, kQuad);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    return pixel();
  };
  EXPECT_EGL_OK(eglBindTexImage(display, surface, EGL_BACK_BUFFER));
  EXPECT_EQ(look(), kRed);
  EXPECT_EGL_FAIL(eglBindTexImage(display, surface, EGL_BACK_BUFFER), EGL_FALSE, EGL_BAD_ACCESS);
  EXPECT_EGL_OK(eglReleaseTexImage(display, surface, EGL_BACK_BUFFER));
  fill(of, 0);
  EXPECT_EGL_OK(eglBindTexImage(display, surface, EGL_BACK_BUFFER));
  EXPECT_EQ(look(), kBlack);
  // A window is none of the surfaces that can be textures.
  const EGLSurface of_window = window_surface(window());
  EXPECT_EGL_FAIL(eglBindTexImage(display, of_window, EGL_BACK_BUFFER), EGL_FALSE, EGL_BAD_SURFACE);
}

}  // namespace
}  // namespace clearpipe::icd
