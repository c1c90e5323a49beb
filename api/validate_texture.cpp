// Validators of texture objects, their parameters and environments (3.6.1, 3.7.5, 3.7.11, 3.7.12).
// SPDX-License-Identifier: MIT
#include "api/texture_target.h"
#include "api/validate.h"

namespace clearpipe::api::validate {

namespace {

Invalid operand(GLenum value, bool alpha_only) {
  if (value == GL_SRC_ALPHA || value == GL_ONE_MINUS_SRC_ALPHA) return {};
  if (alpha_only) {
    return {GL_INVALID_ENUM,
            "{2} is neither SRC_ALPHA nor ONE_MINUS_SRC_ALPHA (3.7.12, table 3.19)"};
  }
  return enum_unless(value == GL_SRC_COLOR || value == GL_ONE_MINUS_SRC_COLOR,
                     "{2} is no operand of a combiner (3.7.12, table 3.18)");
}

Invalid combine_function(GLenum value) {
  return enum_unless(value == GL_REPLACE || value == GL_MODULATE || value == GL_ADD ||
                         value == GL_ADD_SIGNED || value == GL_INTERPOLATE || value == GL_SUBTRACT,
                     "{2} is no function of this combiner (3.7.12, table 3.17)");
}

// External textures have one level, and never repeat (OES_EGL_image_external, 3.7.14).
bool external_takes(GLenum pname, const Params& p) {
  switch (pname) {
    case GL_TEXTURE_MIN_FILTER:
      return p.enumerant() == GL_NEAREST || p.enumerant() == GL_LINEAR;
    case GL_TEXTURE_WRAP_S:
    case GL_TEXTURE_WRAP_T:
      return p.enumerant() == GL_CLAMP_TO_EDGE;
    case GL_GENERATE_MIPMAP:
      return !p.boolean();
    default:
      return true;
  }
}

}  // namespace

Invalid pixel_store(const Context&, GLenum pname, GLint param) {
  if (pname != GL_PACK_ALIGNMENT && pname != GL_UNPACK_ALIGNMENT) {
    return {GL_INVALID_ENUM,
            "{0} is neither PACK_ALIGNMENT nor UNPACK_ALIGNMENT (3.6.1, table 3.1)"};
  }
  return value_unless(param == 1 || param == 2 || param == 4 || param == 8,
                      "{1} is none of 1, 2, 4 and 8 (3.6.1, table 3.1)");
}

Invalid texture_target(GLenum target) {
  return enum_unless(is_texture_target(target), "{0} is no target of textures (3.7)");
}

Invalid specified_target(GLenum target) {
  return enum_unless(is_texture_target(target) && target != GL_TEXTURE_EXTERNAL_OES,
                     "{0} is no target of textures with images of their own (3.7)");
}

Invalid bind_texture(const Context& c, GLenum target, GLuint name) {
  if (const Invalid wrong = texture_target(target)) return wrong;
  const TexturePtr& texture = c.share->textures.find(name);
  return operation_unless(!texture || texture->target == target,
                          "{1} is a texture of another target (OES_texture_cube_map, 3.8.8)");
}

Invalid names(const Context&, GLsizei n, const GLuint*) {
  return value_unless(n >= 0, "{0} is negative (2.5)");
}

Invalid tex_parameter(const Context&, GLenum target, GLenum pname, const Params& p) {
  if (const Invalid wrong = texture_target(target)) return wrong;
  const GLenum value = p.enumerant();
  if (target == GL_TEXTURE_EXTERNAL_OES && !external_takes(pname, p)) {
    return {GL_INVALID_ENUM,
            "{2} is nothing that external textures take (OES_EGL_image_external, 3.7.14)"};
  }
  switch (pname) {
    case GL_TEXTURE_MIN_FILTER:
      return enum_unless(
          value == GL_NEAREST || value == GL_LINEAR ||
              (value >= GL_NEAREST_MIPMAP_NEAREST && value <= GL_LINEAR_MIPMAP_LINEAR),
          "{2} is no minification filter (3.7.5, table 3.13)");
    case GL_TEXTURE_MAG_FILTER:
      return enum_unless(value == GL_NEAREST || value == GL_LINEAR,
                         "{2} is neither NEAREST nor LINEAR (3.7.5, table 3.13)");
    case GL_TEXTURE_WRAP_S:
    case GL_TEXTURE_WRAP_T:
      return enum_unless(
          value == GL_REPEAT || value == GL_CLAMP_TO_EDGE || value == GL_MIRRORED_REPEAT_OES,
          "{2} is no wrap mode (3.7.5, table 3.13)");
    case GL_GENERATE_MIPMAP:
      return {};
    case GL_TEXTURE_CROP_RECT_OES:
      return vector_only(p, 1);
    case GL_TEXTURE_MAX_LEVEL_APPLE:
      return value_unless(p.integer() >= 0, "{2} is negative (APPLE_texture_max_level)");
    case GL_TEXTURE_MAX_ANISOTROPY_EXT:
      return value_unless(p.number() >= 1, "{2} is less than 1 (EXT_texture_filter_anisotropic)");
    default:
      return {GL_INVALID_ENUM, "{1} is no parameter of textures (3.7.5, table 3.13)"};
  }
}

Invalid tex_env(const Context&, GLenum target, GLenum pname, const Params& p) {
  if (target == GL_POINT_SPRITE_OES) {
    return enum_unless(pname == GL_COORD_REPLACE_OES, "{1} is not COORD_REPLACE_OES (3.3)");
  }
  if (target == GL_TEXTURE_FILTER_CONTROL_EXT) {
    return enum_unless(pname == GL_TEXTURE_LOD_BIAS_EXT,
                       "{1} is not TEXTURE_LOD_BIAS_EXT (EXT_texture_lod_bias)");
  }
  if (target != GL_TEXTURE_ENV) {
    return {GL_INVALID_ENUM, "{0} is no target of texture environments (3.7.12)"};
  }
  const GLenum value = p.enumerant();
  switch (pname) {
    case GL_TEXTURE_ENV_MODE:
      return enum_unless(value == GL_MODULATE || value == GL_REPLACE || value == GL_DECAL ||
                             value == GL_BLEND || value == GL_ADD || value == GL_COMBINE ||
                             (value >= GL_MODULATE_COLOR_IMG && value <= GL_ADD_BLEND_IMG) ||
                             value == GL_DOT3_RGBA_IMG,
                         "{2} is no texture function (3.7.12)");
    case GL_TEXTURE_ENV_COLOR:
      return vector_only(p, 1);
    case GL_COMBINE_RGB:
      if (value == GL_DOT3_RGB || value == GL_DOT3_RGBA) return {};
      return combine_function(value);
    case GL_COMBINE_ALPHA:
      return combine_function(value);
    case GL_SRC0_RGB:
    case GL_SRC1_RGB:
    case GL_SRC2_RGB:
    case GL_SRC0_ALPHA:
    case GL_SRC1_ALPHA:
    case GL_SRC2_ALPHA:
      return enum_unless(value == GL_TEXTURE || value == GL_CONSTANT || value == GL_PRIMARY_COLOR ||
                             value == GL_PREVIOUS ||
                             (value >= GL_TEXTURE0 && value < GL_TEXTURE0 + kTextureUnits),
                         "{2} is no source of a combiner (3.7.12, tables 3.18 and 3.19)");
    case GL_OPERAND0_RGB:
    case GL_OPERAND1_RGB:
    case GL_OPERAND2_RGB:
      return operand(value, false);
    case GL_OPERAND0_ALPHA:
    case GL_OPERAND1_ALPHA:
    case GL_OPERAND2_ALPHA:
      return operand(value, true);
    case GL_RGB_SCALE:
    case GL_ALPHA_SCALE:
      return value_unless(p.number() == 1 || p.number() == 2 || p.number() == 4,
                          "{2} is none of 1, 2 and 4 (3.7.12)");
    default:
      return {GL_INVALID_ENUM, "{1} is no parameter of texture environments (3.7.12)"};
  }
}

// What of generated coordinates can be set and asked for.
Invalid generated_mode(GLenum coord, GLenum pname) {
  if (coord != GL_TEXTURE_GEN_STR_OES) {
    return {GL_INVALID_ENUM, "{0} is not TEXTURE_GEN_STR_OES (OES_texture_cube_map, 2.11.4)"};
  }
  return enum_unless(pname == GL_TEXTURE_GEN_MODE_OES,
                     "{1} is not TEXTURE_GEN_MODE_OES (OES_texture_cube_map, 2.11.4)");
}

Invalid tex_gen(const Context&, GLenum coord, GLenum pname, const Params& p) {
  if (const Invalid wrong = generated_mode(coord, pname)) return wrong;
  return enum_unless(p.enumerant() == GL_NORMAL_MAP_OES || p.enumerant() == GL_REFLECTION_MAP_OES,
                     "{2} is neither NORMAL_MAP_OES nor REFLECTION_MAP_OES (OES_texture_cube_map, "
                     "2.11.4)");
}

}  // namespace clearpipe::api::validate
