// What a swap shows in windows of X11: damage, the age of buffers, the swap interval.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>

#include "icd/x11_test.h"

namespace clearpipe::icd {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

TEST_F(X11Test, OnlyDamageIsShown) {
  const auto with_damage = proc<PFNEGLSWAPBUFFERSWITHDAMAGEKHRPROC>("eglSwapBuffersWithDamageKHR");
  const auto with_damage_ext =
      proc<PFNEGLSWAPBUFFERSWITHDAMAGEEXTPROC>("eglSwapBuffersWithDamageEXT");
  const Window on = window(32, 32);
  const EGLSurface surface = current_surface(on);
  EGLint lower_left[] = {0, 0, 16, 16}, two[] = {16, 0, 16, 16, 0, 16, 4, 1000},
         outside[] = {-50, -50, 20, 20, 40, 0, 5, 5, 3, 3, -4, 2},
         overflow[] = {0x7ffffff0, 0x7ffffff0, 0x7fffffff, 0x7fffffff};
  clear(kRed);
  EXPECT_EGL_OK(with_damage(display, surface, lower_left, 1));  // the first frame comes whole
  EXPECT_EQ(shown(on, 31, 0), kRed);
  clear(kGreen);
  EXPECT_EGL_OK(with_damage(display, surface, lower_left, 1));
  EXPECT_EQ(shown(on, 0, 31), kGreen);
  EXPECT_EQ(shown(on, 15, 16), kGreen);
  EXPECT_EQ(shown(on, 16, 16), kRed);
  EXPECT_EQ(shown(on, 15, 15), kRed);
  clear(kBlue);
  EXPECT_EGL_OK(with_damage_ext(display, surface, two, 2));
  EXPECT_EQ(shown(on, 16, 31), kBlue);
  EXPECT_EQ(shown(on, 3, 0), kBlue);
  EXPECT_EQ(shown(on, 4, 0), kRed);
  EXPECT_EQ(shown(on, 0, 31), kGreen);
  clear(kWhite);
  EXPECT_EGL_OK(with_damage(display, surface, outside, 3));
  EXPECT_EGL_OK(with_damage(display, surface, overflow, 1));
  EXPECT_EQ(shown(on, 0, 31), kGreen);
  EXPECT_EGL_OK(with_damage(display, surface, nullptr, 0));  // nothing said: all of it
  EXPECT_EQ(shown(on, 4, 0), kWhite);
  EXPECT_EGL_FAIL(with_damage(display, surface, nullptr, 1), EGL_FALSE, EGL_BAD_PARAMETER);
  EXPECT_EGL_FAIL(with_damage(display, surface, lower_left, -1), EGL_FALSE, EGL_BAD_PARAMETER);
  EXPECT_EGL_FAIL(with_damage(display, random_handle(), lower_left, 1), EGL_FALSE, EGL_BAD_SURFACE);
  // A window of another size shows everything again.
  XResizeWindow(x_, on, 40, 40);
  XSync(x_, False);
  clear(kRed);
  EXPECT_EGL_OK(with_damage(display, surface, lower_left, 1));
  EXPECT_EQ(shown(on, 39, 0), kRed);
}

TEST_F(X11Test, BufferAgeAndPreservation) {
  const Window on = window();
  const EGLSurface surface = current_surface(on);
  // As EGL_KHR_lock_surface3 has it for windows that can be locked.
  EXPECT_EQ(query(surface, EGL_SWAP_BEHAVIOR), EGL_BUFFER_PRESERVED);
  EXPECT_EQ(query(surface, EGL_BUFFER_AGE_EXT), 0);
  clear(kRed);
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  EXPECT_EQ(query(surface, EGL_BUFFER_AGE_EXT), 1);
  EXPECT_EQ(pixel(), kRed);
  clear_part(kGreen, 0, 0, 8, 8);
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  EXPECT_EQ(shown(on, 0, 15), kGreen);
  EXPECT_EQ(shown(on, 15, 0), kRed);
  EXPECT_EGL_OK(eglSurfaceAttrib(display, surface, EGL_SWAP_BEHAVIOR, EGL_BUFFER_PRESERVED));
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  EXPECT_EQ(pixel(15, 15), kRed);
  // Asked for by another thread, or for a surface that is not drawn to: no answer.
  EGLint value = 7;
  EXPECT_EGL_FAIL(eglQuerySurface(display, window_surface(window()), EGL_BUFFER_AGE_EXT, &value),
                  EGL_FALSE, EGL_BAD_SURFACE);
  std::thread([&] {
    EXPECT_EGL_FAIL(eglQuerySurface(display, surface, EGL_BUFFER_AGE_EXT, &value), EGL_FALSE,
                    EGL_BAD_SURFACE);
  }).join();
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  XResizeWindow(x_, on, 20, 20);
  XSync(x_, False);
  EXPECT_EQ(query(surface, EGL_BUFFER_AGE_EXT), 0);
}

TEST_F(X11Test, DamageRegion) {
  const auto set_region = proc<PFNEGLSETDAMAGEREGIONKHRPROC>("eglSetDamageRegionKHR");
  const EGLSurface surface = current_surface(window());
  EGLint rect[] = {0, 0, 4, 4};
  EXPECT_EGL_FAIL(set_region(display, random_handle(), rect, 1), EGL_FALSE, EGL_BAD_SURFACE);
  EXPECT_EGL_FAIL(set_region(display, surface, rect, 1), EGL_FALSE, EGL_BAD_ACCESS);  // no age yet
  for (int frame = 0; frame < 2; ++frame) {
    query(surface, EGL_BUFFER_AGE_EXT);
    EXPECT_EGL_FAIL(set_region(display, surface, rect, -1), EGL_FALSE, EGL_BAD_PARAMETER);
    EXPECT_EGL_OK(set_region(display, surface, rect, 1));
    EXPECT_EGL_FAIL(set_region(display, surface, rect, 1), EGL_FALSE, EGL_BAD_ACCESS);  // once
    clear(kRed);
    EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  }
  query(surface, EGL_BUFFER_AGE_EXT);
  EXPECT_EGL_FAIL(set_region(display, window_surface(window()), rect, 1), EGL_FALSE, EGL_BAD_MATCH);
  EXPECT_EGL_OK(eglSurfaceAttrib(display, surface, EGL_SWAP_BEHAVIOR, EGL_BUFFER_PRESERVED));
  EXPECT_EGL_FAIL(set_region(display, surface, rect, 1), EGL_FALSE, EGL_BAD_MATCH);
}

// A program that draws by itself, without a context (EGL_KHR_lock_surface3).
TEST_F(X11Test, LockedWindow) {
  const auto lock = proc<PFNEGLLOCKSURFACEKHRPROC>("eglLockSurfaceKHR");
  const auto unlock = proc<PFNEGLUNLOCKSURFACEKHRPROC>("eglUnlockSurfaceKHR");
  const auto query64 = proc<PFNEGLQUERYSURFACE64KHRPROC>("eglQuerySurface64KHR");
  const Window on = window();
  const EGLSurface surface = window_surface(on);
  XResizeWindow(x_, on, 24, 20);
  XSync(x_, False);
  for (const bool destroyed : {false, true}) {
    ASSERT_TRUE(lock(display, surface, nullptr));
    EXPECT_EQ(query(surface, EGL_WIDTH), 24);  // the window's size by then
    EXPECT_EQ(query(surface, EGL_HEIGHT), 20);
    EGLAttribKHR pointer = 0;
    EXPECT_EGL_OK(query64(display, surface, EGL_BITMAP_POINTER_KHR, &pointer));
    const EGLint bytes = query(surface, EGL_BITMAP_PIXEL_SIZE_KHR) / 8;
    const EGLint red = query(surface, EGL_BITMAP_PIXEL_RED_OFFSET_KHR);
    auto* first = reinterpret_cast<uint8_t*>(pointer);
    const uint32_t value = (bytes == 2 ? 31u : 255u) << red;
    // The second time it holds what the first left.
    if (destroyed) {
      EXPECT_EQ(std::memcmp(first, &value, bytes == 2 ? 2 : 3), 0);
    }
    for (EGLint y = 0; y < 20; ++y) {
      for (EGLint x = 0; x < 24; ++x) {
        const uint32_t pixel = x < 8 && y < 8 ? value : 0;
        std::memcpy(first + y * query(surface, EGL_BITMAP_PITCH_KHR) + x * bytes, &pixel,
                    static_cast<size_t>(bytes));
      }
    }
    EXPECT_EGL_FAIL(eglSwapBuffers(display, surface), EGL_FALSE, EGL_BAD_ACCESS);
    EXPECT_EGL_OK(unlock(display, surface));
    EXPECT_EGL_OK(eglSwapBuffers(display, surface));
    EXPECT_EQ(shown(on, 0, 0), kRed);
    EXPECT_EQ(shown(on, 7, 7), kRed);
    EXPECT_EQ(shown(on, 8, 7), kBlack);
    EXPECT_EQ(shown(on, 0, 19), kBlack);
  }
  // Drawn to by a context of another thread, it is not this one's to post.
  EXPECT_EGL_OK(eglMakeCurrent(display, surface, surface, context()));
  std::thread([&] {
    EXPECT_EGL_FAIL(eglSwapBuffers(display, surface), EGL_FALSE, EGL_BAD_SURFACE);
  }).join();
  // What the surface is to do can be said when it is made.
  const EGLint list[] = {EGL_SWAP_BEHAVIOR, EGL_BUFFER_DESTROYED, EGL_NONE};
  const EGLSurface other = eglCreateWindowSurface(display, config, window(), list);
  EXPECT_EQ(query(other, EGL_SWAP_BEHAVIOR), EGL_BUFFER_DESTROYED);
  const EGLint bad[] = {EGL_SWAP_BEHAVIOR, EGL_BACK_BUFFER, EGL_NONE};
  EXPECT_EGL_FAIL(eglCreateWindowSurface(display, config, window(), bad), EGL_NO_SURFACE,
                  EGL_BAD_ATTRIBUTE);
}

// Interval 0 does not wait; others wait for the frames of the screen (3.10.3).
TEST_F(X11Test, SwapInterval) {
  const EGLSurface surface = current_surface(window());
  const auto time_of = [&](EGLint interval, int frames) {
    EXPECT_TRUE(eglSwapInterval(display, interval));
    EXPECT_TRUE(eglSwapBuffers(display, surface));
    const auto begin = Clock::now();
    for (int i = 0; i < frames; ++i) {
      clear(i % 2 == 0 ? kRed : kGreen);
      EXPECT_TRUE(eglSwapBuffers(display, surface));
    }
    return Clock::now() - begin;
  };
  const auto unhurried = time_of(1, 10), slow = time_of(3, 5);
  EXPECT_GT(unhurried, milliseconds(60));
  EXPECT_LT(unhurried, milliseconds(2000));
  EXPECT_GT(slow, milliseconds(100));
  // The shortest of a few: the machine may be busy with something else.
  EXPECT_LT(std::min({time_of(0, 10), time_of(0, 10), time_of(0, 10)}), unhurried / 2);
}

}  // namespace
}  // namespace clearpipe::icd
