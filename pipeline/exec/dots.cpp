// Dots, on every SIMD target: see dots.h.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/dots.h"

#include <algorithm>
#include <cstring>

#include "pipeline/fragment/small.h"
#include "pipeline/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/exec/dots.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "pipeline/fragment/depth_stencil-inl.h"
#include "pipeline/fragment/small_pixels-inl.h"
#include "pipeline/setup/point_lanes-inl.h"

#ifndef CLEARPIPE_EXEC_DOTS_ONCE_
#define CLEARPIPE_EXEC_DOTS_ONCE_
namespace clearpipe::pipeline::exec {

// A dot and its tile.
struct PlacedDot {
  uint32_t tile;
  Dot dot;
};

using DotFinder = size_t (*)(const DrawState& draw, const TileGrid& grid, const float* records,
                             size_t count, PlacedDot* out);

}  // namespace clearpipe::pipeline::exec
#endif

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::exec::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Of vertex records that lie behind one another, in their order; returns how many there are.
size_t find_dots(const DrawState& draw, const TileGrid& grid, const float* records, size_t count,
                 PlacedDot* out) {
  using namespace setup::HWY_NAMESPACE;
  const setup::HWY_NAMESPACE::TagI d;
  const PlaneTag df;
  constexpr size_t kLanes = kPlaneLanes;
  static_assert(kTileWidth == 1 << 6 && kTileHeight == 1 << 5);
  const SetupState& state = draw.setup;
  const FragmentProgram& program = *draw.program;
  const fragment::HWY_NAMESPACE::NarrowDepthState depth(
      fragment::HWY_NAMESPACE::depth_state(program));
  const Rect& bounds = state.bounds;
  PlacedDot* next = out;
  for (size_t i = 0; i < count; i += kLanes) {
    const float* vertex[kLanes];
    for (size_t lane = 0; lane < kLanes; ++lane) {  // lanes behind repeat the last
      vertex[lane] = records + std::min(i + lane, count - 1) * state.layout.stride;
    }
    LaneValues window, outcode, colour;
    window.load(vertex, [](int) { return vertex_record::kWindow; });
    outcode.load(vertex, [](int) { return vertex_record::kOutcode; });
    colour.load(vertex, [](int) { return vertex_record::kColour; });
    MaskI drops = hn::Ne(hn::BitCast(d, outcode.at[0]), hn::Zero(d));
    // Those that are far away are outside of the bounds.
    const LanePixels pixel = first_pixels(state, window.at[0], window.at[1], hn::Set(d, 1), drops);
    const VecI x = pixel.x, y = pixel.y;
    drops = hn::Or(drops,
                   hn::Or(hn::Lt(x, hn::Set(d, bounds.x0)), hn::Gt(x, hn::Set(d, bounds.x1 - 1))));
    drops = hn::Or(drops,
                   hn::Or(hn::Lt(y, hn::Set(d, bounds.y0)), hn::Gt(y, hn::Set(d, bounds.y1 - 1))));
    const VecI tile =
        hn::Add(hn::Mul(hn::ShiftRight<5>(y), hn::Set(d, grid.columns)), hn::ShiftRight<6>(x));
    const VecI place = hn::Or(hn::ShiftLeft<6>(hn::And(y, hn::Set(d, kTileHeight - 1))),
                              hn::And(x, hn::Set(d, kTileWidth - 1)));
    const VecI value = fragment::HWY_NAMESPACE::to_depth_value(df, depth, window.at[2]);
    for (PlaneVec& v : colour.at) v = hn::Mul(v, hn::Set(df, float{kColourOne}));
    const VecI pixels = fragment::HWY_NAMESPACE::pack_lanes(colour.at, program.format);
    alignas(64) uint32_t dots[4][kLanes];
    const setup::HWY_NAMESPACE::TagU du;
    hn::Store(hn::BitCast(du, tile), du, dots[0]);
    hn::Store(hn::BitCast(du, place), du, dots[1]);
    hn::Store(hn::BitCast(du, value), du, dots[2]);
    hn::Store(hn::BitCast(du, pixels), du, dots[3]);
    alignas(64) int32_t dropped[kLanes];
    hn::Store(hn::VecFromMask(d, drops), d, dropped);
    for (size_t lane = 0; lane < std::min(kLanes, count - i); ++lane) {
      *next = {dots[0][lane], {dots[1][lane], dots[2][lane], dots[3][lane]}};
      next += dropped[lane] == 0 ? 1 : 0;
    }
  }
  return static_cast<size_t>(next - out);
}

DotFinder dot_finder() { return &find_dots; }

}  // namespace clearpipe::pipeline::exec::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace clearpipe::pipeline {
namespace exec {

HWY_EXPORT(dot_finder);

static DotFinder resolve_dots() {
  static const DotFinder resolved = [] {
    select_simd_target();
    return HWY_DYNAMIC_DISPATCH(dot_finder)();
  }();
  return resolved;
}

// The depth test and its writing, of dots in order: a pixel may be that of several.
template <class Passes>
static void draw_tested(bool write, std::span<const uint32_t> entries, const Tile& tile,
                        const Passes& passes) {
  for (size_t i = 0; i < entries.size(); i += kDotEntries) {
    Dot dot;
    std::memcpy(&dot, entries.data() + i, sizeof(dot));
    uint32_t& stored = tile.depth_stencil[dot.place];
    uint32_t& colour = tile.colour[dot.place];
    // Without branches: which of them pass cannot be guessed.
    const bool pass = passes(dot.depth, stored >> 8);
    colour = pass ? dot.colour : colour;
    if (write) stored = pass ? dot.depth << 8 | (stored & 0xff) : stored;
  }
}

}  // namespace exec

bool may_draw_dots(const DrawState& state, const VertexState& vertex) {
  return state.setup.coverage == FragmentCoverage::kCentre && !state.setup.raster.point_sprite &&
         !vertex.point_attenuated && batches_small(*state.program) &&
         writes_primitive_colours(*state.program);
}

bool draws_dots(const DrawCommand& command, const DrawRecord& draw) {
  if (command.primitive != Primitive::kPoints || !draw.state->may_draw_dots) return false;
  const AttributeSource& size = command.attributes[static_cast<int>(Attribute::kPointSize)];
  if (size.is_array || command.index_type != IndexType::kNone) return false;
  const VertexState& vertex = *draw.vertex;
  constexpr float kLargest = 1.5f;  // 3.3: sizes are rounded
  return std::min(std::max(size.constant.x, vertex.point_size_min), vertex.point_size_max) <=
         kLargest;
}

void DotWorker::run(const DrawList& draws, const TileGrid& grid, BinScratch& scratch, Arena& arena,
                    Packet& packet) {
  packet.bins.reset(grid, scratch);
  for (const PacketRange& range : packet.ranges) {
    const DrawRecord& draw = draws[range.draw];
    uint32_t element = draw.first - draw.index_base + range.first_primitive;
    for (uint32_t left = range.primitive_count; left != 0;) {
      const uint32_t count = std::min(left, kVertices);
      for (uint32_t i = 0; i < count; ++i) elements_[i] = element++;
      run_job(draw, grid, count, packet.bins);
      left -= count;
    }
  }
  packet.bins.close(arena);
}

void DotWorker::run_job(const DrawRecord& draw, const TileGrid& grid, uint32_t count, Bins& bins) {
  records_.reset();
  float* const records =
      records_.allocate_array<float>(size_t{draw.state->clip.layout.stride} * count);
  run_vertex_stages(make_vertex_job(draw, elements_.data(), count, records));
  exec::PlacedDot dots[kVertices];
  const size_t found = exec::resolve_dots()(*draw.state, grid, records, count, dots);
  for (size_t i = 0; i < found; ++i) bins.add(dots[i].tile, dots[i].dot);
}

void draw_dots(const DrawState& state, std::span<const uint32_t> entries, Tile& tile) {
  const DepthRule& depth = state.outputs.depth;
  const auto draw = [&](const auto& passes) {
    exec::draw_tested(depth.write, entries, tile, passes);
  };
  if (!depth.test) {
    for (size_t i = 0; i < entries.size(); i += kDotEntries) {
      tile.colour[entries[i]] = entries[i + 2];
    }
    return;
  }
  using D = uint32_t;
  switch (depth.func) {
    case CompareFunc::kNever:
      return;
    case CompareFunc::kLess:
      return draw([](D a, D b) { return a < b; });
    case CompareFunc::kEqual:
      return draw([](D a, D b) { return a == b; });
    case CompareFunc::kLessEqual:
      return draw([](D a, D b) { return a <= b; });
    case CompareFunc::kGreater:
      return draw([](D a, D b) { return a > b; });
    case CompareFunc::kNotEqual:
      return draw([](D a, D b) { return a != b; });
    case CompareFunc::kGreaterEqual:
      return draw([](D a, D b) { return a >= b; });
    case CompareFunc::kAlways:
      return draw([](D, D) { return true; });
  }
}

}  // namespace clearpipe::pipeline
#endif  // HWY_ONCE
