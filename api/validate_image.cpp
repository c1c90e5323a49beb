// Validators of texture images, given, copied or changed in part (3.7.1, 3.7.2).
// SPDX-License-Identifier: MIT
#include "api/validate_image.h"

#include "api/framebuffer.h"
#include "api/pixel_format.h"
#include "api/texture_tokens.h"

namespace clearpipe::api::validate {

namespace {

// Two arguments in a row.
Invalid format_and_type(GLenum format, GLenum type) {
  if (!is_upload_format(format)) {
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
  return operation_unless(is_upload_type(format, type),
                          "{0} and {1} do not go together (3.6.2, table 3.4)");
}

// Table 3.9: the surface must have the components the texture wants.
Invalid copied_format(const Context& c, GLenum format) {
  if (const Invalid wrong = read_framebuffer(c)) return wrong;
  const bool wants_alpha = format == GL_ALPHA || format == GL_LUMINANCE_ALPHA || format == GL_RGBA;
  return operation_unless(!wants_alpha || read_target(c).colour->has_alpha,
                          "the format has alpha, the framebuffer has none (3.7.2, table 3.9)");
}

// A part of an image that has parts.
Invalid sub_rectangle(const Context& c, GLenum target, GLint level, GLint x, GLint y, GLsizei width,
                      GLsizei height, int size_at) {
  if (const Invalid wrong = image_level(level)) return wrong;
  const TextureLevel& to = image_of(c, target, level);
  if (base_format(to.internal) == 0) {
    return {GL_INVALID_OPERATION,
            "{1} of the bound texture has no image, or one with a palette or of a compressed "
            "format (3.7.2, 3.7.4)"};
  }
  return rectangle_in_level(to, x, y, width, height, size_at);
}

// An internal format that only compressed data can have: images are not compressed here, as
// EXT_texture_compression_dxt1 and those of ANGLE say.
Invalid compressed_only(GLenum internal) {
  return operation_unless(
      internal < GL_COMPRESSED_RGB_S3TC_DXT1_EXT || internal > GL_COMPRESSED_RGBA_S3TC_DXT5_ANGLE,
      "images are not compressed to {2} here: give compressed ones "
      "(EXT_texture_compression_dxt1)");
}

}  // namespace

Invalid image_target(GLenum target) {
  return enum_unless(is_image_target(target), "{0} is no target of images (3.7.1)");
}

const TextureLevel& image_of(const Context& c, GLenum target, GLint level) {
  return bound_texture(c, target)->level[image_index(target, level)];
}

Invalid mutable_texture(const TextureObject& texture) {
  return operation_unless(texture.storage_levels == 0,
                          "the levels of the texture of {0} are immutable (EXT_texture_storage)");
}

Invalid image_level(GLint level) {
  return value_unless(level >= 0 && level < kTextureLevels,
                      "{1} is not in [0, log2(MAX_TEXTURE_SIZE)] (3.7.1)");
}

Invalid image_size(GLenum target, GLint level, GLsizei width, GLsizei height) {
  static_assert(kMaxCubeMapSize == kMaxTextureSize);
  const GLsizei limit = kMaxTextureSize >> level;
  const auto fits = [limit](GLsizei size) { return size >= 0 && size <= limit; };
  if (!fits(width) || !fits(height)) {
    return {GL_INVALID_VALUE,
            "{0} or {1} is negative, or larger than MAX_TEXTURE_SIZE allows at this level (3.7.1)"};
  }
  return value_unless(!is_cube_face(target) || width == height,
                      "{0} and {1} are not equal, as those of a face are (OES_texture_cube_map)");
}

Invalid image_border(GLint border) { return value_unless(border == 0, "{2} is not zero (3.7.1)"); }

Invalid rectangle_in_level(const TextureLevel& level, GLint x, GLint y, GLsizei width,
                           GLsizei height, int size_at) {
  if (width < 0 || height < 0) {
    return Invalid(GL_INVALID_VALUE, "{0} or {1} is negative (3.7.2)").from(size_at);
  }
  const bool inside = x >= 0 && y >= 0 && width <= level.width && height <= level.height &&
                      x <= level.width - width && y <= level.height - height;
  return value_unless(inside,
                      "the rectangle at {2}, {3} reaches out of the level of the texture (3.7.2)");
}

Invalid tex_image(const Context& c, GLenum target, GLint level, GLint internal, GLsizei width,
                  GLsizei height, GLint border, GLenum format, GLenum type, const void*) {
  if (const Invalid wrong = image_target(target)) return wrong;
  const GLenum held = static_cast<GLenum>(internal);
  if (base_format(held) == 0) {
    if (const Invalid wrong = compressed_only(held)) return wrong;
    return {GL_INVALID_VALUE, "{2} is no internal format (3.7.1, table 3.8)"};
  }
  if (const Invalid wrong = format_and_type(format, type)) return wrong.from(6);
  if (const Invalid wrong = image_level(level)) return wrong;
  if (const Invalid wrong = image_size(target, level, width, height)) return wrong.from(3);
  if (const Invalid wrong = image_border(border)) return wrong.from(3);
  if (const Invalid wrong = pixels_for(held, format, type)) return wrong.from(6);
  return mutable_texture(*bound_texture(c, target));
}

Invalid tex_sub_image(const Context& c, GLenum target, GLint level, GLint x, GLint y, GLsizei width,
                      GLsizei height, GLenum format, GLenum type, const void*) {
  if (const Invalid wrong = image_target(target)) return wrong;
  if (const Invalid wrong = format_and_type(format, type)) return wrong.from(6);
  if (const Invalid wrong = sub_rectangle(c, target, level, x, y, width, height, 4)) return wrong;
  const GLenum held = image_of(c, target, level).internal;
  // What the whole image may be given in, a part may be too, and in any type of the format.
  return pixels_for(upload_format(held), format, type).from(6);
}

Invalid copy_tex_image(const Context& c, GLenum target, GLint level, GLenum internal, GLint, GLint,
                       GLsizei width, GLsizei height, GLint border) {
  if (const Invalid wrong = image_target(target)) return wrong;
  if (base_format(internal) == 0 || internal == GL_BGRA_EXT || is_srgb(internal)) {
    if (const Invalid wrong = compressed_only(internal)) return wrong;
    return {GL_INVALID_ENUM, "{2} is no internal format of copies (3.7.2, table 3.8)"};
  }
  if (const Invalid wrong = image_level(level)) return wrong;
  if (const Invalid wrong = image_size(target, level, width, height)) return wrong.from(5);
  if (const Invalid wrong = image_border(border)) return wrong.from(5);
  if (const Invalid wrong = copied_format(c, base_format(internal))) return wrong;
  return mutable_texture(*bound_texture(c, target));
}

Invalid copy_tex_sub_image(const Context& c, GLenum target, GLint level, GLint xoffset,
                           GLint yoffset, GLint, GLint, GLsizei width, GLsizei height) {
  if (const Invalid wrong = image_target(target)) return wrong;
  if (const Invalid wrong = sub_rectangle(c, target, level, xoffset, yoffset, width, height, 6)) {
    return wrong;
  }
  return copied_format(c, image_of(c, target, level).format);
}

}  // namespace clearpipe::api::validate
