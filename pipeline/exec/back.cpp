// The back phase of a tile: each packet's primitives in order - coverage,
// planes, shading - between loading the planes that are needed and merging
// those that changed. SPDX-License-Identifier: MIT
#include <hwy/cache_control.h>

#include <algorithm>
#include <atomic>
#include <bit>

#include "pipeline/exec/dots.h"
#include "pipeline/exec/frame_data.h"
#include "pipeline/exec/small.h"
#include "pipeline/exec/strokes.h"
#include "pipeline/exec/tile_depth.h"
#include "pipeline/fragment/usage.h"
#include "pipeline/merge/merge.h"
#include "pipeline/raster/coverage.h"
#include "pipeline/raster/squares.h"
#include "pipeline/raster/stroke.h"

namespace clearpipe::pipeline {

namespace {

bool covers_tile(const ClearCommand& clear, const Target& target, const Tile& tile) {
  return clear.rect.x0 <= tile.x && clear.rect.y0 <= tile.y &&
         (clear.rect.x1 >= tile.x + kTileWidth || clear.rect.x1 >= target.width) &&
         (clear.rect.y1 >= tile.y + kTileHeight || clear.rect.y1 >= target.height);
}

// A clear of one plane of a tile. What leaves it with one value is only noted.
void clear_tile_plane(const ClearCommand& clear, bool whole, const Tile& tile, uint32_t value,
                      uint32_t mask, TilePlane& plane) {
  if (mask == 0) return;
  if (whole && plane.set_bits(value, mask)) return;
  clear_plane(clear, tile, plane.change(whole ? 0 : mask), value, mask);
}

void clear_planes(const ClearCommand& clear, const Target& target, TilePlanes& planes,
                  TileDepth& depth) {
  const Tile& tile = planes.tile();
  const bool whole = covers_tile(clear, target, tile);
  if (clear.depth) depth.cleared(clear.depth_value, whole);
  for (int s = 0; s < planes.samples(); ++s) {
    clear_tile_plane(clear, whole, tile, clear.colour_value, colour_clear_mask(clear),
                     planes.colour(s));
    clear_tile_plane(clear, whole, tile, clear.depth_value << 8 | clear.stencil_value,
                     depth_stencil_clear_mask(clear), planes.depth_stencil(s));
  }
}

// The coverage of each sample: where it is not found at the samples, it is full
// (3.2.1).
bool cover(const PrimitiveRecord& primitive, const TilePlanes& planes, Coverage* coverage) {
  const Tile& tile = planes.tile();
  if (primitive.multisample) return cover_samples(primitive, tile.x, tile.y, coverage);
  if (!cover_tile(primitive, tile.x, tile.y, coverage[0])) return false;
  std::fill_n(coverage + 1, planes.samples() - 1, coverage[0]);
  return true;
}

// Whether all pixels of the tile that are the target's are covered.
bool is_whole(const Coverage& coverage, const Target& target, const Tile& tile) {
  const int columns = std::min(target.width - tile.x, kTileWidth);
  const int rows = std::min(target.height - tile.y, kTileHeight);
  const uint64_t row = ~uint64_t{0} >> (kTileWidth - columns);
  return coverage.first_row == 0 && coverage.last_row == rows &&
         std::all_of(coverage.rows, coverage.rows + rows,
                     [row](uint64_t covered) { return covered == row; });
}

// Whether a clear leaves nothing visible of what came before it.
bool hides_all(const ClearCommand& clear, const Target& target, const Tile& tile) {
  return covers_tile(clear, target, tile) &&
         (!target.colour || colour_clear_mask(clear) == 0xffffffffu) &&
         (!target.depth_stencil || depth_stencil_clear_mask(clear) == 0xffffffffu);
}

// Whether nothing of a primitive passes the depth test anywhere in the tile.
bool is_hidden(const DrawState& draw, const PrimitiveRecord& primitive, const Tile& tile,
               const TileDepth& depth, PrimitivePlanes& planes) {
  const DepthRule& rule = draw.outputs.depth;
  if (!depth.may_hide(rule)) return false;
  make_depth_plane(draw.setup, primitive, planes);
  return depth.hides(
      rule.func, depth_range(planes.depth, planes.x_ref, planes.y_ref, primitive, tile, rule.one));
}

// A primitive that is not small, but narrow: its pixels are shaded with those of small ones.
void shade_narrow(const DrawState& draw, const PrimitiveRecord& primitive, TilePlanes& planes,
                  TileDepth& depth, BackWorker& worker) {
  Tile& tile = worker.tiles.tiles[0];
  if (is_hidden(draw, primitive, tile, depth, worker.planes)) return;
  CoveredSquares squares;
  if (!cover_squares(primitive, tile.x, tile.y, squares)) return;
  if (counts_usage()) {
    int pixels = 0;
    for (int i = 0; i < squares.count; ++i) pixels += std::popcount(squares.square[i].mask);
    count_pixels(*draw.program, UsageForm::kSmall, pixels);
  }
  planes.prepare(draw.outputs, false);
  worker.small.add(draw, primitive, squares, tile);
  depth.drawn(draw.outputs.depth);
}

void shade_stroke(const DrawState& draw, const StrokeRecord& stroke, TilePlanes& planes,
                  TileDepth& depth, BackWorker& worker) {
  Tile& tile = worker.tiles.tiles[0];
  worker.small.flush();
  if (counts_usage()) {
    count_pixels(*draw.program, UsageForm::kSmall, count_pixels(stroke, tile.x, tile.y));
  }
  planes.prepare(draw.outputs, false);
  draw_stroke(*draw.program, stroke, tile);
  depth.drawn(draw.outputs.depth);
}

// A primitive that is neither: its coverage, its planes, its pixels.
void shade_primitive(const DrawState& draw, const PrimitiveRecord& primitive, const Target& target,
                     TilePlanes& planes, TileDepth& depth, BackWorker& worker) {
  SampleTiles& tiles = worker.tiles;
  const Tile& tile = tiles.tiles[0];
  const int samples = planes.samples();
  const DepthRule& rule = draw.outputs.depth;
  PrimitivePlanes& attributes = worker.planes;
  DepthRange range;
  if (rule.test && samples == 1) {
    make_depth_plane(draw.setup, primitive, attributes);
    range = depth_range(attributes.depth, attributes.x_ref, attributes.y_ref, primitive, tile,
                        rule.one);
    if (rule.traceless && depth.hides(rule.func, range)) return;
  }
  Coverage coverage[kSampleCount];
  if (!cover(primitive, planes, coverage)) return;
  const bool whole = std::all_of(coverage, coverage + samples,
                                 [&](const Coverage& c) { return is_whole(c, target, tile); });
  if (counts_usage()) count_coverage(*draw.program, coverage, samples);
  make_planes(draw.setup, primitive, attributes);
  if (whole && draw.outputs.solid && attributes.flat_colour) {
    const uint32_t pixel = solid_pixel(*draw.program, attributes);
    for (int s = 0; s < samples; ++s) planes.colour(s).set_uniform(pixel);
    return;
  }
  planes.prepare(draw.outputs, draw.outputs.replaces && whole);
  if (samples > 1) {
    shade_samples(*draw.program, attributes, coverage, tiles.tiles.data());
    depth.drawn(rule);
  } else {
    shade(*draw.program, attributes, coverage[0], tiles.tiles[0]);
    depth.drawn(rule, range, whole);
  }
}

void count_small(const FragmentProgram& program, const Packet& packet,
                 std::span<const uint32_t> entries, const Tile& tile) {
  int pixels = 0;
  for (const uint32_t entry : entries) {
    const SmallPrimitive& small = packet.small[entry & ~kSmallEntry];
    pixels += std::popcount(small_coverage(small.mask, small.x, small.y, tile.x, tile.y).mask);
  }
  count_pixels(program, UsageForm::kSmall, pixels);
}

// A record may begin anywhere in a cache line. Inlined, as GCC drops calls of a function that does
// nothing but fetch ahead.
template <class Record>
HWY_INLINE void fetch(const Record& record) {
  const auto* bytes = reinterpret_cast<const std::byte*>(&record);
  for (size_t at = 0; at < sizeof(record); at += 64) hwy::Prefetch(bytes + at);
  hwy::Prefetch(bytes + sizeof(record) - 1);
}

// What an entry numbers.
HWY_INLINE void fetch_record(const Packet& packet, uint32_t entry) {
  if ((entry & kStrokeEntry) != 0) {
    fetch(packet.strokes[entry & ~kStrokeEntry]);
  } else if ((entry & kSmallEntry) != 0) {
    hwy::Prefetch(&packet.small[entry & ~kSmallEntry]);
  } else {
    fetch(packet.primitives[entry]);
  }
}

// A packet's dots in the tile.
void shade_dots(const DrawState& draw, std::span<const uint32_t> entries, TilePlanes& planes,
                TileDepth& depth, BackWorker& worker) {
  worker.small.flush();
  if (counts_usage()) {
    const size_t dots = entries.size() / kDotEntries;
    count_pixels(*draw.program, UsageForm::kSmall, static_cast<int>(dots));
  }
  planes.prepare(draw.outputs, false);
  draw_dots(draw, entries, worker.tiles.tiles[0]);
  depth.drawn(draw.outputs.depth);
}

// The primitives of a packet that touch the tile.
void shade_packet(const DrawList& draws, const Packet& packet, std::span<const uint32_t> entries,
                  const Target& target, TilePlanes& planes, TileDepth& depth, BackWorker& worker) {
  if (packet.is_dots) {
    return shade_dots(*draws[packet.ranges[0].draw].state, entries, planes, depth, worker);
  }
  constexpr size_t kAhead = 4;
  for (size_t at = 0; at < entries.size();) {
    const uint32_t index = entries[at];
    if ((index & kStrokeEntry) != 0) {
      if (at + kAhead < entries.size()) fetch_record(packet, entries[at + kAhead]);
      const StrokeRecord& stroke = packet.strokes[index & ~kStrokeEntry];
      shade_stroke(*draws[stroke.draw].state, stroke, planes, depth, worker);
      ++at;
    } else if ((index & kSmallEntry) == 0) {
      if (at + kAhead < entries.size()) fetch_record(packet, entries[at + kAhead]);
      const PrimitiveRecord& primitive = packet.primitives[index];
      const DrawState& draw = *draws[primitive.draw].state;
      if (primitive.narrow) {
        shade_narrow(draw, primitive, planes, depth, worker);
      } else {
        worker.small.flush();
        shade_primitive(draw, primitive, target, planes, depth, worker);
      }
      ++at;
    } else {
      const SmallPrimitive& small = packet.small[index & ~kSmallEntry];
      const DrawState& draw = *draws[packet.ranges[small.range].draw].state;
      planes.prepare(draw.outputs, false);
      const auto rest = entries.subspan(at);
      const size_t taken = worker.small.add(draws, packet, rest, worker.tiles.tiles[0]);
      if (counts_usage()) {
        count_small(*draw.program, packet, rest.first(taken), worker.tiles.tiles[0]);
      }
      depth.drawn(draw.outputs.depth);
      at += taken;
    }
  }
}

// The lines of memory that a list of dots begins with; the first is fetched already.
void fetch_dots(const TileLists::Reference& list) {
  constexpr uint32_t kLine = 64 / sizeof(uint32_t), kFetched = 4 * kLine;
  for (uint32_t e = kLine; e < std::min(list.count, kFetched); e += kLine) {
    hwy::Prefetch(list.entries + e);
  }
}

// Scattered primitives make many short lists, and each would wait for memory
// three times: for its entries, the primitive, the vertices.
void fetch_ahead(const DrawList& draws, std::span<Packet* const> packets,
                 std::span<const TileLists::Reference> lists, size_t next) {
  constexpr uint32_t kEntries = 4;  // of a list
  if (next + 9 < lists.size()) hwy::Prefetch(lists[next + 9].entries);
  for (const size_t ahead : {next + 6, next + 3}) {
    if (ahead >= lists.size()) continue;
    const bool primitives = ahead == next + 6;
    const TileLists::Reference& list = lists[ahead];
    const Packet& packet = *packets[list.packet];
    if (packet.is_dots) {
      if (!primitives) fetch_dots(list);
      continue;
    }
    for (uint32_t e = 0; e < std::min(list.count, kEntries); ++e) {
      const uint32_t entry = list.entries[e];
      if (primitives) {
        fetch_record(packet, entry);
      } else if ((entry & (kSmallEntry | kStrokeEntry)) == 0) {
        for (const float* vertex : packet.primitives[entry].vertex) hwy::Prefetch(vertex);
      } else if ((entry & kSmallEntry) != 0) {
        const SmallPrimitive& small = packet.small[entry & ~kSmallEntry];
        const DrawState& draw = *draws[packet.ranges[small.range].draw].state;
        hwy::Prefetch(packet.records[small.range] +
                      size_t{small.vertex[0]} * draw.setup.layout.stride);
      }
    }
  }
  // So that calls stay.
  std::atomic_signal_fence(std::memory_order_acq_rel);
}

}  // namespace

void TileWork::make(size_t number, std::span<Packet* const> packets) {
  Part& part = parts_[number];
  part.clears.clear();
  for (size_t i = 0; i < packets.size(); ++i) {
    if (packets[i]->is_clear) part.clears.push_back(static_cast<uint32_t>(i));
  }
  part.lists.build(
      static_cast<uint32_t>(tiles_ * number / parts_.size()),
      static_cast<uint32_t>(tiles_ * (number + 1) / parts_.size()), packets.size(),
      [&](size_t i) -> const Bins* { return packets[i]->is_clear ? nullptr : &packets[i]->bins; });
}

void run_back(const DrawList& draws, std::span<Packet* const> packets, const TileWork& work,
              const Target& target, const TileGrid& grid, int tile_index, BackWorker& worker) {
  // Clears and lists, both in the order of their packets, are merged.
  const auto number = static_cast<size_t>(tile_index);
  const std::span<const TileLists::Reference> lists = work.lists(number);
  const std::span<const TileLists::Reference> lists_ahead = work.lists_ahead(number);
  const std::span<const uint32_t> clears = work.clears(number);
  if (lists.empty() && clears.empty()) return;
  for (Tile& tile : worker.tiles.tiles) {
    tile.x = tile_index % grid.columns * kTileWidth;
    tile.y = tile_index / grid.columns * kTileHeight;
    tile.mirror_height = target.mirrored ? target.height : 0;
  }
  TilePlanes planes(target, worker.tiles, tile_index);
  TileDepth depth(planes.depth_stencil(0));
  // From the last clear on that hides what came before it.
  size_t clear = 0, next = 0;
  for (size_t i = clears.size(); i-- > 0;) {
    if (!hides_all(packets[clears[i]]->clear, target, planes.tile())) continue;
    clear = i;
    next = static_cast<size_t>(
        std::find_if(lists.begin(), lists.end(),
                     [&](const TileLists::Reference& list) { return list.packet > clears[i]; }) -
        lists.begin());
    break;
  }
  while (next < lists.size() || clear < clears.size()) {
    if (clear < clears.size() && (next == lists.size() || clears[clear] < lists[next].packet)) {
      worker.small.flush();
      clear_planes(packets[clears[clear++]]->clear, target, planes, depth);
      continue;
    }
    fetch_ahead(draws, packets, lists_ahead, next);
    const TileLists::Reference& list = lists[next];
    shade_packet(draws, *packets[list.packet], {list.entries, list.count}, target, planes, depth,
                 worker);
    ++next;
  }
  worker.small.flush();
  planes.store();
}

}  // namespace clearpipe::pipeline
