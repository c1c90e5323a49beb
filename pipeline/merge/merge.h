// Tiles and the surface: a tile's planes are loaded when something needs them, and merged back when
// the tile's last primitive is done and they have changed.
// SPDX-License-Identifier: MIT
#pragma once

#include "pipeline/command.h"
#include "pipeline/fragment/program.h"
#include "pipeline/raster/tile.h"
#include "pipeline/surface.h"

namespace clearpipe::pipeline {

// One plane of a tile while it is worked on. What is known to be one value throughout (a cleared
// tile) is written out only when something draws to it.
class TilePlane {
 public:
  // `plane` is the surface's, null when the target has none; `out` is the tile's.
  TilePlane(uint32_t* plane, int width, int height, UniformTiles* uniform, int tile_index,
            const Tile& tile, uint32_t* out);

  void set_uniform(uint32_t value);

  // Makes the tile's memory hold the plane, to be read.
  void load();

  // The same, to be written; returns the tile's memory.
  uint32_t* change() {
    load();
    changed_ = true;
    return out_;
  }

  // The plane is written as a whole: what it held need not be loaded.
  void overwrite() {
    state_ = State::kLoaded;
    changed_ = true;
  }

  void store();

 private:
  enum class State : uint8_t { kStored, kUniform, kLoaded };

  uint32_t* plane_;
  int width_, height_;
  UniformTiles* uniform_;
  size_t tile_index_;
  const Tile& tile_;
  uint32_t* out_;
  State state_ = State::kStored;
  bool changed_ = false;
  uint32_t value_ = 0;  // in kUniform
};

class TilePlanes {
 public:
  TilePlanes(const Target& target, Tile& tile, int tile_index);

  const Tile& tile() const { return tile_; }
  TilePlane& colour() { return colour_; }
  TilePlane& depth_stencil() { return depth_stencil_; }

  // Before something is shaded, perhaps over the whole tile.
  void prepare(const FragmentOutputs& outputs, bool whole_tile) {
    if (outputs.replaces && whole_tile) {
      colour_.overwrite();
    } else if (outputs.colour) {
      colour_.change();
    }
    if (outputs.depth_stencil_write) {
      depth_stencil_.change();
    } else if (outputs.depth_stencil_read) {
      depth_stencil_.load();
    }
  }

  void store() {
    colour_.store();
    depth_stencil_.store();
  }

 private:
  const Tile& tile_;
  TilePlane colour_, depth_stencil_;
};

// Applies glClear to the part of a tile's plane inside the command's rectangle (4.2.3): the bits of
// `mask` become those of `value`.
void clear_plane(const ClearCommand& clear, const Tile& tile, uint32_t* plane, uint32_t value,
                 uint32_t mask);

// The bits of a packed colour or depth/stencil value that a clear changes.
uint32_t colour_clear_mask(const ClearCommand& clear);
uint32_t depth_stencil_clear_mask(const ClearCommand& clear);

}  // namespace clearpipe::pipeline
