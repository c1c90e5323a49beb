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

template <bool kFine>
HWY_INLINE Weight spread(VecInt weight) {
  return kFine ? weight : hn::ShiftLeft<7>(weight);
}

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

HWY_INLINE Colours lerp(Weight weight, const Colours& a, const Colours& b) {
  constexpr int kBits = 15;
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

// The same weight of 15 bits in both halves of a fragment's 32 bits: of kFine the low half of them,
// else the lowest byte, moved up; what lies above does not matter.
template <bool kFine>
HWY_INLINE Weight spread(VecInt weight) {
  const hn::Repartition<uint8_t, TagInt> d8;
  const auto take = [&](const uint8_t(&bytes)[16]) HWY_ATTR {
    return hn::TableLookupBytesOr0(hn::BitCast(d8, weight), hn::LoadDup128(d8, bytes));
  };
  constexpr uint8_t kNone = 0x80;
  alignas(16) static constexpr uint8_t kLowHalf[16] = {0, 1, 0, 1, 4,  5,  4,  5,
                                                       8, 9, 8, 9, 12, 13, 12, 13};
  alignas(16) static constexpr uint8_t kLowByte[16] = {kNone, 0, kNone, 0, kNone, 4,  kNone, 4,
                                                       kNone, 8, kNone, 8, kNone, 12, kNone, 12};
  if constexpr (kFine) return hn::BitCast(TagPairs(), take(kLowHalf));
  const hn::RebindToUnsigned<TagPairs> unsigned_pairs;
  return hn::BitCast(TagPairs(), hn::ShiftRight<1>(hn::BitCast(unsigned_pairs, take(kLowByte))));
}

HWY_INLINE Colours no_colours() { return {hn::Zero(TagPairs()), hn::Zero(TagPairs())}; }

HWY_INLINE Colours unpack(VecInt texels) {
  const TagPairs dp;
  const VecInt mask = hn::Set(TagInt(), 0x00ff00ff);
  const hn::RebindToUnsigned<TagPairs> unsigned_pairs;
  return {hn::BitCast(dp, hn::And(texels, mask)),
          hn::BitCast(dp, hn::ShiftRight<8>(hn::BitCast(unsigned_pairs, texels)))};
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

// The inverse of unpack.
HWY_INLINE VecInt pack(const Colours& c) {
  const TagInt di;
  return hn::Or(hn::BitCast(di, c.rb), hn::ShiftLeft<8>(hn::BitCast(di, c.ga)));
}

// a + weight * (b - a), rounded to nearest.
HWY_INLINE VecPairs lerp(Weight weight, VecPairs a, VecPairs b) {
  return hn::Add(a, hn::MulFixedPoint15(weight, hn::Sub(b, a)));
}
HWY_INLINE Colours lerp(Weight weight, const Colours& a, const Colours& b) {
  return {lerp(weight, a.rb, b.rb), lerp(weight, a.ga, b.ga)};
}

// Packed texels by weights of 8 bits.
template <class V>
HWY_INLINE V lerp_pixels(VecInt weight, V a, V b) {
  const TagInt di;
  const hn::DFromV<V> d;
  return hn::BitCast(
      d, pack(lerp(spread<false>(weight), unpack(hn::BitCast(di, a)), unpack(hn::BitCast(di, b)))));
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
