// The back phase of a tile: each packet's primitives in order - coverage, planes, shading - between
// loading the planes that are needed and merging those that changed.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "pipeline/exec/frame_data.h"
#include "pipeline/merge/merge.h"
#include "pipeline/raster/coverage.h"

namespace clearpipe::pipeline {

namespace {

bool covers_tile(const ClearCommand& clear, const Target& target, const Tile& tile) {
  return clear.rect.x0 <= tile.x && clear.rect.y0 <= tile.y &&
         (clear.rect.x1 >= tile.x + kTileWidth || clear.rect.x1 >= target.width) &&
         (clear.rect.y1 >= tile.y + kTileHeight || clear.rect.y1 >= target.height);
}

// One clear of a tile. What replaces a plane as a whole is only noted.
void clear_planes(const ClearCommand& clear, const Target& target, TilePlanes& planes) {
  const Tile& tile = planes.tile();
  const bool whole = covers_tile(clear, target, tile);
  const uint32_t colour = colour_clear_mask(clear);
  const uint32_t depth_stencil = depth_stencil_clear_mask(clear);
  if (colour != 0) {
    if (whole && colour == 0xffffffffu) {
      planes.colour().set_uniform(clear.colour_value);
    } else {
      clear_plane(clear, tile, planes.colour().change(), clear.colour_value, colour);
    }
  }
  if (depth_stencil != 0) {
    const uint32_t value = clear.depth_value << 8 | clear.stencil_value;
    if (whole && depth_stencil == 0xffffffffu) {
      planes.depth_stencil().set_uniform(value);
    } else {
      clear_plane(clear, tile, planes.depth_stencil().change(), value, depth_stencil);
    }
  }
}

bool is_whole(const Coverage& coverage) {
  return coverage.first_row == 0 && coverage.last_row == kTileHeight &&
         std::all_of(coverage.rows, coverage.rows + kTileHeight,
                     [](uint64_t row) { return row == ~uint64_t{0}; });
}

// The last packet that leaves nothing visible of what came before it.
size_t first_visible(const std::vector<std::unique_ptr<Packet>>& packets, size_t packet_count,
                     const Target& target, const Tile& tile) {
  for (size_t i = packet_count; i-- > 0;) {
    if (!packets[i]->is_clear) continue;
    const ClearCommand& clear = packets[i]->clear;
    if (covers_tile(clear, target, tile) &&
        (!target.colour || colour_clear_mask(clear) == 0xffffffffu) &&
        (!target.depth_stencil || depth_stencil_clear_mask(clear) == 0xffffffffu)) {
      return i;
    }
  }
  return 0;
}

}  // namespace

void run_back(const std::vector<DrawRecord>& draws,
              const std::vector<std::unique_ptr<Packet>>& packets, size_t packet_count,
              const Target& target, const TileGrid& grid, int tile_index, Tile& tile) {
  tile.x = tile_index % grid.columns * kTileWidth;
  tile.y = tile_index / grid.columns * kTileHeight;
  tile.mirror_height = target.mirrored ? target.height : 0;
  TilePlanes planes(target, tile, tile_index);
  Coverage coverage;
  for (size_t i = first_visible(packets, packet_count, target, tile); i < packet_count; ++i) {
    const Packet& packet = *packets[i];
    if (packet.is_clear) {
      clear_planes(packet.clear, target, planes);
      continue;
    }
    for (const uint32_t index : packet.bins.tile(tile_index)) {
      const PrimitiveRecord& primitive = packet.primitives[index];
      if (!cover_tile(primitive, tile.x, tile.y, coverage)) {
        continue;
      }
      const DrawRecord& draw = draws[primitive.draw];
      planes.prepare(draw.outputs, is_whole(coverage));
      PrimitivePlanes attributes;
      make_planes(draw.setup, primitive, attributes);
      shade(*draw.program, attributes, coverage, tile);
    }
  }
  planes.store();
}

}  // namespace clearpipe::pipeline
