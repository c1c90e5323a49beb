// Which pixels of a tile a primitive covers (3.5.1): edge functions evaluated a row at a time, at
// the pixels' centres or at their samples (3.5.3).
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

// How the edges of `primitive` lie to the tile whose first pixel is (tile_x, tile_y), for one place
// of each pixel.
TileOverlap classify_tile(const PrimitiveRecord& primitive, int tile_x, int tile_y,
                          const SamplePlace& place, TileEdges& edges);

// Whether the edges leave every place that counts for the primitive's coverage outside.
bool misses_tile(const PrimitiveRecord& primitive, int tile_x, int tile_y);

// Fills `coverage`; false when no pixel of the tile is covered.
bool cover_tile(const PrimitiveRecord& primitive, int tile_x, int tile_y, Coverage& coverage);

// The same for each sample; false when no sample of the tile is covered.
bool cover_samples(const PrimitiveRecord& primitive, int tile_x, int tile_y,
                   Coverage coverage[kSampleCount]);

}  // namespace clearpipe::pipeline
