// Validators of mapped buffer objects (OES_mapbuffer, EXT_map_buffer_range) and of vertex array
// objects (OES_vertex_array_object).
// SPDX-License-Identifier: MIT
#include "api/validate.h"

namespace clearpipe::api::validate {

namespace {

// A target with a buffer object that is mapped, or not.
GLenum mapped_state(const Context& c, GLenum target, bool mapped) {
  if (const GLenum error = buffer_target(c, target, 0)) return error;
  const BufferPtr& buffer = bound_buffer(c, target);
  return buffer && buffer->mapped == mapped ? GL_NO_ERROR : GL_INVALID_OPERATION;
}

bool inside(GLintptr offset, GLsizeiptr length, size_t whole) {
  const GLsizeiptr size = static_cast<GLsizeiptr>(whole);
  return offset >= 0 && length >= 0 && offset <= size && length <= size - offset;
}

}  // namespace

GLenum map_buffer(const Context& c, GLenum target, GLenum access) {
  if (const GLenum error = buffer_target(c, target, 0)) return error;
  return access == GL_WRITE_ONLY_OES ? mapped_state(c, target, false) : GL_INVALID_ENUM;
}

GLenum map_buffer_range(const Context& c, GLenum target, GLintptr offset, GLsizeiptr length,
                        GLbitfield access) {
  if (const GLenum error = buffer_target(c, target, 0)) return error;
  constexpr GLbitfield kInvalidate = GL_MAP_INVALIDATE_RANGE_BIT_EXT |
                                     GL_MAP_INVALIDATE_BUFFER_BIT_EXT |
                                     GL_MAP_UNSYNCHRONIZED_BIT_EXT;
  constexpr GLbitfield kAll =
      GL_MAP_READ_BIT_EXT | GL_MAP_WRITE_BIT_EXT | GL_MAP_FLUSH_EXPLICIT_BIT_EXT | kInvalidate;
  const BufferPtr& buffer = bound_buffer(c, target);
  if (!buffer) return GL_INVALID_OPERATION;
  if ((access & ~kAll) || !inside(offset, length, buffer->data->size())) return GL_INVALID_VALUE;
  const bool reads = access & GL_MAP_READ_BIT_EXT, writes = access & GL_MAP_WRITE_BIT_EXT;
  const bool good = length != 0 && (reads || writes) && !(reads && (access & kInvalidate)) &&
                    (writes || !(access & GL_MAP_FLUSH_EXPLICIT_BIT_EXT));
  return good ? mapped_state(c, target, false) : GL_INVALID_OPERATION;
}

GLenum flush_mapped_range(const Context& c, GLenum target, GLintptr offset, GLsizeiptr length) {
  if (const GLenum error = mapped_state(c, target, true)) return error;
  const BufferObject& buffer = *bound_buffer(c, target);
  if (!(buffer.map_access & GL_MAP_FLUSH_EXPLICIT_BIT_EXT)) return GL_INVALID_OPERATION;
  return inside(offset, length, buffer.map_length) ? GL_NO_ERROR : GL_INVALID_VALUE;
}

GLenum unmap_buffer(const Context& c, GLenum target) { return mapped_state(c, target, true); }

GLenum get_buffer_pointer(const Context& c, GLenum target, GLenum pname, void**) {
  if (buffer_target(c, target, 0) != GL_NO_ERROR || pname != GL_BUFFER_MAP_POINTER_OES) {
    return GL_INVALID_ENUM;
  }
  return bound_buffer(c, target) ? GL_NO_ERROR : GL_INVALID_OPERATION;
}

GLenum bind_vertex_array(const Context& c, GLuint name) {
  return name == 0 || c.vertex_arrays.contains(name) ? GL_NO_ERROR : GL_INVALID_OPERATION;
}

}  // namespace clearpipe::api::validate
