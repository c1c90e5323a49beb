// Coverage of a tile: see coverage.h.
//
// A row is covered where all edge functions are non-negative: their values are OR-ed, and the sign
// bits of a vector of columns are bits of the row mask. Only the columns of the primitive's box are
// looked at.
// SPDX-License-Identifier: MIT
#include "pipeline/raster/coverage.h"

#include <algorithm>
#include <cstring>
#include <iterator>

#include "pipeline/raster/tile_part.h"
#include "pipeline/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/raster/coverage.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Row masks of the columns [first_column, end_column) for the rows [first_row, end_row), without
// the columns outside that range masked off.
template <int kEdges>
void CoverRows(const TileEdges& edges, int first_column, int end_column, int first_row, int end_row,
               uint64_t* rows) {
  const hn::CappedTag<int32_t, 16> d;
  using V = hn::Vec<decltype(d)>;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const int first = first_column / lanes * lanes;
  const V column = hn::Add(hn::Set(d, first), hn::Iota(d, 0));
  V row_value[kEdges], step[kEdges], next_row[kEdges];
  for (int e = 0; e < kEdges; ++e) {
    const V a = hn::Set(d, edges.a[e]);
    row_value[e] = hn::Add(hn::Mul(a, column), hn::Set(d, edges.c[e] + edges.b[e] * first_row));
    step[e] = hn::Set(d, edges.a[e] * lanes);
    next_row[e] = hn::Set(d, edges.b[e]);
  }
  const V zero = hn::Zero(d);
  for (int row = first_row; row < end_row; ++row) {
    V value[kEdges];
    for (int e = 0; e < kEdges; ++e) {
      value[e] = row_value[e];
      row_value[e] = hn::Add(row_value[e], next_row[e]);
    }
    uint64_t outside = 0;
    for (int x = first; x < end_column; x += lanes) {
      V any = value[0];
      for (int e = 1; e < kEdges; ++e) {
        any = hn::Or(any, value[e]);
      }
      uint8_t bits[8] = {};
      hn::StoreMaskBits(d, hn::Lt(any, zero), bits);
      uint32_t word;
      std::memcpy(&word, bits, sizeof(word));
      outside |= static_cast<uint64_t>(word) << x;
      for (int e = 0; e < kEdges; ++e) {
        value[e] = hn::Add(value[e], step[e]);
      }
    }
    rows[row] = ~outside;
  }
}

void CoverAllRows(const TileEdges& edges, int first_column, int end_column, int first_row,
                  int end_row, uint64_t* rows) {
  switch (edges.count) {
    case 1:
      return CoverRows<1>(edges, first_column, end_column, first_row, end_row, rows);
    case 2:
      return CoverRows<2>(edges, first_column, end_column, first_row, end_row, rows);
    case 3:
      return CoverRows<3>(edges, first_column, end_column, first_row, end_row, rows);
    case 4:
      return CoverRows<4>(edges, first_column, end_column, first_row, end_row, rows);
    default:
      std::fill(rows + first_row, rows + end_row, ~uint64_t{0});
  }
}

}  // namespace clearpipe::pipeline::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace clearpipe::pipeline {
namespace raster {

HWY_EXPORT(CoverAllRows);

using CoverRowsFunction = void (*)(const TileEdges&, int, int, int, int, uint64_t*);

static CoverRowsFunction cover_rows() {
  static const CoverRowsFunction function = [] {
    select_simd_target();
    return static_cast<CoverRowsFunction>(HWY_DYNAMIC_DISPATCH(CoverAllRows));
  }();
  return function;
}

static uint64_t columns_mask(int first, int end) {
  return first < end ? (~uint64_t{0} >> (kTileWidth - (end - first))) << first : 0;
}

static void cover_circle(const Circle& circle, int tile_x, int tile_y, const TilePart& part,
                         const SamplePlace& place, uint64_t* rows) {
  for (int row = part.y0; row < part.y1; ++row) {
    const Span span = circle_span(circle, tile_y + row, place);
    rows[row] =
        columns_mask(std::max(span.first - tile_x, part.x0), std::min(span.end - tile_x, part.x1));
  }
}

// Coverage of one place of each pixel of the part.
static bool cover_place(const PrimitiveRecord& primitive, int tile_x, int tile_y,
                        const TilePart& part, const SamplePlace& place, Coverage& coverage) {
  coverage.first_row = coverage.last_row = 0;
  if (primitive.is_circle) {
    cover_circle(primitive.circle, tile_x, tile_y, part, place, coverage.rows);
  } else {
    TileEdges edges;
    if (classify_tile(primitive, tile_x, tile_y, place, edges) == TileOverlap::kOutside) {
      return false;
    }
    cover_rows()(edges, part.x0, part.x1, part.y0, part.y1, coverage.rows);
  }
  const uint64_t columns = columns_mask(part.x0, part.x1);
  int first = part.y1, last = part.y0;
  for (int row = part.y0; row < part.y1; ++row) {
    coverage.rows[row] &= columns;
    if (coverage.rows[row] != 0) {
      first = std::min(first, row);
      last = row + 1;
    }
  }
  coverage.first_row = first;
  coverage.last_row = std::max(first, last);
  return first < last;
}

}  // namespace raster

TileOverlap classify_tile(const PrimitiveRecord& primitive, int tile_x, int tile_y,
                          const SamplePlace& place, TileEdges& edges) {
  // Without branches: which edges cross a tile cannot be guessed.
  int count = 0;
  int64_t most_of_all = 0;
  for (int i = 0; i < primitive.edge_count; ++i) {
    const Edge& edge = primitive.edges[i];
    const int64_t corner = edge.at(place.x, place.y) + static_cast<int64_t>(edge.a) * tile_x +
                           static_cast<int64_t>(edge.b) * tile_y;
    const int32_t across = edge.a * (kTileWidth - 1);
    const int32_t up = edge.b * (kTileHeight - 1);
    const int64_t least = corner + std::min(across, 0) + std::min(up, 0);
    const int64_t most = corner + std::max(across, 0) + std::max(up, 0);
    most_of_all = std::min(most_of_all, most);
    // Where least < 0 <= most the corner is within the tile's steps of zero, so 32 bits hold it.
    edges.a[count] = edge.a;
    edges.b[count] = edge.b;
    edges.c[count] = static_cast<int32_t>(corner);
    count += least < 0 ? 1 : 0;
  }
  edges.count = count;
  if (most_of_all < 0) return TileOverlap::kOutside;
  return count == 0 ? TileOverlap::kInside : TileOverlap::kPartial;
}

bool misses_tile(const PrimitiveRecord& primitive, int tile_x, int tile_y) {
  TileEdges edges;
  const auto misses = [&](const SamplePlace& place) {
    return classify_tile(primitive, tile_x, tile_y, place, edges) == TileOverlap::kOutside;
  };
  return primitive.multisample
             ? std::all_of(std::begin(kSamplePlaces), std::end(kSamplePlaces), misses)
             : misses(kCentrePlace);
}

bool cover_tile(const PrimitiveRecord& primitive, int tile_x, int tile_y, Coverage& coverage) {
  const raster::TilePart part = raster::part_of_tile(primitive, tile_x, tile_y);
  return !part.empty() &&
         raster::cover_place(primitive, tile_x, tile_y, part, kCentrePlace, coverage);
}

bool cover_samples(const PrimitiveRecord& primitive, int tile_x, int tile_y,
                   Coverage coverage[kSampleCount]) {
  const raster::TilePart part = raster::part_of_tile(primitive, tile_x, tile_y);
  bool any = false;
  for (int s = 0; s < kSampleCount && !part.empty(); ++s) {
    any |= raster::cover_place(primitive, tile_x, tile_y, part, kSamplePlaces[s], coverage[s]);
  }
  return any;
}

}  // namespace clearpipe::pipeline
#endif  // HWY_ONCE
