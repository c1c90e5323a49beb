// What the tests of X11 share: a connection as Xlib programs have it, windows, and what they show.
// The tests draw to the server that scripts/with_xvfb starts for them.
// SPDX-License-Identifier: MIT
#pragma once

#include "icd/egl_test.h"

// After GoogleTest, whose names are macros of Xlib.
#include <X11/Xlib-xcb.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <xcb/xcb.h>

namespace clearpipe::icd {

inline constexpr uint32_t kRed = 0xff0000ffu, kGreen = 0xff00ff00u, kBlue = 0xffff0000u,
                          kWhite = 0xffffffffu, kBlack = 0xff000000u;

class X11Test : public EglTest {
 protected:
  void SetUp() override {
    x_errors() = 0;
    XSetErrorHandler(count_error);
    x_ = XOpenDisplay(nullptr);
    ASSERT_NE(x_, nullptr) << "run with scripts/with_xvfb";
    display = eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, x_, nullptr);
    ASSERT_NE(display, EGL_NO_DISPLAY);
    ASSERT_TRUE(eglInitialize(display, nullptr, nullptr));
    config = choose_window({EGL_DEPTH_SIZE, 24});
    ASSERT_NE(config, nullptr);
  }
  void TearDown() override {
    EglTest::TearDown();
    if (x_ != nullptr) {
      XSync(x_, False);
      XCloseDisplay(x_);
    }
    // Whatever became of windows, no error of ours came to the application.
    EXPECT_EQ(x_errors(), 0);
  }
  static int& x_errors() {
    static int errors = 0;
    return errors;
  }
  static int count_error(Display*, XErrorEvent* event) {
    ADD_FAILURE() << "X error " << int{event->error_code} << " of request "
                  << int{event->request_code} << "." << int{event->minor_code};
    return ++x_errors();
  }

  EGLConfig choose_window(std::vector<EGLint> attributes, EGLint type = EGL_WINDOW_BIT) {
    attributes.insert(attributes.end(), {EGL_SURFACE_TYPE, type, EGL_NONE});
    EGLConfig found = nullptr;
    EGLint count = 0;
    eglChooseConfig(display, attributes.data(), &found, 1, &count);
    return count == 1 ? found : nullptr;
  }
  EGLint attrib(EGLConfig of, EGLint attribute) {
    EGLint value = -1;
    EXPECT_TRUE(eglGetConfigAttrib(display, of, attribute, &value));
    return value;
  }
  // A window of the config's visual that no window manager moves, mapped.
  Window window(int width = 16, int height = 16, int x = 0) {
    XVisualInfo wanted{};
    wanted.visualid = static_cast<VisualID>(attrib(config, EGL_NATIVE_VISUAL_ID));
    int count = 0;
    XVisualInfo* info = XGetVisualInfo(x_, VisualIDMask, &wanted, &count);
    EXPECT_EQ(count, 1);
    const Window root = DefaultRootWindow(x_);
    XSetWindowAttributes attributes{};
    attributes.override_redirect = True;
    attributes.colormap = XCreateColormap(x_, root, info->visual, AllocNone);
    const Window made =
        XCreateWindow(x_, root, x, 0, static_cast<unsigned>(width), static_cast<unsigned>(height),
                      0, info->depth, InputOutput, info->visual,
                      CWOverrideRedirect | CWColormap | CWBorderPixel | CWBackPixel, &attributes);
    XFree(info);
    XMapWindow(x_, made);
    XSync(x_, False);
    return made;
  }
  EGLSurface window_surface(Window of, std::vector<EGLint> attributes = {}) {
    attributes.push_back(EGL_NONE);
    return eglCreateWindowSurface(display, config, of, attributes.data());
  }
  // A window's surface, current.
  EGLSurface current_surface(Window of) {
    const EGLSurface surface = window_surface(of);
    EXPECT_NE(surface, EGL_NO_SURFACE);
    EXPECT_TRUE(eglMakeCurrent(display, surface, surface, context()));
    EXPECT_TRUE(eglSwapInterval(display, 0));
    return surface;
  }
  // What a drawable holds at a place counted from the upper left, 0xffBBGGRR.
  uint32_t shown(Drawable drawable, int x, int y) {
    XImage* image = XGetImage(x_, drawable, x, y, 1, 1, AllPlanes, ZPixmap);
    if (image == nullptr) return 0;
    const unsigned long pixel = XGetPixel(image, 0, 0);
    const bool is_565 = image->bits_per_pixel == 16;
    XDestroyImage(image);
    const auto part = [pixel](int shift, unsigned most) {
      return static_cast<uint32_t>((pixel >> shift & most) * 255 / most);
    };
    const uint32_t r = is_565 ? part(11, 31) : part(16, 255);
    const uint32_t g = is_565 ? part(5, 63) : part(8, 255);
    const uint32_t b = is_565 ? part(0, 31) : part(0, 255);
    return kBlack | b << 16 | g << 8 | r;
  }
  static uint32_t pixel(int x = 0, int y = 0) {
    uint32_t value = 0;
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &value);
    return value;
  }

  Display* x_ = nullptr;
};

}  // namespace clearpipe::icd
