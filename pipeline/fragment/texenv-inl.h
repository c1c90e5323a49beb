// The texture environment as a combiner (3.7.12, tables 3.17 to 3.19): one function of up to three
// arguments for the colours, one for alpha.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_TEXENV_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_TEXENV_INL_H_
#undef CLEARPIPE_FRAGMENT_TEXENV_INL_H_
#else
#define CLEARPIPE_FRAGMENT_TEXENV_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <iterator>

#include "pipeline/fragment/batch.h"
#include "pipeline/fragment/colour-inl.h"
#include "pipeline/state.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// An argument of a combiner for one channel: a batch array or a constant, perhaps one minus it.
struct CombinerInput {
  const int16_t* values;  // null: the constant
  int16_t constant;
  bool complement;

  template <class D>
  HWY_INLINE hn::Vec<D> load(D d, int i) const {
    const auto v = values != nullptr ? hn::Load(d, values + i) : hn::Set(d, constant);
    return complement ? hn::Sub(hn::Set(d, kColourOne), v) : v;
  }
};

inline CombinerInput combiner_input(const CombineArgument& argument, int channel,
                                    const int16_t* constant, const FragmentBatch& batch) {
  const bool alpha = argument.operand == CombineOperand::kAlpha ||
                     argument.operand == CombineOperand::kOneMinusAlpha;
  const int from = alpha ? 3 : channel;
  const bool complement = argument.operand == CombineOperand::kOneMinusColour ||
                          argument.operand == CombineOperand::kOneMinusAlpha;
  switch (argument.source) {
    case CombineSource::kConstant:
      return {nullptr, constant[from], complement};
    case CombineSource::kPrimaryColour:
      return {batch.primary[from], 0, complement};
    case CombineSource::kPrevious:
      return {batch.previous[from], 0, complement};
    default:
      return {batch.texture[static_cast<int>(argument.source)][from], 0, complement};
  }
}

// Arg - 1/2.
template <class D, class V>
HWY_INLINE V centred(D d, V v) {
  return hn::Sub(v, hn::Set(d, kColourOne / 2));
}

template <Combine kCombine, class D, class V = hn::Vec<D>>
HWY_INLINE V combine(D d, V a0, V a1, V a2) {
  const V one = hn::Set(d, kColourOne);
  if constexpr (kCombine == Combine::kReplace) {
    return a0;
  } else if constexpr (kCombine == Combine::kModulate) {
    return multiply(a0, a1);
  } else if constexpr (kCombine == Combine::kAdd) {
    return hn::Add(a0, a1);
  } else if constexpr (kCombine == Combine::kAddSigned) {
    return centred(d, hn::Add(a0, a1));
  } else if constexpr (kCombine == Combine::kInterpolate) {
    return hn::Add(multiply(a0, a2), multiply(a1, hn::Sub(one, a2)));
  } else if constexpr (kCombine == Combine::kModulateAdd) {
    return hn::Add(multiply(a0, a2), a1);
  } else {
    return hn::Sub(a0, a1);
  }
}

// Scale by 1, 2 or 4 and clamp: clamping to 1/scale first keeps the product in range.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V scale_and_clamp(D d, V v, int scale_log2) {
  v = hn::Min(hn::Max(v, hn::Zero(d)), hn::Set(d, static_cast<int16_t>(kColourOne >> scale_log2)));
  if (scale_log2 == 1) return hn::ShiftLeft<1>(v);
  if (scale_log2 == 2) return hn::ShiftLeft<2>(v);
  return v;
}

inline bool reads_primary_colour(const Combiner& combiner) {
  const auto reads = [](const CombineArgument& argument) {
    return argument.source == CombineSource::kPrimaryColour;
  };
  return std::any_of(std::begin(combiner.rgb_argument), std::end(combiner.rgb_argument), reads) ||
         std::any_of(std::begin(combiner.alpha_argument), std::end(combiner.alpha_argument), reads);
}

// A unit's environment with the places of its arguments in a batch: those of each channel.
struct BoundEnvironment {
  Combine rgb_function, alpha_function;
  uint8_t rgb_scale_log2, alpha_scale_log2;
  CombinerInput channel[4][3];
};

// One function for the channels [from, to), one after another.
template <Combine kCombine>
void combine_channels(const BoundEnvironment& e, int from, int to, int first, int end,
                      int16_t (*out)[kBatchSize]) {
  const hn::ScalableTag<int16_t> d;
  constexpr int kArguments = argument_count(kCombine);
  const int scale_log2 = from == 3 ? e.alpha_scale_log2 : e.rgb_scale_log2;
  for (int c = from; c < to; ++c) {
    const CombinerInput* in = e.channel[c];
    const CombinerInput a0 = in[0], a1 = in[kArguments > 1 ? 1 : 0],
                        a2 = in[kArguments > 2 ? 2 : 0];
    for (int i = first; i < end; i += static_cast<int>(hn::Lanes(d))) {
      const auto v0 = a0.load(d, i);
      const auto v1 = kArguments > 1 ? a1.load(d, i) : v0;
      const auto v2 = kArguments > 2 ? a2.load(d, i) : v0;
      hn::Store(scale_and_clamp(d, combine<kCombine>(d, v0, v1, v2), scale_log2), d, out[c] + i);
    }
  }
}

inline BoundEnvironment bind_environment(const Combiner& combiner, const int16_t* constant,
                                         const FragmentBatch& batch) {
  BoundEnvironment e;
  e.rgb_function = combiner.rgb;
  e.alpha_function = combiner.alpha;
  e.rgb_scale_log2 = combiner.rgb_scale_log2;
  e.alpha_scale_log2 = combiner.alpha_scale_log2;
  for (int k = 0; k < 3; ++k) {
    for (int c = 0; c < 3; ++c) {
      e.channel[c][k] = combiner_input(combiner.rgb_argument[k], c, constant, batch);
    }
    e.channel[3][k] = combiner_input(combiner.alpha_argument[k], 3, constant, batch);
  }
  return e;
}

// 4 * ((r0-1/2)(r1-1/2) + (g0-1/2)(g1-1/2) + (b0-1/2)(b1-1/2)) in every channel written, before the
// scales, of which alpha has its own.
inline void combine_dot3(const BoundEnvironment& e, int first, int end, int channels,
                         int16_t (*out)[kBatchSize]) {
  const hn::ScalableTag<int16_t> d;
  for (int i = first; i < end; i += static_cast<int>(hn::Lanes(d))) {
    auto sum = hn::Zero(d);
    for (int c = 0; c < 3; ++c) {
      sum = hn::Add(sum, multiply(centred(d, e.channel[c][0].load(d, i)),
                                  centred(d, e.channel[c][1].load(d, i))));
    }
    const auto v = scale_and_clamp(d, sum, 2);
    for (int c = 0; c < channels; ++c) {
      const int scale_log2 = c == 3 ? e.alpha_scale_log2 : e.rgb_scale_log2;
      hn::Store(scale_and_clamp(d, v, scale_log2), d, out[c] + i);
    }
  }
}

inline void combine_channels(Combine function, const BoundEnvironment& e, int from, int to,
                             int first, int end, int16_t (*out)[kBatchSize]) {
  switch (function) {
    case Combine::kReplace:
      return combine_channels<Combine::kReplace>(e, from, to, first, end, out);
    case Combine::kModulate:
      return combine_channels<Combine::kModulate>(e, from, to, first, end, out);
    case Combine::kAdd:
      return combine_channels<Combine::kAdd>(e, from, to, first, end, out);
    case Combine::kAddSigned:
      return combine_channels<Combine::kAddSigned>(e, from, to, first, end, out);
    case Combine::kInterpolate:
      return combine_channels<Combine::kInterpolate>(e, from, to, first, end, out);
    case Combine::kModulateAdd:
      return combine_channels<Combine::kModulateAdd>(e, from, to, first, end, out);
    default:
      return combine_channels<Combine::kSubtract>(e, from, to, first, end, out);
  }
}

// The unit's environment over the fragments [first, end), whole vectors: `previous` becomes its
// result. Colours come before alpha, because they may read the previous alpha.
inline void run_environment(const BoundEnvironment& e, int first, int end,
                            int16_t (*previous)[kBatchSize]) {
  if (e.rgb_function == Combine::kDot3Rgba) {
    combine_dot3(e, first, end, 4, previous);
    return;
  }
  const bool alike = e.rgb_function == e.alpha_function && e.rgb_scale_log2 == e.alpha_scale_log2;
  if (e.rgb_function == Combine::kDot3Rgb) {
    combine_dot3(e, first, end, 3, previous);
  } else {
    combine_channels(e.rgb_function, e, 0, alike ? 4 : 3, first, end, previous);
  }
  if (!alike) combine_channels(e.alpha_function, e, 3, 4, first, end, previous);
}

// The same of a whole batch.
inline void texture_environment(const Combiner& combiner, const int16_t* constant,
                                FragmentBatch& batch) {
  run_environment(bind_environment(combiner, constant, batch), 0, batch.count, batch.previous);
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
