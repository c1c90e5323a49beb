// The fused loops on every SIMD target, and the choice of what they call.
// SPDX-License-Identifier: MIT
#include "pipeline/fragment/fused.h"

#include <algorithm>

#include "pipeline/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fragment/fused.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "pipeline/fragment/fused-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {

// The loop on this target; one lane at a time is the chain's business.
FusedFunction FindFused(bool textured) {
#if HWY_TARGET != HWY_SCALAR
  return textured ? run_fused<true> : run_fused<false>;
#else
  (void)textured;
  return nullptr;
#endif
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace clearpipe::pipeline {
namespace fragment {

HWY_EXPORT(FindFused);

static FusedFunction find(bool textured) {
  select_simd_target();
  return HWY_DYNAMIC_DISPATCH(FindFused)(textured);
}

}  // namespace fragment

namespace {

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

// Whether nothing but texturing by samples of rows and simple environments makes the colours.
bool fits_strips(const FragmentProgram& program) {
  const unsigned units = program.inputs.texture_units;
  if (units == 0 || units >> kStripUnits != 0 || program.alpha_test ||
      program.fog_mode != FogMode::kNone) {
    return false;
  }
  return std::all_of(program.unit.begin(), program.unit.begin() + kStripUnits,
                     [&](const UnitProgram& unit) {
                       return (units >> (&unit - program.unit.data()) & 1) == 0 ||
                              (unit.simple_environment && !unit.sample.needs_lod &&
                               unit.fused_min != FusedSampler::kAny);
                     });
}

}  // namespace

void select_fused(FragmentProgram& program) {
  for (int u = 0; u < kMaxTextureUnits; ++u) {
    if ((program.inputs.texture_units >> u & 1) == 0) continue;
    UnitProgram& unit = program.unit[u];
    if (unit.sample.sampler.max_anisotropy <= 1) {
      unit.fused_min = unit.sample.min;
      unit.fused_mag = unit.sample.mag;
    }
    unit.simple_environment = has_simple_environment(unit.combiner, u);
  }
  program.fused = fragment::find(program.inputs.texture_units != 0);
  program.fits_strips = program.fused != nullptr && fits_strips(program);
}

}  // namespace clearpipe::pipeline
#endif  // HWY_ONCE
