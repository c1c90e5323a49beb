// The end of a fragment (4.1.7 to 4.2.2): blending or the logical operation, the bits that the
// format has, the colour mask, and the store into the tile.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_WRITE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_WRITE_INL_H_
#undef CLEARPIPE_FRAGMENT_WRITE_INL_H_
#else
#define CLEARPIPE_FRAGMENT_WRITE_INL_H_
#endif

#include <hwy/highway.h>

#include "pipeline/fragment/batch.h"
#include "pipeline/fragment/blend-inl.h"
#include "pipeline/fragment/colour-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The final colour as packed RGBA8.
inline void pack_colour(const int16_t (*colour)[kBatchSize], int count, uint32_t* out) {
  const hn::ScalableTag<int16_t> d;
  const hn::Rebind<uint8_t, decltype(d)> d8;
  auto* bytes = reinterpret_cast<uint8_t*>(out);
  for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d))) {
    const auto r = hn::DemoteTo(d8, to_unorm8(d, hn::Load(d, colour[0] + i)));
    const auto g = hn::DemoteTo(d8, to_unorm8(d, hn::Load(d, colour[1] + i)));
    const auto b = hn::DemoteTo(d8, to_unorm8(d, hn::Load(d, colour[2] + i)));
    const auto a = hn::DemoteTo(d8, to_unorm8(d, hn::Load(d, colour[3] + i)));
    hn::StoreInterleaved4(r, g, b, a, d8, bytes + 4 * i);
  }
}

// Blends batch.colour over batch.stored_colour; the result replaces batch.colour.
inline void blend_stage(const BlendState& state, FragmentBatch& batch) {
  const hn::ScalableTag<uint16_t> d;
  const hn::Rebind<uint8_t, decltype(d)> d8;
  using V = hn::Vec<decltype(d)>;
  auto* source = reinterpret_cast<uint8_t*>(batch.colour);
  const auto* destination = reinterpret_cast<const uint8_t*>(batch.stored_colour);
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    hn::Vec<decltype(d8)> s8[4], d8v[4];
    hn::LoadInterleaved4(d8, source + 4 * i, s8[0], s8[1], s8[2], s8[3]);
    hn::LoadInterleaved4(d8, destination + 4 * i, d8v[0], d8v[1], d8v[2], d8v[3]);
    BlendOperands<V> in;
    in.source_alpha = hn::PromoteTo(d, s8[3]);
    in.destination_alpha = hn::PromoteTo(d, d8v[3]);
    for (int c = 0; c < 4; ++c) {
      in.source = hn::PromoteTo(d, s8[c]);
      in.destination = hn::PromoteTo(d, d8v[c]);
      const bool alpha = c == 3;
      const V result = blend_channel(d, state, alpha, in);
      s8[c] = hn::DemoteTo(d8, hn::BitCast(hn::RebindToSigned<decltype(d)>(), result));
    }
    hn::StoreInterleaved4(s8[0], s8[1], s8[2], s8[3], d8, source + 4 * i);
  }
}

// Table 4.6, as the disjunction of the four minterms that the operation's truth table selects.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V logic_op(D d, LogicOp op, V s, V t) {
  const uint8_t truth = static_cast<uint8_t>(op);  // the value is its truth table
  const auto selected = [&](int bit)
                            HWY_ATTR { return hn::Set(d, (truth >> bit & 1) != 0 ? ~0u : 0u); };
  V result = hn::And(hn::And(s, t), selected(0));
  result = hn::Or(result, hn::And(hn::AndNot(t, s), selected(1)));
  result = hn::Or(result, hn::And(hn::AndNot(s, t), selected(2)));
  return hn::Or(result, hn::AndNot(hn::Or(s, t), selected(3)));
}

inline void logic_op_stage(LogicOp op, FragmentBatch& batch) {
  const hn::ScalableTag<uint32_t> d;
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    const auto s = hn::Load(d, batch.colour + i);
    const auto t = hn::Load(d, batch.stored_colour + i);
    hn::Store(logic_op(d, op, s, t), d, batch.colour + i);
  }
}

// 4.1.8: what the format has of a packed colour (colour_format.h).
template <class D, class V = hn::Vec<D>>
HWY_INLINE V truncate_colour(D d, const Truncation& to, V pixel) {
  const hn::RebindToSigned<D> di;
  if (to.set != 0) return hn::Or(pixel, hn::Set(d, to.set));  // all others have 8 bits
  const V top = hn::BitCast(d, hn::BroadcastSignBit(hn::BitCast(di, pixel)));
  V result = hn::And(pixel, hn::Set(d, to.keep));
  result = hn::Or(result, hn::And(hn::ShiftRight<4>(pixel), hn::Set(d, to.from4)));
  result = hn::Or(result, hn::And(hn::ShiftRight<5>(pixel), hn::Set(d, to.from5)));
  result = hn::Or(result, hn::And(hn::ShiftRight<6>(pixel), hn::Set(d, to.from6)));
  return hn::Or(result, hn::And(top, hn::Set(d, to.from_top)));
}

inline void truncate_stage(ColourFormat format, FragmentBatch& batch) {
  const hn::ScalableTag<uint32_t> d;
  const Truncation to = truncation_of(format);
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    hn::Store(truncate_colour(d, to, hn::Load(d, batch.colour + i)), d, batch.colour + i);
  }
}

// Dead fragments and masked components keep what is stored.
inline void mask_stage(uint32_t colour_mask, FragmentBatch& batch, const int16_t* lives) {
  const hn::ScalableTag<uint32_t> d;
  const hn::RebindToSigned<decltype(d)> di;
  const hn::Rebind<int16_t, decltype(d)> d16;
  const auto writable = hn::Set(d, colour_mask);
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    const auto live = hn::BitCast(d, hn::PromoteTo(di, hn::Load(d16, lives + i)));
    const auto change = hn::And(live, writable);
    const auto stored = hn::Load(d, batch.stored_colour + i);
    hn::Store(hn::Or(hn::And(hn::Load(d, batch.colour + i), change), hn::AndNot(change, stored)), d,
              batch.colour + i);
  }
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
