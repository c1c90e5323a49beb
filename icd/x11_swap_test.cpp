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
  EXPECT_EQ(query(surface, EGL_SWAP_BEHAVIOR), EGL_BUFFER_DESTROYED);
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
