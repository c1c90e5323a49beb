// Raster state from GL state: viewport, scissor, culling, offset, points and lines.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "api/context_state.h"

namespace clearpipe::api {

void derive_raster(Context& context) {
  const State& s = context.state;
  pipeline::RasterState& r = context.raster_state;
  const GLint* box = s.transform.viewport;
  const float n = s.transform.depth_range[0], f = s.transform.depth_range[1];
  r.viewport.scale_x = static_cast<float>(box[2]) * 0.5f;
  r.viewport.scale_y = static_cast<float>(box[3]) * 0.5f;
  r.viewport.scale_z = (f - n) * 0.5f;
  r.viewport.centre_x = static_cast<float>(box[0]) + r.viewport.scale_x;
  r.viewport.centre_y = static_cast<float>(box[1]) + r.viewport.scale_y;
  r.viewport.centre_z = (f + n) * 0.5f;

  const int width = context.draw.width, height = context.draw.height;
  r.scissor = {0, 0, width, height};
  if (s.pixel.scissor_test) {
    const GLint* scissor = s.pixel.scissor;
    auto end = [](GLint origin, GLint size, int limit) {
      return static_cast<int>(std::clamp<int64_t>(static_cast<int64_t>(origin) + size, 0, limit));
    };
    r.scissor = {std::clamp(scissor[0], 0, width), std::clamp(scissor[1], 0, height),
                 end(scissor[0], scissor[2], width), end(scissor[1], scissor[3], height)};
  }

  r.cull = pipeline::CullFace::kNone;
  if (s.raster.cull_face) {
    r.cull = s.raster.cull_mode == GL_FRONT  ? pipeline::CullFace::kFront
             : s.raster.cull_mode == GL_BACK ? pipeline::CullFace::kBack
                                             : pipeline::CullFace::kFrontAndBack;
  }
  r.front_is_clockwise = s.raster.front_face == GL_CW;
  r.flat_shade = s.lighting.shade_model == GL_FLAT;
  r.offset_fill = s.raster.offset_fill;
  r.offset_factor = s.raster.offset_factor;
  r.offset_units = s.raster.offset_units;
  // Not clamped where the clamp is no number (EXT_polygon_offset_clamp).
  r.offset_clamp = std::isfinite(s.raster.offset_clamp) ? s.raster.offset_clamp : 0;
  r.line_width = std::clamp(s.raster.line_width, 1.0f, kMaxLineWidth);
  r.line_smooth = s.raster.line_smooth;
  r.point_smooth = s.raster.point_smooth;
  r.point_sprite = s.raster.point_sprite;
  r.coord_replace = 0;
  for (size_t u = 0; u < kTextureUnits; ++u) {
    if (s.texture.unit[u].coord_replace) {
      r.coord_replace = static_cast<uint8_t>(r.coord_replace | 1u << u);
    }
  }
  r.multisample = s.multisample.enabled;
  context.frame.set_raster_state(r);
}

}  // namespace clearpipe::api
