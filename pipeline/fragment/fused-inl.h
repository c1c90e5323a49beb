// The fused loop on one SIMD target: see fused.h. Vectors of pixels are groups (group-inl.h).
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_FUSED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_FUSED_INL_H_
#undef CLEARPIPE_FRAGMENT_FUSED_INL_H_
#else
#define CLEARPIPE_FRAGMENT_FUSED_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <type_traits>

#include "pipeline/fragment/compare-inl.h"
#include "pipeline/fragment/early_tests-inl.h"
#include "pipeline/fragment/fog-inl.h"
#include "pipeline/fragment/fused_unit-inl.h"
#include "pipeline/fragment/group-inl.h"
#include "pipeline/fragment/split_plane-inl.h"
#include "pipeline/fragment/strips-inl.h"
#include "pipeline/fragment/write_row-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

// The texture units of a program: all are sampled, then their environments follow one another
// (3.7.12, 3.7.13). Environments that are not simple go through the chain's, on a batch of a few
// rows.
class FusedTextures {
 public:
  void start(const FragmentProgram& program, const PrimitivePlanes& planes, const Tile& tile,
             const TilePlaces& places) {
    p_ = &program;
    count_ = 0;
    simple_ = true;
    for (int u = 0; u < kMaxTextureUnits; ++u) {
      if ((program.inputs.texture_units >> u & 1) == 0) continue;
      unit_[count_].start(program, planes, tile, places, u);
      number_[count_++] = u;
      simple_ = simple_ && program.unit[u].simple_environment;
    }
    if (simple_) return;
    uses_primary_ = false;
    for (int i = 0; i < count_; ++i) {
      const UnitProgram& unit = program.unit[number_[i]];
      uses_primary_ = uses_primary_ || reads_primary_colour(unit.combiner);
      environment_[i] = bind_environment(unit.combiner, unit.constant, batch_);
    }
  }

  bool are_simple() const { return simple_; }
  bool have_pixels() const {
    return std::all_of(unit_, unit_ + count_, [](const FusedUnit& u) { return u.has_pixels(); });
  }

  // Samples halves of a row; w is that of its pixels.
  HWY_INLINE void sample(int row, Halves halves, const float* w) {
    for (int i = 0; i < count_; ++i) unit_[i].sample(row, halves, w, batch_);
  }

  // As fragment::gives_texels(), of the only unit.
  bool gives_texels(const PrimitivePlanes& planes, uint32_t& texel_bits) const {
    return count_ == 1 && simple_ && unit_[0].has_pixels() &&
           fragment::HWY_NAMESPACE::gives_texels(p_->unit[number_[0]].combiner, planes, texel_bits);
  }
  HWY_INLINE Pair<VecU> texels(int group) const { return unit_[0].pixels(group); }

  // The simple environments of a group that is sampled.
  HWY_INLINE void apply(int group, Colour16& colour) const {
    for (int i = 0; i < count_; ++i) {
      apply_simple_environment(p_->unit[number_[i]].combiner, unit_[i].colour(group), colour);
    }
  }

  // Environments of any kind, of a strip of rows: first a sampled group of each row after another,
  // with its primary colours, goes to a place in the strip.
  HWY_INLINE void put(int place, int group, const Colour16& primary) {
    const Tag16 d;
    const auto put_colour = [&](const Colour16& colour, int16_t(*to)[kBatchSize]) HWY_ATTR {
      for (int c = 0; c < 4; ++c) hn::Store(colour.channel[c], d, to[c] + place * kGroup);
    };
    if (uses_primary_) put_colour(primary, batch_.primary);
    put_colour(primary, batch_.previous);
    for (int i = 0; i < count_; ++i) put_colour(unit_[i].colour(group), batch_.texture[number_[i]]);
  }
  HWY_NOINLINE void combine(int first_place, int end_place) {
    for (int i = 0; i < count_; ++i) {
      run_environment(environment_[i], first_place * kGroup, end_place * kGroup, batch_.previous);
    }
  }
  HWY_INLINE Colour16 result(int place) const {
    const Tag16 d;
    Colour16 colour;
    for (int c = 0; c < 4; ++c) {
      colour.channel[c] = hn::Load(d, batch_.previous[c] + place * kGroup);
    }
    return colour;
  }

 private:
  const FragmentProgram* p_;
  int count_;
  bool simple_;
  bool uses_primary_;  // an environment takes it other than as what was there before
  int number_[kMaxTextureUnits];
  FusedUnit unit_[kMaxTextureUnits];
  BoundEnvironment environment_[kMaxTextureUnits];
  FragmentBatch batch_;
};

// All stages over a coverage: first the tests, where they may come first, then the colours of each
// row, a group of pixels at a time.
template <bool kTextured>
class FusedLoop {
 public:
  FusedLoop(const FragmentProgram& program, const PrimitivePlanes& planes, Tile& tile)
      : p_(program),
        planes_(planes),
        tile_(tile),
        tests_late_(program.alpha_test && (program.depth_test || program.stencil.enabled)),
        depth_(depth_state(program)),
        truncation_(truncation_of(program.format)) {
    needs_w_ = planes.perspective &&
               (kTextured || !planes.flat_colour || program.fog_mode != FogMode::kNone);
    opaque_ = program.colour_mask == 0xffffffffu && !program.blend.enabled && !program.has_logic_op;
  }

  void run(const Coverage& coverage) {
    Coverage left = coverage;
    if ((p_.depth_test || p_.stencil.enabled) && !tests_late_) {
      test_early(p_, planes_, planes_.depth, tile_, left);
    }
    if (p_.colour_mask == 0 && !p_.alpha_test) return;
    if (!opaque_) writer_ = row_writer(p_);
    const bool plain = !kTextured && !p_.alpha_test && p_.fog_mode == FogMode::kNone;
    if (plain && planes_.flat_colour) {
      shade_flat(left);
    } else if (plain && !planes_.perspective) {
      shade_linear(left);
    } else {
      shade_any(left);
    }
  }

 private:
  static constexpr int kLanes = kGroup / 2;

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

  // One colour for all pixels.
  void shade_flat(const Coverage& coverage) {
    Vec16 bytes[4];
    for (int c = 0; c < 4; ++c) bytes[c] = to_unorm8(Tag16(), flat_channel(c));
    if (opaque_) {
      const Pair<VecU> pixels = pack_kept(bytes);
      for_each_row(coverage, [&](int row, uint64_t covered) HWY_ATTR {
        for (int group = 0; group < kRowGroups; ++group) {
          store_live(pixels, live_mask(group_bits(covered, group)), pixels_of(row, group));
        }
      });
      return;
    }
    for (int group = 0; group < kRowGroups; ++group) put_bytes(bytes, group);
    for_each_row(coverage, [&](int row, uint64_t covered) HWY_ATTR { write_row(row, covered); });
  }

  // Interpolated colours that no division by w belongs to.
  void shade_linear(const Coverage& coverage) {
    set_colours(coverage, TilePlaces(tile_, planes_));
    const auto shade = [&](auto round, auto write) HWY_ATTR {
      for_each_row(coverage, [&](int row, uint64_t covered) HWY_ATTR {
        for (int group = 0; group < kRowGroups; ++group) {
          const uint64_t bits = group_bits(covered, group);
          if (bits == 0) continue;
          Vec16 bytes[4];
          for (int c = 0; c < 4; ++c) {
            const int column = group * kGroup;
            bytes[c] = to_unorm8(Tag16(), narrow({round(colour_[c].at(row, column)),
                                                  round(colour_[c].at(row, column + kLanes))}));
          }
          write(bytes, row, group, bits);
        }
        if (!opaque_) write_row(row, covered);
      });
    };
    const auto round_any = [](VecF v) HWY_ATTR { return round_colour(TagF(), v); };
    const auto replace = [&](Vec16 bytes[4], int row, int group, uint64_t bits) HWY_ATTR {
      store_live(pack_kept(bytes), live_mask(bits), pixels_of(row, group));
    };
    const auto keep = [&](Vec16 bytes[4], int, int group, uint64_t)
                          HWY_ATTR { put_bytes(bytes, group); };
    if (!opaque_) {
      shade(round_any, keep);
    } else if (inside_) {
      shade([](VecF v) HWY_ATTR { return round_inside(TagF(), v); }, replace);
    } else {
      shade(round_any, replace);
    }
  }

  // Everything else.
  void shade_any(const Coverage& coverage) {
    if (kTextured && p_.fits_strips && Strips::fit(p_, planes_, coverage)) {
      Strips(p_, planes_, tile_).run(coverage);
      return;
    }
    const TilePlaces places(tile_, planes_);
    if (tests_late_ && depth_.test) depth_plane_.set(planes_.depth, places);
    if (needs_w_) inv_w_.set(planes_.inv_w, places);
    if (p_.fog_mode != FogMode::kNone) fog_.set(planes_.fog, places);
    set_colours(coverage, places);
    if constexpr (kTextured) {
      textures_.start(p_, planes_, tile_, places);
      uint32_t texel_bits;
      if (!p_.alpha_test && p_.fog_mode == FogMode::kNone &&
          textures_.gives_texels(planes_, texel_bits)) {
        shade_texels(coverage, texel_bits);
        return;
      }
      if (!textures_.are_simple()) {
        shade_combined(coverage);
        return;
      }
    }
    for_each_row(coverage, [&](int row, uint64_t covered) HWY_ATTR {
      if constexpr (kTextured) sample_row(row, covered, w_);
      shade_row(row, covered, w_, 0);
    });
  }

  // Environments that are not simple: a few rows at once, since they are calls for each channel.
  void shade_combined(const Coverage& coverage) {
    constexpr int kStrip = kBatchSize / kTileWidth < 4 ? kBatchSize / kTileWidth : 4;
    alignas(64) float w[kStrip][kTileWidth];
    const int rows = textures_.have_pixels() ? kStrip : 1;  // the chain's samplers need the batch
    for (int first = coverage.first_row; first < coverage.last_row; first += rows) {
      const int count = std::min(rows, coverage.last_row - first);
      uint32_t places = 0;
      for (int i = 0; i < count; ++i) {
        const uint64_t covered = coverage.rows[first + i];
        if (covered == 0) continue;
        sample_row(first + i, covered, w[i]);
        for_each_group(groups_of(covered), [&](int group) HWY_ATTR {
          const Pair<VecF> group_w = needs_w_ ? load_w(w[i], group) : Pair<VecF>{};
          textures_.put(i * kRowGroups + group, group, primary_colour(first + i, group, group_w));
        });
        places |= groups_of(covered) << (i * kRowGroups);
      }
      if (places == 0) continue;
      textures_.combine(std::countr_zero(places), 32 - std::countl_zero(places));
      for (int i = 0; i < count; ++i) {
        const uint64_t covered = coverage.rows[first + i];
        if (covered != 0) shade_row(first + i, covered, w[i], i * kRowGroups);
      }
    }
  }

  // Texels that are the colours.
  void shade_texels(const Coverage& coverage, uint32_t bits) {
    const TagU d;
    for_each_row(coverage, [&](int row, uint64_t covered) HWY_ATTR {
      sample_row(row, covered, w_);
      for_each_group(groups_of(covered), [&](int group) HWY_ATTR {
        Pair<VecU> pixels = textures_.texels(group);
        pixels = {hn::Or(pixels.lower, hn::Set(d, bits)), hn::Or(pixels.upper, hn::Set(d, bits))};
        if (opaque_) {
          store_live(keep(pixels), live_mask(group_bits(covered, group)), pixels_of(row, group));
        } else {
          Vec16 bytes[4];
          unpack_pixels(pixels, bytes);
          put_bytes(bytes, group);
        }
      });
      if (!opaque_) write_row(row, covered);
    });
  }

  template <class F>
  static HWY_INLINE void for_each_row(const Coverage& coverage, const F& function) {
    for (int row = coverage.first_row; row < coverage.last_row; ++row) {
      if (coverage.rows[row] != 0) function(row, coverage.rows[row]);
    }
  }

  HWY_INLINE uint32_t* pixels_of(int row, int group) const {
    return tile_.colour + row * kTileWidth + group * kGroup;
  }
  HWY_INLINE void write_row(int row, uint64_t covered) const {
    writer_(p_, row_, covered, pixels_of(row, 0));
  }
  HWY_INLINE void put_bytes(const Vec16 bytes[4], int group) {
    for (int c = 0; c < 4; ++c) hn::Store(bytes[c], Tag16(), row_.channel[c] + group * kGroup);
  }

  void set_colours(const Coverage& coverage, const TilePlaces& places) {
    inside_ = !planes_.perspective;
    for (int c = 0; c < 4; ++c) {
      if (planes_.flat_colour) {
        flat_.channel[c] = flat_channel(c);
        continue;
      }
      colour_[c].set(planes_.colour[c], places);
      inside_ = inside_ && colour_[c].lies_within(coverage.first_row, coverage.last_row, 0.0f,
                                                  float{kColourOne});
    }
  }

  HWY_INLINE Vec16 flat_channel(int c) const {
    const VecI value = round_colour(TagF(), hn::Set(TagF(), planes_.colour[c].value));
    return narrow({value, value});
  }

  static HWY_INLINE Pair<VecF> at(const SplitPlane& plane, int row, int group) {
    return {plane.at(row, group * kGroup), plane.at(row, group * kGroup + kLanes)};
  }

  HWY_INLINE void sample_row(int row, uint64_t covered, float* row_w) {
    const TagF d;
    if (needs_w_) {
      for_each_group(groups_of(covered), [&](int group) HWY_ATTR {
        const Pair<VecF> w = reciprocal(at(inv_w_, row, group));
        hn::Store(w.lower, d, row_w + group * kGroup);
        hn::Store(w.upper, d, row_w + group * kGroup + kLanes);
      });
    }
    textures_.sample(row, halves_of(covered), row_w);
  }
  static HWY_INLINE Pair<VecF> load_w(const float* row_w, int group) {
    const TagF d;
    return {hn::Load(d, row_w + group * kGroup), hn::Load(d, row_w + group * kGroup + kLanes)};
  }

  // A row that is sampled. `place` is that of its first group in a strip of combined rows.
  HWY_INLINE void shade_row(int row, uint64_t covered, const float* w, int place) {
    uint64_t written = 0;
    for_each_group(groups_of(covered), [&](int group) HWY_ATTR {
      written |= shade_group(row, group, group_bits(covered, group), w, place + group)
                 << (group * kGroup);
    });
    if (!opaque_ && p_.colour_mask != 0) write_row(row, written);
  }

  // Pixels that replace what is stored go there, others to the row's colours. Returns which pixels
  // are written: the alpha test comes before those of depth and stencil (4.1.4).
  HWY_INLINE uint64_t shade_group(int row, int group, uint64_t bits, const float* row_w,
                                  int place) {
    Pair<VecF> w{};
    if (needs_w_) w = kTextured ? load_w(row_w, group) : reciprocal(at(inv_w_, row, group));
    Colour16 colour;
    if constexpr (!kTextured) {
      colour = primary_colour(row, group, w);
    } else if (textures_.are_simple()) {
      colour = primary_colour(row, group, w);
      textures_.apply(group, colour);
    } else {
      colour = textures_.result(place);
    }
    if (p_.fog_mode != FogMode::kNone) apply_fog(row, group, w, colour);
    Vec16 bytes[4];
    for (int c = 0; c < 4; ++c) bytes[c] = to_unorm8(Tag16(), colour.channel[c]);
    Pair<MaskI> live = live_mask(bits);
    if (p_.alpha_test) {
      const Tag16 d16;
      const auto passes = compare(d16, p_.alpha_func, bytes[3], hn::Set(d16, p_.alpha_reference));
      const Pair<MaskI> wide = widen_mask(hn::VecFromMask(d16, passes));
      live = {hn::And(live.lower, wide.lower), hn::And(live.upper, wide.upper)};
      if (tests_late_) {
        const int column = group * kGroup;
        live = {test_half(row, column, live.lower), test_half(row, column + kLanes, live.upper)};
      }
    }
    if (opaque_) {
      store_live(pack_kept(bytes), live, pixels_of(row, group));
      return bits;
    }
    put_bytes(bytes, group);
    if (!p_.alpha_test) return bits;
    const TagI d;
    return bits_of_mask(d, live.lower) | bits_of_mask(d, live.upper) << kLanes;
  }

  // Both tests of half a group; returns which fragments are left.
  HWY_INLINE MaskI test_half(int row, int column, MaskI live) {
    const TagI d;
    auto* stored = reinterpret_cast<int32_t*>(tile_.depth_stencil + row * kTileWidth + column);
    VecI packed = hn::Load(d, stored);
    const VecI depth =
        depth_.test ? to_depth_value(TagF(), depth_, depth_plane_.at(row, column)) : hn::Zero(d);
    const MaskI passes = depth_stencil_test(d, p_.stencil, depth_, live, depth, packed);
    hn::Store(packed, d, stored);
    return passes;
  }

  HWY_INLINE Colour16 primary_colour(int row, int group, const Pair<VecF>& w) const {
    if (planes_.flat_colour) return flat_;
    const TagF d;
    Colour16 colour;
    for (int c = 0; c < 4; ++c) {
      Pair<VecF> value = at(colour_[c], row, group);
      if (inside_) {
        colour.channel[c] = narrow({round_inside(d, value.lower), round_inside(d, value.upper)});
      } else {
        if (planes_.perspective) value = multiply(value, w);
        colour.channel[c] = narrow({round_colour(d, value.lower), round_colour(d, value.upper)});
      }
    }
    return colour;
  }

  HWY_INLINE void apply_fog(int row, int group, const Pair<VecF>& w, Colour16& colour) const {
    const TagF d;
    Pair<VecF> c = at(fog_, row, group);
    if (planes_.perspective) c = multiply(c, w);
    const FogConstants fog = fog_constants(p_);
    const Vec16 factor = narrow_colour({fog_factor(d, fog, c.lower), fog_factor(d, fog, c.upper)});
    for (int i = 0; i < 3; ++i) {
      colour.channel[i] = mix_fog(Tag16(), factor, fog.colour[i], colour.channel[i]);
    }
  }

  // Packed pixels, on a surface of fewer bits what it holds of them (4.1.8).
  HWY_INLINE Pair<VecU> pack_kept(const Vec16 bytes[4]) const { return keep(pack_pixels(bytes)); }
  HWY_INLINE Pair<VecU> keep(const Pair<VecU>& pixels) const {
    if (p_.format == ColourFormat::kRgba8) return pixels;
    const TagU d;
    return {truncate_colour(d, truncation_, pixels.lower),
            truncate_colour(d, truncation_, pixels.upper)};
  }

  const FragmentProgram& p_;
  const PrimitivePlanes& planes_;
  Tile& tile_;
  const bool tests_late_;  // after the alpha test
  const NarrowDepthState depth_;
  const Truncation truncation_;
  bool needs_w_;
  bool opaque_;                 // every fragment that lives replaces the whole pixel
  RowWriter writer_ = nullptr;  // where it does not
  bool inside_;                 // no colour has to be clamped
  Colour16 flat_;
  SplitPlane depth_plane_, inv_w_, fog_, colour_[4];
  alignas(64) float w_[kTileWidth];  // of the pixels of a textured row
  RowColours row_;                   // 8-bit values, for the writer
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
