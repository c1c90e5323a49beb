// Tiles and the surface: a tile's planes are loaded when something needs them, and merged back when
// the tile's last primitive is done and they have changed.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "pipeline/command.h"
#include "pipeline/fragment/program.h"
#include "pipeline/raster/tile.h"
#include "pipeline/surface.h"

namespace clearpipe::pipeline {

// One plane of a tile while it is worked on. What is known to be one value throughout (a cleared
// tile) is written out only when something draws to it.
class TilePlane {
 public:
  // One of a surface that is not there.
  TilePlane() = default;
  // One of a plane that is laid out in tiles, which is worked on where it is; `index` is its place
  // among the tiles.
  TilePlane(uint32_t* plane, UniformTiles& uniform, size_t index);
  // One of a plane that is laid out in rows; it is worked on in `out`.
  TilePlane(uint32_t* plane, int width, int height, const Tile& tile, uint32_t* out);

  // What the plane holds is that part of the rows.
  void take_from_rows(uint32_t* rows, int width, int height, const Tile& tile);

  // What the plane is worked on in; null for one that is not there.
  uint32_t* memory() const { return out_; }

  void set_uniform(uint32_t value) { set_bits(value, 0xffffffffu); }
  bool is_uniform() const { return bits_ == 0xffffffffu; }
  uint32_t uniform_value() const { return value_; }
  bool changed() const { return changed_; }

  // Makes the tile's memory hold the plane, to be read.
  void load();

  // The same, to be written; returns the tile's memory. `bits` of pixels may become anything.
  uint32_t* change(uint32_t bits) {
    load();
    bits_ &= ~bits;
    changed_ = true;
    return out_;
  }

  // In all pixels the bits of `mask` become those of `value`. Returns whether that is all there is
  // to do: otherwise they have to be written.
  bool set_bits(uint32_t value, uint32_t mask);

  // The plane is written as a whole: what it held need not be loaded.
  void overwrite() {
    state_ = State::kLoaded;
    bits_ = 0;
    changed_ = true;
  }

  void store();

 private:
  enum class State : uint8_t { kStored, kUniform, kLoaded };

  uint32_t* out_ = nullptr;
  UniformTiles* uniform_ = nullptr;  // null: the plane is laid out in rows
  size_t index_ = 0;
  uint32_t* rows_ = nullptr;  // what it is in before it is loaded, if not in out_
  int width_ = 0, height_ = 0;
  const Tile* tile_ = nullptr;
  State state_ = State::kStored;
  bool changed_ = false;
  uint32_t bits_ = 0;  // that all pixels share with value_
  uint32_t value_ = 0;
};

// The planes of a tile: colour and depth/stencil of each sample. Of a multisampled target, the mean
// of the samples goes into the colour buffer (4.1.10).
class TilePlanes {
 public:
  // Makes the tiles' planes those of the target's tile.
  TilePlanes(const Target& target, SampleTiles& tiles, int tile_index);

  int samples() const { return samples_; }
  const Tile& tile() const { return tiles_.tiles[0]; }
  TilePlane& colour(int sample) { return colour_[sample]; }
  TilePlane& depth_stencil(int sample) { return depth_stencil_[sample]; }

  // Before something is shaded, perhaps over the whole tile.
  void prepare(const FragmentOutputs& outputs, bool whole_tile);

  void store();

 private:
  bool samples_discarded() const;
  void resolve();

  const Target& target_;
  SampleTiles& tiles_;
  size_t tile_index_;
  int samples_;
  std::array<TilePlane, kSampleCount> colour_, depth_stencil_;
};

// Applies glClear to the part of a tile's plane inside the command's rectangle (4.2.3): the bits of
// `mask` become those of `value`.
void clear_plane(const ClearCommand& clear, const Tile& tile, uint32_t* plane, uint32_t value,
                 uint32_t mask);

// The bits of a packed colour or depth/stencil value that a clear changes.
uint32_t colour_clear_mask(const ClearCommand& clear);
uint32_t depth_stencil_clear_mask(const ClearCommand& clear);

}  // namespace clearpipe::pipeline
