// Sync objects (APPLE_sync): their life, what waiting for them makes sure of, in one context and
// between two on two threads, and the 64-bit query that came with them.
// SPDX-License-Identifier: MIT
#include <atomic>
#include <string>
#include <thread>

#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

class SyncObjects : public CallTest {
 protected:
  // New memory may hold the picture of a surface that is gone.
  void SetUp() override {
    CallTest::SetUp();
    target_.colour->pixels[0] = 0;
  }
  static GLsync fence() { return glFenceSyncAPPLE(GL_SYNC_GPU_COMMANDS_COMPLETE_APPLE, 0); }
  static GLenum property(GLsync sync, GLenum name) {
    GLint value = -1;
    GLsizei length = -1;
    glGetSyncivAPPLE(sync, name, 1, &length, &value);
    EXPECT_EQ(length, 1);
    return static_cast<GLenum>(value);
  }
  static GLenum wait(GLsync sync, GLuint64 nanoseconds) {
    return glClientWaitSyncAPPLE(sync, GL_SYNC_FLUSH_COMMANDS_BIT_APPLE, nanoseconds);
  }
  static void draw(float red) {
    glColor4f(red, 1, 0, 1);
    draw_quad();
  }
  // The memory of the surface, which nothing but executing the frame changes.
  uint32_t drawn() const { return target_.colour->pixels[0]; }
};

constexpr GLuint64 kSecond = 1000000000;

TEST_F(SyncObjects, AreMadeAndDeleted) {
  const GLsync a = fence(), b = fence();
  EXPECT_NE(a, nullptr);
  EXPECT_NE(a, b);
  EXPECT_TRUE(glIsSyncAPPLE(a));
  glDeleteSyncAPPLE(a);
  glDeleteSyncAPPLE(nullptr);
  EXPECT_FALSE(glIsSyncAPPLE(a));
  EXPECT_FALSE(glIsSyncAPPLE(nullptr));
  EXPECT_TRUE(glIsSyncAPPLE(b));
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(SyncObjects, HaveProperties) {
  draw(0);
  const GLsync sync = fence();
  EXPECT_EQ(property(sync, GL_OBJECT_TYPE_APPLE), GLenum{GL_SYNC_FENCE_APPLE});
  EXPECT_EQ(property(sync, GL_SYNC_CONDITION_APPLE), GLenum{GL_SYNC_GPU_COMMANDS_COMPLETE_APPLE});
  EXPECT_EQ(property(sync, GL_SYNC_FLAGS_APPLE), 0u);
  EXPECT_EQ(property(sync, GL_SYNC_STATUS_APPLE), GLenum{GL_UNSIGNALED_APPLE});
  glFinish();
  EXPECT_EQ(property(sync, GL_SYNC_STATUS_APPLE), GLenum{GL_SIGNALED_APPLE});
  GLint untouched = 7;
  GLsizei length = 7;
  glGetSyncivAPPLE(sync, GL_SYNC_STATUS_APPLE, 0, &length, &untouched);
  EXPECT_EQ(untouched, 7);
  EXPECT_EQ(length, 0);
  glGetSyncivAPPLE(sync, GL_SYNC_STATUS_APPLE, 1, nullptr, &untouched);
  EXPECT_EQ(untouched, GL_SIGNALED_APPLE);
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(SyncObjects, WhatCameBeforeIsDoneWhenWaitedFor) {
  draw(0);
  const GLsync sync = fence();
  EXPECT_NE(drawn(), kGreen) << "making it executes nothing";
  EXPECT_EQ(wait(sync, kSecond), GLenum{GL_CONDITION_SATISFIED_APPLE});
  EXPECT_EQ(drawn(), kGreen);
  draw(1);
  EXPECT_EQ(wait(sync, 0), GLenum{GL_ALREADY_SIGNALED_APPLE});
  EXPECT_EQ(drawn(), kGreen) << "nothing is left to wait for";
  const GLsync polled = fence();
  EXPECT_EQ(glClientWaitSyncAPPLE(polled, 0, 0), GLenum{GL_CONDITION_SATISFIED_APPLE})
      << "a program that polls without flushing comes to an end";
  EXPECT_EQ(drawn(), kRed | kGreen);
  draw(0);
  glWaitSyncAPPLE(fence(), 0, GL_TIMEOUT_IGNORED_APPLE);
  EXPECT_EQ(drawn(), kRed | kGreen) << "commands of one context are in order anyway";
  EXPECT_ERROR(GL_NO_ERROR);
}

// The other context waits here, this one draws in a thread of its own.
TEST_F(SyncObjects, OfAnotherContextAreWaitedFor) {
  make_current(nullptr, {}, {});
  std::atomic<GLsync> made = nullptr;
  std::atomic<bool> go_on = false;
  std::thread drawer([&] {
    make_current(context_, target_, target_);
    draw(0);
    made = fence();
    made.notify_one();
    go_on.wait(false);
    glFlush();
    make_current(nullptr, {}, {});
  });
  Context* other = create_context(context_);
  const pipeline::Target target = make_target(kSize, kSize);
  make_current(other, target, target);
  made.wait(nullptr);
  const GLsync sync = made;
  EXPECT_TRUE(glIsSyncAPPLE(sync));
  EXPECT_EQ(wait(sync, 0), GLenum{GL_TIMEOUT_EXPIRED_APPLE});
  EXPECT_EQ(wait(sync, 1000), GLenum{GL_TIMEOUT_EXPIRED_APPLE});
  EXPECT_EQ(property(sync, GL_SYNC_STATUS_APPLE), GLenum{GL_UNSIGNALED_APPLE});
  go_on = true;
  go_on.notify_one();
  // The drawer may be done before this thread has begun to wait.
  const GLenum waited = wait(sync, GL_TIMEOUT_IGNORED_APPLE);
  EXPECT_TRUE(waited == GL_CONDITION_SATISFIED_APPLE || waited == GL_ALREADY_SIGNALED_APPLE);
  EXPECT_EQ(drawn(), kGreen);
  glWaitSyncAPPLE(sync, 0, GL_TIMEOUT_IGNORED_APPLE);
  glDeleteSyncAPPLE(sync);
  EXPECT_ERROR(GL_NO_ERROR);
  drawer.join();
  make_current(nullptr, {}, {});
  destroy_context(other);
}

TEST_F(SyncObjects, AreSignaledWhenTheirContextIsGone) {
  Context* other = create_context(context_);
  const pipeline::Target target = make_target(kSize, kSize);
  make_current(other, target, target);
  draw(0);
  const GLsync sync = fence();
  make_current(context_, target_, target_);
  destroy_context(other);
  EXPECT_EQ(wait(sync, 0), GLenum{GL_ALREADY_SIGNALED_APPLE});
  glWaitSyncAPPLE(sync, 0, GL_TIMEOUT_IGNORED_APPLE);
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(SyncObjects, HaveLabels) {
  const GLsync sync = fence();
  char text[8] = "";
  GLsizei length = -1;
  glObjectPtrLabelKHR(sync, -1, "upload");
  glGetObjectPtrLabelKHR(sync, sizeof(text), &length, text);
  EXPECT_STREQ(text, "upload");
  EXPECT_EQ(length, 6);
  const auto name = static_cast<GLuint>(reinterpret_cast<uintptr_t>(sync));
  glLabelObjectEXT(GL_SYNC_OBJECT_APPLE, name, 4, "done and gone");
  glGetObjectLabelEXT(GL_SYNC_OBJECT_APPLE, name, sizeof(text), &length, text);
  EXPECT_STREQ(text, "done");
  EXPECT_EQ(length, 4);
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(SyncObjects, Integers64) {
  const auto get = [](GLenum name) {
    GLint64 value = -7;
    glGetInteger64vAPPLE(name, &value);
    return value;
  };
  EXPECT_EQ(get(GL_MAX_SERVER_WAIT_TIMEOUT_APPLE), 1000000000);
  EXPECT_EQ(get(GL_MAX_LIGHTS), 8);
  EXPECT_EQ(get(GL_DITHER), 1);
  EXPECT_EQ(get(GL_SHADE_MODEL), GL_SMOOTH);
  glLineWidth(2.5f);
  EXPECT_EQ(get(GL_LINE_WIDTH), 3);
  glClearDepthf(1);
  EXPECT_EQ(get(GL_DEPTH_CLEAR_VALUE), INT64_MAX);
  glClearDepthf(0);
  EXPECT_EQ(get(GL_DEPTH_CLEAR_VALUE), 0);
  EXPECT_ERROR(GL_NO_ERROR);
}

}  // namespace
}  // namespace clearpipe::api
