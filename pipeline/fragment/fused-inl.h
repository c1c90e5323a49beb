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
#include <type_traits>

#include "pipeline/fragment/blend-inl.h"
#include "pipeline/fragment/compare-inl.h"
#include "pipeline/fragment/depth_stencil-inl.h"
#include "pipeline/fragment/fog-inl.h"
#include "pipeline/fragment/fused_unit-inl.h"
#include "pipeline/fragment/group-inl.h"
#include "pipeline/fragment/write-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

// The texture units of a program: all are sampled, then their environments follow one another
// (3.7.12, 3.7.13). Environments that are not simple go through the chain's, on a batch of one
// group.
class FusedTextures {
 public:
  void start(const FragmentProgram& program, const PrimitivePlanes& planes, const Tile& tile) {
    p_ = &program;
    count_ = 0;
    simple_ = true;
    for (int u = 0; u < kMaxTextureUnits; ++u) {
      if ((program.inputs.texture_units >> u & 1) == 0) continue;
      unit_[count_].start(program, planes, tile, u);
      number_[count_++] = u;
      simple_ = simple_ && program.unit[u].simple_environment;
    }
    if (simple_) return;
    for (int i = 0; i < count_; ++i) {
      const UnitProgram& unit = program.unit[number_[i]];
      environment_[i] = bind_environment(unit.combiner, unit.constant, batch_);
    }
  }

  bool are_simple() const { return simple_; }

  // Samples halves of a row; x and w are those of its pixels.
  HWY_INLINE void sample(int row, Halves halves, VecF y, const float* x, const float* w) {
    for (int i = 0; i < count_; ++i) unit_[i].sample(row, halves, y, x, w, batch_);
  }

  // The simple environments of a group that is sampled.
  HWY_INLINE void apply(int group, Colour16& colour) const {
    for (int i = 0; i < count_; ++i) {
      apply_simple_environment(p_->unit[number_[i]].combiner, unit_[i].colour(group), colour);
    }
  }

  // Environments of any kind, of a row: primary colours go in first, a group at a time.
  HWY_INLINE void put_primary(int group, const Colour16& colour) {
    const Tag16 d;
    for (int c = 0; c < 4; ++c) {
      hn::Store(colour.channel[c], d, batch_.primary[c] + group * kGroup);
      hn::Store(colour.channel[c], d, batch_.previous[c] + group * kGroup);
    }
  }
  HWY_NOINLINE void apply_row(int first_group, int end_group) {
    const Tag16 d;
    for (int i = 0; i < count_; ++i) {
      for (int group = first_group; group < end_group; ++group) {
        const Colour16 texture = unit_[i].colour(group);
        for (int c = 0; c < 4; ++c) {
          hn::Store(texture.channel[c], d, batch_.texture[number_[i]][c] + group * kGroup);
        }
      }
    }
    const int first = first_group * kGroup, end = end_group * kGroup;
    for (int i = 0; i < count_; ++i) run_environment(environment_[i], first, end, batch_.previous);
  }
  HWY_INLINE Colour16 result(int group) const {
    const Tag16 d;
    Colour16 colour;
    for (int c = 0; c < 4; ++c) {
      colour.channel[c] = hn::Load(d, batch_.previous[c] + group * kGroup);
    }
    return colour;
  }

 private:
  const FragmentProgram* p_;
  int count_;
  bool simple_;
  int number_[kMaxTextureUnits];
  FusedUnit unit_[kMaxTextureUnits];
  BoundEnvironment environment_[kMaxTextureUnits];
  FragmentBatch batch_;
};

// All stages over the rows of a coverage, a group of pixels at a time.
template <bool kTextured>
class FusedLoop {
 public:
  FusedLoop(const FragmentProgram& program, const PrimitivePlanes& planes, Tile& tile)
      : p_(program),
        planes_(planes),
        tile_(tile),
        tests_(program.depth_test || program.stencil.enabled),
        depth_(depth_state(program)),
        truncates_(program.format != ColourFormat::kRgba8),
        truncation_(truncation_of(program.format)) {
    needs_w_ = planes.perspective &&
               (kTextured || !planes.flat_colour || program.fog_mode != FogMode::kNone);
    blends_ = program.blend.enabled && !program.has_logic_op;
    opaque_ = program.colour_mask == 0xffffffffu && !blends_ && !program.has_logic_op;
    solid_ = !kTextured && planes.flat_colour && opaque_ && program.fog_mode == FogMode::kNone &&
             !program.alpha_test;
    if constexpr (kTextured) textures_.start(program, planes, tile);
    if (planes.flat_colour) {
      for (int c = 0; c < 4; ++c) {
        const VecI value = round_colour(TagF(), hn::Set(TagF(), planes.colour[c].value));
        flat_.channel[c] = narrow({value, value});
      }
    }
    if (solid_) {
      Vec16 bytes[4];
      for (int c = 0; c < 4; ++c) bytes[c] = to_unorm8(Tag16(), flat_.channel[c]);
      solid_pixels_ = pack_kept(bytes).lower;
    }
  }

  void run(const Coverage& coverage) {
    for (int row = coverage.first_row; row < coverage.last_row; ++row) {
      uint64_t covered = coverage.rows[row];
      if (covered == 0) continue;
      set_row(row);
      if constexpr (kTextured) {
        if (tests_ && !p_.alpha_test) covered = test_row(row, covered);
        if (covered == 0 || (p_.colour_mask == 0 && !p_.alpha_test)) continue;
        sample_row(row, covered);
        if (!textures_.are_simple()) combine_row(covered);
      }
      for (uint32_t rest = groups_of(covered); rest != 0; rest &= rest - 1) {
        const int group = std::countr_zero(rest);
        shade_group(row, group, group_bits(covered, group));
      }
    }
  }

 private:
  static constexpr int kLanes = kGroup / 2;

  static constexpr uint64_t kGroupBits = (uint64_t{1} << kGroup) - 1;

  static HWY_INLINE uint64_t group_bits(uint64_t covered, int group) {
    return covered >> (group * kGroup) & kGroupBits;
  }

  // The groups of a row that have pixels, a bit each.
  static HWY_INLINE uint32_t groups_of(uint64_t covered) {
    uint32_t groups = 0;
    for (int group = 0; group < kRowGroups; ++group) {
      groups |= (group_bits(covered, group) != 0 ? 1u : 0u) << group;
    }
    return groups;
  }

  static HWY_INLINE Halves halves_of(uint64_t covered) {
    constexpr uint64_t kHalfBits = (uint64_t{1} << kLanes) - 1;
    Halves halves = 0;
    for (int half = 0; half < 2 * kRowGroups; ++half) {
      halves |= ((covered >> (half * kLanes) & kHalfBits) != 0 ? 1u : 0u) << half;
    }
    return halves;
  }

  HWY_INLINE void set_row(int row) {
    y_ = hn::Set(TagF(), static_cast<float>(tile_.y + row) + (0.5f - planes_.y_ref));
    if (depth_.test) depth_plane_ = RowPlane(planes_.depth, y_);
    if (solid_) return;
    if (needs_w_) inv_w_ = RowPlane(planes_.inv_w, y_);
    if (!planes_.flat_colour) {
      for (int c = 0; c < 4; ++c) colour_[c] = RowPlane(planes_.colour[c], y_);
    }
    if (p_.fog_mode != FogMode::kNone) fog_ = RowPlane(planes_.fog, y_);
  }

  // The places of a group's pixels, from whole numbers, as the chain has them.
  HWY_INLINE Pair<VecF> place(int group) const {
    const TagF d;
    const VecF to_x = hn::Set(d, 0.5f - planes_.x_ref);
    const VecF first = hn::Set(d, static_cast<float>(tile_.x + group * kGroup));
    return {hn::Add(hn::Add(first, hn::Iota(d, 0)), to_x),
            hn::Add(hn::Add(first, hn::Iota(d, kLanes)), to_x)};
  }

  static HWY_INLINE Pair<MaskI> live_mask(uint64_t bits) {
    const TagI d;
    const uint64_t upper_bits = bits >> kLanes;
    return {hn::LoadMaskBits(d, reinterpret_cast<const uint8_t*>(&bits)),
            hn::LoadMaskBits(d, reinterpret_cast<const uint8_t*>(&upper_bits))};
  }

  static HWY_INLINE uint64_t bits_of(const Pair<MaskI>& live) {
    const TagI d;
    uint8_t lower[8] = {}, upper[8] = {};
    hn::StoreMaskBits(d, live.lower, lower);
    hn::StoreMaskBits(d, live.upper, upper);
    uint32_t lower_bits, upper_bits;
    std::memcpy(&lower_bits, lower, sizeof(lower_bits));
    std::memcpy(&upper_bits, upper, sizeof(upper_bits));
    return lower_bits | static_cast<uint64_t>(upper_bits) << kLanes;
  }

  // The depth and stencil tests of a row; returns what passes.
  HWY_INLINE uint64_t test_row(int row, uint64_t covered) {
    uint64_t passed = 0;
    for (uint32_t rest = groups_of(covered); rest != 0; rest &= rest - 1) {
      const int group = std::countr_zero(rest);
      Pair<MaskI> live = live_mask(group_bits(covered, group));
      if (test_depth_stencil(place(group), row * kTileWidth + group * kGroup, live)) {
        passed |= bits_of(live) << (group * kGroup);
      }
    }
    return passed;
  }

  HWY_INLINE void sample_row(int row, uint64_t covered) {
    const TagF d;
    for (uint32_t rest = groups_of(covered); rest != 0; rest &= rest - 1) {
      const int group = std::countr_zero(rest);
      const Pair<VecF> x = place(group);
      hn::Store(x.lower, d, x_ + group * kGroup);
      hn::Store(x.upper, d, x_ + group * kGroup + kLanes);
      if (!needs_w_) continue;
      const Pair<VecF> w = reciprocal(inv_w_.at(x));
      hn::Store(w.lower, d, w_ + group * kGroup);
      hn::Store(w.upper, d, w_ + group * kGroup + kLanes);
    }
    textures_.sample(row, halves_of(covered), y_, x_, w_);
  }

  HWY_INLINE void combine_row(uint64_t covered) {
    const uint32_t groups = groups_of(covered);
    const int first = std::countr_zero(groups), end = 32 - std::countl_zero(groups);
    for (int group = first; group < end; ++group) {
      const Pair<VecF> x = place(group);
      textures_.put_primary(group, primary_colour(x, needs_w_ ? group_w(group, x) : Pair<VecF>{}));
    }
    textures_.apply_row(first, end);
  }

  HWY_INLINE void shade_group(int row, int group, uint64_t bits) {
    const Pair<VecF> x = place(group);
    Pair<MaskI> live = live_mask(bits);
    const int at = row * kTileWidth + group * kGroup;
    if constexpr (!kTextured) {
      // The alpha test comes first where there is one (4.1.4); otherwise what fails is not
      // coloured.
      if (tests_ && !p_.alpha_test && !test_depth_stencil(x, at, live)) return;
      if (p_.colour_mask == 0 && !p_.alpha_test) return;
      if (solid_) {
        store_live({solid_pixels_, solid_pixels_}, live, tile_.colour + at);
        return;
      }
    }
    Pair<VecF> w{};
    if (needs_w_) w = group_w(group, x);
    Colour16 colour;
    if constexpr (!kTextured) {
      colour = primary_colour(x, w);
    } else if (textures_.are_simple()) {
      colour = primary_colour(x, w);
      textures_.apply(group, colour);
    } else {
      colour = textures_.result(group);
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

  HWY_INLINE Pair<VecF> group_w(int group, const Pair<VecF>& x) const {
    const TagF d;
    if constexpr (kTextured) {
      return {hn::Load(d, w_ + group * kGroup), hn::Load(d, w_ + group * kGroup + kLanes)};
    } else {
      return reciprocal(inv_w_.at(x));
    }
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
      store_live(pack_kept(bytes), live, to);
      return;
    }
    const Pair<VecU> stored = {hn::Load(d, to), hn::Load(d, to + kLanes)};
    if (blends_) blend_group(stored, bytes);
    Pair<VecU> packed = pack_pixels(bytes);
    if (p_.has_logic_op) {
      packed.lower = logic_op(d, p_.logic_op, packed.lower, stored.lower);
      packed.upper = logic_op(d, p_.logic_op, packed.upper, stored.upper);
    }
    if (truncates_) packed = truncate_pixels(packed);
    const VecU writable = hn::Set(d, p_.colour_mask);
    store_half(packed.lower, stored.lower, writable, live.lower, to);
    store_half(packed.upper, stored.upper, writable, live.upper, to + kLanes);
  }

  // 4.1.8, on a surface of fewer bits.
  HWY_INLINE Pair<VecU> truncate_pixels(const Pair<VecU>& pixels) const {
    const TagU d;
    return {truncate_colour(d, truncation_, pixels.lower),
            truncate_colour(d, truncation_, pixels.upper)};
  }
  HWY_INLINE Pair<VecU> pack_kept(Vec16 bytes[4]) const {
    const Pair<VecU> packed = pack_pixels(bytes);
    return truncates_ ? truncate_pixels(packed) : packed;
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
  const NarrowDepthState depth_;
  const bool truncates_;
  const Truncation truncation_;
  bool needs_w_;
  bool blends_;
  bool opaque_;  // every fragment that lives replaces the whole pixel
  bool solid_;   // and all of them by the same
  Colour16 flat_;
  VecU solid_pixels_;
  RowPlane depth_plane_, inv_w_, fog_, colour_[4];
  VecF y_;
  alignas(64) float x_[kTileWidth], w_[kTileWidth];  // of the pixels of a textured row
  std::conditional_t<kTextured, FusedTextures, char> textures_;
};

template <bool kTextured>
void run_fused(const FragmentProgram& program, const PrimitivePlanes& planes,
               const Coverage& coverage, Tile& tile) {
  FusedLoop<kTextured>(program, planes, tile).run(coverage);
}

#endif  // HWY_TARGET != HWY_SCALAR

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
