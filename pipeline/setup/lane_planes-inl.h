// The attribute planes of many small primitives at once, one primitive in each lane: make_planes
// (planes.cpp), operation by operation.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_SETUP_LANE_PLANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_SETUP_LANE_PLANES_INL_H_
#undef CLEARPIPE_SETUP_LANE_PLANES_INL_H_
#else
#define CLEARPIPE_SETUP_LANE_PLANES_INL_H_
#endif

#include <hwy/highway.h>

#include "pipeline/setup/primitive.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::setup::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using PlaneTag = hn::CappedTag<float, 16>;
using PlaneVec = hn::Vec<PlaneTag>;
using PlaneMask = hn::Mask<PlaneTag>;
inline constexpr int kPlaneLanes = static_cast<int>(hn::MaxLanes(PlaneTag()));

// Primitives of one kind and one state.
struct LanePrimitives {
  int count = 0;
  const float* vertex[3][kPlaneLanes];  // as many as the kind has
  int32_t colour_offset[kPlaneLanes];   // of the facing that is seen
  alignas(64) float size[kPlaneLanes];  // as in PrimitiveRecord

  // Lanes behind the last primitive repeat the first.
  void pad() {
    if constexpr (kPlaneLanes == 1) return;  // count is 1
    for (int i = count; i < kPlaneLanes; ++i) {
      for (auto& corner : vertex) corner[i] = corner[0];
      colour_offset[i] = colour_offset[0];
      size[i] = size[0];
    }
  }
};

struct LanePlane {
  PlaneVec value, dx, dy;
};

// What PrimitivePlanes has, of each lane.
struct LanePlanes {
  PlaneVec x_ref, y_ref;
  bool perspective;             // of some primitive; then inv_w is set, and is 1 for the others
  bool flat_colour;             // all are of one colour: the colour planes are constant
  PlaneMask divided;            // if perspective: colours are divided by w
  PlaneVec half_width, dx, dy;  // of the region of antialiased points and lines (SmoothRegion)
  LanePlane depth, inv_w, fog;
  LanePlane colour[4];
  LanePlane texture[kMaxTextureUnits][4];  // s, t, not r, q
};

// Whether a plane is what colours are divided by, in all lanes: coordinates without a q of their
// own have such a one.
HWY_INLINE bool is_inv_w(const LanePlanes& planes, const LanePlane& q) {
  const PlaneTag d;
  const hn::RebindToSigned<PlaneTag> di;
  const LanePlane one = {hn::Set(d, 1.0f), hn::Zero(d), hn::Zero(d)};
  const LanePlane& inv_w = planes.perspective ? planes.inv_w : one;
  const auto differ = [&](PlaneVec a, PlaneVec b)
                          HWY_ATTR { return hn::Xor(hn::BitCast(di, a), hn::BitCast(di, b)); };
  const auto any =
      hn::Or(differ(q.value, inv_w.value), hn::Or(differ(q.dx, inv_w.dx), differ(q.dy, inv_w.dy)));
  return hn::AllTrue(di, hn::Eq(any, hn::Zero(di)));
}

#if HWY_TARGET != HWY_SCALAR
// Of each fourth vertex from `first` on, four values behind one another: the blocks of a vector.
template <class D, class Offset>
HWY_INLINE hn::Vec<D> load_blocks(D d, const float* const* vertex, int first, Offset offset) {
  if constexpr (hn::MaxLanes(d) == 4) {
    return hn::LoadU(d, vertex[first] + offset(first));
  } else {
    const hn::Half<D> half;
    constexpr int kNext = static_cast<int>(hn::MaxLanes(half));
    return hn::Combine(d, load_blocks(half, vertex, first + kNext, offset),
                       load_blocks(half, vertex, first, offset));
  }
}

#endif

// Four values from an offset on, of the vertex of each lane.
struct LaneValues {
  PlaneVec at[4];

  template <class Offset>
  HWY_INLINE void load(const float* const* vertex, Offset offset) {
#if HWY_TARGET == HWY_SCALAR
    for (int i = 0; i < 4; ++i) at[i] = hn::Set(PlaneTag(), vertex[0][offset(0) + i]);
#else
    const PlaneTag d;
    const hn::Repartition<uint64_t, PlaneTag> d64;
    // Rows of 4x4 values, transposed in each block.
    const PlaneVec row0 = load_blocks(d, vertex, 0, offset);
    const PlaneVec row1 = load_blocks(d, vertex, 1, offset);
    const PlaneVec row2 = load_blocks(d, vertex, 2, offset);
    const PlaneVec row3 = load_blocks(d, vertex, 3, offset);
    const auto low01 = hn::BitCast(d64, hn::InterleaveLower(d, row0, row1));
    const auto low23 = hn::BitCast(d64, hn::InterleaveLower(d, row2, row3));
    const auto high01 = hn::BitCast(d64, hn::InterleaveUpper(d, row0, row1));
    const auto high23 = hn::BitCast(d64, hn::InterleaveUpper(d, row2, row3));
    at[0] = hn::BitCast(d, hn::InterleaveLower(d64, low01, low23));
    at[1] = hn::BitCast(d, hn::InterleaveUpper(d64, low01, low23));
    at[2] = hn::BitCast(d, hn::InterleaveLower(d64, high01, high23));
    at[3] = hn::BitCast(d, hn::InterleaveUpper(d64, high01, high23));
#endif
  }
};

// The gradients of a function, as in planes.cpp; those of a point are 0.
struct LaneBasis {
  PlaneVec x1, x2, y1, y2;

  HWY_INLINE LanePlane plane(PlaneVec a0, PlaneVec a1, PlaneVec a2) const {
    const PlaneVec d1 = hn::Sub(a1, a0), d2 = hn::Sub(a2, a0);
    return {a0, hn::Add(hn::Mul(d1, x1), hn::Mul(d2, x2)),
            hn::Add(hn::Mul(d1, y1), hn::Mul(d2, y2))};
  }
};

// The planes of primitives of a kind: those of fewer than three vertices repeat the first.
template <PrimitiveKind kKind>
class LanePlaneMaker {
 public:
  HWY_INLINE LanePlaneMaker(const SetupState& state, const LanePrimitives& primitives)
      : state_(state), primitives_(primitives) {}

  HWY_INLINE void make(LanePlanes& out) {
    const PlaneTag d;
    LaneValues window[3];
    load_corners(window, [](int) { return vertex_record::kWindow; });
    if (state_.mirror_height > 0) {
      const PlaneVec height = hn::Set(d, static_cast<float>(state_.mirror_height));
      for (LaneValues& w : window) w.at[1] = hn::Sub(height, w.at[1]);
    }
    out.x_ref = window[0].at[0];
    out.y_ref = window[0].at[1];
    out.dx = hn::Sub(window[1].at[0], window[0].at[0]);
    out.dy = hn::Sub(window[1].at[1], window[0].at[1]);
    if (kKind != PrimitiveKind::kTriangle && is_smooth()) {
      out.half_width = kKind == PrimitiveKind::kPoint
                           ? hn::Mul(hn::Set(d, 0.5f), hn::Load(d, primitives_.size))
                           : hn::Set(d, 0.5f * supported_width(state_.raster.line_width));
    }
    set_basis(window);
    if (state_.inputs.depth) set_depth(window, out.depth);
    const PlaneVec w[3] = {window[0].at[3], window[1].at[3], window[2].at[3]};
    const PlaneMask perspective = hn::Or(hn::Ne(w[0], w[1]), hn::Ne(w[0], w[2]));
    out.perspective = perspective_ = !hn::AllFalse(d, perspective);
    if (perspective_) {
      const PlaneVec one = hn::Set(d, 1.0f);
      const LanePlane inv_w = basis_.plane(w[0], w[1], w[2]);
      out.inv_w = {hn::IfThenElse(perspective, inv_w.value, one),
                   hn::IfThenElseZero(perspective, inv_w.dx),
                   hn::IfThenElseZero(perspective, inv_w.dy)};
      for (int k = 0; k < 3; ++k) scale_[k] = hn::IfThenElse(perspective, w[k], one);
    }
    if (state_.inputs.colour) set_colour(perspective, out);
    if (state_.inputs.fog) {
      // The group of four that it is in.
      LaneValues group[3];
      load_corners(group, [](int) { return vertex_record::kOutcode; });
      out.fog = varying(group, vertex_record::kFog - vertex_record::kOutcode);
    }
    for (int unit = 0; state_.inputs.texture_units >> unit != 0; ++unit) {
      if ((state_.inputs.texture_units >> unit & 1) != 0) set_texture(unit, out.texture[unit]);
    }
  }

 private:
  static constexpr int kCorners = static_cast<int>(kKind) + 1;

  bool is_smooth() const { return state_.coverage == FragmentCoverage::kSmooth; }

  template <class Offset>
  HWY_INLINE void load_corners(LaneValues (&corners)[3], const Offset& offset) const {
    for (int k = 0; k < kCorners; ++k) corners[k].load(primitives_.vertex[k], offset);
    for (int k = kCorners; k < 3; ++k) corners[k] = corners[0];
  }

  HWY_INLINE void set_basis(const LaneValues (&window)[3]) {
    const PlaneTag d;
    const PlaneVec zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    const PlaneVec x10 = hn::Sub(window[1].at[0], window[0].at[0]);
    const PlaneVec y10 = hn::Sub(window[1].at[1], window[0].at[1]);
    if constexpr (kKind == PrimitiveKind::kTriangle) {  // equation 3.6
      const PlaneVec x20 = hn::Sub(window[2].at[0], window[0].at[0]);
      const PlaneVec y20 = hn::Sub(window[2].at[1], window[0].at[1]);
      const PlaneVec area = hn::Sub(hn::Mul(x10, y20), hn::Mul(x20, y10));
      const PlaneMask some = hn::Ne(area, zero);
      const PlaneVec inverse = hn::Div(one, area);
      basis_ = {hn::IfThenElseZero(some, hn::Mul(y20, inverse)),
                hn::IfThenElseZero(some, hn::Mul(hn::Neg(y10), inverse)),
                hn::IfThenElseZero(some, hn::Mul(hn::Neg(x20), inverse)),
                hn::IfThenElseZero(some, hn::Mul(x10, inverse))};
    } else if constexpr (kKind == PrimitiveKind::kLine) {
      if (is_smooth()) {  // equation 3.3: along the line itself
        const PlaneVec square = hn::Add(hn::Mul(x10, x10), hn::Mul(y10, y10));
        basis_ = {hn::Div(x10, square), zero, hn::Div(y10, square), zero};
        return;
      }
      // 3.4.1: along the major axis
      const PlaneMask x_major = hn::Gt(hn::Load(d, primitives_.size), zero);
      basis_ = {hn::IfThenElseZero(x_major, hn::Div(one, x10)), zero,
                hn::IfThenZeroElse(x_major, hn::Div(one, y10)), zero};
    } else {
      basis_ = {zero, zero, zero, zero};
    }
  }

  HWY_INLINE void set_depth(const LaneValues (&window)[3], LanePlane& out) const {
    out = basis_.plane(window[0].at[2], window[1].at[2], window[2].at[2]);
    if (!state_.raster.offset_fill || kKind != PrimitiveKind::kTriangle) return;
    alignas(64) float value[kPlaneLanes], dx[kPlaneLanes], dy[kPlaneLanes];
    const PlaneTag d;
    hn::Store(out.value, d, value);
    hn::Store(out.dx, d, dx);
    hn::Store(out.dy, d, dy);
    for (int i = 0; i < kPlaneLanes; ++i) {
      value[i] += polygon_offset(state_, {value[i], dx[i], dy[i]});
    }
    out.value = hn::Load(d, value);
  }

  HWY_INLINE void set_colour(PlaneMask perspective, LanePlanes& out) const {
    const PlaneTag d;
    LaneValues colour[3];
    load_corners(colour, [this](int i) { return primitives_.colour_offset[i]; });
    const PlaneVec zero = hn::Zero(d), one = hn::Set(d, float{kColourOne});
    PlaneMask flat = hn::Eq(zero, zero);
    if (!state_.raster.flat_shade && kKind != PrimitiveKind::kPoint) {
      for (int c = 0; c < 4; ++c) {
        flat = hn::And(flat, hn::And(hn::Eq(colour[0].at[c], colour[1].at[c]),
                                     hn::Eq(colour[0].at[c], colour[2].at[c])));
      }
    }
    out.flat_colour = hn::AllTrue(d, flat);
    out.divided = hn::AndNot(flat, perspective);
    const LaneValues& provoking = colour[kKind == PrimitiveKind::kTriangle ? 2 : kCorners - 1];
    for (int c = 0; c < 4; ++c) {
      LanePlane plane{provoking.at[c], zero, zero};
      if (!out.flat_colour) {
        const LanePlane smooth = varying(colour, c);
        plane.value = hn::IfThenElse(flat, plane.value, smooth.value);
        plane.dx = hn::IfThenZeroElse(flat, smooth.dx);
        plane.dy = hn::IfThenZeroElse(flat, smooth.dy);
      }
      out.colour[c] = {hn::Mul(plane.value, one), hn::Mul(plane.dx, one), hn::Mul(plane.dy, one)};
    }
  }

  HWY_INLINE void set_texture(int unit, LanePlane (&out)[4]) const {
    if (kKind == PrimitiveKind::kPoint && state_.raster.point_sprite &&
        (state_.raster.coord_replace >> unit & 1) != 0) {
      // 3.3.1: s runs from 0 to 1 across the sprite, t from 0 at its top edge.
      const PlaneTag d;
      const PlaneVec zero = hn::Zero(d), half = hn::Set(d, 0.5f), one = hn::Set(d, 1.0f);
      const PlaneVec step = hn::Div(one, hn::Load(d, primitives_.size));
      out[0] = {half, step, zero};
      out[1] = {half, zero, hn::Neg(step)};
      out[3] = {one, zero, zero};
      return;
    }
    LaneValues coordinates[3];
    const int offset = state_.layout.texture_offset[unit];
    load_corners(coordinates, [offset](int) { return offset; });
    for (const int i : {0, 1, 3}) out[i] = varying(coordinates, i);
  }

  HWY_INLINE LanePlane varying(const LaneValues (&corners)[3], int i) const {
    if (!perspective_) return basis_.plane(corners[0].at[i], corners[1].at[i], corners[2].at[i]);
    return basis_.plane(hn::Mul(corners[0].at[i], scale_[0]), hn::Mul(corners[1].at[i], scale_[1]),
                        hn::Mul(corners[2].at[i], scale_[2]));
  }

  const SetupState& state_;
  const LanePrimitives& primitives_;
  LaneBasis basis_;
  bool perspective_ = false;
  PlaneVec scale_[3];  // if so: 1/w of the corners, 1 of primitives without
};

inline void make_lane_planes(const SetupState& state, PrimitiveKind kind,
                             const LanePrimitives& primitives, LanePlanes& out) {
  switch (kind) {
    case PrimitiveKind::kPoint:
      return LanePlaneMaker<PrimitiveKind::kPoint>(state, primitives).make(out);
    case PrimitiveKind::kLine:
      return LanePlaneMaker<PrimitiveKind::kLine>(state, primitives).make(out);
    case PrimitiveKind::kTriangle:
      return LanePlaneMaker<PrimitiveKind::kTriangle>(state, primitives).make(out);
  }
}

}  // namespace clearpipe::pipeline::setup::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
