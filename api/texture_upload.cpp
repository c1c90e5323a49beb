// Texture images: what an application uploads or copies becomes RGBA8 texels (3.7.1, 3.7.2).
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "api/exec.h"
#include "api/framebuffer.h"
#include "api/pixel_format.h"
#include "api/texture_levels.h"
#include "api/texture_target.h"

namespace clearpipe::api::exec {

namespace {

void unpack(pipeline::ImageLevel& to, int x, int y, int width, int height, GLenum format,
            GLenum type, const void* pixels, int alignment) {
  const pipeline::UnpackLayout layout = unpack_layout(format, type);
  const size_t bytes = pipeline::bytes_of(layout), align = static_cast<size_t>(alignment);
  const size_t row = (bytes * static_cast<size_t>(width) + align - 1) / align * align;
  uint32_t* texel = to.texels.data() + static_cast<ptrdiff_t>(y) * to.width + x;
  pipeline::unpack_rectangle(layout,
                             {pixels, row, width, height, texel, static_cast<size_t>(to.width)});
}

void copy_from_surface(const Context& c, pipeline::ImageLevel& to, GLenum format, int xoffset,
                       int yoffset, int x, int y, int width, int height) {
  // Pixels outside of the surface are undefined: they leave the texel as it is.
  const pipeline::ColourBuffer& from = *c.read.colour;
  const int64_t x0 = std::max<int64_t>(x, 0);
  const int64_t x1 = std::min<int64_t>(static_cast<int64_t>(x) + width, from.width);
  const int64_t y0 = std::max<int64_t>(y, 0);
  const int64_t y1 = std::min<int64_t>(static_cast<int64_t>(y) + height, from.height);
  if (x0 >= x1 || y0 >= y1) return;
  uint32_t* out = to.texels.data() + (yoffset + y0 - y) * to.width + xoffset + (x0 - x);
  const int count = static_cast<int>(x1 - x0), rows = static_cast<int>(y1 - y0);
  pipeline::read_rectangle(from, static_cast<int>(x0), static_cast<int>(y0), count, rows, out,
                           static_cast<size_t>(to.width) * sizeof(uint32_t));
  if (format == GL_RGBA) return;
  for (int row = 0; row < rows; ++row, out += to.width) {
    std::transform(out, out + count, out,
                   [format](uint32_t p) { return components_of(p, format); });
  }
}

}  // namespace

void tex_image(Context& c, GLenum target, GLint level, GLint internal, GLsizei width,
               GLsizei height, GLint, GLenum format, GLenum type, const void* pixels) {
  const GLenum held = static_cast<GLenum>(internal);
  pipeline::ImageLevel to;
  if (!pixels) {
    to = make_level(width, height, base_format(held));
  } else {
    const size_t texels = static_cast<size_t>(width) * static_cast<size_t>(height);
    to = {width, height, pipeline::Texels::for_overwrite(texels)};
    unpack(to, 0, 0, width, height, format, type, pixels, c.state.misc.unpack_alignment);
  }
  replace_level(c, *bound_texture(c, target), image_index(target, level), std::move(to), held,
                base_format(held));
}

void tex_sub_image(Context& c, GLenum target, GLint level, GLint x, GLint y, GLsizei width,
                   GLsizei height, GLenum format, GLenum type, const void* pixels) {
  if (!pixels || width == 0 || height == 0) return;
  const auto change = [&](pipeline::ImageLevel& to) {
    unpack(to, x, y, width, height, format, type, pixels, c.state.misc.unpack_alignment);
  };
  change_level(c, *bound_texture(c, target), image_index(target, level), change);
}

void copy_tex_image(Context& c, GLenum target, GLint level, GLenum internal, GLint x, GLint y,
                    GLsizei width, GLsizei height, GLint) {
  c.finish_frame(Slow::kWaits);
  update_targets(c);
  pipeline::ImageLevel to = make_level(width, height, base_format(internal));
  copy_from_surface(c, to, base_format(internal), 0, 0, x, y, width, height);
  replace_level(c, *bound_texture(c, target), image_index(target, level), std::move(to), internal,
                base_format(internal));
}

void copy_tex_sub_image(Context& c, GLenum target, GLint level, GLint xoffset, GLint yoffset,
                        GLint x, GLint y, GLsizei width, GLsizei height) {
  if (width == 0 || height == 0) return;
  c.finish_frame(Slow::kWaits);
  update_targets(c);
  TextureObject& texture = *bound_texture(c, target);
  const size_t image = image_index(target, level);
  const GLenum format = texture.level[image].format;
  change_level(c, texture, image, [&](pipeline::ImageLevel& to) {
    copy_from_surface(c, to, format, xoffset, yoffset, x, y, width, height);
  });
}

// 3.8.8 of EXT_framebuffer_object: the levels above the base, as automatic generation makes them.
void generate_mipmap(Context& c, GLenum target) {
  TextureObject& texture = *bound_texture(c, target);
  const TextureLevel base = texture.level[0];
  if (base.width == 0 || base.height == 0) return;
  refresh(texture);
  finish_drawing_to(c, texture);
  const size_t count = target == GL_TEXTURE_CUBE_MAP_OES ? pipeline::kCubeFaces : 1;
  std::vector<Levels> mipmaps(count);
  for (size_t face = 0; face < count; ++face) {
    mipmaps[face].push_back(texture.image->levels[face * kTextureLevels]);
    add_mipmaps(mipmaps[face], last_generated_level(texture, mipmaps[face][0]));
    mipmaps[face].erase(mipmaps[face].begin());
  }
  if (mipmaps[0].empty()) return;
  // From the last face on, after which there is room for all: no call but the first can fail.
  for (size_t face = count; face-- > 0;) {
    regenerate_levels(texture, face * kTextureLevels + 1, mipmaps[face]);
  }
}

}  // namespace clearpipe::api::exec
