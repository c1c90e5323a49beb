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

// A clear of one plane of a tile. What replaces it as a whole is only noted.
void clear_tile_plane(const ClearCommand& clear, bool whole, const Tile& tile, uint32_t value,
                      uint32_t mask, TilePlane& plane) {
  if (mask == 0) return;
  if (whole && mask == 0xffffffffu) {
    plane.set_uniform(value);
  } else {
    clear_plane(clear, tile, plane.change(), value, mask);
  }
}

void clear_planes(const ClearCommand& clear, const Target& target, TilePlanes& planes) {
  const Tile& tile = planes.tile();
  const bool whole = covers_tile(clear, target, tile);
  for (int s = 0; s < planes.samples(); ++s) {
    clear_tile_plane(clear, whole, tile, clear.colour_value, colour_clear_mask(clear),
                     planes.colour(s));
    clear_tile_plane(clear, whole, tile, clear.depth_value << 8 | clear.stencil_value,
                     depth_stencil_clear_mask(clear), planes.depth_stencil(s));
  }
}

// The coverage of each sample: where it is not found at the samples, it is full (3.2.1).
bool cover(const PrimitiveRecord& primitive, const TilePlanes& planes, Coverage* coverage) {
  const Tile& tile = planes.tile();
  if (primitive.multisample) return cover_samples(primitive, tile.x, tile.y, coverage);
  if (!cover_tile(primitive, tile.x, tile.y, coverage[0])) return false;
  std::fill_n(coverage + 1, planes.samples() - 1, coverage[0]);
  return true;
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
              const Target& target, const TileGrid& grid, int tile_index, SampleTiles& tiles) {
  for (Tile& tile : tiles.tiles) {
    tile.x = tile_index % grid.columns * kTileWidth;
    tile.y = tile_index / grid.columns * kTileHeight;
    tile.mirror_height = target.mirrored ? target.height : 0;
  }
  TilePlanes planes(target, tiles, tile_index);
  const int samples = planes.samples();
  Coverage coverage[kSampleCount];
  for (size_t i = first_visible(packets, packet_count, target, planes.tile()); i < packet_count;
       ++i) {
    const Packet& packet = *packets[i];
    if (packet.is_clear) {
      clear_planes(packet.clear, target, planes);
      continue;
    }
    for (const uint32_t index : packet.bins.tile(tile_index)) {
      const PrimitiveRecord& primitive = packet.primitives[index];
      if (!cover(primitive, planes, coverage)) {
        continue;
      }
      const DrawState& draw = *draws[primitive.draw].state;
      planes.prepare(draw.outputs,
                     draw.outputs.replaces && std::all_of(coverage, coverage + samples, is_whole));
      PrimitivePlanes attributes;
      make_planes(draw.setup, primitive, attributes);
      if (samples > 1) {
        shade_samples(*draw.program, attributes, coverage, tiles.tiles.data());
      } else {
        shade(*draw.program, attributes, coverage[0], tiles.tiles[0]);
      }
    }
  }
  planes.store();
}

}  // namespace clearpipe::pipeline
