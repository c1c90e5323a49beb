// Texture images: what an application uploads or copies becomes RGBA8 texels (3.7.1 to 3.7.4), and
// mipmaps are made by a 2x2 box filter (3.7.7).
//
// New levels are made whole before the texture gets them, so that a call for which memory does not
// suffice changes nothing.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "api/egl_image.h"
#include "api/exec.h"
#include "api/framebuffer.h"
#include "api/pixel_format.h"

namespace clearpipe::api::exec {

namespace {

using Levels = std::vector<pipeline::ImageLevel>;

// A level with texels of zero.
pipeline::ImageLevel make_level(int width, int height) {
  return {width, height,
          pipeline::Texels(static_cast<size_t>(width) * static_cast<size_t>(height))};
}

// Gives the texture new levels from `first` on. Nothing changes when memory does not suffice.
void set_levels(TextureObject& texture, size_t first, Levels levels, GLenum internal,
                GLenum format) {
  const size_t end = first + levels.size();
  const bool pending = is_pending(texture);
  const auto image = pending ? copy_image(texture, first, end) : texture.image;
  if (image->levels.size() < end) image->levels.resize(end);
  texture.image = image;
  if (pending) texture.uses.clear();
  for (size_t i = 0; i < levels.size(); ++i) {
    TextureLevel& level = texture.level[first + i];
    level = {levels[i].width, levels[i].height, internal, format, level.sibling};
    image->levels[first + i].width = levels[i].width;
    image->levels[first + i].height = levels[i].height;
    replace_texels(texture, first + i, std::move(levels[i].texels));
  }
  ++texture.version;
}

// As above, as images that an application specifies: the texture shares nothing any more.
void install_levels(Context& c, TextureObject& texture, size_t first, Levels levels,
                    GLenum internal, GLenum format) {
  finish_drawing_to(c, texture);
  orphan(texture);
  set_levels(texture, first, std::move(levels), internal, format);
}

// As above, as images that are generated: a mipmap that was complete keeps its structure, and so
// what it shares (issues 4 and 5 of EGL_KHR_gl_image).
void regenerate_levels(TextureObject& texture, size_t first, Levels levels) {
  if (!has_mipmap(texture)) orphan(texture);
  const TextureLevel base = texture.level[0];
  set_levels(texture, first, std::move(levels), base.internal, base.format);
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

// Where a texel of a level half as large lies along one axis: between two texels, the second with
// a weight of 0 to 256. From an even size it is the box of two; from an odd one, the centre's
// place.
struct Halfway {
  int first, second;
  uint32_t weight;
};
Halfway halfway(int to, int to_size, int from_size) {
  // Twice to_size times the distance of the centre from that of the first texel.
  const int64_t place = (2 * int64_t{to} + 1) * from_size - to_size;
  const int64_t unit = 2 * int64_t{to_size};
  const int first = static_cast<int>(place / unit);
  return {first, std::min(first + 1, from_size - 1),
          static_cast<uint32_t>((place % unit * 256 + to_size) / unit)};
}

uint32_t mix(const uint32_t (&texel)[4], uint32_t s, uint32_t t) {
  uint32_t result = 0;
  for (uint32_t shift = 0; shift < 32; shift += 8) {
    auto c = [&texel, shift](int i) { return texel[i] >> shift & 255; };
    const uint32_t lower = c(0) * (256 - s) + c(1) * s, upper = c(2) * (256 - s) + c(3) * s;
    result |= (lower * (256 - t) + upper * t + 32768) >> 16 << shift;
  }
  return result;
}

pipeline::ImageLevel reduced(const pipeline::ImageLevel& from) {
  pipeline::ImageLevel to = make_level(std::max(1, from.width / 2), std::max(1, from.height / 2));
  size_t next = 0;
  for (int y = 0; y < to.height; ++y) {
    const Halfway t = halfway(y, to.height, from.height);
    const uint32_t* lower = from.texels.data() + static_cast<ptrdiff_t>(t.first) * from.width;
    const uint32_t* upper = from.texels.data() + static_cast<ptrdiff_t>(t.second) * from.width;
    for (int x = 0; x < to.width; ++x) {
      const Halfway s = halfway(x, to.width, from.width);
      const uint32_t texel[4] = {lower[s.first], lower[s.second], upper[s.first], upper[s.second]};
      to.texels[next++] = mix(texel, s.weight, t.weight);
    }
  }
  return to;
}

// Appends the levels from that of the last one down to 1x1 (3.7.7, automatic mipmap generation).
void add_mipmaps(Levels& levels) {
  if (levels[0].width == 0 || levels[0].height == 0) return;
  while (levels.back().width > 1 || levels.back().height > 1) {
    levels.push_back(reduced(levels.back()));
  }
}

bool generates(const TextureObject& texture, GLint level) {
  return level == 0 && texture.generate_mipmap;
}

// Replaces one level, and those that follow from it.
void replace_level(Context& c, TextureObject& texture, GLint level, pipeline::ImageLevel to,
                   GLenum internal) {
  Levels levels;
  levels.push_back(std::move(to));
  if (generates(texture, level)) add_mipmaps(levels);
  install_levels(c, texture, static_cast<size_t>(level), std::move(levels), internal,
                 base_format(internal));
}

// Changes texels of one level, and the levels that follow from it.
template <typename Change>
void change_level(Context& c, TextureObject& texture, GLint level, const Change& change) {
  const size_t index = static_cast<size_t>(level);
  refresh(texture);
  finish_drawing_to(c, texture);
  if (generates(texture, level)) {
    Levels levels;
    levels.push_back(texture.image->levels[index]);
    change(levels[0]);
    add_mipmaps(levels);
    regenerate_levels(texture, 0, std::move(levels));
    return;
  }
  size_t bytes = 0;
  for (const pipeline::ImageLevel& l : texture.image->levels) bytes += 4 * l.texels.size();
  if (!may_write_in_place(c, texture, bytes)) {
    pipeline::Texels copy = texture.image->levels[index].texels;
    texture.image = copy_image(texture, index, index + 1);
    replace_texels(texture, index, std::move(copy));
    texture.uses.clear();
    ++texture.version;
  }
  change(texture.image->levels[index]);
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

void copy_from_surface(const Context& c, pipeline::ImageLevel& to, GLenum format, int xoffset,
                       int yoffset, int x, int y, int width, int height) {
  pipeline::store_uniform_tiles(*c.read.colour);
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

void tex_image(Context& c, GLenum, GLint level, GLint internal, GLsizei width, GLsizei height,
               GLint, GLenum format, GLenum type, const void* pixels) {
  pipeline::ImageLevel to = make_level(width, height);
  if (pixels) {
    unpack(to, 0, 0, width, height, format, type, pixels, c.state.misc.unpack_alignment);
  } else if (const uint32_t nothing = reduce(0, base_format(static_cast<GLenum>(internal)))) {
    std::fill(to.texels.begin(), to.texels.end(), nothing);
  }
  replace_level(c, *c.active_unit().texture, level, std::move(to), static_cast<GLenum>(internal));
}

void tex_sub_image(Context& c, GLenum, GLint level, GLint x, GLint y, GLsizei width, GLsizei height,
                   GLenum format, GLenum type, const void* pixels) {
  if (!pixels || width == 0 || height == 0) return;
  change_level(c, *c.active_unit().texture, level, [&](pipeline::ImageLevel& to) {
    unpack(to, x, y, width, height, format, type, pixels, c.state.misc.unpack_alignment);
  });
}

void copy_tex_image(Context& c, GLenum, GLint level, GLenum internal, GLint x, GLint y,
                    GLsizei width, GLsizei height, GLint) {
  c.finish_frame();
  update_targets(c);
  pipeline::ImageLevel to = make_level(width, height);
  std::fill(to.texels.begin(), to.texels.end(), reduce(0, base_format(internal)));
  copy_from_surface(c, to, base_format(internal), 0, 0, x, y, width, height);
  replace_level(c, *c.active_unit().texture, level, std::move(to), internal);
}

void copy_tex_sub_image(Context& c, GLenum, GLint level, GLint xoffset, GLint yoffset, GLint x,
                        GLint y, GLsizei width, GLsizei height) {
  if (width == 0 || height == 0) return;
  c.finish_frame();
  update_targets(c);
  TextureObject& texture = *c.active_unit().texture;
  const GLenum format = texture.level[static_cast<size_t>(level)].format;
  change_level(c, texture, level, [&](pipeline::ImageLevel& to) {
    copy_from_surface(c, to, format, xoffset, yoffset, x, y, width, height);
  });
}

// 3.8.8 of EXT_framebuffer_object: the levels above the base, as automatic generation makes them.
void generate_mipmap(Context& c, GLenum) {
  TextureObject& texture = *c.active_unit().texture;
  const TextureLevel base = texture.level[0];
  if (base.width == 0 || base.height == 0) return;
  refresh(texture);
  finish_drawing_to(c, texture);
  Levels levels;
  levels.push_back(texture.image->levels[0]);
  add_mipmaps(levels);
  levels.erase(levels.begin());
  if (!levels.empty()) regenerate_levels(texture, 1, std::move(levels));
}

// Mipmaps are not generated from compressed images (3.7.7).
void compressed_tex_image(Context& c, GLenum, GLint level, GLenum internal, GLsizei width,
                          GLsizei height, GLint, GLsizei, const void* data) {
  const Palette palette = palette_of(internal);
  const size_t bytes = pixel_bytes(palette.format, palette.type);
  const auto* colours = static_cast<const uint8_t*>(data);
  const uint8_t* indices = colours + (bytes << palette.index_bits);
  Levels levels;
  for (int i = 0; i <= -level; ++i) {
    pipeline::ImageLevel to = make_level(width == 0 ? 0 : std::max(width >> i, 1),
                                         height == 0 ? 0 : std::max(height >> i, 1));
    for (size_t k = 0; k < to.texels.size(); ++k) {
      // Two 4-bit indices in a byte: the first is in the upper half.
      const uint32_t index = palette.index_bits == 8 ? indices[k]
                             : k % 2 == 0            ? indices[k / 2] >> 4u
                                                     : indices[k / 2] & 15u;
      to.texels[k] = unpack_pixel(colours + bytes * index, palette.format, palette.type);
    }
    indices += (to.texels.size() * static_cast<size_t>(palette.index_bits) + 7) / 8;
    levels.push_back(std::move(to));
  }
  install_levels(c, *c.active_unit().texture, 0, std::move(levels), internal, palette.format);
}

void compressed_tex_sub_image(Context&, GLenum, GLint, GLint, GLint, GLsizei, GLsizei, GLenum,
                              GLsizei, const void*) {}

}  // namespace clearpipe::api::exec
