// A tile with memory of its own, zero at first, for tests of what works on tiles.
// SPDX-License-Identifier: MIT
#pragma once

#include "pipeline/raster/tile.h"

namespace clearpipe::pipeline {

struct OwnTile : Tile {
  TileMemory memory{};

  OwnTile() { use_memory(); }
  OwnTile(const OwnTile& other) : Tile(other), memory(other.memory) { use_memory(); }
  OwnTile& operator=(const OwnTile& other) {
    Tile::operator=(other);
    memory = other.memory;
    use_memory();
    return *this;
  }
  ~OwnTile() = default;

 private:
  void use_memory() {
    colour = memory.colour;
    depth_stencil = memory.depth_stencil;
  }
};

}  // namespace clearpipe::pipeline
