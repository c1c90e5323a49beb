// Validators of fog and the per-fragment operations (3.8, 4.1).
// SPDX-License-Identifier: MIT
#include "api/validate.h"

namespace clearpipe::api::validate {

namespace {

Invalid stencil_operation(GLenum op) {
  return enum_unless(op == GL_KEEP || op == GL_ZERO || op == GL_REPLACE || op == GL_INCR ||
                         op == GL_DECR || op == GL_INVERT || op == GL_INCR_WRAP_OES ||
                         op == GL_DECR_WRAP_OES,
                     "{0} is no stencil operation (4.1.5)");
}

// Table 4.1: a source never uses its own colour, a destination never its own.
bool is_common_factor(GLenum factor) {
  return factor == GL_ZERO || factor == GL_ONE || factor == GL_SRC_ALPHA ||
         factor == GL_ONE_MINUS_SRC_ALPHA || factor == GL_DST_ALPHA ||
         factor == GL_ONE_MINUS_DST_ALPHA;
}
Invalid source_factor(GLenum factor) {
  return enum_unless(is_common_factor(factor) || factor == GL_DST_COLOR ||
                         factor == GL_ONE_MINUS_DST_COLOR || factor == GL_SRC_ALPHA_SATURATE,
                     "{0} is no factor of the source (4.1.7, table 4.1)");
}
Invalid destination_factor(GLenum factor) {
  return enum_unless(
      is_common_factor(factor) || factor == GL_SRC_COLOR || factor == GL_ONE_MINUS_SRC_COLOR,
      "{0} is no factor of the destination (4.1.7, table 4.1)");
}
Invalid equation(GLenum mode) {
  return enum_unless(mode == GL_FUNC_ADD_OES || mode == GL_FUNC_SUBTRACT_OES ||
                         mode == GL_FUNC_REVERSE_SUBTRACT_OES || mode == GL_MIN_EXT ||
                         mode == GL_MAX_EXT,
                     "{0} is no blend equation (OES_blend_subtract, EXT_blend_minmax)");
}

}  // namespace

Invalid fog(const Context&, GLenum pname, const Params& p) {
  switch (pname) {
    case GL_FOG_MODE:
      return enum_unless(
          p.enumerant() == GL_LINEAR || p.enumerant() == GL_EXP || p.enumerant() == GL_EXP2,
          "{1} is none of LINEAR, EXP and EXP2 (3.8)");
    case GL_FOG_DENSITY:
      return value_unless(p.number() >= 0, "{1} is negative (3.8)");
    case GL_FOG_START:
    case GL_FOG_END:
      return {};
    case GL_FOG_COLOR:
      return vector_only(p, 0);
    default:
      return {GL_INVALID_ENUM, "{0} is no parameter of fog (3.8)"};
  }
}

Invalid compare_func(const Context&, GLenum func) {
  return enum_unless(func >= GL_NEVER && func <= GL_ALWAYS,
                     "{0} is no comparison, NEVER to ALWAYS (4.1.4 to 4.1.6)");
}

Invalid alpha_func(const Context& c, GLenum func, float) { return compare_func(c, func); }

Invalid stencil_func(const Context& c, GLenum func, GLint, GLuint) { return compare_func(c, func); }

Invalid stencil_op(const Context&, GLenum fail, GLenum zfail, GLenum zpass) {
  if (const Invalid wrong = stencil_operation(fail)) return wrong;
  if (const Invalid wrong = stencil_operation(zfail)) return wrong.from(1);
  return stencil_operation(zpass).from(2);
}

Invalid blend_func(const Context&, GLenum src, GLenum dst) {
  const Invalid wrong = source_factor(src);
  return wrong ? wrong : destination_factor(dst).from(1);
}

Invalid blend_func_separate(const Context& c, GLenum src_rgb, GLenum dst_rgb, GLenum src_a,
                            GLenum dst_a) {
  const Invalid wrong = blend_func(c, src_rgb, dst_rgb);
  return wrong ? wrong : blend_func(c, src_a, dst_a).from(2);
}

Invalid blend_equation(const Context&, GLenum rgb, GLenum alpha) {
  const Invalid wrong = equation(rgb);
  return wrong ? wrong : equation(alpha).from(1);
}

Invalid logic_op(const Context&, GLenum opcode) {
  return enum_unless(opcode >= GL_CLEAR && opcode <= GL_SET,
                     "{0} is no logical operation (4.1.9, table 4.2)");
}

}  // namespace clearpipe::api::validate
