// Multisample fragment operations (4.1.3): what alpha does to the coverage of a fragment, and
// coverage to alpha.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_MULTISAMPLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_MULTISAMPLE_INL_H_
#undef CLEARPIPE_FRAGMENT_MULTISAMPLE_INL_H_
#else
#define CLEARPIPE_FRAGMENT_MULTISAMPLE_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "pipeline/fragment/batch.h"
#include "pipeline/fragment/program.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// SAMPLE_ALPHA_TO_COVERAGE: sample s of n stays covered where alpha is above s / n, as in the
// reference. The section leaves the function open.
inline void alpha_to_coverage(FragmentBatch& batch) {
  const hn::ScalableTag<int16_t> d;
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    const auto alpha = hn::Load(d, batch.previous[3] + i);
    for (int s = 0; s < kSampleCount; ++s) {
      const auto least = hn::Set(d, static_cast<int16_t>(s * kColourOne / kSampleCount));
      const auto covered = hn::VecFromMask(d, hn::Gt(alpha, least));
      int16_t* live = batch.sample_live[s] + i;
      hn::Store(hn::And(hn::Load(d, live), covered), d, live);
    }
  }
}

// SAMPLE_ALPHA_TO_ONE.
inline void alpha_to_one(FragmentBatch& batch) {
  std::fill_n(batch.previous[3], kBatchSize, kColourOne);
}

// The plane as it is found at a sample when it is evaluated at the pixel's centre (3.5.3).
inline Plane plane_at_sample(const Plane& plane, const SamplePlace& place) {
  constexpr float kPixels = 1.0f / 256;  // of a subpixel; exact
  const float across = plane.dx * (static_cast<float>(place.x) * kPixels);
  const float up = plane.dy * (static_cast<float>(place.y) * kPixels);
  return {plane.value + (up + across), plane.dx, plane.dy};
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
