// Validators of vertex arrays, buffer objects, drawing and reading.
// SPDX-License-Identifier: MIT
#include "api/framebuffer.h"
#include "api/pixel_format.h"
#include "api/validate.h"

namespace clearpipe::api::validate {

namespace {

// A vertex array object holds no pointers to client memory (OES_vertex_array_object).
GLenum array_pointer(const Context& c, const void* pointer) {
  const ArraysState& a = c.state.arrays;
  return a.vertex_array != 0 && !a.array_buffer && pointer ? GL_INVALID_OPERATION : GL_NO_ERROR;
}

// Mapped buffers are not drawn from (OES_mapbuffer).
GLenum arrays_error(const Context& c) {
  const ArraysState& a = c.state.arrays;
  const auto mapped = [](const ArrayState& array) {
    return array.enabled && array.buffer && array.buffer->mapped;
  };
  bool any = false;
  for (const ArrayState* array : {&a.vertex, &a.normal, &a.colour, &a.point_size}) {
    any = any || mapped(*array);
  }
  for (const ArrayState& array : a.tex_coord) any = any || mapped(array);
  return any ? GL_INVALID_OPERATION : draw_framebuffer_error(c);
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

GLenum vertex_pointer(const Context& c, GLint size, GLenum type, GLsizei stride,
                      const void* pointer) {
  if (size < 2 || size > 4 || stride < 0) return GL_INVALID_VALUE;
  if (type != GL_BYTE && type != GL_SHORT && type != GL_FIXED && type != GL_FLOAT) {
    return GL_INVALID_ENUM;
  }
  return array_pointer(c, pointer);
}

GLenum color_pointer(const Context& c, GLint size, GLenum type, GLsizei stride,
                     const void* pointer) {
  if (size != 4 || stride < 0) return GL_INVALID_VALUE;
  if (type != GL_UNSIGNED_BYTE && type != GL_FIXED && type != GL_FLOAT) return GL_INVALID_ENUM;
  return array_pointer(c, pointer);
}

GLenum normal_pointer(const Context& c, GLenum type, GLsizei stride, const void* pointer) {
  return vertex_pointer(c, 3, type, stride, pointer);
}

GLenum point_size_pointer(const Context& c, GLenum type, GLsizei stride, const void* pointer) {
  if (type != GL_FIXED && type != GL_FLOAT) return GL_INVALID_ENUM;
  return stride < 0 ? GL_INVALID_VALUE : array_pointer(c, pointer);
}

GLenum buffer_target(const Context&, GLenum target, GLuint) {
  return target == GL_ARRAY_BUFFER || target == GL_ELEMENT_ARRAY_BUFFER ? GL_NO_ERROR
                                                                        : GL_INVALID_ENUM;
}

GLenum buffer_data(const Context& c, GLenum target, GLsizeiptr size, const void*, GLenum usage) {
  if (buffer_target(c, target, 0) != GL_NO_ERROR) return GL_INVALID_ENUM;
  if (usage != GL_STATIC_DRAW && usage != GL_DYNAMIC_DRAW) return GL_INVALID_ENUM;
  if (size < 0) return GL_INVALID_VALUE;
  return bound_buffer(c, target) ? GL_NO_ERROR : GL_INVALID_OPERATION;
}

GLenum buffer_sub_data(const Context& c, GLenum target, GLintptr offset, GLsizeiptr size,
                       const void*) {
  if (buffer_target(c, target, 0) != GL_NO_ERROR) return GL_INVALID_ENUM;
  if (!bound_buffer(c, target) || bound_buffer(c, target)->mapped) return GL_INVALID_OPERATION;
  const GLsizeiptr whole = static_cast<GLsizeiptr>(bound_buffer(c, target)->data->size());
  return offset < 0 || size < 0 || offset > whole || size > whole - offset ? GL_INVALID_VALUE
                                                                           : GL_NO_ERROR;
}

GLenum clear(const Context& c, GLbitfield mask) {
  constexpr GLbitfield kAll = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
  return mask & ~kAll ? GL_INVALID_VALUE : draw_framebuffer_error(c);
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
  if (const GLenum error = read_framebuffer_error(c)) return error;
  return pixels ? GL_NO_ERROR : GL_INVALID_VALUE;
}

GLenum draw_arrays(const Context& c, GLenum mode, GLint first, GLsizei count) {
  if (mode > GL_TRIANGLE_FAN) return GL_INVALID_ENUM;
  if (first < 0 || count < 0) return GL_INVALID_VALUE;
  return arrays_error(c);
}

GLenum draw_elements(const Context& c, GLenum mode, GLsizei count, GLenum type,
                     const void* indices) {
  if (mode > GL_TRIANGLE_FAN) return GL_INVALID_ENUM;
  if (type != GL_UNSIGNED_BYTE && type != GL_UNSIGNED_SHORT && type != GL_UNSIGNED_INT) {
    return GL_INVALID_ENUM;
  }
  if (count < 0) return GL_INVALID_VALUE;
  if (const BufferPtr& buffer = c.state.arrays.element_array_buffer) {
    if (buffer->mapped) return GL_INVALID_OPERATION;
    // Indices past the end of the store are never read.
    const size_t bytes = type == GL_UNSIGNED_BYTE ? 1 : type == GL_UNSIGNED_SHORT ? 2 : 4;
    const size_t offset = reinterpret_cast<uintptr_t>(indices), size = buffer->data->size();
    if (offset > size || static_cast<size_t>(count) > (size - offset) / bytes) {
      return GL_INVALID_OPERATION;
    }
  }
  return arrays_error(c);
}

// As so many single draws, those with nothing to draw left out; none is drawn if one may not be.
GLenum multi_draw_arrays(const Context& c, GLenum mode, const GLint* first, const GLsizei* count,
                         GLsizei n) {
  if (n < 0) return GL_INVALID_VALUE;
  GLenum error = draw_arrays(c, mode, 0, 0);
  for (GLsizei i = 0; i < n && error == GL_NO_ERROR; ++i) {
    if (count[i] > 0) error = draw_arrays(c, mode, first[i], count[i]);
  }
  return error;
}

GLenum multi_draw_elements(const Context& c, GLenum mode, const GLsizei* count, GLenum type,
                           const void* const* indices, GLsizei n) {
  if (n < 0) return GL_INVALID_VALUE;
  GLenum error = draw_elements(c, mode, 0, type, nullptr);
  for (GLsizei i = 0; i < n && error == GL_NO_ERROR; ++i) {
    if (count[i] > 0) error = draw_elements(c, mode, count[i], type, indices[i]);
  }
  return error;
}

}  // namespace clearpipe::api::validate
