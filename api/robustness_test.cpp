// EXT_robustness: reading into memory of a known size, resets, and buffers that end too early.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

using Robustness = CallTest;

// The bytes that a rectangle takes: rows are padded (4.3.1), but for the last one.
TEST_F(Robustness, NoMoreIsWrittenThanFits) {
  glClearColor(0, 1, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  const struct {
    GLint alignment;
    GLsizei width, height;
    GLenum format, type;
    GLsizei bytes;
  } kCases[] = {
      {4, 3, 2, GL_RGBA, GL_UNSIGNED_BYTE, 24},
      {8, 3, 2, GL_RGBA, GL_UNSIGNED_BYTE, 28},
      {8, 3, 1, GL_RGBA, GL_UNSIGNED_BYTE, 12},
      {4, 3, 2, GL_BGRA_EXT, GL_UNSIGNED_SHORT_4_4_4_4_REV_EXT, 14},
      {1, 3, 2, GL_BGRA_EXT, GL_UNSIGNED_SHORT_4_4_4_4_REV_EXT, 12},
      {4, 0, 9, GL_RGBA, GL_UNSIGNED_BYTE, 0},
      {4, 9, 0, GL_RGBA, GL_UNSIGNED_BYTE, 0},
  };
  for (const auto& c : kCases) {
    glPixelStorei(GL_PACK_ALIGNMENT, c.alignment);
    std::vector<GLubyte> data(64, 77), untouched = data;
    glReadnPixelsEXT(0, 0, c.width, c.height, c.format, c.type, c.bytes - 1, data.data());
    EXPECT_ERROR(GL_INVALID_OPERATION) << c.bytes;
    EXPECT_EQ(data, untouched) << c.bytes;
    glReadnPixelsEXT(0, 0, c.width, c.height, c.format, c.type, c.bytes, data.data());
    EXPECT_ERROR(GL_NO_ERROR) << c.bytes;
    EXPECT_EQ(std::count(data.begin() + c.bytes, data.end(), 77), 64 - c.bytes);
    if (c.bytes != 0) {
      EXPECT_NE(data[static_cast<size_t>(c.bytes) - 1], 77) << c.bytes;
    }
  }
}

TEST_F(Robustness, NothingIsEverReset) {
  EXPECT_EQ(glGetGraphicsResetStatusEXT(), static_cast<GLenum>(GL_NO_ERROR));
  Context* robust = create_context(nullptr, {false, false, true, true});
  make_current(robust, target_, target_);
  GLint strategy = 0;
  GLboolean access = GL_FALSE;
  glGetIntegerv(GL_RESET_NOTIFICATION_STRATEGY_EXT, &strategy);
  glGetBooleanv(GL_CONTEXT_ROBUST_ACCESS_EXT, &access);
  EXPECT_EQ(strategy, GL_LOSE_CONTEXT_ON_RESET_EXT);
  EXPECT_TRUE(access);
  EXPECT_EQ(glGetGraphicsResetStatusEXT(), static_cast<GLenum>(GL_NO_ERROR));
  make_current(context_, target_, target_);
  destroy_context(robust);
}

// Elements outside of every buffer: undefined values, and no harm (2.8).
TEST_F(Robustness, IndicesOutsideOfBuffers) {
  const GLuint indices[] = {0, 0xffffffffu, 0x7fffffffu, 12345, 1, 2};
  const GLfloat one[] = {1};
  glBindBuffer(GL_ARRAY_BUFFER, 1);
  glBufferData(GL_ARRAY_BUFFER, sizeof one, one, GL_STATIC_DRAW);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0x7fffffff, nullptr);
  glColorPointer(4, GL_UNSIGNED_BYTE, 0, nullptr);
  glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, indices);
  glDrawArrays(GL_TRIANGLES, 0x7ffffff0, 6);
  glFinish();
  EXPECT_ERROR(GL_NO_ERROR);
}

}  // namespace
}  // namespace clearpipe::api
