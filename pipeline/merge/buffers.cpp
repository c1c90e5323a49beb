// Making colour and depth/stencil buffers, and storing what they only have written down: see
// surface.h.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <new>

#include "pipeline/raster/tile.h"
#include "pipeline/surface.h"

namespace clearpipe::pipeline {

namespace {

size_t tile_count(int width, int height) {
  const size_t columns = static_cast<size_t>((width + kTileWidth - 1) / kTileWidth);
  const size_t rows = static_cast<size_t>((height + kTileHeight - 1) / kTileHeight);
  return columns * rows;
}

UniformTiles no_uniform_tiles(size_t count) {
  UniformTiles tiles;
  tiles.is_uniform.resize(count);
  tiles.value.resize(count);
  return tiles;
}

}  // namespace

std::shared_ptr<ColourBuffer> make_colour_buffer(int width, int height, bool has_alpha,
                                                 int samples) try {
  auto buffer = std::make_shared<ColourBuffer>();
  buffer->width = width;
  buffer->height = height;
  buffer->has_alpha = has_alpha;
  const size_t tiles = tile_count(width, height);
  buffer->uniform = std::make_shared<UniformTiles>(no_uniform_tiles(tiles));
  const size_t count = static_cast<size_t>(width) * height;
  buffer->pixels = std::make_shared<uint32_t[]>(count);
  if (!has_alpha) {
    std::fill_n(buffer->pixels.get(), count, 0xff000000u);
  }
  if (samples > 1) {
    buffer->samples = std::make_shared<SampleBuffer>();
    buffer->samples->values = std::make_unique_for_overwrite<uint32_t[]>(samples * count);
    UniformTiles& uniform = buffer->samples->uniform;
    uniform = no_uniform_tiles(samples * tiles);
    std::fill(uniform.is_uniform.begin(), uniform.is_uniform.end(), uint8_t{1});
    std::fill(uniform.value.begin(), uniform.value.end(), has_alpha ? 0 : 0xff000000u);
  }
  return buffer;
} catch (const std::bad_alloc&) {
  return nullptr;
}

std::shared_ptr<DepthStencilBuffer> make_depth_stencil_buffer(int width, int height, bool has_depth,
                                                              bool has_stencil, int samples) try {
  auto buffer = std::make_shared<DepthStencilBuffer>();
  buffer->width = width;
  buffer->height = height;
  buffer->samples = samples;
  buffer->has_depth = has_depth;
  buffer->has_stencil = has_stencil;
  buffer->uniform =
      std::make_shared<UniformTiles>(no_uniform_tiles(samples * tile_count(width, height)));
  buffer->values = std::make_shared<uint32_t[]>(static_cast<size_t>(width) * height * samples);
  return buffer;
} catch (const std::bad_alloc&) {
  return nullptr;
}

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

}  // namespace clearpipe::pipeline
