// Line setup (3.4): a line is a parallelogram whose long edges lie half a width before and after it
// along the minor axis, and whose short edges are placed so that exactly the columns (or rows) that
// the diamond-exit rule names are covered.
//
// All of it is said for an x-major line; a y-major one is the same with the axes exchanged.
//
// Antialiased and multisampled lines are rectangles along the line.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "pipeline/setup/stroke.h"

namespace clearpipe::pipeline {

namespace {

struct Point {
  float major, minor;
};

float from_centre(float v) { return v - std::floor(v) - 0.5f; }

// An end point as the diamond-exit rule sees it: its place in its pixel, whose diamond is
// |x - centre| + |y - centre| < 1/2.
struct EndPoint {
  float major, minor;  // offset from the centre of its pixel, [-0.5, 0.5)
  bool inside_diamond;

  explicit EndPoint(const Point& p)
      : major(from_centre(p.major)),
        minor(from_centre(p.minor)),
        inside_diamond(std::fabs(major) + std::fabs(minor) < 0.5f) {}
};

// 3.4.1: a fragment is produced for each pixel whose diamond the line exits. With a slope within
// +-1 a line that crosses the centre of a column is there inside the diamond of one of the column's
// pixels. So of an end's column a fragment is drawn when the line crosses its centre, and where the
// diamond of the end itself decides otherwise: a line that starts in it leaves it, one that ends in
// it does not.
bool start_is_drawn(const EndPoint& end, float direction) {
  return end.inside_diamond || end.major * direction <= 0;
}

bool end_is_drawn(const EndPoint& end, float direction) {
  return !end.inside_diamond && end.major * direction > 0;
}

// Moves an end point along the line to the border of its pixel's column, so that the column is
// covered (towards the outside) or not.
Point move_to_column_border(const Point& p, const EndPoint& end, float slope, float side) {
  const float offset = -end.major + side * 0.5f;
  return {p.major + offset, p.minor + offset * slope};
}

// 3.4.2, 3.4.4: two edges at half the width from the line, two through the end points.
bool setup_rectangle(const SetupState& state, const float* w0, const float* w1,
                     PrimitiveRecord& out) {
  const float dx = w1[0] - w0[0];
  const float dy = w1[1] - w0[1];
  const float square = dx * dx + dy * dy;
  if (square < 1e-6f) {
    return false;  // no area that shows
  }
  const float scale = 0.5f * supported_width(state.raster.line_width) / std::sqrt(square);
  // End points and distances are snapped each by itself, as the reference does.
  const int32_t nx = snap(-dy * scale), ny = snap(dx * scale);
  const int32_t x0 = snap(w0[0] - 0.5f), y0 = snap(w0[1] - 0.5f);
  const int32_t x1 = snap(w1[0] - 0.5f), y1 = snap(w1[1] - 0.5f);
  const SnappedPoint corners[4] = {{x0 - nx, mirror(state, y0 - ny)},
                                   {x1 - nx, mirror(state, y1 - ny)},
                                   {x1 + nx, mirror(state, y1 + ny)},
                                   {x0 + nx, mirror(state, y0 + ny)}};
  if (!set_polygon(state, corners, 4, out)) {
    return false;
  }
  if (state.coverage == FragmentCoverage::kSmooth) {
    // A square is touched when its corner towards the inside is inside.
    for (Edge& edge : out.edges) {
      edge.c += (std::abs(static_cast<int64_t>(edge.a)) + std::abs(static_cast<int64_t>(edge.b))) *
                reach_of(state.coverage);
    }
  }
  return true;
}

void set_line(const float* v0, const float* v1, float size, PrimitiveRecord& out) {
  out.kind = PrimitiveKind::kLine;
  out.vertex[0] = v0;
  out.vertex[1] = v1;
  out.size = size;
  out.back_facing = false;
}

}  // namespace

bool setup_snapped_line(const SetupState& state, const float* v0, const float* v1, bool x_major,
                        const SnappedPoint corners[4], PrimitiveRecord& out) {
  set_line(v0, v1, x_major ? 1.0f : -1.0f, out);
  return set_polygon(state, corners, 4, out);
}

bool setup_line(const SetupState& state, const float* v0, const float* v1, PrimitiveRecord& out) {
  const float* w0 = v0 + vertex_record::kWindow;
  const float* w1 = v1 + vertex_record::kWindow;
  const float dx = w1[0] - w0[0];
  const float dy = w1[1] - w0[1];
  if (dx == 0 && dy == 0) {
    return false;
  }
  if (state.coverage != FragmentCoverage::kCentre) {
    set_line(v0, v1, 0, out);
    return setup_rectangle(state, w0, w1, out);
  }
  const bool x_major = std::fabs(dx) >= std::fabs(dy);
  Point start = x_major ? Point{w0[0], w0[1]} : Point{w0[1], w0[0]};
  Point end = x_major ? Point{w1[0], w1[1]} : Point{w1[1], w1[0]};
  const float slope = x_major ? dy / dx : dx / dy;
  const float direction = (x_major ? dx : dy) > 0 ? 1.0f : -1.0f;

  // The plain parallelogram covers the columns whose centre lies between the end points, and that
  // which lies on its left or lower border: the start's or the end's, as the line goes. Where that
  // differs from the rule, the end moves to the column's border.
  const EndPoint s(start), e(end);
  const bool counts_down = !x_major && state.mirror_height > 0;
  const bool starts_at_lower = (direction > 0) != counts_down;
  const bool start_covered = s.major == 0 ? starts_at_lower : s.major * direction < 0;
  const bool end_covered = e.major == 0 ? !starts_at_lower : e.major * direction > 0;
  const bool start_drawn = start_is_drawn(s, direction);
  const bool end_drawn = end_is_drawn(e, direction);
  if (start_covered != start_drawn) {
    start = move_to_column_border(start, s, slope, start_drawn ? -direction : direction);
  }
  if (end_covered != end_drawn) {
    end = move_to_column_border(end, e, slope, end_drawn ? direction : -direction);
  }

  const int width = stroke_width(state.raster);
  const int32_t half = width * kSubpixelOne / 2;
  const int32_t start_major = snap(start.major - 0.5f), start_minor = snap(start.minor - 0.5f);
  const int32_t end_major = snap(end.major - 0.5f), end_minor = snap(end.minor - 0.5f);
  const int32_t major[4] = {start_major, end_major, end_major, start_major};
  const int32_t minor[4] = {start_minor - half, end_minor - half, end_minor + half,
                            start_minor + half};
  SnappedPoint corners[4];
  for (int i = 0; i < 4; ++i) {
    corners[i].x = x_major ? major[i] : minor[i];
    corners[i].y = mirror(state, x_major ? minor[i] : major[i]);
  }
  return setup_snapped_line(state, v0, v1, x_major, corners, out);
}

}  // namespace clearpipe::pipeline
