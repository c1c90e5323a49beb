// Comparison functions, shared by the alpha, stencil and depth tests (4.1.3 to 4.1.5).
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_COMPARE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_COMPARE_INL_H_
#undef CLEARPIPE_FRAGMENT_COMPARE_INL_H_
#else
#define CLEARPIPE_FRAGMENT_COMPARE_INL_H_
#endif

#include <hwy/highway.h>

#include "pipeline/state.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> compare(D d, CompareFunc func, V a, V b) {
  switch (func) {
    case CompareFunc::kNever:
      return hn::Lt(a, a);
    case CompareFunc::kLess:
      return hn::Lt(a, b);
    case CompareFunc::kEqual:
      return hn::Eq(a, b);
    case CompareFunc::kLessEqual:
      return hn::Not(hn::Gt(a, b));
    case CompareFunc::kGreater:
      return hn::Gt(a, b);
    case CompareFunc::kNotEqual:
      return hn::Ne(a, b);
    case CompareFunc::kGreaterEqual:
      return hn::Not(hn::Lt(a, b));
    case CompareFunc::kAlways:
      break;
  }
  (void)d;
  return hn::Eq(a, a);
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
