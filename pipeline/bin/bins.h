// Which primitives touch which tile: a packet's lists, one per tile, in submission order.
//
// A packet is built by one worker, so its lists need no lock; the order of packets is the order of
// submission, so walking the packets in order gives a tile its primitives in order, whoever built
// them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/setup/primitive.h"

namespace clearpipe::pipeline {

struct TileGrid {
  int columns = 0, rows = 0;
  int count() const { return columns * rows; }
};

TileGrid make_tile_grid(int width, int height);

class Bins {
 public:
  // Starts empty lists for every tile of the grid.
  void reset(const TileGrid& grid);

  // Notes `index`, the number of `primitive` in its packet, in every tile it may touch.
  void add(const PrimitiveRecord& primitive, uint32_t index);

  // Sorts what was noted by tile; add() must not follow.
  void close();

  // The primitives that touch a tile.
  std::span<const uint32_t> tile(int index) const {
    return {sorted_.data() + start_[index], sorted_.data() + start_[index + 1]};
  }

 private:
  struct Entry {
    uint32_t tile;
    uint32_t primitive;
  };

  TileGrid grid_;
  std::vector<Entry> entries_;   // in submission order
  std::vector<uint32_t> start_;  // per tile, its first place in sorted_; one more at the end
  std::vector<uint32_t> sorted_;
};

}  // namespace clearpipe::pipeline
