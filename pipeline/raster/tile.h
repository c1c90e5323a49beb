// A tile: the square of the surface that one worker owns while it rasterizes and shades.
//
// Its colour and depth/stencil planes (8 KB each) stay in the first-level cache meanwhile. They are
// the surface's own memory where that is laid out in tiles, else memory of the worker's.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "pipeline/raster/samples.h"

namespace clearpipe::pipeline {

inline constexpr int kTileWidth = 64;  // one bit of a row mask per pixel
inline constexpr int kTileHeight = 32;

inline constexpr int kTilePixels = kTileHeight * kTileWidth;

// Pixels in rows of kTileWidth; aligned to 64 bytes.
struct Tile {
  uint32_t* colour = nullptr;         // RGBA8, R in the low byte
  uint32_t* depth_stencil = nullptr;  // depth << 8 | stencil
  int x = 0, y = 0;                   // window coordinates of the first pixel
  int mirror_height = 0;  // > 0: the surface has this many rows, and its first is the upmost
};

struct TileMemory {
  alignas(64) uint32_t colour[kTilePixels];
  alignas(64) uint32_t depth_stencil[kTilePixels];
};

// The tile of each sample, with memory for planes that the surface does not lay out in tiles or
// does not have. A surface without multisampling uses the first.
struct SampleTiles {
  std::array<Tile, kSampleCount> tiles;

  // Made when it is asked for: few surfaces need any.
  TileMemory& memory(int sample) {
    std::unique_ptr<TileMemory>& memory = memories_[static_cast<size_t>(sample)];
    if (memory == nullptr) memory = std::make_unique<TileMemory>();
    return *memory;
  }

 private:
  std::array<std::unique_ptr<TileMemory>, kSampleCount> memories_;
};

// Which pixels of a tile a primitive covers: bit i of rows[j] is pixel (x + i, y + j).
struct Coverage {
  uint64_t rows[kTileHeight];
  int first_row = 0, last_row = 0;  // half-open range of rows that may be non-zero
};

}  // namespace clearpipe::pipeline
