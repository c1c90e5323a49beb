// Windows of Wayland, shown to a compositor of the test's own.
// SPDX-License-Identifier: MIT
#include "icd/egl_test.h"

#include <wayland-client.h>
#include <wayland-egl.h>

#include <filesystem>
#include <chrono>
#include <thread>

#include "icd/wayland_compositor.h"

namespace clearpipe::icd {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;
using Frames = TestCompositor::Frames;

constexpr uint32_t kRed = 0xff0000ffu, kGreen = 0xff00ff00u, kBlue = 0xffff0000u;

// The same as the compositor has it.
uint32_t argb(uint32_t colour) {
  return (colour & 0xff00ff00u) | (colour >> 16 & 255) | (colour & 255) << 16;
}

// A window of a client.
struct ClientWindow {
  wl_surface* surface = nullptr;
  wl_egl_window* window = nullptr;
};

class WaylandTest : public EglTest {
 protected:
  void SetUp() override {
    wayland_ = wl_display_connect_to_fd(compositor_.connect());
    ASSERT_NE(wayland_, nullptr);
    wl_registry* registry = wl_display_get_registry(wayland_);
    static const wl_registry_listener kListener = {
        [](void* data, wl_registry* from, uint32_t name, const char* interface, uint32_t version) {
          if (std::string(interface) == "wl_compositor") {
            *static_cast<wl_compositor**>(data) = static_cast<wl_compositor*>(
                wl_registry_bind(from, name, &wl_compositor_interface, std::min(version, 4u)));
          }
        },
        [](void*, wl_registry*, uint32_t) {}};
    wl_registry_add_listener(registry, &kListener, &globals_);
    wl_display_roundtrip(wayland_);
    wl_registry_destroy(registry);
    ASSERT_NE(globals_, nullptr);
    display = eglGetPlatformDisplay(EGL_PLATFORM_WAYLAND_KHR, wayland_, nullptr);
    ASSERT_NE(display, EGL_NO_DISPLAY);
    ASSERT_TRUE(eglInitialize(display, nullptr, nullptr));
    config = choose_window({EGL_ALPHA_SIZE, 8, EGL_DEPTH_SIZE, 24});
    ASSERT_NE(config, nullptr);
  }
  void TearDown() override {
    EglTest::TearDown();
    for (ClientWindow& w : windows_) {
      if (w.window != nullptr) wl_egl_window_destroy(w.window);
      wl_surface_destroy(w.surface);
    }
    if (globals_ != nullptr) wl_compositor_destroy(globals_);
    wl_display_disconnect(wayland_);
  }
  EGLConfig choose_window(std::vector<EGLint> attributes) {
    attributes.insert(attributes.end(), {EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_NONE});
    EGLConfig found = nullptr;
    EGLint count = 0;
    eglChooseConfig(display, attributes.data(), &found, 1, &count);
    return count == 1 ? found : nullptr;
  }
  wl_egl_window* window(int width = 16, int height = 16) {
    ClientWindow made;
    made.surface = wl_compositor_create_surface(globals_);
    made.window = wl_egl_window_create(made.surface, width, height);
    windows_.push_back(made);
    return made.window;
  }
  void destroy_window(wl_egl_window* window) {
    for (ClientWindow& w : windows_) {
      if (w.window == window) w.window = nullptr;
    }
    wl_egl_window_destroy(window);
  }
  EGLSurface window_surface(wl_egl_window* of) {
    return eglCreatePlatformWindowSurface(display, config, of, nullptr);
  }
  EGLSurface current_surface(wl_egl_window* of, EGLint interval = 0) {
    const EGLSurface surface = window_surface(of);
    EXPECT_NE(surface, EGL_NO_SURFACE);
    EXPECT_TRUE(eglMakeCurrent(display, surface, surface, context()));
    EXPECT_TRUE(eglSwapInterval(display, interval));
    return surface;
  }
  // What has been committed, when the compositor has seen all of it.
  Commit committed() {
    wl_display_roundtrip(wayland_);
    return compositor_.last();
  }
  static uint32_t at(const Commit& commit, int x, int y) {
    return commit.shown[static_cast<size_t>(y * commit.width + x)];
  }

  TestCompositor compositor_;
  wl_display* wayland_ = nullptr;
  wl_compositor* globals_ = nullptr;
  std::vector<ClientWindow> windows_;
};

TEST_F(WaylandTest, Displays) {
  for (const char* name : {"EGL_EXT_platform_wayland", "EGL_KHR_platform_wayland"}) {
    EXPECT_TRUE(words(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS)).count(name)) << name;
  }
  EXPECT_EQ(eglGetPlatformDisplay(EGL_PLATFORM_WAYLAND_KHR, wayland_, nullptr), display);
  EXPECT_EQ(eglGetDisplay(reinterpret_cast<EGLNativeDisplayType>(wayland_)), display);
  const auto extensions = words(eglQueryString(display, EGL_EXTENSIONS));
  EXPECT_TRUE(extensions.count("EGL_EXT_buffer_age"));
  EXPECT_TRUE(extensions.count("EGL_KHR_image"));
  EXPECT_FALSE(extensions.count("EGL_NOK_texture_from_pixmap"));
  EGLint value = 0;
  eglGetConfigAttrib(display, config, EGL_SURFACE_TYPE, &value);
  EXPECT_EQ(value & (EGL_WINDOW_BIT | EGL_PIXMAP_BIT), EGL_WINDOW_BIT);
  eglGetConfigAttrib(display, config, EGL_MAX_SWAP_INTERVAL, &value);
  EXPECT_EQ(value, 1);
}

// Without a native display, a connection of its own; eglGetDisplay finds it too.
TEST_F(WaylandTest, DefaultDisplay) {
  std::string folder = std::filesystem::temp_directory_path() / "clearpipe-XXXXXX";
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  setenv("XDG_RUNTIME_DIR", folder.c_str(), 1);
  const EGLDisplay own = eglGetPlatformDisplay(EGL_PLATFORM_WAYLAND_KHR, nullptr, nullptr);
  setenv("WAYLAND_DISPLAY", "absent", 1);
  EXPECT_EGL_FAIL(eglInitialize(own, nullptr, nullptr), EGL_FALSE, EGL_NOT_INITIALIZED);
  EXPECT_EQ(eglGetDisplay(EGL_DEFAULT_DISPLAY), surfaceless_display());
  setenv("WAYLAND_DISPLAY", compositor_.add_socket().c_str(), 1);
  EXPECT_EQ(eglGetDisplay(EGL_DEFAULT_DISPLAY), own);
  EXPECT_EGL_OK(eglInitialize(own, nullptr, nullptr));
  EXPECT_EGL_OK(eglTerminate(own));
  unsetenv("WAYLAND_DISPLAY");
  setenv("EGL_PLATFORM", "wayland", 1);
  EXPECT_EQ(eglGetDisplay(EGL_DEFAULT_DISPLAY), own);
  unsetenv("EGL_PLATFORM");
  std::filesystem::remove_all(folder);
}

TEST_F(WaylandTest, ShowsWhatIsDrawn) {
  const EGLSurface surface = current_surface(window(40, 24));
  EXPECT_EQ(query(surface, EGL_WIDTH), 40);
  EXPECT_EQ(query(surface, EGL_HEIGHT), 24);
  clear(0x80332211u);
  clear_part(kRed, 0, 0, 10, 8);
  clear_part(kGreen, 30, 0, 10, 8);
  clear_part(kBlue, 0, 16, 10, 8);
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  const Commit commit = committed();
  ASSERT_EQ(commit.width, 40);
  ASSERT_EQ(commit.height, 24);
  EXPECT_TRUE(commit.has_alpha);
  EXPECT_EQ(at(commit, 0, 23), argb(kRed));
  EXPECT_EQ(at(commit, 9, 16), argb(kRed));
  EXPECT_EQ(at(commit, 10, 16), 0x80112233u);
  EXPECT_EQ(at(commit, 39, 23), argb(kGreen));
  EXPECT_EQ(at(commit, 0, 0), argb(kBlue));
  EXPECT_EQ(at(commit, 39, 0), 0x80112233u);
}

TEST_F(WaylandTest, OpaqueConfig) {
  config = choose_window({EGL_ALPHA_SIZE, 0});
  const EGLSurface surface = current_surface(window());
  clear(0x00ff00ffu);
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  EXPECT_FALSE(committed().has_alpha);
  EXPECT_EQ(at(committed(), 3, 3) & 0xffffffu, 0xff00ffu);
}

// Configs of 16 bits have buffers of 16 bits, whose rows are whole words all the same.
TEST_F(WaylandTest, SixteenBits) {
  config = choose_window({EGL_BUFFER_SIZE, 16, EGL_GREEN_SIZE, EGL_DONT_CARE});
  EGLint green = 0, kinds = 0;
  eglGetConfigAttrib(display, config, EGL_GREEN_SIZE, &green);
  EXPECT_EQ(green, 6);
  const EGLSurface surface = current_surface(window(5, 4));
  clear(kRed);
  clear_part(kGreen, 1, 0, 1, 1);
  clear_part(kBlue, 4, 3, 1, 1);
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  const Commit commit = committed();
  EXPECT_TRUE(commit.is_rgb565);
  EXPECT_EQ(at(commit, 0, 0), argb(kRed));
  EXPECT_EQ(at(commit, 1, 3), argb(kGreen));
  EXPECT_EQ(at(commit, 4, 0), argb(kBlue));
  EXPECT_EQ(at(commit, 4, 1), argb(kRed));
  // Those that compositors have no common format for are for pbuffers.
  const EGLint four[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_BUFFER_SIZE, 16, EGL_NONE};
  std::array<EGLConfig, 64> list{};
  EGLint count = 0;
  eglChooseConfig(display, four, list.data(), 64, &count);
  for (EGLint i = 0; i < count; ++i) {
    EGLint alpha = 0, red = 0;
    eglGetConfigAttrib(display, list[static_cast<size_t>(i)], EGL_ALPHA_SIZE, &alpha);
    eglGetConfigAttrib(display, list[static_cast<size_t>(i)], EGL_RED_SIZE, &red);
    eglGetConfigAttrib(display, list[static_cast<size_t>(i)], EGL_SURFACE_TYPE, &kinds);
    EXPECT_EQ((kinds & EGL_WINDOW_BIT) != 0, red == 8 || alpha == 0);
  }
}

TEST_F(WaylandTest, EveryPixel) {
  constexpr int kWidth = 333, kHeight = 217;
  const EGLSurface surface = current_surface(window(kWidth, kHeight));
  for (int y = 0; y < kHeight; y += 31) {
    for (int x = 0; x < kWidth; x += 29) {
      clear_part((x / 29 + y / 31) % 2 == 0 ? kRed : kBlue, x, y, 29, 31);
    }
  }
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  const Commit commit = committed();
  int wrong = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool even = (x / 29 + (kHeight - 1 - y) / 31) % 2 == 0;
      wrong += at(commit, x, y) != argb(even ? kRed : kBlue);
    }
  }
  EXPECT_EQ(wrong, 0);
}

TEST_F(WaylandTest, FollowsTheWindow) {
  wl_egl_window* on = window(16, 16);
  const EGLSurface surface = current_surface(on);
  clear(kRed);
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  wl_egl_window_resize(on, 50, 30, 3, -4);
  EXPECT_EQ(query(surface, EGL_WIDTH), 50);
  clear(kGreen);
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  Commit commit = committed();
  EXPECT_EQ(commit.width, 50);
  EXPECT_EQ(commit.height, 30);
  EXPECT_EQ(commit.dx, 3);
  EXPECT_EQ(commit.dy, -4);
  EXPECT_EQ(at(commit, 49, 29), argb(kGreen));
  int width = 0, height = 0;
  wl_egl_window_get_attached_size(on, &width, &height);
  EXPECT_EQ(width, 50);
  EXPECT_EQ(height, 30);
  clear(kBlue);
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  commit = committed();
  EXPECT_EQ(commit.dx, 0);  // it moves once
  EXPECT_EQ(at(commit, 0, 0), argb(kBlue));
}

// Only what is damaged is told and copied; a buffer that comes round again gets what it missed.
TEST_F(WaylandTest, DamageOfManyBuffers) {
  const auto with_damage = proc<PFNEGLSWAPBUFFERSWITHDAMAGEKHRPROC>("eglSwapBuffersWithDamageKHR");
  for (const size_t held : {0, 1, 2}) {
    compositor_.hold_buffers(held);
    const EGLSurface surface = current_surface(window(64, 64));
    std::vector<uint32_t> expected(64 * 64, argb(kRed));
    clear(kRed);
    EXPECT_EGL_OK(eglSwapBuffers(display, surface));
    for (int i = 0; i < 14; ++i) {
      const int x = i % 7 * 9, y = i * 4;
      const uint32_t colour = 0xff000000u | static_cast<uint32_t>(i + 1) * 0x0a0b0cu;
      clear_part(colour, x, y, 9, 4);
      EGLint rect[] = {x, y, 9, 4};
      EXPECT_EGL_OK(with_damage(display, surface, rect, 1));
      for (int row = 0; row < 4; ++row) {
        std::fill_n(expected.begin() + (63 - y - row) * 64 + x, 9, argb(colour));
      }
      const Commit commit = committed();
      EXPECT_EQ(commit.buffer, expected) << i;
      EXPECT_EQ(commit.shown, expected) << i;
    }
    // What is not said to be damaged is not shown.
    clear(kBlue);
    EGLint rect[] = {0, 0, 8, 8};
    EXPECT_EGL_OK(with_damage(display, surface, rect, 1));
    EXPECT_EQ(at(committed(), 0, 63), argb(kBlue));
    EXPECT_NE(at(committed(), 8, 63), argb(kBlue));
    eglReleaseThread();
    eglDestroySurface(display, surface);
  }
  compositor_.hold_buffers(0);
}

TEST_F(WaylandTest, BufferAge) {
  const EGLSurface surface = current_surface(window());
  EXPECT_EQ(query(surface, EGL_BUFFER_AGE_EXT), 0);
  clear(kRed);
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  EXPECT_EQ(query(surface, EGL_BUFFER_AGE_EXT), 1);
}

TEST_F(WaylandTest, FramesAreWaitedFor) {
  compositor_.set_frames(Frames::kEvery20Milliseconds);
  const EGLSurface surface = current_surface(window(), 1);
  const auto time_of = [&](int frames) {
    const auto begin = Clock::now();
    for (int i = 0; i < frames; ++i) {
      clear(i % 2 == 0 ? kRed : kGreen);
      EXPECT_TRUE(eglSwapBuffers(display, surface));
    }
    return Clock::now() - begin;
  };
  time_of(1);
  const auto unhurried = time_of(10);
  EXPECT_GT(unhurried, milliseconds(140));
  EXPECT_LT(unhurried, milliseconds(3000));
  EXPECT_TRUE(eglSwapInterval(display, 0));
  EXPECT_LT(time_of(10), unhurried / 2);
}

// A window that is hidden gets no frames: the program is slowed down, not stopped.
TEST_F(WaylandTest, HiddenWindow) {
  compositor_.set_frames(Frames::kNever);
  const EGLSurface surface = current_surface(window(), 1);
  const auto begin = Clock::now();
  for (int i = 0; i < 2; ++i) {
    clear(kRed);
    EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  }
  EXPECT_GT(Clock::now() - begin, milliseconds(500));
  EXPECT_LT(Clock::now() - begin, milliseconds(5000));
  wl_display_roundtrip(wayland_);
  EXPECT_EQ(compositor_.commits(), 2u);
}

// Waiting for a frame does not keep other threads from ending the display.
TEST_F(WaylandTest, TerminatedWhileWaiting) {
  compositor_.set_frames(Frames::kNever);
  wl_egl_window* on = window();
  std::thread waiting([&] {
    const EGLSurface surface = current_surface(on, 1);
    while (eglSwapBuffers(display, surface)) clear(kRed);
    EXPECT_NE(eglGetError(), EGL_SUCCESS);
    eglReleaseThread();
  });
  while (compositor_.commits() == 0) std::this_thread::sleep_for(milliseconds(1));
  std::this_thread::sleep_for(milliseconds(50));
  const auto begin = Clock::now();
  EXPECT_EGL_OK(eglTerminate(display));
  EXPECT_LT(Clock::now() - begin, milliseconds(500));
  waiting.join();
}

// The compositor keeps all buffers: what does not wait for frames waits for them, for a while.
TEST_F(WaylandTest, BuffersAreNeverReleased) {
  compositor_.hold_buffers(1000);
  const EGLSurface surface = current_surface(window());
  for (int i = 0; i < 4; ++i) EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  EXPECT_EGL_FAIL(eglSwapBuffers(display, surface), EGL_FALSE, EGL_BAD_ALLOC);
  compositor_.hold_buffers(0);
}

TEST_F(WaylandTest, RefusedWindows) {
  EXPECT_EGL_FAIL(window_surface(nullptr), EGL_NO_SURFACE, EGL_BAD_NATIVE_WINDOW);
  wl_egl_window* on = window();
  const EGLSurface surface = window_surface(on);
  EXPECT_NE(surface, EGL_NO_SURFACE);
  EXPECT_EGL_FAIL(window_surface(on), EGL_NO_SURFACE, EGL_BAD_ALLOC);
  EXPECT_EGL_OK(eglDestroySurface(display, surface));
  EXPECT_NE(
      eglCreateWindowSurface(display, config, reinterpret_cast<EGLNativeWindowType>(on), nullptr),
      EGL_NO_SURFACE);
  int pixmap = 0;
  EXPECT_EGL_FAIL(eglCreatePlatformPixmapSurface(display, config, &pixmap, nullptr), EGL_NO_SURFACE,
                  EGL_BAD_PARAMETER);
  // Too large for any memory.
  EXPECT_EGL_FAIL(window_surface(window(100000, 100000)), EGL_NO_SURFACE, EGL_BAD_ALLOC);
}

// Destroyed by the application before the surface, as programs do.
TEST_F(WaylandTest, DestroyedWindow) {
  wl_egl_window* on = window();
  const EGLSurface surface = current_surface(on);
  clear(kRed);
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  destroy_window(on);
  clear(kGreen);
  EXPECT_EGL_FAIL(eglSwapBuffers(display, surface), EGL_FALSE, EGL_BAD_NATIVE_WINDOW);
  uint32_t pixel = 0;
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
  EXPECT_EQ(pixel, kGreen);
  EXPECT_EGL_OK(eglDestroySurface(display, surface));
  EXPECT_EGL_OK(eglReleaseThread());
}

TEST_F(WaylandTest, BrokenConnection) {
  const EGLSurface surface = current_surface(window());
  clear(kRed);
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  compositor_.disconnect_clients();
  EGLBoolean result = EGL_TRUE;
  for (int i = 0; i < 100 && result; ++i) {
    clear(kGreen);
    result = eglSwapBuffers(display, surface);
  }
  EXPECT_EQ(result, EGL_FALSE);
  EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
  EXPECT_EGL_OK(eglReleaseThread());
  EXPECT_EGL_OK(eglTerminate(display));
  EXPECT_EGL_FAIL(eglInitialize(display, nullptr, nullptr), EGL_FALSE, EGL_NOT_INITIALIZED);
}

TEST_F(WaylandTest, ManyThreads) {
  std::vector<wl_egl_window*> windows = {window(), window(), window()};
  std::vector<std::thread> threads;
  for (wl_egl_window* on : windows) {
    threads.emplace_back([this, on] {
      const EGLSurface surface = current_surface(on, 1);
      for (int frame = 0; frame < 30; ++frame) {
        clear(kRed);
        EXPECT_TRUE(eglSwapBuffers(display, surface));
      }
      eglReleaseThread();
    });
  }
  for (std::thread& thread : threads) thread.join();
  wl_display_roundtrip(wayland_);
  EXPECT_EQ(compositor_.commits(), 90u);
}

}  // namespace
}  // namespace clearpipe::icd
