// Floats to the nearest integers, where they are known to be in range.
//
// NearestInt of Highway takes care of floats beyond int32_t, with four operations more on x86.
// Those are left out here by the instructions themselves (`fill_gouraud_depth` of bench/scenes, one
// thread: 0.54 ms with them and 0.48 without on AVX2, 0.32 and 0.30 on AVX-512).
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_PIPELINE_NEAREST_INT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_PIPELINE_NEAREST_INT_INL_H_
#undef CLEARPIPE_PIPELINE_NEAREST_INT_INL_H_
#else
#define CLEARPIPE_PIPELINE_NEAREST_INT_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// To nearest, ties to even, for |v| < 2^31.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> nearest_int(D d, V v) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
  using Result = hn::Vec<hn::RebindToSigned<D>>;
  (void)d;
#if HWY_TARGET <= HWY_AVX3
  if constexpr (hn::MaxLanes(D()) == 16) {
    return Result{_mm512_cvtps_epi32(v.raw)};
  } else
#endif
#if HWY_TARGET <= HWY_AVX2
      if constexpr (hn::MaxLanes(D()) == 8) {
    return Result{_mm256_cvtps_epi32(v.raw)};
  } else
#endif
  {
    return Result{_mm_cvtps_epi32(v.raw)};
  }
#else
  (void)d;
  return hn::NearestInt(v);
#endif
}

}  // namespace clearpipe::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
