// The inside of a fragment program: the stages that select.cpp chose and the constants they use.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "pipeline/fragment/batch.h"
#include "pipeline/fragment/program.h"
#include "pipeline/fragment/sample.h"
#include "pipeline/state.h"

namespace clearpipe::pipeline {

enum class FragmentStage : uint8_t {
#define FRAGMENT_STAGE(name) name,
#include "pipeline/fragment/stages.def"
#undef FRAGMENT_STAGE
};

struct ChainStep {
  FragmentStage stage = FragmentStage::pack_colour;
  uint8_t unit = 0;  // of texture stages
};

struct UnitProgram {
  SampleState sample;
  SampleFunction sample_function = nullptr;
  FusedSampler fused_min = FusedSampler::kAny, fused_mag = FusedSampler::kAny;
  Combiner combiner;
  bool simple_environment = false;  // MODULATE or REPLACE of the unit's own texture
  int16_t constant[4] = {};
};

// The fused form (fused.h), which shades whole tiles by itself.
using FusedFunction = void (*)(const FragmentProgram& program, const PrimitivePlanes& planes,
                               const Coverage& coverage, Tile& tile);

struct UsageEntry;

// A program but for its texture units, which are large and mostly not in use.
struct ProgramBase {
  FusedFunction fused = nullptr;  // null: the chain
  bool batches_small = false;     // see small.h
  bool fits_strips = false;       // a textured one whose fused form may shade in strips
  UsageEntry* usage = nullptr;    // where its pixels count (usage.h)
  FragmentInputs inputs;
  std::array<ChainStep, 15 + 2 * kMaxTextureUnits> steps;
  int step_count = 0;

  bool early_depth = false;  // the depth test runs on rows, before batches are filled
  bool depth_test = false, depth_write = false;
  int depth_bits = 24;
  CompareFunc depth_func = CompareFunc::kAlways;
  StencilState stencil;
  bool uses_depth_stencil = false;  // the chain reads and writes the stored values
  bool antialiased = false;         // a fragment's coverage may be less than one, or nothing
  bool alpha_test = false;
  CompareFunc alpha_func = CompareFunc::kAlways;
  int16_t alpha_reference = 0;  // 0 to 255
  FogMode fog_mode = FogMode::kNone;
  float fog_scale = 0, fog_offset = 0;
  int16_t fog_colour[3] = {};
  BlendState blend;
  bool has_logic_op = false;
  LogicOp logic_op = LogicOp::kCopy;
  bool srgb = false;                   // colours are written sRGB-encoded
  uint32_t colour_mask = 0xffffffffu;  // bits of a packed colour that may change
  ColourFormat format = ColourFormat::kRgba8;
  // On a multisampled target.
  bool samples_apart = false;  // the samples are at their places, not all at the centre
  bool alpha_to_coverage = false, alpha_to_one = false;
  uint8_t sample_mask = kAllSamples;  // bit s: sample s may be covered (SAMPLE_COVERAGE)
};

struct FragmentProgram : ProgramBase {
  std::array<UnitProgram, kMaxTextureUnits> unit;  // set for those in inputs.texture_units
};

// Runs the program over the coverage with the SIMD target in use.
void run_chain(const FragmentProgram& program, const PrimitivePlanes& planes,
               const Coverage& coverage, Tile& tile);

}  // namespace clearpipe::pipeline
