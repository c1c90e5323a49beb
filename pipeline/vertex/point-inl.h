// The derived size of points, their fade factor (3.3), and the fog coordinate (3.8).
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_VERTEX_POINT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_VERTEX_POINT_INL_H_
#undef CLEARPIPE_VERTEX_POINT_INL_H_
#else
#define CLEARPIPE_VERTEX_POINT_INL_H_
#endif

#include <hwy/highway.h>

#include "pipeline/vertex/math-inl.h"
#include "pipeline/vertex/transform-inl.h"
#include "pipeline/vertex/vertex_batch.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::vertex::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The fog coordinate, |z| in eye coordinates.
HWY_INLINE void fog_coordinate(const float* eye_z, size_t count, float* fog) {
  const hn::ScalableTag<float> d;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    hn::Store(hn::Abs(hn::Load(d, eye_z + i)), d, fog + i);
  }
}

// derived = clamp(size / sqrt(a + b d + c d^2)), d the eye distance; fade = (derived /
// threshold)^2 where derived is below the threshold, else 1 (equation 3.2). Whether a faded point
// is also widened to the threshold is the rasterizer's question: only multisampling does it.
HWY_INLINE void derive_point_size(const VertexState& state, const float* requested, const Lane* eye,
                                  size_t count, float* derived, float* fade) {
  const hn::ScalableTag<float> d;
  const auto one = hn::Set(d, 1.0f);
  const auto smallest = hn::Set(d, state.point_size_min);
  const auto largest = hn::Set(d, state.point_size_max);
  const auto threshold = hn::Set(d, state.point_fade_threshold);
  const auto a = hn::Set(d, state.point_attenuation[0]);
  const auto b = hn::Set(d, state.point_attenuation[1]);
  const auto c = hn::Set(d, state.point_attenuation[2]);
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    auto size = hn::Load(d, requested + i);
    if (state.point_attenuated) {
      const auto x = hn::Load(d, eye[0] + i);
      const auto y = hn::Load(d, eye[1] + i);
      const auto z = hn::Load(d, eye[2] + i);
      const auto square = dot3(x, y, z, x, y, z);
      const auto distance = hn::Sqrt(square);
      const auto factor = hn::Add(hn::Add(a, hn::Mul(b, distance)), hn::Mul(c, square));
      size = hn::Div(size, hn::Sqrt(factor));
    }
    size = at_most(at_least(size, smallest), largest);
    const auto ratio = hn::Div(size, threshold);
    const auto faded = hn::IfThenElse(hn::Lt(size, threshold), hn::Mul(ratio, ratio), one);
    hn::Store(size, d, derived + i);
    hn::Store(faded, d, fade + i);
  }
}

}  // namespace clearpipe::pipeline::vertex::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CLEARPIPE_VERTEX_POINT_INL_H_
