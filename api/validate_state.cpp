// Validators of transformation, lighting and rasterization state.
// SPDX-License-Identifier: MIT
#include "api/validate.h"

namespace clearpipe::api::validate {

namespace {
Invalid plane_name(GLenum plane) {
  return enum_unless(plane >= GL_CLIP_PLANE0 && plane < GL_CLIP_PLANE0 + kClipPlanes,
                     "{0} is none of CLIP_PLANE0 to CLIP_PLANE7 (2.11)");
}
}  // namespace

Invalid hint(const Context&, GLenum target, GLenum mode) {
  const bool known = target == GL_PERSPECTIVE_CORRECTION_HINT || target == GL_POINT_SMOOTH_HINT ||
                     target == GL_LINE_SMOOTH_HINT || target == GL_FOG_HINT ||
                     target == GL_GENERATE_MIPMAP_HINT;
  if (!known) return {GL_INVALID_ENUM, "{0} is no hint (5.2)"};
  return enum_unless(mode == GL_FASTEST || mode == GL_NICEST || mode == GL_DONT_CARE,
                     "{1} is none of FASTEST, NICEST and DONT_CARE (5.2)");
}

Invalid enable(const Context& c, GLenum cap, bool) {
  return enum_unless(capability(const_cast<Context&>(c), cap).value != nullptr,
                     "{0} is nothing that is enabled with Enable (6.2)");
}

Invalid is_enabled(const Context& c, GLenum cap) {
  return enum_unless(find_array(c.state.arrays, cap) || !enable(c, cap, false),
                     "{0} is nothing that is enabled or disabled (6.1.1)");
}

Invalid texture_unit(const Context&, GLenum texture) {
  return enum_unless(texture >= GL_TEXTURE0 && texture < GL_TEXTURE0 + kTextureUnits,
                     "{0} is none of the texture units TEXTURE0 to TEXTURE7 (2.7)");
}

Invalid multi_tex_coord(const Context& c, GLenum target, float, float, float, float) {
  return texture_unit(c, target);
}

Invalid matrix_mode(const Context&, GLenum mode) {
  return enum_unless(
      mode == GL_MODELVIEW || mode == GL_PROJECTION || mode == GL_TEXTURE ||
          mode == GL_MATRIX_PALETTE_OES,
      "{0} is none of MODELVIEW, PROJECTION, TEXTURE and MATRIX_PALETTE_OES (2.10.2)");
}

Invalid current_palette_matrix(const Context&, GLuint index) {
  return value_unless(index < GLuint{kPaletteMatrices},
                      "{0} is not less than MAX_PALETTE_MATRICES_OES (OES_matrix_palette, 2.10)");
}

Invalid push_matrix(const Context& c) {
  const MatrixStack& stack = current_stack(c);
  if (stack.stack.size() < static_cast<size_t>(stack.limit)) return {};
  return {GL_STACK_OVERFLOW, "the stack of MATRIX_MODE is full (2.10.2)"};
}

Invalid pop_matrix(const Context& c) {
  if (current_stack(c).stack.size() > 1) return {};
  return {GL_STACK_UNDERFLOW, "the stack of MATRIX_MODE has one entry only (2.10.2)"};
}

Invalid frustum_planes(const Context& c, float l, float r, float b, float t, float n, float f) {
  if (!(n > 0)) return {GL_INVALID_VALUE, "{4} is not positive (2.10.2)"};
  if (!(f > 0)) return {GL_INVALID_VALUE, "{5} is not positive (2.10.2)"};
  return ortho_planes(c, l, r, b, t, n, f);
}

Invalid ortho_planes(const Context&, float l, float r, float b, float t, float n, float f) {
  if (l == r) return {GL_INVALID_VALUE, "{0} and {1} are equal (2.10.2)"};
  if (b == t) return {GL_INVALID_VALUE, "{2} and {3} are equal (2.10.2)"};
  return value_unless(n != f, "{4} and {5} are equal (2.10.2)");
}

Invalid rectangle(const Context&, GLint, GLint, GLsizei width, GLsizei height) {
  if (width < 0) return {GL_INVALID_VALUE, "{2} is negative (2.10.1, 4.1.2)"};
  return value_unless(height >= 0, "{3} is negative (2.10.1, 4.1.2)");
}

Invalid clip_plane(const Context&, GLenum plane, const Params&) { return plane_name(plane); }
Invalid clip_plane(const Context&, GLenum plane, const Out&) { return plane_name(plane); }

Invalid shade_model(const Context&, GLenum mode) {
  return enum_unless(mode == GL_FLAT || mode == GL_SMOOTH,
                     "{0} is neither SMOOTH nor FLAT (2.12.6)");
}

Invalid light_model(const Context&, GLenum pname, const Params& p) {
  if (pname == GL_LIGHT_MODEL_AMBIENT) return vector_only(p, 0);
  return enum_unless(pname == GL_LIGHT_MODEL_TWO_SIDE,
                     "{0} is no parameter of the light model (2.12.2, table 2.9)");
}

Invalid light(const Context&, GLenum light, GLenum pname, const Params& p) {
  if (light < GL_LIGHT0 || light >= GL_LIGHT0 + kLights) {
    return {GL_INVALID_ENUM, "{0} is none of LIGHT0 to LIGHT7 (2.12.2)"};
  }
  switch (pname) {
    case GL_AMBIENT:
    case GL_DIFFUSE:
    case GL_SPECULAR:
    case GL_POSITION:
    case GL_SPOT_DIRECTION:
      return vector_only(p, 1);
    case GL_SPOT_EXPONENT:
      return value_unless(p.number() >= 0 && p.number() <= 128,
                          "{2} is not in [0, 128] (2.12.1, table 2.8)");
    case GL_SPOT_CUTOFF:
      return value_unless((p.number() >= 0 && p.number() <= 90) || p.number() == 180,
                          "{2} is neither in [0, 90] nor 180 (2.12.1, table 2.8)");
    case GL_CONSTANT_ATTENUATION:
    case GL_LINEAR_ATTENUATION:
    case GL_QUADRATIC_ATTENUATION:
      return value_unless(p.number() >= 0, "{2} is negative (2.12.1, table 2.8)");
    default:
      return {GL_INVALID_ENUM, "{1} is no parameter of a light (2.12.2, table 2.9)"};
  }
}

Invalid material(const Context&, GLenum face, GLenum pname, const Params& p) {
  if (face != GL_FRONT_AND_BACK) {
    return {GL_INVALID_ENUM, "{0} is not FRONT_AND_BACK (2.12.2)"};
  }
  switch (pname) {
    case GL_AMBIENT:
    case GL_DIFFUSE:
    case GL_AMBIENT_AND_DIFFUSE:
    case GL_SPECULAR:
    case GL_EMISSION:
      return vector_only(p, 1);
    case GL_SHININESS:
      return value_unless(p.number() >= 0 && p.number() <= 128,
                          "{2} is not in [0, 128] (2.12.1, table 2.8)");
    default:
      return {GL_INVALID_ENUM, "{1} is no parameter of a material (2.12.2, table 2.9)"};
  }
}

Invalid positive(const Context&, float value) {
  return value_unless(value > 0, "{0} is not positive (3.3, 3.4)");
}

Invalid point_parameter(const Context&, GLenum pname, const Params& p) {
  switch (pname) {
    case GL_POINT_SIZE_MIN:
    case GL_POINT_SIZE_MAX:
    case GL_POINT_FADE_THRESHOLD_SIZE:
      return value_unless(p.number() >= 0, "{1} is negative (3.3)");
    case GL_POINT_DISTANCE_ATTENUATION:
      return vector_only(p, 0);
    default:
      return {GL_INVALID_ENUM, "{0} is no parameter of points (3.3)"};
  }
}

Invalid cull_face(const Context&, GLenum mode) {
  return enum_unless(mode == GL_FRONT || mode == GL_BACK || mode == GL_FRONT_AND_BACK,
                     "{0} is none of FRONT, BACK and FRONT_AND_BACK (3.5.1)");
}

Invalid front_face(const Context&, GLenum mode) {
  return enum_unless(mode == GL_CW || mode == GL_CCW, "{0} is neither CW nor CCW (3.5.1)");
}

}  // namespace clearpipe::api::validate
