// clearpipe and Mesa open in one process: libglvnd is given both vendors, the program picks each by
// its device (EGL_EXT_device_enumeration, EGL_EXT_platform_device) and draws on both.
// SPDX-License-Identifier: MIT
#include <map>
#include <thread>

#include "icd/egl_test.h"

namespace clearpipe::icd {
namespace {

// One vendor's display, with a context and a pbuffer.
struct Side {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLSurface surface = EGL_NO_SURFACE;
  EGLContext context = EGL_NO_CONTEXT;

  bool make_current() const { return eglMakeCurrent(display, surface, surface, context); }
  bool open() {
    const EGLint wanted[] = {EGL_SURFACE_TYPE,
                             EGL_PBUFFER_BIT,
                             EGL_RENDERABLE_TYPE,
                             EGL_OPENGL_ES_BIT,
                             EGL_RED_SIZE,
                             8,
                             EGL_ALPHA_SIZE,
                             8,
                             EGL_NONE};
    const EGLint size[] = {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count != 1) return false;
    surface = eglCreatePbufferSurface(display, config, size);
    context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    return surface != EGL_NO_SURFACE && context != EGL_NO_CONTEXT;
  }
};

class CoexistTest : public testing::Test {
 protected:
  // Opened once and left open: memory that Mesa's driver keeps is told by its name only while the
  // driver is loaded (scripts/lsan.supp).
  static void SetUpTestSuite() {
    const auto query_devices =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    ASSERT_TRUE(query_devices(16, devices.data(), &count));
    for (EGLint i = 0; i < count; ++i) {
      const EGLDisplay display =
          eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<size_t>(i)], nullptr);
      if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) continue;
      sides[eglQueryString(display, EGL_VENDOR)].display = display;
    }
    ASSERT_EQ(sides.size(), 2u);
    ASSERT_TRUE(sides.count("clearpipe"));
    ASSERT_TRUE(sides.count("Mesa Project"));
    for (auto& [vendor, side] : sides) ASSERT_TRUE(side.open()) << vendor;
  }
  void SetUp() override { ASSERT_EQ(sides.size(), 2u); }
  void TearDown() override { eglReleaseThread(); }

  static inline std::map<std::string, Side> sides;
};

TEST_F(CoexistTest, EachDrawsOnItsOwn) {
  for (int round = 0; round < 3; ++round) {
    for (const auto& [vendor, side] : sides) {
      ASSERT_TRUE(side.make_current()) << vendor;
      const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
      EXPECT_EQ(renderer.find("clearpipe") != std::string::npos, vendor == "clearpipe") << renderer;
      EXPECT_EQ(clear_and_read(0, round == 1 ? 1.0f : 0.0f, 1, 1, 15, 15),
                round == 1 ? 0xffffff00u : 0xffff0000u)
          << vendor;
    }
  }
}

TEST_F(CoexistTest, BothAtOnceInTwoThreads) {
  std::map<std::string, int> right;
  for (const auto& [vendor, side] : sides) right[vendor] = 0;
  std::vector<std::thread> threads;
  for (const auto& [vendor, side] : sides) {
    threads.emplace_back([&side = side, &frames = right[vendor]] {
      if (!side.make_current()) return;
      for (int frame = 0; frame < 20; ++frame) {
        frames += clear_and_read(0, 1, 0, 1, frame % 16, 3) == 0xff00ff00u ? 1 : 0;
      }
      eglReleaseThread();
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const auto& [vendor, frames] : right) EXPECT_EQ(frames, 20) << vendor;
}

// OpenGL is bound: that is Mesa's to create, and nothing of ours (3.7.1).
TEST_F(CoexistTest, OpenGlContextsAreMesasAlone) {
  ASSERT_TRUE(eglBindAPI(EGL_OPENGL_API));
  EXPECT_EGL_FAIL(eglCreateContext(sides["clearpipe"].display, nullptr, EGL_NO_CONTEXT, nullptr),
                  EGL_NO_CONTEXT, EGL_BAD_MATCH);
  ASSERT_TRUE(eglBindAPI(EGL_OPENGL_ES_API));
  EXPECT_NE(eglCreateContext(sides["clearpipe"].display, nullptr, EGL_NO_CONTEXT, nullptr),
            EGL_NO_CONTEXT);
}

// Extension commands reach the vendor whose display they are given.
TEST_F(CoexistTest, SyncsGoToTheirVendor) {
  const auto create =
      reinterpret_cast<PFNEGLCREATESYNCKHRPROC>(eglGetProcAddress("eglCreateSyncKHR"));
  const auto wait =
      reinterpret_cast<PFNEGLCLIENTWAITSYNCKHRPROC>(eglGetProcAddress("eglClientWaitSyncKHR"));
  const auto destroy =
      reinterpret_cast<PFNEGLDESTROYSYNCKHRPROC>(eglGetProcAddress("eglDestroySyncKHR"));
  for (const auto& [vendor, side] : sides) {
    ASSERT_TRUE(side.make_current());
    glClear(GL_COLOR_BUFFER_BIT);
    const EGLSyncKHR fence = create(side.display, EGL_SYNC_FENCE_KHR, nullptr);
    ASSERT_NE(fence, EGL_NO_SYNC_KHR) << vendor;
    EXPECT_EQ(wait(side.display, fence, EGL_SYNC_FLUSH_COMMANDS_BIT_KHR, EGL_FOREVER_KHR),
              EGL_CONDITION_SATISFIED_KHR)
        << vendor;
    EXPECT_EGL_OK(destroy(side.display, fence));
  }
}

}  // namespace
}  // namespace clearpipe::icd
