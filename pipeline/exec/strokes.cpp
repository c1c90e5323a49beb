// Strokes, on every SIMD target: see strokes.h.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/strokes.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "pipeline/fragment/small.h"
#include "pipeline/raster/stroke.h"
#include "pipeline/raster/tile_part.h"
#include "pipeline/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/exec/strokes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "pipeline/fragment/depth_stencil-inl.h"
#include "pipeline/fragment/small_pixels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::exec::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using fragment::HWY_NAMESPACE::NarrowDepthState;

using TagF = hn::CappedTag<float, 16>;
using TagI = hn::RebindToSigned<TagF>;
using VecF = hn::Vec<TagF>;
using VecI = hn::Vec<TagI>;
constexpr int kLanes = static_cast<int>(hn::MaxLanes(TagF()));
constexpr int kThin = 2;  // wider ones are drawn in rows

// A vector of columns (or rows): what their pixels become, and the first row of each.
struct StrokeColumns {
  VecI depth, pixel, first;
};

template <class State>
class StrokePen {
 public:
  StrokePen(const FragmentProgram& program, const State& depth, const StrokeRecord& stroke,
            const StrokeEdge& edge, Tile& tile)
      : program_(program),
        depth_(depth),
        stroke_(stroke),
        edge_(edge),
        part_(raster::part_of_tile(stroke, tile.x, tile.y)),
        tile_(tile),
        inverse_step_(1.0f / static_cast<float>(edge.step)) {
    const TagF d;
    const VecF colour[4] = {hn::Set(d, stroke.colour[0]), hn::Set(d, stroke.colour[1]),
                            hn::Set(d, stroke.colour[2]), hn::Set(d, stroke.colour[3])};
    if (stroke.flat_colour) {
      flat_pixel_ = fragment::HWY_NAMESPACE::pack_lanes(colour, program.format);
    }
  }

  // Pixel by pixel, a vector of columns at a time.
  HWY_INLINE void draw_thin() const {
    const TagI d;
    const auto [first, end] = along(part_);
    const auto [low, high] = across(part_);
    const VecI along_step = hn::Set(d, stroke_.x_major ? 1 : kTileWidth);
    const VecI across_step = hn::Set(d, stroke_.x_major ? kTileWidth : 1);
    for (int column = first; column < end; column += kLanes) {
      const StrokeColumns at = columns(column);
      const auto inside = within(d, hn::Iota(d, 0), end - column);
      const VecI number = hn::Add(hn::Iota(d, 0), hn::Set(d, column));
      for (int i = 0; i < stroke_.width; ++i) {
        const VecI row = hn::Add(at.first, hn::Set(d, i));
        const auto covered = within(d, hn::Sub(row, hn::Set(d, low)), high - low);
        const VecI place = hn::Add(hn::Mul(number, along_step), hn::Mul(row, across_step));
        write_apart(hn::And(inside, covered), place, at.depth, at.pixel);
      }
    }
  }

  // Rows of a vector of columns, from the first that one of them has to the last.
  HWY_INLINE void draw_along_x() const {
    const TagI d;
    const raster::TilePart& part = part_;
    for (int x = part.x0 / kLanes * kLanes; x < part.x1; x += kLanes) {
      const StrokeColumns at = columns(x);
      alignas(64) int32_t first[kLanes];
      hn::Store(at.first, d, first);
      const int left = first[std::max(part.x0 - x, 0)];
      const int right = first[std::min(part.x1 - x, kLanes) - 1];
      const int low = std::max(std::min(left, right), part.y0);
      const int high = std::min(std::max(left, right) + stroke_.width, part.y1);
      const auto inside =
          within(d, hn::Add(hn::Iota(d, 0), hn::Set(d, x - part.x0)), part.x1 - part.x0);
      for (int row = low; row < high; ++row) {
        const auto covered = within(d, hn::Sub(hn::Set(d, row), at.first), stroke_.width);
        write(d, row * kTileWidth + x, hn::And(inside, covered), at.depth, at.pixel);
      }
    }
  }

  // Each row by itself, with vectors that are not much longer than the line is wide.
  HWY_INLINE void draw_along_y() const {
    if (stroke_.width <= 4) {
      draw_rows(hn::CappedTag<int32_t, 4>());
    } else {
      draw_rows(hn::CappedTag<int32_t, 8>());
    }
  }

 private:
  // Lanes in [0, count).
  template <class D>
  static HWY_INLINE hn::Mask<D> within(D d, hn::Vec<D> v, int count) {
    const hn::RebindToUnsigned<D> du;
    return hn::RebindMask(d, hn::Lt(hn::BitCast(du, v), hn::Set(du, static_cast<uint32_t>(count))));
  }

  // The part's columns and rows.
  HWY_INLINE std::pair<int, int> along(const raster::TilePart& part) const {
    return stroke_.x_major ? std::pair(part.x0, part.x1) : std::pair(part.y0, part.y1);
  }
  HWY_INLINE std::pair<int, int> across(const raster::TilePart& part) const {
    return stroke_.x_major ? std::pair(part.y0, part.y1) : std::pair(part.x0, part.x1);
  }

  // From a column of the tile on.
  HWY_INLINE StrokeColumns columns(int column) const {
    const TagF d;
    const int origin = stroke_.x_major ? tile_.x : tile_.y;
    const TagI di;
    const VecI number = hn::Add(hn::Iota(di, 0), hn::Set(di, column));
    // The least row whose value is not negative: -floor(value of row 0 / step).
    const VecI value = hn::Add(hn::Mul(number, hn::Set(di, edge_.slope)), hn::Set(di, edge_.start));
    const VecF quotient = hn::Mul(hn::ConvertTo(d, value), hn::Set(d, inverse_step_));
    const VecI nearest = pipeline::HWY_NAMESPACE::nearest_int(d, quotient);
    const VecI rest = hn::Sub(value, hn::Mul(nearest, hn::Set(di, edge_.step)));
    const VecI floor = hn::Add(nearest, hn::ShiftRight<31>(rest));
    const VecF along = hn::Add(hn::ConvertTo(d, hn::Add(number, hn::Set(di, origin))),
                               hn::Set(d, 0.5f - stroke_.reference));
    return {fragment::HWY_NAMESPACE::to_depth_value(d, depth_, evaluate(stroke_.depth, along)),
            stroke_.flat_colour ? flat_pixel_ : interpolated(along), hn::Neg(floor)};
  }

  static HWY_INLINE VecF evaluate(const StrokeValue& v, VecF along) {
    const TagF d;
    return hn::Add(hn::Set(d, v.value), hn::Mul(hn::Set(d, v.step), along));
  }

  HWY_INLINE VecI interpolated(VecF along) const {
    const TagF d;
    VecF colour[4];
    for (int c = 0; c < 4; ++c) {
      colour[c] = evaluate({stroke_.colour[c], stroke_.colour_step[c]}, along);
    }
    if (stroke_.perspective) {
      const VecF w = hn::Div(hn::Set(d, 1.0f), evaluate(stroke_.inv_w, along));
      for (VecF& v : colour) v = hn::Mul(v, w);
    }
    return fragment::HWY_NAMESPACE::pack_lanes(colour, program_.format);
  }

  template <class D>
  HWY_INLINE void draw_rows(D d) const {
    const TagI all;
    constexpr int kRun = static_cast<int>(hn::MaxLanes(d));
    const raster::TilePart& part = part_;
    const auto number = hn::Iota(d, 0);
    for (int y = part.y0 / kLanes * kLanes; y < part.y1; y += kLanes) {
      const StrokeColumns at = columns(y);
      alignas(64) int32_t depth[kLanes], pixel[kLanes], first[kLanes];
      hn::Store(at.depth, all, depth);
      hn::Store(at.pixel, all, pixel);
      hn::Store(at.first, all, first);
      const int last = std::min(part.y1 - y, kLanes);
      for (int i = std::max(part.y0 - y, 0); i < last; ++i) {
        const int end = std::min(first[i] + stroke_.width, part.x1);
        for (int x = std::max(first[i], part.x0); x < end; x += kRun) {
          const int from = std::min(x, kTileWidth - kRun);
          const auto covered = within(d, hn::Add(number, hn::Set(d, from - x)), end - x);
          write(d, (y + i) * kTileWidth + from, covered, hn::Set(d, depth[i]),
                hn::Set(d, pixel[i]));
        }
      }
    }
  }

  // Some of the pixels from a place of the tile's planes on.
  template <class D>
  HWY_INLINE void write(D d, int place, hn::Mask<D> live, hn::Vec<D> depth,
                        hn::Vec<D> pixel) const {
    using fragment::HWY_NAMESPACE::depth_stencil_test;
    using fragment::HWY_NAMESPACE::NoStencilState;
    if (depth_.test) {
      auto* const stored = reinterpret_cast<int32_t*>(tile_.depth_stencil) + place;
      auto packed = hn::LoadU(d, stored);
      live = depth_stencil_test(d, NoStencilState(), depth_, live, depth, packed);
      if (depth_.write) hn::StoreU(packed, d, stored);
    }
    auto* const colour = reinterpret_cast<int32_t*>(tile_.colour) + place;
    hn::StoreU(hn::IfThenElse(live, pixel, hn::LoadU(d, colour)), d, colour);
  }

  // Those that live of pixels at places of their own.
  HWY_INLINE void write_apart(hn::Mask<TagI> live, VecI place, VecI depth, VecI pixel) const {
    using fragment::HWY_NAMESPACE::depth_stencil_test;
    using fragment::HWY_NAMESPACE::NoStencilState;
    const TagI d;
    place = hn::IfThenElseZero(live, place);
    VecI packed = depth;
    if (depth_.test) {
      const auto* stored = reinterpret_cast<const int32_t*>(tile_.depth_stencil);
      packed = hn::GatherIndex(d, stored, place);
      live = depth_stencil_test(d, NoStencilState(), depth_, live, depth, packed);
      if (depth_.write) scatter(live, place, packed, tile_.depth_stencil);
    }
    scatter(live, place, pixel, tile_.colour);
  }

  static HWY_INLINE void scatter(hn::Mask<TagI> live, VecI place, VecI values, uint32_t* plane) {
    const TagI d;
#if HWY_TARGET <= HWY_AVX3
    // Highway 1.0.3 scatters all lanes; one by one, 16 take 22 to 27 cycles instead of 17 (Zen 5).
    (void)d;
    _mm512_mask_i32scatter_epi32(plane, live.raw, place.raw, values.raw, 4);
#else
    alignas(64) int32_t places[kLanes], all[kLanes];
    hn::Store(place, d, places);
    hn::Store(values, d, all);
    uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, live, bytes);
    for (unsigned bits = bytes[0]; bits != 0; bits &= bits - 1) {
      const int lane = std::countr_zero(bits);
      plane[places[lane]] = static_cast<uint32_t>(all[lane]);
    }
#endif
  }

  const FragmentProgram& program_;
  const State depth_;
  const StrokeRecord& stroke_;
  const StrokeEdge& edge_;
  const raster::TilePart part_;
  Tile& tile_;
  const float inverse_step_;
  VecI flat_pixel_;
};

template <class State>
HWY_INLINE void draw_with(const FragmentProgram& program, const State& depth,
                          const StrokeRecord& stroke, const StrokeEdge& edge, Tile& tile) {
  const StrokePen<State> pen(program, depth, stroke, edge, tile);
  if (stroke.width <= kThin) {
    pen.draw_thin();
  } else if (stroke.x_major) {
    pen.draw_along_x();
  } else {
    pen.draw_along_y();
  }
}

void draw(const FragmentProgram& program, const StrokeRecord& stroke, Tile& tile) {
  using fragment::HWY_NAMESPACE::KnownDepthState;
  StrokeEdge edge;
  if (!find_edge(stroke, tile.x, tile.y, edge)) return;
  const NarrowDepthState depth(fragment::HWY_NAMESPACE::depth_state(program));
  if (depth.test && depth.func == CompareFunc::kLess) {
    draw_with(program, KnownDepthState<CompareFunc::kLess, false>{depth.write, depth.most}, stroke,
              edge, tile);
  } else if (depth.test && depth.func == CompareFunc::kLessEqual) {
    draw_with(program, KnownDepthState<CompareFunc::kLessEqual, false>{depth.write, depth.most},
              stroke, edge, tile);
  } else {
    draw_with(program, depth, stroke, edge, tile);
  }
}

using StrokeDrawer = void (*)(const FragmentProgram&, const StrokeRecord&, Tile&);
StrokeDrawer stroke_drawer() { return &draw; }

}  // namespace clearpipe::pipeline::exec::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace clearpipe::pipeline {
namespace exec {

HWY_EXPORT(stroke_drawer);

static auto resolve_strokes() {
  static const auto resolved = [] {
    select_simd_target();
    return HWY_DYNAMIC_DISPATCH(stroke_drawer)();
  }();
  return resolved;
}

}  // namespace exec

bool draws_strokes(const DrawState& state) {
  return state.setup.coverage == FragmentCoverage::kCentre &&
         stroke_width(state.setup.raster) <= kWidestStroke && batches_small(*state.program) &&
         writes_primitive_colours(*state.program);
}

void draw_stroke(const FragmentProgram& program, const StrokeRecord& stroke, Tile& tile) {
  exec::resolve_strokes()(program, stroke, tile);
}

}  // namespace clearpipe::pipeline
#endif  // HWY_ONCE
