// Setters of current values, rasterization, fragment and framebuffer state (2.7, 3.2 to 3.5, 3.8,
// 4.1, 4.2).
// SPDX-License-Identifier: MIT
#include "api/exec.h"

namespace clearpipe::api {

Capability capability(Context& c, GLenum cap) {
  State& s = c.state;
  if (cap >= GL_LIGHT0 && cap < GL_LIGHT0 + kLights) {
    return {&s.lighting.light[cap - GL_LIGHT0].enabled, kDirtyVertex};
  }
  if (cap >= GL_CLIP_PLANE0 && cap < GL_CLIP_PLANE0 + kClipPlanes) {
    return {&s.transform.clip_plane_enabled[cap - GL_CLIP_PLANE0], kDirtyVertex};
  }
  switch (cap) {
    case GL_NORMALIZE:
      return {&s.transform.normalize, kDirtyVertex};
    case GL_RESCALE_NORMAL:
      return {&s.transform.rescale_normal, kDirtyVertex};
    case GL_MATRIX_PALETTE_OES:
      return {&s.transform.matrix_palette, kDirtyMatrix | kDirtyVertex | kDirtyArrays};
    case GL_FOG:
      return {&s.fog.enabled, kDirtyVertex | kDirtyFragment};
    case GL_LIGHTING:
      return {&s.lighting.enabled, kDirtyVertex};
    case GL_COLOR_MATERIAL:
      return {&s.lighting.colour_material, kDirtyVertex};
    case GL_POINT_SMOOTH:
      return {&s.raster.point_smooth, kDirtyRaster};
    case GL_POINT_SPRITE_OES:
      return {&s.raster.point_sprite, kDirtyRaster};
    case GL_LINE_SMOOTH:
      return {&s.raster.line_smooth, kDirtyRaster};
    case GL_CULL_FACE:
      return {&s.raster.cull_face, kDirtyRaster};
    case GL_POLYGON_OFFSET_FILL:
      return {&s.raster.offset_fill, kDirtyRaster};
    case GL_MULTISAMPLE:
      return {&s.multisample.enabled, kDirtyRaster};
    case GL_SAMPLE_ALPHA_TO_COVERAGE:
      return {&s.multisample.alpha_to_coverage, kDirtyFragment};
    case GL_SAMPLE_ALPHA_TO_ONE:
      return {&s.multisample.alpha_to_one, kDirtyFragment};
    case GL_SAMPLE_COVERAGE:
      return {&s.multisample.coverage, kDirtyFragment};
    case GL_TEXTURE_2D:
      return {&c.active_unit().enabled, kDirtyTexture};
    case GL_TEXTURE_EXTERNAL_OES:
      return {&c.active_unit().external_enabled, kDirtyTexture};
    case GL_TEXTURE_CUBE_MAP_OES:
      return {&c.active_unit().cube_enabled, kDirtyTexture};
    case GL_TEXTURE_GEN_STR_OES:
      return {&c.active_unit().gen_str, kDirtyTexCoord};
    case GL_SCISSOR_TEST:
      return {&s.pixel.scissor_test, kDirtyRaster};
    case GL_ALPHA_TEST:
      return {&s.pixel.alpha_test, kDirtyFragment};
    case GL_STENCIL_TEST:
      return {&s.pixel.stencil_test, kDirtyFragment};
    case GL_DEPTH_TEST:
      return {&s.pixel.depth_test, kDirtyFragment};
    case GL_BLEND:
      return {&s.pixel.blend, kDirtyFragment};
    case GL_DITHER:
      return {&s.pixel.dither, kDirtyFragment};
    case GL_DEBUG_OUTPUT_KHR:
      return {&c.debug.output, 0};
    case GL_DEBUG_OUTPUT_SYNCHRONOUS_KHR:
      return {&c.debug.synchronous, 0};
    case GL_COLOR_LOGIC_OP:
      return {&s.pixel.logic_op_enabled, kDirtyFragment};
    default:
      return {};
  }
}

}  // namespace clearpipe::api

namespace clearpipe::api::exec {

namespace {

// While COLOR_MATERIAL is enabled the current colour is written to the material, and stays there
// (2.12.3). Draws need not know: they take the colours of their vertices.
void track_colour(Context& c) {
  LightingState& l = c.state.lighting;
  if (l.colour_material) l.ambient = l.diffuse = c.state.current.colour;
}

}  // namespace

GLenum get_error(Context& c) {
  const GLenum error = c.error;
  c.error = GL_NO_ERROR;
  return error;
}

// Both execute everything: nothing is drawn while the application goes on.
void finish_all(Context& c) {
  c.finish_frame();
  c.tell_owner();
}
void flush_all(Context& c) {
  c.finish_frame(Slow::kWaits);
  c.tell_owner();
}

void hint(Context& c, GLenum target, GLenum mode) {
  MiscState& m = c.state.misc;
  switch (target) {
    case GL_PERSPECTIVE_CORRECTION_HINT:
      m.perspective_hint = mode;
      break;
    case GL_POINT_SMOOTH_HINT:
      m.point_hint = mode;
      break;
    case GL_LINE_SMOOTH_HINT:
      m.line_hint = mode;
      break;
    case GL_FOG_HINT:
      m.fog_hint = mode;
      break;
    default:
      m.mipmap_hint = mode;
      break;
  }
}

void enable(Context& c, GLenum cap, bool value) {
  const Capability found = capability(c, cap);
  if (*found.value == value) return;
  *found.value = value;
  if (cap == GL_COLOR_MATERIAL) track_colour(c);
  c.dirty |= found.dirty;
}

void color(Context& c, float r, float g, float b, float a) {
  c.state.current.colour = {r, g, b, a};
  track_colour(c);
}

void normal(Context& c, float x, float y, float z) { c.state.current.normal = {x, y, z, 0}; }

void multi_tex_coord(Context& c, GLenum target, float s, float t, float r, float q) {
  c.state.current.tex_coord[target - GL_TEXTURE0] = {s, t, r, q};
}

void point_size(Context& c, float size) {
  c.state.raster.point_size = size;
  c.dirty |= kDirtyVertex;
}

void point_parameter(Context& c, GLenum pname, const Params& p) {
  RasterizationState& r = c.state.raster;
  switch (pname) {
    case GL_POINT_SIZE_MIN:
      r.point_size_min = p.number();
      break;
    case GL_POINT_SIZE_MAX:
      r.point_size_max = p.number();
      break;
    case GL_POINT_FADE_THRESHOLD_SIZE:
      r.point_fade_threshold = p.number();
      break;
    default:
      for (int i = 0; i < 3; ++i) r.point_attenuation[i] = p.number(i);
  }
  c.dirty |= kDirtyVertex;
}

void line_width(Context& c, float width) {
  c.state.raster.line_width = width;
  c.dirty |= kDirtyRaster;
}

void cull_face(Context& c, GLenum mode) {
  c.state.raster.cull_mode = mode;
  c.dirty |= kDirtyRaster;
}

void front_face(Context& c, GLenum mode) {
  c.state.raster.front_face = mode;
  c.dirty |= kDirtyRaster;
}

void polygon_offset(Context& c, float factor, float units) {
  polygon_offset_clamp(c, factor, units, 0);
}

void polygon_offset_clamp(Context& c, float factor, float units, float clamp) {
  c.state.raster.offset_factor = factor;
  c.state.raster.offset_units = units;
  c.state.raster.offset_clamp = clamp;
  c.dirty |= kDirtyRaster;
}

void sample_coverage(Context& c, float value, GLboolean invert) {
  c.state.multisample.coverage_value = clamp01(value);
  c.state.multisample.coverage_invert = invert != 0;
  c.dirty |= kDirtyFragment;
}

void pixel_store(Context& c, GLenum pname, GLint param) {
  (pname == GL_PACK_ALIGNMENT ? c.state.misc.pack_alignment : c.state.misc.unpack_alignment) =
      param;
}

void fog(Context& c, GLenum pname, const Params& p) {
  FogState& f = c.state.fog;
  switch (pname) {
    case GL_FOG_MODE:
      f.mode = p.enumerant();
      break;
    case GL_FOG_DENSITY:
      f.density = p.number();
      break;
    case GL_FOG_START:
      f.start = p.number();
      break;
    case GL_FOG_END:
      f.end = p.number();
      break;
    default:
      f.colour = {clamp01(p.number(0)), clamp01(p.number(1)), clamp01(p.number(2)),
                  clamp01(p.number(3))};
  }
  c.dirty |= kDirtyFragment;
}

void scissor(Context& c, GLint x, GLint y, GLsizei width, GLsizei height) {
  GLint* box = c.state.pixel.scissor;
  box[0] = x;
  box[1] = y;
  box[2] = width;
  box[3] = height;
  c.dirty |= kDirtyRaster;
}

void alpha_func(Context& c, GLenum func, float reference) {
  set_state(c, c.state.pixel.alpha_func, func, kDirtyFragment);
  set_state(c, c.state.pixel.alpha_reference, clamp01(reference), kDirtyFragment);
}

void stencil_func(Context& c, GLenum func, GLint reference, GLuint mask) {
  set_state(c, c.state.pixel.stencil_func, func, kDirtyFragment);
  set_state(c, c.state.pixel.stencil_reference, reference, kDirtyFragment);
  set_state(c, c.state.pixel.stencil_value_mask, mask, kDirtyFragment);
}

void stencil_op(Context& c, GLenum fail, GLenum depth_fail, GLenum pass) {
  set_state(c, c.state.pixel.stencil_fail, fail, kDirtyFragment);
  set_state(c, c.state.pixel.stencil_depth_fail, depth_fail, kDirtyFragment);
  set_state(c, c.state.pixel.stencil_pass, pass, kDirtyFragment);
}

void depth_func(Context& c, GLenum func) {
  set_state(c, c.state.pixel.depth_func, func, kDirtyFragment);
}

void blend_func(Context& c, GLenum src, GLenum dst) { blend_func_separate(c, src, dst, src, dst); }

void blend_func_separate(Context& c, GLenum src_rgb, GLenum dst_rgb, GLenum src_a, GLenum dst_a) {
  PixelState& p = c.state.pixel;
  set_state(c, p.src_rgb, src_rgb, kDirtyFragment);
  set_state(c, p.dst_rgb, dst_rgb, kDirtyFragment);
  set_state(c, p.src_alpha, src_a, kDirtyFragment);
  set_state(c, p.dst_alpha, dst_a, kDirtyFragment);
}

void blend_equation(Context& c, GLenum rgb, GLenum alpha) {
  set_state(c, c.state.pixel.equation_rgb, rgb, kDirtyFragment);
  set_state(c, c.state.pixel.equation_alpha, alpha, kDirtyFragment);
}

void logic_op(Context& c, GLenum opcode) {
  set_state(c, c.state.pixel.logic_op, opcode, kDirtyFragment);
}

void color_mask(Context& c, GLboolean r, GLboolean g, GLboolean b, GLboolean a) {
  const GLboolean values[4] = {r, g, b, a};
  for (int i = 0; i < 4; ++i) {
    set_state(c, c.state.framebuffer.colour_mask[i], values[i] != 0, kDirtyFragment);
  }
}

void depth_mask(Context& c, GLboolean flag) {
  set_state(c, c.state.framebuffer.depth_mask, flag != 0, kDirtyFragment);
}

void stencil_mask(Context& c, GLuint mask) {
  set_state(c, c.state.framebuffer.stencil_mask, mask, kDirtyFragment);
}

void clear_color(Context& c, float r, float g, float b, float a) {
  c.state.framebuffer.clear_colour = {clamp01(r), clamp01(g), clamp01(b), clamp01(a)};
}

void clear_depth(Context& c, float depth) { c.state.framebuffer.clear_depth = clamp01(depth); }

void clear_stencil(Context& c, GLint s) { c.state.framebuffer.clear_stencil = s; }

}  // namespace clearpipe::api::exec
