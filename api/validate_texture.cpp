// Validators of texture objects, their parameters and environments (3.6.1, 3.7.5, 3.7.11, 3.7.12).
// SPDX-License-Identifier: MIT
#include "api/validate.h"

namespace clearpipe::api::validate {

namespace {

GLenum enum_if(bool good) { return good ? GL_NO_ERROR : GL_INVALID_ENUM; }

bool is_operand(GLenum operand, bool alpha_only) {
  return operand == GL_SRC_ALPHA || operand == GL_ONE_MINUS_SRC_ALPHA ||
         (!alpha_only && (operand == GL_SRC_COLOR || operand == GL_ONE_MINUS_SRC_COLOR));
}

}  // namespace

GLenum pixel_store(const Context&, GLenum pname, GLint param) {
  if (pname != GL_PACK_ALIGNMENT && pname != GL_UNPACK_ALIGNMENT) return GL_INVALID_ENUM;
  return param == 1 || param == 2 || param == 4 || param == 8 ? GL_NO_ERROR : GL_INVALID_VALUE;
}

GLenum texture_target(const Context&, GLenum target, GLuint) {
  return enum_if(target == GL_TEXTURE_2D);
}

GLenum names(const Context&, GLsizei n, const GLuint*) {
  return n >= 0 ? GL_NO_ERROR : GL_INVALID_VALUE;
}

GLenum tex_parameter(const Context&, GLenum target, GLenum pname, const Params& p) {
  if (target != GL_TEXTURE_2D) return GL_INVALID_ENUM;
  const GLenum value = p.enumerant();
  switch (pname) {
    case GL_TEXTURE_MIN_FILTER:
      return enum_if(value == GL_NEAREST || value == GL_LINEAR ||
                     (value >= GL_NEAREST_MIPMAP_NEAREST && value <= GL_LINEAR_MIPMAP_LINEAR));
    case GL_TEXTURE_MAG_FILTER:
      return enum_if(value == GL_NEAREST || value == GL_LINEAR);
    case GL_TEXTURE_WRAP_S:
    case GL_TEXTURE_WRAP_T:
      return enum_if(value == GL_REPEAT || value == GL_CLAMP_TO_EDGE ||
                     value == GL_MIRRORED_REPEAT_OES);
    case GL_GENERATE_MIPMAP:
      return GL_NO_ERROR;
    case GL_TEXTURE_MAX_LEVEL_APPLE:
      return p.integer() >= 0 ? GL_NO_ERROR : GL_INVALID_VALUE;
    case GL_TEXTURE_MAX_ANISOTROPY_EXT:
      return p.number() >= 1 ? GL_NO_ERROR : GL_INVALID_VALUE;
    default:
      return GL_INVALID_ENUM;
  }
}

GLenum tex_env(const Context&, GLenum target, GLenum pname, const Params& p) {
  if (target == GL_POINT_SPRITE_OES) return enum_if(pname == GL_COORD_REPLACE_OES);
  if (target == GL_TEXTURE_FILTER_CONTROL_EXT) return enum_if(pname == GL_TEXTURE_LOD_BIAS_EXT);
  if (target != GL_TEXTURE_ENV) return GL_INVALID_ENUM;
  const GLenum value = p.enumerant();
  switch (pname) {
    case GL_TEXTURE_ENV_MODE:
      return enum_if(value == GL_MODULATE || value == GL_REPLACE || value == GL_DECAL ||
                     value == GL_BLEND || value == GL_ADD || value == GL_COMBINE);
    case GL_TEXTURE_ENV_COLOR:
      return enum_if(!p.scalar());
    case GL_COMBINE_RGB:
      if (value == GL_DOT3_RGB || value == GL_DOT3_RGBA) return GL_NO_ERROR;
      [[fallthrough]];
    case GL_COMBINE_ALPHA:
      return enum_if(value == GL_REPLACE || value == GL_MODULATE || value == GL_ADD ||
                     value == GL_ADD_SIGNED || value == GL_INTERPOLATE || value == GL_SUBTRACT);
    case GL_SRC0_RGB:
    case GL_SRC1_RGB:
    case GL_SRC2_RGB:
    case GL_SRC0_ALPHA:
    case GL_SRC1_ALPHA:
    case GL_SRC2_ALPHA:
      return enum_if(value == GL_TEXTURE || value == GL_CONSTANT || value == GL_PRIMARY_COLOR ||
                     value == GL_PREVIOUS ||
                     (value >= GL_TEXTURE0 && value < GL_TEXTURE0 + kTextureUnits));
    case GL_OPERAND0_RGB:
    case GL_OPERAND1_RGB:
    case GL_OPERAND2_RGB:
      return enum_if(is_operand(value, false));
    case GL_OPERAND0_ALPHA:
    case GL_OPERAND1_ALPHA:
    case GL_OPERAND2_ALPHA:
      return enum_if(is_operand(value, true));
    case GL_RGB_SCALE:
    case GL_ALPHA_SCALE:
      return p.number() == 1 || p.number() == 2 || p.number() == 4 ? GL_NO_ERROR : GL_INVALID_VALUE;
    default:
      return GL_INVALID_ENUM;
  }
}

}  // namespace clearpipe::api::validate
