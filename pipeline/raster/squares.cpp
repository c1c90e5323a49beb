// Coverage in squares: see squares.h.
//
// First the squares that no edge leaves outside are found, one in each lane; then the pixels of
// each of them, a vector of pixels at a time.
//
//   lanes of the first step    0  1  2 ..  7     of the second, with 16 lanes   0  1 ..  7
//   (squares of the tile)      8  9 10 .. 15     (pixels of a square)           8  9 .. 15
// SPDX-License-Identifier: MIT
#include "pipeline/raster/squares.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "pipeline/raster/coverage.h"
#include "pipeline/raster/tile_part.h"
#include "pipeline/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/raster/squares.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using TagI = hn::CappedTag<int32_t, 16>;
using VecI = hn::Vec<TagI>;
constexpr int kLanes = static_cast<int>(hn::MaxLanes(TagI()));

// Bits of the lanes in which some value is negative.
template <int kEdges>
HWY_INLINE uint32_t outside_lanes(const VecI (&value)[kEdges]) {
  const TagI d;
  VecI any = value[0];
  for (int e = 1; e < kEdges; ++e) any = hn::Or(any, value[e]);
  uint8_t bits[8];
  hn::StoreMaskBits(d, hn::Lt(any, hn::Zero(d)), bits);
  // No more bytes than are stored, or compilers take them by way of memory.
  if constexpr (kLanes <= 8) return bits[0];
  uint16_t word;
  std::memcpy(&word, bits, sizeof(word));
  return word;
}

// The squares of a tile and the edges: square 8 * j + i is (i, j).
template <int kEdges>
class SquareEdges {
 public:
  explicit HWY_INLINE SquareEdges(const TileEdges& edges) {
    const TagI d;
    const VecI lane = hn::Iota(d, 0);
    const VecI column = hn::And(lane, hn::Set(d, kSmallSide - 1));
    const VecI row = hn::ShiftRight<3>(lane);
    for (int e = 0; e < kEdges; ++e) {
      const VecI a = hn::Set(d, edges.a[e]), b = hn::Set(d, edges.b[e]);
      offset_[e] = hn::Add(hn::Mul(a, column), hn::Mul(b, row));
      right_[e] = hn::Set(d, edges.a[e] * kLanes);
      up_[e] = hn::Set(d, edges.b[e] * kVectorRows);
    }
    find_touched(edges);
  }

  // Bit n: of square n, each edge leaves some pixel inside.
  uint32_t touched() const { return touched_; }

  // The pixels of a square that are inside all edges.
  HWY_INLINE uint64_t mask(int square) const {
    const TagI d;
    VecI first[kEdges];
    for (int e = 0; e < kEdges; ++e) {
      first[e] = hn::Add(offset_[e], hn::Set(d, corner_[e][square]));
    }
    uint64_t outside = 0;
    for (int j = 0; j < kSmallSide; j += kVectorRows) {
      VecI value[kEdges];
      for (int e = 0; e < kEdges; ++e) value[e] = first[e];
      for (int i = 0; i < kSmallSide; i += kLanes) {
        outside |= uint64_t{outside_lanes(value)} << (kSmallSide * j + i);
        for (int e = 0; e < kEdges; ++e) value[e] = hn::Add(value[e], right_[e]);
      }
      for (int e = 0; e < kEdges; ++e) first[e] = hn::Add(first[e], up_[e]);
    }
    return ~outside;
  }

 private:
  static constexpr int kVectorRows = std::max(kLanes / kSmallSide, 1);  // rows of a vector
  static constexpr int kSquares = CoveredSquares::kColumns * CoveredSquares::kRows;

  HWY_INLINE void find_touched(const TileEdges& edges) {
    static_assert(CoveredSquares::kColumns == 8 && kSmallSide == 8 && kSquares == 32);
    const TagI d;
    uint32_t outside = 0;
    for (int first = 0; first < kSquares; first += kLanes) {
      const VecI number = hn::Add(hn::Set(d, first), hn::Iota(d, 0));
      const VecI column = hn::ShiftLeft<3>(hn::And(number, hn::Set(d, 7)));
      const VecI row = hn::AndNot(hn::Set(d, 7), number);
      VecI most[kEdges];
      for (int e = 0; e < kEdges; ++e) {
        const int a = edges.a[e], b = edges.b[e];
        const VecI corner =
            hn::Add(hn::Add(hn::Mul(hn::Set(d, a), column), hn::Mul(hn::Set(d, b), row)),
                    hn::Set(d, edges.c[e]));
        hn::Store(corner, d, corner_[e] + first);
        const int reach = (kSmallSide - 1) * (std::max(a, 0) + std::max(b, 0));
        most[e] = hn::Add(corner, hn::Set(d, reach));
      }
      outside |= outside_lanes(most) << first;
    }
    touched_ = ~outside;
  }

  VecI offset_[kEdges];  // of a vector's pixels from the first
  VecI right_[kEdges], up_[kEdges];
  alignas(64) int32_t corner_[kEdges][kSquares];  // the edges at the squares' first pixels
  uint32_t touched_ = 0;
};

// The squares that the part of the tile touches.
HWY_INLINE uint32_t squares_of(const TilePart& part) {
  const int first_column = part.x0 / kSmallSide, last_column = (part.x1 - 1) / kSmallSide;
  const int first_row = part.y0 / kSmallSide, last_row = (part.y1 - 1) / kSmallSide;
  const uint32_t row = (0xffu >> (7 - (last_column - first_column))) << first_column;
  const uint32_t rows = 0x01010101u >> (8 * (3 - (last_row - first_row))) << (8 * first_row);
  return row * rows;
}

// The pixels of a square that are in the part.
HWY_INLINE uint64_t part_of_square(const TilePart& part, int column, int row) {
  constexpr uint64_t kEachRow = 0x0101010101010101u;
  const int left = std::max(part.x0 - column, 0), low = std::max(part.y0 - row, 0);
  const int right = std::max(column + kSmallSide - part.x1, 0);
  const int high = std::max(row + kSmallSide - part.y1, 0);
  const uint64_t columns = (0xffu >> right & 0xffu << left) * kEachRow;
  const uint64_t rows = ~uint64_t{0} >> kSmallSide * high & ~uint64_t{0} << kSmallSide * low;
  return columns & rows;
}

// With the squares that are touched, and the covered pixels of one.
template <class MaskOf>
HWY_INLINE void list_squares(uint32_t touched, const MaskOf& mask_of, CoveredSquares& out) {
  int count = 0;
  for (; touched != 0; touched &= touched - 1) {
    const int number = std::countr_zero(touched);
    const int column = number % CoveredSquares::kColumns * kSmallSide;
    const int row = number / CoveredSquares::kColumns * kSmallSide;
    const uint64_t mask = mask_of(number, column, row);
    out.square[count] = {mask, column, row};
    count += mask != 0 ? 1 : 0;
  }
  out.count = count;
}

// `cut`: inside the edges are pixels outside of the part.
template <int kEdges>
void CoverByEdges(const TileEdges& edges, const TilePart& part, bool cut, CoveredSquares& out) {
  const SquareEdges<kEdges> pixels(edges);
  const uint32_t touched = pixels.touched() & squares_of(part);
  if (cut) {
    const auto mask_of = [&](int square, int column, int row) HWY_ATTR {
      return pixels.mask(square) & part_of_square(part, column, row);
    };
    list_squares(touched, mask_of, out);
  } else {
    const auto mask_of = [&](int square, int, int) HWY_ATTR { return pixels.mask(square); };
    list_squares(touched, mask_of, out);
  }
}

void CoverSquares(const TileEdges& edges, const TilePart& part, bool cut, CoveredSquares& out) {
  switch (edges.count) {
    case 1:
      return CoverByEdges<1>(edges, part, cut, out);
    case 2:
      return CoverByEdges<2>(edges, part, cut, out);
    case 3:
      return CoverByEdges<3>(edges, part, cut, out);
    case 4:
      return CoverByEdges<4>(edges, part, cut, out);
    default:
      list_squares(
          squares_of(part),
          [&](int, int column, int row) HWY_ATTR { return part_of_square(part, column, row); },
          out);
  }
}

}  // namespace clearpipe::pipeline::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace clearpipe::pipeline {
namespace raster {

HWY_EXPORT(CoverSquares);

using CoverSquaresFunction = void (*)(const TileEdges&, const TilePart&, bool, CoveredSquares&);

static CoverSquaresFunction squares_function() {
  static const CoverSquaresFunction function = [] {
    select_simd_target();
    return static_cast<CoverSquaresFunction>(HWY_DYNAMIC_DISPATCH(CoverSquares));
  }();
  return function;
}

}  // namespace raster

bool cover_squares(const PrimitiveRecord& primitive, int tile_x, int tile_y,
                   CoveredSquares& squares) {
  const raster::TilePart part = raster::part_of_tile(primitive, tile_x, tile_y);
  TileEdges edges;
  if (part.empty() ||
      classify_tile(primitive, tile_x, tile_y, kCentrePlace, edges) == TileOverlap::kOutside) {
    return false;
  }
  raster::squares_function()(edges, part, primitive.cut, squares);
  return squares.count != 0;
}

}  // namespace clearpipe::pipeline
#endif  // HWY_ONCE
