// The choice of a program for a fragment state: the stages it needs, in order, and their constants.
//
// The depth and stencil tests come after the alpha test (4.1.4 to 4.1.6), but nothing can be seen
// of their place when alpha discards nothing: then they come first, and what they discard is never
// textured. A depth test alone goes further and runs on whole rows of coverage.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "pipeline/fragment/chain.h"
#include "pipeline/fragment/fused.h"
#include "pipeline/fragment/small.h"
#include "pipeline/fragment/usage.h"

namespace clearpipe::pipeline {

namespace {

int16_t to_fixed(float v) {
  return static_cast<int16_t>(std::nearbyint(std::clamp(v, 0.0f, 1.0f) * float{kColourOne}));
}

uint32_t packed_mask(uint8_t components) {
  uint32_t mask = 0;
  for (int c = 0; c < 4; ++c) {
    if ((components >> c & 1) != 0) mask |= 0xffu << (8 * c);
  }
  return mask;
}

void set_fog(const FragmentState& state, FragmentProgram& program) {
  constexpr float kLog2E = 1.44269504f;
  program.fog_mode = state.fog;
  switch (state.fog) {
    case FogMode::kNone:
      return;
    case FogMode::kLinear: {
      // f = (end - c) / (end - start); with end = start the section leaves f undefined.
      const float range = state.fog_end - state.fog_start;
      program.fog_scale = range != 0 ? -1.0f / range : 0.0f;
      program.fog_offset = range != 0 ? state.fog_end / range : 1.0f;
      break;
    }
    case FogMode::kExp:
      program.fog_scale = state.fog_density * kLog2E;
      break;
    case FogMode::kExp2:
      program.fog_scale = state.fog_density * std::sqrt(kLog2E);
      break;
  }
  program.fog_colour[0] = to_fixed(state.fog_colour.x);
  program.fog_colour[1] = to_fixed(state.fog_colour.y);
  program.fog_colour[2] = to_fixed(state.fog_colour.z);
}

void set_unit(const TextureUnit& unit, UnitProgram& out) {
  out.sample = make_sample_state(unit);
  out.sample_function = select_sample_function(out.sample);
  out.combiner = unit.combiner;
  const float constant[4] = {unit.constant.x, unit.constant.y, unit.constant.z, unit.constant.w};
  std::transform(constant, constant + 4, out.constant, to_fixed);
}

// CLEARPIPE_FUSED=0 runs chains alone, to compare the two forms.
bool fused_allowed() {
  const char* text = std::getenv("CLEARPIPE_FUSED");
  return text == nullptr || std::strcmp(text, "0") != 0;
}

// Whether alpha decides what is tested against depth and stencil (4.1.3, 4.1.4).
bool discards_by_alpha(const FragmentProgram& program) {
  return program.alpha_test || program.alpha_to_coverage;
}

// Multisample fragment operations (4.1.3). As in the reference, sample s of n is in the coverage
// value v if s < floor(n * v): the section leaves the function open.
void set_multisample(const FragmentState& state, FragmentProgram& program) {
  program.samples_apart = true;
  program.alpha_to_coverage = state.alpha_to_coverage;
  program.alpha_to_one = state.alpha_to_one;
  if (!state.sample_coverage) return;
  const int covered = static_cast<int>(state.sample_coverage_value * kSampleCount);
  const uint32_t mask = (1u << covered) - 1;
  program.sample_mask = (state.sample_coverage_invert ? ~mask : mask) & kAllSamples;
}

// 4.1.7 to 4.1.9, and the conversion to what is stored.
void select_write_stages(const FragmentState& state, bool srgb, FragmentProgram& program) {
  const auto add = [&](FragmentStage stage) { program.steps[program.step_count++] = {stage, 0}; };
  const bool blends = state.blend.enabled && !state.logic_op_enabled;
  if (!srgb) {
    add(FragmentStage::pack_colour);
    if (blends) add(FragmentStage::blend);
  } else {
    add(blends ? FragmentStage::blend_srgb : FragmentStage::pack_srgb);
  }
  if (state.logic_op_enabled) add(FragmentStage::logic_op);
  if (program.format != ColourFormat::kRgba8) add(FragmentStage::truncate);
}

void select_stages(const FragmentState& state, FragmentCoverage coverage, bool srgb,
                   FragmentProgram& program) {
  const auto add = [&](FragmentStage stage, int unit = 0) {
    program.steps[program.step_count++] = {stage, static_cast<uint8_t>(unit)};
  };
  const bool tests = program.depth_test || program.stencil.enabled;
  const bool tests_in_chain = tests && !program.early_depth;
  program.uses_depth_stencil = tests_in_chain;
  const bool smooth = coverage == FragmentCoverage::kSmooth;
  if (smooth) add(FragmentStage::smooth_coverage);
  const bool tests_first = tests_in_chain && !discards_by_alpha(program);
  if (tests_first) add(FragmentStage::test_depth_stencil);

  const bool colour = program.colour_mask != 0;
  if (colour || discards_by_alpha(program)) {
    program.inputs.colour = true;
    add(FragmentStage::interpolate_w);
    add(FragmentStage::interpolate_colour);
    for (int u = 0; u < kMaxTextureUnits; ++u) {
      if (!state.unit[u].enabled) continue;
      program.inputs.texture_units |= static_cast<uint8_t>(1u << u);
      add(FragmentStage::sample_texture, u);
    }
    for (int u = 0; u < kMaxTextureUnits; ++u) {
      if (state.unit[u].enabled) add(FragmentStage::texture_environment, u);
    }
    if (state.fog != FogMode::kNone) {
      program.inputs.fog = true;
      add(FragmentStage::fog);
    }
    if (smooth) add(FragmentStage::apply_coverage);
    if (coverage == FragmentCoverage::kMultisamplePoint) add(FragmentStage::fade_point);
    if (program.alpha_to_coverage) add(FragmentStage::alpha_to_coverage);
    if (program.alpha_to_one) add(FragmentStage::alpha_to_one);
  }
  if (state.alpha_test) add(FragmentStage::alpha_test);
  if (tests_in_chain && !tests_first) add(FragmentStage::test_depth_stencil);
  if (colour) select_write_stages(state, srgb, program);
}

}  // namespace

FragmentProgram* make_fragment_program(const FragmentState& state, const FragmentTarget& target,
                                       FragmentCoverage coverage) {
  auto program = std::make_unique<FragmentProgram>();
  remake_fragment_program(*program, state, target, coverage);
  return program.release();
}

void remake_fragment_program(FragmentProgram& made, const FragmentState& state,
                             const FragmentTarget& target, FragmentCoverage coverage) {
  FragmentProgram* program = &made;
  static_cast<ProgramBase&>(*program) = {};
  program->depth_test = state.depth_test && target.has_depth;
  program->depth_write = program->depth_test && state.depth_write;
  program->depth_func = state.depth_func;
  program->depth_bits = target.depth_bits;
  program->format = target.format;
  program->srgb = target.srgb;
  program->inputs.depth = program->depth_test;
  program->stencil = state.stencil;
  program->stencil.enabled = state.stencil.enabled && target.has_stencil;
  program->alpha_test = state.alpha_test;
  if (is_multisample(coverage)) set_multisample(state, *program);
  // An antialiased fragment that covers nothing must not be tested, so its coverage comes first.
  program->early_depth = program->depth_test && !program->stencil.enabled &&
                         !discards_by_alpha(*program) && coverage != FragmentCoverage::kSmooth;
  program->antialiased = coverage == FragmentCoverage::kSmooth;
  program->alpha_func = state.alpha_func;
  program->alpha_reference = static_cast<int16_t>(std::nearbyint(state.alpha_reference * 255.0f));
  program->blend = state.blend;
  program->has_logic_op = state.logic_op_enabled;
  program->logic_op = state.logic_op;
  program->colour_mask = packed_mask(state.colour_mask);
  set_fog(state, *program);
  for (int u = 0; u < kMaxTextureUnits; ++u) {
    if (state.unit[u].enabled) set_unit(state.unit[u], program->unit[u]);
  }
  select_stages(state, coverage, target.srgb, *program);
  static const bool allowed = fused_allowed();
  const bool chain_only =
      target.multisampled || target.srgb || (program->depth_test && target.depth_bits == 32) ||
      std::any_of(state.unit.begin(), state.unit.end(),
                  [](const TextureUnit& unit) { return unit.enabled && (unit.cube || unit.srgb); });
  if (allowed && !chain_only) {
    if (!program->antialiased) select_fused(*program);
    program->batches_small = (program->inputs.texture_units >> kSmallUnits) == 0;
  }
  program->usage = usage_of(*program);
}

bool batches_small(const FragmentProgram& program) { return program.batches_small; }

bool writes_primitive_colours(const FragmentProgram& program) {
  return program.colour_mask == 0xffffffffu && !program.blend.enabled && !program.has_logic_op &&
         (program.early_depth || !program.uses_depth_stencil) &&
         program.inputs.texture_units == 0 && program.fog_mode == FogMode::kNone &&
         !program.alpha_test && !program.srgb && !program.antialiased;
}

bool shades_strips(const FragmentProgram& program) { return program.fits_strips; }

void destroy_fragment_program(FragmentProgram* program) { delete program; }

FragmentInputs fragment_inputs(const FragmentProgram& program) { return program.inputs; }

FragmentOutputs fragment_outputs(const FragmentProgram& program) {
  const bool stencil = program.stencil.enabled;
  const bool discards = program.alpha_test || program.antialiased || program.alpha_to_coverage ||
                        program.sample_mask != kAllSamples;
  FragmentOutputs outputs;
  outputs.colour = program.colour_mask != 0;
  outputs.depth_stencil_read = program.depth_test || stencil;
  const uint32_t depth_bits = program.depth_bits == 32 ? 0xffffffffu : 0xffffff00u;
  outputs.depth_stencil_write = (program.depth_write ? depth_bits : 0) | (stencil ? 0xffu : 0);
  outputs.replaces = program.colour_mask == 0xffffffffu && !outputs.depth_stencil_read &&
                     !discards && !program.blend.enabled && !program.has_logic_op;
  outputs.solid = outputs.replaces && !program.srgb && program.inputs.texture_units == 0 &&
                  program.fog_mode == FogMode::kNone;
  DepthRule& depth = outputs.depth;
  depth.test = program.depth_test && program.depth_bits != 32;
  depth.write = program.depth_write;
  depth.discards = discards || stencil;
  depth.traceless = !stencil;
  depth.func = program.depth_func;
  if (program.depth_bits == 16) depth.one = 65535.0f;
  return outputs;
}

uint32_t solid_pixel(const FragmentProgram& program, const PrimitivePlanes& planes) {
  // As interpolate-inl.h and colour-inl.h round.
  uint32_t pixel = 0;
  for (int c = 0; c < 4; ++c) {
    const float value = planes.colour[c].value;
    const float clamped = std::min(value > 0 ? value : 0.0f, float{kColourOne});
    const auto colour = static_cast<uint32_t>(std::nearbyint(clamped));
    pixel |= ((colour + 1) * 1020 + 16384) >> 15 << (8 * c);
  }
  return truncate(program.format, pixel);
}

void shade(const FragmentProgram& program, const PrimitivePlanes& planes, const Coverage& coverage,
           Tile& tile) {
  if (program.fused != nullptr) {
    program.fused(program, planes, coverage, tile);
  } else {
    run_chain(program, planes, coverage, tile);
  }
}

}  // namespace clearpipe::pipeline
