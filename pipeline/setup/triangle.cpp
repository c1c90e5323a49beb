// Triangle setup: facing and culling (3.5.1), edges, box.
// SPDX-License-Identifier: MIT
#include "pipeline/setup/primitive.h"

namespace clearpipe::pipeline {

bool setup_triangle(const SetupState& state, const float* v0, const float* v1, const float* v2,
                    PrimitiveRecord& out) {
  const float* vertices[3] = {v0, v1, v2};
  SnappedPoint corners[3];
  for (int i = 0; i < 3; ++i) {
    const float* window = vertices[i] + vertex_record::kWindow;
    corners[i].x = snap(window[0] - 0.5f);
    corners[i].y = mirror(state, snap(window[1] - 0.5f));
    out.vertex[i] = vertices[i];
  }
  // Equation 3.4: the sign of the area decides the facing; no area, no pixels.
  const int64_t area =
      static_cast<int64_t>(corners[1].x - corners[0].x) * (corners[2].y - corners[0].y) -
      static_cast<int64_t>(corners[2].x - corners[0].x) * (corners[1].y - corners[0].y);
  if (area == 0) {
    return false;
  }
  const bool front = (area < 0) == state.raster.front_is_clockwise;
  switch (state.raster.cull) {
    case CullFace::kNone:
      break;
    case CullFace::kFront:
      if (front) return false;
      break;
    case CullFace::kBack:
      if (!front) return false;
      break;
    case CullFace::kFrontAndBack:
      return false;
  }
  out.kind = PrimitiveKind::kTriangle;
  out.back_facing = !front;
  return set_polygon(state, corners, 3, out);
}

}  // namespace clearpipe::pipeline
