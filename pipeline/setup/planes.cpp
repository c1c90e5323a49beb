// Attribute planes: the linear functions of window position that shading evaluates (3.5.1, equation
// 3.6 solved for its gradients), with polygon offset (3.5.2) and the coordinates of point sprites.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "pipeline/setup/primitive.h"

namespace clearpipe::pipeline {

namespace {

// The gradients of a function that is 0 at the reference vertex: dx = d1 * x1 + d2 * x2, where d1
// and d2 are the differences of the other two vertices to the reference.
struct Basis {
  float x1 = 0, x2 = 0, y1 = 0, y2 = 0;

  Plane plane(float a0, float a1, float a2) const {
    const float d1 = a1 - a0;
    const float d2 = a2 - a0;
    return {a0, d1 * x1 + d2 * x2, d1 * y1 + d2 * y2};
  }
};

Basis triangle_basis(const SetupState& state, const PrimitiveRecord& p) {
  const float x10 = window_x(p.vertex[1]) - window_x(p.vertex[0]);
  const float x20 = window_x(p.vertex[2]) - window_x(p.vertex[0]);
  const float y0 = window_y(state, p.vertex[0]);
  const float y10 = window_y(state, p.vertex[1]) - y0;
  const float y20 = window_y(state, p.vertex[2]) - y0;
  const float area = x10 * y20 - x20 * y10;
  if (area == 0) {
    return {};
  }
  const float inverse = 1.0f / area;
  return {y20 * inverse, -y10 * inverse, -x20 * inverse, x10 * inverse};
}

// 3.4.1: the varyings of a line change along its major axis; those of a line that is a rectangle
// along the line itself (equation 3.3).
Basis line_basis(const SetupState& state, const PrimitiveRecord& p) {
  const float dx = window_x(p.vertex[1]) - window_x(p.vertex[0]);
  const float dy = window_y(state, p.vertex[1]) - window_y(state, p.vertex[0]);
  Basis basis;
  if (p.size > 0) {
    basis.x1 = 1.0f / dx;
  } else if (p.size < 0) {
    basis.y1 = 1.0f / dy;
  } else {
    const float square = dx * dx + dy * dy;
    basis.x1 = dx / square;
    basis.y1 = dy / square;
  }
  return basis;
}

// What has one colour needs no interpolation, whatever the shade model.
bool same_colour(const float* a, const float* b, const float* c) {
  return std::equal(a, a + 4, b) && std::equal(a, a + 4, c);
}

// 3.3.1, 3.4.2: what an antialiased point or line covers.
SmoothRegion smooth_region(const SetupState& state, const PrimitiveRecord& p) {
  if (p.kind == PrimitiveKind::kPoint) {
    return {true, 0.5f * p.size, 0, 0};
  }
  return {false, 0.5f * supported_width(state.raster.line_width),
          window_x(p.vertex[1]) - window_x(p.vertex[0]),
          window_y(state, p.vertex[1]) - window_y(state, p.vertex[0])};
}

// 3.3.1: s runs from 0 to 1 across the sprite, t from 0 at its top edge to 1 at its bottom edge.
void make_sprite_planes(const PrimitiveRecord& p, float inverse_w, Plane* out) {
  const float step = 1.0f / p.size;
  out[0] = {0.5f * inverse_w, step * inverse_w, 0};
  out[1] = {0.5f * inverse_w, 0, -step * inverse_w};
  out[2] = {0, 0, 0};
  out[3] = {inverse_w, 0, 0};
}

// A primitive's corners, the last of which is provoking, and the gradients they make.
struct Corners {
  const float* v[3];
  Basis basis;

  Corners(const SetupState& state, const PrimitiveRecord& p)
      : v{p.vertex[0], p.vertex[0], p.vertex[0]} {
    if (p.kind == PrimitiveKind::kTriangle) {
      v[1] = p.vertex[1];
      v[2] = p.vertex[2];
      basis = triangle_basis(state, p);
    } else if (p.kind == PrimitiveKind::kLine) {
      v[1] = p.vertex[1];
      basis = line_basis(state, p);
    }
  }
};

void set_depth_plane(const SetupState& state, const PrimitiveRecord& p, const Corners& corners,
                     PrimitivePlanes& out) {
  const auto& v = corners.v;
  out.x_ref = window_x(v[0]);
  out.y_ref = window_y(state, v[0]);
  if (!state.inputs.depth) return;
  out.depth = corners.basis.plane(window_z(v[0]), window_z(v[1]), window_z(v[2]));
  if (state.raster.offset_fill && p.kind == PrimitiveKind::kTriangle) {
    out.depth.value += polygon_offset(state, out.depth);
  }
}

}  // namespace

// 3.5.2: o = m * factor + r * units, with r the smallest step of the depth buffer, or of window
// depth itself where that is coarser.
float polygon_offset(const SetupState& state, const Plane& depth) {
  const RasterState& raster = state.raster;
  const float resolution = state.depth_bits == 16 ? 1.0f / 65535.0f : 1.0f / 16777215.0f;
  const float slope = std::max(std::fabs(depth.dx), std::fabs(depth.dy));
  const float offset = slope * raster.offset_factor + resolution * raster.offset_units;
  if (raster.offset_clamp == 0) return offset;  // EXT_polygon_offset_clamp
  return raster.offset_clamp > 0 ? std::min(offset, raster.offset_clamp)
                                 : std::max(offset, raster.offset_clamp);
}

void make_depth_plane(const SetupState& state, const PrimitiveRecord& p, PrimitivePlanes& out) {
  set_depth_plane(state, p, Corners(state, p), out);
}

void make_planes(const SetupState& state, const PrimitiveRecord& p, PrimitivePlanes& out) {
  const Corners corners(state, p);
  const auto& v = corners.v;
  const Basis& basis = corners.basis;
  const float* provoking = p.kind == PrimitiveKind::kLine ? v[1] : v[2];
  set_depth_plane(state, p, corners, out);
  out.flat_colour = false;
  out.region = {};
  out.point_fade = 1;
  if (state.coverage == FragmentCoverage::kSmooth) {
    out.region = smooth_region(state, p);
  } else if (state.coverage == FragmentCoverage::kMultisamplePoint) {
    out.point_fade = v[0][vertex_record::kPointAlpha];
  }
  const float w[3] = {inv_w(v[0]), inv_w(v[1]), inv_w(v[2])};
  out.perspective = w[0] != w[1] || w[0] != w[2];

  float scale[3] = {1, 1, 1};
  if (out.perspective) {
    out.inv_w = basis.plane(w[0], w[1], w[2]);
    std::copy(w, w + 3, scale);
  }
  const auto varying = [&](int offset) {
    return basis.plane(v[0][offset] * scale[0], v[1][offset] * scale[1], v[2][offset] * scale[2]);
  };
  if (state.inputs.colour) {
    const int offset =
        p.back_facing && state.two_sided ? state.layout.back_colour_offset : vertex_record::kColour;
    out.flat_colour = state.raster.flat_shade || p.kind == PrimitiveKind::kPoint ||
                      same_colour(v[0] + offset, v[1] + offset, v[2] + offset);
    for (int i = 0; i < 4; ++i) {
      Plane& plane = out.colour[i];
      plane = out.flat_colour ? Plane{provoking[offset + i], 0, 0} : varying(offset + i);
      plane = {plane.value * kColourOne, plane.dx * kColourOne, plane.dy * kColourOne};
    }
  }
  if (state.inputs.fog) {
    out.fog = varying(vertex_record::kFog);
  }
  for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
    if ((state.inputs.texture_units >> unit & 1) == 0) {
      continue;
    }
    if (p.kind == PrimitiveKind::kPoint && state.raster.point_sprite &&
        (state.raster.coord_replace >> unit & 1) != 0) {
      make_sprite_planes(p, 1.0f, out.texture[unit]);
      continue;
    }
    const int offset = state.layout.texture_offset[unit];
    for (int i = 0; i < 4; ++i) {
      out.texture[unit][i] = varying(offset + i);
    }
  }
}

}  // namespace clearpipe::pipeline
