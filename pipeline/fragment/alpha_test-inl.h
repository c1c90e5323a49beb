// The alpha test (4.1.4): fragments that fail it die. The fragment's alpha and the reference are
// compared as 8-bit values.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_ALPHA_TEST_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_ALPHA_TEST_INL_H_
#undef CLEARPIPE_FRAGMENT_ALPHA_TEST_INL_H_
#else
#define CLEARPIPE_FRAGMENT_ALPHA_TEST_INL_H_
#endif

#include <hwy/highway.h>

#include "pipeline/fragment/batch.h"
#include "pipeline/fragment/colour-inl.h"
#include "pipeline/fragment/compare-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

inline void alpha_test(CompareFunc func, int16_t reference, FragmentBatch& batch) {
  const hn::ScalableTag<int16_t> d;
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    const auto alpha = to_unorm8(d, hn::Load(d, batch.previous[3] + i));
    const auto pass = compare(d, func, alpha, hn::Set(d, reference));
    hn::Store(hn::And(hn::Load(d, batch.live + i), hn::VecFromMask(d, pass)), d, batch.live + i);
  }
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
