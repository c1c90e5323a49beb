// Texture filtering on one SIMD target (3.7.7 to 3.7.9): texels of a level fetched and weighted for
// a vector of fragments, and the level of detail chosen per fragment. Axes are in
// sample_axis-inl.h.
//
// Two arithmetics exist. With REPEAT and CLAMP_TO_EDGE, weights have 8 fraction bits and every
// interpolation rounds to 8 bits. When an axis mirrors (kFine), weights have 15 bits and
// colours 13. SPDX-License-Identifier: MIT
#include "pipeline/simd.h"

#include <cstdint>

#include "pipeline/fragment/sample.h"

#if defined(CLEARPIPE_PIPELINE_FRAGMENT_SAMPLE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_PIPELINE_FRAGMENT_SAMPLE_INL_H
#undef CLEARPIPE_PIPELINE_FRAGMENT_SAMPLE_INL_H
#else
#define CLEARPIPE_PIPELINE_FRAGMENT_SAMPLE_INL_H
#endif

#include "hwy/highway.h"
#include "pipeline/fragment/sample_axis-inl.h"
#include "pipeline/fragment/sample_colours-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::sampling {
namespace HWY_NAMESPACE {

HWY_INLINE VecInt gather(const SampleLevel& level, VecInt index) {
  return hn::GatherIndex(TagInt(), reinterpret_cast<const int32_t*>(level.texels), index);
}

// Texels of a row at `first` and `second`. Where every second texel follows its first one, both come
// with one 64-bit load.
struct TexelPair {
  VecInt first, second;
};

HWY_INLINE TexelPair gather_apart(const SampleLevel& level, VecInt first, VecInt second) {
  return {gather(level, first), gather(level, second)};
}

HWY_INLINE TexelPair gather_adjacent(const SampleLevel& level, VecInt first) {
#if HWY_TARGET == HWY_SCALAR
  return gather_apart(level, first, hn::Add(first, hn::Set(TagInt(), 1)));
#else
  const TagInt di;
  const hn::Half<TagInt> dh;
  const hn::RepartitionToWide<TagInt> dw;
  const auto* base = reinterpret_cast<const int64_t*>(level.texels);
  const auto low = hn::ShiftLeft<2>(hn::PromoteTo(dw, hn::LowerHalf(dh, first)));
  const auto high = hn::ShiftLeft<2>(hn::PromoteTo(dw, hn::UpperHalf(dh, first)));
  const VecInt a = hn::BitCast(di, hn::GatherOffset(dw, base, low));
  const VecInt b = hn::BitCast(di, hn::GatherOffset(dw, base, high));
  return {hn::ConcatEven(di, b, a), hn::ConcatOdd(di, b, a)};
#endif
}

template <class Axes, bool kFine>
HWY_INLINE Colours sample_nearest(const Axes& axes, const SampleLevel& level, VecFloat s,
                                  VecFloat t) {
  const VecInt x = axes.nearest_s(s, level.width);
  const VecInt y = axes.nearest_t(t, level.height);
  const VecInt row = hn::Mul(y, hn::Set(TagInt(), level.width));
  const Colours c = unpack(gather(level, hn::Add(row, x)));
  if constexpr (kFine) {
    return widen(c);
  } else {
    return c;
  }
}

// 3.7.8: tau = (1-a)(1-b) t00 + a(1-b) t10 + (1-a)b t01 + ab t11, as three interpolations.
template <class Axes, bool kFine>
HWY_INLINE Colours sample_linear(const Axes& axes, const SampleLevel& level, VecFloat s,
                                 VecFloat t) {
  const LinearAxis x = axes.linear_s(s, level.width);
  const LinearAxis y = axes.linear_t(t, level.height);
  const VecInt width = hn::Set(TagInt(), level.width);
  const VecInt row0 = hn::Mul(y.first, width);
  const VecInt row1 = hn::Mul(y.second, width);
  TexelPair bottom, top;
  const auto adjacent = hn::Eq(x.second, hn::Add(x.first, hn::Set(TagInt(), 1)));
  if (HWY_LIKELY(hn::AllTrue(TagInt(), adjacent))) {
    bottom = gather_adjacent(level, hn::Add(row0, x.first));
    top = gather_adjacent(level, hn::Add(row1, x.first));
  } else {
    bottom = gather_apart(level, hn::Add(row0, x.first), hn::Add(row0, x.second));
    top = gather_apart(level, hn::Add(row1, x.first), hn::Add(row1, x.second));
  }
  Colours c00 = unpack(bottom.first);
  Colours c10 = unpack(bottom.second);
  Colours c01 = unpack(top.first);
  Colours c11 = unpack(top.second);
  if constexpr (kFine) {
    c00 = widen(c00);
    c10 = widen(c10);
    c01 = widen(c01);
    c11 = widen(c11);
  }
  const Weight a = spread(x.weight);
  const Weight b = spread(y.weight);
  return lerp<kFine>(b, lerp<kFine>(a, c00, c10), lerp<kFine>(a, c01, c11));
}

template <bool kFine>
HWY_INLINE void store(const Colours& c, FragmentBatch& batch, int unit, size_t i) {
  if constexpr (kFine) {
    store_colours(c, batch.texture[unit], i);
  } else {
    store_colours(widen(c), batch.texture[unit], i);
  }
}

// One level and one filter for the whole batch.
template <class Axes, bool kFine, bool kLinear>
void sample_one_level(const SampleState& state, FragmentBatch& batch, int unit) {
  const TagFloat df;
  const Axes axes(state);
  const SampleLevel level = state.levels[state.first_level];
  const size_t count = static_cast<size_t>(batch.count);
  for (size_t i = 0; i < count; i += hn::Lanes(df)) {
    const VecFloat s = hn::Load(df, batch.s + i);
    const VecFloat t = hn::Load(df, batch.t + i);
    if constexpr (kLinear) {
      store<kFine>(sample_linear<Axes, kFine>(axes, level, s, t), batch, unit, i);
    } else {
      store<kFine>(sample_nearest<Axes, kFine>(axes, level, s, t), batch, unit, i);
    }
  }
}

// Where a fragment samples: key is 2 * (level - first_level), plus 1 for the magnification filter;
// weight is that of the next level, zero when it is not needed.
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
    level = hn::ConvertTo(di, hn::Floor(hn::Add(lambda, hn::Set(df, 0.5f))));
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

// Samples the fragments of `wanted`, one pass for each distinct key among them. A fragment's result
// depends on its own key alone.
template <class Axes, bool kFine>
HWY_NOINLINE Colours sample_keys(const SampleState& state, const Axes& axes, VecInt key,
                                 hn::Mask<TagInt> wanted, VecFloat s, VecFloat t) {
  const TagInt di;
  HWY_ALIGN int32_t keys[hn::MaxLanes(TagInt())];
  hn::Store(key, di, keys);
  Colours result = no_colours();
  for (intptr_t i = hn::FindFirstTrue(di, wanted); i >= 0; i = hn::FindFirstTrue(di, wanted)) {
    const int32_t k = keys[i];
    const SampleLevel& level = state.levels[state.first_level + (k >> 1)];
    const Filter filter = (k & 1) != 0 ? state.sampler.mag : state.sampler.min;
    const Colours c = filter == Filter::kLinear ? sample_linear<Axes, kFine>(axes, level, s, t)
                                                : sample_nearest<Axes, kFine>(axes, level, s, t);
    const auto mine = hn::Eq(key, hn::Set(di, k));
    result = select(mine, c, result);
    wanted = hn::AndNot(mine, wanted);
  }
  return result;
}

// Levels and filters that follow each fragment's level of detail.
template <class Axes, bool kFine>
void sample_levels(const SampleState& state, FragmentBatch& batch, int unit) {
  const TagFloat df;
  const TagInt di;
  const Axes axes(state);
  const auto all = hn::Eq(hn::Zero(di), hn::Zero(di));
  const size_t count = static_cast<size_t>(batch.count);
  for (size_t i = 0; i < count; i += hn::Lanes(df)) {
    const VecFloat s = hn::Load(df, batch.s + i);
    const VecFloat t = hn::Load(df, batch.t + i);
    const LevelChoice choice = choose_level<kFine>(state, hn::Load(df, batch.lod + i));
    Colours c = sample_keys<Axes, kFine>(state, axes, choice.key, all, s, t);
    const auto both = hn::Gt(choice.weight, hn::Zero(di));
    if (!hn::AllFalse(di, both)) {
      const VecInt next = hn::Add(choice.key, hn::Set(di, 2));
      const Colours other = sample_keys<Axes, kFine>(state, axes, next, both, s, t);
      c = lerp<kFine>(spread(choice.weight), c, other);
    }
    store<kFine>(c, batch, unit, i);
  }
}

template <class Axes, bool kFine>
SampleFunction choose_filter(const SampleState& state) {
  if (state.needs_lod) return sample_levels<Axes, kFine>;
  return state.sampler.min == Filter::kLinear ? sample_one_level<Axes, kFine, true>
                                              : sample_one_level<Axes, kFine, false>;
}

template <WrapKind kS>
SampleFunction choose_wrap_t(const SampleState& state, WrapKind t) {
  switch (t) {
    case WrapKind::kRepeatPowerOfTwo:
      return choose_filter<FixedAxes<kS, WrapKind::kRepeatPowerOfTwo>, false>(state);
    case WrapKind::kRepeatOther:
      return choose_filter<FixedAxes<kS, WrapKind::kRepeatOther>, false>(state);
    default:
      return choose_filter<FixedAxes<kS, WrapKind::kClampToEdge>, false>(state);
  }
}

// The kernel of a sampler on this target.
SampleFunction choose_sample(const SampleState& state) {
  const SampleLevel& level = state.levels[state.first_level];
  const WrapKind s = wrap_kind(state.sampler.wrap_s, level.width);
  const WrapKind t = wrap_kind(state.sampler.wrap_t, level.height);
  if (s == WrapKind::kMirroredRepeat || t == WrapKind::kMirroredRepeat) {
    return choose_filter<MirroredAxes, true>(state);
  }
  switch (s) {
    case WrapKind::kRepeatPowerOfTwo:
      return choose_wrap_t<WrapKind::kRepeatPowerOfTwo>(state, t);
    case WrapKind::kRepeatOther:
      return choose_wrap_t<WrapKind::kRepeatOther>(state, t);
    default:
      return choose_wrap_t<WrapKind::kClampToEdge>(state, t);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace clearpipe::pipeline::sampling
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
