// Setup of strokes: see stroke.h.
// SPDX-License-Identifier: MIT
#include "pipeline/setup/stroke.h"

#include <algorithm>
#include <cmath>

namespace clearpipe::pipeline {

namespace {

// The pixels of an axis with centres from the least to the greatest of some coordinates. A centre
// on the last short edge of a line is not covered, one on the first is (edge.h): they are the ends
// of its major axis.
struct Range {
  int first, end;

  Range(int32_t least, int32_t most, bool is_major)
      : first((least + kSubpixelOne - 1) >> kSubpixelBits),
        end((most + kSubpixelOne - (is_major ? 1 : 0)) >> kSubpixelBits) {}
};

// False when the box is empty.
bool set_box(const SetupState& state, const SnappedPoint corners[4], StrokeRecord& out) {
  // Opposite corners are those of the two long edges.
  const auto [least_x, most_x] =
      std::minmax({corners[0].x, corners[1].x, corners[2].x, corners[3].x});
  const auto [least_y, most_y] =
      std::minmax({corners[0].y, corners[1].y, corners[2].y, corners[3].y});
  const Range columns(least_x, most_x, out.x_major), rows(least_y, most_y, !out.x_major);
  const int x0 = std::max(columns.first, state.bounds.x0);
  const int y0 = std::max(rows.first, state.bounds.y0);
  const int x1 = std::min(columns.end, state.bounds.x1);
  const int y1 = std::min(rows.end, state.bounds.y1);
  out.x0 = static_cast<int16_t>(x0);
  out.y0 = static_cast<int16_t>(y0);
  out.x1 = static_cast<int16_t>(x1);
  out.y1 = static_cast<int16_t>(y1);
  return x0 < x1 && y0 < y1;
}

// Of the long edges that one where rows begin: the other is the same, moved by the width, with the
// inside on its other side. So pixels that are inside of both are those which are inside of this
// one, while those that lie the width below are not.
void set_edge(const SnappedPoint corners[4], StrokeRecord& out) {
  const auto major = [&](const SnappedPoint& p) { return out.x_major ? p.x : p.y; };
  const auto minor = [&](const SnappedPoint& p) { return out.x_major ? p.y : p.x; };
  const bool first = minor(corners[0]) < minor(corners[3]);
  SnappedPoint p = corners[first ? 0 : 3], q = corners[first ? 1 : 2];
  // Inside is to the left: above what goes to the right, to the right of what goes down.
  if ((major(p) < major(q)) != out.x_major) std::swap(p, q);
  const Edge edge = make_edge(p.x, p.y, q.x, q.y);
  out.start = edge.at(kCentrePlace.x, kCentrePlace.y);
  out.slope = out.x_major ? edge.a : edge.b;
  out.step = out.x_major ? edge.b : edge.a;
}

void set_values(const SetupState& state, const float* v0, const float* v1, StrokeRecord& out) {
  const float start = out.x_major ? window_x(v0) : window_y(state, v0);
  const float end = out.x_major ? window_x(v1) : window_y(state, v1);
  const float inverse = 1.0f / (end - start);
  const auto value = [inverse](float a0, float a1) { return StrokeValue{a0, (a1 - a0) * inverse}; };
  out.reference = start;
  out.depth = value(window_z(v0), window_z(v1));
  const float w0 = inv_w(v0), w1 = inv_w(v1);
  out.perspective = w0 != w1;
  out.inv_w = value(w0, w1);
  const float* const c0 = v0 + vertex_record::kColour;
  const float* const c1 = v1 + vertex_record::kColour;
  out.flat_colour = state.raster.flat_shade || std::equal(c0, c0 + 4, c1);
  const float scale0 = out.perspective ? w0 : 1, scale1 = out.perspective ? w1 : 1;
  for (int i = 0; i < 4; ++i) {
    const StrokeValue v =
        out.flat_colour ? StrokeValue{c1[i], 0} : value(c0[i] * scale0, c1[i] * scale1);
    out.colour[i] = v.value * kColourOne;
    out.colour_step[i] = v.step * kColourOne;
  }
}

}  // namespace

int stroke_width(const RasterState& state) {
  return static_cast<int>(std::floor(supported_width(state.line_width) + 0.5f));
}

bool setup_stroke(const SetupState& state, const float* v0, const float* v1, bool x_major,
                  const SnappedPoint corners[4], StrokeRecord& out) {
  out.x_major = x_major;
  out.width = static_cast<uint8_t>(stroke_width(state.raster));
  if (!set_box(state, corners, out)) return false;
  set_edge(corners, out);
  set_values(state, v0, v1, out);
  return true;
}

}  // namespace clearpipe::pipeline
