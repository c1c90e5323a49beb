// The samplers of fused.def (row_sampler-inl.h): one level for the groups of a row (3.7.7, 3.7.8).
//
// A bilinear sample reads two neighbours of each of two rows with one load of 64 bits a row, and
// interpolates in these 64-bit lanes: a texel's four channels are four 16-bit values.
//
//   bytes of a lane   r0 g0 b0 a0 r1 g1 b1 a1
//   first texel       r0 .. g0 .. b0 .. a0 ..      second  r1 .. g1 .. b1 .. a1 ..
//
// A vector of such lanes holds the pixels that InterleaveLower or InterleaveUpper of 32-bit lanes
// would double: of each 128-bit block the first two, or the last two. Loads take any order for
// nothing, and so weights spread and channels part within blocks.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_SAMPLE_ROW_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_SAMPLE_ROW_INL_H_
#undef CLEARPIPE_FRAGMENT_SAMPLE_ROW_INL_H_
#else
#define CLEARPIPE_FRAGMENT_SAMPLE_ROW_INL_H_
#endif

#include <hwy/highway.h>

#include <bit>
#include <cstring>

#include "pipeline/fragment/row_sampler-inl.h"
#include "pipeline/fragment/sample_axis-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

using sampling::HWY_NAMESPACE::LinearAxis;

using TagTexels = hn::Repartition<uint64_t, TagF>;  // two texels a lane
using VecTexels = hn::Vec<TagTexels>;

// Two texels for each pixel of half a group: of the first two pixels of the blocks, and of the
// last.
template <class V>
struct BlockPairs {
  V first, last;
};

// One lane after another into a vector. With AVX-512 a load can go to a single lane of it.
template <class D>
HWY_INLINE hn::Vec<D> from_lanes(D d, const uint64_t* const (&at)[4]) {
  const auto load = [](const uint64_t* from) HWY_ATTR {
    uint64_t lane;
    std::memcpy(&lane, from, sizeof(lane));
    return lane;
  };
#if HWY_TARGET <= HWY_AVX3
  const auto lane = hn::Iota(d, 0);
  auto v = hn::Set(d, load(at[0]));
  for (uint64_t i = 1; i < 4; ++i) {
    v = hn::IfThenElse(hn::Eq(lane, hn::Set(d, i)), hn::Set(d, load(at[i])), v);
  }
  return v;
#else
  const hn::Half<D> half;
  const hn::Half<decltype(half)> quarter;
  (void)load;
  return hn::Combine(d, hn::Combine(half, hn::LoadU(quarter, at[3]), hn::LoadU(quarter, at[2])),
                     hn::Combine(half, hn::LoadU(quarter, at[1]), hn::LoadU(quarter, at[0])));
#endif
}

// Loads by index, which take two thirds of the time of gathers (16 pixels, Zen 5): `at(i)` is the
// address of the two texels of a pixel. Indices leave their vector two at a time.
template <class D, class At>
HWY_INLINE BlockPairs<hn::Vec<hn::Repartition<uint64_t, D>>> load_pairs(D d, hn::Vec<D> index,
                                                                        const At& at) {
  const hn::Repartition<uint64_t, D> wide;
  const auto low_of = [](auto pairs) HWY_ATTR { return hn::GetLane(pairs); };
  const auto high_of = [](auto pairs) HWY_ATTR {
    return hn::GetLane(hn::UpperHalf(hn::Full64<uint64_t>(), pairs));
  };
  if constexpr (hn::MaxLanes(D()) == 4) {
    const hn::Half<decltype(wide)> half_wide;
    const auto pairs = hn::BitCast(wide, index);
    const uint64_t low = low_of(pairs), high = high_of(pairs);
    const auto load = [&](uint64_t i) HWY_ATTR { return hn::LoadU(half_wide, at(i)); };
    return {hn::Combine(wide, load(low >> 32), load(low & 0xffffffffu)),
            hn::Combine(wide, load(high >> 32), load(high & 0xffffffffu))};
  } else if constexpr (hn::MaxLanes(D()) == 8) {
    const auto pairs = hn::BitCast(wide, index);
    const hn::Full128<uint64_t> block;
    const auto block0 = hn::LowerHalf(block, pairs), block1 = hn::UpperHalf(block, pairs);
    const uint64_t low0 = low_of(block0), high0 = high_of(block0);
    const uint64_t low1 = low_of(block1), high1 = high_of(block1);
    const auto four = [&](uint64_t a, uint64_t b) HWY_ATTR {
      const uint64_t* const places[4] = {at(a & 0xffffffffu), at(a >> 32), at(b & 0xffffffffu),
                                         at(b >> 32)};
      return from_lanes(wide, places);
    };
    return {four(low0, low1), four(high0, high1)};
  } else {
    const hn::Half<D> half;
    const auto lower = load_pairs(half, hn::LowerHalf(half, index), at);
    const auto upper = load_pairs(half, hn::UpperHalf(half, index), at);
    return {hn::Combine(wide, upper.first, lower.first), hn::Combine(wide, upper.last, lower.last)};
  }
}

// A texel and its right neighbour.
HWY_INLINE BlockPairs<VecTexels> load_neighbours(const SampleLevel& level, VecU index) {
  return load_pairs(TagU(), index, [&](uint64_t i) {
    return reinterpret_cast<const uint64_t*>(level.texels + i);
  });
}

// The texels at any indices, a lane each.
HWY_INLINE VecU gather_texels(const SampleLevel& level, VecU index) {
  const TagI d;
  return hn::BitCast(TagU(), hn::GatherIndex(d, reinterpret_cast<const int32_t*>(level.texels),
                                             hn::BitCast(d, index)));
}

HWY_INLINE BlockPairs<VecTexels> pair_texels(VecU first, VecU second) {
  const TagU d;
  const TagTexels wide;
  return {hn::BitCast(wide, hn::InterleaveLower(d, first, second)),
          hn::BitCast(wide, hn::InterleaveUpper(d, first, second))};
}

// Two texels from anywhere.
HWY_INLINE BlockPairs<VecTexels> load_apart(const SampleLevel& level, VecU first, VecU second) {
  return pair_texels(gather_texels(level, first), gather_texels(level, second));
}

// A table of bytes for each block of 128 bits, whole, so that it is an operand in memory.
struct BlockTable {
  alignas(64) uint8_t bytes[64];

  constexpr explicit BlockTable(const uint8_t (&block)[16]) : bytes() {
    for (size_t i = 0; i < sizeof(bytes); ++i) bytes[i] = block[i % sizeof(block)];
  }
  HWY_INLINE hn::Vec<TagBytes> load() const { return hn::Load(TagBytes(), bytes); }
};

// Weights of 8 bits in the lanes of a vector of pixels, spread to all channels of the pixels that
// belong to a vector of 64-bit lanes: the first two of a block, or the last two.
struct SpreadWeights {
  Vec16 first, last;

  HWY_INLINE explicit SpreadWeights(VecI weight) {
    const TagBytes d;
    const Tag16 d16;
    static constexpr BlockTable kFirst({0, 1, 0, 1, 0, 1, 0, 1, 4, 5, 4, 5, 4, 5, 4, 5});
    static constexpr BlockTable kLast({8, 9, 8, 9, 8, 9, 8, 9, 12, 13, 12, 13, 12, 13, 12, 13});
    const auto bytes = hn::BitCast(d, hn::ShiftLeft<7>(weight));
    first = hn::BitCast(d16, hn::TableLookupBytes(bytes, kFirst.load()));
    last = hn::BitCast(d16, hn::TableLookupBytes(bytes, kLast.load()));
  }
};

HWY_INLINE Vec16 lerp_neighbours(Vec16 weight, VecTexels texels) {
  const TagBytes d;
  const Tag16 d16;
  constexpr uint8_t kNone = 0x80;
  static constexpr BlockTable kFirst(
      {0, kNone, 1, kNone, 2, kNone, 3, kNone, 8, kNone, 9, kNone, 10, kNone, 11, kNone});
  static constexpr BlockTable kSecond(
      {4, kNone, 5, kNone, 6, kNone, 7, kNone, 12, kNone, 13, kNone, 14, kNone, 15, kNone});
  const auto bytes = hn::BitCast(d, texels);
  const auto first = hn::TableLookupBytesOr0(bytes, kFirst.load());
  const auto second = hn::TableLookupBytesOr0(bytes, kSecond.load());
  return lerp_8(weight, hn::BitCast(d16, first), hn::BitCast(d16, second));
}

// The axes of sample_axis-inl.h. Coordinates that are small enough, as nearly all are, become fixed
// point by the rounding of an addition: a conversion has to guard against overflow.
template <WrapKind kS, WrapKind kT>
HWY_INLINE void linear_axes(const SampleLevel& level, VecF s, VecF t, LinearAxis& x,
                            LinearAxis& y) {
  using sampling::HWY_NAMESPACE::linear_axis;
  if constexpr (kS == WrapKind::kRepeatPowerOfTwo && kT == WrapKind::kRepeatPowerOfTwo) {
    const TagF d;
    const TagI di;
    const VecF u = hn::Mul(s, hn::Set(d, static_cast<float>(level.width) * 256.0f));
    const VecF v = hn::Mul(t, hn::Set(d, static_cast<float>(level.height) * 256.0f));
    const VecF limit = hn::Set(d, 4194304.0f);
    if (HWY_LIKELY(hn::AllTrue(d, hn::And(hn::Lt(hn::Abs(u), limit), hn::Lt(hn::Abs(v), limit))))) {
      const auto axis = [&](VecF scaled, int size) HWY_ATTR {
        const VecF magic = hn::Set(d, 12582912.0f);
        const VecI to_fixed =
            hn::Set(di, 0x4b400000 + 128);  // the bits of `magic`, and half a texel
        const VecI fixed = hn::Sub(hn::BitCast(di, hn::Add(scaled, magic)), to_fixed);
        const VecI last = hn::Set(di, size - 1);
        const VecI first = hn::And(hn::ShiftRight<8>(fixed), last);
        return LinearAxis{first, hn::And(hn::Add(first, hn::Set(di, 1)), last),
                          hn::And(fixed, hn::Set(di, 255))};
      };
      x = axis(u, level.width);
      y = axis(v, level.height);
      return;
    }
  }
  x = linear_axis<kS>(s, level.width);
  y = linear_axis<kT>(t, level.height);
}

// Pixels of half a group whose texels lie close together, as where a texture is about as large as
// what it covers, or larger: in two rows that follow each other, each no longer than a vector. Then
// a few loads of whole vectors bring all of them, and each pixel takes its own from there.
class TexelWindow {
 public:
  // By the columns and rows of the pixels' first texels. The most that is read is `rows` rows and
  // `columns` more texels.
  HWY_INLINE TexelWindow(const SampleLevel& level, VecI column, VecI row, int rows, int columns)
      : width_(level.width) {
    const TagI d;
    // Along a row of pixels columns and rows go one way, so that the least ones are at an end.
    const auto least = [](VecI v)
                           HWY_ATTR { return hn::GetLane(hn::Min(v, hn::Reverse(TagI(), v))); };
    const int column0 = least(column), row0 = least(row);
    column_ = hn::Sub(column, hn::Set(d, column0));
    row_ = hn::Sub(row, hn::Set(d, row0));
    outside_ = hn::Or(hn::And(column_, hn::Set(d, ~(kLanes - 1))), hn::And(row_, hn::Set(d, ~1)));
    const int first = row0 * width_ + column0;
    is_inside_ = first + (rows - 1) * width_ + columns + kLanes <= level.width * level.height;
    texels_ = level.texels + first;
  }

  // Whether all pixels find their texels; `others` is zero where nothing else speaks against it.
  HWY_INLINE bool holds(VecI others) const {
    const TagI d;
    return is_inside_ && hn::AllTrue(d, hn::Eq(hn::Or(outside_, others), hn::Zero(d)));
  }

  // The texels so many rows and columns on from the pixels' first ones.
  HWY_INLINE VecU take(int rows, int columns) const {
    const TagU d;
    const uint32_t* const from = texels_ + rows * width_ + columns;
    const auto index = hn::IndicesFromVec(d, column_);
    const auto lower = hn::RebindMask(d, hn::Eq(row_, hn::Zero(TagI())));
    return hn::IfThenElse(lower, hn::TableLookupLanes(hn::LoadU(d, from), index),
                          hn::TableLookupLanes(hn::LoadU(d, from + width_), index));
  }

 private:
  static constexpr int kLanes = static_cast<int>(hn::MaxLanes(TagI()));

  const uint32_t* texels_;
  int width_;
  bool is_inside_;
  VecI column_, row_;  // of each pixel, counted from the window's first texel
  VecI outside_;       // not zero: a pixel's texel is not in the window
};

// 3.7.8 for half of a group: the colours of its pixels in the two vectors of 64-bit lanes. `close`
// says whether a window was enough up to now: if it was not, it rarely is further along the row.
template <WrapKind kS, WrapKind kT>
HWY_INLINE void sample_linear_half(const SampleLevel& level, VecF s, VecF t, bool& close,
                                   Vec16& first, Vec16& last) {
  const TagI d;
  LinearAxis x, y;
  linear_axes<kS, kT>(level, s, t, x, y);
  BlockPairs<VecTexels> texels0, texels1;
  // Only at the edges of the level is the second texel not the first one's neighbour.
  const VecI one = hn::Set(d, 1);
  const VecI x_apart = hn::Xor(x.second, hn::Add(x.first, one));
  if (close) {
    const VecI y_apart = hn::Xor(y.second, hn::Add(y.first, one));
    const TexelWindow window(level, x.first, y.first, 3, 1);
    close = window.holds(hn::Or(x_apart, y_apart));
    if (close) {
      texels0 = pair_texels(window.take(0, 0), window.take(0, 1));
      texels1 = pair_texels(window.take(1, 0), window.take(1, 1));
    }
  }
  if (!close) {
    const VecI width = hn::Set(d, level.width);
    const VecI row0 = hn::Mul(y.first, width), row1 = hn::Mul(y.second, width);
    const auto at = [](VecI row, VecI column)
                        HWY_ATTR { return hn::BitCast(TagU(), hn::Add(row, column)); };
    if (HWY_LIKELY(hn::AllTrue(d, hn::Eq(x_apart, hn::Zero(d))))) {
      texels0 = load_neighbours(level, at(row0, x.first));
      texels1 = load_neighbours(level, at(row1, x.first));
    } else {
      texels0 = load_apart(level, at(row0, x.first), at(row0, x.second));
      texels1 = load_apart(level, at(row1, x.first), at(row1, x.second));
    }
  }
  const SpreadWeights a(x.weight), b(y.weight);
  first = lerp_8(b.first, lerp_neighbours(a.first, texels0.first),
                 lerp_neighbours(a.first, texels1.first));
  last =
      lerp_8(b.last, lerp_neighbours(a.last, texels0.last), lerp_neighbours(a.last, texels1.last));
}

// Four vectors of pixels whose channels follow each other, as a group's channels.
//
//   lower  r0 g0 b0 a0 r1 g1 b1 a1   r2 g2 b2 a2 r3 g3 b3 a3      upper  R0 G0 ...
//   ->     r0 r1 r2 r3 g0 g1 g2 g3   b0 b1 b2 b3 a0 a1 a2 a3             R0 R1 ...
//   ->     r0 r1 r2 r3 R0 R1 R2 R3   g0 ...
HWY_INLINE void part_channels(const Pair<Vec16>& lower, const Pair<Vec16>& upper, Colour16& out) {
  const Tag16 d;
  const TagTexels wide;
  const auto part = [&](const Pair<Vec16>& v, VecTexels& rg, VecTexels& ba) HWY_ATTR {
    const Vec16 even = hn::InterleaveLower(d, v.lower, v.upper);  // pixels 0 and 2
    const Vec16 odd = hn::InterleaveUpper(d, v.lower, v.upper);   // pixels 1 and 3
    rg = hn::BitCast(wide, hn::InterleaveLower(d, even, odd));
    ba = hn::BitCast(wide, hn::InterleaveUpper(d, even, odd));
  };
  VecTexels rg0, ba0, rg1, ba1;
  part(lower, rg0, ba0);
  part(upper, rg1, ba1);
  out.channel[0] = hn::BitCast(d, hn::InterleaveLower(wide, rg0, rg1));
  out.channel[1] = hn::BitCast(d, hn::InterleaveUpper(wide, rg0, rg1));
  out.channel[2] = hn::BitCast(d, hn::InterleaveLower(wide, ba0, ba1));
  out.channel[3] = hn::BitCast(d, hn::InterleaveUpper(wide, ba0, ba1));
}

// NEAREST for half of a group.
template <WrapKind kS, WrapKind kT>
HWY_INLINE VecU sample_nearest_half(const SampleLevel& level, VecF s, VecF t, bool& close) {
  using sampling::HWY_NAMESPACE::nearest_axis;
  const TagI d;
  const VecI x = nearest_axis<kS>(s, level.width), y = nearest_axis<kT>(t, level.height);
  if (close) {
    const TexelWindow window(level, x, y, 2, 0);
    close = window.holds(hn::Zero(d));
    if (close) return window.take(0, 0);
  }
  const VecI row = hn::Mul(y, hn::Set(d, level.width));
  return gather_texels(level, hn::BitCast(TagU(), hn::Add(row, x)));
}

template <Filter kFilter, WrapKind kS, WrapKind kT>
void sample_row(const SampleLevel& from, const float* row_s, const float* row_t, Halves halves,
                RowColours& out) {
  const TagF d;
  const SampleLevel level = from;
  bool close = true;
  while (halves != 0) {
    const int group = std::countr_zero(halves) / 2;
    const Halves here = halves >> (2 * group);
    halves &= ~halves_of_group(group);
    const float* s = row_s + group * kGroup;
    const float* t = row_t + group * kGroup;
    Colour16 colour;
    if constexpr (kFilter == Filter::kLinear) {
      const Vec16 zero = hn::Zero(Tag16());
      Pair<Vec16> lower{zero, zero}, upper{zero, zero};
      if ((here & 1) != 0) {
        sample_linear_half<kS, kT>(level, hn::Load(d, s), hn::Load(d, t), close, lower.lower,
                                   lower.upper);
      }
      if ((here & 2) != 0) {
        sample_linear_half<kS, kT>(level, hn::Load(d, s + kGroup / 2), hn::Load(d, t + kGroup / 2),
                                   close, upper.lower, upper.upper);
      }
      part_channels(lower, upper, colour);
    } else {
      const VecU zero = hn::Zero(TagU());
      Pair<VecU> texels{zero, zero};
      if ((here & 1) != 0) {
        texels.lower = sample_nearest_half<kS, kT>(level, hn::Load(d, s), hn::Load(d, t), close);
      }
      if ((here & 2) != 0) {
        texels.upper = sample_nearest_half<kS, kT>(level, hn::Load(d, s + kGroup / 2),
                                                   hn::Load(d, t + kGroup / 2), close);
      }
      unpack_pixels(texels, colour.channel);
    }
    out.store(colour, group);
  }
}

RowSampler row_sampler(FusedSampler sampler) {
  constexpr RowSampler kSamplers[] = {
#define FUSED_SAMPLER(filter, wrap_s, wrap_t) \
  sample_row<Filter::k##filter, WrapKind::k##wrap_s, WrapKind::k##wrap_t>,
#include "pipeline/fragment/fused.def"
      nullptr};
  return kSamplers[static_cast<int>(sampler)];
}

#endif  // HWY_TARGET != HWY_SCALAR

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
