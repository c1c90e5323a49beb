// Merging of tiles: see merge.h.
// SPDX-License-Identifier: MIT
#include "pipeline/merge/merge.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "pipeline/srgb.h"

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
    std::fill_n(out, kTilePixels, 0u);
  }
  for (int row = 0; row < part.rows; ++row) {
    const uint32_t* from = plane + static_cast<size_t>(tile.y + row) * width + tile.x;
    std::memcpy(out + row * kTileWidth, from, part.columns * sizeof(uint32_t));
  }
}

// Copies of what there is already: their stores are the widest that the processor has.
void fill_tile(uint32_t* out, uint32_t value) {
  size_t filled = kTileWidth;
  std::fill_n(out, filled, value);
  for (; filled < kTilePixels; filled *= 2) std::memcpy(out + filled, out, filled * sizeof(value));
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
  for (int i = 0; i < kTilePixels; ++i) {
    uint32_t rb = kRounding, ga = kRounding;
    for (int s = 0; s < kSampleCount; ++s) {
      rb += tiles[s].colour[i] & kHalves;
      ga += tiles[s].colour[i] >> 8 & kHalves;
    }
    mean[i] = (rb >> 2 & kHalves) | (ga >> 2 & kHalves) << 8;
  }
}

// The same of linear colours.
void resolve_srgb(const Tile* tiles, uint32_t* mean) {
  for (int i = 0; i < kTilePixels; ++i) {
    uint32_t samples[kSampleCount];
    for (int s = 0; s < kSampleCount; ++s) samples[s] = tiles[s].colour[i];
    mean[i] = mean_srgb(samples);
  }
}

// A mean that the format does not have is truncated as fragments are.
void truncate_tile(ColourFormat format, uint32_t* pixels) {
  std::transform(pixels, pixels + kTilePixels, pixels,
                 [format](uint32_t pixel) { return truncate(format, pixel); });
}

// The pixels themselves, not their samples.
TilePlane pixels_of(const ColourBuffer& buffer, size_t tile_index, const Tile& tile,
                    uint32_t* memory) {
  uint32_t* pixels = buffer.pixels.get();
  return buffer.uniform ? TilePlane(pixels, *buffer.uniform, tile_index)
                        : TilePlane(pixels, buffer.width, buffer.height, tile, memory);
}

}  // namespace

TilePlane::TilePlane(uint32_t* plane, UniformTiles& uniform, size_t index)
    : out_(plane + index * kTilePixels), uniform_(&uniform), index_(index) {
  bits_ = uniform.bits[index];
  value_ = uniform.value[index];
  if (is_uniform()) state_ = State::kUniform;
}

TilePlane::TilePlane(uint32_t* plane, int width, int height, const Tile& tile, uint32_t* out)
    : out_(out), rows_(plane), width_(width), height_(height), tile_(&tile) {}

void TilePlane::take_from_rows(uint32_t* rows, int width, int height, const Tile& tile) {
  state_ = State::kStored;
  bits_ = 0;
  rows_ = rows;
  width_ = width;
  height_ = height;
  tile_ = &tile;
}

bool TilePlane::set_bits(uint32_t value, uint32_t mask) {
  bits_ |= mask;
  value_ = (value_ & ~mask) | (value & mask);
  changed_ = true;
  if (is_uniform()) state_ = State::kUniform;
  return is_uniform();
}

void TilePlane::load() {
  if (state_ == State::kUniform) {
    fill_tile(out_, value_);
  } else if (state_ == State::kStored && rows_ != nullptr) {
    load_plane(rows_, width_, height_, *tile_, out_);
  }
  state_ = State::kLoaded;
}

void TilePlane::store() {
  if (!changed_ || out_ == nullptr) return;
  if (uniform_ != nullptr) {
    uniform_->bits[index_] = bits_;
    uniform_->value[index_] = value_;
    return;
  }
  load();
  store_plane(out_, *tile_, width_, height_, rows_);
}

TilePlanes::TilePlanes(const Target& target, SampleTiles& tiles, int tile_index)
    : target_(target),
      tiles_(tiles),
      tile_index_(static_cast<size_t>(tile_index)),
      samples_(target.samples()) {
  const size_t plane_tiles = tile_count(target.width, target.height);
  for (int s = 0; s < samples_; ++s) {
    Tile& tile = tiles.tiles[s];
    const size_t index = plane_tiles * s + tile_index_;
    if (const ColourBuffer* to = target.colour.get()) {
      colour_[s] = to->samples ? TilePlane(to->samples->values.get(), to->samples->uniform, index)
                               : pixels_of(*to, tile_index_, tile,
                                           to->uniform ? nullptr : tiles.memory(s).colour);
      if (samples_discarded()) {
        colour_[s].take_from_rows(to->pixels.get(), to->width, to->height, tile);
      }
    }
    if (const DepthStencilBuffer* to = target.depth_stencil.get()) {
      depth_stencil_[s] = TilePlane(to->values.get(), *to->uniform, index);
    }
    tile.colour = target.colour ? colour_[s].memory() : tiles.memory(s).colour;
    tile.depth_stencil =
        target.depth_stencil ? depth_stencil_[s].memory() : tiles.memory(s).depth_stencil;
  }
}

bool TilePlanes::samples_discarded() const {
  const SampleBuffer* samples = target_.colour->samples.get();
  return samples != nullptr && !samples->discarded.empty() && samples->discarded[tile_index_] != 0;
}

void TilePlanes::prepare(const FragmentOutputs& outputs, bool whole_tile) {
  for (int s = 0; s < samples_; ++s) {
    if (outputs.replaces && whole_tile) {
      colour_[s].overwrite();
    } else if (outputs.colour) {
      colour_[s].change(0xffffffffu);
    }
    if (outputs.depth_stencil_write != 0) {
      depth_stencil_[s].change(outputs.depth_stencil_write);
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
  // Commands change all samples, or none.
  const TilePlane& first = colour_[0];
  if (!first.changed()) return;
  const ColourBuffer& to = *target_.colour;
  alignas(64) uint32_t memory[kTilePixels];
  TilePlane pixels = pixels_of(to, tile_index_, tile(), memory);
  if (first.is_uniform()) {
    pixels.set_uniform(first.uniform_value());
  } else {
    pixels.overwrite();
    (to.srgb ? resolve_srgb : resolve_samples)(tiles_.tiles.data(), pixels.memory());
    if (to.format != ColourFormat::kRgba8) truncate_tile(to.format, pixels.memory());
  }
  pixels.store();
  if (samples_discarded()) to.samples->discarded[tile_index_] = 0;
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
