// What the tests of EGL share. They see EGL and OpenGL ES as any program does, through whatever
// libEGL.so.1 and libGLESv1_CM.so.1 the loader finds; ctest runs them through libglvnd and again
// on the drop-in libraries.
// SPDX-License-Identifier: MIT
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES/gl.h>
#include <GLES/glext.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace clearpipe::icd {

// The call gives the result that means failure, and the error.
#define EXPECT_EGL_FAIL(call, result, error)                       \
  do {                                                             \
    EXPECT_EQ((call), (result)) << #call;                          \
    EXPECT_EQ(eglGetError(), static_cast<EGLint>(error)) << #call; \
  } while (false)

#define EXPECT_EGL_OK(call)                         \
  do {                                              \
    EXPECT_TRUE((call)) << #call;                   \
    EXPECT_EQ(eglGetError(), EGL_SUCCESS) << #call; \
  } while (false)

inline EGLDisplay surfaceless_display() {
  return eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
}

// libglvnd answers some calls itself, before they reach a vendor library.
inline bool through_libglvnd() { return std::getenv("__EGL_VENDOR_LIBRARY_FILENAMES") != nullptr; }

template <class Function>
Function proc(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

// A handle that nothing ever had.
inline void* random_handle() {
  static uintptr_t next = 0x5eed0001u;
  next = next * 1664525u + 1013904223u;
  return reinterpret_cast<void*>(next | 0x40000000u);
}

inline std::set<std::string> words(const char* text) {
  std::istringstream stream(text != nullptr ? text : "");
  return {std::istream_iterator<std::string>(stream), {}};
}

// An initialized display, terminated afterwards with nothing current.
class EglTest : public testing::Test {
 protected:
  void SetUp() override {
    display = surfaceless_display();
    ASSERT_NE(display, EGL_NO_DISPLAY);
    ASSERT_TRUE(eglInitialize(display, nullptr, nullptr));
    config = choose({EGL_ALPHA_SIZE, 8, EGL_DEPTH_SIZE, 24, EGL_STENCIL_SIZE, 8});
    ASSERT_NE(config, nullptr);
  }
  void TearDown() override {
    eglReleaseThread();
    eglTerminate(display);
    eglReleaseThread();
  }

  // The colour as it is read, RGBA8.
  static void clear(uint32_t colour) {
    const auto component = [colour](int shift) {
      return static_cast<float>(colour >> shift & 255) / 255;
    };
    glClearColor(component(0), component(8), component(16), component(24));
    glClear(GL_COLOR_BUFFER_BIT);
  }
  static void clear_part(uint32_t colour, int x, int y, int width, int height) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(x, y, width, height);
    clear(colour);
    glDisable(GL_SCISSOR_TEST);
  }

  EGLConfig choose(std::vector<EGLint> attributes) {
    attributes.insert(attributes.end(), {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE});
    EGLConfig found = nullptr;
    EGLint count = 0;
    eglChooseConfig(display, attributes.data(), &found, 1, &count);
    return count == 1 ? found : nullptr;
  }
  EGLSurface pbuffer(EGLint width, EGLint height) { return pbuffer(config, width, height); }
  EGLSurface pbuffer(EGLConfig with, EGLint width, EGLint height) {
    const EGLint attributes[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    return eglCreatePbufferSurface(display, with, attributes);
  }
  EGLContext context(EGLContext share = EGL_NO_CONTEXT) {
    return eglCreateContext(display, config, share, nullptr);
  }
  EGLContext context_with(const std::vector<EGLint>& attributes,
                          EGLContext share = EGL_NO_CONTEXT) {
    std::vector<EGLint> list = attributes;
    list.push_back(EGL_NONE);
    return eglCreateContext(display, config, share, list.data());
  }
  EGLint query(EGLSurface surface, EGLint attribute) {
    EGLint value = -12345;
    EXPECT_EGL_OK(eglQuerySurface(display, surface, attribute, &value));
    return value;
  }

  EGLDisplay display = EGL_NO_DISPLAY;
  EGLConfig config = nullptr;
};

// Clears to a colour and reads one pixel back as 0xAABBGGRR.
inline uint32_t clear_and_read(float r, float g, float b, float a, int x = 0, int y = 0) {
  glClearColor(r, g, b, a);
  glClear(GL_COLOR_BUFFER_BIT);
  uint32_t pixel = 0;
  glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
  return pixel;
}

}  // namespace clearpipe::icd
