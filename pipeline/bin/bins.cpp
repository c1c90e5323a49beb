// Binning: see bins.h.
// SPDX-License-Identifier: MIT
#include "pipeline/bin/bins.h"

#include <algorithm>
#include <bit>

#include "pipeline/raster/coverage.h"
#include "pipeline/raster/tile.h"

namespace clearpipe::pipeline {

TileGrid make_tile_grid(int width, int height) {
  return {(width + kTileWidth - 1) / kTileWidth, (height + kTileHeight - 1) / kTileHeight};
}

void Bins::reset(const TileGrid& grid, BinScratch& scratch) {
  grid_ = grid;
  scratch_ = &scratch;
  scratch.reset(grid);
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

// Where its pixels are is known exactly, and none is outside of the surface. The first are in the
// tile of its place only if their row and column say so.
void Bins::add_across(const SmallPrimitive& primitive, uint32_t index) {
  // Each row's pixels in the lowest one.
  uint64_t columns = primitive.mask | primitive.mask >> 32;
  columns |= columns >> 16;
  columns = (columns | columns >> 8) & 0xff;
  const int right = static_cast<int>(std::bit_width(columns)) - 1;
  const int up = (static_cast<int>(std::bit_width(primitive.mask)) - 1) / kSmallSide;
  const int first_column = primitive.x / kTileWidth, first_row = primitive.y / kTileHeight;
  const int last_column = (primitive.x + right) / kTileWidth;
  const int last_row = (primitive.y + up) / kTileHeight;
  if (first_column == last_column && first_row == last_row) {
    note(first_column, first_row, index);
    return;
  }
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
  sorted_.resize(scratch_->entries_.size());
  // Each entry goes to its list's next place; afterwards every `first` has moved to the end.
  for (const BinScratch::Entry& entry : scratch_->entries_) {
    sorted_[lists_[entry.list].first++] = entry.primitive;
  }
  for (List& list : lists_) list.first -= list.count;
  scratch_ = nullptr;
}

}  // namespace clearpipe::pipeline
