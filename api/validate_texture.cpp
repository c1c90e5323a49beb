// Validators of textures, their images and environments (3.6, 3.7).
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "api/framebuffer.h"
#include "api/pixel_format.h"
#include "api/validate.h"

namespace clearpipe::api::validate {

namespace {

GLenum enum_if(bool good) { return good ? GL_NO_ERROR : GL_INVALID_ENUM; }

// Sizes need not be powers of two (OES_texture_npot).
GLenum level_and_size(GLint level, GLsizei width, GLsizei height, GLint border) {
  if (level < 0 || level >= kTextureLevels || border != 0) return GL_INVALID_VALUE;
  const GLsizei limit = kMaxTextureSize >> level;
  return width < 0 || height < 0 || width > limit || height > limit ? GL_INVALID_VALUE
                                                                    : GL_NO_ERROR;
}

GLenum sub_rectangle(const Context& c, GLint level, GLint x, GLint y, GLsizei width,
                     GLsizei height) {
  if (level < 0 || level >= kTextureLevels) return GL_INVALID_VALUE;
  const TextureLevel& to = c.active_unit().texture->level[static_cast<size_t>(level)];
  // Neither an absent image nor a compressed one has parts (3.7.4).
  if (base_format(to.internal) == 0) return GL_INVALID_OPERATION;
  const bool inside = x >= 0 && y >= 0 && width >= 0 && height >= 0 && width <= to.width &&
                      height <= to.height && x <= to.width - width && y <= to.height - height;
  return inside ? GL_NO_ERROR : GL_INVALID_VALUE;
}

GLenum format_and_type(GLenum format, GLenum type) {
  const bool known = type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_SHORT_5_6_5 ||
                     type == GL_UNSIGNED_SHORT_4_4_4_4 || type == GL_UNSIGNED_SHORT_5_5_5_1;
  if ((!is_base_format(format) && format != GL_BGRA_EXT) || !known) return GL_INVALID_ENUM;
  return pixel_bytes(format, type) != 0 ? GL_NO_ERROR : GL_INVALID_OPERATION;
}

// Table 3.9: the surface must have the components the texture wants.
GLenum copied_format(const Context& c, GLenum format) {
  if (const GLenum error = read_framebuffer_error(c)) return error;
  const bool wants_alpha = format == GL_ALPHA || format == GL_LUMINANCE_ALPHA || format == GL_RGBA;
  return wants_alpha && !read_target(c).colour->has_alpha ? GL_INVALID_OPERATION : GL_NO_ERROR;
}

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

GLenum tex_image(const Context&, GLenum target, GLint level, GLint internal, GLsizei width,
                 GLsizei height, GLint border, GLenum format, GLenum type, const void*) {
  if (target != GL_TEXTURE_2D) return GL_INVALID_ENUM;
  const GLenum held = static_cast<GLenum>(internal);
  if (base_format(held) == 0) return GL_INVALID_VALUE;
  const GLenum pair = format_and_type(format, type);
  if (pair == GL_INVALID_ENUM) return pair;
  if (const GLenum error = level_and_size(level, width, height, border)) return error;
  return upload_format(held) == format && has_enough_bits(held, type) ? pair : GL_INVALID_OPERATION;
}

GLenum tex_sub_image(const Context& c, GLenum target, GLint level, GLint x, GLint y, GLsizei width,
                     GLsizei height, GLenum format, GLenum type, const void*) {
  if (target != GL_TEXTURE_2D) return GL_INVALID_ENUM;
  const GLenum pair = format_and_type(format, type);
  if (pair == GL_INVALID_ENUM) return pair;
  if (const GLenum error = sub_rectangle(c, level, x, y, width, height)) return error;
  const GLenum held = c.active_unit().texture->level[static_cast<size_t>(level)].internal;
  return upload_format(held) == format ? pair : GL_INVALID_OPERATION;
}

GLenum copy_tex_image(const Context& c, GLenum target, GLint level, GLenum internal, GLint, GLint,
                      GLsizei width, GLsizei height, GLint border) {
  if (target != GL_TEXTURE_2D || base_format(internal) == 0 || internal == GL_BGRA_EXT) {
    return GL_INVALID_ENUM;
  }
  if (const GLenum error = level_and_size(level, width, height, border)) return error;
  return copied_format(c, base_format(internal));
}

GLenum copy_tex_sub_image(const Context& c, GLenum target, GLint level, GLint xoffset,
                          GLint yoffset, GLint, GLint, GLsizei width, GLsizei height) {
  if (target != GL_TEXTURE_2D) return GL_INVALID_ENUM;
  if (const GLenum error = sub_rectangle(c, level, xoffset, yoffset, width, height)) return error;
  return copied_format(c, c.active_unit().texture->level[static_cast<size_t>(level)].format);
}

GLenum compressed_tex_image(const Context&, GLenum target, GLint level, GLenum internal,
                            GLsizei width, GLsizei height, GLint border, GLsizei size,
                            const void* data) {
  const Palette palette = palette_of(internal);
  if (target != GL_TEXTURE_2D || palette.index_bits == 0) return GL_INVALID_ENUM;
  // The level is minus the number of levels beyond the base (3.7.4).
  if (level > 0 || level <= -kTextureLevels) return GL_INVALID_VALUE;
  if (const GLenum error = level_and_size(0, width, height, border)) return error;
  if (-level > 0 && std::max(width, height) >> -level == 0) return GL_INVALID_VALUE;
  int64_t expected = static_cast<int64_t>(pixel_bytes(palette.format, palette.type))
                     << palette.index_bits;
  for (int i = 0; i <= -level; ++i) {
    const int64_t texels = static_cast<int64_t>(width == 0 ? 0 : std::max(width >> i, 1)) *
                           (height == 0 ? 0 : std::max(height >> i, 1));
    expected += (texels * palette.index_bits + 7) / 8;
  }
  return size == expected && data ? GL_NO_ERROR : GL_INVALID_VALUE;
}

GLenum compressed_tex_sub_image(const Context&, GLenum target, GLint, GLint, GLint, GLsizei,
                                GLsizei, GLenum format, GLsizei, const void*) {
  if (target != GL_TEXTURE_2D || palette_of(format).index_bits == 0) return GL_INVALID_ENUM;
  return GL_INVALID_OPERATION;  // palettes cannot be updated in part
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
