// What each of some tiles has to draw: the lists of all packets, by tile. Made between the front
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
  // A packet that touches the tile, and its Bins::entries().
  struct Reference {
    const uint32_t* entries;
    uint32_t count;
    uint32_t packet;
  };

  // Takes the lists of `count` packets, for tiles from number `first` to `end` - 1; bins_of(i)
  // gives the Bins of packet i, null for one without.
  template <class BinsOf>
  void build(uint32_t first, uint32_t end, size_t count, const BinsOf& bins_of) {
    first_ = first;
    start_.assign(size_t{end - first} + 1, 0);
    for (size_t i = 0; i < count; ++i) {
      const Bins* bins = bins_of(i);
      if (bins == nullptr) continue;
      for (const Bins::List& list : bins->lists()) {
        if (list.tile - first < end - first) ++start_[list.tile - first];
      }
    }
    uint32_t total = 0;
    for (uint32_t& start : start_) start = total += start;
    // Filled from behind: each place of start_ moves from the end of its tile to its beginning.
    references_.resize(total);
    for (size_t i = count; i-- > 0;) {
      const Bins* bins = bins_of(i);
      if (bins == nullptr) continue;
      for (const Bins::List& list : bins->lists()) {
        if (list.tile - first >= end - first) continue;
        references_[--start_[list.tile - first]] = {bins->entries(list).data(), list.count,
                                                    static_cast<uint32_t>(i)};
      }
    }
  }

  // In the order of the packets.
  std::span<const Reference> tile(uint32_t number) const {
    const uint32_t* const start = &start_[number - first_];
    return {references_.data() + start[0], references_.data() + start[1]};
  }
  // The same, and those of all tiles behind it.
  std::span<const Reference> from_tile(uint32_t number) const {
    return {references_.data() + start_[number - first_], references_.data() + references_.size()};
  }

 private:
  uint32_t first_ = 0;
  std::vector<uint32_t> start_;  // per tile, its first place in references_; one more at the end
  std::vector<Reference, ImageAllocator<Reference>> references_;
};

}  // namespace clearpipe::pipeline
