// Errors and displays (3.1 to 3.3).
// SPDX-License-Identifier: MIT
#include "icd/egl_test.h"

namespace clearpipe::icd {
namespace {

TEST(Display, OneHandleForOnePlatform) {
  const EGLDisplay display = surfaceless_display();
  ASSERT_NE(display, EGL_NO_DISPLAY);
  EXPECT_EQ(surfaceless_display(), display);
  const EGLAttrib empty[] = {EGL_NONE};
  EXPECT_EQ(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, empty), display);
  EXPECT_EQ(eglGetError(), EGL_SUCCESS);
}

TEST(Display, TheDefaultDisplayIsSurfaceless) {
  EXPECT_EQ(eglGetDisplay(EGL_DEFAULT_DISPLAY), surfaceless_display());
  EXPECT_EQ(eglGetError(), EGL_SUCCESS);
}

TEST(Display, PlatformsThatAreNotHere) {
  EXPECT_EGL_FAIL(eglGetPlatformDisplay(EGL_PLATFORM_GBM_KHR, nullptr, nullptr), EGL_NO_DISPLAY,
                  EGL_BAD_PARAMETER);
  EXPECT_EGL_FAIL(eglGetPlatformDisplay(0x1234, nullptr, nullptr), EGL_NO_DISPLAY,
                  EGL_BAD_PARAMETER);
  EXPECT_EGL_FAIL(eglGetPlatformDisplay(EGL_NONE, nullptr, nullptr), EGL_NO_DISPLAY,
                  EGL_BAD_PARAMETER);
  int native = 0;
  EXPECT_EGL_FAIL(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, &native, nullptr),
                  EGL_NO_DISPLAY, EGL_BAD_PARAMETER);
}

TEST(Display, AttributesAreRefused) {
  const EGLAttrib list[] = {EGL_WIDTH, 1, EGL_NONE};
  EXPECT_EGL_FAIL(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, list),
                  EGL_NO_DISPLAY, EGL_BAD_ATTRIBUTE);
}

TEST(Display, InitializeTellsTheVersionAndMayBeRepeated) {
  const EGLDisplay display = surfaceless_display();
  EGLint major = 0, minor = 0;
  EXPECT_EGL_OK(eglInitialize(display, &major, &minor));
  EXPECT_EQ(major, 1);
  EXPECT_EQ(minor, 5);
  major = minor = 0;
  EXPECT_EGL_OK(eglInitialize(display, &major, nullptr));
  EXPECT_EGL_OK(eglInitialize(display, nullptr, &minor));
  EXPECT_EQ(major, 1);
  EXPECT_EQ(minor, 5);
  EXPECT_EGL_OK(eglTerminate(display));
  EXPECT_EGL_OK(eglTerminate(display));
}

TEST(Display, WrongDisplays) {
  for (const EGLDisplay wrong : {EGL_NO_DISPLAY, static_cast<EGLDisplay>(random_handle()),
                                 static_cast<EGLDisplay>(random_handle())}) {
    EGLint value = 77;
    EGLConfig config = nullptr;
    EXPECT_EGL_FAIL(eglInitialize(wrong, &value, &value), EGL_FALSE, EGL_BAD_DISPLAY);
    EXPECT_EGL_FAIL(eglTerminate(wrong), EGL_FALSE, EGL_BAD_DISPLAY);
    EXPECT_EGL_FAIL(eglQueryString(wrong, EGL_VENDOR), nullptr, EGL_BAD_DISPLAY);
    EXPECT_EGL_FAIL(eglGetConfigs(wrong, &config, 1, &value), EGL_FALSE, EGL_BAD_DISPLAY);
    EXPECT_EGL_FAIL(eglChooseConfig(wrong, nullptr, &config, 1, &value), EGL_FALSE,
                    EGL_BAD_DISPLAY);
    EXPECT_EGL_FAIL(eglCreatePbufferSurface(wrong, config, nullptr), EGL_NO_SURFACE,
                    EGL_BAD_DISPLAY);
    EXPECT_EGL_FAIL(eglCreateContext(wrong, config, EGL_NO_CONTEXT, nullptr), EGL_NO_CONTEXT,
                    EGL_BAD_DISPLAY);
    void* const handle = random_handle();
    for (const EGLBoolean done :
         {eglGetConfigAttrib(wrong, handle, EGL_RED_SIZE, &value), eglDestroySurface(wrong, handle),
          eglQuerySurface(wrong, handle, EGL_WIDTH, &value),
          eglSurfaceAttrib(wrong, handle, EGL_MIPMAP_LEVEL, 0),
          eglBindTexImage(wrong, handle, EGL_BACK_BUFFER),
          eglReleaseTexImage(wrong, handle, EGL_BACK_BUFFER), eglCopyBuffers(wrong, handle, 0),
          eglSwapBuffers(wrong, handle), eglSwapInterval(wrong, 1),
          eglDestroyContext(wrong, handle), eglQueryContext(wrong, handle, EGL_CONFIG_ID, &value),
          eglDestroySync(wrong, handle), eglWaitSync(wrong, handle, 0)}) {
      EXPECT_FALSE(done);
    }
    EXPECT_EQ(eglGetError(), EGL_BAD_DISPLAY);
    for (const auto call : {eglDestroySurface, eglSwapBuffers, eglDestroyContext, eglDestroySync}) {
      EXPECT_EGL_FAIL(call(wrong, handle), EGL_FALSE, EGL_BAD_DISPLAY);
    }
    EXPECT_EGL_FAIL(eglCreateWindowSurface(wrong, handle, 0, nullptr), EGL_NO_SURFACE,
                    EGL_BAD_DISPLAY);
    EXPECT_EGL_FAIL(eglCreatePixmapSurface(wrong, handle, 0, nullptr), EGL_NO_SURFACE,
                    EGL_BAD_DISPLAY);
    EXPECT_EGL_FAIL(eglMakeCurrent(wrong, EGL_NO_SURFACE, EGL_NO_SURFACE, random_handle()),
                    EGL_FALSE, EGL_BAD_DISPLAY);
    EXPECT_EQ(value, 77);
  }
}

// 3.2: only eglInitialize, eglTerminate and a releasing eglMakeCurrent take such a display.
TEST(Display, UninitializedDisplays) {
  const EGLDisplay display = surfaceless_display();
  ASSERT_TRUE(eglTerminate(display));
  EGLint value = 77;
  EGLConfig config = nullptr;
  void* const handle = random_handle();
#define EXPECT_UNINITIALIZED(call, result) EXPECT_EGL_FAIL(call, result, EGL_NOT_INITIALIZED)
  EXPECT_UNINITIALIZED(eglQueryString(display, EGL_VENDOR), nullptr);
  EXPECT_UNINITIALIZED(eglQueryString(display, EGL_EXTENSIONS), nullptr);
  EXPECT_UNINITIALIZED(eglGetConfigs(display, &config, 1, &value), EGL_FALSE);
  EXPECT_UNINITIALIZED(eglChooseConfig(display, nullptr, &config, 1, &value), EGL_FALSE);
  EXPECT_UNINITIALIZED(eglGetConfigAttrib(display, handle, EGL_RED_SIZE, &value), EGL_FALSE);
  EXPECT_UNINITIALIZED(eglCreatePbufferSurface(display, handle, nullptr), EGL_NO_SURFACE);
  EXPECT_UNINITIALIZED(eglCreateWindowSurface(display, handle, 0, nullptr), EGL_NO_SURFACE);
  EXPECT_UNINITIALIZED(eglCreatePixmapSurface(display, handle, 0, nullptr), EGL_NO_SURFACE);
  EXPECT_UNINITIALIZED(eglCreatePlatformWindowSurface(display, handle, nullptr, nullptr),
                       EGL_NO_SURFACE);
  EXPECT_UNINITIALIZED(eglCreatePlatformPixmapSurface(display, handle, nullptr, nullptr),
                       EGL_NO_SURFACE);
  EXPECT_UNINITIALIZED(
      eglCreatePbufferFromClientBuffer(display, EGL_OPENVG_IMAGE, handle, handle, nullptr),
      EGL_NO_SURFACE);
  EXPECT_UNINITIALIZED(eglDestroySurface(display, handle), EGL_FALSE);
  EXPECT_UNINITIALIZED(eglQuerySurface(display, handle, EGL_WIDTH, &value), EGL_FALSE);
  EXPECT_UNINITIALIZED(eglSurfaceAttrib(display, handle, EGL_MIPMAP_LEVEL, 0), EGL_FALSE);
  EXPECT_UNINITIALIZED(eglBindTexImage(display, handle, EGL_BACK_BUFFER), EGL_FALSE);
  EXPECT_UNINITIALIZED(eglReleaseTexImage(display, handle, EGL_BACK_BUFFER), EGL_FALSE);
  EXPECT_UNINITIALIZED(eglSwapBuffers(display, handle), EGL_FALSE);
  EXPECT_UNINITIALIZED(eglCopyBuffers(display, handle, 0), EGL_FALSE);
  EXPECT_UNINITIALIZED(eglSwapInterval(display, 0), EGL_FALSE);
  EXPECT_UNINITIALIZED(eglCreateContext(display, handle, EGL_NO_CONTEXT, nullptr), EGL_NO_CONTEXT);
  EXPECT_UNINITIALIZED(eglDestroyContext(display, handle), EGL_FALSE);
  EXPECT_UNINITIALIZED(eglQueryContext(display, handle, EGL_CONFIG_ID, &value), EGL_FALSE);
  EXPECT_UNINITIALIZED(eglMakeCurrent(display, handle, handle, handle), EGL_FALSE);
  if (!through_libglvnd()) {  // which says EGL_BAD_MATCH
    EXPECT_UNINITIALIZED(eglMakeCurrent(display, handle, handle, EGL_NO_CONTEXT), EGL_FALSE);
  }
#undef EXPECT_UNINITIALIZED
  EXPECT_EGL_OK(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
  EXPECT_EQ(value, 77);
}

TEST_F(EglTest, QueryString) {
  EXPECT_STREQ(eglQueryString(display, EGL_CLIENT_APIS), "OpenGL_ES");
  EXPECT_STREQ(eglQueryString(display, EGL_VENDOR), "clearpipe");
  EXPECT_EQ(std::string(eglQueryString(display, EGL_VERSION)).substr(0, 4), "1.5 ");
  EXPECT_EGL_FAIL(eglQueryString(display, EGL_WIDTH), nullptr, EGL_BAD_PARAMETER);
  EXPECT_EGL_FAIL(eglQueryString(EGL_NO_DISPLAY, EGL_VENDOR), nullptr, EGL_BAD_DISPLAY);
  const std::string version = eglQueryString(EGL_NO_DISPLAY, EGL_VERSION);
  EXPECT_EQ(version.substr(0, 4), "1.5 ");
}

// 2.8, 3.3: no extension is both the client's and a display's.
TEST_F(EglTest, ClientAndDisplayExtensionsAreDisjoint) {
  const auto client = words(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS));
  const auto own = words(eglQueryString(display, EGL_EXTENSIONS));
  EXPECT_TRUE(client.count("EGL_EXT_client_extensions"));
  EXPECT_TRUE(client.count("EGL_EXT_platform_base"));
  EXPECT_TRUE(client.count("EGL_MESA_platform_surfaceless"));
  EXPECT_TRUE(own.count("EGL_KHR_surfaceless_context"));
  for (const std::string& name : own) {
    EXPECT_EQ(name.substr(0, 4), "EGL_");
    EXPECT_FALSE(client.count(name)) << name;
  }
}

TEST_F(EglTest, AnErrorIsToldOnceAndSuccessReplacesIt) {
  EXPECT_FALSE(eglDestroySurface(display, random_handle()));
  EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
  EXPECT_EQ(eglGetError(), EGL_SUCCESS);
  EXPECT_FALSE(eglDestroySurface(display, random_handle()));
  EXPECT_NE(eglQueryString(display, EGL_VENDOR), nullptr);
  EXPECT_EQ(eglGetError(), EGL_SUCCESS);
}

// 3.2: termination voids the handles for good, but what is current goes on living.
TEST_F(EglTest, TerminateWithCurrentContext) {
  const EGLSurface surface = pbuffer(8, 8), other = pbuffer(8, 8);
  const EGLContext ctx = context();
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, ctx));
  EXPECT_EGL_OK(eglTerminate(display));
  EXPECT_EQ(clear_and_read(1, 0, 0, 1), 0xff0000ffu);
  EXPECT_EQ(eglGetCurrentContext(), ctx);
  ASSERT_TRUE(eglInitialize(display, nullptr, nullptr));
  EXPECT_EGL_FAIL(eglDestroyContext(display, ctx), EGL_FALSE, EGL_BAD_CONTEXT);
  EXPECT_EGL_FAIL(eglDestroySurface(display, surface), EGL_FALSE, EGL_BAD_SURFACE);
  EXPECT_EGL_FAIL(eglDestroySurface(display, other), EGL_FALSE, EGL_BAD_SURFACE);
  const EGLSurface third = pbuffer(8, 8);
  EXPECT_EGL_FAIL(eglMakeCurrent(display, third, third, ctx), EGL_FALSE, EGL_BAD_CONTEXT);
  EXPECT_EGL_FAIL(eglWaitClient(), EGL_FALSE, EGL_BAD_CURRENT_SURFACE);
  EXPECT_EGL_OK(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
  EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
  // New objects of the display that was initialized again.
  const EGLSurface next_surface = pbuffer(8, 8);
  const EGLContext next = context();
  EXPECT_EGL_OK(eglMakeCurrent(display, next_surface, next_surface, next));
  EXPECT_EQ(clear_and_read(0, 1, 0, 1), 0xff00ff00u);
  EXPECT_EGL_FAIL(eglDestroyContext(display, ctx), EGL_FALSE, EGL_BAD_CONTEXT);
}

}  // namespace
}  // namespace clearpipe::icd
