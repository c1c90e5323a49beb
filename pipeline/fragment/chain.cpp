// The chain: fragments of a primitive in a tile, gathered into batches, run through the stages one
// after another, and written back.
//
// A batch is filled with the runs of set bits of the coverage's rows, so that stored values are
// copied in and out a run at a time. Compiled once per SIMD target.
// SPDX-License-Identifier: MIT
#include "pipeline/fragment/chain.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "pipeline/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fragment/chain.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "pipeline/fragment/alpha_test-inl.h"
#include "pipeline/fragment/antialias-inl.h"
#include "pipeline/fragment/depth_stencil-inl.h"
#include "pipeline/fragment/fog-inl.h"
#include "pipeline/fragment/interpolate-inl.h"
#include "pipeline/fragment/texcoord-inl.h"
#include "pipeline/fragment/texenv-inl.h"
#include "pipeline/fragment/write-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct StageContext {
  const FragmentProgram& program;
  const PrimitivePlanes& planes;
  Tile& tile;
};

// The stages of stages.def.
namespace stage {

void smooth_coverage(const StageContext& context, FragmentBatch& batch, int) {
  fragment::HWY_NAMESPACE::smooth_coverage(context.planes.region, batch);
}

void interpolate_w(const StageContext& context, FragmentBatch& batch, int) {
  if (context.planes.perspective) fragment::HWY_NAMESPACE::interpolate_w(context.planes, batch);
}

void test_depth_stencil(const StageContext& context, FragmentBatch& batch, int) {
  const FragmentProgram& p = context.program;
  depth_stencil_stage(context.planes, p.stencil, {p.depth_test, p.depth_write, p.depth_func},
                      batch);
}

void interpolate_colour(const StageContext& context, FragmentBatch& batch, int) {
  fragment::HWY_NAMESPACE::interpolate_colour(context.planes, batch);
}

void sample_texture(const StageContext& context, FragmentBatch& batch, int unit) {
  const UnitProgram& u = context.program.unit[unit];
  const Plane* planes = context.planes.texture[unit];
  texture_coordinates(planes, batch);
  if (u.sample.needs_lod) {
    level_of_detail(context.planes, planes, u.sample, context.tile, batch);
  }
  u.sample_function(u.sample, batch, unit);
}

void texture_environment(const StageContext& context, FragmentBatch& batch, int unit) {
  const UnitProgram& u = context.program.unit[unit];
  fragment::HWY_NAMESPACE::texture_environment(u.combiner, u.constant, batch);
}

void fog(const StageContext& context, FragmentBatch& batch, int) {
  apply_fog(context.planes, fog_constants(context.program), batch);
}

void apply_coverage(const StageContext&, FragmentBatch& batch, int) {
  fragment::HWY_NAMESPACE::apply_coverage(batch);
}

void fade_point(const StageContext& context, FragmentBatch& batch, int) {
  fragment::HWY_NAMESPACE::fade_point(context.planes.point_fade, batch);
}

void alpha_test(const StageContext& context, FragmentBatch& batch, int) {
  fragment::HWY_NAMESPACE::alpha_test(context.program.alpha_func, context.program.alpha_reference,
                                      batch);
}

void pack_colour(const StageContext&, FragmentBatch& batch, int) {
  fragment::HWY_NAMESPACE::pack_colour(batch.previous, batch.count, batch.colour);
}

void blend(const StageContext& context, FragmentBatch& batch, int) {
  blend_stage(context.program.blend, batch);
}

void logic_op(const StageContext& context, FragmentBatch& batch, int) {
  logic_op_stage(context.program.logic_op, batch);
}

}  // namespace stage

using StageFunction = void (*)(const StageContext&, FragmentBatch&, int);

constexpr StageFunction kStages[] = {
#define FRAGMENT_STAGE(name) &stage::name,
#include "pipeline/fragment/stages.def"
#undef FRAGMENT_STAGE
};

// Gathers runs of pixels into a batch, and runs and writes it back when it is full.
class Chain {
 public:
  explicit Chain(const StageContext& context) : context_(context) {
    to_x_ = 0.5f - context.planes.x_ref;
    to_y_ = 0.5f - context.planes.y_ref;
    batch_.count = 0;
  }

  void add_run(int row, int column, int length) {
    while (length > 0) {
      const int part = std::min(length, kBatchSize - batch_.count);
      append(row, column, part);
      column += part;
      length -= part;
      if (batch_.count == kBatchSize) flush();
    }
  }

  void flush() {
    if (batch_.count == 0) return;
    pad();
    const FragmentProgram& program = context_.program;
    for (int i = 0; i < program.step_count; ++i) {
      const ChainStep& step = program.steps[i];
      kStages[static_cast<int>(step.stage)](context_, batch_, step.unit);
    }
    if (program.colour_mask != 0) mask_stage(program.colour_mask, batch_);
    write_back();
    batch_.count = 0;
    run_count_ = 0;
  }

 private:
  struct Run {
    uint16_t offset, length;
  };

  void append(int row, int column, int length) {
    const int at = batch_.count;
    const int offset = row * kTileWidth + column;
    // In the same order as the early depth test, so that both see the same depth.
    const float y = static_cast<float>(context_.tile.y + row) + to_y_;
    const int x = context_.tile.x + column;
    for (int i = 0; i < length; ++i) {
      batch_.x[at + i] = static_cast<float>(x + i) + to_x_;
      batch_.y[at + i] = y;
      batch_.offset[at + i] = static_cast<uint16_t>(offset + i);
      batch_.live[at + i] = -1;
    }
    std::memcpy(batch_.stored_colour + at, context_.tile.colour + offset, length * 4u);
    if (context_.program.uses_depth_stencil) {
      std::memcpy(batch_.stored_depth_stencil + at, context_.tile.depth_stencil + offset,
                  length * 4u);
    }
    runs_[run_count_++] = {static_cast<uint16_t>(offset), static_cast<uint16_t>(length)};
    batch_.count += length;
  }

  // Stages work on whole vectors: the places behind the last fragment repeat it.
  void pad() {
    const int last = batch_.count - 1;
    const int end = std::min((batch_.count + 63) / 64 * 64, kBatchSize);
    for (int i = batch_.count; i < end; ++i) {
      batch_.x[i] = batch_.x[last];
      batch_.y[i] = batch_.y[last];
      batch_.offset[i] = batch_.offset[last];
      batch_.live[i] = 0;
      batch_.stored_colour[i] = 0;
      batch_.stored_depth_stencil[i] = 0;
    }
  }

  void write_back() {
    const FragmentProgram& program = context_.program;
    int at = 0;
    for (int i = 0; i < run_count_; ++i) {
      const Run& run = runs_[i];
      if (program.colour_mask != 0) {
        std::memcpy(context_.tile.colour + run.offset, batch_.colour + at, run.length * 4u);
      }
      if (program.uses_depth_stencil) {
        std::memcpy(context_.tile.depth_stencil + run.offset, batch_.stored_depth_stencil + at,
                    run.length * 4u);
      }
      at += run.length;
    }
  }

  StageContext context_;
  float to_x_ = 0, to_y_ = 0;
  int run_count_ = 0;
  Run runs_[kBatchSize];
  FragmentBatch batch_;
};

void RunChain(const FragmentProgram& program, const PrimitivePlanes& planes,
              const Coverage& coverage, Tile& tile) {
  Coverage kept = coverage;
  if (program.early_depth) {
    early_depth(planes, {program.depth_test, program.depth_write, program.depth_func}, tile, kept);
  }
  if (program.step_count == 0) return;
  Chain chain({program, planes, tile});
  for (int row = kept.first_row; row < kept.last_row; ++row) {
    uint64_t bits = kept.rows[row];
    while (bits != 0) {
      const int first = std::countr_zero(bits);
      const int length = std::countr_one(bits >> first);
      chain.add_run(row, first, length);
      if (first + length == kTileWidth) break;
      bits &= ~uint64_t{0} << (first + length);
    }
  }
  chain.flush();
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace clearpipe::pipeline {
namespace fragment {

HWY_EXPORT(RunChain);

using RunChainFunction = void (*)(const FragmentProgram&, const PrimitivePlanes&, const Coverage&,
                                  Tile&);

static RunChainFunction resolve() {
  select_simd_target();
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return static_cast<RunChainFunction>(HWY_DYNAMIC_DISPATCH(RunChain));
}

}  // namespace fragment

void run_chain(const FragmentProgram& program, const PrimitivePlanes& planes,
               const Coverage& coverage, Tile& tile) {
  static const fragment::RunChainFunction function = fragment::resolve();
  function(program, planes, coverage, tile);
}

}  // namespace clearpipe::pipeline
#endif  // HWY_ONCE
