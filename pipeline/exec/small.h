// Shading of small and of narrow primitives in the back phase: batches of their fragments, which
// may go on from one packet of a tile to the next.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "pipeline/fragment/program.h"
#include "pipeline/raster/squares.h"
#include "pipeline/raster/tile.h"

namespace clearpipe::pipeline {

class DrawList;
struct DrawRecord;
struct DrawState;
struct Packet;

// Set in the entries of bins that number a small primitive.
inline constexpr uint32_t kSmallEntry = 0x80000000u;
// And in those that number a stroke.
inline constexpr uint32_t kStrokeEntry = 0x40000000u;

// Whether what a draw makes small is made a small primitive.
bool draws_small(const DrawRecord& draw);

// Whether what is narrow is shaded with that.
bool draws_narrow(const DrawRecord& draw);

// The kernels of one SIMD target. `memory` holds a batch.
struct SmallKernels {
  void (*begin)(std::byte* memory, std::byte* other, std::byte* scratch,
                const FragmentProgram& program, Tile& tile);
  // When the other batch, if there is one, has a pixel that is added, it is shaded first.
  size_t (*add)(std::byte* memory, std::byte* other, const DrawList& draws, const Packet& packet,
                std::span<const uint32_t> entries, Tile& tile);
  void (*add_squares)(std::byte* memory, std::byte* other, const SetupState& state,
                      const PrimitiveRecord& primitive, const CoveredSquares& squares);
  void (*flush)(std::byte* memory);
};

// Shades the small and the narrow primitives of a tile. What has come is shaded at the latest by
// flush(), which must precede anything else that is done to the tile.
class SmallShader {
 public:
  static constexpr size_t kBatchBytes = 44 * 1024, kScratchBytes = 72 * 1024;

  // Takes entries of a packet: as many from the first on, which has to be of a small primitive, as
  // are of small primitives of draws with one program. Returns how many that are.
  size_t add(const DrawList& draws, const Packet& packet, std::span<const uint32_t> entries,
             Tile& tile);
  // Takes a primitive that is not small, of a draw with draws_narrow(), by its squares in the tile.
  void add(const DrawState& draw, const PrimitiveRecord& primitive, const CoveredSquares& squares,
           Tile& tile);
  void flush();

 private:
  struct Batch {
    const FragmentProgram* program = nullptr;  // null: it holds nothing
    alignas(64) std::byte memory[kBatchBytes];
  };

  // Makes the batch of the program the last one.
  void find(const FragmentProgram& program, Tile& tile);
  std::byte* other_memory() {
    Batch& other = batches_[1 - last_];
    return other.program != nullptr ? other.memory : nullptr;
  }

  // Of the last two programs: what draws cover is mostly apart, so that those which come in turns
  // fill a batch each.
  std::array<Batch, 2> batches_;
  size_t last_ = 0;
  alignas(64) std::byte scratch_[kScratchBytes];
};

}  // namespace clearpipe::pipeline
