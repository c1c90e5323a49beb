// One texture coordinate to texel indices and a weight, on one SIMD target: the wrap modes of 3.7.6
// and the equations for i and alpha of 3.7.8, each axis by itself.
//
// Every index lies inside the level for any float whatever: values are limited as floats before
// they become integers, because a conversion out of range differs between processors. Ordinary
// coordinates are untouched by the limits.
// SPDX-License-Identifier: MIT
#include "pipeline/simd.h"

#include <cstdint>

#include "pipeline/fragment/sample.h"

#if defined(CLEARPIPE_PIPELINE_FRAGMENT_SAMPLE_AXIS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_PIPELINE_FRAGMENT_SAMPLE_AXIS_INL_H
#undef CLEARPIPE_PIPELINE_FRAGMENT_SAMPLE_AXIS_INL_H
#else
#define CLEARPIPE_PIPELINE_FRAGMENT_SAMPLE_AXIS_INL_H
#endif

#include "hwy/highway.h"
#include "pipeline/nearest_int-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::sampling {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using TagFloat = hn::ScalableTag<float>;
using TagInt = hn::RebindToSigned<TagFloat>;
using VecFloat = hn::Vec<TagFloat>;
using VecInt = hn::Vec<TagInt>;

// The two texels of an axis and the weight of the second.
struct LinearAxis {
  VecInt first, second, weight;
};

HWY_INLINE VecFloat number_or_zero(VecFloat v) { return hn::IfThenElseZero(hn::Eq(v, v), v); }

// v where |v| < limit, else zero: also for infinities and NaN.
HWY_INLINE VecFloat small_or_zero(VecFloat v, float limit) {
  return hn::IfThenElseZero(hn::Lt(hn::Abs(v), hn::Set(TagFloat(), limit)), v);
}

// From 2^23 on a float has no fraction left to wrap.
inline constexpr float kNoFraction = 8388608.0f;
// Scaled coordinates below this fit an int32_t with room for the half texel.
inline constexpr float kIntegerLimit = 2147482624.0f;

// To nearest, ties to even, for |v| < 2^31. The emulated target adds one half first, which is wrong
// just below one half, so there the float addition itself does the rounding.
HWY_INLINE VecFloat round_even(VecFloat v) {
#if HWY_TARGET == HWY_EMU128 || HWY_TARGET == HWY_SCALAR
  const TagFloat df;
  const VecFloat shift = hn::CopySign(hn::Set(df, kNoFraction), v);
  const VecFloat rounded = hn::Sub(hn::Add(v, shift), shift);
  return hn::IfThenElse(hn::Lt(hn::Abs(v), hn::Set(df, kNoFraction)), rounded, v);
#else
  return hn::Round(v);
#endif
}

HWY_INLINE VecInt round_to_int(VecFloat v) {
#if HWY_TARGET == HWY_EMU128 || HWY_TARGET == HWY_SCALAR
  return hn::ConvertTo(TagInt(), round_even(v));
#else
  return pipeline::HWY_NAMESPACE::nearest_int(TagFloat(), v);
#endif
}

// A fraction in [0, 1] as a weight: 15 bits rounded, or 8 bits truncated.
template <bool kFine>
HWY_INLINE VecInt fraction_weight(VecFloat fraction) {
  const TagFloat df;
  const TagInt di;
  if constexpr (kFine) {
    const VecInt w = round_to_int(hn::Mul(fraction, hn::Set(df, 32768.0f)));
    return hn::Min(w, hn::Set(di, 32767));
  } else {
    const VecInt w = hn::ConvertTo(di, hn::Mul(fraction, hn::Set(df, 256.0f)));
    return hn::Min(w, hn::Set(di, 255));
  }
}

HWY_INLINE VecFloat fraction(VecFloat s) {
  const VecFloat v = small_or_zero(s, kNoFraction);
  return hn::Sub(v, hn::Floor(v));
}

// MIRRORED_REPEAT as |2 (s/2 - round(s/2))|, in [0, 1].
HWY_INLINE VecFloat mirror(VecFloat s) {
  const VecFloat v = hn::Mul(small_or_zero(s, kNoFraction), hn::Set(TagFloat(), 0.5f));
  const VecFloat half = hn::Sub(v, round_even(v));
  return hn::Abs(hn::Add(half, half));
}

// NEAREST: i = floor(u), wrapped.
template <WrapKind kWrap>
HWY_INLINE VecInt nearest_axis(VecFloat s, int size) {
  const TagFloat df;
  const TagInt di;
  const VecFloat scale = hn::Set(df, static_cast<float>(size));
  const VecInt last = hn::Set(di, size - 1);
  if constexpr (kWrap == WrapKind::kRepeatPowerOfTwo) {
    const VecFloat u = small_or_zero(hn::Mul(s, scale), kIntegerLimit);
    return hn::And(hn::ConvertTo(di, hn::Floor(u)), last);
  } else if constexpr (kWrap == WrapKind::kRepeatOther) {
    const VecFloat below_one = hn::Min(fraction(s), hn::Set(df, 0x1.fffffep-1f));
    return hn::Min(hn::ConvertTo(di, hn::Mul(below_one, scale)), last);
  } else if constexpr (kWrap == WrapKind::kClampToEdge) {
    const VecFloat u = number_or_zero(hn::Mul(s, scale));
    const VecFloat inside = hn::Min(hn::Max(u, hn::Zero(df)), scale);
    return hn::Min(hn::ConvertTo(di, inside), last);
  } else {
    return hn::Min(hn::ConvertTo(di, hn::Mul(mirror(s), scale)), last);
  }
}

// LINEAR with 8-bit weights: u in 24.8 fixed point, rounded, less one half.
template <WrapKind kWrap>
HWY_INLINE VecInt linear_fixed(VecFloat s, int size) {
  const TagFloat df;
  const VecFloat scale = hn::Set(df, static_cast<float>(size) * 256.0f);
  const VecInt half = hn::Set(TagInt(), 128);
  if constexpr (kWrap == WrapKind::kRepeatPowerOfTwo) {
    return hn::Sub(round_to_int(small_or_zero(hn::Mul(s, scale), kIntegerLimit)), half);
  } else if constexpr (kWrap == WrapKind::kRepeatOther) {
    return hn::Sub(round_to_int(hn::Mul(fraction(s), scale)), half);
  } else {
    static_assert(kWrap == WrapKind::kClampToEdge);
    const VecFloat u = number_or_zero(hn::Mul(s, scale));
    return hn::Sub(round_to_int(hn::Min(hn::Max(u, hn::Zero(df)), scale)), half);
  }
}

// The axis at such a number: its floor, wrapped, and its fraction.
template <WrapKind kWrap>
HWY_INLINE LinearAxis linear_texels(VecInt fixed, int size) {
  const TagInt di;
  const VecInt last = hn::Set(di, size - 1), one = hn::Set(di, 1), zero = hn::Zero(di);
  const VecInt whole = hn::ShiftRight<8>(fixed);  // but for powers of two in [-1, last]
  const VecInt weight = hn::And(fixed, hn::Set(di, 255));
  if constexpr (kWrap == WrapKind::kRepeatPowerOfTwo) {
    const VecInt first = hn::And(whole, last);
    return {first, hn::And(hn::Add(first, one), last), weight};
  } else if constexpr (kWrap == WrapKind::kRepeatOther) {
    const VecInt first = hn::Min(hn::IfThenElse(hn::Lt(whole, zero), last, whole), last);
    return {first, hn::IfThenZeroElse(hn::Eq(first, last), hn::Add(first, one)), weight};
  } else {
    return {hn::Max(whole, zero), hn::Min(hn::Add(whole, one), last), weight};
  }
}

template <WrapKind kWrap>
HWY_INLINE LinearAxis linear_axis(VecFloat s, int size) {
  return linear_texels<kWrap>(linear_fixed<kWrap>(s, size), size);
}

// LINEAR with 15-bit weights, for samplers of which an axis mirrors.
template <WrapKind kWrap>
HWY_INLINE LinearAxis fine_linear_axis(VecFloat s, int size) {
  const TagFloat df;
  const TagInt di;
  const VecFloat scale = hn::Set(df, static_cast<float>(size));
  const VecFloat half = hn::Set(df, 0.5f);
  const VecInt last = hn::Set(di, size - 1);
  const VecInt one = hn::Set(di, 1);
  VecFloat u;
  if constexpr (kWrap == WrapKind::kRepeatPowerOfTwo) {
    u = hn::Sub(small_or_zero(hn::Mul(s, scale), kIntegerLimit), half);
  } else if constexpr (kWrap == WrapKind::kRepeatOther) {
    u = hn::Sub(hn::Mul(fraction(s), scale), half);
  } else if constexpr (kWrap == WrapKind::kClampToEdge) {
    u = hn::Min(number_or_zero(hn::Mul(s, scale)), scale);
    u = hn::Max(hn::Sub(u, half), hn::Zero(df));
  } else {
    u = hn::Sub(hn::Mul(mirror(s), scale), half);
  }
  const VecFloat floor = hn::Floor(u);
  const VecInt whole = hn::ConvertTo(di, floor);
  const VecInt weight = fraction_weight<true>(hn::Sub(u, floor));
  if constexpr (kWrap == WrapKind::kRepeatPowerOfTwo) {
    const VecInt first = hn::And(whole, last);
    return {first, hn::And(hn::Add(first, one), last), weight};
  } else if constexpr (kWrap == WrapKind::kRepeatOther) {
    const VecInt first = hn::Min(hn::IfThenElse(hn::Lt(whole, hn::Zero(di)), last, whole), last);
    return {first, hn::IfThenZeroElse(hn::Eq(first, last), hn::Add(first, one)), weight};
  } else {
    return {hn::Min(hn::Max(whole, hn::Zero(di)), last), hn::Min(hn::Add(whole, one), last),
            weight};
  }
}

// Both axes of a sampler whose wrap modes are known when it is compiled.
template <WrapKind kS, WrapKind kT>
struct FixedAxes {
  static constexpr bool kSrgb = false;
  explicit FixedAxes(const SampleState&) {}
  HWY_INLINE VecInt nearest_s(VecFloat s, int size) const { return nearest_axis<kS>(s, size); }
  HWY_INLINE VecInt nearest_t(VecFloat t, int size) const { return nearest_axis<kT>(t, size); }
  HWY_INLINE LinearAxis linear_s(VecFloat s, int size) const { return linear_axis<kS>(s, size); }
  HWY_INLINE LinearAxis linear_t(VecFloat t, int size) const { return linear_axis<kT>(t, size); }
};

// Both axes of a sampler with a mirrored axis; the wrap modes are looked at while it runs.
struct MirroredAxes {
  static constexpr bool kSrgb = false;
  explicit MirroredAxes(const SampleState& state)
      : wrap_s(wrap_kind(state.sampler.wrap_s, state.levels[state.first_level].width)),
        wrap_t(wrap_kind(state.sampler.wrap_t, state.levels[state.first_level].height)) {}
  HWY_INLINE VecInt nearest_s(VecFloat s, int size) const { return nearest(wrap_s, s, size); }
  HWY_INLINE VecInt nearest_t(VecFloat t, int size) const { return nearest(wrap_t, t, size); }
  HWY_INLINE LinearAxis linear_s(VecFloat s, int size) const { return linear(wrap_s, s, size); }
  HWY_INLINE LinearAxis linear_t(VecFloat t, int size) const { return linear(wrap_t, t, size); }

  static HWY_INLINE VecInt nearest(WrapKind wrap, VecFloat s, int size) {
    switch (wrap) {
      case WrapKind::kRepeatPowerOfTwo:
        return nearest_axis<WrapKind::kRepeatPowerOfTwo>(s, size);
      case WrapKind::kRepeatOther:
        return nearest_axis<WrapKind::kRepeatOther>(s, size);
      case WrapKind::kClampToEdge:
        return nearest_axis<WrapKind::kClampToEdge>(s, size);
      default:
        return nearest_axis<WrapKind::kMirroredRepeat>(s, size);
    }
  }
  static HWY_INLINE LinearAxis linear(WrapKind wrap, VecFloat s, int size) {
    switch (wrap) {
      case WrapKind::kRepeatPowerOfTwo:
        return fine_linear_axis<WrapKind::kRepeatPowerOfTwo>(s, size);
      case WrapKind::kRepeatOther:
        return fine_linear_axis<WrapKind::kRepeatOther>(s, size);
      case WrapKind::kClampToEdge:
        return fine_linear_axis<WrapKind::kClampToEdge>(s, size);
      default:
        return fine_linear_axis<WrapKind::kMirroredRepeat>(s, size);
    }
  }

  WrapKind wrap_s, wrap_t;
};

// Both axes of any sampler of an image whose colours are sRGB-encoded.
struct SrgbAxes : MirroredAxes {
  static constexpr bool kSrgb = true;
  explicit SrgbAxes(const SampleState& state) : MirroredAxes(state), decode(state.decode) {}
  const int32_t* decode;
};

}  // namespace HWY_NAMESPACE
}  // namespace clearpipe::pipeline::sampling
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
