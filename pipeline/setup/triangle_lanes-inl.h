// Setup of triangles in lanes: triangle.cpp for many at once. See lanes.h.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_SETUP_TRIANGLE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_SETUP_TRIANGLE_LANES_INL_H_
#undef CLEARPIPE_SETUP_TRIANGLE_LANES_INL_H_
#else
#define CLEARPIPE_SETUP_TRIANGLE_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include "pipeline/setup/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::setup::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE MaskI is_culled(const RasterState& raster, MaskI front) {
  switch (raster.cull) {
    case CullFace::kNone:
      break;
    case CullFace::kFront:
      return front;
    case CullFace::kBack:
      return hn::Not(front);
    case CullFace::kFrontAndBack:
      return hn::Not(no_lane());
  }
  return no_lane();
}

// One vector of triangles.
HWY_INLINE void setup_triangle_lanes(const SetupState& state, const LaneJob& job, size_t i) {
  const TagI d;
  const LaneVertices<3> vertices(state, job, i);
  if (vertices.all_outside) return settle_nothing(job, i);
  const VecF half = hn::Set(TagF(), 0.5f);
  MaskI general = vertices.crosses;
  Corner corner[3];
  for (int k = 0; k < 3; ++k) {
    corner[k].x = snap_lanes(hn::Sub(vertices.x[k], half), general);
    corner[k].y = mirror_lanes(state, snap_lanes(hn::Sub(vertices.y[k], half), general));
  }
  const VecI large = fate(LaneFate::kGeneral);
  settle(state, job, i, corner, vertices.outside, general, large, [&](VecI area) HWY_ATTR {
    // Equation 3.4.
    const VecI zero = hn::Zero(d);
    const MaskI clockwise = hn::Lt(area, zero);
    const MaskI front = state.raster.front_is_clockwise ? clockwise : hn::Not(clockwise);
    const MaskI dropped = hn::Or(hn::Eq(area, zero), is_culled(state.raster, front));
    return hn::IfThenZeroElse(
        dropped, hn::IfThenElse(front, fate(LaneFate::kSmall), fate(LaneFate::kSmallOther)));
  });
}

}  // namespace clearpipe::pipeline::setup::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
