// Merging of tiles: see merge.h.
// SPDX-License-Identifier: MIT
#include "pipeline/merge/merge.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace clearpipe::pipeline {

namespace {

// The part of the tile that lies on a plane of the given size.
struct Overlap {
  int columns, rows;
};

Overlap overlap(const Tile& tile, int width, int height) {
  return {std::clamp(width - tile.x, 0, kTileWidth), std::clamp(height - tile.y, 0, kTileHeight)};
}

void load_plane(const uint32_t* plane, int width, int height, const Tile& tile, uint32_t* out) {
  const Overlap part = overlap(tile, width, height);
  if (part.columns < kTileWidth || part.rows < kTileHeight) {
    std::fill_n(out, kTileWidth * kTileHeight, 0u);
  }
  for (int row = 0; row < part.rows; ++row) {
    const uint32_t* from = plane + static_cast<size_t>(tile.y + row) * width + tile.x;
    std::memcpy(out + row * kTileWidth, from, part.columns * sizeof(uint32_t));
  }
}

void store_plane(const uint32_t* in, const Tile& tile, int width, int height, uint32_t* plane) {
  const Overlap part = overlap(tile, width, height);
  for (int row = 0; row < part.rows; ++row) {
    uint32_t* to = plane + static_cast<size_t>(tile.y + row) * width + tile.x;
    std::memcpy(to, in + row * kTileWidth, part.columns * sizeof(uint32_t));
  }
}

void fill_plane(uint32_t* plane, const Rect& part, uint32_t value, uint32_t mask) {
  if (mask == 0) {
    return;
  }
  for (int row = part.y0; row < part.y1; ++row) {
    uint32_t* first = plane + row * kTileWidth + part.x0;
    uint32_t* last = plane + row * kTileWidth + part.x1;
    if (mask == 0xffffffffu) {
      std::fill(first, last, value);
    } else {
      std::for_each(first, last, [&](uint32_t& p) { p = (p & ~mask) | (value & mask); });
    }
  }
}

// The samples' mean (4.1.10), rounded to nearest. Two components of a pixel at a time, in the
// halves of a word.
void resolve_samples(const Tile* tiles, uint32_t* mean) {
  static_assert(kSampleCount == 4);
  constexpr uint32_t kHalves = 0x00ff00ffu, kRounding = 0x00020002u;
  for (int i = 0; i < kTileHeight * kTileWidth; ++i) {
    uint32_t rb = kRounding, ga = kRounding;
    for (int s = 0; s < kSampleCount; ++s) {
      rb += tiles[s].colour[i] & kHalves;
      ga += tiles[s].colour[i] >> 8 & kHalves;
    }
    mean[i] = (rb >> 2 & kHalves) | (ga >> 2 & kHalves) << 8;
  }
}

// Where the plane of a sample, and its part of the uniform tiles, begin.
struct PlaneOfSample {
  size_t offset, tile;

  PlaneOfSample(int width, int height, int sample, size_t tile_index)
      : offset(static_cast<size_t>(width) * height * sample) {
    const size_t columns = static_cast<size_t>((width + kTileWidth - 1) / kTileWidth);
    const size_t rows = static_cast<size_t>((height + kTileHeight - 1) / kTileHeight);
    tile = columns * rows * sample + tile_index;
  }
};

}  // namespace

TilePlane::TilePlane(uint32_t* plane, int width, int height, UniformTiles* uniform, size_t index,
                     const Tile& tile, uint32_t* out)
    : plane_(plane),
      width_(width),
      height_(height),
      uniform_(uniform),
      index_(index),
      tile_(&tile),
      out_(out) {
  if (uniform_ != nullptr && uniform_->is_uniform[index_] != 0) {
    state_ = State::kUniform;
    value_ = uniform_->value[index_];
  }
}

void TilePlane::set_uniform(uint32_t value) {
  state_ = State::kUniform;
  value_ = value;
  changed_ = true;
}

void TilePlane::load() {
  if (state_ == State::kUniform) {
    std::fill_n(out_, kTileWidth * kTileHeight, value_);
  } else if (state_ == State::kStored && plane_ != nullptr) {
    load_plane(plane_, width_, height_, *tile_, out_);
  }
  state_ = State::kLoaded;
}

void TilePlane::store() {
  if (!changed_ || plane_ == nullptr) return;
  if (uniform_ != nullptr) {
    uniform_->is_uniform[index_] = state_ == State::kUniform;
    if (state_ == State::kUniform) {
      uniform_->value[index_] = value_;
      return;
    }
  }
  load();
  store_plane(out_, *tile_, width_, height_, plane_);
}

TilePlanes::TilePlanes(const Target& target, Tile* tiles, int tile_index)
    : target_(target),
      tiles_(tiles),
      tile_index_(static_cast<size_t>(tile_index)),
      samples_(target.samples()) {
  for (int s = 0; s < samples_; ++s) {
    Tile& tile = tiles[s];
    if (const ColourBuffer* to = target.colour.get()) {
      const PlaneOfSample at(to->width, to->height, s, tile_index_);
      colour_[s] = to->samples
                       ? TilePlane(to->samples->values.get() + at.offset, to->width, to->height,
                                   &to->samples->uniform, at.tile, tile, tile.colour)
                       : TilePlane(to->pixels.get(), to->width, to->height, to->uniform.get(),
                                   tile_index_, tile, tile.colour);
    }
    if (const DepthStencilBuffer* to = target.depth_stencil.get()) {
      const PlaneOfSample at(to->width, to->height, s, tile_index_);
      depth_stencil_[s] = TilePlane(to->values.get() + at.offset, to->width, to->height,
                                    to->uniform.get(), at.tile, tile, tile.depth_stencil);
    }
  }
}

void TilePlanes::prepare(const FragmentOutputs& outputs, bool whole_tile) {
  for (int s = 0; s < samples_; ++s) {
    if (outputs.replaces && whole_tile) {
      colour_[s].overwrite();
    } else if (outputs.colour) {
      colour_[s].change();
    }
    if (outputs.depth_stencil_write) {
      depth_stencil_[s].change();
    } else if (outputs.depth_stencil_read) {
      depth_stencil_[s].load();
    }
  }
}

void TilePlanes::store() {
  if (samples_ > 1 && target_.colour) resolve();
  for (int s = 0; s < samples_; ++s) {
    colour_[s].store();
    depth_stencil_[s].store();
  }
}

void TilePlanes::resolve() {
  const auto first = colour_.begin(), end = first + samples_;
  if (std::none_of(first, end, [](const TilePlane& p) { return p.changed(); })) return;
  const ColourBuffer& to = *target_.colour;
  alignas(64) uint32_t mean[kTileHeight * kTileWidth];
  TilePlane pixels(to.pixels.get(), to.width, to.height, to.uniform.get(), tile_index_, *tiles_,
                   mean);
  if (std::all_of(first, end, [&](const TilePlane& p) {
        return p.is_uniform() && p.uniform_value() == first->uniform_value();
      })) {
    pixels.set_uniform(first->uniform_value());
  } else {
    std::for_each(first, end, [](TilePlane& p) { p.load(); });
    pixels.overwrite();
    resolve_samples(tiles_, mean);
  }
  pixels.store();
}

uint32_t colour_clear_mask(const ClearCommand& clear) {
  uint32_t mask = 0;
  for (int i = 0; i < 4; ++i) {
    if (clear.colour && (clear.colour_mask >> i & 1) != 0) {
      mask |= 0xffu << (8 * i);
    }
  }
  return mask;
}

uint32_t depth_stencil_clear_mask(const ClearCommand& clear) {
  return (clear.depth ? 0xffffff00u : 0u) | (clear.stencil ? uint32_t{clear.stencil_mask} : 0u);
}

void clear_plane(const ClearCommand& clear, const Tile& tile, uint32_t* plane, uint32_t value,
                 uint32_t mask) {
  Rect part;
  part.x0 = std::max(clear.rect.x0 - tile.x, 0);
  part.y0 = std::max(clear.rect.y0 - tile.y, 0);
  part.x1 = std::min(clear.rect.x1 - tile.x, kTileWidth);
  part.y1 = std::min(clear.rect.y1 - tile.y, kTileHeight);
  if (part.x0 < part.x1) fill_plane(plane, part, value, mask);
}

}  // namespace clearpipe::pipeline
