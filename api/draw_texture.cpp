// Rectangles of textures on the screen (OES_draw_texture).
//
// The pixels that the rectangle overlaps get fragments: a box of whole pixels. It is drawn as one
// triangle twice as wide and high, of which the scissor keeps the box, so that every pixel takes
// its texture coordinates from the same plane. The vertices stand in window coordinates already:
// the viewport, the matrices, clip planes, culling and polygon offset have no part in it.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "api/draw.h"
#include "api/exec.h"
#include "api/texture_target.h"

namespace clearpipe::api::exec {

namespace {

// Pixels along one axis, half-open.
struct Span {
  int first = 0, end = 0;
  bool empty() const { return first >= end; }
};

// Those that a range of window coordinates overlaps, as far as there are so many.
Span overlapped(double low, double high, int limit) {
  if (!(low < limit && high > 0)) return {};
  return {low > 0 ? static_cast<int>(std::floor(low)) : 0,
          high < limit ? static_cast<int>(std::ceil(high)) : limit};
}

// One axis of the rectangle on the screen.
struct Axis {
  double origin, size;
  Span span;
  // The corners of the triangle lie at the first pixel and twice the span from it.
  double corner(bool far) const { return span.first + (far ? 2 * (span.end - span.first) : 0); }
  // s = (Ucr + (X - Xs) * (Wcr / Ws)) / Wt, or t, at a corner.
  float coordinate(bool far, GLint crop_origin, GLint crop_size, int texels) const {
    return static_cast<float>((crop_origin + (corner(far) - origin) * (crop_size / size)) / texels);
  }
};

// Clip coordinates are window coordinates over this; exactly, since it is a power of two, and small
// enough for the view volume.
constexpr float kScale = 65536;

constexpr size_t kCorners = 3;
struct Triangle {
  Vec4 position[kCorners];
  Vec4 tex_coord[kTextureUnits][kCorners];
};

Triangle make_triangle(const Context& c, const Axis& x, const Axis& y, float depth) {
  Triangle t;
  for (size_t k = 0; k < kCorners; ++k) {
    const bool right = k == 1, top = k == 2;
    t.position[k] = {static_cast<float>(x.corner(right)) / kScale,
                     static_cast<float>(y.corner(top)) / kScale, depth, 1};
    for (size_t u = 0; u < kTextureUnits; ++u) {
      if (!(c.vertex_state.texture_units >> u & 1)) continue;
      const TextureObject& texture = *enabled_texture(c.state.texture.unit[u]);
      const GLint* crop = texture.crop_rect;
      // An external texture may have no image.
      const int columns = std::max(texture.level[0].width, 1);
      const int rows = std::max(texture.level[0].height, 1);
      t.tex_coord[u][k] = {x.coordinate(right, crop[0], crop[2], columns),
                           y.coordinate(top, crop[1], crop[3], rows), 0, 1};
    }
  }
  return t;
}

// Colour and depth are the same everywhere, and the distance for fog is zero.
pipeline::VertexState vertex_state(const Context& c) {
  pipeline::VertexState v;
  v.model_view.m.fill(0);
  v.fog = c.vertex_state.fog;
  v.texture_units = c.vertex_state.texture_units;
  return v;
}

pipeline::RasterState raster_state(const Context& c, const Span& columns, const Span& rows) {
  pipeline::RasterState r = c.raster_state;
  r.viewport = {kScale, kScale, 1, 0, 0, 0};
  r.scissor = {std::max(r.scissor.x0, columns.first), std::max(r.scissor.y0, rows.first),
               std::min(r.scissor.x1, columns.end), std::min(r.scissor.y1, rows.end)};
  r.cull = pipeline::CullFace::kNone;
  r.offset_fill = false;
  return r;
}

pipeline::AttributeSource corners(const Vec4* values) {
  pipeline::AttributeSource source;
  source.is_array = true;
  source.stride = sizeof(Vec4);
  source.pointer = reinterpret_cast<const std::byte*>(values);
  return source;
}

}  // namespace

void draw_texture(Context& c, float x, float y, float z, float width, float height) {
  update_draw_state(c);
  const double left = x, bottom = y;
  const Axis across{left, width, overlapped(left, left + width, c.draw.width)};
  const Axis up{bottom, height, overlapped(bottom, bottom + height, c.draw.height)};
  if (across.span.empty() || up.span.empty()) return;

  const float n = c.state.transform.depth_range[0], f = c.state.transform.depth_range[1];
  const Triangle triangle = make_triangle(c, across, up, n + clamp01(z) * (f - n));
  pipeline::DrawCommand command;
  command.count = kCorners;
  command.attributes[0] = corners(triangle.position);
  command.attributes[2].constant = c.state.current.colour;
  for (size_t u = 0; u < kTextureUnits; ++u) {
    command.attributes[4 + u] = corners(triangle.tex_coord[u]);
  }
  note_texture_uses(c);
  c.frame.set_vertex_state(vertex_state(c));
  c.frame.set_raster_state(raster_state(c, across.span, up.span));
  c.dirty |= kDirtyVertex | kDirtyRaster;
  if (!c.frame.draw(command)) c.set_error(kOutOfMemory);
}

}  // namespace clearpipe::api::exec
