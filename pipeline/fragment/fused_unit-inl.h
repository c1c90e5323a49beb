// A texture unit of the fused loop: its coordinates along a row, its levels of detail and samplers,
// and the simple environments.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_FUSED_UNIT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_FUSED_UNIT_INL_H_
#undef CLEARPIPE_FRAGMENT_FUSED_UNIT_INL_H_
#else
#define CLEARPIPE_FRAGMENT_FUSED_UNIT_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "pipeline/fragment/group-inl.h"
#include "pipeline/fragment/interpolate-inl.h"
#include "pipeline/fragment/row_sampler-inl.h"
#include "pipeline/fragment/sample_colours-inl.h"
#include "pipeline/fragment/split_plane-inl.h"
#include "pipeline/fragment/sample-inl.h"
#include "pipeline/fragment/texcoord-inl.h"
#include "pipeline/fragment/texenv-inl.h"
#include "pipeline/fragment/whole_row-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

HWY_INLINE Pair<VecF> multiply(const Pair<VecF>& a, const Pair<VecF>& b) {
  return {hn::Mul(a.lower, b.lower), hn::Mul(a.upper, b.upper)};
}
HWY_INLINE Pair<VecF> reciprocal(const Pair<VecF>& v) {
  const VecF one = hn::Set(TagF(), 1.0f);
  return {hn::Div(one, v.lower), hn::Div(one, v.upper)};
}

// Levels and weights of the quads of a tile (3.7.7, 3.7.8), found for a group at a time and kept
// for the second row of the quads. Keys are those of sample.h; weights have 8 bits.
class QuadLevels {
 public:
  HWY_INLINE void reset() {
    corner_ = -1;
    done_ = 0;
  }

  HWY_INLINE void set_row(const Tile& tile, int row) {
    const int corner = quad_row(tile, tile.y + row);
    if (corner != corner_) done_ = 0;
    corner_ = corner;
  }

  void find(const PrimitivePlanes& primitive, const Plane* planes, const SampleState& sample,
            const Tile& tile, uint32_t groups) {
    const TagF d;
    const TagI di;
    const SampleLevel& level = sample.levels[sample.first_level];
    const VecF to_x = hn::Set(d, 0.5f - primitive.x_ref);
    const VecF y = hn::Set(d, static_cast<float>(corner_) + (0.5f - primitive.y_ref));
    for_each_group(groups & ~done_, [&](int group) HWY_ATTR {
      const VecI columns =
          hn::Add(hn::Set(di, tile.x + group * kGroup), hn::ShiftLeft<1>(hn::Iota(di, 0)));
      const VecF x = hn::Add(hn::ConvertTo(d, columns), to_x);
      const VecF lod = level_of_detail(d, quad_footprint(d, planes, level, tile, x, y));
      const auto choice = sampling::HWY_NAMESPACE::choose_level<false>(sample, lod);
      hn::Store(choice.key, di, keys_ + group * kLanes);
      hn::Store(choice.weight, di, weights_ + group * kLanes);
    });
    done_ |= groups;
  }

  HWY_INLINE VecI keys(int group) const { return hn::Load(TagI(), keys_ + group * kLanes); }
  HWY_INLINE VecI weights(int group) const { return hn::Load(TagI(), weights_ + group * kLanes); }
  HWY_INLINE int first_key(int group) const { return keys_[group * kLanes]; }
  HWY_INLINE bool is_one_key(int group, int key) const {
    return hn::AllTrue(TagI(), hn::Eq(keys(group), hn::Set(TagI(), key)));
  }
  HWY_INLINE MaskI between_levels(int group) const {
    return hn::Gt(weights(group), hn::Zero(TagI()));
  }

  // A value of each quad for both of its pixels in the row.
  static HWY_INLINE Pair<VecI> spread(VecI quads) {
    const TagI d;
    const VecI lower = hn::ShiftRight<1>(hn::Iota(d, 0));
    const VecI upper = hn::Add(lower, hn::Set(d, kLanes / 2));
    return {hn::TableLookupLanes(quads, hn::IndicesFromVec(d, lower)),
            hn::TableLookupLanes(quads, hn::IndicesFromVec(d, upper))};
  }

 private:
  static constexpr int kLanes = kGroup / 2;  // quads of a group

  int corner_;
  uint32_t done_;  // bit g: group g is found
  alignas(64) int32_t keys_[kTileWidth / 2];
  alignas(64) int32_t weights_[kTileWidth / 2];
};

// One texture unit: its coordinates on the row at hand, and its samplers.
class FusedUnit {
 public:
  void start(const FragmentProgram& program, const PrimitivePlanes& planes, const Tile& tile,
             const TilePlaces& places, int unit) {
    unit_ = &program.unit[unit];
    primitive_ = &planes;
    planes_ = planes.texture[unit];
    tile_ = &tile;
    index_ = unit;
    const Plane& q = planes_[3];
    q_is_one_ = q.value == 1 && q.dx == 0 && q.dy == 0;
    q_is_inv_w_ = planes.perspective && std::memcmp(&q, &planes.inv_w, sizeof(Plane)) == 0;
    sampler_[0] = row_sampler(unit_->fused_min);
    sampler_[1] = row_sampler(unit_->fused_mag);
    has_levels_ = unit_->sample.needs_lod && sampler_[0] != nullptr;
    if (has_levels_) levels_.reset();
#if HWY_TARGET <= HWY_AVX3
    const SampleState& sample = unit_->sample;
    whole_row_ = q_is_one_ && !has_levels_
                     ? WholeRow::sampler(unit_->fused_min, sample.levels[sample.first_level],
                                         planes_[0], planes_[1])
                     : nullptr;
#endif
    s_plane_.set(planes_[0], places);
    t_plane_.set(planes_[1], places);
    if (!q_is_one_ && !q_is_inv_w_) q_plane_.set(q, places);
  }

  // The texture's colours of halves of a row; w is that of the row's pixels.
  void sample(int row, Halves halves, const float* w, FragmentBatch& batch) {
#if HWY_TARGET <= HWY_AVX3
    // Three halves of four by themselves take longer than all of them.
    if (whole_row_ != nullptr && std::popcount(halves) >= 3) {
      const SampleLevel& level = unit_->sample.levels[unit_->sample.first_level];
      halves &= whole_row_(level, SplitRow(s_plane_, row), SplitRow(t_plane_, row), pixels_);
      if (halves == 0) return;
    }
#endif
    find_coordinates(row, halves, w);
    const uint32_t groups = groups_with(halves);
    if (sampler_[0] == nullptr) {
      for_each_group(groups, [&](int group) HWY_ATTR { sample_any(row, group, batch); });
    } else if (has_levels_) {
      levels_.set_row(*tile_, row);
      levels_.find(*primitive_, planes_, unit_->sample, *tile_, groups);
      sample_levels(halves, groups);
    } else {
      sampler_[0](unit_->sample.levels[unit_->sample.first_level], s_, t_, halves, pixels_);
    }
  }

  // Whether its texels are packed pixels; a colour that the chain's sampler found has more bits.
  bool has_pixels() const { return sampler_[0] != nullptr; }
  HWY_INLINE Pair<VecU> pixels(int group) const { return pixels_.load(group); }

  // Of a group that was sampled.
  HWY_INLINE Colour16 colour(int group) const {
    if (!has_pixels()) return colours_.load(group);
    Colour16 c;
    unpack_pixels(pixels(group), c.channel);
    for (Vec16& channel : c.channel) channel = from_unorm8(Tag16(), channel);
    return c;
  }

 private:
  static HWY_INLINE uint32_t groups_with(Halves halves) {
    uint32_t groups = 0;
    for (int group = 0; group < kRowGroups; ++group) {
      groups |= ((halves & halves_of_group(group)) != 0 ? 1u : 0u) << group;
    }
    return groups;
  }

  // The halves of some groups.
  static HWY_INLINE Halves halves_in(Halves halves, uint32_t groups) {
    Halves wanted = 0;
    for (; groups != 0; groups &= groups - 1) wanted |= halves_of_group(std::countr_zero(groups));
    return halves & wanted;
  }

  HWY_INLINE void find_coordinates(int row, Halves halves, const float* w) {
    const TagF d;
    for (; halves != 0; halves &= halves - 1) {
      const int i = std::countr_zero(halves) * (kGroup / 2);
      VecF ss = s_plane_.at(row, i), tt = t_plane_.at(row, i);
      if (!q_is_one_) {  // a division by one changes nothing
        const VecF reciprocal_q =
            q_is_inv_w_ ? hn::Load(d, w + i) : hn::Div(hn::Set(d, 1.0f), q_plane_.at(row, i));
        ss = hn::Mul(ss, reciprocal_q);
        tt = hn::Mul(tt, reciprocal_q);
      }
      hn::Store(ss, d, s_ + i);
      hn::Store(tt, d, t_ + i);
    }
  }

  HWY_INLINE void sample_key(int key, Halves halves, RowPixels& out) const {
    const SampleState& state = unit_->sample;
    sampler_[key & 1](state.levels[state.first_level + (key >> 1)], s_, t_, halves, out);
  }

  // Levels and filters that follow each quad's level of detail. Most rows have one.
  HWY_INLINE void sample_levels(Halves halves, uint32_t groups) {
    const int key = levels_.first_key(std::countr_zero(groups));
    uint32_t same = 0, between = 0;
    for_each_group(groups, [&](int group) HWY_ATTR {
      if (levels_.is_one_key(group, key)) same |= 1u << group;
      if (!hn::AllFalse(TagI(), levels_.between_levels(group))) between |= 1u << group;
    });
    if (same != 0) sample_key(key, halves_in(halves, same), pixels_);
    if ((same & between) != 0) sample_key(key + 2, halves_in(halves, same & between), next_);
    for_each_group(groups & ~same, [&](int group) HWY_ATTR {
      const VecI keys = levels_.keys(group);
      sample_keys(group, 0, hn::Eq(keys, keys), pixels_);
      sample_keys(group, 2, levels_.between_levels(group), next_);
    });
    for_each_group(between, [&](int group) HWY_ATTR {
      using sampling::HWY_NAMESPACE::lerp_pixels;
      const Pair<VecI> weight = QuadLevels::spread(levels_.weights(group));
      const Pair<VecU> c = pixels_.load(group), next = next_.load(group);
      pixels_.store({lerp_pixels(weight.lower, c.lower, next.lower),
                     lerp_pixels(weight.upper, c.upper, next.upper)},
                    group);
    });
  }

  // One pass for each distinct key of the wanted quads. What is not wanted is left as anything.
  HWY_NOINLINE void sample_keys(int group, int step, MaskI wanted, RowPixels& out) const {
    const TagI d;
    const TagU du;
    const VecI keys = levels_.keys(group);
    HWY_ALIGN int32_t key_of[kGroup / 2];
    hn::Store(keys, d, key_of);
    Pair<VecU> result = out.load(group);
    for (intptr_t i = hn::FindFirstTrue(d, wanted); i >= 0; i = hn::FindFirstTrue(d, wanted)) {
      sample_key(key_of[i] + step, halves_of_group(group), out);
      const Pair<VecU> pixels = out.load(group);
      const MaskI mine = hn::Eq(keys, hn::Set(d, key_of[i]));
      const Pair<VecI> mask = QuadLevels::spread(hn::VecFromMask(d, mine));
      const auto choose = [&](VecI is_mine, VecU yes, VecU no) HWY_ATTR {
        return hn::IfThenElse(hn::MaskFromVec(hn::BitCast(du, is_mine)), yes, no);
      };
      result = {choose(mask.lower, pixels.lower, result.lower),
                choose(mask.upper, pixels.upper, result.upper)};
      wanted = hn::AndNot(mine, wanted);
    }
    out.store(result, group);
  }

  // Through the program's sample function, on a batch of one group.
  HWY_NOINLINE void sample_any(int row, int group, FragmentBatch& batch) {
    const int column = group * kGroup;
    batch.count = kGroup;
    std::copy_n(s_ + column, kGroup, batch.s);
    std::copy_n(t_ + column, kGroup, batch.t);
    if (unit_->sample.needs_lod) {
      for (int i = 0; i < kGroup; ++i) {
        batch.offset[i] = static_cast<uint16_t>(row * kTileWidth + column + i);
      }
      level_of_detail(*primitive_, planes_, unit_->sample, *tile_, batch);
    }
    unit_->sample_function(unit_->sample, batch, index_);
    const TagI d;
    const hn::Rebind<int16_t, TagI> half;
    Colour16 c;
    for (int i = 0; i < 4; ++i) {
      const int16_t* values = batch.texture[index_][i];
      c.channel[i] = narrow({hn::PromoteTo(d, hn::Load(half, values)),
                             hn::PromoteTo(d, hn::Load(half, values + kGroup / 2))});
    }
    colours_.store(c, group);
  }

  const UnitProgram* unit_;
  const PrimitivePlanes* primitive_;
  const Plane* planes_;
  const Tile* tile_;
  int index_;
  bool q_is_one_, q_is_inv_w_, has_levels_;
#if HWY_TARGET <= HWY_AVX3
  WholeRow::Sampler whole_row_;  // null: texels are not close enough
#endif
  SplitPlane s_plane_, t_plane_, q_plane_;
  RowSampler sampler_[2];  // of the minification and the magnification filter
  alignas(64) float s_[kTileWidth], t_[kTileWidth];
  RowPixels pixels_, next_;  // next_: those of the next level
  RowColours colours_;       // sample_any's, in the fixed point of the stages
  QuadLevels levels_;
};

// Whether fragments of the primary colour get the texels of a simple environment's unit as they
// are, but for the bits that are set in `texel_bits`.
inline bool gives_texels(const Combiner& combiner, const PrimitivePlanes& planes,
                         uint32_t& texel_bits) {
  const auto is_one = [&](int c) { return planes.colour[c].value == float{kColourOne}; };
  const bool keeps_alpha = combiner.alpha == Combine::kReplace &&
                           combiner.alpha_argument[0].source == CombineSource::kPrevious;
  texel_bits = keeps_alpha ? 0xff000000u : 0;
  return planes.flat_colour &&
         (combiner.rgb == Combine::kReplace || (is_one(0) && is_one(1) && is_one(2))) &&
         ((combiner.alpha == Combine::kReplace && !keeps_alpha) || is_one(3));
}

// 3.7.12 for MODULATE and REPLACE of the unit's own texture.
HWY_INLINE void apply_simple_environment(const Combiner& combiner, const Colour16& texture,
                                         Colour16& colour) {
  for (int c = 0; c < 4; ++c) {
    if ((c < 3 ? combiner.rgb : combiner.alpha) == Combine::kModulate) {
      colour.channel[c] = combine<Combine::kModulate>(Tag16(), texture.channel[c],
                                                      colour.channel[c], colour.channel[c]);
    } else if (c < 3 || combiner.alpha_argument[0].source != CombineSource::kPrevious) {
      colour.channel[c] = texture.channel[c];
    }
  }
}

#endif  // HWY_TARGET != HWY_SCALAR

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
