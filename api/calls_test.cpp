// The C API on a small surface: errors, state, and pixels that depend on state being derived again.
// SPDX-License-Identifier: MIT
#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

using Calls = CallTest;

TEST_F(Calls, TheFirstErrorSticks) {
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  glEnable(GL_NO_ERROR);
  glLineWidth(-1);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  glPopMatrix();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_STACK_UNDERFLOW));
}

TEST_F(Calls, ViewportAndScissorStartAsTheSurface) {
  GLint box[4];
  glGetIntegerv(GL_VIEWPORT, box);
  EXPECT_EQ(box[2], kSize);
  glGetIntegerv(GL_SCISSOR_BOX, box);
  EXPECT_EQ(box[3], kSize);
}

TEST_F(Calls, ClearRespectsScissorAndMask) {
  glClearColor(1, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glScissor(0, 0, 8, 8);
  glEnable(GL_SCISSOR_TEST);
  glColorMask(0, 1, 0, 1);
  glClearColor(0, 1, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  EXPECT_EQ(pixel(2, 2), 0xff00ffffu);
  EXPECT_EQ(pixel(12, 12), 0xff0000ffu);
}

TEST_F(Calls, DrawsWithTheCurrentColour) {
  glColor4ub(0, 255, 0, 255);
  draw_quad();
  EXPECT_EQ(pixel(8, 8), 0xff00ff00u);
  glColor4f(0, 0, 1, 1);
  draw_quad();
  EXPECT_EQ(pixel(8, 8), 0xffff0000u);
  glDisableClientState(GL_VERTEX_ARRAY);
  glColor4f(1, 1, 1, 1);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  EXPECT_EQ(pixel(8, 8), 0xffff0000u);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(Calls, AnIncompleteTextureDisablesItsUnit) {
  one_colour_texture(kRed);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  draw_quad();
  EXPECT_EQ(pixel(12, 8), kWhite);
}

TEST_F(Calls, ElementsBeyondTheirBufferAreRefused) {
  const GLubyte indices[4] = {0, 1, 2, 3};
  GLuint name;
  glGenBuffers(1, &name);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, name);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, 4, indices, GL_STATIC_DRAW);
  static const float kQuad[] = {-1, -1, 1, -1, -1, 1, 1, 1};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, kQuad);
  glDrawElements(GL_TRIANGLE_STRIP, 5, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
  glDrawElements(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  EXPECT_EQ(pixel(8, 8), 0xffffffffu);
}

TEST(WithoutContext, CallsDoNothing) {
  glClear(GL_COLOR_BUFFER_BIT);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  EXPECT_EQ(glGetString(GL_VENDOR), nullptr);
}

}  // namespace
}  // namespace clearpipe::api
