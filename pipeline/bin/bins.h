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
#include "pipeline/setup/stroke.h"

namespace clearpipe::pipeline {

struct TileGrid {
  int columns = 0, rows = 0;
  int count() const { return columns * rows; }
};

TileGrid make_tile_grid(int width, int height);

// A tile and its part of a packet's entries.
struct BinList {
  uint32_t tile, first, count;
};

// A point of one pixel that becomes what is said here if its depth passes (exec/dots.h). Bins hold
// such as they are, three entries each: nothing else is looked at for them.
struct Dot {
  uint32_t place;  // in the tile, row by row
  uint32_t depth;  // as the buffer holds it
  uint32_t colour;
};
inline constexpr uint32_t kDotEntries = sizeof(Dot) / sizeof(uint32_t);

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
    primitives_.clear();
    dots_.clear();
    lists_.clear();
  }

 private:
  friend class Bins;

  struct Tile {
    uint32_t generation = 0;  // the packet's, or the tile has no list yet
    uint32_t list = 0;
  };
  template <class T>
  struct Noted {
    uint32_t list;
    T what;
  };

  uint32_t generation_ = 0;
  std::vector<Tile> tiles_;
  // In submission order; of a packet either of them.
  std::vector<Noted<uint32_t>> primitives_;
  std::vector<Noted<Dot>> dots_;
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

  void add(const StrokeRecord& stroke, uint32_t index);

  // A dot of the tile; nothing else may be added to the same bins.
  void add(uint32_t tile, const Dot& dot) { scratch_->dots_.push_back({count_in(tile), dot}); }

  // Sorts what was noted by tile into memory of the arena; add() must not follow.
  void close(Arena& arena);

  // The tiles that are touched, in no particular order, and the entries of one: the primitives that
  // touch it, or its dots.
  std::span<const List> lists() const { return lists_; }
  std::span<const uint32_t> entries(const List& list) const {
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
    const uint32_t tile = static_cast<uint32_t>(row * grid_.columns + column);
    scratch_->primitives_.push_back({count_in(tile), index});
  }

  // The tile's list, which will have one more.
  uint32_t count_in(uint32_t number) {
    BinScratch::Tile& tile = scratch_->tiles_[number];
    if (tile.generation != scratch_->generation_) {
      tile = {scratch_->generation_, static_cast<uint32_t>(scratch_->lists_.size())};
      scratch_->lists_.push_back({number, 0, 0});
    }
    ++scratch_->lists_[tile.list].count;
    return tile.list;
  }

  template <class T>
  void sort(const std::vector<BinScratch::Noted<T>>& noted, Arena& arena);

  TileGrid grid_;
  BinScratch* scratch_ = nullptr;
  std::span<const List> lists_;
  std::span<const uint32_t> sorted_;
};

}  // namespace clearpipe::pipeline
