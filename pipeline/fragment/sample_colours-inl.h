// Colours of a vector of fragments and their interpolation, on one SIMD target.
//
// A fragment's four channels travel as two 32-bit lanes of 16-bit pairs, (red, blue) and (green,
// alpha), so an RGBA8 texel unpacks with a mask and a shift. Channels are 8-bit values, or have 13
// fraction bits (kColourOne is 1.0). The one-lane target has no pairs; there each channel is a
// lane. SPDX-License-Identifier: MIT
#include "pipeline/simd.h"

#include <cstddef>
#include <cstdint>

#include "pipeline/fragment/sample.h"

#if defined(CLEARPIPE_PIPELINE_FRAGMENT_SAMPLE_COLOURS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_PIPELINE_FRAGMENT_SAMPLE_COLOURS_INL_H
#undef CLEARPIPE_PIPELINE_FRAGMENT_SAMPLE_COLOURS_INL_H
#else
#define CLEARPIPE_PIPELINE_FRAGMENT_SAMPLE_COLOURS_INL_H
#endif

#include "hwy/highway.h"
#include "pipeline/fragment/colour-inl.h"
#include "pipeline/fragment/sample_axis-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::sampling {
namespace HWY_NAMESPACE {

using TagHalf = hn::Rebind<int16_t, TagInt>;

#if HWY_TARGET == HWY_SCALAR

struct Colours {
  VecInt channel[4];
};
using Weight = VecInt;

HWY_INLINE Weight spread(VecInt weight) { return weight; }

HWY_INLINE Colours no_colours() {
  const VecInt zero = hn::Zero(TagInt());
  return {{zero, zero, zero, zero}};
}

HWY_INLINE Colours unpack(VecInt texels) {
  const VecInt mask = hn::Set(TagInt(), 0xff);
  return {{hn::And(texels, mask), hn::And(hn::ShiftRight<8>(texels), mask),
           hn::And(hn::ShiftRight<16>(texels), mask), hn::And(hn::ShiftRight<24>(texels), mask)}};
}

HWY_INLINE Colours widen(Colours c) {
  for (VecInt& v : c.channel) {
    v = fragment::HWY_NAMESPACE::from_unorm8(TagInt(), v);
  }
  return c;
}

// The linear colours of sRGB-encoded texels (srgb.h), and their alpha.
HWY_INLINE Colours decode(const int32_t* table, VecInt texels) {
  Colours c = unpack(texels);
  for (int i = 0; i < 3; ++i) c.channel[i] = hn::GatherIndex(TagInt(), table, c.channel[i]);
  c.channel[3] = fragment::HWY_NAMESPACE::from_unorm8(TagInt(), c.channel[3]);
  return c;
}

template <bool kFine>
HWY_INLINE Colours lerp(Weight weight, const Colours& a, const Colours& b) {
  constexpr int kBits = kFine ? 15 : 8;
  const VecInt half = hn::Set(TagInt(), 1 << (kBits - 1));
  Colours result = a;
  for (int i = 0; i < 4; ++i) {
    const VecInt product = hn::Mul(weight, hn::Sub(b.channel[i], a.channel[i]));
    result.channel[i] = hn::Add(a.channel[i], hn::ShiftRight<kBits>(hn::Add(product, half)));
  }
  return result;
}

HWY_INLINE Colours select(hn::Mask<TagInt> mask, const Colours& yes, const Colours& no) {
  Colours result = no;
  for (int i = 0; i < 4; ++i) {
    result.channel[i] = hn::IfThenElse(mask, yes.channel[i], no.channel[i]);
  }
  return result;
}

HWY_INLINE void store_colours(const Colours& c, int16_t (*out)[kBatchSize], size_t i) {
  const TagHalf dh;
  for (int k = 0; k < 4; ++k) hn::StoreU(hn::DemoteTo(dh, c.channel[k]), dh, out[k] + i);
}

#else

using TagPairs = hn::Repartition<int16_t, TagInt>;
using VecPairs = hn::Vec<TagPairs>;

struct Colours {
  VecPairs rb, ga;
};
using Weight = VecPairs;

// The same 16-bit weight in both halves of a fragment's 32 bits.
HWY_INLINE Weight spread(VecInt weight) {
  return hn::BitCast(TagPairs(), hn::Or(weight, hn::ShiftLeft<16>(weight)));
}

HWY_INLINE Colours no_colours() { return {hn::Zero(TagPairs()), hn::Zero(TagPairs())}; }

HWY_INLINE Colours unpack(VecInt texels) {
  const TagPairs dp;
  const VecInt mask = hn::Set(TagInt(), 0x00ff00ff);
  return {hn::BitCast(dp, hn::And(texels, mask)),
          hn::BitCast(dp, hn::And(hn::ShiftRight<8>(texels), mask))};
}

// 8 bits to 13 fraction bits, exact at both ends.
HWY_INLINE VecPairs widen(VecPairs v) {
  return fragment::HWY_NAMESPACE::from_unorm8(TagPairs(), v);
}
HWY_INLINE Colours widen(const Colours& c) { return {widen(c.rb), widen(c.ga)}; }

// The linear colours of sRGB-encoded texels (srgb.h), and their alpha.
HWY_INLINE Colours decode(const int32_t* table, VecInt texels) {
  const TagInt di;
  const TagPairs dp;
  const VecInt byte = hn::Set(di, 0xff);
  const auto linear = [&](VecInt encoded) HWY_ATTR { return hn::GatherIndex(di, table, encoded); };
  const VecInt r = linear(hn::And(texels, byte));
  const VecInt g = linear(hn::And(hn::ShiftRight<8>(texels), byte));
  const VecInt b = linear(hn::And(hn::ShiftRight<16>(texels), byte));
  const VecInt a =
      fragment::HWY_NAMESPACE::from_unorm8(di, hn::And(hn::ShiftRight<24>(texels), byte));
  return {hn::BitCast(dp, hn::Or(r, hn::ShiftLeft<16>(b))),
          hn::BitCast(dp, hn::Or(g, hn::ShiftLeft<16>(a)))};
}

// a + weight * (b - a), rounded to nearest. The difference of 8-bit values is moved up by 7 bits,
// so that an 8-bit weight meets it in the 15-bit product.
template <bool kFine>
HWY_INLINE VecPairs lerp(Weight weight, VecPairs a, VecPairs b) {
  VecPairs delta = hn::Sub(b, a);
  if constexpr (!kFine) delta = hn::ShiftLeft<7>(delta);
  return hn::Add(a, hn::MulFixedPoint15(weight, delta));
}
template <bool kFine>
HWY_INLINE Colours lerp(Weight weight, const Colours& a, const Colours& b) {
  return {lerp<kFine>(weight, a.rb, b.rb), lerp<kFine>(weight, a.ga, b.ga)};
}

HWY_INLINE Colours select(hn::Mask<TagInt> mask, const Colours& yes, const Colours& no) {
  const TagInt di;
  const TagPairs dp;
  return {hn::BitCast(dp, hn::IfThenElse(mask, hn::BitCast(di, yes.rb), hn::BitCast(di, no.rb))),
          hn::BitCast(dp, hn::IfThenElse(mask, hn::BitCast(di, yes.ga), hn::BitCast(di, no.ga)))};
}

HWY_INLINE void store_colours(const Colours& c, int16_t (*out)[kBatchSize], size_t i) {
  const TagInt di;
  const TagHalf dh;
  const VecInt rb = hn::BitCast(di, c.rb);
  const VecInt ga = hn::BitCast(di, c.ga);
  const VecInt low = hn::Set(di, 0xffff);
  hn::StoreU(hn::DemoteTo(dh, hn::And(rb, low)), dh, out[0] + i);
  hn::StoreU(hn::DemoteTo(dh, hn::And(ga, low)), dh, out[1] + i);
  hn::StoreU(hn::DemoteTo(dh, hn::ShiftRight<16>(rb)), dh, out[2] + i);
  hn::StoreU(hn::DemoteTo(dh, hn::ShiftRight<16>(ga)), dh, out[3] + i);
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace clearpipe::pipeline::sampling
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
