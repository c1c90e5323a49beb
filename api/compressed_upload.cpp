// Compressed texture images become RGBA8 texels (3.7.3, 3.7.4). Mipmaps are not generated from them
// (3.7.7).
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "api/compressed_format.h"
#include "api/exec.h"
#include "api/pixel_format.h"
#include "api/texture_levels.h"
#include "api/texture_target.h"

namespace clearpipe::api::exec {

namespace {

// The data of formats with a palette has all levels, from the base to that of -level.
Levels decode_palette(const Palette& palette, GLint level, GLsizei width, GLsizei height,
                      const uint8_t* colours) {
  const pipeline::UnpackLayout layout = unpack_layout(palette.format, palette.type);
  const size_t count = size_t{1} << palette.index_bits;
  uint32_t colour[256];
  pipeline::unpack_pixels(layout, colours, count, colour);
  const uint8_t* indices = colours + count * pipeline::bytes_of(layout);
  Levels levels;
  for (int i = 0; i <= -level; ++i) {
    pipeline::ImageLevel to = make_level(width == 0 ? 0 : std::max(width >> i, 1),
                                         height == 0 ? 0 : std::max(height >> i, 1));
    for (size_t k = 0; k < to.texels.size(); ++k) {
      // Two 4-bit indices in a byte: the first is in the upper half.
      const uint32_t index = palette.index_bits == 8 ? indices[k]
                             : k % 2 == 0            ? indices[k / 2] >> 4u
                                                     : indices[k / 2] & 15u;
      to.texels[k] = colour[index];
    }
    indices += (to.texels.size() * static_cast<size_t>(palette.index_bits) + 7) / 8;
    levels.push_back(std::move(to));
  }
  return levels;
}

}  // namespace

void compressed_tex_image(Context& c, GLenum target, GLint level, GLenum internal, GLsizei width,
                          GLsizei height, GLint, GLsizei, const void* data) {
  TextureObject& texture = *bound_texture(c, target);
  const auto* bytes = static_cast<const uint8_t*>(data);
  if (const CompressedFormat* format = compressed_format(internal)) {
    pipeline::ImageLevel to = make_level(width, height);
    format->decode(bytes, {to, 0, 0, width, height});
    replace_level(c, texture, image_index(target, level), std::move(to), internal, format->base);
    return;
  }
  const Palette palette = palette_of(internal);
  Levels levels = decode_palette(palette, level, width, height, bytes);
  install_levels(c, texture, image_index(target, 0), levels, internal, palette.format);
}

void compressed_tex_sub_image(Context& c, GLenum target, GLint level, GLint x, GLint y,
                              GLsizei width, GLsizei height, GLenum internal, GLsizei,
                              const void* data) {
  if (width == 0 || height == 0) return;
  const auto change = [&](pipeline::ImageLevel& to) {
    compressed_format(internal)->decode(static_cast<const uint8_t*>(data),
                                        {to, x, y, width, height});
  };
  change_level(c, *bound_texture(c, target), image_index(target, level), change);
}

}  // namespace clearpipe::api::exec
