// Setup of triangles on one SIMD target: see triangles.h.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_SETUP_TRIANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_SETUP_TRIANGLES_INL_H_
#undef CLEARPIPE_SETUP_TRIANGLES_INL_H_
#else
#define CLEARPIPE_SETUP_TRIANGLES_INL_H_
#endif

#include <hwy/highway.h>

#include "pipeline/setup/triangles.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::setup::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using TagI = hn::CappedTag<int32_t, kTriangleLanes>;
using TagF = hn::RebindToFloat<TagI>;
using VecI = hn::Vec<TagI>;
using VecF = hn::Vec<TagF>;
using MaskI = hn::Mask<TagI>;

struct Corner {
  VecI x, y;
};

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

// An edge as an affine function on the square at the triangle's box, with 32 bits: its corners are
// within nine pixels of each other.
struct SquareEdge {
  VecI value, step_x, step_y;
};

HWY_INLINE SquareEdge square_edge(const Corner& p, const Corner& q) {
  const TagI d;
  const VecI a = hn::Sub(p.y, q.y), b = hn::Sub(q.x, p.x);
  const VecI zero = hn::Zero(d);
  // What raster/edge.h says of centres on the edge.
  const MaskI owns = hn::Or(hn::Gt(a, zero), hn::And(hn::Eq(a, zero), hn::Gt(b, zero)));
  const VecI product = hn::Add(hn::Mul(a, p.x), hn::Mul(b, p.y));
  const VecI value = hn::Sub(hn::Neg(product), hn::IfThenZeroElse(owns, hn::Set(d, 1)));
  return {value, hn::ShiftLeft<kSubpixelBits>(a), hn::ShiftLeft<kSubpixelBits>(b)};
}

// Bit 8 * j + i of the masks: the pixel (i, j) of the square is inside the three edges.
HWY_INLINE void mask_square(const SquareEdge (&edges)[3], int width, int height, VecI& low,
                            VecI& high) {
  const TagI d;
  VecI row[3] = {edges[0].value, edges[1].value, edges[2].value};
  low = high = hn::Zero(d);
  for (int j = 0; j < height; ++j) {
    VecI value[3] = {row[0], row[1], row[2]};
    VecI bits = hn::Zero(d);
    uint32_t bit = uint32_t{1} << (kSmallSide * (j & 3));
    for (int i = 0; i < width; ++i, bit <<= 1) {
      const VecI any = hn::Or(hn::Or(value[0], value[1]), value[2]);
      const VecI here = hn::Set(d, static_cast<int32_t>(bit));
      bits = hn::Or(bits, hn::AndNot(hn::BroadcastSignBit(any), here));
      for (int e = 0; e < 3; ++e) value[e] = hn::Add(value[e], edges[e].step_x);
    }
    (j < 4 ? low : high) = hn::Or(j < 4 ? low : high, bits);
    for (int e = 0; e < 3; ++e) row[e] = hn::Add(row[e], edges[e].step_y);
  }
}

HWY_INLINE int greatest(VecI v) {
  const TagI d;
  return hn::GetLane(hn::MaxOfLanes(d, v));
}

HWY_INLINE MaskI is_culled(const RasterState& raster, MaskI front) {
  const TagI d;
  const MaskI all = hn::Eq(hn::Zero(d), hn::Zero(d));
  switch (raster.cull) {
    case CullFace::kNone:
      break;
    case CullFace::kFront:
      return front;
    case CullFace::kBack:
      return hn::Not(front);
    case CullFace::kFrontAndBack:
      return all;
  }
  return hn::Not(all);
}

HWY_INLINE VecI fate(TriangleFate value) { return hn::Set(TagI(), static_cast<int32_t>(value)); }

// One vector of triangles.
HWY_INLINE void setup_lanes(const SetupState& state, const TriangleJob& job, size_t i) {
  const TagI d;
  const TagF df;
  const VecI zero = hn::Zero(d);
  const MaskI none = hn::Lt(zero, zero);
  const MaskI in_use = hn::FirstN(d, job.count - i);  // lanes behind repeat the first vertex
  Corner corner[3];
  VecI any = zero, all = hn::Set(d, ~int32_t{kOutcodeGuard});
  MaskI far = none;
  for (int k = 0; k < 3; ++k) {
    const VecI number = hn::IfThenElseZero(in_use, hn::LoadU(d, job.corner[k] + i));
    const VecI at = hn::Mul(number, hn::Set(d, state.layout.stride));
    const auto* codes = reinterpret_cast<const int32_t*>(job.records + vertex_record::kOutcode);
    const VecI outcode = hn::GatherIndex(d, codes, at);
    any = hn::Or(any, outcode);
    all = hn::And(all, outcode);
    const VecF half = hn::Set(df, 0.5f);
    const float* window = job.records + vertex_record::kWindow;
    corner[k].x = snap_lanes(hn::Sub(hn::GatherIndex(df, window, at), half), far);
    corner[k].y = snap_lanes(hn::Sub(hn::GatherIndex(df, window + 1, at), half), far);
    if (state.mirror_height > 0) {
      corner[k].y = hn::Sub(hn::Set(d, (state.mirror_height - 1) * kSubpixelOne), corner[k].y);
    }
  }
  const MaskI outside = hn::Ne(all, zero);
  const MaskI crosses = hn::Or(hn::Ne(any, zero), far);

  // The box, as set_box has it for centres.
  const VecI low_x = hn::Min(hn::Min(corner[0].x, corner[1].x), corner[2].x);
  const VecI low_y = hn::Min(hn::Min(corner[0].y, corner[1].y), corner[2].y);
  const VecI high_x = hn::Max(hn::Max(corner[0].x, corner[1].x), corner[2].x);
  const VecI high_y = hn::Max(hn::Max(corner[0].y, corner[1].y), corner[2].y);
  const VecI up = hn::Set(d, kSubpixelOne - 1);
  const VecI x0 = hn::ShiftRight<kSubpixelBits>(hn::Add(low_x, up));
  const VecI y0 = hn::ShiftRight<kSubpixelBits>(hn::Add(low_y, up));
  const VecI x1 = hn::ShiftRight<kSubpixelBits>(high_x);  // inclusive
  const VecI y1 = hn::ShiftRight<kSubpixelBits>(high_y);
  const MaskI empty = hn::Or(hn::Lt(x1, x0), hn::Lt(y1, y0));
  const VecI side = hn::Set(d, kSmallSide);
  const VecI right = hn::Sub(x1, x0), upper = hn::Sub(y1, y0);
  const MaskI fits = hn::And(hn::Lt(right, side), hn::Lt(upper, side));
  const MaskI cut = hn::Or(
      hn::Or(hn::Lt(x0, hn::Set(d, state.bounds.x0)), hn::Gt(x1, hn::Set(d, state.bounds.x1 - 1))),
      hn::Or(hn::Lt(y0, hn::Set(d, state.bounds.y0)), hn::Gt(y1, hn::Set(d, state.bounds.y1 - 1))));
  const MaskI small = hn::AndNot(hn::Or(hn::Or(crosses, empty), cut), fits);

  VecI result = hn::IfThenElse(empty, fate(TriangleFate::kNothing), fate(TriangleFate::kGeneral));
  result = hn::IfThenElse(crosses, fate(TriangleFate::kGeneral), result);
  if (!hn::AllFalse(d, small)) {
    for (Corner& c : corner) {
      c.x = hn::Sub(c.x, hn::ShiftLeft<kSubpixelBits>(x0));
      c.y = hn::Sub(c.y, hn::ShiftLeft<kSubpixelBits>(y0));
    }
    // Equation 3.4.
    const VecI area =
        hn::Sub(hn::Mul(hn::Sub(corner[1].x, corner[0].x), hn::Sub(corner[2].y, corner[0].y)),
                hn::Mul(hn::Sub(corner[2].x, corner[0].x), hn::Sub(corner[1].y, corner[0].y)));
    const MaskI clockwise = hn::Lt(area, zero);
    const MaskI front = state.raster.front_is_clockwise ? clockwise : hn::Not(clockwise);
    const MaskI dropped = hn::Or(hn::Eq(area, zero), is_culled(state.raster, front));
    const Corner second = {hn::IfThenElse(clockwise, corner[2].x, corner[1].x),
                           hn::IfThenElse(clockwise, corner[2].y, corner[1].y)};
    const Corner third = {hn::IfThenElse(clockwise, corner[1].x, corner[2].x),
                          hn::IfThenElse(clockwise, corner[1].y, corner[2].y)};
    const SquareEdge edges[3] = {square_edge(corner[0], second), square_edge(second, third),
                                 square_edge(third, corner[0])};
    const MaskI kept = hn::AndNot(dropped, small);
    VecI low, high;
    mask_square(edges, greatest(hn::IfThenElseZero(small, right)) + 1,
                greatest(hn::IfThenElseZero(small, upper)) + 1, low, high);
    const MaskI covers = hn::And(kept, hn::Ne(hn::Or(low, high), zero));
    const VecI facing =
        hn::IfThenElse(front, fate(TriangleFate::kSmallFront), fate(TriangleFate::kSmallBack));
    result = hn::IfThenElse(small, hn::IfThenElseZero(covers, facing), result);
    hn::StoreU(x0, d, job.x + i);
    hn::StoreU(y0, d, job.y + i);
    hn::StoreU(hn::BitCast(hn::RebindToUnsigned<TagI>(), low), hn::RebindToUnsigned<TagI>(),
               job.mask_low + i);
    hn::StoreU(hn::BitCast(hn::RebindToUnsigned<TagI>(), high), hn::RebindToUnsigned<TagI>(),
               job.mask_high + i);
  }
  static_assert(static_cast<int>(TriangleFate::kNothing) == 0);
  hn::StoreU(hn::IfThenZeroElse(outside, result), d, job.fate + i);
}

}  // namespace clearpipe::pipeline::setup::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
