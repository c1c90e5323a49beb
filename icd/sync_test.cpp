// Sync objects (3.8.1), EGL_KHR_fence_sync, EGL_KHR_reusable_sync and EGL_KHR_wait_sync.
// SPDX-License-Identifier: MIT
#include <atomic>
#include <chrono>
#include <thread>

#include "icd/egl_test.h"

namespace clearpipe::icd {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr EGLTime kMillisecond = 1000000;

class SyncTest : public EglTest {
 protected:
  void make_current() {
    const EGLSurface surface = pbuffer(16, 16);
    ASSERT_TRUE(eglMakeCurrent(display, surface, surface, context()));
  }
  EGLSync reusable() { return create_khr(display, EGL_SYNC_REUSABLE_KHR, nullptr); }
  EGLAttrib attrib(EGLSync sync, EGLint attribute) {
    EGLAttrib value = -12345;
    EXPECT_EGL_OK(eglGetSyncAttrib(display, sync, attribute, &value));
    return value;
  }
  // Runs `release` once the other thread, which begins to wait for `sync`, is likely to sleep.
  template <class Release>
  EGLint wait_result(EGLSync sync, Release release) {
    std::atomic<bool> started{false};
    EGLint result = 0;
    std::thread waiter([&] {
      started = true;
      result = eglClientWaitSync(display, sync, 0, 20000 * kMillisecond);
    });
    while (!started) std::this_thread::yield();
    std::this_thread::sleep_for(milliseconds(100));
    release();
    waiter.join();
    return result;
  }

  PFNEGLCREATESYNCKHRPROC create_khr = proc<PFNEGLCREATESYNCKHRPROC>("eglCreateSyncKHR");
  PFNEGLDESTROYSYNCKHRPROC destroy_khr = proc<PFNEGLDESTROYSYNCKHRPROC>("eglDestroySyncKHR");
  PFNEGLCLIENTWAITSYNCKHRPROC client_wait_khr =
      proc<PFNEGLCLIENTWAITSYNCKHRPROC>("eglClientWaitSyncKHR");
  PFNEGLSIGNALSYNCKHRPROC signal_khr = proc<PFNEGLSIGNALSYNCKHRPROC>("eglSignalSyncKHR");
  PFNEGLGETSYNCATTRIBKHRPROC get_attrib_khr =
      proc<PFNEGLGETSYNCATTRIBKHRPROC>("eglGetSyncAttribKHR");
  PFNEGLWAITSYNCKHRPROC wait_khr = proc<PFNEGLWAITSYNCKHRPROC>("eglWaitSyncKHR");
};

TEST_F(SyncTest, Extensions) {
  const auto own = words(eglQueryString(display, EGL_EXTENSIONS));
  for (const char* name : {"EGL_KHR_fence_sync", "EGL_KHR_reusable_sync", "EGL_KHR_wait_sync"}) {
    EXPECT_TRUE(own.count(name)) << name;
  }
}

TEST_F(SyncTest, CreateErrors) {
  const EGLAttrib list[] = {EGL_SYNC_STATUS, EGL_SIGNALED, EGL_NONE};
  const EGLint list_khr[] = {EGL_SYNC_STATUS, EGL_SIGNALED, EGL_NONE};
  EXPECT_EGL_FAIL(eglCreateSync(random_handle(), EGL_SYNC_FENCE, nullptr), EGL_NO_SYNC,
                  EGL_BAD_DISPLAY);
  EXPECT_EGL_FAIL(eglCreateSync(display, EGL_SYNC_FENCE, nullptr), EGL_NO_SYNC, EGL_BAD_MATCH);
  make_current();
  EXPECT_EGL_FAIL(eglCreateSync(display, EGL_SYNC_FENCE, list), EGL_NO_SYNC, EGL_BAD_ATTRIBUTE);
  EXPECT_EGL_FAIL(eglCreateSync(display, EGL_SYNC_CL_EVENT, nullptr), EGL_NO_SYNC,
                  EGL_BAD_PARAMETER);
  EXPECT_EGL_FAIL(eglCreateSync(display, EGL_NONE, nullptr), EGL_NO_SYNC, EGL_BAD_PARAMETER);
  EXPECT_EGL_FAIL(create_khr(random_handle(), EGL_SYNC_FENCE_KHR, nullptr), EGL_NO_SYNC,
                  EGL_BAD_DISPLAY);
  EXPECT_EGL_FAIL(create_khr(display, EGL_SYNC_REUSABLE_KHR, list_khr), EGL_NO_SYNC,
                  EGL_BAD_ATTRIBUTE);
  EXPECT_EGL_FAIL(create_khr(display, EGL_NONE, nullptr), EGL_NO_SYNC, EGL_BAD_ATTRIBUTE);
}

TEST_F(SyncTest, HandleErrors) {
  make_current();
  EGLAttrib value = 77;
  EGLint value_khr = 77;
  const EGLSync gone = eglCreateSync(display, EGL_SYNC_FENCE, nullptr);
  ASSERT_NE(gone, EGL_NO_SYNC);
  EXPECT_EGL_OK(eglDestroySync(display, gone));
  for (const EGLSync wrong : {EGL_NO_SYNC, gone, static_cast<EGLSync>(random_handle()),
                              static_cast<EGLSync>(eglGetCurrentContext())}) {
    EXPECT_EGL_FAIL(eglDestroySync(display, wrong), EGL_FALSE, EGL_BAD_PARAMETER);
    EXPECT_EGL_FAIL(destroy_khr(display, wrong), EGL_FALSE, EGL_BAD_PARAMETER);
    EXPECT_EGL_FAIL(eglClientWaitSync(display, wrong, 0, 0), EGL_FALSE, EGL_BAD_PARAMETER);
    EXPECT_EGL_FAIL(client_wait_khr(display, wrong, 0, 0), EGL_FALSE, EGL_BAD_PARAMETER);
    EXPECT_EGL_FAIL(eglWaitSync(display, wrong, 0), EGL_FALSE, EGL_BAD_PARAMETER);
    EXPECT_EGL_FAIL(wait_khr(display, wrong, 0), EGL_FALSE, EGL_BAD_PARAMETER);
    EXPECT_EGL_FAIL(signal_khr(display, wrong, EGL_SIGNALED), EGL_FALSE, EGL_BAD_PARAMETER);
    EXPECT_EGL_FAIL(eglGetSyncAttrib(display, wrong, EGL_SYNC_TYPE, &value), EGL_FALSE,
                    EGL_BAD_PARAMETER);
    EXPECT_EGL_FAIL(get_attrib_khr(display, wrong, EGL_SYNC_TYPE, &value_khr), EGL_FALSE,
                    EGL_BAD_PARAMETER);
  }
  const EGLSync sync = reusable();
  EXPECT_EGL_FAIL(eglGetSyncAttrib(random_handle(), sync, EGL_SYNC_TYPE, &value), EGL_FALSE,
                  EGL_BAD_DISPLAY);
  EXPECT_EGL_FAIL(eglGetSyncAttrib(display, sync, EGL_WIDTH, &value), EGL_FALSE, EGL_BAD_ATTRIBUTE);
  EXPECT_EGL_FAIL(eglGetSyncAttrib(display, sync, EGL_SYNC_CONDITION, &value), EGL_FALSE,
                  EGL_BAD_MATCH);
  EXPECT_EGL_FAIL(eglGetSyncAttrib(display, sync, EGL_SYNC_TYPE, nullptr), EGL_FALSE,
                  EGL_BAD_PARAMETER);
  EXPECT_EGL_FAIL(eglClientWaitSync(random_handle(), sync, 0, 0), EGL_FALSE, EGL_BAD_DISPLAY);
  EXPECT_EGL_FAIL(client_wait_khr(random_handle(), sync, 0, 0), EGL_FALSE, EGL_BAD_DISPLAY);
  EXPECT_EGL_FAIL(signal_khr(display, sync, EGL_NONE), EGL_FALSE, EGL_BAD_PARAMETER);
  EXPECT_EGL_FAIL(eglWaitSync(display, sync, 1), EGL_FALSE, EGL_BAD_PARAMETER);
  EXPECT_EQ(value, 77);
  EXPECT_EQ(value_khr, 77);
}

// A fence is done when the commands before it are: the surface then holds their pixels.
TEST_F(SyncTest, Fence) {
  make_current();
  glClearColor(0, 1, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  const EGLSync fence = eglCreateSync(display, EGL_SYNC_FENCE, nullptr);
  ASSERT_NE(fence, EGL_NO_SYNC);
  EXPECT_EQ(attrib(fence, EGL_SYNC_TYPE), EGL_SYNC_FENCE);
  EXPECT_EQ(attrib(fence, EGL_SYNC_CONDITION), EGL_SYNC_PRIOR_COMMANDS_COMPLETE);
  for (const EGLint flags : {0, EGL_SYNC_FLUSH_COMMANDS_BIT}) {
    EXPECT_EQ(eglClientWaitSync(display, fence, flags, EGL_FOREVER), EGL_CONDITION_SATISFIED);
    EXPECT_EQ(client_wait_khr(display, fence, flags, 0), EGL_CONDITION_SATISFIED);
  }
  EXPECT_EQ(attrib(fence, EGL_SYNC_STATUS), EGL_SIGNALED);
  EXPECT_EGL_OK(eglWaitSync(display, fence, 0));
  EXPECT_EGL_OK(wait_khr(display, fence, 0));
  EXPECT_EGL_FAIL(signal_khr(display, fence, EGL_UNSIGNALED), EGL_FALSE, EGL_BAD_MATCH);
  EXPECT_EGL_OK(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
  EXPECT_EGL_FAIL(eglWaitSync(display, fence, 0), EGL_FALSE, EGL_BAD_MATCH);
  EXPECT_EQ(eglClientWaitSync(display, fence, 0, 0), EGL_CONDITION_SATISFIED);
  EXPECT_EGL_OK(destroy_khr(display, fence));
}

// The work is done by the time the fence is signaled: nothing of it is left for glReadPixels. A
// frame of blended layers takes long enough to tell, and a busy machine gets three tries.
TEST_F(SyncTest, FenceMeansThatTheWorkIsDone) {
  const EGLSurface surface = pbuffer(1024, 1024);
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, context()));
  const GLfloat corners[] = {-1, -1, 1, -1, -1, 1, 1, 1};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, corners);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glColor4ub(1, 0, 0, 0);
  bool told = false;
  for (int round = 0; round < 3 && !told; ++round) {
    glClear(GL_COLOR_BUFFER_BIT);
    for (int layer = 0; layer < 100; ++layer) glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    const auto start = Clock::now();
    const EGLSync fence = eglCreateSync(display, EGL_SYNC_FENCE, nullptr);
    ASSERT_EQ(eglClientWaitSync(display, fence, 0, EGL_FOREVER), EGL_CONDITION_SATISFIED);
    const auto signaled = Clock::now();
    uint32_t pixel = 0;
    glReadPixels(512, 512, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
    EXPECT_EQ(pixel, 100u);
    told = (Clock::now() - signaled) * 2 < signaled - start;
    EXPECT_EGL_OK(eglDestroySync(display, fence));
  }
  EXPECT_TRUE(told);
}

// Waiting without a flush, while the context stays current to the thread that made the fence.
TEST_F(SyncTest, FenceOfAContextThatIsCurrentElsewhere) {
  std::atomic<EGLSync> fence{EGL_NO_SYNC};
  std::atomic<bool> done{false};
  std::thread drawer([&] {
    make_current();
    glClear(GL_COLOR_BUFFER_BIT);
    fence = create_khr(display, EGL_SYNC_FENCE_KHR, nullptr);
    while (!done) std::this_thread::yield();
    eglReleaseThread();
  });
  while (fence == EGL_NO_SYNC) std::this_thread::yield();
  EXPECT_EQ(eglClientWaitSync(display, fence, 0, 10000 * kMillisecond), EGL_CONDITION_SATISFIED);
  done = true;
  drawer.join();
}

TEST_F(SyncTest, ReusableStatus) {
  const EGLSync sync = reusable();
  ASSERT_NE(sync, EGL_NO_SYNC);
  EXPECT_EQ(attrib(sync, EGL_SYNC_TYPE), EGL_SYNC_REUSABLE_KHR);
  EXPECT_EQ(attrib(sync, EGL_SYNC_STATUS), EGL_UNSIGNALED);
  EGLint value = 0;
  EXPECT_EGL_OK(get_attrib_khr(display, sync, EGL_SYNC_STATUS_KHR, &value));
  EXPECT_EQ(value, EGL_UNSIGNALED_KHR);
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(eglClientWaitSync(display, sync, 0, 0), EGL_TIMEOUT_EXPIRED);
    EXPECT_EGL_OK(signal_khr(display, sync, EGL_SIGNALED));
    EXPECT_EGL_OK(signal_khr(display, sync, EGL_SIGNALED));
    EXPECT_EQ(attrib(sync, EGL_SYNC_STATUS), EGL_SIGNALED);
    EXPECT_EQ(eglClientWaitSync(display, sync, 0, EGL_FOREVER), EGL_CONDITION_SATISFIED);
    EXPECT_EGL_OK(signal_khr(display, sync, EGL_UNSIGNALED));
    EXPECT_EQ(attrib(sync, EGL_SYNC_STATUS), EGL_UNSIGNALED);
  }
  // Commands cannot be made to wait for what is not signaled.
  make_current();
  EXPECT_EGL_FAIL(eglWaitSync(display, sync, 0), EGL_FALSE, EGL_BAD_MATCH);
  EXPECT_EGL_OK(signal_khr(display, sync, EGL_SIGNALED));
  EXPECT_EGL_OK(eglWaitSync(display, sync, 0));
}

TEST_F(SyncTest, Timeout) {
  const EGLSync sync = reusable();
  const auto start = Clock::now();
  EXPECT_EQ(client_wait_khr(display, sync, EGL_SYNC_FLUSH_COMMANDS_BIT, 30 * kMillisecond),
            EGL_TIMEOUT_EXPIRED);
  EXPECT_GE(Clock::now() - start, milliseconds(30));
  EXPECT_EQ(eglClientWaitSync(display, sync, 0, 1), EGL_TIMEOUT_EXPIRED);
}

TEST_F(SyncTest, SignaledByAnotherThread) {
  const EGLSync sync = reusable();
  EXPECT_EQ(wait_result(sync, [&] { EXPECT_TRUE(signal_khr(display, sync, EGL_SIGNALED)); }),
            EGL_CONDITION_SATISFIED);
  // A timeout that the clock cannot hold is still a wait.
  EXPECT_TRUE(signal_khr(display, sync, EGL_UNSIGNALED));
  std::thread signaller([&] {
    std::this_thread::sleep_for(milliseconds(20));
    EXPECT_TRUE(signal_khr(display, sync, EGL_SIGNALED));
  });
  EXPECT_EQ(eglClientWaitSync(display, sync, 0, EGL_FOREVER - 1), EGL_CONDITION_SATISFIED);
  signaller.join();
}

// Every transition to signaled releases those who wait, however short it is.
TEST_F(SyncTest, SignaledAndUnsignaledAtOnce) {
  const EGLSync sync = reusable();
  EXPECT_EQ(wait_result(sync,
                        [&] {
                          EXPECT_TRUE(signal_khr(display, sync, EGL_SIGNALED));
                          EXPECT_TRUE(signal_khr(display, sync, EGL_UNSIGNALED));
                        }),
            EGL_CONDITION_SATISFIED);
}

TEST_F(SyncTest, DestroyedWhileWaitedFor) {
  const EGLSync sync = reusable();
  EXPECT_EQ(wait_result(sync, [&] { EXPECT_TRUE(eglDestroySync(display, sync)); }),
            EGL_CONDITION_SATISFIED);
  EXPECT_EGL_FAIL(eglClientWaitSync(display, sync, 0, 0), EGL_FALSE, EGL_BAD_PARAMETER);
}

TEST_F(SyncTest, TerminatedWhileWaitedFor) {
  const EGLSync sync = reusable();
  EXPECT_EQ(wait_result(sync, [&] { EXPECT_TRUE(eglTerminate(display)); }),
            EGL_CONDITION_SATISFIED);
  ASSERT_TRUE(eglInitialize(display, nullptr, nullptr));
  EXPECT_EGL_FAIL(eglClientWaitSync(display, sync, 0, 0), EGL_FALSE, EGL_BAD_PARAMETER);
}

TEST_F(SyncTest, ManyWaitersAreAllReleased) {
  const EGLSync sync = reusable();
  std::atomic<int> waiting{0}, released{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([&] {
      ++waiting;
      if (eglClientWaitSync(display, sync, 0, EGL_FOREVER) == EGL_CONDITION_SATISFIED) ++released;
    });
  }
  while (waiting < 8) std::this_thread::yield();
  std::this_thread::sleep_for(milliseconds(20));
  EXPECT_EQ(released, 0);
  EXPECT_TRUE(signal_khr(display, sync, EGL_SIGNALED));
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(released, 8);
}

TEST_F(SyncTest, Uninitialized) {
  const EGLSync sync = reusable();
  ASSERT_TRUE(eglTerminate(display));
  EGLAttrib value = 0;
  EXPECT_EGL_FAIL(eglCreateSync(display, EGL_SYNC_FENCE, nullptr), EGL_NO_SYNC,
                  EGL_NOT_INITIALIZED);
  EXPECT_EGL_FAIL(eglDestroySync(display, sync), EGL_FALSE, EGL_NOT_INITIALIZED);
  EXPECT_EGL_FAIL(eglClientWaitSync(display, sync, 0, 0), EGL_FALSE, EGL_NOT_INITIALIZED);
  EXPECT_EGL_FAIL(eglWaitSync(display, sync, 0), EGL_FALSE, EGL_NOT_INITIALIZED);
  EXPECT_EGL_FAIL(eglGetSyncAttrib(display, sync, EGL_SYNC_TYPE, &value), EGL_FALSE,
                  EGL_NOT_INITIALIZED);
  EXPECT_EGL_FAIL(signal_khr(display, sync, EGL_SIGNALED), EGL_FALSE, EGL_NOT_INITIALIZED);
}

}  // namespace
}  // namespace clearpipe::icd
