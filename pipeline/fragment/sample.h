// Texture sampling (3.7.7 to 3.7.9) over a batch: s, t and lod in, filtered colours out.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "pipeline/fragment/batch.h"
#include "pipeline/state.h"

namespace clearpipe::pipeline {

// What sampling needs, worked out once per program from the unit's image and sampler.
struct SampleLevel {
  const uint32_t* texels = nullptr;
  int width = 0, height = 0;
};
// Levels of all faces of a cube map are numbered as in an Image. A sampling key is twice the number
// of a level, counted from the first that is used, plus 1 for the magnification filter.
inline constexpr int kFaceKey = 2 * kMaxLevels;

// A wrap mode, with REPEAT told apart by the size of the base level: powers of two wrap by a mask
// after scaling, other sizes by the fraction of the coordinate before it.
enum class WrapKind : uint8_t { kRepeatPowerOfTwo, kRepeatOther, kClampToEdge, kMirroredRepeat };

inline WrapKind wrap_kind(Wrap wrap, int size) {
  switch (wrap) {
    case Wrap::kRepeat:
      return (size & (size - 1)) == 0 ? WrapKind::kRepeatPowerOfTwo : WrapKind::kRepeatOther;
    case Wrap::kClampToEdge:
      return WrapKind::kClampToEdge;
    default:
      return WrapKind::kMirroredRepeat;
  }
}

// How one level is sampled for many pixels at once (row_sampler-inl.h), kAny: not at all.
enum class FusedSampler : uint8_t {
#define FUSED_SAMPLER(filter, s, t) k##filter##s##t,
#include "pipeline/fragment/fused.def"
  kAny
};

struct SampleState {
  SampleLevel levels[kMaxLevels];
  std::vector<SampleLevel> other_faces;  // of a cube map: the levels from that of -x on
  int first_level = 0, last_level = 0;
  Sampler sampler;
  bool needs_lod = false;   // minification and magnification differ, or mipmaps are used, or the
                            // footprint is looked at (anisotropic-inl.h)
  float lod_threshold = 0;  // c: magnification when lod <= c (3.7.8)
  const int32_t* decode = nullptr;  // of sRGB-encoded colours: srgb_to_linear()
  FusedSampler min = FusedSampler::kAny, mag = FusedSampler::kAny;  // of the filters

  bool is_cube() const { return !other_faces.empty(); }
  const SampleLevel& level(int number) const {
    return number < kMaxLevels ? levels[number] : other_faces[number - kMaxLevels];
  }
};

SampleState make_sample_state(const TextureUnit& unit);

// Fills batch.texture[unit] from batch.s, batch.t, with a cube map batch.face, and (if needs_lod)
// batch.lod, along_s, along_t and probes. Chosen for the sampler once; runs on the SIMD target in
// use.
using SampleFunction = void (*)(const SampleState& state, FragmentBatch& batch, int unit);
SampleFunction select_sample_function(const SampleState& state);

}  // namespace clearpipe::pipeline
