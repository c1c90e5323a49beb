// The chain for multisampled targets: a fragment is shaded once, at the pixel's centre (3.2.1), and
// its samples are tested, blended and written each by itself (4.1.10). Compiled once per SIMD
// target.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>

#include "pipeline/fragment/chain.h"
#include "pipeline/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fragment/sample_chain.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "pipeline/fragment/early_tests-inl.h"
#include "pipeline/fragment/gather-inl.h"
#include "pipeline/fragment/stages-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The depth of the samples: each at its place, or all at the centre where the fragment's coverage
// was found there (3.2.1).
struct SampleDepths {
  Plane plane[kSampleCount];

  SampleDepths(const FragmentProgram& program, const PrimitivePlanes& planes) {
    for (int s = 0; s < kSampleCount; ++s) {
      plane[s] =
          program.samples_apart ? plane_at_sample(planes.depth, kSamplePlaces[s]) : planes.depth;
    }
  }
};

class SampleChain {
 public:
  SampleChain(const FragmentProgram& program, const PrimitivePlanes& planes,
              const SampleDepths& depths, Tile* tiles)
      : context_{program, planes, tiles[0]},
        depths_(depths),
        tiles_(tiles),
        gathered_(planes, tiles[0]) {}

  void add_run(const Coverage* coverage, int row, int column, int length) {
    while (length > 0) {
      const int at = gathered_.batch().count;
      const int taken = gathered_.append(row, column, length);
      for (int s = 0; s < kSampleCount; ++s) {
        const uint64_t bits = coverage[s].rows[row] >> column;
        int16_t* live = gathered_.batch().sample_live[s] + at;
        for (int i = 0; i < taken; ++i) live[i] = static_cast<int16_t>(-(bits >> i & 1));
      }
      column += taken;
      length -= taken;
      if (gathered_.full()) flush();
    }
  }

  void flush() {
    if (gathered_.empty()) return;
    gathered_.pad();
    for (auto& live : gathered_.batch().sample_live) {
      std::fill(live + gathered_.batch().count, live + kBatchSize, int16_t{0});
    }
    run_stages();
    gathered_.clear();
  }

 private:
  void run_stages() {
    const FragmentProgram& program = context_.program;
    FragmentBatch& batch = gathered_.batch();
    const ChainStep* combine = nullptr;  // with the stored colour
    for (int i = 0; i < program.step_count; ++i) {
      const ChainStep& step = program.steps[i];
      if (step.stage == FragmentStage::blend || step.stage == FragmentStage::blend_srgb ||
          step.stage == FragmentStage::logic_op) {
        combine = &step;
      } else if (step.stage == FragmentStage::truncate) {
        continue;  // after the above
      } else if (step.stage == FragmentStage::test_depth_stencil) {
        if (!test_samples()) return;
      } else {
        run_stage(context_, step, batch);
      }
    }
    if (program.colour_mask != 0) write_samples(combine);
  }

  // Samples of fragments that are discarded die.
  void discard_samples() {
    const hn::ScalableTag<int16_t> d;
    FragmentBatch& batch = gathered_.batch();
    for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
      const auto live = hn::Load(d, batch.live + i);
      for (auto& sample : batch.sample_live) {
        hn::Store(hn::And(hn::Load(d, sample + i), live), d, sample + i);
      }
    }
  }

  // False when no sample passes.
  bool test_samples() {
    discard_samples();
    const FragmentProgram& program = context_.program;
    FragmentBatch& batch = gathered_.batch();
    int16_t any = 0;
    for (int s = 0; s < kSampleCount; ++s) {
      gathered_.load(tiles_[s].depth_stencil, batch.stored_depth_stencil);
      int16_t* live = batch.sample_live[s];
      depth_stencil_stage(depths_.plane[s], program.stencil, depth_state(program), batch, live);
      gathered_.store(batch.stored_depth_stencil, tiles_[s].depth_stencil);
      for (int i = 0; i < batch.count; ++i) any = static_cast<int16_t>(any | live[i]);
    }
    return any != 0;
  }

  void write_samples(const ChainStep* combine) {
    discard_samples();
    FragmentBatch& batch = gathered_.batch();
    alignas(64) uint32_t source[kBatchSize];
    std::memcpy(source, batch.colour, sizeof(source));
    for (int s = 0; s < kSampleCount; ++s) {
      gathered_.load(tiles_[s].colour, batch.stored_colour);
      std::memcpy(batch.colour, source, sizeof(source));
      if (combine != nullptr) run_stage(context_, *combine, batch);
      if (context_.program.format != ColourFormat::kRgba8) {
        truncate_stage(context_.program.format, batch);
      }
      mask_stage(context_.program.colour_mask, batch, batch.sample_live[s]);
      gathered_.store(batch.colour, tiles_[s].colour);
    }
  }

  StageContext context_;
  const SampleDepths& depths_;
  Tile* tiles_;
  GatheredBatch gathered_;
};

// SAMPLE_COVERAGE and the early depth test take samples away. What is left then has the same range
// of rows for each sample; false when nothing is.
bool KeepSamples(const FragmentProgram& program, const PrimitivePlanes& planes,
                 const SampleDepths& depths, Tile* tiles, Coverage* coverage) {
  int first = kTileHeight, last = 0;
  for (int s = 0; s < kSampleCount; ++s) {
    Coverage& kept = coverage[s];
    if ((program.sample_mask >> s & 1) == 0) kept.last_row = kept.first_row;
    if (program.early_depth) {
      test_early(program, planes, depths.plane[s], tiles[s], kept);
    }
    if (kept.first_row == kept.last_row) kept.first_row = kept.last_row = 0;
    if (kept.last_row != 0) first = std::min(first, kept.first_row);
    last = std::max(last, kept.last_row);
  }
  for (int s = 0; s < kSampleCount && first < last; ++s) {
    Coverage& kept = coverage[s];
    std::fill(kept.rows + first, kept.rows + std::max(first, kept.first_row), uint64_t{0});
    std::fill(kept.rows + std::max(first, kept.last_row), kept.rows + last, uint64_t{0});
    kept.first_row = first;
    kept.last_row = last;
  }
  return first < last;
}

void RunSampleChain(const FragmentProgram& program, const PrimitivePlanes& planes,
                    const Coverage* coverage, Tile* tiles) {
  const SampleDepths depths(program, planes);
  Coverage kept[kSampleCount];
  std::copy_n(coverage, kSampleCount, kept);
  if (!KeepSamples(program, planes, depths, tiles, kept) || program.step_count == 0) return;
  SampleChain chain(program, planes, depths, tiles);
  for (int row = kept[0].first_row; row < kept[0].last_row; ++row) {
    uint64_t any = 0;
    for (const Coverage& sample : kept) any |= sample.rows[row];
    for_each_run(row, any,
                 [&](int r, int column, int length) { chain.add_run(kept, r, column, length); });
  }
  chain.flush();
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace clearpipe::pipeline {
namespace fragment {

HWY_EXPORT(RunSampleChain);

using RunSampleChainFunction = void (*)(const FragmentProgram&, const PrimitivePlanes&,
                                        const Coverage*, Tile*);

static RunSampleChainFunction resolve() {
  select_simd_target();
  return static_cast<RunSampleChainFunction>(HWY_DYNAMIC_DISPATCH(RunSampleChain));
}

}  // namespace fragment

void shade_samples(const FragmentProgram& program, const PrimitivePlanes& planes,
                   const Coverage coverage[kSampleCount], Tile tiles[kSampleCount]) {
  static const fragment::RunSampleChainFunction function = fragment::resolve();
  function(program, planes, coverage, tiles);
}

}  // namespace clearpipe::pipeline
#endif  // HWY_ONCE
