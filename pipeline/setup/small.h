// Small primitives: those whose pixels lie in a square of 8x8, which then are one 64-bit mask.
//
// A mesh is made of them, and what a tile does for each primitive - edge functions, planes, a loop
// over rows - costs more than their pixels. So their coverage is found before they are binned (what
// covers nothing goes no further), and a tile shades the pixels of many of them at once
// (fragment/small-inl.h). Only of primitives that are covered by centres (3.5.1), not by samples.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "pipeline/raster/tile.h"
#include "pipeline/setup/primitive.h"

namespace clearpipe::pipeline {

inline constexpr int kSmallSide = 8;

// None lies across two cache lines.
struct alignas(32) SmallPrimitive {
  uint64_t mask;  // bit 8 * j + i: pixel (x + i, y + j) is covered
  int16_t x, y;
  uint32_t vertex[3];  // numbers of vertex records in the range; points use one, lines two
  float size;          // as in PrimitiveRecord
  uint16_t range;      // number in the packet's ranges
  PrimitiveKind kind;
  bool back_facing;
};

// The pixels of a small primitive that lie in a tile: bit 8 * j + i is pixel (column + i, row + j)
// of the tile. All bits that are set are inside the tile. The square must touch the tile.
struct SmallCoverage {
  uint64_t mask;
  int column, row;
};

inline SmallCoverage small_coverage(uint64_t mask, int x, int y, int tile_x, int tile_y) {
  constexpr uint64_t kEachRow = 0x0101010101010101u;
  // Without branches: whether a square lies across the border of a tile cannot be guessed.
  const int column = x - tile_x, row = y - tile_y;
  const int left = std::max(-column, 0), right = std::max(column - (kTileWidth - kSmallSide), 0);
  const int low = std::max(-row, 0), high = std::max(row - (kTileHeight - kSmallSide), 0);
  mask = mask >> left & kEachRow * (0xffu >> left) & kEachRow * (0xffu >> right);
  mask = mask >> kSmallSide * low & ~uint64_t{0} >> kSmallSide * high;
  return {mask, std::max(column, 0), std::max(row, 0)};
}

// Whether the box of a primitive after setup is small enough.
inline bool is_small(const PrimitiveRecord& primitive) {
  return primitive.x1 - primitive.x0 <= kSmallSide && primitive.y1 - primitive.y0 <= kSmallSide;
}

// Makes a small primitive of one whose box is small and whose pixels are decided by their centres;
// false when it covers none. The vertices and the range are left to the caller.
bool make_small(const PrimitiveRecord& primitive, SmallPrimitive& out);

}  // namespace clearpipe::pipeline
