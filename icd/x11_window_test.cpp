// Windows of X11: what they show, that they are followed when they are resized, and what happens
// when they are gone.
// SPDX-License-Identifier: MIT
#include <sys/socket.h>

#include <bit>
#include <chrono>
#include <thread>

#include "icd/x11_test.h"

namespace clearpipe::icd {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

TEST_F(X11Test, Displays) {
  for (const char* name :
       {"EGL_EXT_platform_x11", "EGL_KHR_platform_x11", "EGL_EXT_platform_xcb"}) {
    EXPECT_TRUE(words(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS)).count(name)) << name;
  }
  EXPECT_EQ(eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, x_, nullptr), display);
  EXPECT_EQ(eglGetDisplay(reinterpret_cast<EGLNativeDisplayType>(x_)), display);
  const auto extensions = words(eglQueryString(display, EGL_EXTENSIONS));
  for (const char* name : {"EGL_EXT_buffer_age", "EGL_KHR_swap_buffers_with_damage",
                           "EGL_EXT_swap_buffers_with_damage", "EGL_KHR_partial_update"}) {
    EXPECT_TRUE(extensions.count(name)) << name;
  }
  // Without a native display, a connection of our own; a screen may be named.
  const EGLAttrib screen[] = {EGL_PLATFORM_X11_SCREEN_KHR, 0, EGL_NONE};
  const EGLAttrib no_screen[] = {EGL_PLATFORM_X11_SCREEN_KHR, 7, EGL_NONE};
  const EGLAttrib wrong[] = {EGL_WIDTH, 7, EGL_NONE};
  const EGLDisplay own = eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, nullptr, nullptr);
  EXPECT_NE(own, display);
  EXPECT_EGL_OK(eglInitialize(own, nullptr, nullptr));
  EXPECT_EGL_OK(eglTerminate(own));
  const EGLDisplay named = eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, x_, screen);
  EXPECT_EGL_OK(eglInitialize(named, nullptr, nullptr));
  EXPECT_EGL_OK(eglTerminate(named));
  const EGLDisplay absent = eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, x_, no_screen);
  EXPECT_EGL_FAIL(eglInitialize(absent, nullptr, nullptr), EGL_FALSE, EGL_NOT_INITIALIZED);
  EXPECT_EGL_FAIL(eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, x_, wrong), EGL_NO_DISPLAY,
                  EGL_BAD_ATTRIBUTE);
}

// eglGetDisplay without a display goes to the server at $DISPLAY, unless $EGL_PLATFORM says where.
TEST_F(X11Test, DefaultDisplay) {
  EXPECT_EQ(eglGetDisplay(EGL_DEFAULT_DISPLAY),
            eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, nullptr, nullptr));
  setenv("EGL_PLATFORM", "surfaceless", 1);
  EXPECT_EQ(eglGetDisplay(EGL_DEFAULT_DISPLAY), surfaceless_display());
  setenv("EGL_PLATFORM", "xcb", 1);
  EXPECT_EQ(eglGetDisplay(EGL_DEFAULT_DISPLAY),
            eglGetPlatformDisplay(EGL_PLATFORM_XCB_EXT, nullptr, nullptr));
  unsetenv("EGL_PLATFORM");
}

TEST_F(X11Test, NoServer) {
  const std::string there = getenv("DISPLAY");
  setenv("DISPLAY", ":5999", 1);
  const EGLDisplay own = eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, nullptr, nullptr);
  EXPECT_EGL_FAIL(eglInitialize(own, nullptr, nullptr), EGL_FALSE, EGL_NOT_INITIALIZED);
  EXPECT_EQ(eglGetDisplay(EGL_DEFAULT_DISPLAY), surfaceless_display());
  setenv("DISPLAY", there.c_str(), 1);
  EXPECT_EGL_OK(eglInitialize(own, nullptr, nullptr));
  EXPECT_EGL_OK(eglTerminate(own));
}

// Every config for windows has a visual of the screen that fits; the first ones are opaque.
TEST_F(X11Test, Configs) {
  EGLint count = 0;
  ASSERT_TRUE(eglGetConfigs(display, nullptr, 0, &count));
  std::vector<EGLConfig> list(static_cast<size_t>(count));
  ASSERT_TRUE(eglGetConfigs(display, list.data(), count, &count));
  bool alpha_visual = false;
  // Colours of other sizes than the visual's are for pbuffers.
  const auto bits = [](unsigned long mask) { return std::popcount(mask); };
  const Visual* root = DefaultVisual(x_, DefaultScreen(x_));
  bool pbuffer_only = false;
  for (const EGLConfig c : list) {
    if (attrib(c, EGL_NATIVE_RENDERABLE) == EGL_FALSE) {
      pbuffer_only = true;
      EXPECT_NE(attrib(c, EGL_GREEN_SIZE), bits(root->green_mask));
      EXPECT_EQ(attrib(c, EGL_SURFACE_TYPE) & (EGL_WINDOW_BIT | EGL_PIXMAP_BIT), 0);
      EXPECT_EQ(attrib(c, EGL_NATIVE_VISUAL_TYPE), EGL_NONE);
      continue;
    }
    XVisualInfo wanted{};
    wanted.visualid = static_cast<VisualID>(attrib(c, EGL_NATIVE_VISUAL_ID));
    int found = 0;
    XVisualInfo* info = XGetVisualInfo(x_, VisualIDMask, &wanted, &found);
    ASSERT_EQ(found, 1);
    EXPECT_EQ(attrib(c, EGL_NATIVE_VISUAL_TYPE), TrueColor);
    EXPECT_EQ(attrib(c, EGL_RED_SIZE), bits(info->red_mask));
    EXPECT_EQ(attrib(c, EGL_GREEN_SIZE), bits(info->green_mask));
    EXPECT_EQ(attrib(c, EGL_BLUE_SIZE), bits(info->blue_mask));
    EXPECT_EQ(attrib(c, EGL_NATIVE_RENDERABLE), EGL_TRUE);
    EXPECT_TRUE(attrib(c, EGL_SURFACE_TYPE) & EGL_WINDOW_BIT);
    EXPECT_EQ(attrib(c, EGL_MIN_SWAP_INTERVAL), 0);
    EXPECT_GE(attrib(c, EGL_MAX_SWAP_INTERVAL), 1);
    if (info->depth == 32) {
      alpha_visual = true;
      EXPECT_EQ(attrib(c, EGL_ALPHA_SIZE), 8);
    }
    XFree(info);
  }
  EXPECT_TRUE(alpha_visual);
  EXPECT_TRUE(pbuffer_only);
  // On a screen of 16 bits, alpha is only in windows that have a depth of their own.
  EXPECT_EQ(attrib(choose_window({EGL_ALPHA_SIZE, 8}), EGL_NATIVE_VISUAL_ID) ==
                attrib(choose_window({}), EGL_NATIVE_VISUAL_ID),
            bits(root->green_mask) == 8);
}

TEST_F(X11Test, ShowsWhatIsDrawn) {
  const Window on = window(40, 24);
  const EGLSurface surface = current_surface(on);
  EXPECT_EQ(query(surface, EGL_WIDTH), 40);
  EXPECT_EQ(query(surface, EGL_HEIGHT), 24);
  EXPECT_EQ(query(surface, EGL_RENDER_BUFFER), EGL_BACK_BUFFER);
  GLint box[4];
  glGetIntegerv(GL_VIEWPORT, box);
  EXPECT_EQ(box[2], 40);
  EXPECT_EQ(box[3], 24);
  clear(kBlack);
  clear_part(kRed, 0, 0, 10, 8);     // lower left
  clear_part(kGreen, 30, 0, 10, 8);  // lower right
  clear_part(kBlue, 0, 16, 10, 8);   // upper left
  clear_part(0xff336699u, 30, 16, 10, 8);
  EXPECT_EQ(shown(on, 5, 20), kBlack);  // nothing comes before it is posted
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  EXPECT_EQ(shown(on, 0, 23), kRed);
  EXPECT_EQ(shown(on, 9, 16), kRed);
  EXPECT_EQ(shown(on, 10, 16), kBlack);
  EXPECT_EQ(shown(on, 9, 15), kBlack);
  EXPECT_EQ(shown(on, 39, 23), kGreen);
  EXPECT_EQ(shown(on, 0, 0), kBlue);
  if (DefaultDepth(x_, DefaultScreen(x_)) >= 24) {
    EXPECT_EQ(shown(on, 39, 0), 0xff336699u);
  }
}

// A window of a visual with alpha takes the surface's alpha along.
TEST_F(X11Test, WindowWithAlpha) {
  std::array<EGLConfig, 128> list;
  EGLint count = 0;
  ASSERT_TRUE(eglGetConfigs(display, list.data(), 128, &count));
  XVisualInfo deep{};
  ASSERT_TRUE(XMatchVisualInfo(x_, DefaultScreen(x_), 32, TrueColor, &deep));
  for (EGLint i = 0; i < count; ++i) {
    if (attrib(list[static_cast<size_t>(i)], EGL_NATIVE_VISUAL_ID) ==
        static_cast<EGLint>(deep.visualid)) {
      config = list[static_cast<size_t>(i)];
      break;
    }
  }
  const Window on = window();
  const EGLSurface surface = current_surface(on);
  clear(0x40112233u);
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  XImage* image = XGetImage(x_, on, 3, 3, 1, 1, AllPlanes, ZPixmap);
  ASSERT_NE(image, nullptr);
  EXPECT_EQ(XGetPixel(image, 0, 0), 0x40332211u);
  XDestroyImage(image);
}

// A large window, of which some rows and columns are no whole tiles, pixel by pixel.
TEST_F(X11Test, EveryPixel) {
  constexpr int kWidth = 333, kHeight = 217;
  const Window on = window(kWidth, kHeight);
  const EGLSurface surface = current_surface(on);
  clear(kBlack);
  for (int y = 0; y < kHeight; y += 31) {
    for (int x = 0; x < kWidth; x += 29) {
      clear_part((x / 29 + y / 31) % 2 == 0 ? kRed : kBlue, x, y, 29, 31);
    }
  }
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  XImage* image = XGetImage(x_, on, 0, 0, kWidth, kHeight, AllPlanes, ZPixmap);
  ASSERT_NE(image, nullptr);
  const unsigned long red = image->red_mask, blue = image->blue_mask;
  int wrong = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool even = (x / 29 + (kHeight - 1 - y) / 31) % 2 == 0;
      const unsigned long colours = image->red_mask | image->green_mask | image->blue_mask;
      wrong += (XGetPixel(image, x, y) & colours) != (even ? red : blue);
    }
  }
  XDestroyImage(image);
  EXPECT_EQ(wrong, 0);
}

// The surface has the size of the window in the first frame that is drawn after a change.
TEST_F(X11Test, FollowsTheWindow) {
  const Window on = window(16, 16);
  const EGLSurface surface = current_surface(on);
  clear(kRed);
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  for (const auto& [width, height] : {std::pair<int, int>{100, 60}, {7, 5}, {64, 200}}) {
    XResizeWindow(x_, on, static_cast<unsigned>(width), static_cast<unsigned>(height));
    XSync(x_, False);
    glViewport(0, 0, width, height);
    clear(kGreen);
    EXPECT_EQ(query(surface, EGL_WIDTH), width);
    EXPECT_EQ(query(surface, EGL_HEIGHT), height);
    EXPECT_EQ(pixel(width - 1, height - 1), kGreen);
    clear_part(kBlue, 0, 0, 1, 1);
    EXPECT_EGL_OK(eglSwapBuffers(display, surface));
    EXPECT_EQ(shown(on, 0, height - 1), kBlue);
    EXPECT_EQ(shown(on, width - 1, 0), kGreen);
    EXPECT_EQ(shown(on, width - 1, height - 1), kGreen);
  }
  // Resized between drawing and posting: what was drawn is shown, and the next frame fits.
  clear(kWhite);
  XResizeWindow(x_, on, 30, 30);
  XSync(x_, False);
  EXPECT_EQ(pixel(63, 199), kWhite);
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  clear(kRed);
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  EXPECT_EQ(shown(on, 29, 29), kRed);
  EXPECT_EQ(query(surface, EGL_WIDTH), 30);
}

TEST_F(X11Test, CreatedThroughThePlatform) {
  Window on = window();
  const EGLAttrib list[] = {EGL_RENDER_BUFFER, EGL_SINGLE_BUFFER, EGL_NONE};
  const EGLSurface surface = eglCreatePlatformWindowSurface(display, config, &on, list);
  ASSERT_NE(surface, EGL_NO_SURFACE);
  EXPECT_EQ(query(surface, EGL_RENDER_BUFFER), EGL_SINGLE_BUFFER);
  const EGLContext ctx = context();
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, ctx));
  EGLint buffer = 0;
  EXPECT_EGL_OK(eglQueryContext(display, ctx, EGL_RENDER_BUFFER, &buffer));
  EXPECT_EQ(buffer, EGL_BACK_BUFFER);  // what is really drawn to
  clear(kGreen);
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  EXPECT_EQ(shown(on, 3, 3), kGreen);
  // Asked for what only pbuffers have, it says nothing.
  for (const EGLint attribute : {EGL_LARGEST_PBUFFER, EGL_TEXTURE_FORMAT, EGL_MIPMAP_LEVEL}) {
    EGLint untouched = 4711;
    EXPECT_EGL_OK(eglQuerySurface(display, surface, attribute, &untouched));
    EXPECT_EQ(untouched, 4711);
  }
  Window second = window();
  EXPECT_NE(proc<PFNEGLCREATEPLATFORMWINDOWSURFACEEXTPROC>("eglCreatePlatformWindowSurfaceEXT")(
                display, config, &second, nullptr),
            EGL_NO_SURFACE);
}

TEST_F(X11Test, XcbConnections) {
  int screen = 0;
  xcb_connection_t* connection = xcb_connect(nullptr, &screen);
  const EGLDisplay xcb = eglGetPlatformDisplay(EGL_PLATFORM_XCB_EXT, connection, nullptr);
  ASSERT_TRUE(eglInitialize(xcb, nullptr, nullptr));
  xcb_window_t on = static_cast<xcb_window_t>(window());
  const EGLDisplay x11 = display;
  display = xcb;
  config = choose_window({});
  const EGLSurface surface = eglCreatePlatformWindowSurface(xcb, config, &on, nullptr);
  ASSERT_TRUE(eglMakeCurrent(xcb, surface, surface, context()));
  clear(kBlue);
  EXPECT_EGL_OK(eglSwapBuffers(xcb, surface));
  std::free(xcb_get_input_focus_reply(connection, xcb_get_input_focus(connection), nullptr));
  EXPECT_EQ(shown(on, 3, 3), kBlue);
  // The connection that is not ours dies: the error, and no crash.
  shutdown(xcb_get_file_descriptor(connection), SHUT_RDWR);
  EXPECT_EGL_FAIL(eglSwapBuffers(xcb, surface), EGL_FALSE, EGL_BAD_NATIVE_WINDOW);
  clear(kRed);
  EXPECT_EQ(pixel(), kRed);
  EXPECT_EGL_FAIL(eglCreatePlatformWindowSurface(xcb, config, &on, nullptr), EGL_NO_SURFACE,
                  EGL_BAD_NATIVE_WINDOW);
  eglReleaseThread();
  EXPECT_EGL_OK(eglTerminate(xcb));
  EXPECT_EGL_FAIL(eglInitialize(xcb, nullptr, nullptr), EGL_FALSE, EGL_NOT_INITIALIZED);
  xcb_disconnect(connection);
  display = x11;
}

TEST_F(X11Test, RefusedWindows) {
  EXPECT_EGL_FAIL(window_surface(0), EGL_NO_SURFACE, EGL_BAD_NATIVE_WINDOW);
  EXPECT_EGL_FAIL(window_surface(0x1ffffff0), EGL_NO_SURFACE, EGL_BAD_NATIVE_WINDOW);
  EXPECT_EGL_FAIL(eglCreatePlatformWindowSurface(display, config, nullptr, nullptr), EGL_NO_SURFACE,
                  EGL_BAD_NATIVE_WINDOW);
  const Window gone = window();
  XDestroyWindow(x_, gone);
  EXPECT_EGL_FAIL(window_surface(gone), EGL_NO_SURFACE, EGL_BAD_NATIVE_WINDOW);
  const Window input =
      XCreateWindow(x_, DefaultRootWindow(x_), 0, 0, 4, 4, 0, 0, InputOnly, nullptr, 0, nullptr);
  EXPECT_EGL_FAIL(window_surface(input), EGL_NO_SURFACE, EGL_BAD_NATIVE_WINDOW);
  const Pixmap pixmap = XCreatePixmap(x_, DefaultRootWindow(x_), 4, 4, 24);
  EXPECT_EGL_FAIL(window_surface(pixmap), EGL_NO_SURFACE, EGL_BAD_NATIVE_WINDOW);
  const Window on = window();
  for (const std::vector<EGLint>& list :
       {std::vector<EGLint>{EGL_WIDTH, 4}, {EGL_RENDER_BUFFER, EGL_TRUE}, {EGL_GL_COLORSPACE, 1}}) {
    EXPECT_EGL_FAIL(window_surface(on, list), EGL_NO_SURFACE, EGL_BAD_ATTRIBUTE);
  }
  EXPECT_EGL_FAIL(eglCreateWindowSurface(display, random_handle(), on, nullptr), EGL_NO_SURFACE,
                  EGL_BAD_CONFIG);
  // One surface at a time.
  const EGLSurface surface = window_surface(on);
  EXPECT_EGL_FAIL(window_surface(on), EGL_NO_SURFACE, EGL_BAD_ALLOC);
  EXPECT_EGL_OK(eglDestroySurface(display, surface));
  EXPECT_NE(window_surface(on), EGL_NO_SURFACE);
}

TEST_F(X11Test, DestroyedWindow) {
  const Window on = window();
  const EGLSurface surface = current_surface(on);
  clear(kRed);
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  XDestroyWindow(x_, on);
  XSync(x_, False);
  for (int i = 0; i < 3; ++i) {
    clear(kGreen);
    EXPECT_EQ(pixel(), kGreen);  // drawing goes on
    EXPECT_EGL_FAIL(eglSwapBuffers(display, surface), EGL_FALSE, EGL_BAD_NATIVE_WINDOW);
  }
  EXPECT_TRUE(eglSwapInterval(display, 1));
  EXPECT_EGL_FAIL(eglSwapBuffers(display, surface), EGL_FALSE, EGL_BAD_NATIVE_WINDOW);
  EXPECT_EQ(query(surface, EGL_WIDTH), 16);
  ASSERT_TRUE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
  EXPECT_EGL_FAIL(eglMakeCurrent(display, surface, surface, context()), EGL_FALSE,
                  EGL_BAD_NATIVE_WINDOW);
  EXPECT_EGL_OK(eglDestroySurface(display, surface));
}

// The window is destroyed by another client while frames are shown, at any moment.
TEST_F(X11Test, DestroyedWhileDrawing) {
  for (const EGLint interval : {0, 1}) {
    const Window on = window(200, 200);
    const EGLSurface surface = current_surface(on);
    EXPECT_TRUE(eglSwapInterval(display, interval));
    std::thread destroyer([on] {
      std::this_thread::sleep_for(milliseconds(60));
      xcb_connection_t* other = xcb_connect(nullptr, nullptr);
      xcb_destroy_window(other, static_cast<xcb_window_t>(on));
      std::free(xcb_get_input_focus_reply(other, xcb_get_input_focus(other), nullptr));
      xcb_disconnect(other);
    });
    const auto begin = Clock::now();
    while (eglSwapBuffers(display, surface)) {
      clear(kRed);
      ASSERT_LT(Clock::now() - begin, std::chrono::seconds(20));
    }
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
    destroyer.join();
    eglDestroySurface(display, surface);
  }
}

// Objects destroyed in an order that programs like: the window system goes first.
TEST_F(X11Test, WindowSystemGoesFirst) {
  Display* own = XOpenDisplay(nullptr);
  const EGLDisplay other = eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, own, nullptr);
  ASSERT_TRUE(eglInitialize(other, nullptr, nullptr));
  const Window on = XCreateSimpleWindow(own, DefaultRootWindow(own), 0, 0, 9, 9, 0, 0, 0);
  const EGLDisplay first = display;
  display = other;
  config = choose_window({});
  const EGLSurface surface = current_surface(on);
  clear(kRed);
  EXPECT_EGL_OK(eglSwapBuffers(other, surface));
  EXPECT_EGL_OK(eglTerminate(other));  // while it is current
  XDestroyWindow(own, on);
  XCloseDisplay(own);
  clear(kGreen);
  EXPECT_EQ(pixel(), kGreen);
  EXPECT_FALSE(eglSwapBuffers(other, surface));
  EXPECT_EGL_OK(eglReleaseThread());
  display = first;
}

TEST_F(X11Test, SurfaceDestroyedWhileCurrent) {
  const Window on = window();
  const EGLSurface surface = current_surface(on);
  EXPECT_EGL_OK(eglDestroySurface(display, surface));
  XDestroyWindow(x_, on);
  clear(kRed);
  EXPECT_EQ(pixel(), kRed);
  EXPECT_EGL_FAIL(eglSwapBuffers(display, surface), EGL_FALSE, EGL_BAD_SURFACE);
}

// Windows of several threads at once, on one connection.
TEST_F(X11Test, ManyThreads) {
  std::vector<std::thread> threads;
  std::array<Window, 3> windows;
  for (size_t i = 0; i < windows.size(); ++i) windows[i] = window(64, 64, static_cast<int>(i) * 70);
  for (size_t i = 0; i < windows.size(); ++i) {
    threads.emplace_back([&, i] {
      const EGLSurface surface = window_surface(windows[i]);
      ASSERT_TRUE(eglMakeCurrent(display, surface, surface, context()));
      EXPECT_TRUE(eglSwapInterval(display, 0));
      for (uint32_t frame = 0; frame < 30; ++frame) {
        clear(kBlack | static_cast<uint32_t>(i + 1) << 5);
        EXPECT_TRUE(eglSwapBuffers(display, surface));
      }
      eglReleaseThread();
    });
  }
  for (std::thread& thread : threads) thread.join();
  if (DefaultDepth(x_, DefaultScreen(x_)) >= 24) {
    for (size_t i = 0; i < windows.size(); ++i) {
      EXPECT_EQ(shown(windows[i], 5, 5), kBlack | static_cast<uint32_t>(i + 1) << 5);
    }
  }
}

// Four samples a pixel are resolved before they are shown.
TEST_F(X11Test, Multisampled) {
  config = choose_window({EGL_SAMPLES, 4});
  ASSERT_NE(config, nullptr);
  const Window on = window();
  const EGLSurface surface = current_surface(on);
  clear(kRed);
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  EXPECT_EQ(shown(on, 4, 4), kRed);
}

TEST_F(X11Test, OffscreenToo) {
  config = choose({EGL_ALPHA_SIZE, 8});
  const EGLSurface surface = pbuffer(4, 4);
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, context()));
  EXPECT_EQ(clear_and_read(1, 0, 0, 1), kRed);
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
}

}  // namespace
}  // namespace clearpipe::icd
