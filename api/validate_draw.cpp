// Validators of vertex arrays, buffer objects, drawing and reading.
// SPDX-License-Identifier: MIT
#include "api/pixel_format.h"
#include "api/validate.h"

namespace clearpipe::api::validate {

namespace {

GLenum framebuffer(const pipeline::Target& target) {
  return target.colour || target.depth_stencil ? GL_NO_ERROR : GL_INVALID_FRAMEBUFFER_OPERATION_OES;
}

const BufferPtr& bound(const Context& c, GLenum target) {
  return target == GL_ARRAY_BUFFER ? c.state.arrays.array_buffer
                                   : c.state.arrays.element_array_buffer;
}

}  // namespace

GLenum client_state(const Context&, GLenum array, bool) {
  switch (array) {
    case GL_VERTEX_ARRAY:
    case GL_NORMAL_ARRAY:
    case GL_COLOR_ARRAY:
    case GL_TEXTURE_COORD_ARRAY:
    case GL_POINT_SIZE_ARRAY_OES:
      return GL_NO_ERROR;
    default:
      return GL_INVALID_ENUM;
  }
}

GLenum vertex_pointer(const Context&, GLint size, GLenum type, GLsizei stride, const void*) {
  if (size < 2 || size > 4 || stride < 0) return GL_INVALID_VALUE;
  if (type != GL_BYTE && type != GL_SHORT && type != GL_FIXED && type != GL_FLOAT) {
    return GL_INVALID_ENUM;
  }
  return GL_NO_ERROR;
}

GLenum color_pointer(const Context&, GLint size, GLenum type, GLsizei stride, const void*) {
  if (size != 4 || stride < 0) return GL_INVALID_VALUE;
  if (type != GL_UNSIGNED_BYTE && type != GL_FIXED && type != GL_FLOAT) return GL_INVALID_ENUM;
  return GL_NO_ERROR;
}

GLenum normal_pointer(const Context& c, GLenum type, GLsizei stride, const void* pointer) {
  return vertex_pointer(c, 3, type, stride, pointer);
}

GLenum point_size_pointer(const Context&, GLenum type, GLsizei stride, const void*) {
  if (type != GL_FIXED && type != GL_FLOAT) return GL_INVALID_ENUM;
  return stride < 0 ? GL_INVALID_VALUE : GL_NO_ERROR;
}

GLenum buffer_target(const Context&, GLenum target, GLuint) {
  return target == GL_ARRAY_BUFFER || target == GL_ELEMENT_ARRAY_BUFFER ? GL_NO_ERROR
                                                                        : GL_INVALID_ENUM;
}

GLenum buffer_data(const Context& c, GLenum target, GLsizeiptr size, const void*, GLenum usage) {
  if (buffer_target(c, target, 0) != GL_NO_ERROR) return GL_INVALID_ENUM;
  if (usage != GL_STATIC_DRAW && usage != GL_DYNAMIC_DRAW) return GL_INVALID_ENUM;
  if (size < 0) return GL_INVALID_VALUE;
  return bound(c, target) ? GL_NO_ERROR : GL_INVALID_OPERATION;
}

GLenum buffer_sub_data(const Context& c, GLenum target, GLintptr offset, GLsizeiptr size,
                       const void*) {
  if (buffer_target(c, target, 0) != GL_NO_ERROR) return GL_INVALID_ENUM;
  if (!bound(c, target)) return GL_INVALID_OPERATION;
  const GLsizeiptr whole = static_cast<GLsizeiptr>(bound(c, target)->data->size());
  return offset < 0 || size < 0 || offset > whole || size > whole - offset ? GL_INVALID_VALUE
                                                                           : GL_NO_ERROR;
}

GLenum clear(const Context& c, GLbitfield mask) {
  constexpr GLbitfield kAll = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
  return mask & ~kAll ? GL_INVALID_VALUE : framebuffer(c.draw);
}

GLenum read_pixels(const Context& c, GLint, GLint, GLsizei width, GLsizei height, GLenum format,
                   GLenum type, const void* pixels) {
  if (width < 0 || height < 0) return GL_INVALID_VALUE;
  if (!is_base_format(format) && format != GL_BGRA_EXT) return GL_INVALID_ENUM;
  if (type != GL_UNSIGNED_BYTE && type != GL_UNSIGNED_SHORT_5_6_5 &&
      type != GL_UNSIGNED_SHORT_4_4_4_4 && type != GL_UNSIGNED_SHORT_5_5_5_1 &&
      type != GL_UNSIGNED_SHORT_4_4_4_4_REV_EXT && type != GL_UNSIGNED_SHORT_1_5_5_5_REV_EXT) {
    return GL_INVALID_ENUM;
  }
  if (read_bytes(format, type) == 0) return GL_INVALID_OPERATION;
  if (!c.read.colour) return GL_INVALID_FRAMEBUFFER_OPERATION_OES;
  return pixels ? GL_NO_ERROR : GL_INVALID_VALUE;
}

GLenum draw_arrays(const Context& c, GLenum mode, GLint first, GLsizei count) {
  if (mode > GL_TRIANGLE_FAN) return GL_INVALID_ENUM;
  if (first < 0 || count < 0) return GL_INVALID_VALUE;
  return framebuffer(c.draw);
}

GLenum draw_elements(const Context& c, GLenum mode, GLsizei count, GLenum type,
                     const void* indices) {
  if (mode > GL_TRIANGLE_FAN) return GL_INVALID_ENUM;
  if (type != GL_UNSIGNED_BYTE && type != GL_UNSIGNED_SHORT && type != GL_UNSIGNED_INT) {
    return GL_INVALID_ENUM;
  }
  if (count < 0) return GL_INVALID_VALUE;
  if (const BufferPtr& buffer = c.state.arrays.element_array_buffer) {
    // Indices past the end of the store are never read.
    const size_t bytes = type == GL_UNSIGNED_BYTE ? 1 : type == GL_UNSIGNED_SHORT ? 2 : 4;
    const size_t offset = reinterpret_cast<uintptr_t>(indices), size = buffer->data->size();
    if (offset > size || static_cast<size_t>(count) > (size - offset) / bytes) {
      return GL_INVALID_OPERATION;
    }
  }
  return framebuffer(c.draw);
}

}  // namespace clearpipe::api::validate
