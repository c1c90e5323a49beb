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
#include "pipeline/fragment/sample_colours-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

using TagF = hn::ScalableTag<float>;
using TagI = hn::RebindToSigned<TagF>;
using TagU = hn::RebindToUnsigned<TagF>;
using Tag16 = hn::Repartition<int16_t, TagF>;
using TagU16 = hn::RebindToUnsigned<Tag16>;
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

// The same of colours that are scaled already, as colour planes are.
HWY_INLINE Vec16 narrow_scaled(const Pair<VecF>& f) {
  const TagF d;
  return narrow({round_colour(d, f.lower), round_colour(d, f.upper)});
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

// Colours of both halves in the sampler's form (pairs of channels) as a group's.
HWY_INLINE Colour16 narrow_sample(const sampling::HWY_NAMESPACE::Colours& lower,
                                  const sampling::HWY_NAMESPACE::Colours& upper) {
  const TagI d;
  const VecI low = hn::Set(d, 0xffff);
  const VecI rb0 = hn::BitCast(d, lower.rb), rb1 = hn::BitCast(d, upper.rb);
  const VecI ga0 = hn::BitCast(d, lower.ga), ga1 = hn::BitCast(d, upper.ga);
  return {{narrow({hn::And(rb0, low), hn::And(rb1, low)}),
           narrow({hn::And(ga0, low), hn::And(ga1, low)}),
           narrow({hn::ShiftRight<16>(rb0), hn::ShiftRight<16>(rb1)}),
           narrow({hn::ShiftRight<16>(ga0), hn::ShiftRight<16>(ga1)})}};
}

// 8-bit channels of packed pixels as a group's.
HWY_INLINE void unpack_pixels(const Pair<VecU>& pixels, Vec16 out[4]) {
  const TagI d;
  const VecI byte = hn::Set(d, 0xff);
  const VecI a = hn::BitCast(d, pixels.lower), b = hn::BitCast(d, pixels.upper);
  out[0] = narrow({hn::And(a, byte), hn::And(b, byte)});
  out[1] = narrow({hn::And(hn::ShiftRight<8>(a), byte), hn::And(hn::ShiftRight<8>(b), byte)});
  out[2] = narrow({hn::And(hn::ShiftRight<16>(a), byte), hn::And(hn::ShiftRight<16>(b), byte)});
  out[3] = narrow({hn::BitCast(d, hn::ShiftRight<24>(pixels.lower)),
                   hn::BitCast(d, hn::ShiftRight<24>(pixels.upper))});
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
