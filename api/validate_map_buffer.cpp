// Validators of mapped buffer objects (OES_mapbuffer, EXT_map_buffer_range) and of vertex array
// objects (OES_vertex_array_object).
// SPDX-License-Identifier: MIT
#include "api/validate.h"

namespace clearpipe::api::validate {

namespace {

Invalid no_buffer(const Context& c, GLenum target) {
  return operation_unless(bound_buffer(c, target) != nullptr, kNoBuffer);
}

// A target with a buffer object that is mapped, or not.
Invalid mapped_state(const Context& c, GLenum target, bool mapped) {
  if (const Invalid wrong = buffer_target(c, target, 0)) return wrong;
  if (const Invalid wrong = no_buffer(c, target)) return wrong;
  return operation_unless(bound_buffer(c, target)->mapped == mapped,
                          mapped ? "the buffer of {0} is not mapped (OES_mapbuffer)" : kMapped);
}

Invalid range(GLintptr offset, GLsizeiptr length, size_t whole) {
  const GLsizeiptr size = static_cast<GLsizeiptr>(whole);
  if (offset < 0 || length < 0) {
    return {GL_INVALID_VALUE, "{0} or {1} is negative (EXT_map_buffer_range)"};
  }
  return value_unless(offset <= size && length <= size - offset,
                      "{0} with {1} reaches past the end (EXT_map_buffer_range)");
}

}  // namespace

Invalid map_buffer(const Context& c, GLenum target, GLenum access) {
  if (const Invalid wrong = buffer_target(c, target, 0)) return wrong;
  if (access != GL_WRITE_ONLY_OES) {
    return {GL_INVALID_ENUM, "{1} is not WRITE_ONLY_OES (OES_mapbuffer)"};
  }
  return mapped_state(c, target, false);
}

Invalid map_buffer_range(const Context& c, GLenum target, GLintptr offset, GLsizeiptr length,
                         GLbitfield access) {
  constexpr GLbitfield kDiscard = GL_MAP_INVALIDATE_RANGE_BIT_EXT |
                                  GL_MAP_INVALIDATE_BUFFER_BIT_EXT | GL_MAP_UNSYNCHRONIZED_BIT_EXT;
  constexpr GLbitfield kAll =
      GL_MAP_READ_BIT_EXT | GL_MAP_WRITE_BIT_EXT | GL_MAP_FLUSH_EXPLICIT_BIT_EXT | kDiscard;
  if (const Invalid wrong = buffer_target(c, target, 0)) return wrong;
  if (const Invalid wrong = no_buffer(c, target)) return wrong;
  if (const Invalid wrong = range(offset, length, bound_buffer(c, target)->data->size())) {
    return wrong.from(1);
  }
  if (access & ~kAll) {
    return {GL_INVALID_VALUE, "{3} has bits that are no flags of a mapping (EXT_map_buffer_range)"};
  }
  const bool reads = access & GL_MAP_READ_BIT_EXT, writes = access & GL_MAP_WRITE_BIT_EXT;
  if (length == 0) return {GL_INVALID_OPERATION, "{2} is zero (EXT_map_buffer_range)"};
  if (!reads && !writes) {
    return {GL_INVALID_OPERATION, "{3} neither reads nor writes (EXT_map_buffer_range)"};
  }
  if (reads && (access & kDiscard)) {
    return {GL_INVALID_OPERATION,
            "{3} reads what it invalidates or does not wait for (EXT_map_buffer_range)"};
  }
  if (!writes && (access & GL_MAP_FLUSH_EXPLICIT_BIT_EXT)) {
    return {GL_INVALID_OPERATION, "{3} flushes without writing (EXT_map_buffer_range)"};
  }
  return mapped_state(c, target, false);
}

Invalid flush_mapped_range(const Context& c, GLenum target, GLintptr offset, GLsizeiptr length) {
  if (const Invalid wrong = mapped_state(c, target, true)) return wrong;
  const BufferObject& buffer = *bound_buffer(c, target);
  if (!(buffer.map_access & GL_MAP_FLUSH_EXPLICIT_BIT_EXT)) {
    return {GL_INVALID_OPERATION,
            "the buffer of {0} is mapped without MAP_FLUSH_EXPLICIT_BIT_EXT "
            "(EXT_map_buffer_range)"};
  }
  return range(offset, length, buffer.map_length).from(1);
}

Invalid unmap_buffer(const Context& c, GLenum target) { return mapped_state(c, target, true); }

Invalid get_buffer_pointer(const Context& c, GLenum target, GLenum pname, void**) {
  if (const Invalid wrong = buffer_target(c, target, 0)) return wrong;
  if (pname != GL_BUFFER_MAP_POINTER_OES) {
    return {GL_INVALID_ENUM, "{1} is not BUFFER_MAP_POINTER_OES (OES_mapbuffer)"};
  }
  return no_buffer(c, target);
}

Invalid bind_vertex_array(const Context& c, GLuint name) {
  return operation_unless(name == 0 || c.vertex_arrays.contains(name),
                          "{0} is no name of GenVertexArraysOES (OES_vertex_array_object)");
}

}  // namespace clearpipe::api::validate
