// Texture filtering on one SIMD target (3.7.7 to 3.7.9): texels of a level fetched and weighted for
// a vector of fragments, and the level of detail chosen per fragment. Axes are in
// sample_axis-inl.h.
//
// Two arithmetics exist. With REPEAT and CLAMP_TO_EDGE, weights have 8 fraction bits and every
// interpolation rounds to 8 bits; but for the one-lane target, the samplers of rows have that
// (sample_row-inl.h). When an axis mirrors, or colours are sRGB-encoded (kFine),
// weights have 15 bits and colours 13. SPDX-License-Identifier: MIT
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
#include "pipeline/fragment/anisotropic-inl.h"
#include "pipeline/fragment/sample_axis-inl.h"
#include "pipeline/fragment/sample_batch-inl.h"
#include "pipeline/fragment/sample_colours-inl.h"
#include "pipeline/fragment/sample_level-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::sampling {
namespace HWY_NAMESPACE {

HWY_INLINE VecInt gather(const SampleLevel& level, VecInt index) {
  return hn::GatherIndex(TagInt(), reinterpret_cast<const int32_t*>(level.texels), index);
}

// Two neighbouring texels of a row for each lane.
struct TexelPair {
  VecInt first, second;
};

#if HWY_TARGET != HWY_SCALAR
// By one load of 64 bits a lane: half as many as two gathers make.
HWY_INLINE TexelPair gather_neighbours(const SampleLevel& level, VecInt index) {
  const TagInt di;
  const hn::Repartition<int64_t, TagInt> wide;
  const hn::Half<TagInt> half;
  const auto* base = reinterpret_cast<const int64_t*>(level.texels);
  const VecInt offset = hn::ShiftLeft<2>(index);
  const VecInt lower = hn::BitCast(
      di, hn::GatherOffset(wide, base, hn::PromoteTo(wide, hn::LowerHalf(half, offset))));
  const VecInt upper = hn::BitCast(
      di, hn::GatherOffset(wide, base, hn::PromoteTo(wide, hn::UpperHalf(half, offset))));
  return {hn::ConcatEven(di, upper, lower), hn::ConcatOdd(di, upper, lower)};
}
#endif

// The texels of a row, given the index of its first.
HWY_INLINE TexelPair gather_pair(const SampleLevel& level, VecInt row, const LinearAxis& x,
                                 [[maybe_unused]] bool neighbours) {
#if HWY_TARGET != HWY_SCALAR
  if (neighbours) return gather_neighbours(level, hn::Add(row, x.first));
#endif
  return {gather(level, hn::Add(row, x.first)), gather(level, hn::Add(row, x.second))};
}

// Texels as the colours that are interpolated.
template <class Axes, bool kFine>
HWY_INLINE Colours colours_of(const Axes& axes, VecInt texels) {
  if constexpr (Axes::kSrgb) {
    return decode(axes.decode, texels);
  } else if constexpr (kFine) {
    return widen(unpack(texels));
  } else {
    return unpack(texels);
  }
}

template <class Axes, bool kFine>
HWY_INLINE Colours sample_nearest(const Axes& axes, const SampleLevel& level, VecFloat s,
                                  VecFloat t) {
  const VecInt x = axes.nearest_s(s, level.width);
  const VecInt y = axes.nearest_t(t, level.height);
  const VecInt row = hn::Mul(y, hn::Set(TagInt(), level.width));
  return colours_of<Axes, kFine>(axes, gather(level, hn::Add(row, x)));
}

// 3.7.8: tau = (1-a)(1-b) t00 + a(1-b) t10 + (1-a)b t01 + ab t11, as three interpolations.
template <class Axes, bool kFine>
HWY_INLINE Colours sample_linear(const Axes& axes, const SampleLevel& level, VecFloat s,
                                 VecFloat t) {
  const LinearAxis x = axes.linear_s(s, level.width);
  const LinearAxis y = axes.linear_t(t, level.height);
  const VecInt width = hn::Set(TagInt(), level.width);
  // Only at the edges of the level is the second texel not the first one's neighbour.
  const VecInt next = hn::Add(x.first, hn::Set(TagInt(), 1));
  const bool neighbours = hn::AllTrue(TagInt(), hn::Eq(x.second, next));
  const TexelPair row0 = gather_pair(level, hn::Mul(y.first, width), x, neighbours);
  const TexelPair row1 = gather_pair(level, hn::Mul(y.second, width), x, neighbours);
  const Colours c00 = colours_of<Axes, kFine>(axes, row0.first);
  const Colours c10 = colours_of<Axes, kFine>(axes, row0.second);
  const Colours c01 = colours_of<Axes, kFine>(axes, row1.first);
  const Colours c11 = colours_of<Axes, kFine>(axes, row1.second);
  const Weight a = spread<kFine>(x.weight);
  const Weight b = spread<kFine>(y.weight);
  return lerp(b, lerp(a, c00, c10), lerp(a, c01, c11));
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
    const SampleLevel& level = state.level(state.first_level + (k >> 1));
    const Filter filter = (k & 1) != 0 ? state.sampler.mag : state.sampler.min;
    const Colours c = filter == Filter::kLinear ? sample_linear<Axes, kFine>(axes, level, s, t)
                                                : sample_nearest<Axes, kFine>(axes, level, s, t);
    const auto mine = hn::Eq(key, hn::Set(di, k));
    result = select(mine, c, result);
    wanted = hn::AndNot(mine, wanted);
  }
  return result;
}

// The whole batch on one level, or between it and the next.
template <class Axes, bool kFine, bool kLinear>
HWY_NOINLINE void sample_same_key(const SampleState& state, const BatchChoice& choices,
                                  FragmentBatch& batch, int unit) {
  const TagFloat df;
  const TagInt di;
  const Axes axes(state);
  const int first = state.first_level + (choices.key[0] >> 1);
  const SampleLevel levels[2] = {state.level(first),
                                 state.level(choices.two_levels ? first + 1 : first)};
  const size_t count = static_cast<size_t>(batch.count);
  for (size_t i = 0; i < count; i += hn::Lanes(df)) {
    const VecFloat s = hn::Load(df, batch.s + i);
    const VecFloat t = hn::Load(df, batch.t + i);
    Colours c = kLinear ? sample_linear<Axes, kFine>(axes, levels[0], s, t)
                        : sample_nearest<Axes, kFine>(axes, levels[0], s, t);
    if (choices.two_levels) {
      const Colours other = kLinear ? sample_linear<Axes, kFine>(axes, levels[1], s, t)
                                    : sample_nearest<Axes, kFine>(axes, levels[1], s, t);
      c = lerp(spread<kFine>(hn::Load(di, choices.weight + i)), c, other);
    }
    store<kFine>(c, batch, unit, i);
  }
}

// Levels and filters that follow each fragment's level of detail.
template <class Axes, bool kFine>
void sample_levels(const SampleState& state, FragmentBatch& batch, int unit) {
  const TagFloat df;
  const TagInt di;
  if (batch.count <= 0) return;
  BatchChoice choices;
  choose_levels<kFine>(state, batch, choices);
  if (choices.same_key) {
    const bool magnified = (choices.key[0] & 1) != 0;
    const Filter filter = magnified ? state.sampler.mag : state.sampler.min;
    if (filter == Filter::kLinear) {
      sample_same_key<Axes, kFine, true>(state, choices, batch, unit);
    } else {
      sample_same_key<Axes, kFine, false>(state, choices, batch, unit);
    }
    return;
  }
  const Axes axes(state);
  const auto all = hn::Eq(hn::Zero(di), hn::Zero(di));
  const size_t count = static_cast<size_t>(batch.count);
  for (size_t i = 0; i < count; i += hn::Lanes(df)) {
    const VecFloat s = hn::Load(df, batch.s + i);
    const VecFloat t = hn::Load(df, batch.t + i);
    const VecInt key = hn::Load(di, choices.key + i);
    const VecInt weight = hn::Load(di, choices.weight + i);
    Colours c = sample_keys<Axes, kFine>(state, axes, key, all, s, t);
    const auto both = hn::Gt(weight, hn::Zero(di));
    if (!hn::AllFalse(di, both)) {
      const VecInt next = hn::Add(key, hn::Set(di, 2));
      const Colours other = sample_keys<Axes, kFine>(state, axes, next, both, s, t);
      c = lerp(spread<kFine>(weight), c, other);
    }
    store<kFine>(c, batch, unit, i);
  }
}

template <class Axes, bool kFine>
SampleFunction choose_filter(const SampleState& state) {
  if (state.sampler.max_anisotropy > 1) return sample_anisotropic<sample_levels<Axes, kFine>>;
  if (state.needs_lod || state.is_cube()) return sample_levels<Axes, kFine>;
  return state.sampler.min == Filter::kLinear ? sample_one_level<Axes, kFine, true>
                                              : sample_one_level<Axes, kFine, false>;
}

#if HWY_TARGET == HWY_SCALAR
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

// A sampler that is one of fused.def.
inline SampleFunction choose_row_sampler(const SampleState& state) {
  const SampleLevel& level = state.levels[state.first_level];
  const WrapKind t = wrap_kind(state.sampler.wrap_t, level.height);
  switch (wrap_kind(state.sampler.wrap_s, level.width)) {
    case WrapKind::kRepeatPowerOfTwo:
      return choose_wrap_t<WrapKind::kRepeatPowerOfTwo>(state, t);
    case WrapKind::kRepeatOther:
      return choose_wrap_t<WrapKind::kRepeatOther>(state, t);
    default:
      return choose_wrap_t<WrapKind::kClampToEdge>(state, t);
  }
}
#else
inline SampleFunction choose_row_sampler(const SampleState& state) {
  if (state.sampler.max_anisotropy > 1) return sample_anisotropic<sample_rows<true>>;
  return state.needs_lod || state.is_cube() ? sample_rows<true> : sample_rows<false>;
}
#endif

// The kernel of a sampler on this target.
inline SampleFunction choose_sample(const SampleState& state) {
  if (state.decode != nullptr) return choose_filter<SrgbAxes, true>(state);
  if (state.min == FusedSampler::kAny) return choose_filter<MirroredAxes, true>(state);
  return choose_row_sampler(state);
}

}  // namespace HWY_NAMESPACE
}  // namespace clearpipe::pipeline::sampling
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
