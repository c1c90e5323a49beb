// Texture images: what an application uploads or copies becomes RGBA8 texels (3.7.1 to 3.7.3), and
// mipmaps are made by a 2x2 box filter (3.7.11).
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "api/exec.h"
#include "api/pixel_format.h"

namespace clearpipe::api::exec {

namespace {

// Makes an empty level; its texels start as zero.
pipeline::ImageLevel& define_level(Context& c, TextureObject& texture, size_t level, GLenum format,
                                   GLenum type, int width, int height) {
  std::vector<uint32_t> texels(static_cast<size_t>(width) * static_cast<size_t>(height));
  pipeline::Image& image = writable_image(texture);
  if (image.levels.size() <= level) image.levels.resize(level + 1);
  image.levels[level] = {width, height, std::move(texels)};
  texture.level[level] = {width, height, format, type};
  c.dirty |= kDirtyTexture;
  return image.levels[level];
}

void unpack(pipeline::ImageLevel& to, int x, int y, int width, int height, GLenum format,
            GLenum type, const void* pixels, int alignment) {
  const size_t bytes = pixel_bytes(format, type), align = static_cast<size_t>(alignment);
  const size_t row = (bytes * static_cast<size_t>(width) + align - 1) / align * align;
  for (int j = 0; j < height; ++j) {
    const uint8_t* from = static_cast<const uint8_t*>(pixels) + row * static_cast<size_t>(j);
    uint32_t* texel = to.texels.data() + static_cast<ptrdiff_t>(y + j) * to.width + x;
    for (int i = 0; i < width; ++i, from += bytes) *texel++ = unpack_pixel(from, format, type);
  }
}

uint32_t average(uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
  uint32_t result = 0;
  for (uint32_t shift = 0; shift < 32; shift += 8) {
    const uint32_t sum =
        (a >> shift & 255) + (b >> shift & 255) + (c >> shift & 255) + (d >> shift & 255);
    result |= (sum + 2) / 4 << shift;
  }
  return result;
}

void generate_mipmaps(Context& c, TextureObject& texture) {
  const TextureLevel base = texture.level[0];
  int width = base.width, height = base.height;
  for (size_t level = 1; (width > 1 || height > 1) && level < kTextureLevels; ++level) {
    const int to_width = std::max(1, width / 2), to_height = std::max(1, height / 2);
    pipeline::ImageLevel& to =
        define_level(c, texture, level, base.format, base.type, to_width, to_height);
    const pipeline::ImageLevel& from = texture.image->levels[level - 1];
    const auto texel = [&from](int x, int y) {
      return from.texels[static_cast<size_t>(y) * static_cast<size_t>(from.width) +
                         static_cast<size_t>(x)];
    };
    size_t next = 0;
    for (int y = 0; y < to_height; ++y) {
      const int y0 = std::min(2 * y, height - 1), y1 = std::min(2 * y + 1, height - 1);
      for (int x = 0; x < to_width; ++x) {
        const int x0 = std::min(2 * x, width - 1), x1 = std::min(2 * x + 1, width - 1);
        to.texels[next++] = average(texel(x0, y0), texel(x1, y0), texel(x0, y1), texel(x1, y1));
      }
    }
    width = to_width;
    height = to_height;
  }
}

void after_change(Context& c, TextureObject& texture, GLint level) {
  if (level == 0 && texture.generate_mipmap && texture.level[0].width != 0) {
    generate_mipmaps(c, texture);
  }
  c.dirty |= kDirtyTexture;
}

// What of a surface's colour a base format keeps (table 3.9): luminance is the red component.
uint32_t reduce(uint32_t colour, GLenum format) {
  const uint32_t r = colour & 255, a = colour >> 24;
  switch (format) {
    case GL_RGBA:
      return colour;
    case GL_RGB:
      return colour | 0xff000000u;
    case GL_LUMINANCE_ALPHA:
      return rgba(r, r, r, a);
    case GL_LUMINANCE:
      return rgba(r, r, r, 255);
    default:
      return rgba(0, 0, 0, a);
  }
}

void copy_from_surface(Context& c, pipeline::ImageLevel& to, GLenum format, int xoffset,
                       int yoffset, int x, int y, int width, int height) {
  c.frame.finish();
  const pipeline::ColourBuffer& from = *c.read.colour;
  for (int64_t j = 0; j < height; ++j) {
    for (int64_t i = 0; i < width; ++i) {
      // Pixels outside of the surface are undefined: they leave the texel as it is.
      if (x + i < 0 || x + i >= from.width || y + j < 0 || y + j >= from.height) continue;
      to.texels[static_cast<size_t>((yoffset + j) * to.width + xoffset + i)] =
          reduce(from.pixels[static_cast<size_t>((y + j) * from.width + x + i)], format);
    }
  }
}

}  // namespace

void tex_image(Context& c, GLenum, GLint level, GLint, GLsizei width, GLsizei height, GLint,
               GLenum format, GLenum type, const void* pixels) {
  TextureObject& texture = *c.active_unit().texture;
  pipeline::ImageLevel& to =
      define_level(c, texture, static_cast<size_t>(level), format, type, width, height);
  if (pixels) {
    unpack(to, 0, 0, width, height, format, type, pixels, c.state.misc.unpack_alignment);
  } else {
    std::fill(to.texels.begin(), to.texels.end(), reduce(0, format));
  }
  after_change(c, texture, level);
}

void tex_sub_image(Context& c, GLenum, GLint level, GLint x, GLint y, GLsizei width, GLsizei height,
                   GLenum format, GLenum type, const void* pixels) {
  if (!pixels || width == 0 || height == 0) return;
  TextureObject& texture = *c.active_unit().texture;
  unpack(writable_image(texture).levels[static_cast<size_t>(level)], x, y, width, height, format,
         type, pixels, c.state.misc.unpack_alignment);
  after_change(c, texture, level);
}

void copy_tex_image(Context& c, GLenum, GLint level, GLenum internal, GLint x, GLint y,
                    GLsizei width, GLsizei height, GLint) {
  TextureObject& texture = *c.active_unit().texture;
  pipeline::ImageLevel& to = define_level(c, texture, static_cast<size_t>(level), internal,
                                          GL_UNSIGNED_BYTE, width, height);
  copy_from_surface(c, to, internal, 0, 0, x, y, width, height);
  after_change(c, texture, level);
}

void copy_tex_sub_image(Context& c, GLenum, GLint level, GLint xoffset, GLint yoffset, GLint x,
                        GLint y, GLsizei width, GLsizei height) {
  TextureObject& texture = *c.active_unit().texture;
  const size_t index = static_cast<size_t>(level);
  copy_from_surface(c, writable_image(texture).levels[index], texture.level[index].format, xoffset,
                    yoffset, x, y, width, height);
  after_change(c, texture, level);
}

void compressed_tex_image(Context& c, GLenum, GLint level, GLenum internal, GLsizei width,
                          GLsizei height, GLint, GLsizei, const void* data) {
  TextureObject& texture = *c.active_unit().texture;
  const Palette palette = palette_of(internal);
  const size_t bytes = pixel_bytes(palette.format, palette.type);
  const auto* colours = static_cast<const uint8_t*>(data);
  const uint8_t* indices = colours + (bytes << palette.index_bits);
  for (int i = 0; i <= -level; ++i) {
    pipeline::ImageLevel& to = define_level(c, texture, static_cast<size_t>(i), palette.format,
                                            palette.type, width == 0 ? 0 : std::max(width >> i, 1),
                                            height == 0 ? 0 : std::max(height >> i, 1));
    for (size_t k = 0; k < to.texels.size(); ++k) {
      // Two 4-bit indices in a byte: the first is in the upper half.
      const uint32_t index = palette.index_bits == 8 ? indices[k]
                             : k % 2 == 0            ? indices[k / 2] >> 4u
                                                     : indices[k / 2] & 15u;
      to.texels[k] = unpack_pixel(colours + bytes * index, palette.format, palette.type);
    }
    indices += (to.texels.size() * static_cast<size_t>(palette.index_bits) + 7) / 8;
  }
}

void compressed_tex_sub_image(Context&, GLenum, GLint, GLint, GLint, GLsizei, GLsizei, GLenum,
                              GLsizei, const void*) {}

}  // namespace clearpipe::api::exec
