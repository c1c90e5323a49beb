// See texture_levels.h. Mipmaps are made by a 2x2 box filter.
// SPDX-License-Identifier: MIT
#include "api/texture_levels.h"

#include <algorithm>

#include "api/pixel_format.h"
#include "api/surface_texture.h"

namespace clearpipe::api {

namespace {

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

void set_levels(TextureObject& texture, size_t first, std::span<pipeline::ImageLevel> levels,
                GLenum internal, GLenum format) {
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

}  // namespace

pipeline::ImageLevel make_level(int width, int height, GLenum format) {
  const size_t texels = static_cast<size_t>(width) * static_cast<size_t>(height);
  return {width, height, pipeline::Texels(texels, components_of(0, format))};
}

void install_levels(Context& c, TextureObject& texture, size_t first,
                    std::span<pipeline::ImageLevel> levels, GLenum internal, GLenum format) {
  finish_drawing_to(c, texture);
  forget_surface(texture);
  orphan(texture);
  set_levels(texture, first, levels, internal, format);
}

void regenerate_levels(TextureObject& texture, size_t first,
                       std::span<pipeline::ImageLevel> levels) {
  if (!has_mipmap(texture)) orphan(texture);
  const TextureLevel base = texture.level[first / kTextureLevels * kTextureLevels];
  set_levels(texture, first, levels, base.internal, base.format);
}

int last_generated_level(const TextureObject& texture, const pipeline::ImageLevel& base) {
  if (base.width == 0 || base.height == 0) return 0;
  return last_mipmap_level(texture, std::max(base.width, base.height));
}

void add_mipmaps(Levels& levels, int last) {
  for (int i = 0; i < last; ++i) levels.push_back(reduced(levels.back()));
}

// Automatic generation is not performed from compressed images, or from sRGB-encoded ones
// (EXT_sRGB, 3.7.11).
bool generates_mipmap(const TextureObject& texture, size_t image, GLenum internal) {
  return image % kTextureLevels == 0 && texture.generate_mipmap && base_format(internal) != 0 &&
         !is_srgb(internal);
}

void replace_level(Context& c, TextureObject& texture, size_t image, pipeline::ImageLevel to,
                   GLenum internal, GLenum format) {
  if (!generates_mipmap(texture, image, internal)) {
    return install_levels(c, texture, image, {&to, 1}, internal, format);
  }
  Levels levels;
  levels.push_back(std::move(to));
  add_mipmaps(levels, last_generated_level(texture, levels[0]));
  install_levels(c, texture, image, levels, internal, format);
}

void make_writable(Context& c, TextureObject& texture) {
  refresh(texture);
  finish_drawing_to(c, texture);
  size_t bytes = 0;
  for (const pipeline::ImageLevel& l : texture.image->levels) bytes += 4 * l.texels.size();
  if (may_write_in_place(c, texture, bytes)) return;
  replace_image(texture, std::make_shared<pipeline::Image>(*texture.image));
}

}  // namespace clearpipe::api
