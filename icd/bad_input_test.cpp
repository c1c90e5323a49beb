// What bad input gets: handles that were never ours, were destroyed, are another kind of object's
// or another display's; and memory that does not suffice. Every command that takes a handle, the
// error that EGL 1.5 names, and nothing changed. SPDX-License-Identifier: MIT
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <functional>
#include <random>

#include "icd/egl_test.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SANITIZED 1
#else
#define SANITIZED 0
#endif

namespace clearpipe::icd {
namespace {

struct Refusal {
  const char* command;
  std::function<bool(void*)> call;  // with the handle; whether it succeeds
};

class BadInputTest : public EglTest {
 protected:
  void SetUp() override {
    EglTest::SetUp();
    surface_ = pbuffer(4, 4);
    context_ = context();
    ASSERT_TRUE(eglMakeCurrent(display, surface_, surface_, context_));
    sync_ = eglCreateSync(display, EGL_SYNC_FENCE, nullptr);
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    texture_ = reinterpret_cast<EGLClientBuffer>(static_cast<uintptr_t>(texture));
    image_ = eglCreateImage(display, context_, EGL_GL_TEXTURE_2D, texture_, nullptr);
    ASSERT_NE(image_, EGL_NO_IMAGE);
    // Another display, with objects of its own.
    EGLDeviceEXT device = nullptr;
    EGLint count = 0;
    proc<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT")(1, &device, &count);
    other_ = eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
    ASSERT_TRUE(eglInitialize(other_, nullptr, nullptr));
    EGLint found = 0;
    ASSERT_TRUE(eglGetConfigs(other_, &other_config_, 1, &found));
    const EGLint size[] = {EGL_WIDTH, 4, EGL_HEIGHT, 4, EGL_NONE};
    other_surface_ = eglCreatePbufferSurface(other_, other_config_, size);
    other_context_ = eglCreateContext(other_, other_config_, EGL_NO_CONTEXT, nullptr);
    const EGLint reusable[] = {EGL_NONE};
    other_sync_ =
        proc<PFNEGLCREATESYNCKHRPROC>("eglCreateSyncKHR")(other_, EGL_SYNC_REUSABLE_KHR, reusable);
    ASSERT_NE(other_sync_, EGL_NO_SYNC);
    // One that is gone.
    const EGLSurface gone = pbuffer(4, 4);
    ASSERT_TRUE(eglDestroySurface(display, gone));
    destroyed_ = gone;
  }
  void TearDown() override {
    eglReleaseThread();
    eglTerminate(other_);
    EglTest::TearDown();
  }
  // Handles that name no object but, if so, one of a kind that is not wanted.
  std::vector<void*> strangers(const void* wanted) const {
    std::vector<void*> handles = {random_handle(),
                                  random_handle(),
                                  destroyed_,
                                  display,
                                  &texture_words_,
                                  reinterpret_cast<void*>(~uintptr_t{0}),
                                  static_cast<char*>(config) + 1};
    for (void* object : {surface_, context_, sync_, image_, config}) {
      if (object != wanted) handles.push_back(object);
    }
    return handles;
  }
  void expect_refused(const std::vector<Refusal>& refusals, const void* wanted, void* others,
                      EGLint error) {
    std::vector<void*> handles = strangers(wanted);
    handles.push_back(others);
    for (const Refusal& refusal : refusals) {
      for (void* handle : handles) {
        EXPECT_FALSE(refusal.call(handle)) << refusal.command << " of " << handle;
        EXPECT_EQ(eglGetError(), error) << refusal.command << " of " << handle;
      }
    }
    // Nothing has changed.
    EXPECT_EQ(eglGetCurrentContext(), context_);
    EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), surface_);
    EXPECT_EQ(query(surface_, EGL_WIDTH), 4);
    EXPECT_EQ(clear_and_read(1, 0, 1, 1), 0xffff00ffu);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  }

  EGLSurface surface_ = EGL_NO_SURFACE, other_surface_ = EGL_NO_SURFACE;
  EGLContext context_ = EGL_NO_CONTEXT, other_context_ = EGL_NO_CONTEXT;
  EGLSync sync_ = EGL_NO_SYNC, other_sync_ = EGL_NO_SYNC;
  EGLImage image_ = EGL_NO_IMAGE;
  EGLClientBuffer texture_ = nullptr;
  EGLDisplay other_ = EGL_NO_DISPLAY;
  EGLConfig other_config_ = nullptr;
  void* destroyed_ = nullptr;
  mutable std::array<uintptr_t, 4> texture_words_ = {};
};

TEST_F(BadInputTest, Surfaces) {
  EGLint value = 0;
  const std::vector<Refusal> refusals = {
      {"eglQuerySurface",
       [&](void* s) { return eglQuerySurface(display, s, EGL_WIDTH, &value) == EGL_TRUE; }},
      {"eglSurfaceAttrib",
       [&](void* s) { return eglSurfaceAttrib(display, s, EGL_MIPMAP_LEVEL, 0) == EGL_TRUE; }},
      {"eglBindTexImage",
       [&](void* s) { return eglBindTexImage(display, s, EGL_BACK_BUFFER) == EGL_TRUE; }},
      {"eglReleaseTexImage",
       [&](void* s) { return eglReleaseTexImage(display, s, EGL_BACK_BUFFER) == EGL_TRUE; }},
      {"eglSwapBuffers", [&](void* s) { return eglSwapBuffers(display, s) == EGL_TRUE; }},
      {"eglCopyBuffers", [&](void* s) { return eglCopyBuffers(display, s, 0) == EGL_TRUE; }},
      {"eglDestroySurface", [&](void* s) { return eglDestroySurface(display, s) == EGL_TRUE; }},
      {"eglMakeCurrent, to draw",
       [&](void* s) { return eglMakeCurrent(display, s, surface_, context_) == EGL_TRUE; }},
      {"eglMakeCurrent, to read",
       [&](void* s) { return eglMakeCurrent(display, surface_, s, context_) == EGL_TRUE; }},
  };
  expect_refused(refusals, surface_, other_surface_, EGL_BAD_SURFACE);
}

TEST_F(BadInputTest, Contexts) {
  EGLint value = 0;
  const std::vector<Refusal> refusals = {
      {"eglQueryContext",
       [&](void* c) { return eglQueryContext(display, c, EGL_CONFIG_ID, &value) == EGL_TRUE; }},
      {"eglDestroyContext", [&](void* c) { return eglDestroyContext(display, c) == EGL_TRUE; }},
      {"eglMakeCurrent",
       [&](void* c) { return eglMakeCurrent(display, surface_, surface_, c) == EGL_TRUE; }},
  };
  expect_refused(refusals, context_, other_context_, EGL_BAD_CONTEXT);
  const std::vector<Refusal> sharing = {
      {"eglCreateContext", [&](void* c) { return context(c) != EGL_NO_CONTEXT; }},
  };
  expect_refused(sharing, context_, random_handle(), EGL_BAD_CONTEXT);
  // That of another display is one, but does not match (3.7.1).
  EXPECT_EGL_FAIL(context(other_context_), EGL_NO_CONTEXT, EGL_BAD_MATCH);
  EXPECT_EGL_FAIL(eglCreateImage(display, random_handle(), EGL_GL_TEXTURE_2D, texture_, nullptr),
                  EGL_NO_IMAGE, EGL_BAD_CONTEXT);
}

TEST_F(BadInputTest, Configs) {
  EGLint value = 0;
  const EGLint size[] = {EGL_WIDTH, 4, EGL_HEIGHT, 4, EGL_NONE};
  const std::vector<Refusal> refusals = {
      {"eglGetConfigAttrib",
       [&](void* c) { return eglGetConfigAttrib(display, c, EGL_RED_SIZE, &value) == EGL_TRUE; }},
      {"eglCreatePbufferSurface",
       [&](void* c) { return eglCreatePbufferSurface(display, c, size) != EGL_NO_SURFACE; }},
      {"eglCreateContext",
       [&](void* c) {
         return eglCreateContext(display, c, EGL_NO_CONTEXT, nullptr) != EGL_NO_CONTEXT;
       }},
  };
  expect_refused(refusals, config, other_config_, EGL_BAD_CONFIG);
}

TEST_F(BadInputTest, SyncsAndImages) {
  EGLAttrib value = 0;
  const std::vector<Refusal> syncs = {
      {"eglDestroySync", [&](void* s) { return eglDestroySync(display, s) == EGL_TRUE; }},
      {"eglClientWaitSync",
       [&](void* s) { return eglClientWaitSync(display, s, 0, 0) != EGL_FALSE; }},
      {"eglWaitSync", [&](void* s) { return eglWaitSync(display, s, 0) == EGL_TRUE; }},
      {"eglGetSyncAttrib",
       [&](void* s) { return eglGetSyncAttrib(display, s, EGL_SYNC_TYPE, &value) == EGL_TRUE; }},
      {"eglSignalSyncKHR",
       [&](void* s) {
         return proc<PFNEGLSIGNALSYNCKHRPROC>("eglSignalSyncKHR")(display, s, EGL_SIGNALED_KHR) ==
                EGL_TRUE;
       }},
      {"eglDestroyImage", [&](void* i) { return eglDestroyImage(display, i) == EGL_TRUE; }},
  };
  std::vector<Refusal> images = {syncs.back()};
  expect_refused({syncs.begin(), syncs.end() - 1}, sync_, other_sync_, EGL_BAD_PARAMETER);
  expect_refused(images, image_, other_sync_, EGL_BAD_PARAMETER);
}

// Calls in no order with handles and numbers that are right, wrong or of another kind: nothing but
// errors, and afterwards everything works.
TEST_F(BadInputTest, RandomCalls) {
  std::mt19937 random(20);
  const auto below = [&](uint32_t bound) { return static_cast<uint32_t>(random()) % bound; };
  std::vector<void*> handles = {nullptr, surface_, context_, sync_, image_, config, display};
  const EGLint names[] = {
      EGL_WIDTH,     EGL_HEIGHT,        EGL_CONFIG_ID,        EGL_MIPMAP_LEVEL,
      EGL_NONE,      EGL_BACK_BUFFER,   EGL_SINGLE_BUFFER,    EGL_TEXTURE_FORMAT,
      EGL_SYNC_TYPE, EGL_SWAP_BEHAVIOR, EGL_BUFFER_PRESERVED, -1};
  const auto handle = [&]() -> void* {
    return below(8) == 0 ? random_handle() : handles[below(static_cast<uint32_t>(handles.size()))];
  };
  const auto name = [&] { return names[below(std::size(names))]; };
  const auto dpy = [&] { return below(10) == 0 ? other_ : display; };
  int made = 0, errors = 0;
  for (int i = 0; i < 20000; ++i) {
    EGLint integer = 0;
    EGLAttrib attribute = 0;
    const EGLint list[] = {below(2) ? EGL_WIDTH : name(), static_cast<EGLint>(below(9)), EGL_NONE};
    const EGLAttrib level[] = {EGL_GL_TEXTURE_LEVEL, static_cast<EGLAttrib>(below(2)), EGL_NONE};
    void* object = nullptr;
    bool good = true;
    switch (below(16)) {
      case 0:
        good = (object = eglCreatePbufferSurface(dpy(), handle(), list)) != nullptr;
        break;
      case 1:
        good = (object = eglCreateContext(dpy(), handle(), handle(), nullptr)) != nullptr;
        break;
      case 2:
        good = (object = eglCreateSync(dpy(), EGL_SYNC_FENCE, nullptr)) != nullptr;
        break;
      case 3:
        good = (object = eglCreateImage(dpy(), handle(), EGL_GL_TEXTURE_2D, texture_, level)) !=
               nullptr;
        break;
      case 4:
        good = eglDestroySurface(dpy(), handle());
        break;
      case 5:
        good = eglDestroyContext(dpy(), handle());
        break;
      case 6:
        good = eglDestroySync(dpy(), handle());
        break;
      case 7:
        good = eglDestroyImage(dpy(), handle());
        break;
      case 8:
        good = eglMakeCurrent(dpy(), handle(), handle(), handle());
        break;
      case 9:
        good = eglQuerySurface(dpy(), handle(), name(), &integer);
        break;
      case 10:
        good = eglSurfaceAttrib(dpy(), handle(), name(), name());
        break;
      case 11:
        good = eglBindTexImage(dpy(), handle(), name());
        break;
      case 12:
        good = eglReleaseTexImage(dpy(), handle(), name());
        break;
      case 13:
        good = eglSwapBuffers(dpy(), handle());
        break;
      case 14:
        good = eglGetSyncAttrib(dpy(), handle(), name(), &attribute);
        break;
      default:
        glClear(GL_COLOR_BUFFER_BIT);
        glFlush();
    }
    const bool told = eglGetError() != EGL_SUCCESS;
    ASSERT_EQ(told, !good) << "call " << i;
    errors += told;
    made += object != nullptr;
    if (object != nullptr) {
      if (handles.size() < 40) {
        handles.push_back(object);
      } else {
        handles[7 + below(33)] = object;
      }
    }
  }
  EXPECT_GT(made, 100);
  EXPECT_GT(errors, 1000);
  const EGLSurface surface = pbuffer(4, 4);
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, context()));
  EXPECT_EQ(clear_and_read(1, 0, 0, 1), 0xff0000ffu);
}

// A surface that is larger than the memory there is: EGL_BAD_ALLOC, or a smaller one where that is
// asked for. In a process of its own, whose memory is bounded.
TEST_F(BadInputTest, MemoryRunsOut) {
  if (SANITIZED) GTEST_SKIP() << "a sanitizer ends the program when memory runs out";
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    long pages = 0;
    if (FILE* status = std::fopen("/proc/self/statm", "r")) {
      if (std::fscanf(status, "%ld", &pages) != 1) pages = 0;
      std::fclose(status);
    }
    const auto limit = static_cast<rlim_t>(pages) * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) +
                       (rlim_t{256} << 20);
    const rlimit bound = {limit, limit};
    if (pages == 0 || setrlimit(RLIMIT_AS, &bound) != 0) _exit(10);
    for (int i = 0; i < 3; ++i) {
      if (pbuffer(16384, 16384) != EGL_NO_SURFACE) _exit(11);
      if (eglGetError() != EGL_BAD_ALLOC) _exit(12);
    }
    const EGLint largest[] = {EGL_WIDTH,           16384,    EGL_HEIGHT, 8192,
                              EGL_LARGEST_PBUFFER, EGL_TRUE, EGL_NONE};
    const EGLSurface surface = eglCreatePbufferSurface(display, config, largest);
    EGLint width = 0, height = 0;
    if (!eglQuerySurface(display, surface, EGL_WIDTH, &width) ||
        !eglQuerySurface(display, surface, EGL_HEIGHT, &height)) {
      _exit(13);
    }
    // 256 MB hold some ten million pixels with their depth.
    if (width >= 16384 || width != 2 * height || width < 1024) _exit(14);
    const EGLSurface small = pbuffer(4, 4);
    if (small == EGL_NO_SURFACE || !eglDestroySurface(display, surface)) _exit(15);
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status)) << status;
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace
}  // namespace clearpipe::icd
