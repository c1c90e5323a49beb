// Vertex arrays (2.8) and buffer objects (2.9).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>

#include "api/exec.h"

namespace clearpipe::api {

const ArrayState* find_array(const ArraysState& a, GLenum name) {
  switch (name) {
    case GL_VERTEX_ARRAY:
      return &a.vertex;
    case GL_NORMAL_ARRAY:
      return &a.normal;
    case GL_COLOR_ARRAY:
      return &a.colour;
    case GL_POINT_SIZE_ARRAY_OES:
      return &a.point_size;
    case GL_TEXTURE_COORD_ARRAY:
      return &a.tex_coord[static_cast<size_t>(a.client_active_texture)];
    case GL_MATRIX_INDEX_ARRAY_OES:
      return &a.matrix_index;
    case GL_WEIGHT_ARRAY_OES:
      return &a.weight;
    default:
      return nullptr;
  }
}

ArrayState* find_array(ArraysState& a, GLenum name) {
  return const_cast<ArrayState*>(find_array(static_cast<const ArraysState&>(a), name));
}

}  // namespace clearpipe::api

namespace clearpipe::api::exec {

namespace {

void set_pointer(Context& c, GLenum which, GLint size, GLenum type, GLsizei stride,
                 const void* pointer) {
  ArrayState& a = *find_array(c.state.arrays, which);
  a.size = size;
  a.type = type;
  a.stride = stride;
  a.pointer = pointer;
  a.buffer = c.state.arrays.array_buffer;
  c.dirty |= kDirtyArrays;
}

BufferPtr& binding(Context& c, GLenum target) {
  ArraysState& a = c.state.arrays;
  return target == GL_ARRAY_BUFFER ? a.array_buffer : a.element_array_buffer;
}

}  // namespace

void client_active_texture(Context& c, GLenum texture) {
  c.state.arrays.client_active_texture = static_cast<GLint>(texture - GL_TEXTURE0);
}

void client_state(Context& c, GLenum array, bool value) {
  find_array(c.state.arrays, array)->enabled = value;
  c.dirty |= kDirtyArrays;
}

void vertex_pointer(Context& c, GLint size, GLenum type, GLsizei stride, const void* pointer) {
  set_pointer(c, GL_VERTEX_ARRAY, size, type, stride, pointer);
}

void color_pointer(Context& c, GLint size, GLenum type, GLsizei stride, const void* pointer) {
  set_pointer(c, GL_COLOR_ARRAY, size, type, stride, pointer);
}

void normal_pointer(Context& c, GLenum type, GLsizei stride, const void* pointer) {
  set_pointer(c, GL_NORMAL_ARRAY, 3, type, stride, pointer);
}

void tex_coord_pointer(Context& c, GLint size, GLenum type, GLsizei stride, const void* pointer) {
  set_pointer(c, GL_TEXTURE_COORD_ARRAY, size, type, stride, pointer);
}

void point_size_pointer(Context& c, GLenum type, GLsizei stride, const void* pointer) {
  set_pointer(c, GL_POINT_SIZE_ARRAY_OES, 1, type, stride, pointer);
}

void matrix_index_pointer(Context& c, GLint size, GLenum type, GLsizei stride,
                          const void* pointer) {
  set_pointer(c, GL_MATRIX_INDEX_ARRAY_OES, size, type, stride, pointer);
}

void weight_pointer(Context& c, GLint size, GLenum type, GLsizei stride, const void* pointer) {
  set_pointer(c, GL_WEIGHT_ARRAY_OES, size, type, stride, pointer);
}

void bind_buffer(Context& c, GLenum target, GLuint name) {
  binding(c, target) = name == 0 ? nullptr : c.share->buffers.bind(name);
}

void gen_buffers(Context& c, GLsizei n, GLuint* names) {
  for (GLsizei i = 0; i < n; ++i) names[i] = c.share->buffers.generate();
}

void delete_buffers(Context& c, GLsizei n, const GLuint* names) {
  ArraysState& a = c.state.arrays;
  c.dirty |= kDirtyArrays;
  for (GLsizei i = 0; i < n; ++i) {
    const BufferPtr buffer = c.share->buffers.find(names[i]);
    c.share->buffers.erase(names[i]);
    if (!buffer) continue;
    buffer->mapped = false;
    if (a.array_buffer == buffer) a.array_buffer = nullptr;
    if (a.element_array_buffer == buffer) a.element_array_buffer = nullptr;
    // Arrays that lie in the buffer become arrays at address zero: nothing is drawn from them.
    visit_arrays(a, [&buffer](ArrayState& array) {
      if (array.buffer != buffer) return;
      array.buffer = nullptr;
      array.pointer = nullptr;
    });
  }
}

GLboolean is_buffer(Context& c, GLuint name) { return c.share->buffers.find(name) != nullptr; }

void buffer_data(Context& c, GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
  auto store = std::make_shared<pipeline::BufferData>(static_cast<size_t>(size));
  if (data && size != 0) {
    std::memcpy(store->data(), data, store->size());
  } else {
    std::fill(store->begin(), store->end(), std::byte{0});
  }
  BufferObject& buffer = *binding(c, target);
  buffer.data = std::move(store);
  ++c.share->buffers_version;
  buffer.uses.clear();
  buffer.usage = usage;
  buffer.mapped = false;  // a new store is not mapped
}

void buffer_sub_data(Context& c, GLenum target, GLintptr offset, GLsizeiptr size,
                     const void* data) {
  BufferObject& buffer = *binding(c, target);
  if (size == 0 || !data) return;
  if (!may_write_in_place(c, buffer.uses, buffer.data->size())) {
    buffer.data = std::make_shared<pipeline::BufferData>(*buffer.data);
    ++c.share->buffers_version;
    buffer.uses.clear();
  }
  std::memcpy(buffer.data->data() + offset, data, static_cast<size_t>(size));
}

}  // namespace clearpipe::api::exec
