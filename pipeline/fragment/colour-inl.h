// Colour arithmetic of the fragment stages: signed 16-bit lanes with 13 fraction bits, and the
// exact conversion from and to 8 bits.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_COLOUR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_COLOUR_INL_H_
#undef CLEARPIPE_FRAGMENT_COLOUR_INL_H_
#else
#define CLEARPIPE_FRAGMENT_COLOUR_INL_H_
#endif

#include <hwy/highway.h>

#include "pipeline/fragment/batch.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// colour_from_unorm8 (batch.h) of a vector: 8192 * v / 255, rounded to nearest. 32 v / 255 differs
// so little from v / 8 that 32.125 v rounds alike; in 16 bits it is a product of 128 v.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V from_unorm8(D d, V v) {
  if constexpr (sizeof(hn::TFromD<D>) == 2) {
    return hn::MulFixedPoint15(hn::ShiftLeft<7>(v), hn::Set(d, 8224));
  } else {
    return hn::Add(hn::ShiftLeft<5>(v), hn::ShiftRight<3>(hn::Add(v, hn::Set(d, 4))));
  }
}

// The nearest 8-bit value of a colour in [0, 1]; gives back what from_unorm8 was given. 1020 is
// 32768 * 255 / 8192; values that are halfway go up, and so do those less than a step below.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V to_unorm8(D d, V c) {
  return hn::MulFixedPoint15(hn::Add(c, hn::Set(d, 1)), hn::Set(d, 1020));
}

// a * b for factors in (-2, 2), rounded to nearest; 1 * b is exactly b.
template <class V>
HWY_INLINE V multiply(V a, V b) {
  return hn::MulFixedPoint15(hn::ShiftLeft<1>(a), hn::ShiftLeft<1>(b));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE V clamp_colour(D d, V c) {
  return hn::Min(hn::Max(c, hn::Zero(d)), hn::Set(d, kColourOne));
}

// The nearest integer, ties to even, of a float in [0, kColourOne]. Adding 1.5 * 2^23 leaves it in
// the low mantissa bits.
template <class DF, class VF = hn::Vec<DF>>
HWY_INLINE hn::Vec<hn::RebindToSigned<DF>> round_inside(DF df, VF inside) {
  const hn::RebindToSigned<DF> di;
  const VF magic = hn::Set(df, 12582912.0f);
  return hn::Sub(hn::BitCast(di, hn::Add(inside, magic)), hn::BitCast(di, magic));
}

// The same of any float, clamped; NaN becomes 0, as Max takes its second parameter then.
template <class DF, class VF = hn::Vec<DF>>
HWY_INLINE hn::Vec<hn::RebindToSigned<DF>> round_colour(DF df, VF scaled) {
  return round_inside(df, hn::Min(hn::Max(scaled, hn::Zero(df)), hn::Set(df, float{kColourOne})));
}

// A float in [0, 1] (anything else is clamped, NaN to 0) as a colour in 32 bits.
template <class DF, class VF = hn::Vec<DF>>
HWY_INLINE hn::Vec<hn::RebindToSigned<DF>> to_wide_colour(DF df, VF f) {
  return round_colour(df, hn::Mul(f, hn::Set(df, float{kColourOne})));
}

// The same in 16 bits, for the 16-bit tag of as many lanes as the float tag.
template <class D16, class DF, class VF = hn::Vec<DF>>
HWY_INLINE hn::Vec<D16> to_colour(D16 d16, DF df, VF f) {
  return hn::DemoteTo(d16, to_wide_colour(df, f));
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
