// Validators of texture images, given, copied or changed in part (3.7.1, 3.7.2).
// SPDX-License-Identifier: MIT
#include "api/validate_image.h"

#include "api/framebuffer.h"
#include "api/pixel_format.h"
#include "api/texture_tokens.h"

namespace clearpipe::api::validate {

namespace {

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

GLenum sub_rectangle(const Context& c, GLint level, GLint x, GLint y, GLsizei width,
                     GLsizei height) {
  if (level < 0 || level >= kTextureLevels) return GL_INVALID_VALUE;
  const TextureLevel& to = c.active_unit().texture->level[static_cast<size_t>(level)];
  // Neither an absent image nor a compressed one has parts (3.7.4).
  if (base_format(to.internal) == 0) return GL_INVALID_OPERATION;
  return rectangle_in_level(to, x, y, width, height);
}

// The error of an internal format that only compressed data can have: images are not compressed
// here, as EXT_texture_compression_dxt1 and those of ANGLE say.
GLenum unknown_format(GLenum internal, GLenum error) {
  return internal >= GL_COMPRESSED_RGB_S3TC_DXT1_EXT &&
                 internal <= GL_COMPRESSED_RGBA_S3TC_DXT5_ANGLE
             ? GL_INVALID_OPERATION
             : error;
}

}  // namespace

GLenum level_and_size(GLint level, GLsizei width, GLsizei height, GLint border) {
  if (level < 0 || level >= kTextureLevels || border != 0) return GL_INVALID_VALUE;
  const GLsizei limit = kMaxTextureSize >> level;
  return width < 0 || height < 0 || width > limit || height > limit ? GL_INVALID_VALUE
                                                                    : GL_NO_ERROR;
}

GLenum rectangle_in_level(const TextureLevel& level, GLint x, GLint y, GLsizei width,
                          GLsizei height) {
  const bool inside = x >= 0 && y >= 0 && width >= 0 && height >= 0 && width <= level.width &&
                      height <= level.height && x <= level.width - width &&
                      y <= level.height - height;
  return inside ? GL_NO_ERROR : GL_INVALID_VALUE;
}

GLenum tex_image(const Context&, GLenum target, GLint level, GLint internal, GLsizei width,
                 GLsizei height, GLint border, GLenum format, GLenum type, const void*) {
  if (target != GL_TEXTURE_2D) return GL_INVALID_ENUM;
  const GLenum held = static_cast<GLenum>(internal);
  if (base_format(held) == 0) return unknown_format(held, GL_INVALID_VALUE);
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
  if (target != GL_TEXTURE_2D || internal == GL_BGRA_EXT) return GL_INVALID_ENUM;
  if (base_format(internal) == 0) return unknown_format(internal, GL_INVALID_ENUM);
  if (const GLenum error = level_and_size(level, width, height, border)) return error;
  return copied_format(c, base_format(internal));
}

GLenum copy_tex_sub_image(const Context& c, GLenum target, GLint level, GLint xoffset,
                          GLint yoffset, GLint, GLint, GLsizei width, GLsizei height) {
  if (target != GL_TEXTURE_2D) return GL_INVALID_ENUM;
  if (const GLenum error = sub_rectangle(c, level, xoffset, yoffset, width, height)) return error;
  return copied_format(c, c.active_unit().texture->level[static_cast<size_t>(level)].format);
}

}  // namespace clearpipe::api::validate
