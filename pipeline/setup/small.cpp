// Small primitives from records that setup has made: see small.h.
// SPDX-License-Identifier: MIT
#include "pipeline/setup/small.h"

#include <algorithm>

namespace clearpipe::pipeline {

namespace {

// The pixels of the square at (x, y) inside all edges, and inside the box.
uint64_t mask_of(const PrimitiveRecord& primitive) {
  const int width = primitive.x1 - primitive.x0, height = primitive.y1 - primitive.y0;
  uint64_t mask = 0;
  const uint64_t row_mask = 0xffu >> (kSmallSide - width);
  for (int j = 0; j < height; ++j) mask |= row_mask << (kSmallSide * j);
  for (int e = 0; e < primitive.edge_count; ++e) {
    const Edge& edge = primitive.edges[e];
    int64_t row_value = edge.at(0, 0) + static_cast<int64_t>(edge.a) * primitive.x0 +
                        static_cast<int64_t>(edge.b) * primitive.y0;
    uint64_t outside = 0;
    for (int j = 0; j < height; ++j, row_value += edge.b) {
      int64_t value = row_value;
      for (int i = 0; i < width; ++i, value += edge.a) {
        outside |= (static_cast<uint64_t>(value) >> 63) << (kSmallSide * j + i);
      }
    }
    mask &= ~outside;
  }
  return mask;
}

}  // namespace

bool make_small(const PrimitiveRecord& primitive, SmallPrimitive& out) {
  out.mask = mask_of(primitive);
  if (out.mask == 0) return false;
  out.x = primitive.x0;
  out.y = primitive.y0;
  out.size = primitive.size;
  out.kind = primitive.kind;
  out.back_facing = primitive.back_facing;
  return true;
}

}  // namespace clearpipe::pipeline
