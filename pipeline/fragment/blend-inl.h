// Blending (4.1.7) on 8-bit values in 16-bit lanes: exact products a * b / 255, rounded, and
// saturating sums, as the reference blends an RGBA8 surface.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_BLEND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_BLEND_INL_H_
#undef CLEARPIPE_FRAGMENT_BLEND_INL_H_
#else
#define CLEARPIPE_FRAGMENT_BLEND_INL_H_
#endif

#include <hwy/highway.h>

#include "pipeline/state.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The nearest integer to a * b / 255, as (a b + 128) * 257 / 65536.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V multiply_unorm8(D d, V a, V b) {
  return hn::MulHigh(hn::Add(hn::Mul(a, b), hn::Set(d, 128)), hn::Set(d, 257));
}

// The colour of source and destination at one channel, with both alphas at hand.
template <class V>
struct BlendOperands {
  V source, destination, source_alpha, destination_alpha;
};

// Table 4.5.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V blend_factor(D d, BlendFactor factor, bool alpha, const BlendOperands<V>& in) {
  const V one = hn::Set(d, 255);
  switch (factor) {
    case BlendFactor::kZero:
      return hn::Zero(d);
    case BlendFactor::kOne:
      return one;
    case BlendFactor::kSrcColour:
      return in.source;
    case BlendFactor::kOneMinusSrcColour:
      return hn::Sub(one, in.source);
    case BlendFactor::kDstColour:
      return in.destination;
    case BlendFactor::kOneMinusDstColour:
      return hn::Sub(one, in.destination);
    case BlendFactor::kSrcAlpha:
      return in.source_alpha;
    case BlendFactor::kOneMinusSrcAlpha:
      return hn::Sub(one, in.source_alpha);
    case BlendFactor::kDstAlpha:
      return in.destination_alpha;
    case BlendFactor::kOneMinusDstAlpha:
      return hn::Sub(one, in.destination_alpha);
    case BlendFactor::kSrcAlphaSaturate:
      return alpha ? one : hn::Min(in.source_alpha, hn::Sub(one, in.destination_alpha));
  }
  return one;
}

// A colour times its factor; ONE and ZERO, which are common, need no product.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V weigh(D d, V colour, BlendFactor factor, bool alpha, const BlendOperands<V>& in) {
  if (factor == BlendFactor::kOne) return colour;
  if (factor == BlendFactor::kZero) return hn::Zero(d);
  return multiply_unorm8(d, colour, blend_factor(d, factor, alpha, in));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE V blend(D d, BlendEquation equation, BlendFactor source_factor,
                   BlendFactor destination_factor, bool alpha, const BlendOperands<V>& in) {
  if (equation == BlendEquation::kMin) return hn::Min(in.source, in.destination);
  if (equation == BlendEquation::kMax) return hn::Max(in.source, in.destination);
  const V source = weigh(d, in.source, source_factor, alpha, in);
  const V destination = weigh(d, in.destination, destination_factor, alpha, in);
  switch (equation) {
    case BlendEquation::kSubtract:
      return hn::SaturatedSub(source, destination);
    case BlendEquation::kReverseSubtract:
      return hn::SaturatedSub(destination, source);
    default:
      return hn::Min(hn::Add(source, destination), hn::Set(d, 255));
  }
}

// The blending of a colour channel or of alpha; the state is a BlendState or has its members.
template <class D, class State, class V = hn::Vec<D>>
HWY_INLINE V blend_channel(D d, const State& state, bool alpha, const BlendOperands<V>& in) {
  return blend(d, alpha ? state.alpha : state.rgb, alpha ? state.src_alpha : state.src_rgb,
               alpha ? state.dst_alpha : state.dst_rgb, alpha, in);
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
