// Attribute planes over a tile (3.5.1): what columns and rows share of their evaluation is found
// once, and an addition is left for each pixel.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_SPLIT_PLANE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_SPLIT_PLANE_INL_H_
#undef CLEARPIPE_FRAGMENT_SPLIT_PLANE_INL_H_
#else
#define CLEARPIPE_FRAGMENT_SPLIT_PLANE_INL_H_
#endif

#include <hwy/highway.h>

#include "pipeline/fragment/program.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Where the pixels of a tile are, relative to a primitive's reference. Sums begin with whole
// numbers, in every form of the stages.
struct TilePlaces {
  alignas(64) float x[kTileWidth], y[kTileHeight];

  TilePlaces(const Tile& tile, const PrimitivePlanes& planes) {
    set(tile.x, planes.x_ref, kTileWidth, x);
    set(tile.y, planes.y_ref, kTileHeight, y);
  }

 private:
  static HWY_INLINE void set(int first, float reference, int count, float* out) {
    const hn::ScalableTag<float> d;
    const auto to_centre = hn::Set(d, 0.5f - reference);
    for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d))) {
      const auto place = hn::Add(hn::Set(d, static_cast<float>(first + i)), hn::Iota(d, 0));
      hn::Store(hn::Add(place, to_centre), d, out + i);
    }
  }
};

// `evaluate` of interpolate-inl.h in its two parts: value + dy * y of rows, dx * x of columns.
class SplitPlane {
 public:
  HWY_INLINE void set(const Plane& plane, const TilePlaces& places) {
    const hn::ScalableTag<float> d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const auto value = hn::Set(d, plane.value), dx = hn::Set(d, plane.dx),
               dy = hn::Set(d, plane.dy);
    for (int i = 0; i < kTileHeight; i += lanes) {
      hn::Store(hn::Add(value, hn::Mul(dy, hn::Load(d, places.y + i))), d, row_ + i);
    }
    for (int i = 0; i < kTileWidth; i += lanes) {
      hn::Store(hn::Mul(dx, hn::Load(d, places.x + i)), d, column_ + i);
    }
  }

  // At the pixels of a row from `column` on, a whole vector of them.
  HWY_INLINE hn::Vec<hn::ScalableTag<float>> at(int row, int column) const {
    const hn::ScalableTag<float> d;
    return hn::Add(hn::Set(d, row_[row]), hn::LoadU(d, column_ + column));
  }

  // At the pixels of a column from `row` on.
  HWY_INLINE hn::Vec<hn::ScalableTag<float>> rows(int row, int column) const {
    const hn::ScalableTag<float> d;
    return hn::Add(hn::Load(d, row_ + row), hn::Set(d, column_[column]));
  }

  // Whether all values of some rows are in [low, high]. Rounding keeps order, so that the least
  // value and the greatest are at corners of the tile.
  bool lies_within(int first_row, int last_row, float low, float high) const {
    if (first_row >= last_row) return true;
    const auto inside = [&](int row, int column) {
      const float value = row_[row] + column_[column];
      return value >= low && value <= high;
    };
    return inside(first_row, 0) && inside(first_row, kTileWidth - 1) && inside(last_row - 1, 0) &&
           inside(last_row - 1, kTileWidth - 1);
  }

 private:
  friend class SplitRow;

  alignas(64) float row_[kTileHeight];
  alignas(64) float column_[kTileWidth];
};

// One of its rows.
class SplitRow {
 public:
  HWY_INLINE SplitRow(const SplitPlane& plane, int row)
      : row_(plane.row_[row]), columns_(plane.column_) {}

  HWY_INLINE float operator[](int column) const { return row_ + columns_[column]; }
  HWY_INLINE hn::Vec<hn::ScalableTag<float>> at(int column) const {
    const hn::ScalableTag<float> d;
    return hn::Add(hn::Set(d, row_), hn::Load(d, columns_ + column));
  }

 private:
  const float row_;
  const float* const columns_;
};

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
