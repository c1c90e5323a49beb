// Small primitives whose colours are written as they are (writes_primitive_colours()): a square of
// 8x8 pixels after another, in their order, from the planes of a group (small-inl.h). Nothing is
// listed or gathered, and no primitive has to wait for another that covers the same pixels.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_SMALL_SQUARES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_SMALL_SQUARES_INL_H_
#undef CLEARPIPE_FRAGMENT_SMALL_SQUARES_INL_H_
#else
#define CLEARPIPE_FRAGMENT_SMALL_SQUARES_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <type_traits>

#include "pipeline/fragment/depth_stencil-inl.h"
#include "pipeline/fragment/early_tests-inl.h"
#include "pipeline/fragment/small_pixels-inl.h"
#include "pipeline/setup/lane_planes-inl.h"
#include "pipeline/setup/small.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

class SmallSquares {
 public:
  static constexpr int kRoom = 64;

  bool is_full() const { return count_ == kRoom; }
  void clear() { count_ = 0; }

  // Pixels of the primitive in a lane of the group.
  HWY_INLINE void list(const SmallCoverage& coverage, int lane) {
    // Moved so that the square lies in the tile as a whole.
    const int column = std::min(coverage.column, kTileWidth - kSmallSide);
    const int row = std::min(coverage.row, kTileHeight - kSmallSide);
    const int by = coverage.column - column + kSmallSide * (coverage.row - row);
    square_[count_++] = {coverage.mask << by, column, row, lane};
  }

  // Shades what is listed.
  void shade(const FragmentProgram& program, const setup::HWY_NAMESPACE::LanePlanes& planes,
             Tile& tile) {
    store_planes(planes, program.format);
    const NarrowDepthState depth(depth_state(program));
    if (!depth.test) return shade_all<false>(program, depth, tile);
    switch (depth.func) {
      case CompareFunc::kLess:
        return shade_all<true>(
            program, KnownDepthState<CompareFunc::kLess, false>{depth.write, depth.most}, tile);
      case CompareFunc::kLessEqual:
        return shade_all<true>(
            program, KnownDepthState<CompareFunc::kLessEqual, false>{depth.write, depth.most},
            tile);
      default:
        return shade_all<true>(program, depth, tile);
    }
  }

 private:
  using TagF = hn::CappedTag<float, 16>;
  using TagI = hn::RebindToSigned<TagF>;
  using VecF = hn::Vec<TagF>;
  using VecI = hn::Vec<TagI>;
  using LanePlane = setup::HWY_NAMESPACE::LanePlane;
  static constexpr int kLanes = static_cast<int>(hn::MaxLanes(TagF()));

  struct Square {
    uint64_t mask;
    int column, row;  // of the tile
    int lane;
  };

  // The plane of each lane, in memory, from where one of them becomes that of a vector.
  struct StoredPlane {
    alignas(64) float value[kLanes], dx[kLanes], dy[kLanes];

    HWY_INLINE void store(const LanePlane& plane) {
      const TagF d;
      hn::Store(plane.value, d, value);
      hn::Store(plane.dx, d, dx);
      hn::Store(plane.dy, d, dy);
    }
    HWY_INLINE LanePlane of(int lane) const {
      const TagF d;
      return {hn::Set(d, value[lane]), hn::Set(d, dx[lane]), hn::Set(d, dy[lane])};
    }
  };

  HWY_INLINE void store_planes(const setup::HWY_NAMESPACE::LanePlanes& planes,
                               ColourFormat format) {
    const TagF d;
    const TagI di;
    const VecF half = hn::Set(d, 0.5f);
    hn::Store(hn::Sub(half, planes.x_ref), d, to_x_);
    hn::Store(hn::Sub(half, planes.y_ref), d, to_y_);
    depth_.store(planes.depth);
    flat_ = planes.flat_colour;
    perspective_ = planes.perspective && !flat_;
    if (flat_) {
      const VecF colour[4] = {planes.colour[0].value, planes.colour[1].value,
                              planes.colour[2].value, planes.colour[3].value};
      hn::Store(pack_lanes(colour, format), di, pixel_);
      return;
    }
    for (int c = 0; c < 4; ++c) colour_[c].store(planes.colour[c]);
    if (!perspective_) return;
    inv_w_.store(planes.inv_w);
    hn::Store(hn::VecFromMask(di, hn::RebindMask(di, planes.divided)), di, divided_);
  }

  template <bool kTests, class State>
  HWY_INLINE void shade_all(const FragmentProgram& program, const State& depth, Tile& tile) {
    for (int i = 0; i < count_; ++i) shade_square<kTests>(program, depth, square_[i], tile);
  }

  // Of a square, a vector of pixels after another.
  template <bool kTests, class State>
  HWY_INLINE void shade_square(const FragmentProgram& program, const State& depth,
                               const Square& square, Tile& tile) {
    const TagF d;
    const TagI di;
    constexpr uint64_t kAll = (uint64_t{1} << kLanes) - 1;
    const int lane = square.lane;
    const VecI number = hn::Iota(di, 0);
    const VecI columns =
        hn::Add(hn::And(number, hn::Set(di, kSmallSide - 1)), hn::Set(di, tile.x + square.column));
    const VecI rows = hn::Add(hn::ShiftRight<3>(number), hn::Set(di, tile.y + square.row));
    const VecF to_x = hn::Set(d, to_x_[lane]), to_y = hn::Set(d, to_y_[lane]);
    const LanePlane depth_plane = depth_.of(lane);
    const VecI flat_pixel = hn::Set(di, pixel_[lane]);
    uint32_t* const first_depth = tile.depth_stencil + square.row * kTileWidth + square.column;
    uint32_t* const first_pixel = tile.colour + square.row * kTileWidth + square.column;
    for (int first = 0; first < kSquarePixels; first += kLanes) {
      const uint64_t bits = square.mask >> first & kAll;
      if (bits == 0) continue;
      const VecF x =
          hn::Add(hn::ConvertTo(d, hn::Add(columns, hn::Set(di, first % kSmallSide))), to_x);
      const VecF y =
          hn::Add(hn::ConvertTo(d, hn::Add(rows, hn::Set(di, first / kSmallSide))), to_y);
      auto live = mask_of_bits(di, bits);
      if constexpr (kTests) {
        VecI packed = load(first_depth, first);
        const VecI value = to_depth_value(d, depth, evaluate(d, depth_plane, x, y));
        live = depth_stencil_test(di, NoStencilState(), depth, live, value, packed);
        if (depth.write) store(packed, first_depth, first);
        if (hn::AllFalse(di, live)) continue;
      }
      const VecI pixel = flat_ ? flat_pixel : interpolated_pixel(lane, x, y, program.format);
      store(hn::IfThenElse(live, pixel, load(first_pixel, first)), first_pixel, first);
    }
  }

  HWY_INLINE VecI interpolated_pixel(int lane, VecF x, VecF y, ColourFormat format) const {
    const TagF d;
    VecF colour[4];
    for (int c = 0; c < 4; ++c) colour[c] = evaluate(d, colour_[c].of(lane), x, y);
    if (perspective_ && divided_[lane] != 0) {
      const VecF w = hn::Div(hn::Set(d, 1.0f), evaluate(d, inv_w_.of(lane), x, y));
      for (VecF& v : colour) v = hn::Mul(v, w);
    }
    return pack_lanes(colour, format);
  }

  // A vector of a square's pixels, whose first in the tile's plane is `plane`: of one of its rows,
  // or of two.
  static HWY_INLINE VecI load(const uint32_t* plane, int first) {
    const TagI d;
    const auto* from = reinterpret_cast<const int32_t*>(plane) + offset(first);
#if HWY_TARGET != HWY_SCALAR
    if constexpr (kLanes > kSmallSide) {
      const hn::Half<TagI> half;
      return hn::Combine(d, hn::LoadU(half, from + kTileWidth), hn::LoadU(half, from));
    }
#endif
    return hn::LoadU(d, from);
  }
  static HWY_INLINE void store(VecI pixels, uint32_t* plane, int first) {
    const TagI d;
    auto* const to = reinterpret_cast<int32_t*>(plane) + offset(first);
#if HWY_TARGET != HWY_SCALAR
    if constexpr (kLanes > kSmallSide) {
      const hn::Half<TagI> half;
      hn::StoreU(hn::LowerHalf(half, pixels), half, to);
      hn::StoreU(hn::UpperHalf(half, pixels), half, to + kTileWidth);
      return;
    }
#endif
    hn::StoreU(pixels, d, to);
  }
  static HWY_INLINE int offset(int pixel) {
    return pixel / kSmallSide * kTileWidth + pixel % kSmallSide;
  }

  int count_ = 0;
  Square square_[kRoom];
  // Of the group, by lane.
  bool flat_, perspective_;
  alignas(64) float to_x_[kLanes], to_y_[kLanes];
  alignas(64) int32_t pixel_[kLanes];    // if flat_
  alignas(64) int32_t divided_[kLanes];  // by w, if perspective_
  StoredPlane depth_, inv_w_, colour_[4];
};

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
