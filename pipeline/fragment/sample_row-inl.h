// The samplers of fused.def (row_sampler-inl.h): one level for the pixels of a row (3.7.7, 3.7.8).
//
// A bilinear sample takes two neighbours of each of two rows of texels. Where the pixels of a
// vector find theirs close together, a few whole loads bring all of them; else one load of 64 bits
// brings two neighbours of a pixel. Then each of the four texels is a vector, a lane for each
// pixel, and is interpolated as the chain does it (sample_colours-inl.h). SPDX-License-Identifier:
// MIT
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
#include "pipeline/fragment/sample_colours-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

// Two texels a lane, for the pixels of a vector: of the first two of each block, and of the last.
template <class V>
struct BlockPairs {
  V first, last;
};
// The same of two rows of texels.
template <class V>
struct RowPairs {
  BlockPairs<V> row[2];
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

// Loads by index from two rows, which take two thirds of the time of gathers (16 pixels, Zen 5).
// Indices leave their vector two at a time.
template <class D>
HWY_INLINE RowPairs<hn::Vec<hn::Repartition<uint64_t, D>>> load_pairs(
    D d, hn::Vec<D> index, const uint32_t* const (&rows)[2]) {
  const hn::Repartition<uint64_t, D> wide;
  const auto low_of = [](auto pairs) HWY_ATTR { return hn::GetLane(pairs); };
  const auto high_of = [](auto pairs) HWY_ATTR {
    return hn::GetLane(hn::UpperHalf(hn::Full64<uint64_t>(), pairs));
  };
  const auto at = [](const uint32_t* row, uint64_t i) {
    return reinterpret_cast<const uint64_t*>(row + i);
  };
  RowPairs<hn::Vec<decltype(wide)>> out;
  if constexpr (hn::MaxLanes(D()) == 4) {
    const hn::Half<decltype(wide)> half_wide;
    const auto pairs = hn::BitCast(wide, index);
    const uint64_t low = low_of(pairs), high = high_of(pairs);
    for (int r = 0; r < 2; ++r) {
      const auto load = [&](uint64_t i) HWY_ATTR { return hn::LoadU(half_wide, at(rows[r], i)); };
      out.row[r] = {hn::Combine(wide, load(low >> 32), load(low & 0xffffffffu)),
                    hn::Combine(wide, load(high >> 32), load(high & 0xffffffffu))};
    }
  } else if constexpr (hn::MaxLanes(D()) == 8) {
    const auto pairs = hn::BitCast(wide, index);
    const hn::Full128<uint64_t> block;
    const auto block0 = hn::LowerHalf(block, pairs), block1 = hn::UpperHalf(block, pairs);
    const uint64_t low0 = low_of(block0), high0 = high_of(block0);
    const uint64_t low1 = low_of(block1), high1 = high_of(block1);
    for (int r = 0; r < 2; ++r) {
      const auto four = [&](uint64_t a, uint64_t b) HWY_ATTR {
        const uint64_t* const places[4] = {at(rows[r], a & 0xffffffffu), at(rows[r], a >> 32),
                                           at(rows[r], b & 0xffffffffu), at(rows[r], b >> 32)};
        return from_lanes(wide, places);
      };
      out.row[r] = {four(low0, low1), four(high0, high1)};
    }
  } else {
    const hn::Half<D> half;
    const auto lower = load_pairs(half, hn::LowerHalf(half, index), rows);
    const auto upper = load_pairs(half, hn::UpperHalf(half, index), rows);
    for (int r = 0; r < 2; ++r) {
      out.row[r] = {hn::Combine(wide, upper.row[r].first, lower.row[r].first),
                    hn::Combine(wide, upper.row[r].last, lower.row[r].last)};
    }
  }
  return out;
}

// Texels of a vector of pixels and those that follow them.
struct TexelPairs {
  VecU first, second;
};

// Four texels of each pixel: two rows, in turn.
struct TexelSquares {
  TexelPairs row0, row1;
};

// Each texel and its right neighbour in memory, and what lies so far below them.
HWY_INLINE TexelSquares load_neighbours(const SampleLevel& level, VecI index, int below) {
  const TagU d;
  const uint32_t* const rows[2] = {level.texels, level.texels + below};
  const auto loaded = load_pairs(d, hn::BitCast(d, index), rows);
  const auto part = [&](const auto& pairs) HWY_ATTR {
    const VecU front = hn::BitCast(d, pairs.first), back = hn::BitCast(d, pairs.last);
    const VecU even = hn::InterleaveLower(d, front, back);  // pixels 0 and 2 of each block
    const VecU odd = hn::InterleaveUpper(d, front, back);   // pixels 1 and 3
    return TexelPairs{hn::InterleaveLower(d, even, odd), hn::InterleaveUpper(d, even, odd)};
  };
  return {part(loaded.row[0]), part(loaded.row[1])};
}

// The texels at any indices.
HWY_INLINE VecU gather_texels(const SampleLevel& level, VecI index) {
  const TagI d;
  return hn::BitCast(TagU(),
                     hn::GatherIndex(d, reinterpret_cast<const int32_t*>(level.texels), index));
}

// Both coordinates of a vector of pixels in fixed point, as linear_fixed() has them. Coordinates
// that are small enough, as nearly all are, become that by the rounding of an addition: the integer
// lies in the low bits then, and what lies above them does not matter to powers of two.
template <WrapKind kS, WrapKind kT>
HWY_INLINE void linear_fixed(const SampleLevel& level, VecF s, VecF t, VecI& x, VecI& y) {
  using sampling::HWY_NAMESPACE::linear_fixed;
  if constexpr (kS == WrapKind::kRepeatPowerOfTwo && kT == WrapKind::kRepeatPowerOfTwo) {
    const TagF d;
    const TagI di;
    const VecF magic = hn::Set(d, 12582912.0f - 128.0f);  // and half a texel less
    const auto fixed = [&](VecF v, int size) HWY_ATTR {
      const VecF scale = hn::Set(d, static_cast<float>(size) * 256.0f);
      return hn::BitCast(di, hn::Add(hn::Mul(v, scale), magic));
    };
    x = fixed(s, level.width);
    y = fixed(t, level.height);
    const VecI exponent = hn::Set(di, 0x4b000000);  // of sums in [2^23, 2^24)
    const VecI differs = hn::Or(hn::Xor(x, exponent), hn::Xor(y, exponent));
    const VecI high = hn::And(differs, hn::Set(di, static_cast<int32_t>(0xff800000)));
    if (HWY_LIKELY(hn::AllTrue(di, hn::Eq(high, hn::Zero(di))))) return;
  }
  x = linear_fixed<kS>(s, level.width);
  y = linear_fixed<kT>(t, level.height);
}

// Along a row of pixels columns and rows of texels go one way, so that the least of a vector are in
// its first lane or in its last. Where they do not, no window will hold.
class LeastLanes {
 public:
  // By the coordinates of the first vector that is sampled.
  HWY_INLINE LeastLanes(const float* s, const float* t)
      : column_(s[0] <= s[kLast] ? 0 : kLast), row_(t[0] <= t[kLast] ? 0 : kLast) {}

  HWY_INLINE VecI column(VecI v) const { return lane(v, column_); }
  HWY_INLINE VecI row(VecI v) const { return lane(v, row_); }

 private:
  static constexpr int kLast = static_cast<int>(hn::MaxLanes(TagI())) - 1;

  static HWY_INLINE VecI lane(VecI v, int which) {
    const TagI d;
    return hn::TableLookupLanes(v, hn::IndicesFromVec(d, hn::Set(d, which)));
  }

  int column_, row_;
};

// Pixels of a vector whose texels lie close together, as where a texture is about as large as what
// it covers, or larger: in two rows that follow each other, each no longer than a vector.
// Then a few loads of whole vectors bring all of them, and each pixel takes its own from there.
template <WrapKind kS, WrapKind kT>
class TexelWindow {
 public:
  // By the columns and rows of the pixels' first texels, of powers of two not wrapped yet. `more`
  // columns and rows on are taken too.
  HWY_INLINE TexelWindow(const SampleLevel& level, const LeastLanes& least, VecI column, VecI row,
                         int more)
      : width_(level.width) {
    const VecI least_column = least.column(column), least_row = least.row(row);
    column_ = hn::Sub(column, least_column);
    row_ = hn::Sub(row, least_row);
    const int column0 = wrap<kS>(hn::GetLane(least_column), level.width);
    const int row0 = wrap<kT>(hn::GetLane(least_row), level.height);
    is_inside_ = column0 >= 0 && row0 >= 0 && column0 + kLanes - 1 + more < level.width &&
                 row0 + 1 + more < level.height;
    texels_ = level.texels + row0 * width_ + column0;
  }

  // Whether all pixels find their texels.
  HWY_INLINE bool holds() const {
    const TagI d;
    const VecI outside =
        hn::Or(hn::AndNot(hn::Set(d, kLanes - 1), column_), hn::AndNot(hn::Set(d, 1), row_));
    return is_inside_ && hn::AllTrue(d, hn::Eq(outside, hn::Zero(d)));
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
  HWY_INLINE TexelPairs take_pairs(int rows) const { return {take(rows, 0), take(rows, 1)}; }

 private:
  static constexpr int kLanes = static_cast<int>(hn::MaxLanes(TagI()));

  template <WrapKind kWrap>
  static HWY_INLINE int wrap(int first, int size) {
    return kWrap == WrapKind::kRepeatPowerOfTwo ? first & (size - 1) : first;
  }

  const uint32_t* texels_;
  int width_;
  bool is_inside_;     // none of it is beyond an edge
  VecI column_, row_;  // of each pixel, counted from the window's first texel
};

// From anywhere in the level.
template <WrapKind kS, WrapKind kT>
HWY_INLINE TexelSquares load_squares(const SampleLevel& level, VecI x_fixed, VecI y_fixed) {
  using sampling::HWY_NAMESPACE::linear_texels;
  const TagI d;
  const auto x = linear_texels<kS>(x_fixed, level.width);
  const auto y = linear_texels<kT>(y_fixed, level.height);
  const VecI width = hn::Set(d, level.width), one = hn::Set(d, 1);
  const VecI start0 = hn::Mul(y.first, width);
  // Only at the edges of the level are the second texels not the neighbours of the first.
  const VecI apart =
      hn::Or(hn::Xor(x.second, hn::Add(x.first, one)), hn::Xor(y.second, hn::Add(y.first, one)));
  if (HWY_LIKELY(hn::AllTrue(d, hn::Eq(apart, hn::Zero(d))))) {
    return load_neighbours(level, hn::Add(start0, x.first), level.width);
  }
  const VecI start1 = hn::Mul(y.second, width);
  const auto both = [&](VecI start) HWY_ATTR {
    return TexelPairs{gather_texels(level, hn::Add(start, x.first)),
                      gather_texels(level, hn::Add(start, x.second))};
  };
  return {both(start0), both(start1)};
}

// 3.7.8 for a vector of pixels. `close` says whether windows are looked for: one that does not
// hold, away from the edges, rarely does further along the row.
template <WrapKind kS, WrapKind kT>
HWY_INLINE VecU sample_linear(const SampleLevel& level, const LeastLanes& least, VecF s, VecF t,
                              bool& close) {
  using namespace sampling::HWY_NAMESPACE;
  const TagI d;
  VecI x, y;
  fragment::HWY_NAMESPACE::linear_fixed<kS, kT>(level, s, t, x, y);
  TexelSquares texels;
  if (close) {
    const TexelWindow<kS, kT> window(level, least, hn::ShiftRight<8>(x), hn::ShiftRight<8>(y), 1);
    close = window.holds();
    if (close) texels = {window.take_pairs(0), window.take_pairs(1)};
  }
  if (!close) texels = load_squares<kS, kT>(level, x, y);
  const Weight a = spread<false>(x), b = spread<false>(y);  // by the fraction
  const auto across = [&](const TexelPairs& row) HWY_ATTR {
    return lerp(a, unpack(hn::BitCast(d, row.first)), unpack(hn::BitCast(d, row.second)));
  };
  return hn::BitCast(TagU(), pack(lerp(b, across(texels.row0), across(texels.row1))));
}

// NEAREST for a vector of pixels.
template <WrapKind kS, WrapKind kT>
HWY_INLINE VecU sample_nearest(const SampleLevel& level, const LeastLanes& least, VecF s, VecF t,
                               bool& close) {
  using sampling::HWY_NAMESPACE::nearest_axis;
  const TagI d;
  const VecI x = nearest_axis<kS>(s, level.width), y = nearest_axis<kT>(t, level.height);
  if (close) {
    const TexelWindow<kS, kT> window(level, least, x, y, 0);
    close = window.holds();
    if (close) return window.take(0, 0);
  }
  return gather_texels(level, hn::Add(hn::Mul(y, hn::Set(d, level.width)), x));
}

template <Filter kFilter, WrapKind kS, WrapKind kT>
void sample_row(const SampleLevel& from, const float* row_s, const float* row_t, Halves halves,
                RowPixels& out) {
  const TagF d;
  const SampleLevel level = from;
  const int first = std::countr_zero(halves) * (kGroup / 2);
  const LeastLanes least(row_s + first, row_t + first);
  bool close = true;
  for (; halves != 0; halves &= halves - 1) {
    const int at = std::countr_zero(halves) * (kGroup / 2);
    const VecF s = hn::Load(d, row_s + at), t = hn::Load(d, row_t + at);
    const VecU pixels = kFilter == Filter::kLinear
                            ? sample_linear<kS, kT>(level, least, s, t, close)
                            : sample_nearest<kS, kT>(level, least, s, t, close);
    hn::Store(pixels, TagU(), out.pixel + at);
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
