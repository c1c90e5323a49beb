// Pixels at any places of a tile's plane, from there to a batch of fragments (small-inl.h) and
// back. `offset` holds their indices into the plane. SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_SMALL_PIXELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_SMALL_PIXELS_INL_H_
#undef CLEARPIPE_FRAGMENT_SMALL_PIXELS_INL_H_
#else
#define CLEARPIPE_FRAGMENT_SMALL_PIXELS_INL_H_
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Calls f for each of so many fragments.
template <class F>
HWY_INLINE void for_each_fragment(int count, const F& f) {
  int i = 0;
  for (; i + 4 <= count; i += 4) {
    f(i);
    f(i + 1);
    f(i + 2);
    f(i + 3);
  }
  for (; i < count; ++i) f(i);
}

// By whole vectors, up to the end of the last one: left to themselves, compilers take indices out
// of vectors and put values into them.
HWY_INLINE void gather_pixels(const uint32_t* HWY_RESTRICT plane,
                              const int32_t* HWY_RESTRICT offset, int count,
                              uint32_t* HWY_RESTRICT values) {
  const hn::ScalableTag<int32_t> d;
  for (int i = 0; i < count; i += static_cast<int>(hn::MaxLanes(d))) {
    const auto in_use = hn::FirstN(d, static_cast<size_t>(count - i));
    const auto index = hn::IfThenElseZero(in_use, hn::Load(d, offset + i));
    hn::Store(hn::GatherIndex(d, reinterpret_cast<const int32_t*>(plane), index), d,
              reinterpret_cast<int32_t*>(values) + i);
  }
}

HWY_INLINE void scatter_pixels(const uint32_t* HWY_RESTRICT values,
                               const int32_t* HWY_RESTRICT offset, int count,
                               uint32_t* HWY_RESTRICT plane) {
  for_each_fragment(count, [=](int i) { plane[offset[i]] = values[i]; });
}

// Of the fragments that live. The others go where nobody looks, so that there is no branch.
HWY_INLINE void scatter_live_pixels(const uint32_t* values, const int32_t* offset,
                                    const int16_t* live, int count, uint32_t* plane) {
  uint32_t nowhere;
  for_each_fragment(count, [=, &nowhere](int i) {
    uint32_t* to = live[i] != 0 ? plane + offset[i] : &nowhere;
    *to = values[i];
  });
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
