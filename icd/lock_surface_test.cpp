// Surfaces that are locked and drawn to by the program (EGL_KHR_lock_surface3).
// SPDX-License-Identifier: MIT
#include "icd/egl_test.h"

namespace clearpipe::icd {
namespace {

constexpr EGLint kWidth = 70, kHeight = 40;  // more than a tile each way

class LockSurfaceTest : public EglTest {
 protected:
  EGLConfig with_format(EGLint format) { return choose({EGL_MATCH_FORMAT_KHR, format}); }
  EGLint attrib(EGLConfig of, EGLint attribute) {
    EGLint value = -1;
    eglGetConfigAttrib(display, of, attribute, &value);
    return value;
  }
  std::byte* map(EGLSurface surface) {
    EGLAttribKHR pointer = 0;
    EXPECT_EGL_OK(query_(display, surface, EGL_BITMAP_POINTER_KHR, &pointer));
    return reinterpret_cast<std::byte*>(pointer);
  }
  template <class Pixel>
  Pixel& at(EGLSurface surface, int x, int y) {
    return reinterpret_cast<Pixel*>(map(surface) + query(surface, EGL_BITMAP_PITCH_KHR) * y)[x];
  }
  EGLBoolean lock(EGLSurface surface, std::vector<EGLint> list = {}) {
    list.push_back(EGL_NONE);
    return lock_(display, surface, list.data());
  }
  static uint32_t pixel(int x, int y) {
    uint32_t value = 0;
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &value);
    return value;
  }

  PFNEGLLOCKSURFACEKHRPROC lock_ = proc<PFNEGLLOCKSURFACEKHRPROC>("eglLockSurfaceKHR");
  PFNEGLUNLOCKSURFACEKHRPROC unlock_ = proc<PFNEGLUNLOCKSURFACEKHRPROC>("eglUnlockSurfaceKHR");
  PFNEGLQUERYSURFACE64KHRPROC query_ = proc<PFNEGLQUERYSURFACE64KHRPROC>("eglQuerySurface64KHR");
};

TEST_F(LockSurfaceTest, Configs) {
  std::array<EGLConfig, 128> all{};
  EGLint count = 0;
  ASSERT_TRUE(eglGetConfigs(display, all.data(), 128, &count));
  for (EGLint i = 0; i < count; ++i) {
    const EGLConfig c = all[static_cast<size_t>(i)];
    const bool lockable = (attrib(c, EGL_SURFACE_TYPE) & EGL_LOCK_SURFACE_BIT_KHR) != 0;
    EXPECT_EQ(lockable, attrib(c, EGL_SAMPLES) == 0);
    EXPECT_EQ(attrib(c, EGL_MATCH_FORMAT_KHR) == EGL_NONE, !lockable);
    if ((attrib(c, EGL_SURFACE_TYPE) & EGL_OPTIMAL_FORMAT_BIT_KHR) != 0) {
      EXPECT_TRUE(lockable);
    }
  }
  for (const EGLint format : {EGL_FORMAT_RGB_565_EXACT_KHR, EGL_FORMAT_RGB_565_KHR}) {
    const EGLConfig c = with_format(format);
    EXPECT_EQ(attrib(c, EGL_GREEN_SIZE), 6);
    EXPECT_EQ(attrib(c, EGL_BUFFER_SIZE), 16);
    EXPECT_EQ(attrib(c, EGL_MATCH_FORMAT_KHR), EGL_FORMAT_RGB_565_EXACT_KHR);
  }
  for (const EGLint format : {EGL_FORMAT_RGBA_8888_EXACT_KHR, EGL_FORMAT_RGBA_8888_KHR}) {
    const EGLConfig c = with_format(format);
    EXPECT_EQ(attrib(c, EGL_ALPHA_SIZE), 8);
    EXPECT_EQ(attrib(c, EGL_MATCH_FORMAT_KHR), EGL_FORMAT_RGBA_8888_EXACT_KHR);
  }
  EXPECT_EQ(attrib(with_format(EGL_NONE), EGL_SAMPLES), 4);
  EXPECT_NE(with_format(EGL_DONT_CARE), nullptr);
  const EGLint bad[] = {EGL_MATCH_FORMAT_KHR, EGL_TRUE, EGL_NONE};
  EGLConfig found = nullptr;
  EXPECT_EGL_FAIL(eglChooseConfig(display, bad, &found, 1, &count), EGL_FALSE, EGL_BAD_ATTRIBUTE);
}

TEST_F(LockSurfaceTest, WhatIsWrittenIsInTheSurface) {
  const EGLSurface surface = pbuffer(kWidth, kHeight);
  ASSERT_TRUE(lock(surface, {EGL_LOCK_USAGE_HINT_KHR, EGL_WRITE_SURFACE_BIT_KHR}));
  EXPECT_EQ(query(surface, EGL_BITMAP_ORIGIN_KHR), EGL_UPPER_LEFT_KHR);
  EXPECT_EQ(query(surface, EGL_BITMAP_PIXEL_SIZE_KHR), 32);
  EXPECT_EQ(query(surface, EGL_BITMAP_PIXEL_RED_OFFSET_KHR), 16);
  EXPECT_EQ(query(surface, EGL_BITMAP_PIXEL_GREEN_OFFSET_KHR), 8);
  EXPECT_EQ(query(surface, EGL_BITMAP_PIXEL_BLUE_OFFSET_KHR), 0);
  EXPECT_EQ(query(surface, EGL_BITMAP_PIXEL_ALPHA_OFFSET_KHR), 24);
  EXPECT_EQ(query(surface, EGL_BITMAP_PIXEL_LUMINANCE_OFFSET_KHR), 0);
  EXPECT_EQ(query(surface, EGL_WIDTH), kWidth);
  EXPECT_GE(query(surface, EGL_BITMAP_PITCH_KHR), 4 * kWidth);
  EXPECT_EQ(map(surface), map(surface));
  EGLAttribKHR height = 0;
  EXPECT_EGL_OK(query_(display, surface, EGL_HEIGHT, &height));
  EXPECT_EQ(height, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      at<uint32_t>(surface, x, y) = static_cast<uint32_t>(0x80000000 + (x << 16) + (y << 8) + 7);
    }
  }
  EXPECT_EGL_OK(unlock_(display, surface));
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, context()));
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      ASSERT_EQ(pixel(x, kHeight - 1 - y),
                static_cast<uint32_t>(0x80000000 + (7 << 16) + (y << 8) + x));
    }
  }
}

TEST_F(LockSurfaceTest, PixelsArePreservedOnDemand) {
  const EGLSurface surface = pbuffer(kWidth, kHeight);
  const EGLContext ctx = context();
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, ctx));
  clear(0xff0000ff);
  clear_part(0x40ff8000, 66, 35, 4, 5);
  ASSERT_TRUE(eglMakeCurrent(display, nullptr, nullptr, nullptr));
  ASSERT_TRUE(lock(surface, {EGL_MAP_PRESERVE_PIXELS_KHR, EGL_TRUE}));
  EXPECT_EQ(at<uint32_t>(surface, 0, 0), 0xffff0000u);
  EXPECT_EQ(at<uint32_t>(surface, 66, 0), 0x400080ffu);
  EXPECT_EQ(at<uint32_t>(surface, 69, 4), 0x400080ffu);
  EXPECT_EQ(at<uint32_t>(surface, 69, 5), 0xffff0000u);
  at<uint32_t>(surface, 1, kHeight - 1) = 0xff112233u;
  EXPECT_EGL_OK(unlock_(display, surface));
  // What is not mapped does not change.
  ASSERT_TRUE(lock(surface));
  EXPECT_EGL_OK(unlock_(display, surface));
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, ctx));
  EXPECT_EQ(pixel(0, 0), 0xff0000ffu);
  EXPECT_EQ(pixel(1, 0), 0xff332211u);
  EXPECT_EQ(pixel(68, 38), 0x40ff8000u);
}

TEST_F(LockSurfaceTest, SixteenBits) {
  config = with_format(EGL_FORMAT_RGB_565_EXACT_KHR);
  const EGLSurface surface = pbuffer(5, 3);
  ASSERT_TRUE(lock(surface));
  EXPECT_EQ(query(surface, EGL_BITMAP_PIXEL_SIZE_KHR), 16);
  EXPECT_EQ(query(surface, EGL_BITMAP_PIXEL_RED_OFFSET_KHR), 11);
  EXPECT_EQ(query(surface, EGL_BITMAP_PIXEL_GREEN_OFFSET_KHR), 5);
  EXPECT_EQ(query(surface, EGL_BITMAP_PIXEL_ALPHA_OFFSET_KHR), 0);
  at<uint16_t>(surface, 4, 0) = 0xf800;
  at<uint16_t>(surface, 0, 2) = 3 << 11 | 33 << 5 | 31;
  EXPECT_EGL_OK(unlock_(display, surface));
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, context()));
  EXPECT_EQ(pixel(4, 2), 0xff0000ffu);
  EXPECT_EQ(pixel(0, 0), 0xffff8618u);
  ASSERT_TRUE(eglMakeCurrent(display, nullptr, nullptr, nullptr));
  ASSERT_TRUE(lock(surface, {EGL_MAP_PRESERVE_PIXELS_KHR, EGL_TRUE}));
  EXPECT_EQ(at<uint16_t>(surface, 0, 2), 3 << 11 | 33 << 5 | 31);
}

TEST_F(LockSurfaceTest, LockErrors) {
  const EGLSurface surface = pbuffer(8, 8);
  EXPECT_EGL_FAIL(lock_(display, random_handle(), nullptr), EGL_FALSE, EGL_BAD_SURFACE);
  EXPECT_EGL_FAIL(unlock_(display, random_handle()), EGL_FALSE, EGL_BAD_SURFACE);
  EXPECT_EGL_FAIL(lock(surface, {EGL_WIDTH, 1}), EGL_FALSE, EGL_BAD_ATTRIBUTE);
  EXPECT_EGL_FAIL(lock(surface, {EGL_MAP_PRESERVE_PIXELS_KHR, 2}), EGL_FALSE, EGL_BAD_ATTRIBUTE);
  EXPECT_EGL_FAIL(lock(surface, {EGL_LOCK_USAGE_HINT_KHR, 4}), EGL_FALSE, EGL_BAD_ATTRIBUTE);
  EXPECT_EGL_FAIL(unlock_(display, surface), EGL_FALSE, EGL_BAD_ACCESS);
  EGLAttribKHR wide = 5;
  EGLint small = 5;
  EXPECT_EGL_FAIL(query_(display, surface, EGL_BITMAP_POINTER_KHR, &wide), EGL_FALSE,
                  EGL_BAD_ACCESS);
  EXPECT_EGL_FAIL(query_(display, surface, EGL_BITMAP_PITCH_KHR, &wide), EGL_FALSE, EGL_BAD_ACCESS);
  EXPECT_EGL_FAIL(eglQuerySurface(display, surface, EGL_BITMAP_PITCH_KHR, &small), EGL_FALSE,
                  EGL_BAD_ACCESS);
  EXPECT_EGL_FAIL(eglQuerySurface(display, surface, EGL_BITMAP_POINTER_KHR, &small), EGL_FALSE,
                  EGL_BAD_ATTRIBUTE);
  EXPECT_EGL_FAIL(query_(display, surface, 0x7fff, &wide), EGL_FALSE, EGL_BAD_ATTRIBUTE);
  EXPECT_EGL_FAIL(query_(display, surface, EGL_WIDTH, nullptr), EGL_FALSE, EGL_BAD_PARAMETER);
  EXPECT_EQ(wide, 5);
  EXPECT_EQ(small, 5);
  const EGLContext ctx = context();
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, ctx));
  EXPECT_EGL_FAIL(lock(surface), EGL_FALSE, EGL_BAD_ACCESS);
  ASSERT_TRUE(eglMakeCurrent(display, nullptr, nullptr, nullptr));
  const EGLSurface multisampled = pbuffer(choose({EGL_SAMPLES, 4}), 8, 8);
  EXPECT_EGL_FAIL(lock(multisampled), EGL_FALSE, EGL_BAD_ACCESS);
  EXPECT_EGL_OK(lock_(display, surface, nullptr));
  EXPECT_EGL_FAIL(lock(surface), EGL_FALSE, EGL_BAD_ACCESS);
}

TEST_F(LockSurfaceTest, ALockedSurfaceIsOfNoOtherUse) {
  const EGLint list[] = {EGL_WIDTH,
                         8,
                         EGL_HEIGHT,
                         8,
                         EGL_TEXTURE_FORMAT,
                         EGL_TEXTURE_RGBA,
                         EGL_TEXTURE_TARGET,
                         EGL_TEXTURE_2D,
                         EGL_NONE};
  const EGLSurface surface = eglCreatePbufferSurface(display, config, list);
  const EGLSurface other = pbuffer(8, 8);
  const EGLContext ctx = context();
  ASSERT_TRUE(lock(surface));
  for (const auto& [draw, read] : {std::pair(surface, other), std::pair(other, surface)}) {
    EXPECT_EGL_FAIL(eglMakeCurrent(display, draw, read, ctx), EGL_FALSE, EGL_BAD_ACCESS);
  }
  ASSERT_TRUE(eglMakeCurrent(display, other, other, ctx));
  EXPECT_EGL_FAIL(eglSwapBuffers(display, surface), EGL_FALSE, EGL_BAD_ACCESS);
  EXPECT_EGL_FAIL(eglCopyBuffers(display, surface, 0), EGL_FALSE, EGL_BAD_ACCESS);
  EXPECT_EGL_FAIL(eglBindTexImage(display, surface, EGL_BACK_BUFFER), EGL_FALSE, EGL_BAD_ACCESS);
  EXPECT_EGL_FAIL(eglReleaseTexImage(display, surface, EGL_BACK_BUFFER), EGL_FALSE, EGL_BAD_ACCESS);
  EXPECT_EGL_FAIL(eglSurfaceAttrib(display, surface, EGL_SWAP_BEHAVIOR, EGL_BUFFER_PRESERVED),
                  EGL_FALSE, EGL_BAD_ACCESS);
  EXPECT_EGL_FAIL(eglDestroySurface(display, surface), EGL_FALSE, EGL_BAD_ACCESS);
  EXPECT_EQ(query(surface, EGL_WIDTH), 8);
  EXPECT_EGL_OK(unlock_(display, surface));
  EXPECT_EGL_OK(eglMakeCurrent(display, surface, surface, ctx));
  EXPECT_EGL_OK(eglDestroySurface(display, other));
  // One that can be locked is posted without a context; one that has samples is not.
  EXPECT_EGL_OK(eglMakeCurrent(display, nullptr, nullptr, nullptr));
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  const EGLSurface multisampled = pbuffer(choose({EGL_SAMPLES, 4}), 8, 8);
  EXPECT_EGL_FAIL(eglSwapBuffers(display, multisampled), EGL_FALSE, EGL_BAD_SURFACE);
}

// A display that goes takes its locked surfaces with it.
TEST_F(LockSurfaceTest, TerminatedWhileLocked) {
  const EGLSurface surface = pbuffer(8, 8);
  ASSERT_TRUE(lock(surface));
  map(surface);
  EXPECT_EGL_OK(eglTerminate(display));
  EXPECT_EGL_OK(eglInitialize(display, nullptr, nullptr));
  EXPECT_EGL_FAIL(unlock_(display, surface), EGL_FALSE, EGL_BAD_SURFACE);
}

}  // namespace
}  // namespace clearpipe::icd
