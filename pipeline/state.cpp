// Copying and comparing state: see state.h.
// SPDX-License-Identifier: MIT
#include "pipeline/state.h"

#include <cstddef>
#include <cstring>
#include <type_traits>

namespace clearpipe::pipeline {

void copy_vertex_state(const VertexState& from, VertexState& to) {
  static_assert(std::is_trivially_copyable_v<VertexState>);
  constexpr size_t kAlways = offsetof(VertexState, projection);
  std::memcpy(static_cast<void*>(&to), &from, kAlways);
  if (from.palette != nullptr) to.projection = from.projection;
  if (from.lighting) {
    to.scene_ambient = from.scene_ambient;
    to.material = from.material;
    for (size_t i = 0; i < from.lights.size(); ++i) {
      if (from.lights[i].enabled) {
        to.lights[i] = from.lights[i];
      } else {
        to.lights[i].enabled = false;
      }
    }
  }
  for (size_t u = 0; from.texture_matrix >> u != 0; ++u) {
    if ((from.texture_matrix >> u & 1) != 0) to.texture_matrices[u] = from.texture_matrices[u];
  }
  for (size_t i = 0; from.clip_planes >> i != 0; ++i) {
    if ((from.clip_planes >> i & 1) != 0) to.clip_plane[i] = from.clip_plane[i];
  }
}

bool FragmentState::operator==(const FragmentState& other) const {
  const FragmentOperations &mine = *this, &others = other;
  if (!(mine == others)) return false;
  for (size_t u = 0; u < unit.size(); ++u) {
    if (unit[u].enabled != other.unit[u].enabled) return false;
    if (unit[u].enabled && !(unit[u] == other.unit[u])) return false;
  }
  return true;
}

void copy_fragment_state(const FragmentState& from, FragmentState& to) {
  static_cast<FragmentOperations&>(to) = from;
  for (size_t u = 0; u < to.unit.size(); ++u) {
    if (from.unit[u].enabled) {
      to.unit[u] = from.unit[u];
    } else {
      to.unit[u].enabled = false;
      to.unit[u].image.reset();
    }
  }
}

}  // namespace clearpipe::pipeline
