// The last stages of a row of the fused loop, where pixels are not simply replaced: blending
// (4.1.7), logic operation (4.1.9), masks (4.2.2). One function for each blending of fused.def, and
// one for everything.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_WRITE_ROW_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_WRITE_ROW_INL_H_
#undef CLEARPIPE_FRAGMENT_WRITE_ROW_INL_H_
#else
#define CLEARPIPE_FRAGMENT_WRITE_ROW_INL_H_
#endif

#include <hwy/highway.h>

#include "pipeline/fragment/blend-inl.h"
#include "pipeline/fragment/early_tests-inl.h"
#include "pipeline/fragment/group-inl.h"
#include "pipeline/fragment/row_sampler-inl.h"
#include "pipeline/fragment/write-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

// Writes the colours of a row, 8-bit values, to the pixels that are covered.
using RowWriter = void (*)(const FragmentProgram& program, const RowColours& colours,
                           uint64_t covered, uint32_t* pixels);

// The pixels of a group in a row's mask.
HWY_INLINE uint64_t group_bits(uint64_t covered, int group) {
  constexpr uint64_t kGroupBits = kGroup == 64 ? ~uint64_t{0} : (uint64_t{1} << kGroup) - 1;
  return covered >> (group * kGroup) & kGroupBits;
}

// The same as masks of its halves.
HWY_INLINE Pair<MaskI> live_mask(uint64_t bits) {
  const TagI d;
  return {mask_of_bits(d, bits), mask_of_bits(d, bits >> (kGroup / 2))};
}

HWY_INLINE void store_live(const Pair<VecU>& pixels, const Pair<MaskI>& live, uint32_t* to) {
  const TagU d;
  hn::BlendedStore(pixels.lower, hn::RebindMask(d, live.lower), d, to);
  hn::BlendedStore(pixels.upper, hn::RebindMask(d, live.upper), d, to + kGroup / 2);
}

HWY_INLINE Pair<VecU> load_pixels(const uint32_t* from) {
  const TagU d;
  return {hn::Load(d, from), hn::Load(d, from + kGroup / 2)};
}

// Source colours over what is stored, as pixels.
template <class Blend>
HWY_INLINE Pair<VecU> blend_group(const Blend& state, const Colour16& source,
                                  const Pair<VecU>& stored) {
  const Tag16 d16;
  const TagU16 d;
  Vec16 destination[4], result[4];
  unpack_pixels(stored, destination);
  BlendOperands<hn::Vec<TagU16>> in;
  in.source_alpha = hn::BitCast(d, source.channel[3]);
  in.destination_alpha = hn::BitCast(d, destination[3]);
  for (int c = 0; c < 4; ++c) {
    in.source = hn::BitCast(d, source.channel[c]);
    in.destination = hn::BitCast(d, destination[c]);
    result[c] = hn::BitCast(d16, blend_channel(d, state, c == 3, in));
  }
  return pack_pixels(result);
}

// A blending that the compiler knows. Sums alone are listed in fused.def.
template <BlendFactor kSrcRgb, BlendFactor kDstRgb, BlendFactor kSrcAlpha, BlendFactor kDstAlpha>
struct FixedBlend {
  static constexpr BlendEquation rgb = BlendEquation::kAdd, alpha = BlendEquation::kAdd;
  static constexpr BlendFactor src_rgb = kSrcRgb, dst_rgb = kDstRgb;
  static constexpr BlendFactor src_alpha = kSrcAlpha, dst_alpha = kDstAlpha;
};

template <class Blend>
bool is_blend(const BlendState& state) {
  return state.rgb == Blend::rgb && state.alpha == Blend::alpha &&
         state.src_rgb == Blend::src_rgb && state.dst_rgb == Blend::dst_rgb &&
         state.src_alpha == Blend::src_alpha && state.dst_alpha == Blend::dst_alpha;
}

template <class Blend>
void blend_row(const FragmentProgram&, const RowColours& colours, uint64_t covered,
               uint32_t* pixels) {
  for (int group = 0; group < kRowGroups; ++group) {
    const uint64_t bits = group_bits(covered, group);
    if (bits == 0) continue;
    uint32_t* const to = pixels + group * kGroup;
    store_live(blend_group(Blend(), colours.load(group), load_pixels(to)), live_mask(bits), to);
  }
}

inline void write_row(const FragmentProgram& program, const RowColours& colours, uint64_t covered,
                      uint32_t* pixels) {
  const TagU d;
  const bool blends = program.blend.enabled && !program.has_logic_op;
  const Truncation truncation = truncation_of(program.format);
  const VecU writable = hn::Set(d, program.colour_mask);
  for (int group = 0; group < kRowGroups; ++group) {
    const uint64_t bits = group_bits(covered, group);
    if (bits == 0) continue;
    uint32_t* const to = pixels + group * kGroup;
    const Colour16 source = colours.load(group);
    const Pair<VecU> stored = load_pixels(to);
    Pair<VecU> result =
        blends ? blend_group(program.blend, source, stored) : pack_pixels(source.channel);
    const auto finish = [&](VecU pixel, VecU old) HWY_ATTR {
      if (program.has_logic_op) pixel = logic_op(d, program.logic_op, pixel, old);
      if (program.format != ColourFormat::kRgba8) pixel = truncate_colour(d, truncation, pixel);
      return hn::Or(hn::And(pixel, writable), hn::AndNot(writable, old));
    };
    result = {finish(result.lower, stored.lower), finish(result.upper, stored.upper)};
    store_live(result, live_mask(bits), to);
  }
}

// What writes the rows of a program.
inline RowWriter row_writer(const FragmentProgram& program) {
  const bool plain = program.colour_mask == 0xffffffffu && !program.has_logic_op &&
                     program.format == ColourFormat::kRgba8 && program.blend.enabled;
  if (!plain) return write_row;
#define FUSED_BLEND(src_rgb, dst_rgb, src_alpha, dst_alpha)                         \
  {                                                                                 \
    using Blend = FixedBlend<BlendFactor::k##src_rgb, BlendFactor::k##dst_rgb,      \
                             BlendFactor::k##src_alpha, BlendFactor::k##dst_alpha>; \
    if (is_blend<Blend>(program.blend)) return blend_row<Blend>;                    \
  }
#include "pipeline/fragment/fused.def"
  return write_row;
}

#endif  // HWY_TARGET != HWY_SCALAR

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
