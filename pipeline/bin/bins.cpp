// Binning: see bins.h.
// SPDX-License-Identifier: MIT
#include "pipeline/bin/bins.h"

#include <algorithm>

#include "pipeline/raster/coverage.h"
#include "pipeline/raster/tile.h"

namespace clearpipe::pipeline {

TileGrid make_tile_grid(int width, int height) {
  return {(width + kTileWidth - 1) / kTileWidth, (height + kTileHeight - 1) / kTileHeight};
}

void Bins::reset(const TileGrid& grid) {
  grid_ = grid;
  entries_.clear();
  start_.assign(static_cast<size_t>(grid.count()) + 1, 0);
}

void Bins::add(const PrimitiveRecord& primitive, uint32_t index) {
  const int first_column = primitive.x0 / kTileWidth;
  const int last_column = (primitive.x1 - 1) / kTileWidth;
  const int first_row = primitive.y0 / kTileHeight;
  const int last_row = (primitive.y1 - 1) / kTileHeight;
  // A box of one tile row or column rarely misses a tile; larger boxes are worth the test.
  const bool test = last_column - first_column > 0 && last_row - first_row > 0;
  for (int row = first_row; row <= last_row; ++row) {
    for (int column = first_column; column <= last_column; ++column) {
      if (test && misses_tile(primitive, column * kTileWidth, row * kTileHeight)) {
        continue;
      }
      const uint32_t tile = static_cast<uint32_t>(row * grid_.columns + column);
      entries_.push_back({tile, index});
      ++start_[tile + 1];
    }
  }
}

void Bins::close() {
  for (size_t i = 1; i < start_.size(); ++i) {
    start_[i] += start_[i - 1];
  }
  sorted_.resize(entries_.size());
  // Each entry goes to its tile's next place; afterwards every start has moved to its end, which is
  // the next tile's start: shift them back by one.
  for (const Entry& entry : entries_) {
    sorted_[start_[entry.tile]++] = entry.primitive;
  }
  std::move_backward(start_.begin(), start_.end() - 1, start_.end());
  start_[0] = 0;
}

}  // namespace clearpipe::pipeline
