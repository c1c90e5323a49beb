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

void Bins::reset(const TileGrid& grid, TileNumbers& numbers) {
  grid_ = grid;
  numbers_ = &numbers;
  numbers.reset(grid);
  entries_.clear();
  lists_.clear();
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
      note(column, row, index);
    }
  }
}

// Where its pixels are is known exactly, and none is outside of the surface.
void Bins::add_across(const SmallPrimitive& primitive, uint32_t index) {
  constexpr int kReach = kSmallSide - 1;
  const int first_column = primitive.x / kTileWidth, first_row = primitive.y / kTileHeight;
  const int last_column = (primitive.x + kReach) / kTileWidth;
  const int last_row = (primitive.y + kReach) / kTileHeight;
  for (int row = first_row; row <= last_row; ++row) {
    for (int column = first_column; column <= last_column; ++column) {
      const SmallCoverage coverage = small_coverage(primitive.mask, primitive.x, primitive.y,
                                                    column * kTileWidth, row * kTileHeight);
      if (coverage.mask != 0) note(column, row, index);
    }
  }
}

void Bins::close() {
  uint32_t first = 0;
  for (List& list : lists_) {
    list.first = first;
    first += list.count;
  }
  sorted_.resize(entries_.size());
  // Each entry goes to its list's next place; afterwards every `first` has moved to the end.
  for (const Entry& entry : entries_) {
    sorted_[lists_[entry.list].first++] = entry.primitive;
  }
  for (List& list : lists_) list.first -= list.count;
}

}  // namespace clearpipe::pipeline
