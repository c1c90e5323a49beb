// Anisotropic filtering (EXT_texture_filter_anisotropic) on one SIMD target: instead of one sample
// of a texture, several along the longer side of the fragment's footprint, and their mean.
//
// The footprint is the pair of derivatives of (s, t) over the quad; level_of_detail
// (texcoord-inl.h) leaves the longer one in batch.along_s and along_t, and in batch.probes the
// number N of samples that make each as short as the other side is. With the extension's equation
//   tau = 1/N sum_{i=1..N} tau(s + ds (i / (N+1) - 1/2), t + dt (i / (N+1) - 1/2))
// each is a whole sample of its own, mipmaps and all, of the level that log2(rho / N) asks for.
// SPDX-License-Identifier: MIT
#include "pipeline/simd.h"

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "pipeline/fragment/sample.h"

#if defined(CLEARPIPE_PIPELINE_FRAGMENT_ANISOTROPIC_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_PIPELINE_FRAGMENT_ANISOTROPIC_INL_H
#undef CLEARPIPE_PIPELINE_FRAGMENT_ANISOTROPIC_INL_H
#else
#define CLEARPIPE_PIPELINE_FRAGMENT_ANISOTROPIC_INL_H
#endif

#include "hwy/highway.h"
#include "pipeline/fragment/sample_axis-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::sampling {
namespace HWY_NAMESPACE {

// Moves the coordinates of all fragments from `from` to that of their probe i, of N. Fragments with
// fewer probes stay inside of their footprints; what they sample there is not added.
HWY_INLINE void place_probes(const float* from, const float* along, int i, size_t count,
                             const float* probes, float* to) {
  const TagFloat d;
  const VecFloat one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f);
  for (size_t k = 0; k < count; k += hn::Lanes(d)) {
    const VecFloat n = hn::Load(d, probes + k);
    const VecFloat place =
        hn::Sub(hn::Div(hn::Min(hn::Set(d, static_cast<float>(i)), n), hn::Add(n, one)), half);
    const VecFloat centre = hn::Load(d, from + k);
    const VecFloat probe = hn::Add(centre, hn::Mul(hn::Load(d, along + k), place));
    // One probe is the sample it would be without: `along` need not be a number then.
    hn::Store(hn::IfThenElse(hn::Eq(n, one), centre, probe), d, to + k);
  }
}

// Samples each fragment batch.probes times by kProbe.
template <SampleFunction kProbe>
void sample_anisotropic(const SampleState& state, FragmentBatch& batch, int unit) {
  const size_t count = static_cast<size_t>(batch.count);
  int most = 1;
  for (size_t k = 0; k < count; ++k) {
    if (batch.probes[k] > static_cast<float>(most)) most = static_cast<int>(batch.probes[k]);
  }
  if (most == 1) return kProbe(state, batch, unit);
  alignas(64) float s[kBatchSize], t[kBatchSize];
  std::memcpy(s, batch.s, sizeof(s));
  std::memcpy(t, batch.t, sizeof(t));
  int32_t sum[4][kBatchSize] = {};
  for (int i = 1; i <= most; ++i) {
    place_probes(s, batch.along_s, i, count, batch.probes, batch.s);
    place_probes(t, batch.along_t, i, count, batch.probes, batch.t);
    kProbe(state, batch, unit);
    for (int c = 0; c < 4; ++c) {
      for (size_t k = 0; k < count; ++k) {
        if (static_cast<float>(i) <= batch.probes[k]) sum[c][k] += batch.texture[unit][c][k];
      }
    }
  }
  for (int c = 0; c < 4; ++c) {
    for (size_t k = 0; k < count; ++k) {
      const int32_t n = static_cast<int32_t>(batch.probes[k]);
      batch.texture[unit][c][k] = static_cast<int16_t>((2 * sum[c][k] + n) / (2 * n));
    }
  }
  std::memcpy(batch.s, s, sizeof(s));
  std::memcpy(batch.t, t, sizeof(t));
}

}  // namespace HWY_NAMESPACE
}  // namespace clearpipe::pipeline::sampling
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
