// The state that sampling needs, taken from a texture unit once per program, and the choice of a
// kernel for the SIMD target in use (3.7.7 to 3.7.10).
// SPDX-License-Identifier: MIT
#include "pipeline/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fragment/sample.cpp"
#include "hwy/foreach_target.h"

#include "hwy/highway.h"
#include "pipeline/fragment/sample-inl.h"
#include "pipeline/fragment/sample_row-inl.h"
#include "pipeline/srgb.h"

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

// The levels of a face (0 for an image that is no cube map) from `first` to the last that is there,
// which is returned, but not beyond `wanted`.
int take_levels(const Image* image, int face, int first, int wanted, SampleLevel* out) {
  out[first] = {&kBlack, 1, 1};
  const size_t start = static_cast<size_t>(face) * kMaxLevels;
  int last = first;
  for (int i = first; i <= wanted; ++i) {
    const size_t index = start + static_cast<size_t>(i);
    if (image == nullptr || index >= image->levels.size()) break;
    const ImageLevel& level = image->levels[index];
    if (!has_texels(level)) break;
    out[i] = {level.texels.data(), level.width, level.height};
    last = i;
  }
  return last;
}

// The sampler of fused.def for one of the filters. It does not decode sRGB.
FusedSampler sampler_of(const SampleState& state, Filter filter) {
  const SampleLevel& level = state.levels[state.first_level];
  const WrapKind s = wrap_kind(state.sampler.wrap_s, level.width);
  const WrapKind t = wrap_kind(state.sampler.wrap_t, level.height);
  if (state.decode != nullptr) return FusedSampler::kAny;
#define FUSED_SAMPLER(f, wrap_s, wrap_t)                                                \
  if (filter == Filter::k##f && s == WrapKind::k##wrap_s && t == WrapKind::k##wrap_t) { \
    return FusedSampler::k##f##wrap_s##wrap_t;                                          \
  }
#include "pipeline/fragment/fused.def"
  return FusedSampler::kAny;
}

}  // namespace

SampleState make_sample_state(const TextureUnit& unit) {
  SampleState state;
  state.sampler = unit.sampler;
  const Sampler& sampler = state.sampler;
  state.first_level = std::clamp(sampler.base_level, 0, kMaxLevels - 1);
  const int wanted = sampler.mip == MipFilter::kNone
                         ? state.first_level
                         : std::clamp(sampler.max_level, state.first_level, kMaxLevels - 1);
  state.last_level = take_levels(unit.image.get(), 0, state.first_level, wanted, state.levels);
  if (unit.cube) {
    state.other_faces.resize(static_cast<size_t>(kCubeFaces - 1) * kMaxLevels);
    for (int face = 1; face < kCubeFaces; ++face) {
      const int last = take_levels(unit.image.get(), face, state.first_level, wanted,
                                   &state.other_faces[static_cast<size_t>(face - 1) * kMaxLevels]);
      state.last_level = std::min(state.last_level, last);
    }
  }
  if (unit.srgb) state.decode = srgb_to_linear();
  state.needs_lod = sampler.min != sampler.mag || state.last_level > state.first_level ||
                    sampler.max_anisotropy > 1;
  state.lod_threshold = sampler.mag == Filter::kLinear && sampler.min == Filter::kNearest &&
                                sampler.mip != MipFilter::kNone
                            ? 0.5f
                            : 0.0f;
  state.min = sampler_of(state, sampler.min);
  state.mag = sampler_of(state, sampler.mag);
  return state;
}

namespace sampling {

HWY_EXPORT(choose_sample);

static SampleFunction dispatch(const SampleState& state) {
  select_simd_target();
  return HWY_DYNAMIC_DISPATCH(choose_sample)(state);
}

}  // namespace sampling

SampleFunction select_sample_function(const SampleState& state) {
  return sampling::dispatch(state);
}

}  // namespace clearpipe::pipeline
#endif
