// The chain: fragments of a primitive in a tile, gathered into batches, run through the stages one
// after another, and written back. Compiled once per SIMD target.
// SPDX-License-Identifier: MIT
#include "pipeline/fragment/chain.h"

#include "pipeline/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fragment/chain.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "pipeline/fragment/early_tests-inl.h"
#include "pipeline/fragment/gather-inl.h"
#include "pipeline/fragment/stages-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {

class Chain {
 public:
  Chain(const FragmentProgram& program, const PrimitivePlanes& planes, Tile& tile)
      : context_{program, planes, tile}, tile_(tile), gathered_(planes, tile) {}

  void add_run(int row, int column, int length) {
    while (length > 0) {
      const int taken = gathered_.append(row, column, length);
      column += taken;
      length -= taken;
      if (gathered_.full()) flush();
    }
  }

  void flush() {
    if (gathered_.empty()) return;
    const FragmentProgram& program = context_.program;
    FragmentBatch& batch = gathered_.batch();
    gathered_.load(tile_.colour, batch.stored_colour);
    if (program.uses_depth_stencil) {
      gathered_.load(tile_.depth_stencil, batch.stored_depth_stencil);
    }
    gathered_.pad();
    for (int i = 0; i < program.step_count; ++i) run_stage(context_, program.steps[i], batch);
    if (program.colour_mask != 0) {
      mask_stage(program.colour_mask, batch, batch.live);
      gathered_.store(batch.colour, tile_.colour);
    }
    if (program.uses_depth_stencil) {
      gathered_.store(batch.stored_depth_stencil, tile_.depth_stencil);
    }
    gathered_.clear();
  }

 private:
  StageContext context_;
  Tile& tile_;
  GatheredBatch gathered_;
};

void RunChain(const FragmentProgram& program, const PrimitivePlanes& planes,
              const Coverage& coverage, Tile& tile) {
  Coverage kept = coverage;
  if (program.early_depth) test_early(program, planes, planes.depth, tile, kept);
  if (program.step_count == 0) return;
  Chain chain(program, planes, tile);
  for (int row = kept.first_row; row < kept.last_row; ++row) {
    for_each_run(row, kept.rows[row],
                 [&](int r, int column, int length) { chain.add_run(r, column, length); });
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
