// The state that sampling needs, taken from a texture unit once per program, and the choice of a
// kernel for the SIMD target in use (3.7.7 to 3.7.10).
// SPDX-License-Identifier: MIT
#include "pipeline/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fragment/sample.cpp"
#include "hwy/foreach_target.h"

#include "hwy/highway.h"
#include "pipeline/fragment/sample-inl.h"

#if HWY_ONCE
#include <algorithm>
#include <cstddef>

namespace clearpipe::pipeline {
namespace {

// What an absent image reads as: a texture that is not complete never gets here (3.7.10).
constexpr uint32_t kBlack = 0xff000000u;

bool has_texels(const ImageLevel& level) {
  return level.width > 0 && level.height > 0 &&
         level.texels.size() >=
             static_cast<size_t>(level.width) * static_cast<size_t>(level.height);
}

}  // namespace

SampleState make_sample_state(const TextureUnit& unit) {
  SampleState state;
  state.sampler = unit.sampler;
  const Sampler& sampler = state.sampler;
  state.first_level = std::clamp(sampler.base_level, 0, kMaxLevels - 1);
  state.last_level = state.first_level;
  state.levels[state.first_level] = {&kBlack, 1, 1};
  if (unit.image != nullptr) {
    const int stored =
        static_cast<int>(std::min(unit.image->levels.size(), static_cast<size_t>(kMaxLevels)));
    const int wanted = sampler.mip == MipFilter::kNone
                           ? state.first_level
                           : std::max(sampler.max_level, state.first_level);
    for (int i = state.first_level; i < stored && i <= wanted; ++i) {
      const ImageLevel& level = unit.image->levels[static_cast<size_t>(i)];
      if (!has_texels(level)) break;
      state.levels[i] = {level.texels.data(), level.width, level.height};
      state.last_level = i;
    }
  }
  state.needs_lod = sampler.min != sampler.mag || state.last_level > state.first_level ||
                    sampler.max_anisotropy > 1;
  state.lod_threshold = sampler.mag == Filter::kLinear && sampler.min == Filter::kNearest &&
                                sampler.mip != MipFilter::kNone
                            ? 0.5f
                            : 0.0f;
  return state;
}

namespace sampling {

HWY_EXPORT(choose_sample);

static SampleFunction dispatch(const SampleState& state) {
  return HWY_DYNAMIC_DISPATCH(choose_sample)(state);
}

}  // namespace sampling

SampleFunction select_sample_function(const SampleState& state) {
  return sampling::dispatch(state);
}

}  // namespace clearpipe::pipeline
#endif
