// Which primitives touch which tile: a packet's lists, one per tile it touches, in submission
// order.
//
// A packet is built by one worker, so its lists need no lock; the order of packets is the order of
// submission, so walking the packets in order gives a tile its primitives in order, whoever built
// them. The cost of a packet follows its primitives, not the tiles of the surface.
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/exec/arena.h"
#include "pipeline/setup/primitive.h"
#include "pipeline/setup/small.h"

namespace clearpipe::pipeline {

struct TileGrid {
  int columns = 0, rows = 0;
  int count() const { return columns * rows; }
};

TileGrid make_tile_grid(int width, int height);

// A tile and its part of a packet's primitives.
struct BinList {
  uint32_t tile, first, count;
};

// What a worker needs to sort a packet's primitives by tile; used for one packet after another.
class BinScratch {
 public:
  // Forgets the lists of the last packet.
  void reset(const TileGrid& grid) {
    const size_t count = static_cast<size_t>(grid.count());
    if (tiles_.size() < count || ++generation_ == 0) {
      tiles_.assign(count, Tile());
      generation_ = 1;
    }
    entries_.clear();
    lists_.clear();
  }

 private:
  friend class Bins;

  struct Tile {
    uint32_t generation = 0;  // the packet's, or the tile has no list yet
    uint32_t list = 0;
  };
  struct Entry {
    uint32_t list;
    uint32_t primitive;
  };

  uint32_t generation_ = 0;
  std::vector<Tile> tiles_;
  std::vector<Entry> entries_;  // in submission order
  std::vector<BinList> lists_;
};

class Bins {
 public:
  using List = BinList;

  // Starts without lists. `scratch` is used until close().
  void reset(const TileGrid& grid, BinScratch& scratch);

  // Notes `index`, the number of `primitive` in its packet, in every tile it may touch.
  void add(const PrimitiveRecord& primitive, uint32_t index);
  void add(const SmallPrimitive& primitive, uint32_t index) {
    // Where its pixels are is known exactly, and none is outside of the surface. Most are in one
    // tile; that their square is in one, too, would often be wrong.
    const int right = primitive.x + last_column(primitive.mask);
    const int up = primitive.y + last_row(primitive.mask);
    const int column = primitive.x / kTileWidth, row = primitive.y / kTileHeight;
    if (right / kTileWidth == column && up / kTileHeight == row) {
      note(column, row, index);
    } else {
      add_across(primitive, right / kTileWidth, up / kTileHeight, index);
    }
  }

  // Sorts what was noted by tile into memory of the arena; add() must not follow.
  void close(Arena& arena);

  // The tiles that are touched, in no particular order, and the primitives that touch one.
  std::span<const List> lists() const { return lists_; }
  std::span<const uint32_t> primitives(const List& list) const {
    return sorted_.subspan(list.first, list.count);
  }

 private:
  // Of the pixels of a mask.
  static int last_column(uint64_t mask) {
    // Each row's pixels in the lowest one.
    uint64_t columns = mask | mask >> 32;
    columns |= columns >> 16;
    columns = (columns | columns >> 8) & 0xff;
    return static_cast<int>(std::bit_width(columns)) - 1;
  }
  static int last_row(uint64_t mask) {
    return (static_cast<int>(std::bit_width(mask)) - 1) / kSmallSide;
  }

  // One whose last pixels are in the tiles of that column and row.
  void add_across(const SmallPrimitive& primitive, int last_column, int last_row, uint32_t index);

  void note(int column, int row, uint32_t index) {
    const uint32_t number = static_cast<uint32_t>(row * grid_.columns + column);
    BinScratch::Tile& tile = scratch_->tiles_[number];
    if (tile.generation != scratch_->generation_) {
      tile = {scratch_->generation_, static_cast<uint32_t>(scratch_->lists_.size())};
      scratch_->lists_.push_back({number, 0, 0});
    }
    scratch_->entries_.push_back({tile.list, index});
    ++scratch_->lists_[tile.list].count;
  }

  TileGrid grid_;
  BinScratch* scratch_ = nullptr;
  std::span<const List> lists_;
  std::span<const uint32_t> sorted_;
};

}  // namespace clearpipe::pipeline
