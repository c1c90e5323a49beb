// Samples of a texture that is not turned: s is a matter of the column of a pixel alone, t of its
// row, as where programs draw rectangles in two dimensions, and in point sprites. So the texels of
// a vector's columns and their weights are found once for all rows, and come from two vectors of
// each row of texels, whatever their order. See row_sampler-inl.h for the samplers of all else.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_ALIGNED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_ALIGNED_INL_H_
#undef CLEARPIPE_FRAGMENT_ALIGNED_INL_H_
#else
#define CLEARPIPE_FRAGMENT_ALIGNED_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "pipeline/fragment/early_tests-inl.h"
#include "pipeline/fragment/group-inl.h"
#include "pipeline/fragment/sample_axis-inl.h"
#include "pipeline/fragment/sample_colours-inl.h"
#include "pipeline/fragment/split_plane-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

// The texels of an axis (3.7.7, 3.7.8) with a wrap mode that samplers of fused.def have; NEAREST
// has the first alone.
HWY_INLINE sampling::HWY_NAMESPACE::LinearAxis texels_of_axis(Filter filter, WrapKind wrap,
                                                              VecF coordinate, int size) {
  using namespace sampling::HWY_NAMESPACE;
  const auto axis = [&](auto kind) HWY_ATTR {
    constexpr WrapKind kWrap = kind();
    if (filter == Filter::kLinear) return linear_axis<kWrap>(coordinate, size);
    const VecI texel = nearest_axis<kWrap>(coordinate, size);
    return LinearAxis{texel, texel, hn::Zero(TagI())};
  };
  switch (wrap) {
    case WrapKind::kRepeatPowerOfTwo:
      return axis(std::integral_constant<WrapKind, WrapKind::kRepeatPowerOfTwo>());
    case WrapKind::kRepeatOther:
      return axis(std::integral_constant<WrapKind, WrapKind::kRepeatOther>());
    default:
      return axis(std::integral_constant<WrapKind, WrapKind::kClampToEdge>());
  }
}

class AlignedSampler {
 public:
  // The coordinates of a unit.
  static bool is_for(const Plane (&coordinates)[4]) {
    const auto& [s, t, r, q] = coordinates;
    return s.dy == 0 && t.dx == 0 && q.value == 1 && q.dx == 0 && q.dy == 0;
  }

  void start(const SampleState& state, const SplitPlane& s, const SplitPlane& t) {
    const TagI d;
    level_ = &state.levels[state.first_level];
    s_ = &s;
    filter_ = state.sampler.min;
    wrap_s_ = wrap_kind(state.sampler.wrap_s, level_->width);
    column_ = -1;
    const WrapKind wrap_t = wrap_kind(state.sampler.wrap_t, level_->height);
    for (int row = 0; row < kTileHeight; row += kLanes) {
      const auto axis = texels_of_axis(filter_, wrap_t, t.rows(row, 0), level_->height);
      hn::Store(axis.first, d, row_[0] + row);
      hn::Store(axis.second, d, row_[1] + row);
      hn::Store(axis.weight, d, row_weight_ + row);
    }
  }

  // Of the pixels from a column on, those whose bits are set are about to be sampled. False when
  // their texels are too far apart for that.
  HWY_INLINE bool set_columns(int column, uint64_t bits) {
    if (column != column_ || (bits & ~columns_) != 0) find_columns(column, bits);
    return close_;
  }

  // Their samples in a row.
  HWY_INLINE VecU sample(int row) const {
    if (!whole_) return sample<NarrowTexels>(row);
    return both_ ? sample<WideTexels>(row) : sample<CloseTexels>(row);
  }

 private:
  static constexpr int kLanes = static_cast<int>(hn::MaxLanes(TagI()));

  // Places of texels in two vectors.
  struct Places {
    VecI in_either;  // counted from the first of the vector that has it
    hn::Mask<TagU> in_second;
  };

  // What there is of a row of texels: those of all columns are in one vector,
  struct CloseTexels {
    VecU vector;

    HWY_INLINE CloseTexels(const uint32_t* from, int) : vector(hn::LoadU(TagU(), from)) {}
    HWY_INLINE VecU take(const Places& places) const {
      return hn::TableLookupLanes(vector, hn::IndicesFromVec(TagU(), places.in_either));
    }
  };
  // in two,
  struct WideTexels {
    VecU lower, upper;

    HWY_INLINE WideTexels(const uint32_t* from, int)
        : WideTexels(hn::LoadU(TagU(), from), hn::LoadU(TagU(), from + kLanes)) {}
    HWY_INLINE WideTexels(VecU first, VecU second) : lower(first), upper(second) {}
    HWY_INLINE VecU take(const Places& places) const {
      const auto index = hn::IndicesFromVec(TagU(), places.in_either);
      return hn::IfThenElse(places.in_second, hn::TableLookupLanes(upper, index),
                            hn::TableLookupLanes(lower, index));
    }
  };
  // or the row is shorter than that.
  struct NarrowTexels : WideTexels {
    HWY_INLINE NarrowTexels(const uint32_t* from, int width)
        : WideTexels(part(from, width), part(from + kLanes, width - kLanes)) {}

    static HWY_INLINE VecU part(const uint32_t* from, int width) {
      const auto count = static_cast<size_t>(std::clamp(width, 0, kLanes));
      // Other targets would read the whole vector.
      if constexpr (kLanes >= 8) return hn::MaskedLoad(hn::FirstN(TagU(), count), TagU(), from);
      alignas(64) uint32_t texels[kLanes] = {};
      std::memcpy(texels, from, count * sizeof(uint32_t));
      return hn::Load(TagU(), texels);
    }
  };

  template <class Texels>
  HWY_INLINE VecU sample(int row) const {
    using namespace sampling::HWY_NAMESPACE;
    const TagI d;
    const int width = level_->width;
    const uint32_t* const from = level_->texels + first_texel_;
    const Texels row0(from + row_[0][row] * width, width);
    // Samples at the centres of texels, as of pictures that are drawn as large as they are, are
    // those texels.
    if (filter_ == Filter::kNearest || (!is_between_ && row_weight_[row] == 0)) {
      return row0.take(first_);
    }
    const Texels row1(from + row_[1][row] * width, width);
    const Weight down = spread<false>(hn::Set(d, row_weight_[row]));
    const auto across = [&](const Texels& texels) HWY_ATTR {
      return lerp(across_, unpack(hn::BitCast(d, texels.take(first_))),
                  unpack(hn::BitCast(d, texels.take(second_))));
    };
    return hn::BitCast(TagU(), pack(lerp(down, across(row0), across(row1))));
  }

  HWY_NOINLINE void find_columns(int column, uint64_t bits) {
    using namespace sampling::HWY_NAMESPACE;
    const TagI d;
    column_ = column;
    columns_ = bits;
    const int width = level_->width;
    const LinearAxis axis = texels_of_axis(filter_, wrap_s_, s_->at(0, column), width);
    // Nobody looks at what is sampled for other pixels.
    const MaskI wanted = mask_of_bits(d, bits);
    const auto bound = [&](VecI otherwise) HWY_ATTR {
      return Pair<VecI>{hn::IfThenElse(wanted, axis.first, otherwise),
                        hn::IfThenElse(wanted, axis.second, otherwise)};
    };
    const Pair<VecI> for_least = bound(hn::Set(d, width)), for_most = bound(hn::Zero(d));
    const int least = hn::GetLane(hn::MinOfLanes(d, hn::Min(for_least.lower, for_least.upper)));
    const int most = hn::GetLane(hn::MaxOfLanes(d, hn::Max(for_most.lower, for_most.upper)));
    whole_ = width >= 2 * kLanes;
    first_texel_ = whole_ ? std::min(least, width - 2 * kLanes) : 0;
    close_ = most - first_texel_ < 2 * kLanes;
    both_ = most - first_texel_ >= kLanes;
    first_ = places_of(axis.first);
    second_ = places_of(axis.second);
    across_ = spread<false>(axis.weight);
    is_between_ = !hn::AllTrue(d, hn::Eq(hn::IfThenElseZero(wanted, axis.weight), hn::Zero(d)));
  }

  HWY_INLINE Places places_of(VecI texel) const {
    const TagI d;
    const VecI place = hn::Sub(texel, hn::Set(d, first_texel_));
    return {hn::And(place, hn::Set(d, kLanes - 1)),
            hn::RebindMask(TagU(), hn::Gt(place, hn::Set(d, kLanes - 1)))};
  }

  const SampleLevel* level_;
  const SplitPlane* s_;
  Filter filter_;
  WrapKind wrap_s_;
  // By row of the tile: the two rows of texels, and the weight of the second.
  alignas(64) int32_t row_[2][kTileHeight], row_weight_[kTileHeight];
  // The column at hand, and which of the pixels from there on.
  int column_;
  uint64_t columns_;
  bool close_, both_;  // texels are in two vectors, not all in the first
  bool whole_;         // rows have so many
  int first_texel_;    // of the first vector
  Places first_, second_;
  sampling::HWY_NAMESPACE::Weight across_;
  bool is_between_;  // some weight is not 0
};

#endif  // HWY_TARGET != HWY_SCALAR

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
