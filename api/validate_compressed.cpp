// Validators of compressed texture images (3.7.3, 3.7.4, and the extensions that
// compressed_format.cpp names).
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "api/compressed_format.h"
#include "api/pixel_format.h"
#include "api/validate_image.h"

namespace clearpipe::api::validate {

namespace {

GLenum palette_image(const Palette& palette, GLint level, GLsizei width, GLsizei height,
                     GLint border, GLsizei size, const void* data) {
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

bool is_allowed(ImageSizes sizes, GLsizei size) {
  return sizes == ImageSizes::kAll || size == 1 || size == 2 || size % 4 == 0;
}

// One axis of a part: where it begins and how long it is, of an image that long.
bool is_allowed(ImageParts parts, GLint offset, GLsizei length, GLsizei whole) {
  if (offset % 4 != 0) return false;
  const GLsizei end = parts == ImageParts::kBlocksToTheEdge ? offset + length : length;
  return length % 4 == 0 || end == whole;
}

GLenum data_of(const CompressedFormat& format, GLsizei width, GLsizei height, GLsizei size,
               const void* data) {
  const bool good = size == compressed_bytes(format, width, height) && (data || size == 0);
  return good ? GL_NO_ERROR : GL_INVALID_VALUE;
}

}  // namespace

GLenum compressed_tex_image(const Context&, GLenum target, GLint level, GLenum internal,
                            GLsizei width, GLsizei height, GLint border, GLsizei size,
                            const void* data) {
  const Palette palette = palette_of(internal);
  const CompressedFormat* format = compressed_format(internal);
  if (target != GL_TEXTURE_2D || (palette.index_bits == 0 && !format)) return GL_INVALID_ENUM;
  if (!format) return palette_image(palette, level, width, height, border, size, data);
  if (border != 0) return GL_INVALID_OPERATION;
  if (const GLenum error = level_and_size(level, width, height, 0)) return error;
  if (!is_allowed(format->sizes, width) || !is_allowed(format->sizes, height)) {
    return GL_INVALID_OPERATION;
  }
  return data_of(*format, width, height, size, data);
}

GLenum compressed_tex_sub_image(const Context& c, GLenum target, GLint level, GLint x, GLint y,
                                GLsizei width, GLsizei height, GLenum internal, GLsizei size,
                                const void* data) {
  const CompressedFormat* format = compressed_format(internal);
  const bool has_palette = palette_of(internal).index_bits != 0;
  if (target != GL_TEXTURE_2D || (!format && !has_palette)) return GL_INVALID_ENUM;
  if (has_palette) return GL_INVALID_OPERATION;  // palettes cannot be updated in part
  if (level < 0 || level >= kTextureLevels) return GL_INVALID_VALUE;
  const TextureLevel& to = c.active_unit().texture->level[static_cast<size_t>(level)];
  if (to.internal != internal) return GL_INVALID_OPERATION;
  if (const GLenum error = rectangle_in_level(to, x, y, width, height)) return error;
  if (!is_allowed(format->parts, x, width, to.width) ||
      !is_allowed(format->parts, y, height, to.height)) {
    return GL_INVALID_OPERATION;
  }
  return data_of(*format, width, height, size, data);
}

}  // namespace clearpipe::api::validate
