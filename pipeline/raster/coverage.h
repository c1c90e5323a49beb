// Which pixels of a tile a primitive covers (3.5.1): edge functions evaluated a row at a time.
// SPDX-License-Identifier: MIT
#pragma once

#include "pipeline/raster/tile.h"
#include "pipeline/setup/primitive.h"

namespace clearpipe::pipeline {

// The edges that cross a tile, as 32-bit functions of the position in it. An edge whose half plane
// holds the whole tile is left out.
struct TileEdges {
  int count = 0;
  int32_t a[4], b[4], c[4];  // inside: a * column + b * row + c >= 0
};

enum class TileOverlap : uint8_t { kOutside, kPartial, kInside };

// How the edges of `primitive` lie to the tile whose first pixel is (tile_x, tile_y).
TileOverlap classify_tile(const PrimitiveRecord& primitive, int tile_x, int tile_y,
                          TileEdges& edges);

// Fills `coverage`; false when no pixel of the tile is covered.
bool cover_tile(const PrimitiveRecord& primitive, int tile_x, int tile_y, Coverage& coverage);

}  // namespace clearpipe::pipeline
