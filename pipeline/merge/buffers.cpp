// Making colour and depth/stencil buffers, and reading what they hold: see surface.h.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <new>

#include "pipeline/exec/pieces.h"
#include "pipeline/image.h"
#include "pipeline/image_memory.h"
#include "pipeline/raster/tile.h"
#include "pipeline/surface.h"

namespace clearpipe::pipeline {

namespace {

// Not initialised: tiles that are noted as uniform are written before they are read.
std::shared_ptr<uint32_t[]> allocate_tiles(size_t count) {
  const size_t bytes = count * kTilePixels * sizeof(uint32_t);
  auto* memory = static_cast<uint32_t*>(allocate_memory(bytes));
  return {memory, [bytes](uint32_t* p) { free_memory(p, bytes); }};
}

UniformTiles all_uniform(size_t count, uint32_t value) {
  UniformTiles tiles;
  tiles.bits.resize(count, 0xffffffffu);
  tiles.value.resize(count, value);
  return tiles;
}

}  // namespace

size_t tile_count(int width, int height) {
  const size_t columns = static_cast<size_t>((width + kTileWidth - 1) / kTileWidth);
  const size_t rows = static_cast<size_t>((height + kTileHeight - 1) / kTileHeight);
  return columns * rows;
}

size_t place_in_tiles(int width, int x, int y) {
  const size_t columns = static_cast<size_t>((width + kTileWidth - 1) / kTileWidth);
  const size_t tile = static_cast<size_t>(y / kTileHeight) * columns + x / kTileWidth;
  return tile * kTilePixels + static_cast<size_t>(y % kTileHeight) * kTileWidth + x % kTileWidth;
}

std::shared_ptr<ColourBuffer> make_colour_buffer(int width, int height, bool has_alpha,
                                                 int samples) try {
  auto buffer = std::make_shared<ColourBuffer>();
  buffer->width = width;
  buffer->height = height;
  buffer->has_alpha = has_alpha;
  const size_t tiles = tile_count(width, height);
  const uint32_t initial = has_alpha ? 0 : 0xff000000u;
  buffer->uniform = std::make_shared<UniformTiles>(all_uniform(tiles, initial));
  buffer->pixels = allocate_tiles(tiles);
  if (samples > 1) {
    buffer->samples = std::make_shared<SampleBuffer>();
    buffer->samples->values = allocate_tiles(samples * tiles);
    buffer->samples->uniform = all_uniform(samples * tiles, initial);
  }
  return buffer;
} catch (const std::bad_alloc&) {
  return nullptr;
}

std::shared_ptr<SampleBuffer> make_sample_buffer(int width, int height) try {
  auto samples = std::make_shared<SampleBuffer>();
  const size_t tiles = tile_count(width, height);
  samples->values = allocate_tiles(kSampleCount * tiles);
  samples->uniform = all_uniform(kSampleCount * tiles, 0);
  samples->discarded.resize(tiles, 1);
  return samples;
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
  const size_t tiles = samples * tile_count(width, height);
  buffer->uniform = std::make_shared<UniformTiles>(all_uniform(tiles, 0));
  buffer->values = allocate_tiles(tiles);
  return buffer;
} catch (const std::bad_alloc&) {
  return nullptr;
}

void read_pixels(const ColourBuffer& buffer, int x, int y, int count, void* out) {
  auto* to = static_cast<std::byte*>(out);
  const auto copy = [&to](const uint32_t* from, int pixels) {
    const size_t bytes = static_cast<size_t>(pixels) * sizeof(uint32_t);
    std::memcpy(to, from, bytes);
    to += bytes;
  };
  if (!buffer.uniform) {
    copy(buffer.pixels.get() + static_cast<size_t>(y) * buffer.width + x, count);
    return;
  }
  for (int end = x + count; x < end;) {
    const int part = std::min(kTileWidth - x % kTileWidth, end - x);
    const size_t place = place_in_tiles(buffer.width, x, y);
    const size_t tile = place / kTilePixels;
    if (buffer.uniform->is_uniform(tile)) {
      uint32_t row[kTileWidth];
      std::fill_n(row, part, buffer.uniform->value[tile]);
      copy(row, part);
    } else {
      copy(buffer.pixels.get() + place, part);
    }
    x += part;
  }
}

void write_pixels(ColourBuffer& buffer, int x, int y, int count, const uint32_t* from) {
  if (!buffer.uniform) {
    std::copy_n(from, count, buffer.pixels.get() + static_cast<size_t>(y) * buffer.width + x);
    return;
  }
  for (int end = x + count; x < end;) {
    const int part = std::min(kTileWidth - x % kTileWidth, end - x);
    const size_t place = place_in_tiles(buffer.width, x, y);
    const size_t tile = place / kTilePixels;
    if (buffer.uniform->is_uniform(tile)) {
      std::fill_n(buffer.pixels.get() + tile * kTilePixels, kTilePixels,
                  buffer.uniform->value[tile]);
    }
    buffer.uniform->bits[tile] = 0;
    std::copy_n(from, part, buffer.pixels.get() + place);
    from += part;
    x += part;
  }
}

namespace {

struct Rectangle {
  const ColourBuffer& buffer;
  int x, y, count, rows;
  std::byte* out;
  size_t row_bytes;
};

// A row of tiles, of which each lies in one stretch.
void read_tile_row(const Rectangle& r, int row) {
  const int y0 = std::max(row * kTileHeight, r.y);
  const int y1 = std::min((row + 1) * kTileHeight, r.y + r.rows);
  for (int x = r.x; x < r.x + r.count;) {
    const int part = std::min(kTileWidth - x % kTileWidth, r.x + r.count - x);
    std::byte* to = r.out + static_cast<size_t>(y0 - r.y) * r.row_bytes +
                    static_cast<size_t>(x - r.x) * sizeof(uint32_t);
    const size_t place = place_in_tiles(r.buffer.width, x, y0);
    const size_t tile = place / kTilePixels;
    uint32_t same[kTileWidth];
    const bool uniform = r.buffer.uniform->is_uniform(tile);
    if (uniform) std::fill_n(same, part, r.buffer.uniform->value[tile]);
    const uint32_t* from = uniform ? same : r.buffer.pixels.get() + place;
    const size_t step = uniform ? 0 : kTileWidth;
    for (int y = y0; y < y1; ++y, from += step, to += r.row_bytes) {
      if (part == kTileWidth) {
        std::memcpy(to, from, kTileWidth * sizeof(uint32_t));  // moves, not a call
      } else {
        std::memcpy(to, from, static_cast<size_t>(part) * sizeof(uint32_t));
      }
    }
    x += part;
  }
}

}  // namespace

void read_rectangle(const ColourBuffer& buffer, int x, int y, int count, int rows, void* out,
                    size_t row_bytes) {
  if (!buffer.uniform) {
    for (int row = 0; row < rows; ++row) {
      read_pixels(buffer, x, y + row, count, static_cast<std::byte*>(out) + row * row_bytes);
    }
    return;
  }
  // Below this, waking threads costs more than they save.
  constexpr int64_t kManyPixels = 256 * 1024;
  const Rectangle rectangle{buffer, x, y, count, rows, static_cast<std::byte*>(out), row_bytes};
  const int first = y / kTileHeight, end = (y + rows + kTileHeight - 1) / kTileHeight;
  if (int64_t{count} * rows < kManyPixels) {
    for (int row = first; row < end; ++row) read_tile_row(rectangle, row);
  } else {
    run_pieces(static_cast<size_t>(end - first),
               [&](size_t i) { read_tile_row(rectangle, first + static_cast<int>(i)); });
  }
}

bool lay_out_in_rows(ColourBuffer& buffer) try {
  if (!buffer.uniform) return true;
  const size_t width = static_cast<size_t>(buffer.width);
  auto rows = Texels::for_overwrite(width * buffer.height).memory();
  read_rectangle(buffer, 0, 0, buffer.width, buffer.height, rows.get(), width * sizeof(uint32_t));
  buffer.pixels = std::move(rows);
  buffer.uniform = nullptr;
  return true;
} catch (const std::bad_alloc&) {
  return false;
}

}  // namespace clearpipe::pipeline
