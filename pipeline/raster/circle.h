// The region of a round point (3.3.1, 3.3.3), in exact integer arithmetic.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "pipeline/raster/samples.h"

namespace clearpipe::pipeline {

// In subpixels, measured from the centre of pixel (0, 0).
struct Circle {
  int32_t x, y, radius;
  int32_t reach;  // a place at most this far from the circle along each axis counts as inside
};

// The pixels of a row whose place lies inside: columns [first, end), none when first >= end.
struct Span {
  int32_t first, end;
};
Span circle_span(const Circle& circle, int32_t row, const SamplePlace& place);

}  // namespace clearpipe::pipeline
