// Edge functions: the half planes whose intersection is a primitive (3.5.1).
//
// Window positions are snapped to 1/256 pixel, as llvmpipe does, so an edge function is exact
// integer arithmetic. Its value at a place of pixel (i, j), (dx, dy) subpixels from the centre, is
// E = a*i + b*j + ((c + a*dx + b*dy) >> 8) in units of 1/256 of the cross product, rounded down,
// which keeps its sign: the place is inside when E >= 0 for every edge. Two primitives that share
// an edge get values that sum to -1 on it: no place is hit twice and none is missed.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace clearpipe::pipeline {

inline constexpr int kSubpixelBits = 8;
inline constexpr int kSubpixelOne = 1 << kSubpixelBits;

// Primitives are clipped to this range of window coordinates, in pixels, so that edge differences
// stay within 2^23 and the steps of a tile within 2^30: 32-bit arithmetic is exact inside a tile.
inline constexpr int kGuardMin = -8192;
inline constexpr int kGuardMax = 24576;

struct Edge {
  int32_t a = 0, b = 0;  // steps per pixel in x and y
  int64_t c = 0;         // cross product at the centre of pixel (0, 0)

  // The value at a place of pixel (0, 0), in subpixels from its centre.
  int64_t at(int32_t dx, int32_t dy) const {
    return (c + static_cast<int64_t>(a) * dx + static_cast<int64_t>(b) * dy) >> kSubpixelBits;
  }
};

// The edge from (x0, y0) to (x1, y1), snapped coordinates; inside is to the left. A centre exactly
// on the edge is inside when the interior lies towards +x, or towards +y of a horizontal edge: the
// top-left rule of a surface whose first row is on top.
inline Edge make_edge(int32_t x0, int32_t y0, int32_t x1, int32_t y1) {
  Edge edge;
  edge.a = y0 - y1;
  edge.b = x1 - x0;
  const bool owns_edge = edge.a > 0 || (edge.a == 0 && edge.b > 0);
  const int64_t value = -(static_cast<int64_t>(edge.a) * x0 + static_cast<int64_t>(edge.b) * y0);
  edge.c = value - (owns_edge ? 0 : 1);
  return edge;
}

}  // namespace clearpipe::pipeline
