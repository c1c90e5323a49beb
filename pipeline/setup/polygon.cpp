// What triangles, lines and points share: snapping, edges and the box of pixels.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "pipeline/setup/primitive.h"

namespace clearpipe::pipeline {

int32_t snap(float pixels) {
  const float v = pixels * static_cast<float>(kSubpixelOne);
  // Below 2^22, adding 1.5 * 2^23 rounds to the nearest integer; a call of the library takes
  // longer.
  constexpr float kMagic = 12582912.0f, kLimit = 4194304.0f;
  const float rounded = std::fabs(v) < kLimit ? (v + kMagic) - kMagic : std::nearbyint(v);
  return static_cast<int32_t>(rounded);
}

int32_t reach_of(FragmentCoverage coverage) {
  switch (coverage) {
    case FragmentCoverage::kCentre:
      return 0;
    case FragmentCoverage::kSmooth:
      return kSubpixelOne / 2 + 2;
    case FragmentCoverage::kMultisample:
    case FragmentCoverage::kMultisamplePoint:
      return kSampleReach;
  }
  return 0;
}

bool set_box(const SetupState& state, const SnappedPoint& low, const SnappedPoint& high,
             PrimitiveRecord& out) {
  const int32_t reach = reach_of(state.coverage);
  // Centres lie at whole pixels: the first one not left of low, and the last one not right of high.
  const auto first_centre = [reach](int32_t v) {
    return (v - reach + kSubpixelOne - 1) >> kSubpixelBits;
  };
  const auto last_centre = [reach](int32_t v) { return (v + reach) >> kSubpixelBits; };
  const int left = first_centre(low.x), right = last_centre(high.x) + 1;
  const int lower = first_centre(low.y), upper = last_centre(high.y) + 1;
  const int x0 = std::max(left, state.bounds.x0), x1 = std::min(right, state.bounds.x1);
  const int y0 = std::max(lower, state.bounds.y0), y1 = std::min(upper, state.bounds.y1);
  if (x0 >= x1 || y0 >= y1) {
    return false;
  }
  out.cut = reach != 0 || x0 != left || x1 != right || y0 != lower || y1 != upper;
  out.x0 = static_cast<int16_t>(x0);
  out.y0 = static_cast<int16_t>(y0);
  out.x1 = static_cast<int16_t>(x1);
  out.y1 = static_cast<int16_t>(y1);
  out.multisample = is_multisample(state.coverage);
  return true;
}

bool set_polygon(const SetupState& state, const SnappedPoint* corners, int count,
                 PrimitiveRecord& out) {
  int32_t min_x = corners[0].x, max_x = corners[0].x;
  int32_t min_y = corners[0].y, max_y = corners[0].y;
  for (int i = 1; i < count; ++i) {
    min_x = std::min(min_x, corners[i].x);
    max_x = std::max(max_x, corners[i].x);
    min_y = std::min(min_y, corners[i].y);
    max_y = std::max(max_y, corners[i].y);
  }
  if (!set_box(state, {min_x, min_y}, {max_x, max_y}, out)) {
    return false;
  }
  out.edge_count = static_cast<uint8_t>(count);
  int64_t doubled_area = 0;
  for (int i = 0; i < count; ++i) {
    const SnappedPoint& p = corners[i];
    const SnappedPoint& q = corners[(i + 1) % count];
    doubled_area += static_cast<int64_t>(p.x) * q.y - static_cast<int64_t>(q.x) * p.y;
  }
  out.width = row_width(std::abs(doubled_area) / 2, max_y - min_y);
  for (int i = 0; i < count; ++i) {
    const SnappedPoint& p = corners[i];
    const SnappedPoint& q = corners[(i + 1) % count];
    out.edges[i] =
        doubled_area >= 0 ? make_edge(p.x, p.y, q.x, q.y) : make_edge(q.x, q.y, p.x, p.y);
  }
  return true;
}

}  // namespace clearpipe::pipeline
