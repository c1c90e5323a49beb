// The back phase of a tile: load, then each packet's primitives in order - coverage, planes,
// shading - then merge.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/frame_data.h"
#include "pipeline/merge/merge.h"
#include "pipeline/raster/coverage.h"

namespace clearpipe::pipeline {

namespace {

// Whether a clear sets every bit of every pixel the tile has, so that nothing before it shows.
bool replaces_tile(const ClearCommand& clear, const Target& target, const Tile& tile) {
  const bool whole_tile = clear.rect.x0 <= tile.x && clear.rect.y0 <= tile.y &&
                          (clear.rect.x1 >= tile.x + kTileWidth || clear.rect.x1 >= target.width) &&
                          (clear.rect.y1 >= tile.y + kTileHeight || clear.rect.y1 >= target.height);
  const bool colour = !target.colour || colour_clear_mask(clear) == 0xffffffffu;
  const bool depth_stencil =
      !target.depth_stencil || depth_stencil_clear_mask(clear) == 0xffffffffu;
  return whole_tile && colour && depth_stencil;
}

}  // namespace

void run_back(const std::vector<DrawRecord>& draws,
              const std::vector<std::unique_ptr<Packet>>& packets, size_t packet_count,
              const Target& target, const TileGrid& grid, int tile_index, Tile& tile) {
  tile.x = tile_index % grid.columns * kTileWidth;
  tile.y = tile_index / grid.columns * kTileHeight;

  // Work before a clear that replaces the whole tile never shows.
  size_t first = 0;
  bool loaded = false;
  for (size_t i = packet_count; i-- > 0;) {
    if (packets[i]->is_clear && replaces_tile(packets[i]->clear, target, tile)) {
      first = i;
      loaded = true;
      break;
    }
  }
  bool touched = loaded;
  Coverage coverage;
  for (size_t i = first; i < packet_count; ++i) {
    const Packet& packet = *packets[i];
    const auto list = packet.is_clear ? std::span<const uint32_t>() : packet.bins.tile(tile_index);
    if (!packet.is_clear && list.empty()) {
      continue;
    }
    if (!loaded) {
      load_tile(target, tile, true, true);
      loaded = true;
    }
    touched = true;
    if (packet.is_clear) {
      clear_tile(packet.clear, tile);
      continue;
    }
    for (const uint32_t index : list) {
      const PrimitiveRecord& primitive = packet.primitives[index];
      if (!cover_tile(primitive, tile.x, tile.y, coverage)) {
        continue;
      }
      const DrawRecord& draw = draws[primitive.draw];
      PrimitivePlanes planes;
      make_planes(draw.setup, primitive, planes);
      shade(*draw.program, planes, coverage, tile);
    }
  }
  if (touched) {
    store_tile(target, tile, true, true);
  }
}

}  // namespace clearpipe::pipeline
