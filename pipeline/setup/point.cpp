// Point setup (3.3): aliased points cover a square of whole pixels, point sprites the exact square
// around their position, antialiased and multisampled points the circle.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "pipeline/setup/primitive.h"

namespace clearpipe::pipeline {

namespace {

// A rectangle of pixels, from the first of each axis to the one behind the last.
bool set_pixels(const SetupState& state, int left, int right, int bottom, int top,
                PrimitiveRecord& out) {
  const int x0 = std::max(left, state.bounds.x0), x1 = std::min(right, state.bounds.x1);
  const int y0 = std::max(bottom, state.bounds.y0), y1 = std::min(top, state.bounds.y1);
  if (x0 >= x1 || y0 >= y1) {
    return false;
  }
  out.x0 = static_cast<int16_t>(x0);
  out.y0 = static_cast<int16_t>(y0);
  out.x1 = static_cast<int16_t>(x1);
  out.y1 = static_cast<int16_t>(y1);
  out.edge_count = 0;
  return true;
}

// 3.3: an odd size is centred on a pixel, an even one on a pixel corner.
bool setup_square(const SetupState& state, const float* window, float size, PrimitiveRecord& out) {
  // Rounded to nearest; of two equally near, the smaller.
  const int width = static_cast<int>(std::ceil(size - 0.5f));
  int32_t x = snap(window[0]);
  int32_t y = snap(window[1]);
  if (state.mirror_height > 0) {
    y = state.mirror_height * kSubpixelOne - y;
  }
  const int rounding = (width & 1) != 0 ? 0 : kSubpixelOne / 2;
  const int left = ((x + rounding) >> kSubpixelBits) - width / 2;
  const int bottom = ((y + rounding) >> kSubpixelBits) - width / 2;
  return set_pixels(state, left, left + width, bottom, bottom + width, out);
}

bool setup_sprite(const SetupState& state, const float* window, float size, PrimitiveRecord& out) {
  const int32_t width = snap(size);
  const int32_t left = snap(window[0] - 0.5f) - width / 2;
  const int32_t first = snap(window[1] - 0.5f) - width / 2;
  const int32_t y0 = mirror(state, first), y1 = mirror(state, first + width);
  const int32_t low = std::min(y0, y1), high = std::max(y0, y1);
  if (state.coverage != FragmentCoverage::kCentre) {
    const SnappedPoint corners[4] = {
        {left, low}, {left + width, low}, {left + width, high}, {left, high}};
    return set_polygon(state, corners, 4, out);
  }
  // Centres on the left and the lower edge are inside, as edge.h has it.
  const auto centre = [](int32_t v) { return (v + kSubpixelOne - 1) >> kSubpixelBits; };
  out.width = row_width(int64_t{width} * width, width);
  return set_pixels(state, centre(left), centre(left + width), centre(low), centre(high), out);
}

// Smaller circles are shaded many at once (exec/small.h), with the corners of their boxes.
constexpr int kNarrowRadius = 8;

// 3.3.1, 3.3.3.
bool setup_circle(const SetupState& state, const float* window, float size, PrimitiveRecord& out) {
  const int32_t x = snap(window[0] - 0.5f);
  const int32_t y = mirror(state, snap(window[1] - 0.5f));
  const int32_t radius = snap(0.5f * size);
  const bool smooth = state.coverage == FragmentCoverage::kSmooth;
  out.is_circle = true;
  out.circle = {x, y, radius, smooth ? reach_of(state.coverage) : 0};
  if (smooth && radius <= kNarrowRadius * kSubpixelOne) out.width = RowWidth::kNarrow;
  return set_box(state, {x - radius, y - radius}, {x + radius, y + radius}, out);
}

}  // namespace

bool setup_point(const SetupState& state, const float* v0, PrimitiveRecord& out) {
  out.kind = PrimitiveKind::kPoint;
  out.vertex[0] = v0;
  out.back_facing = false;
  float size = v0[vertex_record::kPointSize];
  if (state.coverage == FragmentCoverage::kMultisamplePoint) {
    size = std::max(size, state.point_fade_threshold);  // equation 3.1
  }
  out.size = supported_width(size);
  const float* window = v0 + vertex_record::kWindow;
  if (state.raster.point_sprite) {
    return setup_sprite(state, window, out.size, out);
  }
  return state.coverage == FragmentCoverage::kCentre ? setup_square(state, window, out.size, out)
                                                     : setup_circle(state, window, out.size, out);
}

}  // namespace clearpipe::pipeline
