// Clip tests and the viewport (2.10.1, 2.11): outcodes, distances to user planes, and window
// coordinates.
//
// Window x, y, z decide coverage, so they follow the reference to the bit: a true 1/w, a rounded
// product x * (1/w), then scale and translation under a single rounding. The product of two floats
// is exact in double precision, hence double arithmetic rounds the sum just once too, without
// needing a fused instruction that some processors lack. (The sum is rounded to double and then to
// float; the two roundings differ from one in about one case in 2^29.)
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_VERTEX_PROJECT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_VERTEX_PROJECT_INL_H_
#undef CLEARPIPE_VERTEX_PROJECT_INL_H_
#else
#define CLEARPIPE_VERTEX_PROJECT_INL_H_
#endif

#include <hwy/highway.h>

#include <limits>

#include "pipeline/vertex/transform-inl.h"
#include "pipeline/vertex/vertex_batch.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::vertex::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// A vertex is outside a plane unless it is known to be inside, so a NaN is outside all of them.
// The guard bit is also set for w <= 0 and for coordinates that are not finite: window coordinates
// of such a vertex mean nothing.
HWY_INLINE void test_clip_volume(const Lane* clip, const GuardBand& guard, size_t count,
                                 float* outcode) {
  const hn::ScalableTag<float> d;
  const hn::RebindToUnsigned<decltype(d)> du;
  using V = hn::Vec<decltype(d)>;
  const auto zero = hn::Zero(d);
  constexpr uint32_t kAll = 2 * kOutcodeGuard - 1;
  const auto largest = hn::Set(d, std::numeric_limits<float>::max());
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const V x = hn::Load(d, clip[0] + i);
    const V y = hn::Load(d, clip[1] + i);
    const V z = hn::Load(d, clip[2] + i);
    const V w = hn::Load(d, clip[3] + i);
    const V minus_w = hn::Neg(w);
    auto inside_of = hn::Zero(du);
    const auto note = [&](auto inside, uint32_t bit) HWY_ATTR {
      inside_of =
          hn::Or(inside_of, hn::IfThenElseZero(hn::RebindMask(du, inside), hn::Set(du, bit)));
    };
    note(hn::Ge(x, minus_w), kOutcodeLeft);
    note(hn::Le(x, w), kOutcodeRight);
    note(hn::Ge(y, minus_w), kOutcodeBottom);
    note(hn::Le(y, w), kOutcodeTop);
    note(hn::Ge(z, minus_w), kOutcodeNear);
    note(hn::Le(z, w), kOutcodeFar);
    const auto in_x = hn::And(hn::Ge(x, hn::Mul(hn::Set(d, guard.x_min), w)),
                              hn::Le(x, hn::Mul(hn::Set(d, guard.x_max), w)));
    const auto in_y = hn::And(hn::Ge(y, hn::Mul(hn::Set(d, guard.y_min), w)),
                              hn::Le(y, hn::Mul(hn::Set(d, guard.y_max), w)));
    const auto finite_xy = hn::And(hn::Le(hn::Abs(x), largest), hn::Le(hn::Abs(y), largest));
    const auto finite_zw = hn::And(hn::Le(hn::Abs(z), largest), hn::Le(w, largest));
    const auto finite = hn::And(finite_xy, hn::And(finite_zw, hn::Gt(w, zero)));
    note(hn::And(finite, hn::And(in_x, in_y)), kOutcodeGuard);
    const auto code = hn::AndNot(inside_of, hn::Set(du, kAll));
    hn::Store(hn::BitCast(d, code), d, outcode + i);
  }
}

// Signed distances to the enabled user planes, in eye coordinates (2.11): outside is negative.
HWY_INLINE void test_user_planes(const VertexState& state, const Lane* eye, size_t count,
                                 Lane* distance, float* outcode) {
  const hn::ScalableTag<float> d;
  const hn::RebindToUnsigned<decltype(d)> du;
  for (int plane = 0; plane < kMaxClipPlanes; ++plane) {
    if ((state.clip_planes >> plane & 1) == 0) {
      continue;
    }
    const Vec4& p = state.clip_plane[plane];
    const auto bit = hn::Set(du, static_cast<uint32_t>(kOutcodeUser) << plane);
    for (size_t i = 0; i < count; i += hn::Lanes(d)) {
      const auto value =
          dot4(d, p.x, p.y, p.z, p.w, hn::Load(d, eye[0] + i), hn::Load(d, eye[1] + i),
               hn::Load(d, eye[2] + i), hn::Load(d, eye[3] + i));
      hn::Store(value, d, distance[plane] + i);
      const auto outside = hn::Not(hn::Ge(value, hn::Zero(d)));
      const auto code = hn::BitCast(du, hn::Load(d, outcode + i));
      const auto added = hn::And(hn::BitCast(du, hn::VecFromMask(d, outside)), bit);
      hn::Store(hn::BitCast(d, hn::Or(code, added)), d, outcode + i);
    }
  }
}

// Half a vector at a time, as double precision takes twice the room.
HWY_INLINE void project_to_window(const Lane* clip, const Viewport& viewport, size_t count,
                                  Lane* window) {
  const hn::ScalableTag<double> wide;
  const hn::Rebind<float, decltype(wide)> d;
  const double scale[3] = {viewport.scale_x, viewport.scale_y, viewport.scale_z};
  const double centre[3] = {viewport.centre_x, viewport.centre_y, viewport.centre_z};
  for (size_t i = 0; i < count; i += hn::Lanes(wide)) {
    const auto reciprocal_w = hn::Div(hn::Set(d, 1.0f), hn::Load(d, clip[3] + i));
    for (int axis = 0; axis < 3; ++axis) {
      const auto device = hn::Mul(hn::Load(d, clip[axis] + i), reciprocal_w);
      const auto scaled = hn::Mul(hn::PromoteTo(wide, device), hn::Set(wide, scale[axis]));
      const auto moved = hn::Add(scaled, hn::Set(wide, centre[axis]));
      hn::Store(hn::DemoteTo(d, moved), d, window[axis] + i);
    }
    hn::Store(reciprocal_w, d, window[3] + i);
  }
}

}  // namespace clearpipe::pipeline::vertex::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CLEARPIPE_VERTEX_PROJECT_INL_H_
