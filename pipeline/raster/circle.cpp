// The rows of a circle: see circle.h.
// SPDX-License-Identifier: MIT
#include "pipeline/raster/circle.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "pipeline/raster/edge.h"

namespace clearpipe::pipeline {

namespace {

// The largest integer whose square is not larger; exact, because a double holds every value here
// and its square root is rounded correctly.
int32_t integer_sqrt(int64_t value) {
  return static_cast<int32_t>(std::sqrt(static_cast<double>(value)));
}

}  // namespace

Span circle_span(const Circle& circle, int32_t row, const SamplePlace& place) {
  const int64_t away =
      std::max(std::abs(row * kSubpixelOne + place.y - circle.y) - circle.reach, 0);
  const int64_t square = static_cast<int64_t>(circle.radius) * circle.radius - away * away;
  if (square < 0) {
    return {0, 0};
  }
  const int32_t half = integer_sqrt(square) + circle.reach;
  const int32_t centre = circle.x - place.x;
  return {(centre - half + kSubpixelOne - 1) >> kSubpixelBits,
          ((centre + half) >> kSubpixelBits) + 1};
}

}  // namespace clearpipe::pipeline
