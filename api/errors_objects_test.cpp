// Errors of framebuffer and renderbuffer objects (OES_framebuffer_object and what goes with it),
// mapped buffers (OES_mapbuffer, EXT_map_buffer_range) and vertex array objects
// (OES_vertex_array_object).
// SPDX-License-Identifier: MIT
#include "api/error_cases.h"

namespace clearpipe::api {
namespace {

constexpr GLenum kFramebuffer = GL_FRAMEBUFFER_OES, kRenderbuffer = GL_RENDERBUFFER_OES,
                 kColour = GL_COLOR_ATTACHMENT0_OES, kDepth = GL_DEPTH_ATTACHMENT_OES,
                 kStencil = GL_STENCIL_ATTACHMENT_OES,
                 kIncomplete = GL_INVALID_FRAMEBUFFER_OPERATION_OES;

class ObjectErrors : public ErrorTest {
 protected:
  static GLint* out() { return x; }
  static void attach(GLenum point, GLuint renderbuffer) {
    glFramebufferRenderbufferOES(kFramebuffer, point, kRenderbuffer, renderbuffer);
  }
  static void storage(GLuint name, GLenum format, GLsizei size) {
    glBindRenderbufferOES(kRenderbuffer, name);
    glRenderbufferStorageOES(kRenderbuffer, format, size, size);
  }
  static void read() { glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, x); }
  // What needs a complete framebuffer.
  static const std::vector<ErrorCase>& uses() {
    static const std::vector<ErrorCase> kCases = {
        REFUSED(kIncomplete, glClear(GL_COLOR_BUFFER_BIT)),
        REFUSED(kIncomplete, glDrawArrays(GL_TRIANGLES, 0, 3)),
        REFUSED(kIncomplete, glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, nullptr)),
        REFUSED(kIncomplete, glDrawTexiOES(0, 0, 0, 1, 1)),
        REFUSED(kIncomplete, read()),
        REFUSED(kIncomplete, glCopyTexImage2D(k2D, 0, GL_RGBA, 0, 0, 1, 1, 0)),
        REFUSED(kIncomplete, glCopyTexSubImage2D(k2D, 0, 0, 0, 0, 0, 1, 1)),
    };
    return kCases;
  }
};

TEST_F(ObjectErrors, FramebufferObjects) {
  const ErrorCase kCases[] = {
    REFUSED(GL_INVALID_ENUM, glBindFramebufferOES(kRenderbuffer, 3)),
    REFUSED(GL_INVALID_ENUM, glBindRenderbufferOES(kFramebuffer, 3)),
    REFUSED(GL_INVALID_VALUE, GLuint n = 0; glGenFramebuffersOES(-1, &n)),
    REFUSED(GL_INVALID_VALUE, GLuint n = 0; glDeleteFramebuffersOES(-1, &n)),
    REFUSED(GL_INVALID_VALUE, GLuint n = 0; glGenRenderbuffersOES(-1, &n)),
    REFUSED(GL_INVALID_VALUE, GLuint n = 0; glDeleteRenderbuffersOES(-1, &n)),
    REFUSED(GL_INVALID_ENUM, EXPECT_EQ(glCheckFramebufferStatusOES(kRenderbuffer), 0u)),
    // No framebuffer object and no renderbuffer are bound.
    REFUSED(GL_INVALID_OPERATION, attach(kColour, 0)),
    REFUSED(GL_INVALID_OPERATION, glFramebufferTexture2DOES(kFramebuffer, kColour, k2D, 0, 0)),
    REFUSED(GL_INVALID_OPERATION,
            glGetFramebufferAttachmentParameterivOES(
                kFramebuffer, kColour, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_OES, out())),
    REFUSED(GL_INVALID_OPERATION, glRenderbufferStorageOES(kRenderbuffer, GL_RGBA8_OES, 1, 1)),
    REFUSED(GL_INVALID_OPERATION,
            glGetRenderbufferParameterivOES(kRenderbuffer, GL_RENDERBUFFER_WIDTH_OES, out())),
    REFUSED(GL_INVALID_ENUM, glGenerateMipmapOES(GL_TEXTURE)),
  };
  expect_refused(kCases);
}

TEST_F(ObjectErrors, Attachments) {
  glBindFramebufferOES(kFramebuffer, 3);
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_ENUM, glFramebufferRenderbufferOES(0, kColour, kRenderbuffer, 0)),
      REFUSED(GL_INVALID_ENUM, attach(kColour + 1, 0)),
      REFUSED(GL_INVALID_ENUM, glFramebufferRenderbufferOES(kFramebuffer, kColour, k2D, 0)),
      REFUSED(GL_INVALID_OPERATION, attach(kColour, 77)),
      REFUSED(GL_INVALID_ENUM, glFramebufferTexture2DOES(0, kColour, k2D, 1, 0)),
      REFUSED(GL_INVALID_ENUM, glFramebufferTexture2DOES(kFramebuffer, kColour + 1, k2D, 1, 0)),
      REFUSED(GL_INVALID_ENUM,
              glFramebufferTexture2DOES(kFramebuffer, kColour, GL_TEXTURE_BINDING_2D, 1, 0)),
      REFUSED(GL_INVALID_OPERATION, glFramebufferTexture2DOES(kFramebuffer, kColour, k2D, 77, 0)),
      REFUSED(GL_INVALID_VALUE, glFramebufferTexture2DOES(kFramebuffer, kColour, k2D, 1, -1)),
      REFUSED(GL_INVALID_VALUE, glFramebufferTexture2DOES(kFramebuffer, kColour, k2D, 1, 15)),
      REFUSED(GL_INVALID_ENUM, glGetFramebufferAttachmentParameterivOES(
                                   0, kColour, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_OES, out())),
      REFUSED(GL_INVALID_ENUM, glGetFramebufferAttachmentParameterivOES(
                                   kFramebuffer, GL_COLOR_BUFFER_BIT,
                                   GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_OES, out())),
      REFUSED(GL_INVALID_ENUM,
              glGetFramebufferAttachmentParameterivOES(kFramebuffer, kColour, GL_RED_BITS, out())),
      // Nothing is attached.
      REFUSED(GL_INVALID_ENUM,
              glGetFramebufferAttachmentParameterivOES(
                  kFramebuffer, kColour, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME_OES, out())),
      REFUSED(GL_INVALID_ENUM,
              glGetFramebufferAttachmentParameterivOES(
                  kFramebuffer, kColour, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL_OES, out())),
  };
  expect_refused(kCases);
  storage(4, GL_RGBA8_OES, 1);
  attach(kColour, 4);
  const ErrorCase kNoTexture[] = {
      REFUSED(GL_INVALID_ENUM,
              glGetFramebufferAttachmentParameterivOES(
                  kFramebuffer, kColour, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL_OES, out())),
      REFUSED(GL_INVALID_ENUM, glGetFramebufferAttachmentParameterivOES(
                                   kFramebuffer, kColour,
                                   GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE_OES, out())),
  };
  expect_refused(kNoTexture);
}

TEST_F(ObjectErrors, RenderbufferStorage) {
  glBindRenderbufferOES(kRenderbuffer, 3);
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_ENUM, glRenderbufferStorageOES(k2D, GL_RGBA8_OES, 1, 1)),
      REFUSED(GL_INVALID_ENUM, glRenderbufferStorageOES(kRenderbuffer, GL_LUMINANCE, 1, 1)),
      REFUSED(GL_INVALID_VALUE, glRenderbufferStorageOES(kRenderbuffer, GL_RGBA8_OES, -1, 1)),
      REFUSED(GL_INVALID_VALUE, glRenderbufferStorageOES(kRenderbuffer, GL_RGBA8_OES, 1, -1)),
      REFUSED(GL_INVALID_VALUE, glRenderbufferStorageOES(kRenderbuffer, GL_RGBA8_OES, 16385, 1)),
      REFUSED(GL_INVALID_VALUE, glRenderbufferStorageOES(kRenderbuffer, GL_RGBA8_OES, 1, 16385)),
      REFUSED(GL_INVALID_ENUM,
              glGetRenderbufferParameterivOES(k2D, GL_RENDERBUFFER_WIDTH_OES, out())),
      REFUSED(GL_INVALID_ENUM, glGetRenderbufferParameterivOES(kRenderbuffer, GL_RED_BITS, out())),
  };
  expect_refused(kCases);
}

// EXT_multisampled_render_to_texture
TEST_F(ObjectErrors, Samples) {
  static const auto attach_samples = [](GLenum target, GLenum point, GLenum texture_target,
                                        GLuint name, GLint level, GLsizei samples) {
    glFramebufferTexture2DMultisampleEXT(target, point, texture_target, name, level, samples);
  };
  static const auto store = [](GLenum target, GLsizei samples, GLenum format, GLsizei size) {
    glRenderbufferStorageMultisampleEXT(target, samples, format, size, 1);
  };
  const ErrorCase kUnbound[] = {
      REFUSED(GL_INVALID_OPERATION, store(kRenderbuffer, 4, GL_RGBA8_OES, 1)),
      REFUSED(GL_INVALID_OPERATION, attach_samples(kFramebuffer, kColour, k2D, 1, 0, 4)),
  };
  expect_refused(kUnbound);
  glBindRenderbufferOES(kRenderbuffer, 3);
  glBindFramebufferOES(kFramebuffer, 3);
  glFramebufferTexture2DMultisampleEXT(kFramebuffer, kColour, k2D, 1, 0, 4);
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_ENUM, attach_samples(kRenderbuffer, kColour, k2D, 1, 0, 0)),
      REFUSED(GL_INVALID_ENUM, attach_samples(kFramebuffer, kDepth, k2D, 1, 0, 0)),
      REFUSED(GL_INVALID_ENUM, attach_samples(kFramebuffer, kColour, GL_TEXTURE, 1, 0, 0)),
      REFUSED(GL_INVALID_OPERATION, attach_samples(kFramebuffer, kColour, k2D, 77, 0, 0)),
      REFUSED(GL_INVALID_VALUE, attach_samples(kFramebuffer, kColour, k2D, 1, -1, 0)),
      REFUSED(GL_INVALID_VALUE, attach_samples(kFramebuffer, kColour, k2D, 1, 0, 5)),
      REFUSED(GL_INVALID_VALUE, attach_samples(kFramebuffer, kColour, k2D, 1, 0, -1)),
      REFUSED(GL_INVALID_ENUM, store(kFramebuffer, 0, GL_RGBA8_OES, 1)),
      REFUSED(GL_INVALID_ENUM, store(kRenderbuffer, 0, GL_RGBA, 1)),
      REFUSED(GL_INVALID_VALUE, store(kRenderbuffer, 5, GL_RGBA8_OES, 1)),
      REFUSED(GL_INVALID_VALUE, store(kRenderbuffer, -1, GL_RGBA8_OES, 1)),
      REFUSED(GL_INVALID_VALUE, store(kRenderbuffer, 1, GL_RGBA8_OES, 16385)),
  };
  expect_refused(kCases);
  EXPECT_EQ(glCheckFramebufferStatusOES(kFramebuffer), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
  storage(5, GL_DEPTH_COMPONENT16_OES, 4);
  attach(kDepth, 5);
  expect_refused(uses());  // a texture with samples, depth without
  glFramebufferTexture2DMultisampleEXT(kFramebuffer, kColour, k2D, 0, 0, 4);
  attach(kDepth, 0);
}

// 4.4.4.2: every reason not to be complete.
TEST_F(ObjectErrors, IncompleteFramebuffers) {
  glBindFramebufferOES(kFramebuffer, 3);
  expect_refused(uses());  // nothing is attached
  storage(4, GL_RGBA8_OES, 0);
  attach(kColour, 4);
  expect_refused(uses());  // no size
  storage(4, GL_RGBA8_OES, 4);
  storage(5, GL_DEPTH_COMPONENT16_OES, 8);
  attach(kDepth, 5);
  expect_refused(uses());  // sizes that differ
  attach(kDepth, 4);
  expect_refused(uses());  // a colour as depth
  storage(5, GL_DEPTH_COMPONENT16_OES, 4);
  storage(6, GL_STENCIL_INDEX8_OES, 4);
  attach(kDepth, 5);
  attach(kStencil, 6);
  expect_refused(uses());  // two images of depth and stencil
}

TEST_F(ObjectErrors, NoColourToRead) {
  glBindFramebufferOES(kFramebuffer, 3);
  storage(5, GL_DEPTH_COMPONENT16_OES, 4);
  attach(kDepth, 5);
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_OPERATION, read()),
      REFUSED(GL_INVALID_OPERATION, glCopyTexImage2D(k2D, 0, GL_RGBA, 0, 0, 1, 1, 0)),
      REFUSED(GL_INVALID_OPERATION, glCopyTexSubImage2D(k2D, 0, 0, 0, 0, 0, 1, 1)),
  };
  expect_refused(kCases);
}

TEST_F(ObjectErrors, DiscardedAttachments) {
  static constexpr GLenum kOfObjects[] = {kColour, GL_COLOR_EXT}, kOfSurfaces[] = {kColour};
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_ENUM, glDiscardFramebufferEXT(k2D, 0, nullptr)),
      REFUSED(GL_INVALID_VALUE, glDiscardFramebufferEXT(kFramebuffer, -1, kOfObjects)),
      REFUSED(GL_INVALID_ENUM, glDiscardFramebufferEXT(kFramebuffer, 1, kOfSurfaces)),
  };
  expect_refused(kCases);
  glBindFramebufferOES(kFramebuffer, 3);
  const ErrorCase kMixed[] = {
      REFUSED(GL_INVALID_ENUM, glDiscardFramebufferEXT(kFramebuffer, 2, kOfObjects))};
  expect_refused(kMixed);
}

TEST_F(ObjectErrors, MappedBuffers) {
  constexpr GLbitfield kRead = GL_MAP_READ_BIT_EXT, kWrite = GL_MAP_WRITE_BIT_EXT;
  constexpr GLenum kArray = GL_ARRAY_BUFFER;
  const auto none = [](GLintptr offset, GLsizeiptr length, GLbitfield access) {
    EXPECT_EQ(glMapBufferRangeEXT(GL_ARRAY_BUFFER, offset, length, access), nullptr);
  };
  static const auto range = none;
  static void* pointer = &pointer;
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_ENUM, EXPECT_EQ(glMapBufferOES(k2D, GL_WRITE_ONLY_OES), nullptr)),
      REFUSED(GL_INVALID_ENUM, EXPECT_EQ(glMapBufferOES(kArray, kWrite), nullptr)),
      REFUSED(GL_INVALID_ENUM, EXPECT_EQ(glMapBufferRangeEXT(k2D, 0, 1, kWrite), nullptr)),
      REFUSED(GL_INVALID_VALUE, range(-1, 1, kWrite)),
      REFUSED(GL_INVALID_VALUE, range(0, -1, kWrite)),
      REFUSED(GL_INVALID_VALUE, range(8, 1, kWrite)),
      REFUSED(GL_INVALID_VALUE, range(INTPTR_MAX, INTPTR_MAX, kWrite)),
      REFUSED(GL_INVALID_VALUE, range(0, 1, kWrite | 0x40)),
      REFUSED(GL_INVALID_OPERATION, range(0, 0, kWrite)),
      REFUSED(GL_INVALID_OPERATION, range(0, 1, 0)),
      REFUSED(GL_INVALID_OPERATION, range(0, 1, kRead | GL_MAP_INVALIDATE_RANGE_BIT_EXT)),
      REFUSED(GL_INVALID_OPERATION, range(0, 1, kRead | GL_MAP_INVALIDATE_BUFFER_BIT_EXT)),
      REFUSED(GL_INVALID_OPERATION, range(0, 1, kRead | GL_MAP_UNSYNCHRONIZED_BIT_EXT)),
      REFUSED(GL_INVALID_OPERATION, range(0, 1, kRead | GL_MAP_FLUSH_EXPLICIT_BIT_EXT)),
      REFUSED(GL_INVALID_ENUM, glFlushMappedBufferRangeEXT(k2D, 0, 1)),
      REFUSED(GL_INVALID_OPERATION, glFlushMappedBufferRangeEXT(kArray, 0, 1)),
      REFUSED(GL_INVALID_ENUM, EXPECT_FALSE(glUnmapBufferOES(k2D))),
      REFUSED(GL_INVALID_OPERATION, EXPECT_FALSE(glUnmapBufferOES(kArray))),
      REFUSED(GL_INVALID_ENUM, glGetBufferPointervOES(k2D, GL_BUFFER_MAP_POINTER_OES, &pointer)),
      REFUSED(GL_INVALID_ENUM, glGetBufferPointervOES(kArray, GL_BUFFER_SIZE, &pointer)),
  };
  expect_refused(kCases);
  EXPECT_EQ(pointer, &pointer);

  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_BYTE, 0, nullptr);
  glMapBufferOES(kArray, GL_WRITE_ONLY_OES);
  const ErrorCase kMapped[] = {
      REFUSED(GL_INVALID_OPERATION, EXPECT_EQ(glMapBufferOES(kArray, GL_WRITE_ONLY_OES), nullptr)),
      REFUSED(GL_INVALID_OPERATION, range(0, 1, kWrite)),
      REFUSED(GL_INVALID_OPERATION, glBufferSubData(kArray, 0, 1, f)),
      REFUSED(GL_INVALID_OPERATION, glFlushMappedBufferRangeEXT(kArray, 0, 1)),
      REFUSED(GL_INVALID_OPERATION, glDrawArrays(GL_TRIANGLES, 0, 3)),
      REFUSED(GL_INVALID_OPERATION, glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, nullptr)),
  };
  expect_refused(kMapped);
  glUnmapBufferOES(kArray);

  glMapBufferRangeEXT(kArray, 2, 4, kWrite | GL_MAP_FLUSH_EXPLICIT_BIT_EXT);
  const ErrorCase kRanges[] = {
      REFUSED(GL_INVALID_VALUE, glFlushMappedBufferRangeEXT(kArray, -1, 1)),
      REFUSED(GL_INVALID_VALUE, glFlushMappedBufferRangeEXT(kArray, 0, -1)),
      REFUSED(GL_INVALID_VALUE, glFlushMappedBufferRangeEXT(kArray, 2, 3)),
  };
  expect_refused(kRanges);
  glUnmapBufferOES(kArray);

  glMapBufferOES(GL_ELEMENT_ARRAY_BUFFER, GL_WRITE_ONLY_OES);
  const ErrorCase kIndices[] = {
      REFUSED(GL_INVALID_OPERATION, glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, nullptr))};
  expect_refused(kIndices);
  glUnmapBufferOES(GL_ELEMENT_ARRAY_BUFFER);
}

TEST_F(ObjectErrors, MappingWithoutABuffer) {
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  static void* pointer = nullptr;
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_OPERATION, glMapBufferOES(GL_ARRAY_BUFFER, GL_WRITE_ONLY_OES)),
      REFUSED(GL_INVALID_OPERATION,
              glMapBufferRangeEXT(GL_ARRAY_BUFFER, 0, 1, GL_MAP_WRITE_BIT_EXT)),
      REFUSED(GL_INVALID_OPERATION, glFlushMappedBufferRangeEXT(GL_ARRAY_BUFFER, 0, 1)),
      REFUSED(GL_INVALID_OPERATION, glUnmapBufferOES(GL_ARRAY_BUFFER)),
      REFUSED(GL_INVALID_OPERATION,
              glGetBufferPointervOES(GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER_OES, &pointer)),
  };
  expect_refused(kCases);
}

TEST_F(ObjectErrors, VertexArrayObjects) {
  GLuint array = 0;
  glGenVertexArraysOES(1, &array);
  glBindVertexArrayOES(array);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  const ErrorCase kCases[] = {
    REFUSED(GL_INVALID_OPERATION, glBindVertexArrayOES(77)),
    REFUSED(GL_INVALID_VALUE, GLuint n = 0; glGenVertexArraysOES(-1, &n)),
    REFUSED(GL_INVALID_VALUE, GLuint n = 0; glDeleteVertexArraysOES(-1, &n)),
    // Pointers to client memory.
    REFUSED(GL_INVALID_OPERATION, glVertexPointer(2, GL_FLOAT, 0, f)),
    REFUSED(GL_INVALID_OPERATION, glColorPointer(4, GL_FLOAT, 0, f)),
    REFUSED(GL_INVALID_OPERATION, glNormalPointer(GL_FLOAT, 0, f)),
    REFUSED(GL_INVALID_OPERATION, glTexCoordPointer(2, GL_FLOAT, 0, f)),
    REFUSED(GL_INVALID_OPERATION, glPointSizePointerOES(GL_FLOAT, 0, f)),
  };
  expect_refused(kCases);
}

}  // namespace
}  // namespace clearpipe::api
