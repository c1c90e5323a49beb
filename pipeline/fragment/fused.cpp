// The fused loops of fused.def on every SIMD target, and the choice among them.
// SPDX-License-Identifier: MIT
#include "pipeline/fragment/fused.h"

#include "pipeline/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fragment/fused.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "pipeline/fragment/fused-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {

// The loop for a pair of samplers on this target; one lane at a time is the chain's business.
FusedFunction FindFused(FusedSampler sampler0, FusedSampler sampler1) {
#if HWY_TARGET != HWY_SCALAR
#define FUSED_LOOP(s0, s1)                                            \
  if (sampler0 == FusedSampler::s0 && sampler1 == FusedSampler::s1) { \
    return run_fused<FusedSampler::s0, FusedSampler::s1>;             \
  }
#include "pipeline/fragment/fused.def"
#undef FUSED_LOOP
#else
  (void)sampler0;
  (void)sampler1;
#endif
  return nullptr;
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace clearpipe::pipeline {
namespace fragment {

HWY_EXPORT(FindFused);

static FusedFunction find(FusedSampler sampler0, FusedSampler sampler1) {
  select_simd_target();
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return HWY_DYNAMIC_DISPATCH(FindFused)(sampler0, sampler1);
}

}  // namespace fragment

namespace {

bool is_power_of_two(int v) { return (v & (v - 1)) == 0; }

FusedSampler sampler_of(const SampleState& state) {
  const SampleLevel& level = state.levels[state.first_level];
  const Sampler& sampler = state.sampler;
  if (state.needs_lod || sampler.wrap_s != sampler.wrap_t) return FusedSampler::kAny;
  const bool linear = sampler.mag == Filter::kLinear;
  if (sampler.wrap_s == Wrap::kClampToEdge) {
    return linear ? FusedSampler::kLinearClamp : FusedSampler::kNearestClamp;
  }
  if (sampler.wrap_s == Wrap::kRepeat && is_power_of_two(level.width) &&
      is_power_of_two(level.height)) {
    return linear ? FusedSampler::kLinearRepeat : FusedSampler::kNearestRepeat;
  }
  return FusedSampler::kAny;
}

bool is(const CombineArgument& argument, int source, CombineOperand operand) {
  return static_cast<int>(argument.source) == source && argument.operand == operand;
}

// Whether a function of the combiner is what MODULATE or REPLACE makes of a texture: the product of
// the previous colour and the texture's, or one of both.
bool is_simple(Combine function, const std::array<CombineArgument, 3>& argument, int unit,
               CombineOperand operand, bool may_keep) {
  const int previous = static_cast<int>(CombineSource::kPrevious);
  if (function == Combine::kModulate) {
    return is(argument[0], previous, operand) && is(argument[1], unit, operand);
  }
  return function == Combine::kReplace &&
         (is(argument[0], unit, operand) || (may_keep && is(argument[0], previous, operand)));
}

bool has_simple_environment(const Combiner& combiner, int unit) {
  return combiner.rgb_scale_log2 == 0 && combiner.alpha_scale_log2 == 0 &&
         is_simple(combiner.rgb, combiner.rgb_argument, unit, CombineOperand::kColour, false) &&
         is_simple(combiner.alpha, combiner.alpha_argument, unit, CombineOperand::kAlpha, true);
}

}  // namespace

FusedFunction select_fused(const FragmentProgram& program) {
  if (program.has_logic_op) return nullptr;
  FusedSampler sampler[2] = {FusedSampler::kNone, FusedSampler::kNone};
  if (program.inputs.texture_units > 3 || program.inputs.texture_units == 2) return nullptr;
  for (int unit = 0; unit < 2; ++unit) {
    if ((program.inputs.texture_units >> unit & 1) == 0) continue;
    if (!has_simple_environment(program.unit[unit].combiner, unit)) return nullptr;
    sampler[unit] = sampler_of(program.unit[unit].sample);
  }
  if (const FusedFunction found = fragment::find(sampler[0], sampler[1])) return found;
  for (FusedSampler& s : sampler) {
    if (s != FusedSampler::kNone) s = FusedSampler::kAny;
  }
  return fragment::find(sampler[0], sampler[1]);
}

}  // namespace clearpipe::pipeline
#endif  // HWY_ONCE
