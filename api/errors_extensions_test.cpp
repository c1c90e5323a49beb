// Errors of the other extensions: draw_texture, multi_draw_arrays, debug output and labels, fences,
// robustness, EGL images, texture parameters and compressed formats.
// SPDX-License-Identifier: MIT
#include "api/context.h"
#include "api/error_cases.h"
#include "api/texture_tokens.h"

namespace clearpipe::api {
namespace {

class ExtensionErrors : public ErrorTest {
 protected:
  static void compressed(GLenum format, GLint level, GLsizei width, GLsizei height, GLint border,
                         GLsizei size) {
    glCompressedTexImage2D(k2D, level, format, width, height, border, size, f);
  }
  static void part(GLint level, GLint left, GLint bottom, GLsizei width, GLsizei height,
                   GLsizei size) {
    glCompressedTexSubImage2D(k2D, level, left, bottom, width, height,
                              GL_COMPRESSED_RGB_S3TC_DXT1_EXT, size, f);
  }
};

TEST_F(ExtensionErrors, DrawTexture) {
  static constexpr GLshort kShorts[] = {0, 0, 0, 0, 1};
  static constexpr GLint kIntegers[] = {0, 0, 0, 1, -1};
  static constexpr GLfloat kFloats[] = {0, 0, 0, 1, 0};
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_VALUE, glDrawTexsOES(0, 0, 0, -1, 1)),
      REFUSED(GL_INVALID_VALUE, glDrawTexsvOES(kShorts)),
      REFUSED(GL_INVALID_VALUE, glDrawTexiOES(0, 0, 0, 1, 0)),
      REFUSED(GL_INVALID_VALUE, glDrawTexivOES(kIntegers)),
      REFUSED(GL_INVALID_VALUE, glDrawTexxOES(0, 0, 0, 0, 0x10000)),
      REFUSED(GL_INVALID_VALUE, glDrawTexxvOES(kIntegers)),
      REFUSED(GL_INVALID_VALUE, glDrawTexfOES(0, 0, 0, 1, -0.5f)),
      REFUSED(GL_INVALID_VALUE, glDrawTexfvOES(kFloats)),
      REFUSED(GL_INVALID_ENUM, glTexParameterf(k2D, GL_TEXTURE_CROP_RECT_OES, 1)),
      REFUSED(GL_INVALID_ENUM, glTexParameteri(k2D, GL_TEXTURE_CROP_RECT_OES, 1)),
      REFUSED(GL_INVALID_ENUM, glTexParameterx(k2D, GL_TEXTURE_CROP_RECT_OES, 1)),
  };
  expect_refused(kCases);
}

TEST_F(ExtensionErrors, EglImages) {
  glBindRenderbufferOES(GL_RENDERBUFFER_OES, 7);
  glRenderbufferStorageOES(GL_RENDERBUFFER_OES, GL_DEPTH_COMPONENT24_OES, 2, 2);
  GLuint texture = 1;
  glGenTextures(1, &texture);
  glBindTexture(k2D, texture);
  glTexImage2D(k2D, 0, GL_ALPHA, 2, 2, 0, GL_ALPHA, GL_UNSIGNED_BYTE, nullptr);
  static char alpha_handle, depth_handle;
  static void* const alpha = &alpha_handle;
  static void* const depth = &depth_handle;
  Context* const context = current_context();
  ASSERT_EQ(create_egl_image(context, ImageSource::kTexture2D, texture, 0, alpha),
            ImageError::kNone);
  ASSERT_EQ(create_egl_image(context, ImageSource::kRenderbuffer, 7, 0, depth), ImageError::kNone);
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_ENUM, glEGLImageTargetTexture2DOES(GL_TEXTURE, alpha)),
      REFUSED(GL_INVALID_VALUE, glEGLImageTargetTexture2DOES(k2D, nullptr)),
      REFUSED(GL_INVALID_OPERATION, glEGLImageTargetTexture2DOES(k2D, depth)),
      REFUSED(GL_INVALID_ENUM, glEGLImageTargetRenderbufferStorageOES(k2D, depth)),
      REFUSED(GL_INVALID_VALUE,
              glEGLImageTargetRenderbufferStorageOES(GL_RENDERBUFFER_OES, nullptr)),
      REFUSED(GL_INVALID_OPERATION,
              glEGLImageTargetRenderbufferStorageOES(GL_RENDERBUFFER_OES, alpha)),
  };
  expect_refused(kCases);
  glBindRenderbufferOES(GL_RENDERBUFFER_OES, 0);
  const ErrorCase kUnbound[] = {
      REFUSED(GL_INVALID_OPERATION,
              glEGLImageTargetRenderbufferStorageOES(GL_RENDERBUFFER_OES, depth)),
  };
  expect_refused(kUnbound);
  destroy_egl_image(alpha);
  destroy_egl_image(depth);
}

// One draw that is wrong is enough, and none is drawn.
TEST_F(ExtensionErrors, MultiDraw) {
  static constexpr GLint kFirst[] = {0, -1};
  static constexpr GLsizei kCount[] = {3, 3}, kMany[] = {3, 9};
  static const void* const kIndices[] = {nullptr, nullptr};
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_VALUE, glMultiDrawArraysEXT(GL_TRIANGLES, kFirst, kCount, -1)),
      REFUSED(GL_INVALID_ENUM, glMultiDrawArraysEXT(7, kFirst, kCount, 1)),
      REFUSED(GL_INVALID_VALUE, glMultiDrawArraysEXT(GL_TRIANGLES, kFirst, kCount, 2)),
      REFUSED(GL_INVALID_VALUE,
              glMultiDrawElementsEXT(GL_TRIANGLES, kCount, GL_UNSIGNED_BYTE, kIndices, -1)),
      REFUSED(GL_INVALID_ENUM, glMultiDrawElementsEXT(7, kCount, GL_UNSIGNED_BYTE, kIndices, 1)),
      REFUSED(GL_INVALID_ENUM, glMultiDrawElementsEXT(GL_TRIANGLES, kCount, GL_SHORT, kIndices, 1)),
      REFUSED(GL_INVALID_OPERATION,
              glMultiDrawElementsEXT(GL_TRIANGLES, kMany, GL_UNSIGNED_BYTE, kIndices, 2)),
  };
  expect_refused(kCases);
}

TEST_F(ExtensionErrors, DebugOutput) {
  constexpr GLenum kApplication = GL_DEBUG_SOURCE_APPLICATION_KHR, kOther = GL_DEBUG_TYPE_OTHER_KHR,
                   kHigh = GL_DEBUG_SEVERITY_HIGH_KHR;
  static const std::string too_long(4096, 'x');
  static const GLuint id = 1;
  static void* pointer = &pointer;
  static const GLsync sync = glFenceSyncAPPLE(GL_SYNC_GPU_COMMANDS_COMPLETE_APPLE, 0);
  static GLsizei length = 7;
  static char text[] = "?";
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_ENUM,
              glDebugMessageInsertKHR(GL_DEBUG_SOURCE_API_KHR, kOther, 0, kHigh, 1, text)),
      REFUSED(GL_INVALID_ENUM, glDebugMessageInsertKHR(kApplication, GL_DEBUG_TYPE_PUSH_GROUP_KHR,
                                                       0, kHigh, 1, text)),
      REFUSED(GL_INVALID_ENUM, glDebugMessageInsertKHR(kApplication, kOther, 0, 0, 1, text)),
      REFUSED(GL_INVALID_VALUE,
              glDebugMessageInsertKHR(kApplication, kOther, 0, kHigh, -1, too_long.c_str())),
      REFUSED(GL_INVALID_VALUE,
              glDebugMessageInsertKHR(kApplication, kOther, 0, kHigh, 4096, text)),
      REFUSED(GL_INVALID_ENUM,
              glDebugMessageControlKHR(0, kOther, GL_DONT_CARE, 0, nullptr, GL_TRUE)),
      REFUSED(GL_INVALID_ENUM,
              glDebugMessageControlKHR(kApplication, 0, GL_DONT_CARE, 0, nullptr, GL_TRUE)),
      REFUSED(GL_INVALID_ENUM,
              glDebugMessageControlKHR(kApplication, kOther, 0, 0, nullptr, GL_TRUE)),
      REFUSED(GL_INVALID_VALUE,
              glDebugMessageControlKHR(kApplication, kOther, GL_DONT_CARE, -1, &id, GL_TRUE)),
      REFUSED(GL_INVALID_OPERATION,
              glDebugMessageControlKHR(GL_DONT_CARE, kOther, GL_DONT_CARE, 1, &id, GL_TRUE)),
      REFUSED(GL_INVALID_OPERATION,
              glDebugMessageControlKHR(kApplication, GL_DONT_CARE, GL_DONT_CARE, 1, &id, GL_TRUE)),
      REFUSED(GL_INVALID_OPERATION,
              glDebugMessageControlKHR(kApplication, kOther, kHigh, 1, &id, GL_TRUE)),
      REFUSED(GL_INVALID_VALUE,
              glGetDebugMessageLogKHR(1, -1, nullptr, nullptr, nullptr, nullptr, nullptr, text)),
      REFUSED(GL_INVALID_ENUM, glPushDebugGroupKHR(GL_DEBUG_SOURCE_API_KHR, 0, 1, text)),
      REFUSED(GL_INVALID_VALUE, glPushDebugGroupKHR(kApplication, 0, -1, too_long.c_str())),
      REFUSED(GL_STACK_UNDERFLOW, glPopDebugGroupKHR()),
      REFUSED(GL_INVALID_ENUM, glObjectLabelKHR(k2D, 1, 1, text)),
      REFUSED(GL_INVALID_VALUE, glObjectLabelKHR(GL_TEXTURE, 77, 1, text)),
      REFUSED(GL_INVALID_VALUE, glObjectLabelKHR(GL_SHADER_KHR, 1, 1, text)),
      REFUSED(GL_INVALID_VALUE, glObjectLabelKHR(GL_TEXTURE, 1, 256, too_long.c_str())),
      REFUSED(GL_INVALID_VALUE, glObjectLabelKHR(GL_TEXTURE, 1, -1, too_long.c_str())),
      REFUSED(GL_INVALID_ENUM, glGetObjectLabelKHR(k2D, 1, 1, &length, text)),
      REFUSED(GL_INVALID_VALUE, glGetObjectLabelKHR(GL_TEXTURE, 77, 1, &length, text)),
      REFUSED(GL_INVALID_VALUE, glGetObjectLabelKHR(GL_TEXTURE, 1, -1, &length, text)),
      REFUSED(GL_INVALID_VALUE, glObjectPtrLabelKHR(&id, 1, text)),
      REFUSED(GL_INVALID_VALUE, glObjectPtrLabelKHR(sync, 256, too_long.c_str())),
      REFUSED(GL_INVALID_VALUE, glGetObjectPtrLabelKHR(&id, 1, &length, text)),
      REFUSED(GL_INVALID_VALUE, glGetObjectPtrLabelKHR(sync, -1, &length, text)),
      REFUSED(GL_INVALID_ENUM, glGetPointervKHR(GL_DEBUG_OUTPUT_KHR, &pointer)),
  };
  expect_refused(kCases);
  EXPECT_STREQ(text, "?");
  EXPECT_EQ(length, 7);
  EXPECT_EQ(pointer, &pointer);
  for (int i = 1; i < 64; ++i) glPushDebugGroupKHR(kApplication, 0, 1, text);
  const ErrorCase kFull[] = {
      REFUSED(GL_STACK_OVERFLOW, glPushDebugGroupKHR(GL_DEBUG_SOURCE_APPLICATION_KHR, 0, 1, text))};
  expect_refused(kFull);
}

TEST_F(ExtensionErrors, Labels) {
  static GLsizei length = 7;
  static char text[] = "?";
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_ENUM, glLabelObjectEXT(GL_BUFFER_KHR, 1, 1, text)),
      REFUSED(GL_INVALID_OPERATION, glLabelObjectEXT(GL_TEXTURE, 77, 1, text)),
      REFUSED(GL_INVALID_OPERATION, glLabelObjectEXT(GL_VERTEX_ARRAY_OBJECT_EXT, 1, 1, text)),
      REFUSED(GL_INVALID_VALUE, glLabelObjectEXT(GL_TEXTURE, 1, -1, text)),
      REFUSED(GL_INVALID_ENUM, glGetObjectLabelEXT(k2D, 1, 1, &length, text)),
      REFUSED(GL_INVALID_OPERATION, glGetObjectLabelEXT(GL_TEXTURE, 77, 1, &length, text)),
      REFUSED(GL_INVALID_VALUE, glGetObjectLabelEXT(GL_TEXTURE, 1, -1, &length, text)),
  };
  expect_refused(kCases);
  EXPECT_STREQ(text, "?");
  EXPECT_EQ(length, 7);
}

TEST_F(ExtensionErrors, Fences) {
  static GLint status = 7;
  glSetFenceNV(1, GL_ALL_COMPLETED_NV);
  const ErrorCase kCases[] = {
    REFUSED(GL_INVALID_VALUE, GLuint n = 0; glGenFencesNV(-1, &n)),
    REFUSED(GL_INVALID_VALUE, GLuint n = 1; glDeleteFencesNV(-1, &n)),
    REFUSED(GL_INVALID_ENUM, glSetFenceNV(2, GL_FENCE_STATUS_NV)),
    REFUSED(GL_INVALID_OPERATION, EXPECT_TRUE(glTestFenceNV(2))),  // TRUE, as the text says
    REFUSED(GL_INVALID_OPERATION, glFinishFenceNV(2)),
    REFUSED(GL_INVALID_OPERATION, glGetFenceivNV(2, GL_FENCE_STATUS_NV, &status)),
    REFUSED(GL_INVALID_ENUM, glGetFenceivNV(1, GL_ALL_COMPLETED_NV, &status)),
  };
  expect_refused(kCases);
  EXPECT_TRUE(glIsFenceNV(1));
  EXPECT_FALSE(glIsFenceNV(2));
  EXPECT_EQ(status, 7);
}

TEST_F(ExtensionErrors, SyncObjects) {
  static constexpr GLenum kComplete = GL_SYNC_GPU_COMMANDS_COMPLETE_APPLE;
  static const GLsync sync = glFenceSyncAPPLE(kComplete, 0);
  static const auto none = reinterpret_cast<GLsync>(uintptr_t{77});
  static const auto far =
      reinterpret_cast<GLsync>(reinterpret_cast<uintptr_t>(sync) + (1ull << 32));
  static GLint value = 7;
  const auto wait = [](GLsync s, GLbitfield flags) {
    EXPECT_EQ(glClientWaitSyncAPPLE(s, flags, 0), GLenum{GL_WAIT_FAILED_APPLE});
  };
  static const auto client_wait = wait;
  const ErrorCase kCases[] = {
    REFUSED(GL_INVALID_ENUM, EXPECT_FALSE(glFenceSyncAPPLE(GL_SYNC_FENCE_APPLE, 0))),
    REFUSED(GL_INVALID_VALUE, EXPECT_FALSE(glFenceSyncAPPLE(kComplete, 1))),
    REFUSED(GL_INVALID_VALUE, glDeleteSyncAPPLE(none)),
    REFUSED(GL_INVALID_VALUE, glDeleteSyncAPPLE(far)),
    REFUSED(GL_INVALID_VALUE, client_wait(none, 0)),
    REFUSED(GL_INVALID_VALUE, client_wait(nullptr, 0)),
    REFUSED(GL_INVALID_VALUE, client_wait(sync, 2)),
    REFUSED(GL_INVALID_VALUE, glWaitSyncAPPLE(none, 0, GL_TIMEOUT_IGNORED_APPLE)),
    REFUSED(GL_INVALID_VALUE, glWaitSyncAPPLE(sync, 1, GL_TIMEOUT_IGNORED_APPLE)),
    REFUSED(GL_INVALID_VALUE, glWaitSyncAPPLE(sync, 0, 0)),
    REFUSED(GL_INVALID_VALUE, glGetSyncivAPPLE(none, GL_SYNC_STATUS_APPLE, 1, nullptr, &value)),
    REFUSED(GL_INVALID_ENUM, glGetSyncivAPPLE(sync, GL_SYNC_FENCE_APPLE, 1, nullptr, &value)),
    REFUSED(GL_INVALID_VALUE, glGetSyncivAPPLE(sync, GL_SYNC_STATUS_APPLE, -1, nullptr, &value)),
    REFUSED(GL_INVALID_ENUM, GLint64 wide = 0; glGetInteger64vAPPLE(GL_SYNC_STATUS_APPLE, &wide)),
    REFUSED(GL_INVALID_OPERATION, glLabelObjectEXT(GL_SYNC_OBJECT_APPLE, 77, 1, "?")),
  };
  expect_refused(kCases);
  EXPECT_TRUE(glIsSyncAPPLE(sync));
  EXPECT_FALSE(glIsSyncAPPLE(none));
  EXPECT_FALSE(glIsSyncAPPLE(far));
  EXPECT_EQ(value, 7);
}

TEST_F(ExtensionErrors, Robustness) {
  const auto read = [](GLsizei width, GLenum format, GLenum type, GLsizei size, void* data) {
    glReadnPixelsEXT(0, 0, width, 1, format, type, size, data);
  };
  static const auto read_n = read;
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_VALUE, read_n(-1, GL_RGBA, GL_UNSIGNED_BYTE, 64, x)),
      REFUSED(GL_INVALID_ENUM, read_n(1, GL_FLOAT, GL_UNSIGNED_BYTE, 64, x)),
      REFUSED(GL_INVALID_ENUM, read_n(1, GL_RGBA, GL_FLOAT, 64, x)),
      REFUSED(GL_INVALID_OPERATION, read_n(1, GL_RGB, GL_UNSIGNED_BYTE, 64, x)),
      REFUSED(GL_INVALID_OPERATION, read_n(4, GL_RGBA, GL_UNSIGNED_BYTE, 15, x)),
      REFUSED(GL_INVALID_OPERATION, read_n(4, GL_RGBA, GL_UNSIGNED_BYTE, -1, x)),
      REFUSED(GL_INVALID_OPERATION,
              glReadnPixelsEXT(0, 0, INT32_MAX, INT32_MAX, GL_RGBA, GL_UNSIGNED_BYTE, 64, x)),
      REFUSED(GL_INVALID_VALUE, read_n(4, GL_RGBA, GL_UNSIGNED_BYTE, 16, nullptr)),
      REFUSED(GL_INVALID_VALUE, glGetnUniformfvEXT(1, 0, 64, f)),
      REFUSED(GL_INVALID_VALUE, glGetnUniformivEXT(1, 0, 64, x)),
  };
  expect_refused(kCases);
}

TEST_F(ExtensionErrors, TextureParameters) {
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_VALUE, glTexParameteri(k2D, GL_TEXTURE_MAX_LEVEL_APPLE, -1)),
      REFUSED(GL_INVALID_VALUE, glTexParameterf(k2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 0.5f)),
      REFUSED(GL_INVALID_VALUE, glTexParameterx(k2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 0xffff)),
      REFUSED(GL_INVALID_ENUM,
              glTexEnvf(GL_TEXTURE_FILTER_CONTROL_EXT, GL_MAX_TEXTURE_LOD_BIAS_EXT, 1)),
      REFUSED(GL_INVALID_ENUM, glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_LOD_BIAS_EXT, 1)),
      REFUSED(GL_INVALID_ENUM,
              glGetTexEnvfv(GL_TEXTURE_FILTER_CONTROL_EXT, GL_TEXTURE_ENV_MODE, f)),
  };
  expect_refused(kCases);
}

// The first texture keeps its image; the second one gets a compressed image of 12x8.
TEST_F(ExtensionErrors, CompressedFormats) {
  constexpr GLenum kDxt1 = GL_COMPRESSED_RGB_S3TC_DXT1_EXT;
  constexpr GLenum kInvalidValue = GL_INVALID_VALUE, kInvalidOperation = GL_INVALID_OPERATION;
  const ErrorCase kImages[] = {
      REFUSED(kInvalidOperation, compressed(kDxt1, 0, 4, 4, 1, 8)),
      REFUSED(kInvalidOperation, compressed(GL_ETC1_RGB8_OES, 0, 4, 4, 1, 8)),
      REFUSED(kInvalidValue, compressed(kDxt1, -1, 4, 4, 0, 8)),
      REFUSED(kInvalidValue, compressed(kDxt1, 15, 4, 4, 0, 8)),
      REFUSED(kInvalidValue, compressed(kDxt1, 0, -4, 4, 0, 8)),
      REFUSED(kInvalidValue, compressed(kDxt1, 0, 4, 16388, 0, 8)),
      REFUSED(kInvalidValue, compressed(kDxt1, 0, 4, 4, 0, 7)),
      REFUSED(kInvalidValue, compressed(kDxt1, 0, 4, 4, 0, -8)),
      REFUSED(kInvalidValue, compressed(GL_ETC1_RGB8_OES, 0, 5, 4, 0, 8)),
      REFUSED(kInvalidValue, compressed(GL_COMPRESSED_RGBA_S3TC_DXT5_ANGLE, 0, 4, 4, 0, 8)),
      REFUSED(kInvalidOperation, compressed(GL_COMPRESSED_RGBA_S3TC_DXT3_ANGLE, 0, 3, 4, 0, 16)),
      REFUSED(kInvalidOperation, compressed(GL_COMPRESSED_RGBA_S3TC_DXT5_ANGLE, 0, 4, 6, 0, 32)),
      REFUSED(kInvalidValue, glCompressedTexImage2D(k2D, 0, kDxt1, 4, 4, 0, 8, nullptr)),
      REFUSED(kInvalidOperation,
              glTexImage2D(k2D, 0, kDxt1, 4, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr)),
      REFUSED(kInvalidOperation, glCopyTexImage2D(k2D, 0, kDxt1, 0, 0, 4, 4, 0)),
      REFUSED(kInvalidOperation, part(0, 0, 0, 4, 4, 8)),  // it has another format
  };
  expect_refused(kImages);

  glBindTexture(k2D, 2);
  const std::vector<GLubyte> data(48);
  glCompressedTexImage2D(k2D, 0, kDxt1, 12, 8, 0, 48, data.data());
  const ErrorCase kParts[] = {
      REFUSED(kInvalidValue, part(-1, 0, 0, 4, 4, 8)),
      REFUSED(kInvalidValue, part(15, 0, 0, 4, 4, 8)),
      REFUSED(kInvalidOperation, part(1, 0, 0, 4, 4, 8)),
      REFUSED(kInvalidValue, part(0, -4, 0, 4, 4, 8)),
      REFUSED(kInvalidValue, part(0, 12, 0, 4, 4, 8)),
      REFUSED(kInvalidValue, part(0, 0, 4, 4, 8, 16)),
      REFUSED(kInvalidValue, part(0, 0, 0, -4, 4, 8)),
      REFUSED(kInvalidOperation, part(0, 2, 0, 4, 4, 8)),
      REFUSED(kInvalidOperation, part(0, 0, 0, 4, 2, 8)),
      REFUSED(kInvalidValue, part(0, 0, 0, 4, 4, 16)),
      REFUSED(kInvalidOperation, glTexSubImage2D(k2D, 0, 0, 0, 4, 4, GL_RGB, GL_UNSIGNED_BYTE, f)),
      REFUSED(kInvalidOperation, glCopyTexSubImage2D(k2D, 0, 0, 0, 0, 0, 4, 4)),
      REFUSED(kInvalidOperation, glGenerateMipmapOES(k2D)),
  };
  expect_refused(kParts);
}

}  // namespace
}  // namespace clearpipe::api
