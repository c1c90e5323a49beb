// Mapped buffer objects (OES_mapbuffer, EXT_map_buffer_range): the application writes into the
// store itself. A store that an unfinished frame reads is replaced by a copy before, even where the
// application asks for no synchronisation: a frame never sees data move.
// SPDX-License-Identifier: MIT
#include <new>

#include "api/exec.h"

namespace clearpipe::api::exec {

namespace {

BufferObject& bound(Context& c, GLenum target) {
  ArraysState& a = c.state.arrays;
  return *(target == GL_ARRAY_BUFFER ? a.array_buffer : a.element_array_buffer);
}

void* pointer_of(const BufferObject& buffer) {
  return buffer.mapped ? buffer.data->data() + buffer.map_offset : nullptr;
}

}  // namespace

void* map_buffer(Context& c, GLenum target, GLenum) {
  const size_t size = bound(c, target).data->size();
  if (size == 0) throw std::bad_alloc();  // there is no address to give
  return map_buffer_range(c, target, 0, static_cast<GLsizeiptr>(size), GL_MAP_WRITE_BIT_EXT);
}

void* map_buffer_range(Context& c, GLenum target, GLintptr offset, GLsizeiptr length,
                       GLbitfield access) {
  BufferObject& buffer = bound(c, target);
  if ((access & GL_MAP_WRITE_BIT_EXT) && !may_write_in_place(c, buffer.uses, buffer.data->size())) {
    buffer.data = std::make_shared<pipeline::BufferData>(*buffer.data);
    ++c.share->buffers_version;
    buffer.uses.clear();
  }
  buffer.mapped = true;
  buffer.map_access = access;
  buffer.map_offset = static_cast<size_t>(offset);
  buffer.map_length = static_cast<size_t>(length);
  return pointer_of(buffer);
}

// What was written is in the store already.
void flush_mapped_range(Context&, GLenum, GLintptr, GLsizeiptr) {}

GLboolean unmap_buffer(Context& c, GLenum target) {
  bound(c, target).mapped = false;
  return GL_TRUE;  // the store is never lost
}

void get_buffer_pointer(Context& c, GLenum target, GLenum, void** params) {
  *params = pointer_of(bound(c, target));
}

}  // namespace clearpipe::api::exec
