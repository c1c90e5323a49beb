// What each tile of a frame has to draw: the lists of all packets, by tile. Made between the front
// and the back phase, so that a tile looks at no packet that does not touch it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/bin/bins.h"
#include "pipeline/image_memory.h"

namespace clearpipe::pipeline {

class TileLists {
 public:
  // A packet that touches the tile, and its entries of Bins::primitives().
  struct Reference {
    const uint32_t* entries;
    uint32_t count;
    uint32_t packet;
  };

  // Takes the lists of `count` packets; bins_of(i) gives the Bins of packet i, null for one
  // without.
  template <class BinsOf>
  void build(const TileGrid& grid, size_t count, const BinsOf& bins_of) {
    start_.assign(static_cast<size_t>(grid.count()) + 1, 0);
    size_t total = 0;
    for (size_t i = 0; i < count; ++i) {
      const Bins* bins = bins_of(i);
      if (bins == nullptr) continue;
      for (const Bins::List& list : bins->lists()) ++start_[list.tile];
      total += bins->lists().size();
    }
    uint32_t end = 0;
    for (uint32_t& start : start_) start = end += start;
    // Filled from behind: each place of start_ moves from the end of its tile to its beginning.
    references_.resize(total);
    for (size_t i = count; i-- > 0;) {
      const Bins* bins = bins_of(i);
      if (bins == nullptr) continue;
      for (const Bins::List& list : bins->lists()) {
        references_[--start_[list.tile]] = {bins->primitives(list).data(), list.count,
                                            static_cast<uint32_t>(i)};
      }
    }
  }

  // In the order of the packets.
  std::span<const Reference> tile(int index) const {
    return {references_.data() + start_[index], references_.data() + start_[index + 1]};
  }

 private:
  std::vector<uint32_t> start_;  // per tile, its first place in references_; one more at the end
  std::vector<Reference, ImageAllocator<Reference>> references_;
};

}  // namespace clearpipe::pipeline
