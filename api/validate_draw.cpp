// Validators of vertex arrays, buffer objects, drawing and reading.
// SPDX-License-Identifier: MIT
#include "api/draw.h"
#include "api/framebuffer.h"
#include "api/pixel_format.h"
#include "api/validate.h"

namespace clearpipe::api::validate {

namespace {

// The last three arguments of a call that points to an array. The type was found good or not
// (table 2.4). A vertex array object holds no pointers to client memory (OES_vertex_array_object).
Invalid array_pointer(const Context& c, bool type, GLsizei stride, const void* pointer) {
  if (!type) return {GL_INVALID_ENUM, "{0} is no type of this array (2.8, table 2.4)"};
  if (stride < 0) return {GL_INVALID_VALUE, "{1} is negative (2.8)"};
  const ArraysState& a = c.state.arrays;
  return operation_unless(a.vertex_array == 0 || a.array_buffer || !pointer,
                          "{2} is in client memory, and a vertex array object is bound "
                          "(OES_vertex_array_object)");
}

bool is_coordinate_type(GLenum type) {
  return type == GL_BYTE || type == GL_SHORT || type == GL_FIXED || type == GL_FLOAT;
}

// Mapped buffers are not drawn from (OES_mapbuffer).
Invalid drawn_arrays(const Context& c) {
  const ArraysState& a = c.state.arrays;
  bool any = false;
  visit_arrays(a, [&any](const ArrayState& array) {
    any = any || (array.enabled && array.buffer && array.buffer->mapped);
  });
  if (any) {
    return {GL_INVALID_OPERATION, "the buffer of an enabled array is mapped (OES_mapbuffer)"};
  }
  return drawn_framebuffer(c);
}

Invalid vertex_units(GLint size) {
  return value_unless(size >= 1 && size <= kVertexUnits,
                      "{0} is not in [1, MAX_VERTEX_UNITS_OES] (OES_matrix_palette, 2.8)");
}

Invalid primitive(GLenum mode) {
  return enum_unless(mode <= GL_TRIANGLE_FAN, "{0} is no kind of primitive (2.6.1)");
}

}  // namespace

Invalid client_state(const Context& c, GLenum array, bool) {
  return enum_unless(find_array(c.state.arrays, array) != nullptr, "{0} is no array (2.8)");
}

Invalid vertex_pointer(const Context& c, GLint size, GLenum type, GLsizei stride,
                       const void* pointer) {
  if (size < 2 || size > 4) {
    return {GL_INVALID_VALUE, "{0} is none of 2, 3 and 4 (2.8, table 2.4)"};
  }
  return array_pointer(c, is_coordinate_type(type), stride, pointer).from(1);
}

Invalid color_pointer(const Context& c, GLint size, GLenum type, GLsizei stride,
                      const void* pointer) {
  if (size != 4) return {GL_INVALID_VALUE, "{0} is not 4 (2.8, table 2.4)"};
  const bool good = type == GL_UNSIGNED_BYTE || type == GL_FIXED || type == GL_FLOAT;
  return array_pointer(c, good, stride, pointer).from(1);
}

Invalid normal_pointer(const Context& c, GLenum type, GLsizei stride, const void* pointer) {
  return array_pointer(c, is_coordinate_type(type), stride, pointer);
}

Invalid point_size_pointer(const Context& c, GLenum type, GLsizei stride, const void* pointer) {
  return array_pointer(c, type == GL_FIXED || type == GL_FLOAT, stride, pointer);
}

Invalid matrix_index_pointer(const Context& c, GLint size, GLenum type, GLsizei stride,
                             const void* pointer) {
  if (const Invalid wrong = vertex_units(size)) return wrong;
  return array_pointer(c, type == GL_UNSIGNED_BYTE, stride, pointer).from(1);
}

Invalid weight_pointer(const Context& c, GLint size, GLenum type, GLsizei stride,
                       const void* pointer) {
  if (const Invalid wrong = vertex_units(size)) return wrong;
  return array_pointer(c, type == GL_FIXED || type == GL_FLOAT, stride, pointer).from(1);
}

Invalid buffer_target(const Context&, GLenum target, GLuint) {
  return enum_unless(target == GL_ARRAY_BUFFER || target == GL_ELEMENT_ARRAY_BUFFER,
                     "{0} is neither ARRAY_BUFFER nor ELEMENT_ARRAY_BUFFER (2.9)");
}

Invalid buffer_data(const Context& c, GLenum target, GLsizeiptr size, const void*, GLenum usage) {
  if (const Invalid wrong = buffer_target(c, target, 0)) return wrong;
  if (usage != GL_STATIC_DRAW && usage != GL_DYNAMIC_DRAW) {
    return {GL_INVALID_ENUM, "{3} is neither STATIC_DRAW nor DYNAMIC_DRAW (2.9, table 2.5)"};
  }
  if (size < 0) return {GL_INVALID_VALUE, "{1} is negative (2.9, table 2.5)"};
  return operation_unless(bound_buffer(c, target) != nullptr, kNoBuffer);
}

Invalid buffer_sub_data(const Context& c, GLenum target, GLintptr offset, GLsizeiptr size,
                        const void*) {
  if (const Invalid wrong = buffer_target(c, target, 0)) return wrong;
  if (!bound_buffer(c, target)) return {GL_INVALID_OPERATION, kNoBuffer};
  if (bound_buffer(c, target)->mapped) return {GL_INVALID_OPERATION, kMapped};
  if (offset < 0 || size < 0) return {GL_INVALID_VALUE, "{1} or {2} is negative (2.9)"};
  const GLsizeiptr whole = static_cast<GLsizeiptr>(bound_buffer(c, target)->data->size());
  return value_unless(offset <= whole && size <= whole - offset,
                      "{1} with {2} reaches past the end of the buffer (2.9)");
}

Invalid clear(const Context& c, GLbitfield mask) {
  constexpr GLbitfield kAll = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
  if (mask & ~kAll) {
    return {GL_INVALID_VALUE,
            "{0} has bits other than those of the colour, depth and stencil buffers (4.2.3)"};
  }
  return drawn_framebuffer(c);
}

namespace {
// The first six arguments of calls that read pixels.
Invalid read_rectangle(const Context& c, GLsizei width, GLsizei height, GLenum format,
                       GLenum type) {
  if (width < 0 || height < 0) return {GL_INVALID_VALUE, "{2} or {3} is negative (4.3.1)"};
  if (!is_base_format(format) && format != GL_BGRA_EXT) {
    return {GL_INVALID_ENUM, "{4} is no format of pixels (3.6.2, table 3.3)"};
  }
  if (type != GL_UNSIGNED_BYTE && type != GL_UNSIGNED_SHORT_5_6_5 &&
      type != GL_UNSIGNED_SHORT_4_4_4_4 && type != GL_UNSIGNED_SHORT_5_5_5_1 &&
      type != GL_UNSIGNED_SHORT_4_4_4_4_REV_EXT && type != GL_UNSIGNED_SHORT_1_5_5_5_REV_EXT) {
    return {GL_INVALID_ENUM, "{5} is no type of pixels (3.6.2, table 3.2)"};
  }
  if (read_bytes(format, type) == 0) {
    return {GL_INVALID_OPERATION,
            "pixels are not read as {4} of {5}, but as RGBA of UNSIGNED_BYTE (4.3.1) or as BGRA "
            "(EXT_read_format_bgra)"};
  }
  if (const Invalid wrong = read_framebuffer(c)) return wrong;
  return operation_unless(type != GL_UNSIGNED_SHORT_5_6_5 || is_rgb565(read_target(c)),
                          "the surface has not the colours of {5}, and is read as RGBA of "
                          "UNSIGNED_BYTE or as BGRA (OES_read_format)");
}
}  // namespace

Invalid read_pixels(const Context& c, GLint, GLint, GLsizei width, GLsizei height, GLenum format,
                    GLenum type, const void* pixels) {
  if (const Invalid wrong = read_rectangle(c, width, height, format, type)) return wrong;
  return value_unless(pixels != nullptr, "{6} is no place to write to (4.3.1)");
}

Invalid read_n_pixels(const Context& c, GLint x, GLint y, GLsizei width, GLsizei height,
                      GLenum format, GLenum type, GLsizei size, const void* data) {
  if (const Invalid wrong = read_rectangle(c, width, height, format, type)) return wrong;
  if (size < bytes_read(c, width, height, format, type)) {
    return {GL_INVALID_OPERATION, "{6} is less than the pixels take (EXT_robustness, 4.3.1)"};
  }
  return read_pixels(c, x, y, width, height, format, type, data).from(1);
}

Invalid draw_arrays(const Context& c, GLenum mode, GLint first, GLsizei count) {
  if (const Invalid wrong = primitive(mode)) return wrong;
  if (first < 0 || count < 0) return {GL_INVALID_VALUE, "{1} or {2} is negative (2.8)"};
  return drawn_arrays(c);
}

Invalid draw_elements(const Context& c, GLenum mode, GLsizei count, GLenum type,
                      const void* indices) {
  if (const Invalid wrong = primitive(mode)) return wrong;
  if (type != GL_UNSIGNED_BYTE && type != GL_UNSIGNED_SHORT && type != GL_UNSIGNED_INT) {
    return {GL_INVALID_ENUM, "{2} is no type of indices (2.8, OES_element_index_uint)"};
  }
  if (count < 0) return {GL_INVALID_VALUE, "{1} is negative (2.8)"};
  if (const BufferPtr& buffer = c.state.arrays.element_array_buffer) {
    if (buffer->mapped) {
      return {GL_INVALID_OPERATION, "the buffer of the indices is mapped (OES_mapbuffer)"};
    }
    // Indices past the end of the store are never read.
    const size_t bytes = type == GL_UNSIGNED_BYTE ? 1 : type == GL_UNSIGNED_SHORT ? 2 : 4;
    const size_t offset = reinterpret_cast<uintptr_t>(indices), size = buffer->data->size();
    if (offset > size || static_cast<size_t>(count) > (size - offset) / bytes) {
      return {GL_INVALID_OPERATION,
              "{1} indices from {3} on reach past the end of the buffer (2.9)"};
    }
  }
  return drawn_arrays(c);
}

Invalid draw_texture(const Context& c, float, float, float, float width, float height) {
  if (!(width > 0)) return {GL_INVALID_VALUE, "{3} is not positive (OES_draw_texture)"};
  if (!(height > 0)) return {GL_INVALID_VALUE, "{4} is not positive (OES_draw_texture)"};
  return drawn_framebuffer(c);
}

// As so many single draws, those with nothing to draw left out; none is drawn if one may not be.
Invalid multi_draw_arrays(const Context& c, GLenum mode, const GLint* first, const GLsizei* count,
                          GLsizei n) {
  if (n < 0) return {GL_INVALID_VALUE, "{3} is negative (EXT_multi_draw_arrays)"};
  Invalid wrong = draw_arrays(c, mode, 0, 0);
  for (GLsizei i = 0; i < n && !wrong; ++i) {
    if (count[i] > 0) wrong = draw_arrays(c, mode, first[i], count[i]);
  }
  return wrong;
}

Invalid multi_draw_elements(const Context& c, GLenum mode, const GLsizei* count, GLenum type,
                            const void* const* indices, GLsizei n) {
  if (n < 0) return {GL_INVALID_VALUE, "{4} is negative (EXT_multi_draw_arrays)"};
  Invalid wrong = draw_elements(c, mode, 0, type, nullptr);
  for (GLsizei i = 0; i < n && !wrong; ++i) {
    if (count[i] > 0) wrong = draw_elements(c, mode, count[i], type, indices[i]);
  }
  return wrong;
}

}  // namespace clearpipe::api::validate
