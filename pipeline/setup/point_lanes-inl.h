// Setup of points in lanes: point.cpp for many at once, whose comments say what happens. See
// lanes.h.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_SETUP_POINT_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_SETUP_POINT_LANES_INL_H_
#undef CLEARPIPE_SETUP_POINT_LANES_INL_H_
#else
#define CLEARPIPE_SETUP_POINT_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include "pipeline/setup/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::setup::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// As supported_width().
HWY_INLINE VecF point_sizes(const SetupState& state, const LaneJob& job, size_t i) {
  const TagI d;
  const TagF df;
  const VecI number =
      hn::IfThenElseZero(hn::FirstN(d, job.count - i), hn::LoadU(d, job.corner[0] + i));
  const VecF size = hn::GatherIndex(df, job.records + vertex_record::kPointSize,
                                    hn::Mul(number, hn::Set(d, state.layout.stride)));
  const VecF one = hn::Set(df, 1.0f);
  return hn::IfThenElse(hn::Gt(size, one), hn::Min(size, hn::Set(df, 255.0f)), one);
}

// The ends of a square along x and y, from the centre of pixel (0, 0).
struct LaneSquare {
  VecI left, right, low, high;
};

struct LanePixels {
  VecI x, y;
};

// 3.3: the first of a square of whole pixels.
HWY_INLINE LanePixels first_pixels(const SetupState& state, VecF x, VecF y, VecI width,
                                   MaskI& far) {
  const TagI d;
  const auto odd = hn::Ne(hn::And(width, hn::Set(d, 1)), hn::Zero(d));
  const VecI rounding = hn::IfThenZeroElse(odd, hn::Set(d, kSubpixelOne / 2));
  const auto first = [&](VecI centre) HWY_ATTR {
    return hn::Sub(hn::ShiftRight<kSubpixelBits>(hn::Add(centre, rounding)),
                   hn::ShiftRight<1>(width));
  };
  VecI centre_y = snap_lanes(y, far);
  if (state.mirror_height > 0) {
    centre_y = hn::Sub(hn::Set(d, state.mirror_height * kSubpixelOne), centre_y);
  }
  return {first(snap_lanes(x, far)), first(centre_y)};
}

HWY_INLINE LaneSquare pixel_square(const SetupState& state, VecF x, VecF y, VecF size,
                                   MaskI& general) {
  const TagI d;
  const VecI width = hn::ConvertTo(d, hn::Ceil(hn::Sub(size, hn::Set(TagF(), 0.5f))));
  const LanePixels pixels = first_pixels(state, x, y, width, general);
  const auto low_end = [&](VecI pixel) HWY_ATTR {
    return hn::Sub(hn::ShiftLeft<kSubpixelBits>(pixel), hn::Set(d, kSubpixelOne / 2));
  };
  const VecI left = low_end(pixels.x), low = low_end(pixels.y);
  const VecI side = hn::ShiftLeft<kSubpixelBits>(width);
  return {left, hn::Add(left, side), low, hn::Add(low, side)};
}

// 3.3.1: a point sprite.
HWY_INLINE LaneSquare sprite_square(const SetupState& state, VecF x, VecF y, VecF size,
                                    MaskI& general) {
  const VecF half = hn::Set(TagF(), 0.5f);
  const VecI width = snap_lanes(size, general), to_first = hn::ShiftRight<1>(width);
  const VecI left = hn::Sub(snap_lanes(hn::Sub(x, half), general), to_first);
  const VecI first = hn::Sub(snap_lanes(hn::Sub(y, half), general), to_first);
  return {left, hn::Add(left, width), mirror_lanes(state, first),
          mirror_lanes(state, hn::Add(first, width))};
}

// One vector of points.
HWY_INLINE void setup_point_lanes(const SetupState& state, const LaneJob& job, size_t i) {
  const LaneVertices<1> v(state, job, i);
  if (v.all_outside) return settle_nothing(job, i);
  const VecF size = point_sizes(state, job, i);
  MaskI general = no_lane();
  const LaneSquare s = state.raster.point_sprite
                           ? sprite_square(state, v.x[0], v.y[0], size, general)
                           : pixel_square(state, v.x[0], v.y[0], size, general);
  Corner corner[4] = {{s.left, s.low}, {s.right, s.low}, {s.right, s.high}, {s.left, s.high}};
  // A point that crosses a plane is gone (2.11).
  settle(state, job, i, corner, v.crosses, general, fate(LaneFate::kGeneral),
         [](VecI) HWY_ATTR { return fate(LaneFate::kSmall); });
}

}  // namespace clearpipe::pipeline::setup::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
