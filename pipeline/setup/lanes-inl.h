// What setup of triangles and lines in lanes shares: vertices, snapping, and the mask of a convex
// polygon that is small. See lanes.h.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_SETUP_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_SETUP_LANES_INL_H_
#undef CLEARPIPE_SETUP_LANES_INL_H_
#else
#define CLEARPIPE_SETUP_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "pipeline/setup/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::setup::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using TagI = hn::CappedTag<int32_t, kSetupLanes>;
using TagU = hn::RebindToUnsigned<TagI>;
using TagF = hn::RebindToFloat<TagI>;
using VecI = hn::Vec<TagI>;
using VecF = hn::Vec<TagF>;
using MaskI = hn::Mask<TagI>;
using MaskF = hn::Mask<TagF>;

HWY_INLINE MaskI no_lane() {
  const VecI zero = hn::Zero(TagI());
  return hn::Lt(zero, zero);
}

HWY_INLINE VecI fate(LaneFate value) { return hn::Set(TagI(), static_cast<int32_t>(value)); }

// Window x and y of the vertices of a vector of primitives, and what their outcodes say.
template <int kVertices>
struct LaneVertices {
  VecF x[kVertices], y[kVertices];  // not set if all are outside
  MaskI outside;                    // of a clip plane, as a whole
  MaskI crosses;                    // some plane
  bool all_outside;

  HWY_INLINE LaneVertices(const SetupState& state, const LaneJob& job, size_t i) {
    const TagI d;
    const TagF df;
    const MaskI in_use = hn::FirstN(d, job.count - i);  // lanes behind repeat the first vertex
    const auto* codes = reinterpret_cast<const int32_t*>(job.records + vertex_record::kOutcode);
    const float* window = job.records + vertex_record::kWindow;
    VecI any = hn::Zero(d), all = hn::Set(d, ~int32_t{kOutcodeGuard});
    VecI at[kVertices];
    for (int k = 0; k < kVertices; ++k) {
      const VecI number = hn::IfThenElseZero(in_use, hn::LoadU(d, job.corner[k] + i));
      at[k] = hn::Mul(number, hn::Set(d, state.layout.stride));
      const VecI outcode = hn::GatherIndex(d, codes, at[k]);
      any = hn::Or(any, outcode);
      all = hn::And(all, outcode);
    }
    outside = hn::Ne(all, hn::Zero(d));
    crosses = hn::Ne(any, hn::Zero(d));
    all_outside = hn::AllTrue(d, outside);
    if (all_outside) return;
    for (int k = 0; k < kVertices; ++k) {
      x[k] = hn::GatherIndex(df, window, at[k]);
      y[k] = hn::GatherIndex(df, window + 1, at[k]);
    }
  }
};

HWY_INLINE void settle_nothing(const LaneJob& job, size_t i) {
  static_assert(static_cast<int>(LaneFate::kNothing) == 0);
  hn::StoreU(hn::Zero(TagI()), TagI(), job.fate + i);
}

// As snap() does below its limit; beyond it `far` is set.
HWY_INLINE VecI snap_lanes(VecF pixels, MaskI& far) {
  const TagF d;
  const VecF v = hn::Mul(pixels, hn::Set(d, static_cast<float>(kSubpixelOne)));
  const VecF magic = hn::Set(d, 12582912.0f);
  const auto near = hn::Lt(hn::Abs(v), hn::Set(d, 4194304.0f));
  far = hn::Or(far, hn::Not(hn::RebindMask(TagI(), near)));
  const VecF whole = hn::Sub(hn::Add(v, magic), magic);
  return hn::ConvertTo(TagI(), hn::IfThenElseZero(near, whole));
}

struct Corner {
  VecI x, y;
};

HWY_INLINE VecI mirror_lanes(const SetupState& state, VecI y) {
  if (state.mirror_height == 0) return y;
  return hn::Sub(hn::Set(TagI(), (state.mirror_height - 1) * kSubpixelOne), y);
}

// An edge as an affine function of the pixels of the polygon's box, with 32 bits: corners are
// within 17 pixels of each other.
struct SquareEdge {
  VecI value, step_x, step_y;

  // At the first pixel of a square.
  HWY_INLINE VecI at(int square) const {
    static_assert(kLaneSquares == 2 && kSmallSide == 8);
    VecI v = value;
    if (square % 2 != 0) v = hn::Add(v, hn::ShiftLeft<3>(step_x));
    if (square / 2 != 0) v = hn::Add(v, hn::ShiftLeft<3>(step_y));
    return v;
  }
};

// From p to q, or in lanes where all bits of `reverse` are set the other way.
HWY_INLINE SquareEdge square_edge(const Corner& p, const Corner& q, VecI reverse) {
  const TagI d;
  const auto turned = [reverse](VecI v) HWY_ATTR { return hn::Sub(hn::Xor(v, reverse), reverse); };
  const VecI a = turned(hn::Sub(p.y, q.y)), b = turned(hn::Sub(q.x, p.x));
  const VecI zero = hn::Zero(d);
  // What raster/edge.h says of centres on the edge.
  const MaskI owns = hn::Or(hn::Gt(a, zero), hn::And(hn::Eq(a, zero), hn::Gt(b, zero)));
  const VecI product = hn::Add(hn::Mul(a, p.x), hn::Mul(b, p.y));
  const VecI value = hn::Sub(hn::Neg(product), hn::IfThenZeroElse(owns, hn::Set(d, 1)));
  return {value, hn::ShiftLeft<kSubpixelBits>(a), hn::ShiftLeft<kSubpixelBits>(b)};
}

// Bit 8 * j + i of the masks: the pixel (i, j) of the square is inside all edges. Of the square
// only so many columns and rows are looked at.
template <int kEdges>
HWY_INLINE void mask_square(const SquareEdge (&edges)[kEdges], int square, int width, int height,
                            VecI& low, VecI& high) {
  const TagI d;
  VecI row[kEdges];
  for (int e = 0; e < kEdges; ++e) row[e] = edges[e].at(square);
  low = high = hn::Zero(d);
  for (int j = 0; j < height; ++j) {
    VecI value[kEdges];
    for (int e = 0; e < kEdges; ++e) value[e] = row[e];
    VecI bits = hn::Zero(d);
    uint32_t bit = uint32_t{1} << (kSmallSide * (j & 3));
    for (int i = 0; i < width; ++i, bit <<= 1) {
      VecI any = value[0];
      for (int e = 1; e < kEdges; ++e) any = hn::Or(any, value[e]);
      const VecI here = hn::Set(d, static_cast<int32_t>(bit));
      bits = hn::Or(bits, hn::AndNot(hn::BroadcastSignBit(any), here));
      for (int e = 0; e < kEdges; ++e) value[e] = hn::Add(value[e], edges[e].step_x);
    }
    (j < 4 ? low : high) = hn::Or(j < 4 ? low : high, bits);
    for (int e = 0; e < kEdges; ++e) row[e] = hn::Add(row[e], edges[e].step_y);
  }
}

HWY_INLINE int greatest(VecI v) {
  const TagI d;
  return hn::GetLane(hn::MaxOfLanes(d, v));
}

// The end of setup of a vector of convex polygons in either winding: their fates and masks.
// `general` are those that are left to setup of one; `large` is the fate of others that are not
// small, and `fate_of` gives that of small ones with pixels from twice their area, in square
// subpixels.
template <int kCorners, class FateOf>
HWY_INLINE void settle(const SetupState& state, const LaneJob& job, size_t i,
                       Corner (&corner)[kCorners], MaskI nothing, MaskI general, VecI large,
                       const FateOf& fate_of) {
  const TagI d;
  const VecI zero = hn::Zero(d);
  // The box, as set_box has it for centres.
  VecI low_x = corner[0].x, high_x = corner[0].x, low_y = corner[0].y, high_y = corner[0].y;
  for (int k = 1; k < kCorners; ++k) {
    low_x = hn::Min(low_x, corner[k].x);
    high_x = hn::Max(high_x, corner[k].x);
    low_y = hn::Min(low_y, corner[k].y);
    high_y = hn::Max(high_y, corner[k].y);
  }
  const VecI up = hn::Set(d, kSubpixelOne - 1);
  const VecI x0 = hn::ShiftRight<kSubpixelBits>(hn::Add(low_x, up));
  const VecI y0 = hn::ShiftRight<kSubpixelBits>(hn::Add(low_y, up));
  const VecI x1 = hn::ShiftRight<kSubpixelBits>(high_x);  // inclusive
  const VecI y1 = hn::ShiftRight<kSubpixelBits>(high_y);
  const MaskI empty = hn::Or(hn::Lt(x1, x0), hn::Lt(y1, y0));
  const VecI side = hn::Set(d, kLaneSquares * kSmallSide);
  const VecI right = hn::Sub(x1, x0), upper = hn::Sub(y1, y0);
  const MaskI fits = hn::And(hn::Lt(right, side), hn::Lt(upper, side));
  const MaskI cut = hn::Or(
      hn::Or(hn::Lt(x0, hn::Set(d, state.bounds.x0)), hn::Gt(x1, hn::Set(d, state.bounds.x1 - 1))),
      hn::Or(hn::Lt(y0, hn::Set(d, state.bounds.y0)), hn::Gt(y1, hn::Set(d, state.bounds.y1 - 1))));
  const MaskI small = hn::AndNot(hn::Or(hn::Or(general, empty), cut), fits);

  static_assert(static_cast<int>(LaneFate::kNothing) == 0);
  VecI result = hn::IfThenZeroElse(empty, large);
  result = hn::IfThenElse(general, fate(LaneFate::kGeneral), result);
  if (!hn::AllFalse(d, small)) {
    for (Corner& c : corner) {
      c.x = hn::Sub(c.x, hn::ShiftLeft<kSubpixelBits>(x0));
      c.y = hn::Sub(c.y, hn::ShiftLeft<kSubpixelBits>(y0));
    }
    VecI area = zero;
    for (int k = 1; k + 1 < kCorners; ++k) {
      const Corner &a = corner[k], &b = corner[k + 1], &o = corner[0];
      area = hn::Add(area, hn::Sub(hn::Mul(hn::Sub(a.x, o.x), hn::Sub(b.y, o.y)),
                                   hn::Mul(hn::Sub(b.x, o.x), hn::Sub(a.y, o.y))));
    }
    const VecI reverse = hn::BroadcastSignBit(area);
    SquareEdge edges[kCorners];
    for (int k = 0; k < kCorners; ++k) {
      edges[k] = square_edge(corner[k], corner[(k + 1) % kCorners], reverse);
    }
    const int width = greatest(hn::IfThenElseZero(small, right)) + 1;
    const int height = greatest(hn::IfThenElseZero(small, upper)) + 1;
    const TagU du;
    VecI covered = zero, more = zero;
    for (int square = 0; square < kSquaresOfLane; ++square) {
      const int columns = std::min(width - square % kLaneSquares * kSmallSide, kSmallSide);
      const int rows = std::min(height - square / kLaneSquares * kSmallSide, kSmallSide);
      VecI low = zero, high = zero;
      if (columns > 0 && rows > 0) mask_square(edges, square, columns, rows, low, high);
      covered = hn::Or(covered, hn::Or(low, high));
      if (square != 0) more = hn::Or(more, hn::Or(low, high));
      hn::StoreU(hn::BitCast(du, low), du, job.mask_low[square] + i);
      hn::StoreU(hn::BitCast(du, high), du, job.mask_high[square] + i);
    }
    const MaskI covers = hn::Ne(covered, zero);
    result = hn::IfThenElse(small, hn::IfThenElseZero(covers, fate_of(area)), result);
    hn::StoreU(x0, d, job.x + i);
    hn::StoreU(y0, d, job.y + i);
    hn::StoreU(more, d, job.more + i);
  }
  hn::StoreU(hn::IfThenZeroElse(nothing, result), d, job.fate + i);
}

}  // namespace clearpipe::pipeline::setup::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
