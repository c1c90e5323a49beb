// What a frame is made of between recording and execution.
//
// Draws are cut into packets of a few hundred primitives, the unit of the front phase: a packet is
// fetched, transformed, clipped, set up and binned by one worker into memory of its own. Packets
// keep the order of submission; a clear is a packet of its own.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "pipeline/bin/bins.h"
#include "pipeline/bin/tile_lists.h"
#include "pipeline/clip/clip.h"
#include "pipeline/command.h"
#include "pipeline/exec/arena.h"
#include "pipeline/exec/draw_list.h"
#include "pipeline/exec/small.h"
#include "pipeline/fragment/program.h"
#include "pipeline/raster/tile.h"
#include "pipeline/setup/primitive.h"
#include "pipeline/setup/small.h"
#include "pipeline/setup/stroke.h"
#include "pipeline/surface.h"

namespace clearpipe::pipeline {

inline constexpr uint32_t kPacketPrimitives = 512;
inline constexpr uint32_t kPacketVertices = 3 * kPacketPrimitives;

struct PacketRange {
  uint32_t draw = 0;
  uint32_t first_primitive = 0, primitive_count = 0;
};

// Apart from each other: the worker that has one must not wait for the lines in which draws are
// added to the next.
struct alignas(128) Packet {
  // Filled while recording.
  std::vector<PacketRange> ranges;
  uint32_t primitive_count = 0;
  bool is_clear = false;
  uint32_t most = kPacketPrimitives;  // as many primitives as it takes
  // All of its ranges are of dots (dots.h), with one state. Others have at most kPacketPrimitives.
  bool is_dots = false;
  ClearCommand clear;

  // Filled by the front phase.
  std::span<const PrimitiveRecord> primitives;
  std::span<const SmallPrimitive> small;
  std::span<const StrokeRecord> strokes;
  std::span<const float* const> records;  // by range: its vertex records
  Bins bins;

  void reset() {
    ranges.clear();
    primitive_count = 0;
    most = kPacketPrimitives;
    is_clear = is_dots = false;
    primitives = {};
    small = {};
    strokes = {};
  }
};

// How many primitives `count` vertices make (2.6.1).
uint32_t primitive_count(Primitive primitive, uint32_t count);

// How many vertices a primitive has that shares none with another; else 0.
uint32_t corners_of(Primitive primitive);

// The job that makes vertex records of elements of a draw.
inline VertexJob make_vertex_job(const DrawRecord& draw, const uint32_t* elements, size_t count,
                                 float* records) {
  const ClipState& clip = draw.state->clip;
  return {draw.sources, draw.vertex, clip.viewport, clip.guard,
          clip.layout,  elements,    count,         records};
}

// Runs the front phase of packets, whose lists and vertex records are the worker's until it is
// reset.
class FrontWorker;
struct FrontWorkerDeleter {
  void operator()(FrontWorker* worker) const;
};
using FrontWorkerPtr = std::unique_ptr<FrontWorker, FrontWorkerDeleter>;
FrontWorkerPtr make_front_worker();
void run_front(FrontWorker& worker, const DrawList& draws, const TileGrid& grid, Packet& packet);
void reset_front_worker(FrontWorker& worker);

// What the tiles have to do, made when the front phase of all packets is done: in parts, as
// Shares::divide() makes them of the tiles, which workers can make at the same time.
class TileWork {
 public:
  void divide(const TileGrid& grid, size_t parts) {
    tiles_ = static_cast<size_t>(grid.count());
    parts_.resize(parts);
  }
  void make(size_t part, std::span<Packet* const> packets);

  std::span<const TileLists::Reference> lists(size_t tile) const {
    return part_of(tile).lists.tile(static_cast<uint32_t>(tile));
  }
  // The same, and those that come next, of the tiles behind it.
  std::span<const TileLists::Reference> lists_ahead(size_t tile) const {
    return part_of(tile).lists.from_tile(static_cast<uint32_t>(tile));
  }
  // The packets that are clears.
  std::span<const uint32_t> clears(size_t tile) const { return part_of(tile).clears; }

 private:
  struct Part {
    std::vector<uint32_t> clears;
    TileLists lists;
  };
  const Part& part_of(size_t tile) const {
    return parts_[((tile + 1) * parts_.size() - 1) / tiles_];
  }

  size_t tiles_ = 0;
  std::vector<Part> parts_;
};

// What a worker has in the back phase; used for one tile after another.
struct BackWorker {
  SampleTiles tiles;
  SmallShader small;
  PrimitivePlanes planes;  // of the primitive at hand: clearing them costs more than making some
};

// Runs the back phase of one tile.
void run_back(const DrawList& draws, std::span<Packet* const> packets, const TileWork& work,
              const Target& target, const TileGrid& grid, int tile_index, BackWorker& worker);

}  // namespace clearpipe::pipeline
