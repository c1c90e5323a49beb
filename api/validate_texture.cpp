// Validators of textures, their images and environments (3.6, 3.7).
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "api/framebuffer.h"
#include "api/pixel_format.h"
#include "api/validate.h"

namespace clearpipe::api::validate {

namespace {

// Of every call about an image, the second argument.
Invalid image_level(GLint level) {
  return value_unless(level >= 0 && level < kTextureLevels,
                      "{1} is not in [0, log2(MAX_TEXTURE_SIZE)] (3.7.1)");
}

// Three arguments in a row. Sizes need not be powers of two (OES_texture_npot).
Invalid image_size(GLint level, GLsizei width, GLsizei height, GLint border) {
  const GLsizei limit = kMaxTextureSize >> level;
  const auto fits = [limit](GLsizei size) { return size >= 0 && size <= limit; };
  if (!fits(width) || !fits(height)) {
    return {GL_INVALID_VALUE,
            "{0} or {1} is negative, or larger than MAX_TEXTURE_SIZE allows at this level (3.7.1)"};
  }
  return value_unless(border == 0, "{2} is not zero (3.7.1)");
}

// A part of an image that must be there: the first six arguments.
Invalid sub_rectangle(const Context& c, GLint level, GLint x, GLint y, GLsizei width,
                      GLsizei height, int size_at) {
  if (const Invalid wrong = image_level(level)) return wrong;
  const TextureLevel& to = c.active_unit().texture->level[static_cast<size_t>(level)];
  if (base_format(to.internal) == 0) {
    return {
        GL_INVALID_OPERATION,
        "{1} of the bound texture has no image, or a compressed one, which has no parts (3.7.2, "
        "3.7.4)"};
  }
  if (width < 0 || height < 0) {
    return Invalid(GL_INVALID_VALUE, "{0} or {1} is negative (3.7.2)").from(size_at);
  }
  const bool inside = x >= 0 && y >= 0 && width <= to.width && height <= to.height &&
                      x <= to.width - width && y <= to.height - height;
  return value_unless(inside,
                      "the rectangle at {2}, {3} reaches out of the level of the texture (3.7.2)");
}

// Two arguments in a row.
Invalid format_and_type(GLenum format, GLenum type) {
  if (!is_base_format(format) && format != GL_BGRA_EXT) {
    return {GL_INVALID_ENUM, "{0} is no format of pixels (3.6.2, table 3.3)"};
  }
  return enum_unless(type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_SHORT_5_6_5 ||
                         type == GL_UNSIGNED_SHORT_4_4_4_4 || type == GL_UNSIGNED_SHORT_5_5_5_1,
                     "{1} is no type of pixels (3.6.2, table 3.2)");
}
Invalid pixels_for(GLenum internal, GLenum format, GLenum type) {
  if (upload_format(internal) != format) {
    return {GL_INVALID_OPERATION, "{0} is not the format of the texture (3.7.1)"};
  }
  if (!has_enough_bits(internal, type)) {
    return {GL_INVALID_OPERATION,
            "{1} has fewer bits than the internal format (OES_required_internalformat, table 3.4)"};
  }
  return operation_unless(pixel_bytes(format, type) != 0,
                          "{0} and {1} do not go together (3.6.2, table 3.4)");
}

// Table 3.9: the surface must have the components the texture wants.
Invalid copied_format(const Context& c, GLenum format) {
  if (const Invalid wrong = read_framebuffer(c)) return wrong;
  const bool wants_alpha = format == GL_ALPHA || format == GL_LUMINANCE_ALPHA || format == GL_RGBA;
  return operation_unless(!wants_alpha || read_target(c).colour->has_alpha,
                          "the format has alpha, the framebuffer has none (3.7.2, table 3.9)");
}

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

}  // namespace

Invalid pixel_store(const Context&, GLenum pname, GLint param) {
  if (pname != GL_PACK_ALIGNMENT && pname != GL_UNPACK_ALIGNMENT) {
    return {GL_INVALID_ENUM,
            "{0} is neither PACK_ALIGNMENT nor UNPACK_ALIGNMENT (3.6.1, table 3.1)"};
  }
  return value_unless(param == 1 || param == 2 || param == 4 || param == 8,
                      "{1} is none of 1, 2, 4 and 8 (3.6.1, table 3.1)");
}

Invalid texture_target(const Context&, GLenum target, GLuint) {
  return enum_unless(target == GL_TEXTURE_2D, "{0} is no target of textures (3.7)");
}

Invalid names(const Context&, GLsizei n, const GLuint*) {
  return value_unless(n >= 0, "{0} is negative (2.5)");
}

Invalid tex_image(const Context& c, GLenum target, GLint level, GLint internal, GLsizei width,
                  GLsizei height, GLint border, GLenum format, GLenum type, const void*) {
  if (const Invalid wrong = texture_target(c, target, 0)) return wrong;
  const GLenum held = static_cast<GLenum>(internal);
  if (base_format(held) == 0) {
    return {GL_INVALID_VALUE, "{2} is no internal format (3.7.1, table 3.8)"};
  }
  if (const Invalid wrong = format_and_type(format, type)) return wrong.from(6);
  if (const Invalid wrong = image_level(level)) return wrong;
  if (const Invalid wrong = image_size(level, width, height, border)) return wrong.from(3);
  return pixels_for(held, format, type).from(6);
}

Invalid tex_sub_image(const Context& c, GLenum target, GLint level, GLint x, GLint y, GLsizei width,
                      GLsizei height, GLenum format, GLenum type, const void*) {
  if (const Invalid wrong = texture_target(c, target, 0)) return wrong;
  if (const Invalid wrong = format_and_type(format, type)) return wrong.from(6);
  if (const Invalid wrong = sub_rectangle(c, level, x, y, width, height, 4)) return wrong;
  const GLenum held = c.active_unit().texture->level[static_cast<size_t>(level)].internal;
  // What the whole image may be given in, a part may be too, and in any type of the format.
  return pixels_for(upload_format(held), format, type).from(6);
}

Invalid copy_tex_image(const Context& c, GLenum target, GLint level, GLenum internal, GLint, GLint,
                       GLsizei width, GLsizei height, GLint border) {
  if (const Invalid wrong = texture_target(c, target, 0)) return wrong;
  if (base_format(internal) == 0 || internal == GL_BGRA_EXT) {
    return {GL_INVALID_ENUM, "{2} is no internal format of copies (3.7.2, table 3.8)"};
  }
  if (const Invalid wrong = image_level(level)) return wrong;
  if (const Invalid wrong = image_size(level, width, height, border)) return wrong.from(5);
  return copied_format(c, base_format(internal));
}

Invalid copy_tex_sub_image(const Context& c, GLenum target, GLint level, GLint xoffset,
                           GLint yoffset, GLint, GLint, GLsizei width, GLsizei height) {
  if (const Invalid wrong = texture_target(c, target, 0)) return wrong;
  if (const Invalid wrong = sub_rectangle(c, level, xoffset, yoffset, width, height, 6)) {
    return wrong;
  }
  return copied_format(c, c.active_unit().texture->level[static_cast<size_t>(level)].format);
}

Invalid compressed_tex_image(const Context& c, GLenum target, GLint level, GLenum internal,
                             GLsizei width, GLsizei height, GLint border, GLsizei size,
                             const void* data) {
  if (const Invalid wrong = texture_target(c, target, 0)) return wrong;
  const Palette palette = palette_of(internal);
  if (palette.index_bits == 0) {
    return {GL_INVALID_ENUM, "{2} is no format of compressed images (3.7.3, table 3.10)"};
  }
  // The level is minus the number of levels beyond the base (3.7.4).
  if (level > 0 || level <= -kTextureLevels) {
    return {GL_INVALID_VALUE, "{1} is not minus the number of levels beyond the base (3.7.4)"};
  }
  if (const Invalid wrong = image_size(0, width, height, border)) return wrong.from(3);
  if (-level > 0 && std::max(width, height) >> -level == 0) {
    return {GL_INVALID_VALUE, "{1} asks for more levels than {3} and {4} have (3.7.4)"};
  }
  int64_t expected = static_cast<int64_t>(pixel_bytes(palette.format, palette.type))
                     << palette.index_bits;
  for (int i = 0; i <= -level; ++i) {
    const int64_t texels = static_cast<int64_t>(width == 0 ? 0 : std::max(width >> i, 1)) *
                           (height == 0 ? 0 : std::max(height >> i, 1));
    expected += (texels * palette.index_bits + 7) / 8;
  }
  if (size != expected) {
    return {GL_INVALID_VALUE, "{6} is not the size of such an image (3.7.3, 3.7.4)"};
  }
  return value_unless(data != nullptr, "{7} is no image (3.7.3)");
}

Invalid compressed_tex_sub_image(const Context& c, GLenum target, GLint, GLint, GLint, GLsizei,
                                 GLsizei, GLenum format, GLsizei, const void*) {
  if (const Invalid wrong = texture_target(c, target, 0)) return wrong;
  if (palette_of(format).index_bits == 0) {
    return {GL_INVALID_ENUM, "{6} is no format of compressed images (3.7.3, table 3.10)"};
  }
  return {GL_INVALID_OPERATION, "an image with a palette has no parts (3.7.4)"};
}

Invalid tex_parameter(const Context& c, GLenum target, GLenum pname, const Params& p) {
  if (const Invalid wrong = texture_target(c, target, 0)) return wrong;
  const GLenum value = p.enumerant();
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
                             value == GL_BLEND || value == GL_ADD || value == GL_COMBINE,
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

}  // namespace clearpipe::api::validate
