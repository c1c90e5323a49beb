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

}  // namespace

std::shared_ptr<ColourBuffer> make_colour_buffer(int width, int height, bool has_alpha) try {
  auto buffer = std::make_shared<ColourBuffer>();
  buffer->width = width;
  buffer->height = height;
  buffer->has_alpha = has_alpha;
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
  buffer->values = std::make_shared<uint32_t[]>(static_cast<size_t>(width) * height);
  return buffer;
} catch (const std::bad_alloc&) {
  return nullptr;
}

void load_tile(const Target& target, Tile& tile, bool colour, bool depth_stencil) {
  if (colour && target.colour) {
    const ColourBuffer& buffer = *target.colour;
    load_plane(buffer.pixels.get(), buffer.width, buffer.height, tile, tile.colour);
  }
  if (depth_stencil && target.depth_stencil) {
    const DepthStencilBuffer& buffer = *target.depth_stencil;
    load_plane(buffer.values.get(), buffer.width, buffer.height, tile, tile.depth_stencil);
  }
}

void store_tile(const Target& target, const Tile& tile, bool colour, bool depth_stencil) {
  if (colour && target.colour) {
    ColourBuffer& buffer = *target.colour;
    store_plane(tile.colour, tile, buffer.width, buffer.height, buffer.pixels.get());
  }
  if (depth_stencil && target.depth_stencil) {
    DepthStencilBuffer& buffer = *target.depth_stencil;
    store_plane(tile.depth_stencil, tile, buffer.width, buffer.height, buffer.values.get());
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

void clear_tile(const ClearCommand& clear, Tile& tile) {
  Rect part;
  part.x0 = std::max(clear.rect.x0 - tile.x, 0);
  part.y0 = std::max(clear.rect.y0 - tile.y, 0);
  part.x1 = std::min(clear.rect.x1 - tile.x, kTileWidth);
  part.y1 = std::min(clear.rect.y1 - tile.y, kTileHeight);
  if (part.x0 >= part.x1) {
    return;
  }
  fill_plane(tile.colour, part, clear.colour_value, colour_clear_mask(clear));
  fill_plane(tile.depth_stencil, part, clear.depth_value << 8 | clear.stencil_value,
             depth_stencil_clear_mask(clear));
}

}  // namespace clearpipe::pipeline
