// Batches sampled by the samplers of rows: two rows of them, each fragment with a level of its own.
// SPDX-License-Identifier: MIT
#include "pipeline/simd.h"

#include <algorithm>
#include <cstdint>

#include "pipeline/fragment/sample.h"

#if defined(CLEARPIPE_PIPELINE_FRAGMENT_SAMPLE_BATCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_PIPELINE_FRAGMENT_SAMPLE_BATCH_INL_H
#undef CLEARPIPE_PIPELINE_FRAGMENT_SAMPLE_BATCH_INL_H
#else
#define CLEARPIPE_PIPELINE_FRAGMENT_SAMPLE_BATCH_INL_H
#endif

#include "hwy/highway.h"
#include "pipeline/fragment/row_sampler-inl.h"
#include "pipeline/fragment/sample_colours-inl.h"
#include "pipeline/fragment/sample_level-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::sampling {
namespace HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR

using fragment::HWY_NAMESPACE::for_each_group;
using fragment::HWY_NAMESPACE::Halves;
using fragment::HWY_NAMESPACE::halves_of_group;
using fragment::HWY_NAMESPACE::kGroup;
using fragment::HWY_NAMESPACE::kRowGroups;
using fragment::HWY_NAMESPACE::MaskI;
using fragment::HWY_NAMESPACE::Pair;
using fragment::HWY_NAMESPACE::RowPixels;
using fragment::HWY_NAMESPACE::RowSampler;
using fragment::HWY_NAMESPACE::Tag16;
using fragment::HWY_NAMESPACE::TagU;
using fragment::HWY_NAMESPACE::Vec16;
using fragment::HWY_NAMESPACE::VecI;
using fragment::HWY_NAMESPACE::VecU;

class BatchRow {
 public:
  // Fragments of the batch from `first` on.
  BatchRow(const SampleState& state, const RowSampler* samplers, const FragmentBatch& batch,
           int first)
      : state_(state), samplers_(samplers), s_(batch.s + first), t_(batch.t + first) {
    const int count = std::min(batch.count - first, kTileWidth);
    halves_ = (Halves{1} << ((count + kHalf - 1) / kHalf)) - 1;
  }

  void sample_one_level() {
    samplers_[0](state_.levels[state_.first_level], s_, t_, halves_, pixels_);
  }

  // Levels and filters that follow each fragment's level of detail.
  void sample_levels(const BatchChoice& choices, const int32_t* keys, const int32_t* weights) {
    if (choices.same_key) {
      sample_key(keys[0], halves_, pixels_);
      if (!choices.two_levels) return;
      sample_key(keys[0] + 2, halves_, next_);
    }
    for (int group = 0; group < kRowGroups; ++group) {
      if ((halves_ & halves_of_group(group)) == 0) continue;
      if (!choices.same_key) sample_group(group, keys, weights);
      const Pair<VecU> c = pixels_.load(group), next = next_.load(group);
      const VecI lower = hn::Load(TagInt(), weights + group * kGroup);
      pixels_.store({lerp_pixels(lower, c.lower, next.lower),
                     lerp_pixels(upper(group, weights), c.upper, next.upper)},
                    group);
    }
  }

  // The colours of the row's fragments, in the fixed point of the stages.
  void store(int16_t (*out)[kBatchSize], int first) const {
    const Tag16 d;
    for (int group = 0; group < kRowGroups; ++group) {
      if ((halves_ & halves_of_group(group)) == 0) continue;
      Vec16 channels[4];
      fragment::HWY_NAMESPACE::unpack_pixels(pixels_.load(group), channels);
      for (int i = 0; i < 4; ++i) {
        const Vec16 channel = fragment::HWY_NAMESPACE::from_unorm8(d, channels[i]);
        hn::Store(fragment::HWY_NAMESPACE::in_order(channel), d, out[i] + first + group * kGroup);
      }
    }
  }

 private:
  static constexpr int kHalf = kGroup / 2;

  bool has_upper(int group) const {
    return (halves_ & halves_of_group(group)) == halves_of_group(group);
  }

  // Values of the upper half of a group; of one that is not looked at, 0.
  HWY_INLINE VecI upper(int group, const int32_t* values) const {
    const TagInt d;
    return has_upper(group) ? hn::Load(d, values + group * kGroup + kHalf) : hn::Zero(d);
  }

  HWY_INLINE void sample_key(int key, Halves halves, RowPixels& out) const {
    samplers_[key & 1](state_.level(state_.first_level + (key >> 1)), s_, t_, halves, out);
  }

  // Each fragment of a group from the level of its key, and where it has a weight the next one.
  void sample_group(int group, const int32_t* keys, const int32_t* weights) {
    const TagInt d;
    const VecI zero = hn::Zero(d);
    const auto between = [&](VecI w) HWY_ATTR { return hn::Gt(w, zero); };
    const MaskI all = hn::Eq(zero, zero);
    const VecI low = hn::Load(d, weights + group * kGroup), high = upper(group, weights);
    sample_keys(group, keys, 0, all, has_upper(group) ? all : hn::Not(all), pixels_);
    sample_keys(group, keys, 2, between(low), between(high), next_);
  }

  // One pass for each distinct key of the wanted fragments. What is not wanted is left as anything.
  HWY_NOINLINE void sample_keys(int group, const int32_t* keys, int step, MaskI low, MaskI high,
                                RowPixels& out) const {
    const TagInt d;
    const TagU du;
    keys += group * kGroup;
    const VecI low_keys = hn::Load(d, keys);
    const VecI high_keys = hn::AllFalse(d, high) ? hn::Zero(d) : hn::Load(d, keys + kHalf);
    Pair<VecU> result = out.load(group);
    while (true) {
      intptr_t i = hn::FindFirstTrue(d, low);
      if (i < 0) {
        i = hn::FindFirstTrue(d, high);
        if (i < 0) break;
        i += kHalf;
      }
      const VecI key = hn::Set(d, keys[i]);
      sample_key(keys[i] + step, halves_ & halves_of_group(group), out);
      const Pair<VecU> pixels = out.load(group);
      const MaskI low_mine = hn::Eq(low_keys, key), high_mine = hn::Eq(high_keys, key);
      result.lower = hn::IfThenElse(hn::RebindMask(du, low_mine), pixels.lower, result.lower);
      result.upper = hn::IfThenElse(hn::RebindMask(du, high_mine), pixels.upper, result.upper);
      low = hn::AndNot(low_mine, low);
      high = hn::AndNot(high_mine, high);
    }
    out.store(result, group);
  }

  const SampleState& state_;
  const RowSampler* samplers_;
  const float *s_, *t_;
  Halves halves_;
  RowPixels pixels_, next_;  // next_: those of the next level
};

template <bool kLevels>
void sample_rows(const SampleState& state, FragmentBatch& batch, int unit) {
  static_assert(kBatchSize % kTileWidth == 0);
  using fragment::HWY_NAMESPACE::row_sampler;
  const RowSampler samplers[2] = {row_sampler(state.min), row_sampler(state.mag)};
  BatchChoice choices;
  if constexpr (kLevels) choose_levels<false>(state, batch, choices);
  for (int first = 0; first < batch.count; first += kTileWidth) {
    BatchRow row(state, samplers, batch, first);
    if constexpr (kLevels) {
      row.sample_levels(choices, choices.key + first, choices.weight + first);
    } else {
      row.sample_one_level();
    }
    row.store(batch.texture[unit], first);
  }
}

#endif  // HWY_TARGET != HWY_SCALAR

}  // namespace HWY_NAMESPACE
}  // namespace clearpipe::pipeline::sampling
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
