// Setup of lines in lanes: line.cpp for many at once, whose comments say what happens. See lanes.h.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_SETUP_LINE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_SETUP_LINE_LANES_INL_H_
#undef CLEARPIPE_SETUP_LINE_LANES_INL_H_
#else
#define CLEARPIPE_SETUP_LINE_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include "pipeline/setup/lanes-inl.h"
#include "pipeline/setup/stroke.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::setup::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Of an end point along the line's major axis and the other one.
struct LanePoint {
  VecF major, minor;
};

// 3.4.1: an end point as the diamond-exit rule sees it.
struct LaneEnd {
  VecF major;       // offset from the centre of its pixel, [-0.5, 0.5)
  MaskF on_centre;  // there
  MaskF beyond;     // past the centre, as the line goes
  MaskF in_diamond;

  HWY_INLINE LaneEnd(const LanePoint& p, VecF direction) {
    const TagF d;
    const VecF half = hn::Set(d, 0.5f), zero = hn::Zero(d);
    const auto from_centre = [half](VecF v)
                                 HWY_ATTR { return hn::Sub(hn::Sub(v, hn::Floor(v)), half); };
    major = from_centre(p.major);
    beyond = hn::Gt(hn::Mul(major, direction), zero);
    on_centre = hn::Eq(major, zero);
    in_diamond = hn::Lt(hn::Add(hn::Abs(major), hn::Abs(from_centre(p.minor))), half);
  }
};

// Where `moved`, the end moves along the line to the border of its column that lies on `side`.
HWY_INLINE LanePoint move_to_border(const LanePoint& p, const LaneEnd& end, VecF slope, VecF side,
                                    MaskF moved) {
  const TagF d;
  const VecF offset = hn::Add(hn::Neg(end.major), hn::Mul(side, hn::Set(d, 0.5f)));
  return {hn::IfThenElse(moved, hn::Add(p.major, offset), p.major),
          hn::IfThenElse(moved, hn::Add(p.minor, hn::Mul(offset, slope)), p.minor)};
}

HWY_INLINE VecF select(MaskF mask, VecF yes, VecF no) { return hn::IfThenElse(mask, yes, no); }

// One vector of lines.
HWY_INLINE void setup_line_lanes(const SetupState& state, const LaneJob& job, size_t i) {
  const TagI d;
  const TagF df;
  const VecF zero = hn::Zero(df), one = hn::Set(df, 1.0f), half = hn::Set(df, 0.5f);
  const LaneVertices<2> v(state, job, i);
  if (v.all_outside) return settle_nothing(job, i);
  const VecF dx = hn::Sub(v.x[1], v.x[0]), dy = hn::Sub(v.y[1], v.y[0]);
  const MaskF point = hn::And(hn::Eq(dx, zero), hn::Eq(dy, zero));
  const MaskF x_major = hn::Ge(hn::Abs(dx), hn::Abs(dy));
  LanePoint start = {select(x_major, v.x[0], v.y[0]), select(x_major, v.y[0], v.x[0])};
  LanePoint end = {select(x_major, v.x[1], v.y[1]), select(x_major, v.y[1], v.x[1])};
  const VecF along = select(x_major, dx, dy);
  const VecF slope = hn::Div(select(x_major, dy, dx), along);
  const VecF direction = select(hn::Gt(along, zero), one, hn::Neg(one));

  const LaneEnd s(start, direction), e(end, direction);
  const MaskF forward = hn::Gt(direction, zero);
  MaskF at_lower = forward;  // the line starts at its left or lower end, in the window
  if (state.mirror_height > 0) at_lower = hn::Xor(forward, hn::Not(x_major));
  const VecF s_along = hn::Mul(s.major, direction);
  const MaskF start_covered =
      hn::Or(hn::And(s.on_centre, at_lower), hn::AndNot(s.on_centre, hn::Lt(s_along, zero)));
  const MaskF end_covered =
      hn::Or(hn::AndNot(at_lower, e.on_centre), hn::AndNot(e.on_centre, e.beyond));
  const MaskF start_drawn = hn::Or(s.in_diamond, hn::Le(s_along, zero));
  const MaskF end_drawn = hn::AndNot(e.in_diamond, e.beyond);
  const VecF back = hn::Neg(direction);
  start = move_to_border(start, s, slope, select(start_drawn, back, direction),
                         hn::Xor(start_covered, start_drawn));
  end = move_to_border(end, e, slope, select(end_drawn, direction, back),
                       hn::Xor(end_covered, end_drawn));

  const int width = stroke_width(state.raster);
  const VecI half_width = hn::Set(d, width * kSubpixelOne / 2);
  MaskI general = v.crosses;
  const VecI start_major = snap_lanes(hn::Sub(start.major, half), general);
  const VecI start_minor = snap_lanes(hn::Sub(start.minor, half), general);
  const VecI end_major = snap_lanes(hn::Sub(end.major, half), general);
  const VecI end_minor = snap_lanes(hn::Sub(end.minor, half), general);
  const VecI major[4] = {start_major, end_major, end_major, start_major};
  const VecI minor[4] = {hn::Sub(start_minor, half_width), hn::Sub(end_minor, half_width),
                         hn::Add(end_minor, half_width), hn::Add(start_minor, half_width)};
  const MaskI across = hn::RebindMask(d, x_major);
  Corner corner[4];
  for (int k = 0; k < 4; ++k) {
    corner[k].x = hn::IfThenElse(across, major[k], minor[k]);
    corner[k].y = mirror_lanes(state, hn::IfThenElse(across, minor[k], major[k]));
    hn::StoreU(corner[k].x, d, job.snapped_x[k] + i);
    hn::StoreU(corner[k].y, d, job.snapped_y[k] + i);
  }
  const MaskI nothing = hn::Or(v.outside, hn::AndNot(v.crosses, hn::RebindMask(d, point)));
  const VecI large =
      hn::IfThenElse(across, fate(LaneFate::kSnapped), fate(LaneFate::kSnappedOther));
  if (job.corners_alone) {
    const VecI result = hn::IfThenElse(general, fate(LaneFate::kGeneral), large);
    hn::StoreU(hn::IfThenZeroElse(nothing, result), d, job.fate + i);
    return;
  }
  settle(state, job, i, corner, nothing, general, large, [&](VecI) HWY_ATTR {
    return hn::IfThenElse(across, fate(LaneFate::kSmall), fate(LaneFate::kSmallOther));
  });
}

}  // namespace clearpipe::pipeline::setup::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
