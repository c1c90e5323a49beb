// Groups of pixels, the vectors of the fused loop (fused-inl.h).
//
// A group is two float vectors of neighbouring pixels, `lower` and `upper`, and the 16-bit vectors
// that belong to them. Those keep the order in which narrowing leaves the lanes: within each block
// of 128 bits first the lower vector's four, then the upper's.
//
//   lower  l0 l1 l2 l3 | l4 l5 l6 l7      upper  u0 u1 u2 u3 | u4 u5 u6 u7
//   narrowed  l0 l1 l2 l3 u0 u1 u2 u3 | l4 l5 l6 l7 u4 u5 u6 u7
//
// Interleaving the lower or upper halves of blocks, as packing does, undoes it.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_GROUP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_GROUP_INL_H_
#undef CLEARPIPE_FRAGMENT_GROUP_INL_H_
#else
#define CLEARPIPE_FRAGMENT_GROUP_INL_H_
#endif

#include <hwy/highway.h>

#include "pipeline/fragment/colour-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

using TagF = hn::ScalableTag<float>;
using TagI = hn::RebindToSigned<TagF>;
using TagU = hn::RebindToUnsigned<TagF>;
using Tag16 = hn::Repartition<int16_t, TagF>;
using TagU16 = hn::RebindToUnsigned<Tag16>;
using TagBytes = hn::Repartition<uint8_t, TagF>;
using VecF = hn::Vec<TagF>;
using VecI = hn::Vec<TagI>;
using VecU = hn::Vec<TagU>;
using Vec16 = hn::Vec<Tag16>;
using MaskI = hn::Mask<TagI>;

// Both halves of a group.
template <class V>
struct Pair {
  V lower, upper;
};

HWY_INLINE Vec16 narrow(const Pair<VecI>& v) {
  return hn::ReorderDemote2To(Tag16(), v.lower, v.upper);
}

HWY_INLINE Vec16 narrow_colour(const Pair<VecF>& f) {
  const TagF d;
  return narrow({to_wide_colour(d, f.lower), to_wide_colour(d, f.upper)});
}

// What narrow() made, in the order of the pixels.
HWY_INLINE Vec16 in_order(Vec16 v) {
  const Tag16 d;
  if constexpr (hn::MaxLanes(Tag16()) == 8) return v;
  const hn::Repartition<uint64_t, Tag16> d64;
  const auto halves = hn::BitCast(d64, v);
  return hn::ConcatLowerLower(d, hn::BitCast(d, hn::ConcatOdd(d64, halves, halves)),
                              hn::BitCast(d, hn::ConcatEven(d64, halves, halves)));
}

// A 16-bit mask vector (all bits or none) as masks of both halves.
HWY_INLINE Pair<MaskI> widen_mask(Vec16 mask) {
  const TagI d;
  return {hn::MaskFromVec(hn::BitCast(d, hn::InterleaveLower(Tag16(), mask, mask))),
          hn::MaskFromVec(hn::BitCast(d, hn::InterleaveUpper(Tag16(), mask, mask)))};
}

struct Colour16 {
  Vec16 channel[4];
};

// 8-bit channels of packed pixels as a group's. Of each block, first the bytes of a channel come
// together, then those of both halves:
//   r0 r1 r2 r3 g0 .. b0 .. a0 ..   ->   r0 r1 r2 r3 R0 R1 R2 R3 g0 ..   and   b0 ..
HWY_INLINE void unpack_pixels(const Pair<VecU>& pixels, Vec16 out[4]) {
  const TagBytes d8;
  const Tag16 d16;
  const TagU d;
  alignas(16) static constexpr uint8_t kByChannel[16] = {0, 4, 8,  12, 1, 5, 9,  13,
                                                         2, 6, 10, 14, 3, 7, 11, 15};
  const auto table = hn::LoadDup128(d8, kByChannel);
  const auto by_channel = [&](VecU half) HWY_ATTR {
    return hn::BitCast(d, hn::TableLookupBytes(hn::BitCast(d8, half), table));
  };
  const VecU lower = by_channel(pixels.lower), upper = by_channel(pixels.upper);
  const auto rg = hn::BitCast(d8, hn::InterleaveLower(d, lower, upper));
  const auto ba = hn::BitCast(d8, hn::InterleaveUpper(d, lower, upper));
  const auto zero = hn::Zero(d8);
  out[0] = hn::BitCast(d16, hn::InterleaveLower(d8, rg, zero));
  out[1] = hn::BitCast(d16, hn::InterleaveUpper(d8, rg, zero));
  out[2] = hn::BitCast(d16, hn::InterleaveLower(d8, ba, zero));
  out[3] = hn::BitCast(d16, hn::InterleaveUpper(d8, ba, zero));
}

// The inverse: 8-bit values in 16-bit lanes as packed pixels.
HWY_INLINE Pair<VecU> pack_pixels(const Vec16 c[4]) {
  const Tag16 d;
  const TagU du;
  const Vec16 rg = hn::Or(c[0], hn::ShiftLeft<8>(c[1]));
  const Vec16 ba = hn::Or(c[2], hn::ShiftLeft<8>(c[3]));
  return {hn::BitCast(du, hn::InterleaveLower(d, rg, ba)),
          hn::BitCast(du, hn::InterleaveUpper(d, rg, ba))};
}

#endif  // HWY_TARGET != HWY_SCALAR

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
