// Vertex array objects (OES_vertex_array_object): the state of the bound one is the context's,
// exchanged when another is bound.
// SPDX-License-Identifier: MIT
#include <utility>

#include "api/exec.h"

namespace clearpipe::api::exec {

namespace {

VertexArrayState& kept(Context& c, GLuint name) {
  return name == 0 ? c.default_vertex_array : *c.vertex_arrays.bind(name);
}

}  // namespace

void bind_vertex_array(Context& c, GLuint name) {
  ArraysState& a = c.state.arrays;
  if (name == a.vertex_array) return;
  VertexArrayState& next = kept(c, name);
  VertexArrayState& current = a;
  kept(c, a.vertex_array) = std::exchange(current, std::move(next));
  a.vertex_array = name;
  c.dirty |= kDirtyArrays;
}

void gen_vertex_arrays(Context& c, GLsizei n, GLuint* names) {
  for (GLsizei i = 0; i < n; ++i) names[i] = c.vertex_arrays.generate();
}

void delete_vertex_arrays(Context& c, GLsizei n, const GLuint* names) {
  for (GLsizei i = 0; i < n; ++i) {
    if (names[i] == 0) continue;
    if (names[i] == c.state.arrays.vertex_array) bind_vertex_array(c, 0);
    c.vertex_arrays.erase(names[i]);
  }
}

GLboolean is_vertex_array(Context& c, GLuint name) { return c.vertex_arrays.find(name) != nullptr; }

}  // namespace clearpipe::api::exec
