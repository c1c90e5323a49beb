// Setters of matrices, viewport, clip planes and lighting (2.10 to 2.12).
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "api/exec.h"
#include "api/matrix.h"

namespace clearpipe::api {

const MatrixStack& current_stack(const Context& c) {
  const TransformState& t = c.state.transform;
  switch (t.matrix_mode) {
    case GL_MODELVIEW:
      return t.modelview;
    case GL_PROJECTION:
      return t.projection;
    case GL_MATRIX_PALETTE_OES:
      return t.palette[t.current_palette_matrix];
    default:
      return t.texture[static_cast<size_t>(c.state.texture.active)];
  }
}

MatrixStack& current_stack(Context& c) {
  return const_cast<MatrixStack&>(current_stack(static_cast<const Context&>(c)));
}

}  // namespace clearpipe::api

namespace clearpipe::api::exec {

namespace {

Mat4 read_matrix(const Params& p) {
  Mat4 m;
  for (int i = 0; i < 16; ++i) m.m[static_cast<size_t>(i)] = p.number(i);
  return m;
}

Vec4 read_vec4(const Params& p) { return {p.number(0), p.number(1), p.number(2), p.number(3)}; }

Mat4& changed_top(Context& c) {
  c.dirty |= c.state.transform.matrix_mode == GL_TEXTURE ? kDirtyTexCoord : kDirtyMatrix;
  return current_stack(c).top();
}

}  // namespace

void matrix_mode(Context& c, GLenum mode) { c.state.transform.matrix_mode = mode; }

void current_palette_matrix(Context& c, GLuint index) {
  c.state.transform.current_palette_matrix = index;
}

void load_palette_from_model_view_matrix(Context& c) {
  TransformState& t = c.state.transform;
  t.palette[t.current_palette_matrix].top() = t.modelview.top();
  c.dirty |= kDirtyMatrix;
}

void load_identity(Context& c) { changed_top(c) = {}; }

void load_matrix(Context& c, const Params& p) { changed_top(c) = read_matrix(p); }

void mult_matrix(Context& c, const Params& p) {
  Mat4& top = changed_top(c);
  top = multiply(top, read_matrix(p));
}

void push_matrix(Context& c) {
  MatrixStack& stack = current_stack(c);
  stack.stack.push_back(Mat4(stack.top()));
}

void pop_matrix(Context& c) {
  changed_top(c);
  current_stack(c).stack.pop_back();
}

void rotate_matrix(Context& c, float angle, float x, float y, float z) {
  rotate(changed_top(c), angle, x, y, z);
}

void scale_matrix(Context& c, float x, float y, float z) { scale(changed_top(c), x, y, z); }

void translate_matrix(Context& c, float x, float y, float z) { translate(changed_top(c), x, y, z); }

void frustum_matrix(Context& c, float l, float r, float b, float t, float n, float f) {
  Mat4& top = changed_top(c);
  top = multiply(top, frustum(l, r, b, t, n, f));
}

void ortho_matrix(Context& c, float l, float r, float b, float t, float n, float f) {
  Mat4& top = changed_top(c);
  top = multiply(top, ortho(l, r, b, t, n, f));
}

void depth_range(Context& c, float n, float f) {
  c.state.transform.depth_range[0] = clamp01(n);
  c.state.transform.depth_range[1] = clamp01(f);
  c.dirty |= kDirtyRaster;
}

void viewport(Context& c, GLint x, GLint y, GLsizei width, GLsizei height) {
  GLint* v = c.state.transform.viewport;
  v[0] = std::clamp(x, -kMaxViewport * 2, kMaxViewport * 2);
  v[1] = std::clamp(y, -kMaxViewport * 2, kMaxViewport * 2);
  v[2] = std::min(width, kMaxViewport);
  v[3] = std::min(height, kMaxViewport);
  c.dirty |= kDirtyRaster;
}

void clip_plane(Context& c, GLenum plane, const Params& p) {
  TransformState& t = c.state.transform;
  t.clip_plane[plane - GL_CLIP_PLANE0] = transform_plane(read_vec4(p), invert(t.modelview.top()));
  c.dirty |= kDirtyVertex;
}

void shade_model(Context& c, GLenum mode) {
  c.state.lighting.shade_model = mode;
  c.dirty |= kDirtyRaster;
}

void light_model(Context& c, GLenum pname, const Params& p) {
  if (pname == GL_LIGHT_MODEL_TWO_SIDE) {
    c.state.lighting.two_sided = p.boolean();
  } else {
    c.state.lighting.model_ambient = read_vec4(p);
  }
  c.dirty |= kDirtyVertex;
}

void light(Context& c, GLenum name, GLenum pname, const Params& p) {
  LightState& l = c.state.lighting.light[name - GL_LIGHT0];
  const Mat4& modelview = c.state.transform.modelview.top();
  switch (pname) {
    case GL_AMBIENT:
      l.ambient = read_vec4(p);
      break;
    case GL_DIFFUSE:
      l.diffuse = read_vec4(p);
      break;
    case GL_SPECULAR:
      l.specular = read_vec4(p);
      break;
    case GL_POSITION:
      l.position = transform(modelview, read_vec4(p));
      break;
    case GL_SPOT_DIRECTION: {
      const Vec4 v = transform(modelview, {p.number(0), p.number(1), p.number(2), 0});
      l.spot_direction = {v.x, v.y, v.z, 0};
      break;
    }
    case GL_SPOT_EXPONENT:
      l.spot_exponent = p.number();
      break;
    case GL_SPOT_CUTOFF:
      l.spot_cutoff = p.number();
      break;
    case GL_CONSTANT_ATTENUATION:
      l.attenuation[0] = p.number();
      break;
    case GL_LINEAR_ATTENUATION:
      l.attenuation[1] = p.number();
      break;
    default:
      l.attenuation[2] = p.number();
      break;
  }
  c.dirty |= kDirtyVertex;
}

void material(Context& c, GLenum, GLenum pname, const Params& p) {
  LightingState& l = c.state.lighting;
  switch (pname) {
    // While COLOR_MATERIAL is enabled these two follow the current colour alone (2.12.3).
    case GL_AMBIENT:
      if (!l.colour_material) l.ambient = read_vec4(p);
      break;
    case GL_DIFFUSE:
      if (!l.colour_material) l.diffuse = read_vec4(p);
      break;
    case GL_AMBIENT_AND_DIFFUSE:
      if (!l.colour_material) l.ambient = l.diffuse = read_vec4(p);
      break;
    case GL_SPECULAR:
      l.specular = read_vec4(p);
      break;
    case GL_EMISSION:
      l.emission = read_vec4(p);
      break;
    default:
      l.shininess = p.number();
      break;
  }
  c.dirty |= kDirtyVertex;
}

}  // namespace clearpipe::api::exec
