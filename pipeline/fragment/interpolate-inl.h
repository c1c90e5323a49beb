// Interpolation (3.5.1): attribute planes evaluated at pixel centres.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_INTERPOLATE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_INTERPOLATE_INL_H_
#undef CLEARPIPE_FRAGMENT_INTERPOLATE_INL_H_
#else
#define CLEARPIPE_FRAGMENT_INTERPOLATE_INL_H_
#endif

#include <hwy/highway.h>

#include "pipeline/fragment/batch.h"
#include "pipeline/fragment/colour-inl.h"
#include "pipeline/fragment/program.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// (value + dy * y) + dx * x, with x and y relative to the primitive's reference.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V evaluate(D d, const Plane& plane, V x, V y) {
  const V row = hn::Add(hn::Set(d, plane.value), hn::Mul(hn::Set(d, plane.dy), y));
  return hn::Add(row, hn::Mul(hn::Set(d, plane.dx), x));
}

// The same of planes that differ by lane: anything with value, dx and dy in vectors.
template <class D, class P, class V = decltype(P::value)>
HWY_INLINE V evaluate(D, const P& plane, V x, V y) {
  const V row = hn::Add(plane.value, hn::Mul(plane.dy, y));
  return hn::Add(row, hn::Mul(plane.dx, x));
}

// w_clip of each fragment, the reciprocal of its interpolated inverse.
inline void interpolate_w(const PrimitivePlanes& planes, FragmentBatch& batch) {
  const hn::ScalableTag<float> d;
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    const auto inverse =
        evaluate(d, planes.inv_w, hn::Load(d, batch.x + i), hn::Load(d, batch.y + i));
    hn::Store(hn::Div(hn::Set(d, 1.0f), inverse), d, batch.w + i);
  }
}

// The primary colour, clamped; also the colour that the first texture unit finds.
inline void interpolate_colour(const PrimitivePlanes& planes, FragmentBatch& batch) {
  const hn::ScalableTag<float> d;
  const hn::Rebind<int16_t, decltype(d)> d16;
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int c = 0; c < 4; ++c) {
    const Plane& plane = planes.colour[c];
    for (int i = 0; i < batch.count; i += lanes) {
      auto value = evaluate(d, plane, hn::Load(d, batch.x + i), hn::Load(d, batch.y + i));
      if (planes.perspective && !planes.flat_colour) {
        value = hn::Mul(value, hn::Load(d, batch.w + i));
      }
      const auto colour = hn::DemoteTo(d16, round_colour(d, value));
      hn::Store(colour, d16, batch.primary[c] + i);
      hn::Store(colour, d16, batch.previous[c] + i);
    }
  }
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
