// Dots: points of one pixel whose colour is written as it is, if their depth passes.
//
// Scattered points are few in a tile from each packet, so that the back phase would wait for memory
// with each of them: for its entry, the small primitive, the vertex. Of a dot, the front phase
// knows all there is to know. The bins hold it whole (bin/bins.h), its vertex is forgotten at once,
// and packets are larger, so that a tile finds more of its dots in one place.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "pipeline/exec/frame_data.h"

namespace clearpipe::pipeline {

// Fewer points are not worth a packet of their own.
inline constexpr uint32_t kLeastDots = 128;
inline constexpr uint32_t kPacketDots = 4096;

// Whether points that are drawn with the state are dots if their size is that of one; the state has
// all but that.
bool may_draw_dots(const DrawState& state, const VertexState& vertex);

// Whether the draw, which was recorded from the command, is one of dots.
bool draws_dots(const DrawCommand& command, const DrawRecord& draw);

// Runs the front phase of packets of dots.
class DotWorker {
 public:
  // The packet's lists are in the arena.
  void run(const DrawList& draws, const TileGrid& grid, BinScratch& scratch, Arena& arena,
           Packet& packet);

 private:
  static constexpr uint32_t kVertices = 256;  // of a job: their records stay in the nearest cache

  void run_job(const DrawRecord& draw, const TileGrid& grid, uint32_t count, Bins& bins);

  Arena records_;
  std::array<uint32_t, kVertices> elements_;
};

// Draws the dots that a tile's list of a packet has, which all are of draws with that state.
void draw_dots(const DrawState& state, std::span<const uint32_t> entries, Tile& tile);

}  // namespace clearpipe::pipeline
