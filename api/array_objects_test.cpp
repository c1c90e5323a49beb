// Mapped buffers, vertex array objects and lists of draws (OES_mapbuffer, EXT_map_buffer_range,
// OES_vertex_array_object, EXT_multi_draw_arrays), and EXT_discard_framebuffer.
// SPDX-License-Identifier: MIT
#include <cstring>

#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

constexpr float kQuad[] = {-1, -1, 1, -1, -1, 1, 1, 1};
constexpr float kLeft[] = {-1, -1, 0, -1, -1, 1, 0, 1};
constexpr GLenum kArray = GL_ARRAY_BUFFER, kElements = GL_ELEMENT_ARRAY_BUFFER;

class ArrayObjects : public CallTest {
 protected:
  static GLuint buffer_with(const void* data, GLsizeiptr size, GLenum target = kArray) {
    GLuint name = 0;
    glGenBuffers(1, &name);
    glBindBuffer(target, name);
    glBufferData(target, size, data, GL_DYNAMIC_DRAW);
    return name;
  }
  static GLint parameter(GLenum name) {
    GLint value = -1;
    glGetBufferParameteriv(kArray, name, &value);
    return value;
  }
  static void* map_pointer() {
    void* pointer = nullptr;
    glGetBufferPointervOES(kArray, GL_BUFFER_MAP_POINTER_OES, &pointer);
    return pointer;
  }
  static void draw_four() { glDrawArrays(GL_TRIANGLE_STRIP, 0, 4); }
};

TEST_F(ArrayObjects, AMappedBufferIsWrittenAndDrawn) {
  buffer_with(kQuad, sizeof kQuad);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, nullptr);
  glColor4f(1, 0, 0, 1);
  draw_four();  // pending while the store is mapped
  void* pointer = glMapBufferOES(kArray, GL_WRITE_ONLY_OES);
  ASSERT_NE(pointer, nullptr);
  EXPECT_EQ(std::memcmp(pointer, kQuad, sizeof kQuad), 0);
  EXPECT_EQ(map_pointer(), pointer);
  EXPECT_EQ(parameter(GL_BUFFER_MAPPED_OES), GL_TRUE);
  EXPECT_EQ(parameter(GL_BUFFER_ACCESS_OES), GL_WRITE_ONLY_OES);
  std::memcpy(pointer, kLeft, sizeof kLeft);
  draw_four();
  EXPECT_ERROR(GL_INVALID_OPERATION);
  glBufferSubData(kArray, 0, 4, kQuad);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  EXPECT_EQ(glMapBufferOES(kArray, GL_WRITE_ONLY_OES), nullptr);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  EXPECT_EQ(glUnmapBufferOES(kArray), GL_TRUE);
  EXPECT_EQ(parameter(GL_BUFFER_MAPPED_OES), GL_FALSE);
  EXPECT_EQ(map_pointer(), nullptr);
  EXPECT_EQ(right(), kRed);
  glColor4f(0, 0, 1, 1);
  draw_four();
  EXPECT_EQ(left(), kBlue);
  EXPECT_EQ(right(), kRed);
  EXPECT_ERROR(GL_NO_ERROR);
  glMapBufferOES(kArray, GL_WRITE_ONLY_OES);
  glBufferData(kArray, sizeof kQuad, kQuad, GL_STATIC_DRAW);  // a new store
  EXPECT_EQ(glUnmapBufferOES(kArray), GL_FALSE);
  EXPECT_ERROR(GL_INVALID_OPERATION);
}

TEST_F(ArrayObjects, MapErrors) {
  EXPECT_EQ(glMapBufferOES(kArray, GL_WRITE_ONLY_OES), nullptr);
  EXPECT_ERROR(GL_INVALID_OPERATION);  // zero is bound
  EXPECT_EQ(glMapBufferRangeEXT(kArray, 0, 4, GL_MAP_WRITE_BIT_EXT), nullptr);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  buffer_with(kQuad, sizeof kQuad);
  EXPECT_EQ(glMapBufferOES(GL_TEXTURE_2D, GL_WRITE_ONLY_OES), nullptr);
  EXPECT_ERROR(GL_INVALID_ENUM);
  EXPECT_EQ(glMapBufferOES(kArray, GL_WRITE_ONLY_OES - 1), nullptr);
  EXPECT_ERROR(GL_INVALID_ENUM);
  struct Row {
    GLintptr offset;
    GLsizeiptr length;
    GLbitfield access;
    GLenum error;
  };
  const GLbitfield read = GL_MAP_READ_BIT_EXT, write = GL_MAP_WRITE_BIT_EXT;
  const Row rows[] = {{-1, 4, write, GL_INVALID_VALUE},
                      {0, -1, write, GL_INVALID_VALUE},
                      {16, 17, write, GL_INVALID_VALUE},
                      {0, 4, write | 0x40, GL_INVALID_VALUE},
                      {0, 0, write, GL_INVALID_OPERATION},
                      {0, 4, 0, GL_INVALID_OPERATION},
                      {0, 4, read | GL_MAP_INVALIDATE_RANGE_BIT_EXT, GL_INVALID_OPERATION},
                      {0, 4, read | write | GL_MAP_INVALIDATE_BUFFER_BIT_EXT, GL_INVALID_OPERATION},
                      {0, 4, read | GL_MAP_UNSYNCHRONIZED_BIT_EXT, GL_INVALID_OPERATION},
                      {0, 4, read | GL_MAP_FLUSH_EXPLICIT_BIT_EXT, GL_INVALID_OPERATION}};
  for (const Row& row : rows) {
    EXPECT_EQ(glMapBufferRangeEXT(kArray, row.offset, row.length, row.access), nullptr);
    EXPECT_ERROR(row.error) << row.offset << " " << row.length << " " << row.access;
  }
  EXPECT_EQ(parameter(GL_BUFFER_MAPPED_OES), GL_FALSE);
  glFlushMappedBufferRangeEXT(kArray, 0, 4);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  void* pointer = nullptr;
  glGetBufferPointervOES(kArray, GL_BUFFER_SIZE, &pointer);
  EXPECT_ERROR(GL_INVALID_ENUM);
  glBufferData(kArray, 0, nullptr, GL_STATIC_DRAW);
  EXPECT_EQ(glMapBufferOES(kArray, GL_WRITE_ONLY_OES), nullptr);
  EXPECT_ERROR(GL_OUT_OF_MEMORY);
}

TEST_F(ArrayObjects, RangesAreMappedAndFlushed) {
  buffer_with(kQuad, sizeof kQuad);
  auto* part = static_cast<float*>(
      glMapBufferRangeEXT(kArray, 8, 8, GL_MAP_WRITE_BIT_EXT | GL_MAP_FLUSH_EXPLICIT_BIT_EXT));
  ASSERT_NE(part, nullptr);
  part[0] = 0;
  glFlushMappedBufferRangeEXT(kArray, 4, 5);
  EXPECT_ERROR(GL_INVALID_VALUE);
  glFlushMappedBufferRangeEXT(kArray, 0, 4);
  EXPECT_ERROR(GL_NO_ERROR);
  glUnmapBufferOES(kArray);
  const auto* whole =
      static_cast<const float*>(glMapBufferRangeEXT(kArray, 0, sizeof kQuad, GL_MAP_READ_BIT_EXT));
  ASSERT_NE(whole, nullptr);
  EXPECT_EQ(whole[1], -1);
  EXPECT_EQ(whole[2], 0);
  glFlushMappedBufferRangeEXT(kArray, 0, 4);
  EXPECT_ERROR(GL_INVALID_OPERATION);  // not to be flushed explicitly
}

TEST_F(ArrayObjects, VertexArrayObjectsKeepTheirArrays) {
  GLuint arrays[2] = {};
  glGenVertexArraysOES(2, arrays);
  EXPECT_FALSE(glIsVertexArrayOES(arrays[0]));
  glBindVertexArrayOES(arrays[1] + 1);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  const GLuint quad = buffer_with(kQuad, sizeof kQuad);
  glVertexPointer(3, GL_FLOAT, 12, nullptr);  // of the default vertex array
  for (const GLuint array : arrays) {
    glBindVertexArrayOES(array);
    EXPECT_TRUE(glIsVertexArrayOES(array));
    GLint size = 0;
    glGetIntegerv(GL_VERTEX_ARRAY_SIZE, &size);
    EXPECT_EQ(size, 4);
    glVertexPointer(2, GL_FLOAT, 0, nullptr);
    glEnableClientState(GL_VERTEX_ARRAY);
    const uint8_t indices[] = {0, 1, 2, 3};
    buffer_with(indices, sizeof indices, kElements);
    buffer_with(kLeft, sizeof kLeft);  // for the next
  }
  GLint value = 0;
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING_OES, &value);
  EXPECT_EQ(value, static_cast<GLint>(arrays[1]));
  glBindBuffer(kArray, 0);
  glVertexPointer(2, GL_FLOAT, 0, kQuad);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  glColorPointer(4, GL_FLOAT, 0, kQuad);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  glNormalPointer(GL_FLOAT, 0, kQuad);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  glPointSizePointerOES(GL_FLOAT, 0, kQuad);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  glColor4f(1, 0, 0, 1);
  glBindVertexArrayOES(arrays[0]);
  glDrawElements(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_EQ(right(), kRed);
  glColor4f(0, 1, 0, 1);
  glBindVertexArrayOES(arrays[1]);
  glDeleteBuffers(1, &quad);  // still held by the other
  glDrawElements(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_EQ(left(), kGreen);
  EXPECT_EQ(right(), kRed);
  glDeleteVertexArraysOES(1, &arrays[1]);
  EXPECT_FALSE(glIsVertexArrayOES(arrays[1]));
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING_OES, &value);
  EXPECT_EQ(value, 0);
  glGetIntegerv(GL_VERTEX_ARRAY_SIZE, &value);
  EXPECT_EQ(value, 3);
  EXPECT_FALSE(glIsEnabled(GL_VERTEX_ARRAY));
  glGetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &value);
  EXPECT_EQ(value, 0);
  glBindVertexArrayOES(arrays[0]);
  glColor4f(0, 0, 1, 1);
  glDrawElements(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_EQ(right(), kBlue);
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(ArrayObjects, ListsOfDraws) {
  static const float kHalves[] = {-1, -1, -0.5f, -1, -1, 1, -0.5f, 1, 0, -1, 1, -1, 0, 1, 1, 1};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, kHalves);
  glClear(GL_COLOR_BUFFER_BIT);
  glColor4f(1, 0, 0, 1);
  const GLint first[] = {0, -7, 4};
  GLsizei count[] = {4, 0, 4};  // nothing to draw is no error
  glMultiDrawArraysEXT(GL_TRIANGLE_STRIP, first, count, 3);
  EXPECT_EQ(pixel(1, 8), kRed);
  EXPECT_EQ(pixel(6, 8), 0u);
  EXPECT_EQ(right(), kRed);
  EXPECT_ERROR(GL_NO_ERROR);
  const uint8_t left_part[] = {0, 1, 2, 3}, right_part[] = {4, 5, 6, 7};
  const void* const indices[] = {left_part, nullptr, right_part};
  glColor4f(0, 0, 1, 1);
  glMultiDrawElementsEXT(GL_TRIANGLE_STRIP, count, GL_UNSIGNED_BYTE, indices, 3);
  EXPECT_EQ(pixel(1, 8), kBlue);
  EXPECT_EQ(right(), kBlue);
  EXPECT_ERROR(GL_NO_ERROR);

  glColor4f(0, 1, 0, 1);
  count[1] = 4;  // the second may not be drawn, so none is
  glMultiDrawArraysEXT(GL_TRIANGLE_STRIP, first, count, 3);
  EXPECT_ERROR(GL_INVALID_VALUE);
  glMultiDrawArraysEXT(GL_TRIANGLE_FAN + 1, first, count, 1);
  EXPECT_ERROR(GL_INVALID_ENUM);
  glMultiDrawArraysEXT(GL_TRIANGLES, first, count, -1);
  EXPECT_ERROR(GL_INVALID_VALUE);
  glMultiDrawElementsEXT(GL_TRIANGLES, count, GL_FLOAT, indices, 1);
  EXPECT_ERROR(GL_INVALID_ENUM);
  glMultiDrawElementsEXT(GL_TRIANGLES, count, GL_UNSIGNED_BYTE, indices, -1);
  EXPECT_ERROR(GL_INVALID_VALUE);
  EXPECT_EQ(right(), kBlue);
}

TEST_F(ArrayObjects, DiscardTakesTheAttachmentsOfWhatIsBound) {
  const GLenum surface[] = {GL_COLOR_EXT, GL_DEPTH_EXT, GL_STENCIL_EXT};
  const GLenum object[] = {GL_COLOR_ATTACHMENT0_OES, GL_DEPTH_ATTACHMENT_OES};
  glDiscardFramebufferEXT(GL_FRAMEBUFFER_OES, 3, surface);
  EXPECT_ERROR(GL_NO_ERROR);
  glDiscardFramebufferEXT(GL_FRAMEBUFFER_OES, 2, object);
  EXPECT_ERROR(GL_INVALID_ENUM);
  glDiscardFramebufferEXT(GL_FRAMEBUFFER_OES, -1, surface);
  EXPECT_ERROR(GL_INVALID_VALUE);
  glDiscardFramebufferEXT(GL_RENDERBUFFER_OES, 0, surface);
  EXPECT_ERROR(GL_INVALID_ENUM);
  glBindFramebufferOES(GL_FRAMEBUFFER_OES, 1);
  glDiscardFramebufferEXT(GL_FRAMEBUFFER_OES, 2, object);
  EXPECT_ERROR(GL_NO_ERROR);
  glDiscardFramebufferEXT(GL_FRAMEBUFFER_OES, 1, surface);
  EXPECT_ERROR(GL_INVALID_ENUM);
}

}  // namespace
}  // namespace clearpipe::api
