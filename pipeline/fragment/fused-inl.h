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
#include "pipeline/fragment/fused_textures-inl.h"
#include "pipeline/fragment/group-inl.h"
#include "pipeline/fragment/split_plane-inl.h"
#include "pipeline/fragment/strips-inl.h"
#include "pipeline/fragment/write_row-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

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
    const bool plain = !kTextured && is_plain();
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
      if (is_plain() && textures_.gives_texels(planes_, texel_bits)) {
        shade_texels(coverage, texel_bits);
        return;
      }
      if (!textures_.are_simple()) {
        shade_combined(coverage);
        return;
      }
    }
    const bool plain = is_plain();
    for_each_row(coverage, [&](int row, uint64_t covered) HWY_ATTR {
      if constexpr (kTextured) sample_row(row, covered, w_);
      if (plain) {
        shade_plain_row(row, covered);
      } else {
        shade_row(row, covered, w_, 0);
      }
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
          const Pair<VecF> group_w = w_of(first + i, group, w[i]);
          textures_.put(i * kRowGroups + group, group, primary_colour(first + i, group, group_w));
        });
        places |= groups_of(covered) << (i * kRowGroups);
      }
      if (places == 0) continue;
      textures_.combine(std::countr_zero(places), 32 - std::countl_zero(places));
      for (int i = 0; i < count; ++i) {
        const uint64_t covered = coverage.rows[first + i];
        if (covered == 0) continue;
        if (!is_plain()) {
          shade_row(first + i, covered, w[i], i * kRowGroups);
          continue;
        }
        for_each_group(groups_of(covered), [&](int group) HWY_ATTR {
          write_plain(textures_.result(i * kRowGroups + group), first + i, group, covered);
        });
        if (!opaque_ && p_.colour_mask != 0) write_row(first + i, covered);
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
  // w of a group, if it is needed: of a row that is sampled it is known.
  HWY_INLINE Pair<VecF> w_of(int row, int group, const float* row_w) const {
    if (!needs_w_) return Pair<VecF>{};
    if constexpr (!kTextured) return reciprocal(at(inv_w_, row, group));
    const TagF d;
    return {hn::Load(d, row_w + group * kGroup), hn::Load(d, row_w + group * kGroup + kLanes)};
  }

  // Nothing comes after the environments.
  bool is_plain() const { return !p_.alpha_test && p_.fog_mode == FogMode::kNone; }

  // A row that is sampled. `place` is that of its first group in a strip of combined rows.
  HWY_INLINE void shade_row(int row, uint64_t covered, const float* w, int place) {
    uint64_t written = 0;
    for_each_group(groups_of(covered), [&](int group) HWY_ATTR {
      written |= shade_group(row, group, group_bits(covered, group), w, place + group)
                 << (group * kGroup);
    });
    if (!opaque_ && p_.colour_mask != 0) write_row(row, written);
  }

  // The same where no environment is combined and all is plain.
  HWY_INLINE void shade_plain_row(int row, uint64_t covered) {
    for_each_group(groups_of(covered), [&](int group) HWY_ATTR {
      Colour16 colour = primary_colour(row, group, w_of(row, group, w_));
      if constexpr (kTextured) textures_.apply(group, colour);
      write_plain(colour, row, group, covered);
    });
    if (!opaque_ && p_.colour_mask != 0) write_row(row, covered);
  }

  HWY_INLINE void write_plain(const Colour16& colour, int row, int group, uint64_t covered) {
    Vec16 bytes[4];
    to_bytes(colour, bytes);
    write_group(bytes, live_mask(group_bits(covered, group)), row, group);
  }

  static HWY_INLINE void to_bytes(const Colour16& colour, Vec16 bytes[4]) {
    for (int c = 0; c < 4; ++c) bytes[c] = to_unorm8(Tag16(), colour.channel[c]);
  }

  // Pixels that replace what is stored go there, others to the row's colours.
  HWY_INLINE void write_group(const Vec16 bytes[4], const Pair<MaskI>& live, int row, int group) {
    if (opaque_) {
      store_live(pack_kept(bytes), live, pixels_of(row, group));
    } else {
      put_bytes(bytes, group);
    }
  }

  // Returns which pixels are written: the alpha test comes before those of depth and stencil
  // (4.1.4).
  HWY_INLINE uint64_t shade_group(int row, int group, uint64_t bits, const float* row_w,
                                  int place) {
    const Pair<VecF> w = w_of(row, group, row_w);
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
    to_bytes(colour, bytes);
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
    write_group(bytes, live, row, group);
    if (opaque_ || !p_.alpha_test) return bits;
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
