// Clipping of the primitives that cross a clip plane (2.11), in homogeneous clip coordinates.
//
// Every plane that a primitive crosses cuts it, by Sutherland and Hodgman's method, in the order
// and with the arithmetic of the reference: the corners that clipping makes are snapped like
// others, so a different cut would cover different pixels along the edges that leave the view. The
// guard band comes last; it only keeps window coordinates inside the range of raster/edge.h.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "pipeline/exec/arena.h"
#include "pipeline/vertex/vertex_stage.h"

namespace clearpipe::pipeline {

struct ClipState {
  VertexLayout layout;
  Viewport viewport;
  GuardBand guard;
  bool flat_shade = false;
};

// The guard band of a viewport: the window range of raster/edge.h, in multiples of w.
GuardBand make_guard_band(const Viewport& viewport);

// Each plane adds a corner at most.
inline constexpr int kMaxPlanes = 10 + kMaxClipPlanes;
inline constexpr int kMaxClippedCorners = 3 + kMaxPlanes;

// Cuts the triangle v[0..2] against the planes in `planes` (a union of outcodes). Corners are
// written to `out`; new vertices come from `arena`. Returns their number, 0 when nothing is left.
// With flat shading every corner carries the colours of the provoking vertex v[2].
int clip_triangle(const ClipState& state, const float* const v[3], uint32_t planes, Arena& arena,
                  const float** out);

// Cuts a line, at both ends; false when nothing is left.
bool clip_line(const ClipState& state, const float* v[2], uint32_t planes, Arena& arena);

}  // namespace clearpipe::pipeline
