// The fused loop on one SIMD target: see fused.h. Vectors of pixels are groups (group-inl.h).
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_FUSED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_FUSED_INL_H_
#undef CLEARPIPE_FRAGMENT_FUSED_INL_H_
#else
#define CLEARPIPE_FRAGMENT_FUSED_INL_H_
#endif

#include <hwy/highway.h>

#include <bit>

#include "pipeline/fragment/blend-inl.h"
#include "pipeline/fragment/compare-inl.h"
#include "pipeline/fragment/depth_stencil-inl.h"
#include "pipeline/fragment/fog-inl.h"
#include "pipeline/fragment/fused.h"
#include "pipeline/fragment/fused_unit-inl.h"
#include "pipeline/fragment/group-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

// All stages over the rows of a coverage, a group of pixels at a time.
template <FusedSampler kSampler0, FusedSampler kSampler1>
class FusedLoop {
 public:
  FusedLoop(const FragmentProgram& program, const PrimitivePlanes& planes, Tile& tile)
      : p_(program),
        planes_(planes),
        tile_(tile),
        tests_(program.depth_test || program.stencil.enabled),
        depth_(depth_state(program)),
        unit0_(program, planes, tile, 0),
        unit1_(program, planes, tile, 1) {
    needs_w_ = planes.perspective && (kSampler0 != FusedSampler::kNone || !planes.flat_colour ||
                                      program.fog_mode != FogMode::kNone);
    opaque_ = program.colour_mask == 0xffffffffu && !program.blend.enabled;
    solid_ = kSampler0 == FusedSampler::kNone && planes.flat_colour && opaque_ &&
             program.fog_mode == FogMode::kNone && !program.alpha_test;
    if (planes.flat_colour) {
      for (int c = 0; c < 4; ++c) {
        const VecI value = round_colour(TagF(), hn::Set(TagF(), planes.colour[c].value));
        flat_.channel[c] = narrow({value, value});
      }
    }
    if (solid_) {
      Vec16 bytes[4];
      for (int c = 0; c < 4; ++c) bytes[c] = to_unorm8(Tag16(), flat_.channel[c]);
      solid_pixels_ = pack_pixels(bytes).lower;
    }
  }

  void run(const Coverage& coverage) {
    constexpr int kGroup = 2 * static_cast<int>(hn::MaxLanes(TagF()));
    constexpr uint64_t kGroupBits = (uint64_t{1} << kGroup) - 1;
    for (int row = coverage.first_row; row < coverage.last_row; ++row) {
      const uint64_t covered = coverage.rows[row];
      if (covered == 0) continue;
      set_row(row);
      const int last = 64 - std::countl_zero(covered);
      for (int x = std::countr_zero(covered) / kGroup * kGroup; x < last; x += kGroup) {
        const uint64_t bits = covered >> x & kGroupBits;
        if (bits != 0) shade_group(row, x, bits);
      }
    }
  }

 private:
  static constexpr int kLanes = static_cast<int>(hn::MaxLanes(TagF()));

  HWY_INLINE void set_row(int row) {
    const TagF d;
    const VecF y = hn::Set(d, static_cast<float>(tile_.y + row) + (0.5f - planes_.y_ref));
    if (depth_.test) depth_plane_ = RowPlane(planes_.depth, y);
    if (solid_) return;
    if (needs_w_) inv_w_ = RowPlane(planes_.inv_w, y);
    if (!planes_.flat_colour) {
      for (int c = 0; c < 4; ++c) colour_[c] = RowPlane(planes_.colour[c], y);
    }
    if (p_.fog_mode != FogMode::kNone) fog_ = RowPlane(planes_.fog, y);
    if constexpr (kSampler0 != FusedSampler::kNone) unit0_.set_row(row, y);
    if constexpr (kSampler1 != FusedSampler::kNone) unit1_.set_row(row, y);
  }

  HWY_INLINE void shade_group(int row, int column, uint64_t bits) {
    const TagF d;
    const TagI di;
    // From whole numbers, as the chain has it.
    const VecF to_x = hn::Set(d, 0.5f - planes_.x_ref);
    const VecF first = hn::Set(d, static_cast<float>(tile_.x + column));
    const Pair<VecF> x = {hn::Add(hn::Add(first, hn::Iota(d, 0)), to_x),
                          hn::Add(hn::Add(first, hn::Iota(d, kLanes)), to_x)};
    const uint64_t upper_bits = bits >> kLanes;
    Pair<MaskI> live = {hn::LoadMaskBits(di, reinterpret_cast<const uint8_t*>(&bits)),
                        hn::LoadMaskBits(di, reinterpret_cast<const uint8_t*>(&upper_bits))};
    const int at = row * kTileWidth + column;
    // The alpha test comes first where there is one (4.1.4); otherwise what fails is not coloured.
    if (tests_ && !p_.alpha_test && !test_depth_stencil(x, at, live)) return;
    if (p_.colour_mask == 0 && !p_.alpha_test) return;
    if (solid_) {
      store_live({solid_pixels_, solid_pixels_}, live, tile_.colour + at);
      return;
    }
    Pair<VecF> w{};
    if (needs_w_) w = reciprocal(inv_w_.at(x));
    Colour16 colour = primary_colour(x, w);
    if constexpr (kSampler0 != FusedSampler::kNone) {
      unit0_.apply_environment(unit0_.sample(column, x, w), colour);
    }
    if constexpr (kSampler1 != FusedSampler::kNone) {
      unit1_.apply_environment(unit1_.sample(column, x, w), colour);
    }
    if (p_.fog_mode != FogMode::kNone) apply_fog(x, w, colour);
    Vec16 bytes[4];
    for (int c = 0; c < 4; ++c) bytes[c] = to_unorm8(Tag16(), colour.channel[c]);
    if (p_.alpha_test) {
      const Tag16 d16;
      const auto passes = compare(d16, p_.alpha_func, bytes[3], hn::Set(d16, p_.alpha_reference));
      const Pair<MaskI> wide = widen_mask(hn::VecFromMask(d16, passes));
      live = {hn::And(live.lower, wide.lower), hn::And(live.upper, wide.upper)};
      if (tests_ && !test_depth_stencil(x, at, live)) return;
    }
    if (p_.colour_mask != 0) write(bytes, at, live);
  }

  // Both tests; fragments that fail leave `live`. False when none is left.
  HWY_INLINE bool test_depth_stencil(const Pair<VecF>& x, int at, Pair<MaskI>& live) {
    live.lower = test_half(x.lower, at, live.lower);
    live.upper = test_half(x.upper, at + kLanes, live.upper);
    const TagI d;
    return !hn::AllFalse(d, hn::Or(live.lower, live.upper));
  }

  HWY_INLINE MaskI test_half(VecF x, int at, MaskI live) {
    const TagI d;
    auto* stored = reinterpret_cast<int32_t*>(tile_.depth_stencil + at);
    VecI packed = hn::Load(d, stored);
    const VecI depth =
        depth_.test ? to_depth_value(TagF(), depth_, depth_plane_.at(x)) : hn::Zero(d);
    const MaskI passes = p_.stencil.enabled
                             ? depth_stencil_test(d, p_.stencil, depth_, live, depth, packed)
                             : depth_stencil_test(d, StencilState(), depth_, live, depth, packed);
    if (depth_.write || p_.stencil.enabled) hn::Store(packed, d, stored);
    return passes;
  }

  HWY_INLINE Colour16 primary_colour(const Pair<VecF>& x, const Pair<VecF>& w) const {
    if (planes_.flat_colour) return flat_;
    Colour16 colour;
    for (int c = 0; c < 4; ++c) {
      const Pair<VecF> value = colour_[c].at(x);
      colour.channel[c] = narrow_scaled(planes_.perspective ? multiply(value, w) : value);
    }
    return colour;
  }

  HWY_INLINE void apply_fog(const Pair<VecF>& x, const Pair<VecF>& w, Colour16& colour) const {
    const TagF d;
    Pair<VecF> c = fog_.at(x);
    if (planes_.perspective) c = multiply(c, w);
    const FogConstants fog = fog_constants(p_);
    const Vec16 factor = narrow_colour({fog_factor(d, fog, c.lower), fog_factor(d, fog, c.upper)});
    for (int i = 0; i < 3; ++i) {
      colour.channel[i] = mix_fog(Tag16(), factor, fog.colour[i], colour.channel[i]);
    }
  }

  HWY_INLINE void write(Vec16 bytes[4], int at, const Pair<MaskI>& live) {
    const TagU d;
    uint32_t* to = tile_.colour + at;
    if (opaque_) {
      store_live(pack_pixels(bytes), live, to);
      return;
    }
    const Pair<VecU> stored = {hn::Load(d, to), hn::Load(d, to + kLanes)};
    if (p_.blend.enabled) blend_group(stored, bytes);
    const Pair<VecU> packed = pack_pixels(bytes);
    const VecU writable = hn::Set(d, p_.colour_mask);
    store_half(packed.lower, stored.lower, writable, live.lower, to);
    store_half(packed.upper, stored.upper, writable, live.upper, to + kLanes);
  }

  static HWY_INLINE void store_live(const Pair<VecU>& pixels, const Pair<MaskI>& live,
                                    uint32_t* to) {
    const TagU d;
    hn::BlendedStore(pixels.lower, hn::RebindMask(d, live.lower), d, to);
    hn::BlendedStore(pixels.upper, hn::RebindMask(d, live.upper), d, to + kLanes);
  }

  static HWY_INLINE void store_half(VecU packed, VecU stored, VecU writable, MaskI live,
                                    uint32_t* to) {
    const TagU d;
    const VecU change = hn::And(hn::BitCast(d, hn::VecFromMask(TagI(), live)), writable);
    hn::Store(hn::Or(hn::And(packed, change), hn::AndNot(change, stored)), d, to);
  }

  HWY_INLINE void blend_group(const Pair<VecU>& stored, Vec16 bytes[4]) const {
    const Tag16 d16;
    const TagU16 d;
    using V = hn::Vec<TagU16>;
    Vec16 destination[4];
    unpack_pixels(stored, destination);
    BlendOperands<V> in;
    in.source_alpha = hn::BitCast(d, bytes[3]);
    in.destination_alpha = hn::BitCast(d, destination[3]);
    const BlendState& state = p_.blend;
    for (int c = 0; c < 4; ++c) {
      in.source = hn::BitCast(d, bytes[c]);
      in.destination = hn::BitCast(d, destination[c]);
      bytes[c] = hn::BitCast(d16, blend_channel(d, state, c == 3, in));
    }
  }

  const FragmentProgram& p_;
  const PrimitivePlanes& planes_;
  Tile& tile_;
  const bool tests_;
  const DepthState depth_;
  bool needs_w_;
  bool opaque_;  // every fragment that lives replaces the whole pixel
  bool solid_;   // and all of them by the same
  Colour16 flat_;
  VecU solid_pixels_;
  RowPlane depth_plane_, inv_w_, fog_, colour_[4];
  FusedUnit<kSampler0> unit0_;
  FusedUnit<kSampler1> unit1_;
};

template <FusedSampler kSampler0, FusedSampler kSampler1>
void run_fused(const FragmentProgram& program, const PrimitivePlanes& planes,
               const Coverage& coverage, Tile& tile) {
  FusedLoop<kSampler0, kSampler1>(program, planes, tile).run(coverage);
}

#endif  // HWY_TARGET != HWY_SCALAR

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
