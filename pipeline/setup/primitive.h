// A primitive after setup: what binning, rasterization and shading need, in one record.
//
// Edges are kept because every tile tests them; attribute planes are not: they are derived from the
// vertices by make_planes when a tile really shades pixels of the primitive.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "pipeline/fragment/program.h"
#include "pipeline/raster/circle.h"
#include "pipeline/raster/edge.h"
#include "pipeline/state.h"
#include "pipeline/vertex/vertex_stage.h"

namespace clearpipe::pipeline {

enum class PrimitiveKind : uint8_t { kPoint, kLine, kTriangle };  // of one, two, three vertices

// What setup needs to know of a draw, the same for all its primitives.
struct SetupState {
  RasterState raster;
  VertexLayout layout;
  Rect bounds;  // pixels that may be touched: the scissor box and the surface
  FragmentInputs inputs;
  FragmentCoverage coverage = FragmentCoverage::kCentre;
  float point_fade_threshold = 1;  // multisampled points are at least as large (3.3)
  int depth_bits = 24;             // of the depth buffer
  int mirror_height = 0;           // > 0: record y counts down from the top of a surface this high
  bool two_sided = false;          // back colour at layout.back_colour_offset
};

// How many pixels of a row a primitive covers, on average: fewer than 16, fewer than 40, or more.
enum class RowWidth : uint8_t { kNarrow, kMedium, kWide };

struct PrimitiveRecord {
  const float* vertex[3] = {};  // vertex records; points use one, lines two
  union {
    Edge edges[4] = {};
    Circle circle;  // if is_circle
  };
  // Pixels that may be covered, inside SetupState::bounds; half-open.
  int16_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  float size = 0;     // points: the size used; lines: +1 x-major, -1 y-major, 0 a rectangle
  uint32_t draw = 0;  // index of the draw in the frame
  PrimitiveKind kind = PrimitiveKind::kTriangle;
  bool multisample = false;  // its samples count, not the centre
  uint8_t edge_count = 0;    // 0: the whole box is covered, or the circle in it
  bool is_circle = false;
  bool back_facing = false;
  RowWidth width = RowWidth::kWide;
  bool narrow = false;  // so narrow that its pixels are shaded with others' (exec/small.h)
  bool cut = false;     // outside of the box may be pixels that are inside the edges
};

// The setup of each kind of primitive; false when nothing can be covered. The triangle's third
// vertex and the line's second one are provoking.
bool setup_triangle(const SetupState& state, const float* v0, const float* v1, const float* v2,
                    PrimitiveRecord& out);
bool setup_line(const SetupState& state, const float* v0, const float* v1, PrimitiveRecord& out);
bool setup_point(const SetupState& state, const float* v0, PrimitiveRecord& out);

// That of a box or a polygon whose area is so many pixels, in square subpixels.
inline RowWidth row_width(int64_t area, int32_t height) {
  const int64_t pixel = int64_t{kSubpixelOne} * height;
  if (area >= 40 * pixel) return RowWidth::kWide;
  return area >= 16 * pixel ? RowWidth::kMedium : RowWidth::kNarrow;
}

// Position snapped to 1/256 pixel and measured from the centre of pixel (0, 0), y upwards.
struct SnappedPoint {
  int32_t x = 0, y = 0;
};

// The rest of the setup of a line whose pixels are decided by their centres, from its corners.
bool setup_snapped_line(const SetupState& state, const float* v0, const float* v1, bool x_major,
                        const SnappedPoint corners[4], PrimitiveRecord& out);

// The nearest width that is supported for points and lines of any kind (3.3.1, 3.4.2).
inline float supported_width(float width) { return width > 1 ? std::min(width, 255.0f) : 1.0f; }

// The planes of the varyings in state.inputs, and of depth.
// Those of others stay as they are.
void make_planes(const SetupState& state, const PrimitiveRecord& primitive, PrimitivePlanes& out);

// That of depth alone, and where planes count from.
void make_depth_plane(const SetupState& state, const PrimitiveRecord& primitive,
                      PrimitivePlanes& out);

// What is added to the depth of a polygon's fragments (3.5.2).
float polygon_offset(const SetupState& state, const Plane& depth);

// Rounds to nearest, ties to even, as the reference's conversion does.
int32_t snap(float pixels);

// The record's y, mirrored into window coordinates.
inline int32_t mirror(const SetupState& state, int32_t y) {
  return state.mirror_height > 0 ? (state.mirror_height - 1) * kSubpixelOne - y : y;
}

// Window coordinates of a vertex record, as planes have them, and 1/w.
inline float window_x(const float* record) { return record[vertex_record::kWindow]; }
inline float window_y(const SetupState& state, const float* record) {
  const float y = record[vertex_record::kWindow + 1];
  return state.mirror_height > 0 ? static_cast<float>(state.mirror_height) - y : y;
}
inline float window_z(const float* record) { return record[vertex_record::kWindow + 2]; }
inline float inv_w(const float* record) { return record[vertex_record::kWindow + 3]; }

// Sets the box of the pixels with a place inside the given bounds, up to reach_of(state.coverage)
// away from their centre; false when it is empty.
bool set_box(const SetupState& state, const SnappedPoint& low, const SnappedPoint& high,
             PrimitiveRecord& out);

// Sets the edges of a convex polygon of `count` corners in either winding and the box of pixels it
// may cover; false when the box is empty.
bool set_polygon(const SetupState& state, const SnappedPoint* corners, int count,
                 PrimitiveRecord& out);

// How far from the centre of a pixel, in subpixels along each axis, lies what decides whether a
// primitive produces a fragment there: nothing but the centre, the samples, or the whole square.
// The square is taken a little larger: its exact coverage is found from unsnapped positions.
int32_t reach_of(FragmentCoverage coverage);

}  // namespace clearpipe::pipeline
