// Pixels at any places of a tile's plane, from there to a batch of fragments (small-inl.h) and
// back, and the colours of fragments. `offset` holds their indices into the plane.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_SMALL_PIXELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_SMALL_PIXELS_INL_H_
#undef CLEARPIPE_FRAGMENT_SMALL_PIXELS_INL_H_
#else
#define CLEARPIPE_FRAGMENT_SMALL_PIXELS_INL_H_
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "pipeline/fragment/batch.h"
#include "pipeline/fragment/colour-inl.h"
#include "pipeline/fragment/write-inl.h"
#include "pipeline/setup/lane_planes-inl.h"

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

// Interpolated colours, in fixed point.
inline void round_colours(const float (&colour)[4][kBatchSize], bool textured,
                          FragmentBatch& batch) {
  const hn::ScalableTag<float> d;
  const hn::Rebind<int16_t, decltype(d)> d16;
  for (int c = 0; c < 4; ++c) {
    for (int i = 0; i < batch.count; i += static_cast<int>(hn::MaxLanes(d))) {
      const auto rounded = hn::DemoteTo(d16, round_colour(d, hn::Load(d, colour[c] + i)));
      hn::Store(rounded, d16, batch.previous[c] + i);
      if (textured) hn::Store(rounded, d16, batch.primary[c] + i);
    }
  }
}

// The pixels that colours become where no stage changes them, one in each lane.
HWY_INLINE hn::Vec<hn::ScalableTag<int32_t>> pack_lanes(
    const hn::Vec<hn::ScalableTag<float>> (&colour)[4], ColourFormat format) {
  const hn::ScalableTag<float> d;
  const hn::ScalableTag<int32_t> di;
  const hn::ScalableTag<uint32_t> du;
#if HWY_TARGET == HWY_SCALAR
  const hn::Rebind<int16_t, decltype(d)> d16;
  const auto byte = [&](auto value) HWY_ATTR {
    const auto rounded = hn::DemoteTo(d16, round_colour(d, value));
    return hn::BitCast(du, hn::PromoteTo(di, to_unorm8(d16, rounded)));
  };
  const auto low = hn::Or(byte(colour[0]), hn::ShiftLeft<8>(byte(colour[1])));
  const auto high = hn::Or(byte(colour[2]), hn::ShiftLeft<8>(byte(colour[3])));
  const auto pixels = hn::Or(low, hn::ShiftLeft<16>(high));
#else
  // Two channels in the halves of each lane.
  const hn::Repartition<int16_t, decltype(d)> d16;
  const auto bytes = [&](auto low, auto high) HWY_ATTR {
    const auto both = hn::Or(round_colour(d, low), hn::ShiftLeft<16>(round_colour(d, high)));
    return hn::BitCast(du, to_unorm8(d16, hn::BitCast(d16, both)));
  };
  const auto pixels =
      hn::Or(bytes(colour[0], colour[2]), hn::ShiftLeft<8>(bytes(colour[1], colour[3])));
#endif
  if (format == ColourFormat::kRgba8) return hn::BitCast(di, pixels);
  return hn::BitCast(di, truncate_colour(du, truncation_of(format), pixels));
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
