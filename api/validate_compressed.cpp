// Validators of compressed texture images (3.7.3, 3.7.4, and the extensions that
// compressed_format.cpp names).
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "api/compressed_format.h"
#include "api/pixel_format.h"
#include "api/validate_image.h"

namespace clearpipe::api::validate {

namespace {

constexpr Invalid kNoFormat{GL_INVALID_ENUM,
                            "{0} is no format of compressed images (3.7.3, table 3.10)"};

// Two arguments in a row.
Invalid image_data(int64_t expected, GLsizei size, const void* data) {
  if (size != expected) {
    return {GL_INVALID_VALUE, "{0} is not the size of such an image (3.7.3)"};
  }
  return value_unless(data || size == 0, "{1} is no image (3.7.3)");
}

Invalid palette_image(GLenum target, const Palette& palette, GLint level, GLsizei width,
                      GLsizei height, GLint border, GLsizei size, const void* data) {
  // The level is minus the number of levels beyond the base (3.7.4).
  if (level > 0 || level <= -kTextureLevels) {
    return {GL_INVALID_VALUE, "{1} is not minus the number of levels beyond the base (3.7.4)"};
  }
  if (const Invalid wrong = image_size(target, 0, width, height)) return wrong.from(3);
  if (const Invalid wrong = image_border(border)) return wrong.from(3);
  if (-level > 0 && std::max(width, height) >> -level == 0) {
    return {GL_INVALID_VALUE, "{1} asks for more levels than {3} and {4} have (3.7.4)"};
  }
  const size_t colour = pipeline::bytes_of(unpack_layout(palette.format, palette.type));
  int64_t expected = static_cast<int64_t>(colour << palette.index_bits);
  for (int i = 0; i <= -level; ++i) {
    const int64_t texels = static_cast<int64_t>(width == 0 ? 0 : std::max(width >> i, 1)) *
                           (height == 0 ? 0 : std::max(height >> i, 1));
    expected += (texels * palette.index_bits + 7) / 8;
  }
  return image_data(expected, size, data).from(6);
}

// One axis of a part: where it begins and how long it is, of an image that long.
bool is_allowed(CompressedFamily::Parts parts, GLint offset, GLsizei length, GLsizei whole) {
  if (parts == CompressedFamily::Parts::kNone) return length == whole;
  if (offset % 4 != 0) return false;
  const bool to_the_edge = parts == CompressedFamily::Parts::kBlocksToTheEdge;
  return length % 4 == 0 || (to_the_edge ? offset + length : length) == whole;
}

Invalid block_data(const CompressedFormat& format, GLsizei width, GLsizei height, GLsizei size,
                   const void* data) {
  return image_data(compressed_bytes(format, width, height), size, data);
}

}  // namespace

Invalid compressed_size(const CompressedFamily& family, GLsizei width, GLsizei height) {
  const auto both = [&](const auto& good) { return good(width) && good(height); };
  switch (family.sizes) {
    case CompressedFamily::Sizes::kOneTwoOrBlocks:
      return operation_unless(
          both([](GLsizei size) { return size == 1 || size == 2 || size % 4 == 0; }),
          "{3} or {4} is neither 1 nor 2 nor a multiple of 4 (the extension of {2})");
    case CompressedFamily::Sizes::kPowersOfTwo:
      return value_unless(both([](GLsizei size) { return (size & (size - 1)) == 0; }),
                          "{3} or {4} is no power of two (the extension of {2})");
    default:
      return {};
  }
}

Invalid compressed_tex_image(const Context& c, GLenum target, GLint level, GLenum internal,
                             GLsizei width, GLsizei height, GLint border, GLsizei size,
                             const void* data) {
  if (const Invalid wrong = image_target(target)) return wrong;
  const Palette palette = palette_of(internal);
  const CompressedFormat* format = compressed_format(internal);
  if (palette.index_bits != 0) {
    const Invalid wrong = palette_image(target, palette, level, width, height, border, size, data);
    return wrong ? wrong : mutable_texture(*bound_texture(c, target));
  }
  if (!format) return kNoFormat.from(2);
  const CompressedFamily& family = format->family;
  if (border != 0) {
    return {family.border_error, "{5} is not zero (3.7.3, and the extension of {2})"};
  }
  if (const Invalid wrong = image_level(level)) return wrong;
  if (const Invalid wrong = image_size(target, level, width, height)) return wrong.from(3);
  if (const Invalid wrong = compressed_size(family, width, height)) return wrong;
  if (const Invalid wrong = block_data(*format, width, height, size, data)) return wrong.from(6);
  return mutable_texture(*bound_texture(c, target));
}

Invalid compressed_tex_sub_image(const Context& c, GLenum target, GLint level, GLint x, GLint y,
                                 GLsizei width, GLsizei height, GLenum internal, GLsizei size,
                                 const void* data) {
  if (const Invalid wrong = image_target(target)) return wrong;
  const CompressedFormat* format = compressed_format(internal);
  if (palette_of(internal).index_bits != 0) {
    return {GL_INVALID_OPERATION, "an image with a palette has no parts (3.7.4)"};
  }
  if (!format) return kNoFormat.from(6);
  if (const Invalid wrong = image_level(level)) return wrong;
  const TextureLevel& to = image_of(c, target, level);
  if (to.internal != internal) {
    return {GL_INVALID_OPERATION, "{6} is not the internal format of the texture (3.7.3)"};
  }
  if (const Invalid wrong = rectangle_in_level(to, x, y, width, height, 4)) return wrong;
  if (!is_allowed(format->family.parts, x, width, to.width) ||
      !is_allowed(format->family.parts, y, height, to.height)) {
    return {
        GL_INVALID_OPERATION,
        "the rectangle at {2}, {3} is not made of whole blocks, or not the whole image (3.7.3, and "
        "the extension of {6})"};
  }
  return block_data(*format, width, height, size, data).from(7);
}

}  // namespace clearpipe::api::validate
