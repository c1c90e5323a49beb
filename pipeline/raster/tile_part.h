// The part of a tile that the box of a primitive takes.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "pipeline/setup/primitive.h"

namespace clearpipe::pipeline::raster {

// Columns and rows of the tile; half-open.
struct TilePart {
  int x0, y0, x1, y1;
  bool empty() const { return x0 >= x1 || y0 >= y1; }
};

// Of anything that has a box.
template <class Boxed>
TilePart part_of_tile(const Boxed& primitive, int tile_x, int tile_y) {
  return {std::max(primitive.x0 - tile_x, 0), std::max(primitive.y0 - tile_y, 0),
          std::min(primitive.x1 - tile_x, kTileWidth),
          std::min(primitive.y1 - tile_y, kTileHeight)};
}

}  // namespace clearpipe::pipeline::raster
