// The choice of levels and filters by the level of detail (3.7.7, 3.7.8) on one SIMD target.
// SPDX-License-Identifier: MIT
#include "pipeline/simd.h"

#include <cstddef>
#include <cstdint>

#include "pipeline/fragment/sample.h"

#if defined(CLEARPIPE_PIPELINE_FRAGMENT_SAMPLE_LEVEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_PIPELINE_FRAGMENT_SAMPLE_LEVEL_INL_H
#undef CLEARPIPE_PIPELINE_FRAGMENT_SAMPLE_LEVEL_INL_H
#else
#define CLEARPIPE_PIPELINE_FRAGMENT_SAMPLE_LEVEL_INL_H
#endif

#include "hwy/highway.h"
#include "pipeline/fragment/sample_axis-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::sampling {
namespace HWY_NAMESPACE {

// Where a fragment samples: key as sample.h says; weight is that of the next level, zero when it is
// not needed.
struct LevelChoice {
  VecInt key, weight;
};

// 3.7.7 and 3.7.8: lambda = lod + bias; magnified when lambda <= c; else the nearest level, or two.
template <bool kFine>
HWY_INLINE LevelChoice choose_level(const SampleState& state, VecFloat lod) {
  const TagFloat df;
  const TagInt di;
  const VecFloat limit = hn::Set(df, 64.0f);
  VecFloat lambda = hn::Add(lod, hn::Set(df, state.sampler.lod_bias));
  lambda = hn::Max(hn::Min(number_or_zero(lambda), limit), hn::Neg(limit));
  const VecInt last = hn::Set(di, state.last_level - state.first_level);
  VecInt level = hn::Zero(di);
  VecInt weight = hn::Zero(di);
  if (state.sampler.mip == MipFilter::kNearest) {
    // Halfway between levels: up without a bias, to the even level with one.
    level = state.sampler.lod_bias == 0.0f
                ? hn::ConvertTo(di, hn::Floor(hn::Add(lambda, hn::Set(df, 0.5f))))
                : round_to_int(lambda);
    level = hn::Min(hn::Max(level, hn::Zero(di)), last);
  } else if (state.sampler.mip == MipFilter::kLinear) {
    const VecFloat whole = hn::Floor(lambda);
    level = hn::ConvertTo(di, whole);
    weight = fraction_weight<kFine>(hn::Sub(lambda, whole));
    const auto between = hn::And(hn::Gt(level, hn::Set(di, -1)), hn::Lt(level, last));
    weight = hn::IfThenElseZero(between, weight);
    level = hn::Min(hn::Max(level, hn::Zero(di)), last);
  }
  VecInt key = hn::Add(level, level);
  if (state.sampler.min != state.sampler.mag) {
    const auto magnified = hn::RebindMask(di, hn::Le(lambda, hn::Set(df, state.lod_threshold)));
    key = hn::IfThenElse(magnified, hn::Set(di, 1), key);
    weight = hn::IfThenZeroElse(magnified, weight);
  }
  return {key, weight};
}

// What choose_level gives for a batch.
struct BatchChoice {
  HWY_ALIGN int32_t key[kBatchSize];
  HWY_ALIGN int32_t weight[kBatchSize];
  bool same_key = true;     // one key for the whole batch
  bool two_levels = false;  // some weight is not zero
};

template <bool kFine>
HWY_INLINE void choose_levels(const SampleState& state, const FragmentBatch& batch,
                              BatchChoice& choices) {
  const TagFloat df;
  const TagInt di;
  const size_t count = static_cast<size_t>(batch.count);
  const bool cube = state.is_cube();
  for (size_t i = 0; i < count; i += hn::Lanes(df)) {
    LevelChoice choice = choose_level<kFine>(state, hn::Load(df, batch.lod + i));
    if (cube) choice.key = hn::Add(choice.key, hn::Load(di, batch.face + i));
    hn::Store(choice.key, di, choices.key + i);
    hn::Store(choice.weight, di, choices.weight + i);
    if (!hn::AllTrue(di, hn::Eq(choice.key, hn::Set(di, choices.key[0])))) {
      choices.same_key = false;
    }
    if (!hn::AllTrue(di, hn::Eq(choice.weight, hn::Zero(di)))) choices.two_levels = true;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace clearpipe::pipeline::sampling
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
