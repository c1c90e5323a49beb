// Samplers of rows: one level of a texture for many pixels at once. What sample.cpp has of them,
// for the fused loop and for batches (sample_batch-inl.h). SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_ROW_SAMPLER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_ROW_SAMPLER_INL_H_
#undef CLEARPIPE_FRAGMENT_ROW_SAMPLER_INL_H_
#else
#define CLEARPIPE_FRAGMENT_ROW_SAMPLER_INL_H_
#endif

#include <hwy/highway.h>

#include <bit>

#include "pipeline/fragment/group-inl.h"
#include "pipeline/fragment/sample.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

inline constexpr int kGroup = 2 * static_cast<int>(hn::MaxLanes(TagF()));  // pixels of a group
inline constexpr int kRowGroups = kTileWidth / kGroup;

// The colours of a row, 8-bit values, group after group.
struct RowColours {
  alignas(64) int16_t channel[4][kTileWidth];

  HWY_INLINE Colour16 load(int group) const {
    const Tag16 d;
    Colour16 c;
    for (int i = 0; i < 4; ++i) c.channel[i] = hn::Load(d, channel[i] + group * kGroup);
    return c;
  }
  HWY_INLINE void store(const Colour16& c, int group) {
    const Tag16 d;
    for (int i = 0; i < 4; ++i) hn::Store(c.channel[i], d, channel[i] + group * kGroup);
  }
};

// The pixels of a row, packed as in a surface.
struct RowPixels {
  alignas(64) uint32_t pixel[kTileWidth];

  HWY_INLINE Pair<VecU> load(int group) const {
    const TagU d;
    const uint32_t* const from = pixel + group * kGroup;
    return {hn::Load(d, from), hn::Load(d, from + kGroup / 2)};
  }
  HWY_INLINE void store(const Pair<VecU>& pixels, int group) {
    const TagU d;
    uint32_t* const to = pixel + group * kGroup;
    hn::Store(pixels.lower, d, to);
    hn::Store(pixels.upper, d, to + kGroup / 2);
  }
};

// Calls `function(group)` for each bit of `groups`.
template <class F>
HWY_INLINE void for_each_group(uint32_t groups, const F& function) {
  for (; groups != 0; groups &= groups - 1) function(std::countr_zero(groups));
}

// Which halves of the groups of a row are looked at: bit 2 g is the lower half of group g.
using Halves = uint32_t;
HWY_INLINE Halves halves_of_group(int group) { return Halves{3} << (2 * group); }

// Samples some halves of the groups of a row. Coordinates lie as pixels do; those of a half are all
// read, and may be any numbers where nobody looks.
using RowSampler = void (*)(const SampleLevel& level, const float* s, const float* t, Halves halves,
                            RowPixels& out);

// The sampler of a name in fused.def; null for kAny.
RowSampler row_sampler(FusedSampler sampler);

#endif  // HWY_TARGET != HWY_SCALAR

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
