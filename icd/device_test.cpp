// Devices and the displays made from them (EGL_EXT_device_base, EGL_EXT_platform_device).
// SPDX-License-Identifier: MIT
#include "icd/egl_test.h"

namespace clearpipe::icd {
namespace {

class DeviceTest : public EglTest {
 protected:
  void SetUp() override {
    EglTest::SetUp();
    EGLint count = 0;
    ASSERT_TRUE(query_devices(1, &device, &count));
    ASSERT_EQ(count, 1);
  }
  EGLDisplay device_display() {
    return eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
  }

  const PFNEGLQUERYDEVICESEXTPROC query_devices =
      reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  const PFNEGLQUERYDEVICEATTRIBEXTPROC query_attrib =
      reinterpret_cast<PFNEGLQUERYDEVICEATTRIBEXTPROC>(
          eglGetProcAddress("eglQueryDeviceAttribEXT"));
  const PFNEGLQUERYDEVICESTRINGEXTPROC query_string =
      reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(
          eglGetProcAddress("eglQueryDeviceStringEXT"));
  const PFNEGLQUERYDISPLAYATTRIBEXTPROC query_display =
      reinterpret_cast<PFNEGLQUERYDISPLAYATTRIBEXTPROC>(
          eglGetProcAddress("eglQueryDisplayAttribEXT"));
  EGLDeviceEXT device = EGL_NO_DEVICE_EXT;
};

TEST_F(DeviceTest, Enumeration) {
  const auto client = words(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS));
  for (const char* name : {"EGL_EXT_device_base", "EGL_EXT_device_enumeration",
                           "EGL_EXT_device_query", "EGL_EXT_platform_device"}) {
    EXPECT_TRUE(client.count(name)) << name;
  }
  EXPECT_NE(device, EGL_NO_DEVICE_EXT);
  EGLint count = 0;
  EXPECT_EGL_OK(query_devices(0, nullptr, &count));
  EXPECT_EQ(count, 1);
  EGLDeviceEXT list[3] = {};
  EXPECT_EGL_OK(query_devices(3, list, &count));
  EXPECT_EQ(count, 1);
  EXPECT_EQ(list[0], device);
  EXPECT_EQ(list[1], EGL_NO_DEVICE_EXT);
  EXPECT_EGL_FAIL(query_devices(0, list, &count), EGL_FALSE, EGL_BAD_PARAMETER);
  EXPECT_EGL_FAIL(query_devices(-1, list, &count), EGL_FALSE, EGL_BAD_PARAMETER);
  EXPECT_EGL_FAIL(query_devices(3, list, nullptr), EGL_FALSE, EGL_BAD_PARAMETER);
}

TEST_F(DeviceTest, Queries) {
  const auto extensions = words(query_string(device, EGL_EXTENSIONS));
  EXPECT_TRUE(extensions.count("EGL_MESA_device_software"));
  EXPECT_TRUE(extensions.count("EGL_EXT_device_query_name"));
  EXPECT_STREQ(query_string(device, EGL_VENDOR), "clearpipe");
  EXPECT_STREQ(query_string(device, EGL_RENDERER_EXT), "clearpipe");
  EXPECT_EGL_FAIL(query_string(device, EGL_WIDTH), nullptr, EGL_BAD_PARAMETER);
  EGLAttrib value = 77;
  EXPECT_EGL_FAIL(query_attrib(device, EGL_WIDTH, &value), EGL_FALSE, EGL_BAD_ATTRIBUTE);
  for (const EGLDeviceEXT wrong : {EGL_NO_DEVICE_EXT, static_cast<EGLDeviceEXT>(random_handle()),
                                   static_cast<EGLDeviceEXT>(display)}) {
    EXPECT_EGL_FAIL(query_string(wrong, EGL_EXTENSIONS), nullptr, EGL_BAD_DEVICE_EXT);
    EXPECT_EGL_FAIL(query_attrib(wrong, EGL_WIDTH, &value), EGL_FALSE, EGL_BAD_DEVICE_EXT);
  }
  EXPECT_EQ(value, 77);
}

TEST_F(DeviceTest, EveryDisplayHasTheDevice) {
  EGLAttrib value = 0;
  EXPECT_EGL_OK(query_display(display, EGL_DEVICE_EXT, &value));
  EXPECT_EQ(reinterpret_cast<EGLDeviceEXT>(value), device);
  EXPECT_EGL_FAIL(query_display(display, EGL_WIDTH, &value), EGL_FALSE, EGL_BAD_ATTRIBUTE);
  EXPECT_EGL_FAIL(query_display(random_handle(), EGL_DEVICE_EXT, &value), EGL_FALSE,
                  EGL_BAD_DISPLAY);
  ASSERT_TRUE(eglTerminate(display));
  EXPECT_EGL_FAIL(query_display(display, EGL_DEVICE_EXT, &value), EGL_FALSE, EGL_NOT_INITIALIZED);
}

TEST_F(DeviceTest, Platform) {
  const EGLDisplay own = device_display();
  ASSERT_NE(own, EGL_NO_DISPLAY);
  EXPECT_NE(own, display);
  EXPECT_EQ(device_display(), own);
  const auto get_platform_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  EXPECT_EQ(get_platform_display(EGL_PLATFORM_DEVICE_EXT, device, nullptr), own);
  EXPECT_EQ(get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr), display);
  const EGLint list[] = {EGL_WIDTH, 1, EGL_NONE};
  EXPECT_EGL_FAIL(get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, list),
                  EGL_NO_DISPLAY, EGL_BAD_ATTRIBUTE);
  for (void* const wrong : {static_cast<void*>(nullptr), random_handle()}) {
    EXPECT_EGL_FAIL(eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, wrong, nullptr), EGL_NO_DISPLAY,
                    EGL_BAD_PARAMETER);
  }
  // A display of its own: initialized and terminated by itself, and drawn to.
  EGLint count = 0;
  EXPECT_EGL_FAIL(eglGetConfigs(own, nullptr, 0, &count), EGL_FALSE, EGL_NOT_INITIALIZED);
  ASSERT_TRUE(eglInitialize(own, nullptr, nullptr));
  display = own;
  EXPECT_EGL_FAIL(pbuffer(4, 4), EGL_NO_SURFACE, EGL_BAD_CONFIG);  // configs belong to displays
  config = choose({EGL_ALPHA_SIZE, 8});
  const EGLSurface surface = pbuffer(4, 4);
  EXPECT_EGL_OK(eglMakeCurrent(own, surface, surface, context()));
  EXPECT_EQ(eglGetCurrentDisplay(), own);
  EXPECT_EQ(clear_and_read(1, 0, 0, 1), 0xff0000ffu);
  eglReleaseThread();
  eglTerminate(surfaceless_display());
}

// Handles of one display name nothing in another (3.7.1, 3.7.3, 3.8.1).
TEST_F(DeviceTest, OtherDisplaysObjectsAreRefused) {
  const EGLDisplay own = device_display();
  ASSERT_TRUE(eglInitialize(own, nullptr, nullptr));
  const EGLSurface surface = pbuffer(4, 4);
  const EGLContext ctx = context();
  const EGLSync sync = eglCreateSync(display, EGL_SYNC_REUSABLE_KHR, nullptr);
  EGLint value = 0;
  EGLConfig own_config = nullptr;
  const EGLint any[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE};
  ASSERT_TRUE(eglChooseConfig(own, any, &own_config, 1, &value));
  EXPECT_EGL_FAIL(eglCreateContext(own, own_config, ctx, nullptr), EGL_NO_CONTEXT, EGL_BAD_MATCH);
  EXPECT_EGL_FAIL(eglMakeCurrent(own, surface, surface, ctx), EGL_FALSE, EGL_BAD_CONTEXT);
  EXPECT_EGL_FAIL(eglDestroyContext(own, ctx), EGL_FALSE, EGL_BAD_CONTEXT);
  EXPECT_EGL_FAIL(eglQuerySurface(own, surface, EGL_WIDTH, &value), EGL_FALSE, EGL_BAD_SURFACE);
  EXPECT_EGL_FAIL(eglDestroySurface(own, surface), EGL_FALSE, EGL_BAD_SURFACE);
  EXPECT_EGL_FAIL(eglDestroySync(own, sync), EGL_FALSE, EGL_BAD_PARAMETER);
  const EGLContext own_context = eglCreateContext(own, own_config, EGL_NO_CONTEXT, nullptr);
  EXPECT_EGL_FAIL(eglMakeCurrent(own, surface, surface, own_context), EGL_FALSE, EGL_BAD_SURFACE);
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, ctx));
  EXPECT_EGL_FAIL(eglCreateSync(own, EGL_SYNC_FENCE, nullptr), EGL_NO_SYNC, EGL_BAD_MATCH);
  // From a context of one display to one of the other.
  EXPECT_EGL_OK(eglMakeCurrent(own, EGL_NO_SURFACE, EGL_NO_SURFACE, own_context));
  EXPECT_EQ(eglGetCurrentDisplay(), own);
  EXPECT_EGL_OK(eglTerminate(display));
  EXPECT_EQ(eglGetCurrentContext(), own_context);
  EXPECT_EGL_OK(eglTerminate(own));
}

}  // namespace
}  // namespace clearpipe::icd
