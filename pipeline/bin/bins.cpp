// Binning: see bins.h.
// SPDX-License-Identifier: MIT
#include "pipeline/bin/bins.h"

#include <algorithm>
#include <cstring>

#include "pipeline/raster/coverage.h"
#include "pipeline/raster/stroke.h"
#include "pipeline/raster/tile.h"

namespace clearpipe::pipeline {

namespace {

// What misses_tile() says of a primitive that is covered by centres, for one tile after another:
// the greatest values that its edges have in a tile, from those of the tile before by an addition.
template <int kEdges>
class EdgeWalk {
 public:
  EdgeWalk(const PrimitiveRecord& primitive, int tile_x, int tile_y) {
    for (int i = 0; i < kEdges; ++i) {
      const Edge& edge = primitive.edges[i];
      row_[i] = edge.at(kCentrePlace.x, kCentrePlace.y) + int64_t{edge.a} * tile_x +
                int64_t{edge.b} * tile_y + int64_t{std::max(edge.a, 0)} * (kTileWidth - 1) +
                int64_t{std::max(edge.b, 0)} * (kTileHeight - 1);
      most_[i] = row_[i];
      right_[i] = int64_t{edge.a} * kTileWidth;
      up_[i] = int64_t{edge.b} * kTileHeight;
    }
  }

  bool misses() const {
    int64_t any = 0;
    for (int i = 0; i < kEdges; ++i) any |= most_[i];
    return any < 0;
  }
  void next_column() {
    for (int i = 0; i < kEdges; ++i) most_[i] += right_[i];
  }
  // The first column of the next row.
  void next_row() {
    for (int i = 0; i < kEdges; ++i) most_[i] = row_[i] += up_[i];
  }

 private:
  int64_t most_[4], row_[4], right_[4], up_[4];
};

// Calls f(column, row) for each of the tiles that the edges do not miss.
template <int kEdges, class F>
void walk_tiles(const PrimitiveRecord& primitive, const Rect& tiles, const F& f) {
  EdgeWalk<kEdges> walk(primitive, tiles.x0 * kTileWidth, tiles.y0 * kTileHeight);
  for (int row = tiles.y0; row < tiles.y1; ++row, walk.next_row()) {
    for (int column = tiles.x0; column < tiles.x1; ++column, walk.next_column()) {
      if (!walk.misses()) f(column, row);
    }
  }
}

}  // namespace

TileGrid make_tile_grid(int width, int height) {
  return {(width + kTileWidth - 1) / kTileWidth, (height + kTileHeight - 1) / kTileHeight};
}

void Bins::reset(const TileGrid& grid, BinScratch& scratch) {
  grid_ = grid;
  scratch_ = &scratch;
  scratch.reset(grid);
  lists_ = {};
  sorted_ = {};
}

void Bins::add(const PrimitiveRecord& primitive, uint32_t index) {
  const int first_column = primitive.x0 / kTileWidth;
  const int last_column = (primitive.x1 - 1) / kTileWidth;
  const int first_row = primitive.y0 / kTileHeight;
  const int last_row = (primitive.y1 - 1) / kTileHeight;
  // A box of one tile row or column rarely misses a tile; larger boxes are worth the test.
  if (last_column == first_column || last_row == first_row || primitive.multisample) {
    const bool test = last_column > first_column && last_row > first_row;
    for (int row = first_row; row <= last_row; ++row) {
      for (int column = first_column; column <= last_column; ++column) {
        if (test && misses_tile(primitive, column * kTileWidth, row * kTileHeight)) continue;
        note(column, row, index);
      }
    }
    return;
  }
  const Rect tiles{first_column, first_row, last_column + 1, last_row + 1};
  const auto note_tile = [&](int column, int row) { note(column, row, index); };
  switch (primitive.edge_count) {
    case 3:
      return walk_tiles<3>(primitive, tiles, note_tile);
    case 4:
      return walk_tiles<4>(primitive, tiles, note_tile);
    default:  // a box
      return walk_tiles<0>(primitive, tiles, note_tile);
  }
}

void Bins::add(const StrokeRecord& stroke, uint32_t index) {
  const int first_column = stroke.x0 / kTileWidth, last_column = (stroke.x1 - 1) / kTileWidth;
  const int first_row = stroke.y0 / kTileHeight, last_row = (stroke.y1 - 1) / kTileHeight;
  // As for other primitives.
  const bool test = last_column > first_column && last_row > first_row;
  for (int row = first_row; row <= last_row; ++row) {
    for (int column = first_column; column <= last_column; ++column) {
      if (!test || touches_tile(stroke, column * kTileWidth, row * kTileHeight)) {
        note(column, row, index);
      }
    }
  }
}

// The first pixels are in the tile of its place only if their row and column say so.
void Bins::add_across(const SmallPrimitive& primitive, int last_column, int last_row,
                      uint32_t index) {
  const int first_column = primitive.x / kTileWidth, first_row = primitive.y / kTileHeight;
  for (int row = first_row; row <= last_row; ++row) {
    for (int column = first_column; column <= last_column; ++column) {
      const SmallCoverage coverage = small_coverage(primitive.mask, primitive.x, primitive.y,
                                                    column * kTileWidth, row * kTileHeight);
      if (coverage.mask != 0) note(column, row, index);
    }
  }
}

// Each goes to its list's next place; afterwards every `first` has moved to the end.
template <class T>
void Bins::sort(const std::vector<BinScratch::Noted<T>>& noted, Arena& arena) {
  constexpr uint32_t kEntries = sizeof(T) / sizeof(uint32_t);
  std::vector<List>& lists = scratch_->lists_;
  uint32_t first = 0;
  for (List& list : lists) {
    list.first = first;
    list.count *= kEntries;
    first += list.count;
  }
  uint32_t* const sorted = arena.allocate_array<uint32_t>(first);
  sorted_ = {sorted, first};
  for (const BinScratch::Noted<T>& one : noted) {
    uint32_t& next = lists[one.list].first;
    std::memcpy(sorted + next, &one.what, sizeof(T));
    next += kEntries;
  }
  for (List& list : lists) list.first -= list.count;
}

void Bins::close(Arena& arena) {
  if (scratch_->dots_.empty()) {
    sort(scratch_->primitives_, arena);
  } else {
    sort(scratch_->dots_, arena);
  }
  const std::vector<List>& lists = scratch_->lists_;
  List* const kept = arena.allocate_array<List>(lists.size());
  std::copy(lists.begin(), lists.end(), kept);
  lists_ = {kept, lists.size()};
  scratch_ = nullptr;
}

}  // namespace clearpipe::pipeline
