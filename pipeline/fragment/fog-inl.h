// Fog (3.8): the factor of each fragment from its interpolated fog coordinate, and the mix with the
// fog colour.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_FOG_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_FOG_INL_H_
#undef CLEARPIPE_FRAGMENT_FOG_INL_H_
#else
#define CLEARPIPE_FRAGMENT_FOG_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "pipeline/fragment/chain.h"
#include "pipeline/fragment/colour-inl.h"
#include "pipeline/fragment/interpolate-inl.h"
#include "pipeline/vertex/math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct FogConstants {
  FogMode mode = FogMode::kNone;
  float scale = 0, offset = 0;  // linear: f = c * scale + offset; exp, exp2: the power's factor
  int16_t colour[3] = {};
};

// Equations 3.24 to 3.26; the powers of e are powers of two with log2(e) in the factor.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V fog_factor(D d, const FogConstants& fog, V c) {
  const V scale = hn::Set(d, fog.scale);
  if (fog.mode == FogMode::kLinear) {
    return hn::Add(hn::Mul(c, scale), hn::Set(d, fog.offset));
  }
  const V power = hn::Mul(c, scale);
  const V limit = hn::Set(d, 64.0f);  // 2^-64 is 0 in any colour
  const V exponent = fog.mode == FogMode::kExp ? hn::Abs(power) : hn::Mul(power, power);
  return vertex::HWY_NAMESPACE::exp2(
      d, hn::Neg(hn::IfThenElse(hn::Lt(exponent, limit), exponent, limit)));
}

inline FogConstants fog_constants(const FragmentProgram& program) {
  FogConstants fog{program.fog_mode, program.fog_scale, program.fog_offset, {}};
  std::copy_n(program.fog_colour, 3, fog.colour);
  return fog;
}

// Equation 3.23: C = f C_r + (1 - f) C_f.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V mix_fog(D d, V factor, int16_t fog_colour, V colour) {
  const V fog = hn::Set(d, fog_colour);
  return hn::Add(fog, multiply(factor, hn::Sub(colour, fog)));
}

inline void apply_fog(const PrimitivePlanes& planes, const FogConstants& fog,
                      FragmentBatch& batch) {
  const hn::ScalableTag<float> d;
  const hn::Rebind<int16_t, decltype(d)> d16;
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    auto coordinate = evaluate(d, planes.fog, hn::Load(d, batch.x + i), hn::Load(d, batch.y + i));
    if (planes.perspective) {
      coordinate = hn::Mul(coordinate, hn::Load(d, batch.w + i));
    }
    const auto f = to_colour(d16, d, fog_factor(d, fog, coordinate));
    for (int c = 0; c < 3; ++c) {
      const auto colour = hn::Load(d16, batch.previous[c] + i);
      hn::Store(mix_fog(d16, f, fog.colour[c], colour), d16, batch.previous[c] + i);
    }
  }
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
