// Which primitives touch which tile: a packet's lists, one per tile it touches, in submission
// order.
//
// A packet is built by one worker, so its lists need no lock; the order of packets is the order of
// submission, so walking the packets in order gives a tile its primitives in order, whoever built
// them. The cost of a packet follows its primitives, not the tiles of the surface.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/setup/primitive.h"
#include "pipeline/setup/small.h"

namespace clearpipe::pipeline {

struct TileGrid {
  int columns = 0, rows = 0;
  int count() const { return columns * rows; }
};

TileGrid make_tile_grid(int width, int height);

// The number of a packet's list by tile, while the packet is built; used for one packet after
// another.
class TileNumbers {
 public:
  // Forgets the lists of the last packet.
  void reset(const TileGrid& grid) {
    const size_t count = static_cast<size_t>(grid.count());
    if (entries_.size() < count || ++generation_ == 0) {
      entries_.assign(count, Entry());
      generation_ = 1;
    }
  }

  // The number noted for a tile, which is `fresh` from now on if there is none.
  uint32_t find(uint32_t tile, uint32_t fresh) {
    Entry& entry = entries_[tile];
    if (entry.generation != generation_) entry = {generation_, fresh};
    return entry.number;
  }

 private:
  struct Entry {
    uint32_t generation = 0, number = 0;
  };

  std::vector<Entry> entries_;
  uint32_t generation_ = 0;
};

class Bins {
 public:
  // A tile and its part of the primitives.
  struct List {
    uint32_t tile, first, count;
  };

  // Starts without lists. `numbers` is used until close().
  void reset(const TileGrid& grid, TileNumbers& numbers);

  // Notes `index`, the number of `primitive` in its packet, in every tile it may touch.
  void add(const PrimitiveRecord& primitive, uint32_t index);
  void add(const SmallPrimitive& primitive, uint32_t index) {
    constexpr int kReach = kSmallSide - 1;
    const int column = primitive.x / kTileWidth, row = primitive.y / kTileHeight;
    if ((primitive.x + kReach) / kTileWidth == column &&
        (primitive.y + kReach) / kTileHeight == row) {
      note(column, row, index);
    } else {
      add_across(primitive, index);
    }
  }

  // Sorts what was noted by tile; add() must not follow.
  void close();

  // The tiles that are touched, in no particular order, and the primitives that touch one.
  std::span<const List> lists() const { return lists_; }
  std::span<const uint32_t> primitives(const List& list) const {
    return {sorted_.data() + list.first, list.count};
  }

 private:
  struct Entry {
    uint32_t list;
    uint32_t primitive;
  };

  void add_across(const SmallPrimitive& primitive, uint32_t index);

  void note(int column, int row, uint32_t index) {
    const uint32_t tile = static_cast<uint32_t>(row * grid_.columns + column);
    const uint32_t list = numbers_->find(tile, static_cast<uint32_t>(lists_.size()));
    if (list == lists_.size()) lists_.push_back({tile, 0, 0});
    entries_.push_back({list, index});
    ++lists_[list].count;
  }

  TileGrid grid_;
  TileNumbers* numbers_ = nullptr;
  std::vector<Entry> entries_;  // in submission order
  std::vector<List> lists_;
  std::vector<uint32_t> sorted_;
};

}  // namespace clearpipe::pipeline
