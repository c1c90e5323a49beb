// Validators of transformation, lighting and rasterization state.
// SPDX-License-Identifier: MIT
#include "api/validate.h"

namespace clearpipe::api::validate {

namespace {
GLenum enum_if(bool good) { return good ? GL_NO_ERROR : GL_INVALID_ENUM; }
GLenum value_if(bool good) { return good ? GL_NO_ERROR : GL_INVALID_VALUE; }
bool is_plane(GLenum plane) {
  return plane >= GL_CLIP_PLANE0 && plane < GL_CLIP_PLANE0 + kClipPlanes;
}
}  // namespace

GLenum hint(const Context&, GLenum target, GLenum mode) {
  const bool known = target == GL_PERSPECTIVE_CORRECTION_HINT || target == GL_POINT_SMOOTH_HINT ||
                     target == GL_LINE_SMOOTH_HINT || target == GL_FOG_HINT ||
                     target == GL_GENERATE_MIPMAP_HINT;
  return enum_if(known && (mode == GL_FASTEST || mode == GL_NICEST || mode == GL_DONT_CARE));
}

GLenum enable(const Context& c, GLenum cap, bool) {
  return enum_if(capability(const_cast<Context&>(c), cap).value != nullptr);
}

GLenum is_enabled(const Context& c, GLenum cap) {
  const bool array = cap == GL_VERTEX_ARRAY || cap == GL_NORMAL_ARRAY || cap == GL_COLOR_ARRAY ||
                     cap == GL_TEXTURE_COORD_ARRAY || cap == GL_POINT_SIZE_ARRAY_OES;
  return array ? GL_NO_ERROR : enable(c, cap, false);
}

GLenum texture_unit(const Context&, GLenum texture) {
  return enum_if(texture >= GL_TEXTURE0 && texture < GL_TEXTURE0 + kTextureUnits);
}

GLenum multi_tex_coord(const Context& c, GLenum target, float, float, float, float) {
  return texture_unit(c, target);
}

GLenum matrix_mode(const Context&, GLenum mode) {
  return enum_if(mode == GL_MODELVIEW || mode == GL_PROJECTION || mode == GL_TEXTURE);
}

GLenum push_matrix(const Context& c) {
  const MatrixStack& stack = current_stack(c);
  return stack.stack.size() < static_cast<size_t>(stack.limit) ? GL_NO_ERROR : GL_STACK_OVERFLOW;
}

GLenum pop_matrix(const Context& c) {
  return current_stack(c).stack.size() > 1 ? GL_NO_ERROR : GL_STACK_UNDERFLOW;
}

GLenum frustum_planes(const Context&, float l, float r, float b, float t, float n, float f) {
  return value_if(n > 0 && f > 0 && l != r && b != t && n != f);
}

GLenum ortho_planes(const Context&, float l, float r, float b, float t, float n, float f) {
  return value_if(l != r && b != t && n != f);
}

GLenum rectangle(const Context&, GLint, GLint, GLsizei width, GLsizei height) {
  return value_if(width >= 0 && height >= 0);
}

GLenum clip_plane(const Context&, GLenum plane, const Params&) { return enum_if(is_plane(plane)); }
GLenum clip_plane(const Context&, GLenum plane, const Out&) { return enum_if(is_plane(plane)); }

GLenum shade_model(const Context&, GLenum mode) {
  return enum_if(mode == GL_FLAT || mode == GL_SMOOTH);
}

GLenum light_model(const Context&, GLenum pname, const Params& p) {
  return enum_if(pname == GL_LIGHT_MODEL_TWO_SIDE ||
                 (pname == GL_LIGHT_MODEL_AMBIENT && !p.scalar()));
}

GLenum light(const Context&, GLenum light, GLenum pname, const Params& p) {
  if (light < GL_LIGHT0 || light >= GL_LIGHT0 + kLights) return GL_INVALID_ENUM;
  switch (pname) {
    case GL_AMBIENT:
    case GL_DIFFUSE:
    case GL_SPECULAR:
    case GL_POSITION:
    case GL_SPOT_DIRECTION:
      return enum_if(!p.scalar());
    case GL_SPOT_EXPONENT:
      return value_if(p.number() >= 0 && p.number() <= 128);
    case GL_SPOT_CUTOFF:
      return value_if((p.number() >= 0 && p.number() <= 90) || p.number() == 180);
    case GL_CONSTANT_ATTENUATION:
    case GL_LINEAR_ATTENUATION:
    case GL_QUADRATIC_ATTENUATION:
      return value_if(p.number() >= 0);
    default:
      return GL_INVALID_ENUM;
  }
}

GLenum material(const Context&, GLenum face, GLenum pname, const Params& p) {
  if (face != GL_FRONT_AND_BACK) return GL_INVALID_ENUM;
  switch (pname) {
    case GL_AMBIENT:
    case GL_DIFFUSE:
    case GL_AMBIENT_AND_DIFFUSE:
    case GL_SPECULAR:
    case GL_EMISSION:
      return enum_if(!p.scalar());
    case GL_SHININESS:
      return value_if(p.number() >= 0 && p.number() <= 128);
    default:
      return GL_INVALID_ENUM;
  }
}

GLenum positive(const Context&, float value) { return value_if(value > 0); }

GLenum point_parameter(const Context&, GLenum pname, const Params& p) {
  switch (pname) {
    case GL_POINT_SIZE_MIN:
    case GL_POINT_SIZE_MAX:
    case GL_POINT_FADE_THRESHOLD_SIZE:
      return value_if(p.number() >= 0);
    case GL_POINT_DISTANCE_ATTENUATION:
      return enum_if(!p.scalar());
    default:
      return GL_INVALID_ENUM;
  }
}

GLenum cull_face(const Context&, GLenum mode) {
  return enum_if(mode == GL_FRONT || mode == GL_BACK || mode == GL_FRONT_AND_BACK);
}

GLenum front_face(const Context&, GLenum mode) { return enum_if(mode == GL_CW || mode == GL_CCW); }

}  // namespace clearpipe::api::validate
