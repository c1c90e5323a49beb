// Merging of tiles: see merge.h.
// SPDX-License-Identifier: MIT
#include "pipeline/merge/merge.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <new>

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

std::shared_ptr<UniformTiles> no_uniform_tiles(int width, int height) {
  const size_t columns = static_cast<size_t>((width + kTileWidth - 1) / kTileWidth);
  const size_t rows = static_cast<size_t>((height + kTileHeight - 1) / kTileHeight);
  auto tiles = std::make_shared<UniformTiles>();
  tiles->is_uniform.resize(columns * rows);
  tiles->value.resize(columns * rows);
  return tiles;
}

}  // namespace

std::shared_ptr<ColourBuffer> make_colour_buffer(int width, int height, bool has_alpha) try {
  auto buffer = std::make_shared<ColourBuffer>();
  buffer->width = width;
  buffer->height = height;
  buffer->has_alpha = has_alpha;
  buffer->uniform = no_uniform_tiles(width, height);
  const size_t count = static_cast<size_t>(width) * height;
  buffer->pixels = std::make_shared<uint32_t[]>(count);
  if (!has_alpha) {
    std::fill_n(buffer->pixels.get(), count, 0xff000000u);
  }
  return buffer;
} catch (const std::bad_alloc&) {
  return nullptr;
}

std::shared_ptr<DepthStencilBuffer> make_depth_stencil_buffer(int width, int height, bool has_depth,
                                                              bool has_stencil) try {
  auto buffer = std::make_shared<DepthStencilBuffer>();
  buffer->width = width;
  buffer->height = height;
  buffer->has_depth = has_depth;
  buffer->has_stencil = has_stencil;
  buffer->uniform = no_uniform_tiles(width, height);
  buffer->values = std::make_shared<uint32_t[]>(static_cast<size_t>(width) * height);
  return buffer;
} catch (const std::bad_alloc&) {
  return nullptr;
}

TilePlane::TilePlane(uint32_t* plane, int width, int height, UniformTiles* uniform, int tile_index,
                     const Tile& tile, uint32_t* out)
    : plane_(plane),
      width_(width),
      height_(height),
      uniform_(uniform),
      tile_index_(static_cast<size_t>(tile_index)),
      tile_(tile),
      out_(out) {
  if (uniform_ != nullptr && uniform_->is_uniform[tile_index_] != 0) {
    state_ = State::kUniform;
    value_ = uniform_->value[tile_index_];
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
    load_plane(plane_, width_, height_, tile_, out_);
  }
  state_ = State::kLoaded;
}

void TilePlane::store() {
  if (!changed_ || plane_ == nullptr) return;
  if (uniform_ != nullptr) {
    uniform_->is_uniform[tile_index_] = state_ == State::kUniform;
    if (state_ == State::kUniform) {
      uniform_->value[tile_index_] = value_;
      return;
    }
  }
  load();
  store_plane(out_, tile_, width_, height_, plane_);
}

TilePlanes::TilePlanes(const Target& target, Tile& tile, int tile_index)
    : tile_(tile),
      colour_(target.colour ? target.colour->pixels.get() : nullptr,
              target.colour ? target.colour->width : 0, target.colour ? target.colour->height : 0,
              target.colour ? target.colour->uniform.get() : nullptr, tile_index, tile,
              tile.colour),
      depth_stencil_(target.depth_stencil ? target.depth_stencil->values.get() : nullptr,
                     target.depth_stencil ? target.depth_stencil->width : 0,
                     target.depth_stencil ? target.depth_stencil->height : 0,
                     target.depth_stencil ? target.depth_stencil->uniform.get() : nullptr,
                     tile_index, tile, tile.depth_stencil) {}

void store_uniform_tiles(ColourBuffer& buffer) {
  if (!buffer.uniform) return;
  UniformTiles& tiles = *buffer.uniform;
  const int columns = (buffer.width + kTileWidth - 1) / kTileWidth;
  for (size_t i = 0; i < tiles.is_uniform.size(); ++i) {
    if (tiles.is_uniform[i] == 0) continue;
    tiles.is_uniform[i] = 0;
    const int x = static_cast<int>(i) % columns * kTileWidth;
    const int y = static_cast<int>(i) / columns * kTileHeight;
    const int width = std::min(buffer.width - x, kTileWidth);
    const int end = std::min(buffer.height, y + kTileHeight);
    for (int row = y; row < end; ++row) {
      std::fill_n(buffer.pixels.get() + static_cast<size_t>(row) * buffer.width + x, width,
                  tiles.value[i]);
    }
  }
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
