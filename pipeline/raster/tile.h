// A tile: the square of the surface that one worker owns while it rasterizes and shades.
//
// Its colour and depth/stencil planes (8 KB each) stay in the first-level cache until they are
// merged into the surface.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace clearpipe::pipeline {

inline constexpr int kTileWidth = 64;  // one bit of a row mask per pixel
inline constexpr int kTileHeight = 32;

struct Tile {
  alignas(64) uint32_t colour[kTileHeight * kTileWidth];         // RGBA8, R in the low byte
  alignas(64) uint32_t depth_stencil[kTileHeight * kTileWidth];  // depth << 8 | stencil
  int x = 0, y = 0;       // window coordinates of the first pixel
  int mirror_height = 0;  // > 0: the surface has this many rows, and its first is the upmost
};

// Which pixels of a tile a primitive covers: bit i of rows[j] is pixel (x + i, y + j).
struct Coverage {
  uint64_t rows[kTileHeight];
  int first_row = 0, last_row = 0;  // half-open range of rows that may be non-zero
};

}  // namespace clearpipe::pipeline
