// EGL from several threads: whose is what is current (3.7.3), and state of a thread (3.1, 3.12).
// SPDX-License-Identifier: MIT
#include <thread>

#include "icd/egl_test.h"

namespace clearpipe::icd {
namespace {

class ThreadTest : public EglTest {
 protected:
  template <class Body>
  void in_another_thread(Body body) {
    std::thread(body).join();
  }
};

TEST_F(ThreadTest, ErrorsBelongToTheThread) {
  EXPECT_FALSE(eglDestroySurface(display, random_handle()));
  in_another_thread([&] {
    EXPECT_EQ(eglGetError(), EGL_SUCCESS);
    EXPECT_FALSE(eglDestroyContext(display, random_handle()));
    EXPECT_EQ(eglGetError(), EGL_BAD_CONTEXT);
  });
  EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
}

TEST_F(ThreadTest, CurrentInOneThreadRefusedInAnother) {
  const EGLSurface surface = pbuffer(4, 4), other_surface = pbuffer(4, 4), read = pbuffer(4, 4);
  const EGLContext ctx = context(), other = context();
  ASSERT_TRUE(eglMakeCurrent(display, surface, read, ctx));
  in_another_thread([&] {
    EXPECT_EGL_FAIL(eglMakeCurrent(display, other_surface, other_surface, ctx), EGL_FALSE,
                    EGL_BAD_ACCESS);
    EXPECT_EGL_FAIL(eglMakeCurrent(display, surface, surface, other), EGL_FALSE, EGL_BAD_ACCESS);
    EXPECT_EGL_FAIL(eglMakeCurrent(display, other_surface, read, other), EGL_FALSE, EGL_BAD_ACCESS);
    EXPECT_EGL_FAIL(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, ctx), EGL_FALSE,
                    EGL_BAD_ACCESS);
    EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
    EXPECT_EGL_OK(eglMakeCurrent(display, other_surface, other_surface, other));
    EXPECT_EQ(clear_and_read(0, 0, 1, 1), 0xffff0000u);
    EXPECT_EGL_OK(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
  });
  EXPECT_EQ(eglGetCurrentContext(), ctx);
  // Released here, they may be bound there.
  ASSERT_TRUE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
  in_another_thread([&] {
    EXPECT_EGL_OK(eglMakeCurrent(display, surface, surface, ctx));
    EXPECT_EGL_OK(eglReleaseThread());
  });
}

// Destroyed in one thread, a context and its surface serve on in the thread where they are current.
TEST_F(ThreadTest, DestroyedInAnotherThread) {
  const EGLSurface surface = pbuffer(4, 4);
  const EGLContext ctx = context();
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, ctx));
  in_another_thread([&] {
    EXPECT_EGL_OK(eglDestroySurface(display, surface));
    EXPECT_EGL_OK(eglDestroyContext(display, ctx));
    EXPECT_EGL_OK(eglTerminate(display));
  });
  EXPECT_EQ(clear_and_read(1, 0, 0, 1, 3, 3), 0xff0000ffu);
}

// A thread that ends gives back what it had bound.
TEST_F(ThreadTest, AThreadThatEndsReleases) {
  const EGLSurface surface = pbuffer(4, 4);
  const EGLContext ctx = context();
  in_another_thread([&] {
    EXPECT_EGL_OK(eglMakeCurrent(display, surface, surface, ctx));
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
  });
  EXPECT_EGL_OK(eglMakeCurrent(display, surface, surface, ctx));
  uint32_t pixel = 0;
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
  EXPECT_EQ(pixel, 0xff00ff00u);
}

TEST_F(ThreadTest, ReleaseThread) {
  EXPECT_EGL_OK(eglReleaseThread());
  const EGLSurface surface = pbuffer(4, 4);
  const EGLContext ctx = context();
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, ctx));
  EXPECT_EGL_OK(eglReleaseThread());
  EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
  EXPECT_EQ(eglGetCurrentDisplay(), EGL_NO_DISPLAY);
  EXPECT_FALSE(eglDestroySurface(display, random_handle()));
  EXPECT_TRUE(eglReleaseThread());
  EXPECT_EQ(eglGetError(), EGL_SUCCESS);
  // Surfaces and contexts belong to EGL, not to the thread.
  EXPECT_EGL_OK(eglMakeCurrent(display, surface, surface, ctx));
  in_another_thread([&] { EXPECT_EGL_OK(eglReleaseThread()); });
  EXPECT_EQ(eglGetCurrentContext(), ctx);
}

// Every thread draws triangles of its own colour into its own pbuffer, over and over; half of them
// share objects. Each must read back its own colour.
TEST_F(ThreadTest, ManyThreadsDraw) {
  constexpr int kThreads = 12, kFrames = 20, kSize = 96;
  std::vector<EGLContext> contexts;
  for (int i = 0; i < kThreads; ++i) {
    contexts.push_back(context(i % 2 == 1 ? contexts[0] : EGL_NO_CONTEXT));
  }
  std::vector<int> right(kThreads, 0);
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i) {
    threads.emplace_back([this, i, &contexts, &right] {
      const EGLSurface surface = pbuffer(kSize, kSize);
      if (!eglMakeCurrent(display, surface, surface, contexts[static_cast<size_t>(i)])) return;
      const GLfloat corners[] = {-1, -1, 1, -1, -1, 1, 1, 1};
      glEnableClientState(GL_VERTEX_ARRAY);
      glVertexPointer(2, GL_FLOAT, 0, corners);
      std::vector<uint32_t> pixels(kSize * kSize);
      for (int frame = 0; frame < kFrames; ++frame) {
        const auto red = static_cast<GLubyte>(i * 20 + frame % 20);
        glClear(GL_COLOR_BUFFER_BIT);
        glColor4ub(red, static_cast<GLubyte>(frame), 7, 255);
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
        if (!eglSwapBuffers(display, surface)) return;
        glReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        const uint32_t expected =
            0xff070000u | static_cast<uint32_t>(frame) << 8 | static_cast<uint32_t>(red);
        bool same = glGetError() == GL_NO_ERROR;
        for (const uint32_t pixel : pixels) same = same && pixel == expected;
        right[static_cast<size_t>(i)] += same ? 1 : 0;
      }
      eglReleaseThread();
      eglDestroySurface(display, surface);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (int i = 0; i < kThreads; ++i) EXPECT_EQ(right[static_cast<size_t>(i)], kFrames) << i;
}

// Objects are made and destroyed by all threads at once, and handles of others are asked about.
TEST_F(ThreadTest, ManyThreadsCreateAndDestroy) {
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([this] {
      for (int n = 0; n < 200; ++n) {
        const EGLSurface surface = pbuffer(4, 4);
        const EGLContext ctx = context();
        EXPECT_TRUE(eglMakeCurrent(display, surface, surface, ctx));
        EXPECT_TRUE(eglDestroyContext(display, ctx));
        EGLint width = 0;
        eglQuerySurface(display,
                        reinterpret_cast<EGLSurface>(reinterpret_cast<uintptr_t>(surface) - 2),
                        EGL_WIDTH, &width);
        EXPECT_TRUE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
        EXPECT_TRUE(eglDestroySurface(display, surface));
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace clearpipe::icd
