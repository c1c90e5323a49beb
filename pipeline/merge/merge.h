// Tiles and the surface: loading a tile's planes before the first primitive, clearing it, and
// merging it back when its last primitive is done.
// SPDX-License-Identifier: MIT
#pragma once

#include "pipeline/command.h"
#include "pipeline/raster/tile.h"
#include "pipeline/surface.h"

namespace clearpipe::pipeline {

// Copies the target's pixels under the tile into it; pixels past the surface's edge read as 0.
void load_tile(const Target& target, Tile& tile, bool colour, bool depth_stencil);

// Copies the tile's planes that have changed into the target.
void store_tile(const Target& target, const Tile& tile, bool colour, bool depth_stencil);

// Applies glClear to the part of the tile inside the command's rectangle (4.2.3).
void clear_tile(const ClearCommand& clear, Tile& tile);

// The bits of a packed colour or depth/stencil value that a clear changes.
uint32_t colour_clear_mask(const ClearCommand& clear);
uint32_t depth_stencil_clear_mask(const ClearCommand& clear);

}  // namespace clearpipe::pipeline
