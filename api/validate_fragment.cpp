// Validators of fog and the per-fragment operations (3.8, 4.1).
// SPDX-License-Identifier: MIT
#include "api/validate.h"

namespace clearpipe::api::validate {

namespace {

GLenum enum_if(bool good) { return good ? GL_NO_ERROR : GL_INVALID_ENUM; }

bool is_stencil_op(GLenum op) {
  return op == GL_KEEP || op == GL_ZERO || op == GL_REPLACE || op == GL_INCR || op == GL_DECR ||
         op == GL_INVERT || op == GL_INCR_WRAP_OES || op == GL_DECR_WRAP_OES;
}

// Table 4.1: a source never uses its own colour, a destination never its own.
bool is_common_factor(GLenum factor) {
  return factor == GL_ZERO || factor == GL_ONE || factor == GL_SRC_ALPHA ||
         factor == GL_ONE_MINUS_SRC_ALPHA || factor == GL_DST_ALPHA ||
         factor == GL_ONE_MINUS_DST_ALPHA;
}
bool is_source_factor(GLenum factor) {
  return is_common_factor(factor) || factor == GL_DST_COLOR || factor == GL_ONE_MINUS_DST_COLOR ||
         factor == GL_SRC_ALPHA_SATURATE;
}
bool is_destination_factor(GLenum factor) {
  return is_common_factor(factor) || factor == GL_SRC_COLOR || factor == GL_ONE_MINUS_SRC_COLOR;
}
bool is_equation(GLenum mode) {
  return mode == GL_FUNC_ADD_OES || mode == GL_FUNC_SUBTRACT_OES ||
         mode == GL_FUNC_REVERSE_SUBTRACT_OES || mode == GL_MIN_EXT || mode == GL_MAX_EXT;
}

}  // namespace

GLenum fog(const Context&, GLenum pname, const Params& p) {
  switch (pname) {
    case GL_FOG_MODE:
      return enum_if(p.enumerant() == GL_LINEAR || p.enumerant() == GL_EXP ||
                     p.enumerant() == GL_EXP2);
    case GL_FOG_DENSITY:
      return p.number() >= 0 ? GL_NO_ERROR : GL_INVALID_VALUE;
    case GL_FOG_START:
    case GL_FOG_END:
      return GL_NO_ERROR;
    case GL_FOG_COLOR:
      return enum_if(!p.scalar());
    default:
      return GL_INVALID_ENUM;
  }
}

GLenum compare_func(const Context&, GLenum func) {
  return enum_if(func >= GL_NEVER && func <= GL_ALWAYS);
}

GLenum alpha_func(const Context& c, GLenum func, float) { return compare_func(c, func); }

GLenum stencil_func(const Context& c, GLenum func, GLint, GLuint) { return compare_func(c, func); }

GLenum stencil_op(const Context&, GLenum fail, GLenum zfail, GLenum zpass) {
  return enum_if(is_stencil_op(fail) && is_stencil_op(zfail) && is_stencil_op(zpass));
}

GLenum blend_func(const Context&, GLenum src, GLenum dst) {
  return enum_if(is_source_factor(src) && is_destination_factor(dst));
}

GLenum blend_func_separate(const Context&, GLenum src_rgb, GLenum dst_rgb, GLenum src_a,
                           GLenum dst_a) {
  return enum_if(is_source_factor(src_rgb) && is_destination_factor(dst_rgb) &&
                 is_source_factor(src_a) && is_destination_factor(dst_a));
}

GLenum blend_equation(const Context&, GLenum rgb, GLenum alpha) {
  return enum_if(is_equation(rgb) && is_equation(alpha));
}

GLenum logic_op(const Context&, GLenum opcode) {
  return enum_if(opcode >= GL_CLEAR && opcode <= GL_SET);
}

}  // namespace clearpipe::api::validate
