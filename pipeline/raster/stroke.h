// The pixels of a stroke (setup/stroke.h) in a tile.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "pipeline/raster/tile.h"
#include "pipeline/setup/stroke.h"

namespace clearpipe::pipeline {

// A stroke's edge in the tile whose first pixel is (tile_x, tile_y), with whole numbers of that.
struct StrokeEdge {
  int32_t slope, step, start;
};

// What the edge's function has at the first pixel of a tile.
inline int64_t stroke_start(const StrokeRecord& stroke, int tile_x, int tile_y) {
  const int column = stroke.x_major ? tile_x : tile_y, row = stroke.x_major ? tile_y : tile_x;
  return stroke.start + int64_t{stroke.slope} * column + int64_t{stroke.step} * row;
}

// Whether the stroke's long edges leave some pixel of the tile between them.
inline bool touches_tile(const StrokeRecord& stroke, int tile_x, int tile_y) {
  const int columns = (stroke.x_major ? kTileWidth : kTileHeight) - 1;
  const int rows = (stroke.x_major ? kTileHeight : kTileWidth) - 1;
  const int64_t start = stroke_start(stroke, tile_x, tile_y);
  const int64_t most =
      start + int64_t{std::max(stroke.slope, 0)} * columns + int64_t{stroke.step} * rows;
  const int64_t least = start + int64_t{std::min(stroke.slope, 0)} * columns;
  return most >= 0 && least < int64_t{stroke.step} * stroke.width;
}

// How many pixels of a tile are covered.
int count_pixels(const StrokeRecord& stroke, int tile_x, int tile_y);

// False when no pixel is covered.
inline bool find_edge(const StrokeRecord& stroke, int tile_x, int tile_y, StrokeEdge& out) {
  const int64_t start = stroke_start(stroke, tile_x, tile_y);
  // Steps are less than 2^23: where the start is so far away, so is every row of a column, by more
  // than the width of a stroke.
  constexpr int64_t kFar = int64_t{1} << 30;
  out = {stroke.slope, stroke.step, static_cast<int32_t>(start)};
  return start > -kFar && start < kFar;
}

}  // namespace clearpipe::pipeline
