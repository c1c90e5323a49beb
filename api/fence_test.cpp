// Fences (NV_fence): their life, and that what was drawn before one is there when it is passed.
// SPDX-License-Identifier: MIT
#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

using Fences = CallTest;

TEST_F(Fences, NamesBecomeFencesWhenSet) {
  GLuint names[2] = {};
  glGenFencesNV(2, names);
  EXPECT_NE(names[0], names[1]);
  EXPECT_FALSE(glIsFenceNV(names[0]));
  glSetFenceNV(names[0], GL_ALL_COMPLETED_NV);
  EXPECT_TRUE(glIsFenceNV(names[0]));
  EXPECT_FALSE(glIsFenceNV(names[1]));
  glSetFenceNV(77, GL_ALL_COMPLETED_NV);  // a name of the application's own
  EXPECT_TRUE(glIsFenceNV(77));
  const GLuint gone[] = {77, 0, 12345};
  glDeleteFencesNV(3, gone);
  EXPECT_FALSE(glIsFenceNV(77));
  EXPECT_TRUE(glIsFenceNV(names[0]));
  GLint condition = 0;
  glGetFenceivNV(names[0], GL_FENCE_CONDITION_NV, &condition);
  EXPECT_EQ(condition, GL_ALL_COMPLETED_NV);
  EXPECT_ERROR(GL_NO_ERROR);
}

// The memory of the surface, which nothing but executing the frame changes.
TEST_F(Fences, WhatCameBeforeIsDoneWhenPassed) {
  const auto drawn = [this] { return target_.colour->pixels[0]; };
  const auto draw = [](float red) {
    glColor4f(red, 1, 0, 1);
    draw_quad();
  };
  GLint status = 0;
  draw(0);
  glSetFenceNV(1, GL_ALL_COMPLETED_NV);
  EXPECT_NE(drawn(), kGreen) << "setting it executes nothing";
  glFinishFenceNV(1);
  EXPECT_EQ(drawn(), kGreen);
  draw(1);
  EXPECT_TRUE(glTestFenceNV(1));
  EXPECT_EQ(drawn(), kGreen) << "a fence that is passed stays so, and asks for nothing";
  glSetFenceNV(1, GL_ALL_COMPLETED_NV);
  EXPECT_TRUE(glTestFenceNV(1));
  EXPECT_EQ(drawn(), kRed | kGreen);
  draw(0);
  glSetFenceNV(1, GL_ALL_COMPLETED_NV);
  glGetFenceivNV(1, GL_FENCE_STATUS_NV, &status);
  EXPECT_EQ(status, GL_TRUE);
  EXPECT_EQ(drawn(), kGreen);
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(Fences, ContextsHaveTheirOwn) {
  glSetFenceNV(1, GL_ALL_COMPLETED_NV);
  Context* other = create_context(context_);
  make_current(other, target_, target_);
  EXPECT_FALSE(glIsFenceNV(1));
  make_current(context_, target_, target_);
  EXPECT_TRUE(glIsFenceNV(1));
  destroy_context(other);
}

}  // namespace
}  // namespace clearpipe::api
