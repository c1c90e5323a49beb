// The layout of vertex records, and the window coordinates of vertices that clipping made.
// SPDX-License-Identifier: MIT
#include <bit>

#include "pipeline/vertex/vertex_stage.h"

namespace clearpipe::pipeline {

VertexLayout make_vertex_layout(const VertexState& state) {
  VertexLayout layout;
  uint8_t next = vertex_record::kTexture;
  layout.texture_units = state.texture_units;
  for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
    if ((state.texture_units >> unit & 1) != 0) {
      layout.texture_offset[unit] = next;
      next = static_cast<uint8_t>(next + 4);
    }
  }
  if (state.lighting && state.two_sided) {
    layout.back_colour_offset = next;
    next = static_cast<uint8_t>(next + 4);
  }
  if (state.clip_planes != 0) {
    layout.clip_distance_offset = next;
    next = static_cast<uint8_t>(next + kMaxClipPlanes);
  }
  layout.stride = next;
  return layout;
}

// The divide, the scale and the translation each round once here (2.10.1). The reference projects
// the vertices of its clipper this way too, while its vertex stage rounds scale and translation
// together, as project-inl.h does; original vertices of a clipped primitive keep what they have.
void project_vertex(float* record, const Viewport& viewport) {
  const float* clip = record + vertex_record::kClip;
  float* window = record + vertex_record::kWindow;
  const float reciprocal_w = 1.0f / clip[3];
  window[0] = clip[0] * reciprocal_w * viewport.scale_x + viewport.centre_x;
  window[1] = clip[1] * reciprocal_w * viewport.scale_y + viewport.centre_y;
  window[2] = clip[2] * reciprocal_w * viewport.scale_z + viewport.centre_z;
  window[3] = reciprocal_w;
}

}  // namespace clearpipe::pipeline
