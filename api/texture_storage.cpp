// Textures whose size and format are fixed at once, for all levels (EXT_texture_storage), and
// copies of levels between them (APPLE_copy_texture_levels). SPDX-License-Identifier: MIT
#include "api/texture_storage.h"

#include <algorithm>

#include "api/compressed_format.h"
#include "api/egl_image.h"
#include "api/exec.h"
#include "api/pixel_format.h"
#include "api/texture_levels.h"
#include "api/texture_target.h"

namespace clearpipe::api {

StorageFormat storage_format(GLenum internal) {
  switch (internal) {
    case GL_RGB565_OES:
    case GL_RGBA4_OES:
    case GL_RGB5_A1_OES:
    case GL_RGB8_OES:
    case GL_RGBA8_OES:
    case GL_LUMINANCE8_ALPHA8_EXT:
    case GL_LUMINANCE8_EXT:
    case GL_ALPHA8_EXT:
      return {internal, base_format(internal)};
    case GL_BGRA8_EXT:
      return {GL_BGRA_EXT, GL_RGBA};
    default:
      break;
  }
  const CompressedFormat* compressed = compressed_format(internal);
  return compressed ? StorageFormat{internal, compressed->base} : StorageFormat();
}

int matching_level(const TextureObject& to, const TextureObject& from, int base, int count) {
  const auto same = [&](int level) {
    for (int i = 0; i < count; ++i) {
      const TextureLevel& a = to.level[static_cast<size_t>(level + i)];
      const TextureLevel& b = from.level[static_cast<size_t>(base + i)];
      if (a.width != b.width || a.height != b.height) return false;
    }
    return true;
  };
  for (int level = 0; level + count <= to.storage_levels; ++level) {
    if (same(level)) return level;
  }
  return -1;
}

namespace exec {

void tex_storage(Context& c, GLenum target, GLsizei levels, GLenum internal, GLsizei width,
                 GLsizei height) {
  TextureObject& texture = *bound_texture(c, target);
  const StorageFormat format = storage_format(internal);
  auto image = std::make_shared<pipeline::Image>();
  auto level = decltype(texture.level)();
  const size_t faces = target == GL_TEXTURE_CUBE_MAP_OES ? pipeline::kCubeFaces : 1;
  image->levels.resize((faces - 1) * kTextureLevels + static_cast<size_t>(levels));
  for (size_t face = 0; face < faces; ++face) {
    for (int i = 0; i < levels; ++i) {
      const size_t at = face * kTextureLevels + static_cast<size_t>(i);
      const int w = std::max(width >> i, 1), h = std::max(height >> i, 1);
      level[at] = {w, h, format.internal, format.base};
      image->levels[at] = make_level(w, h, format.base);
    }
  }
  finish_drawing_to(c, texture);
  orphan(texture);
  texture.surface = nullptr;
  texture.image = std::move(image);
  texture.uses.clear();
  texture.level = level;
  texture.storage_levels = levels;
  ++texture.version;
}

void copy_texture_levels(Context& c, GLuint destination, GLuint source, GLint base, GLsizei count) {
  TextureObject& to = *c.share->textures.find(destination);
  TextureObject& from = *c.share->textures.find(source);
  const int first = matching_level(to, from, base, count);
  refresh(from);
  finish_drawing_to(c, from);
  make_writable(c, to);
  const int faces = to.target == GL_TEXTURE_CUBE_MAP_OES ? pipeline::kCubeFaces : 1;
  for (int face = 0; face < faces; ++face) {
    for (int i = 0; i < count; ++i) {
      const int offset = face * kTextureLevels + i;
      const auto& texels = from.image->levels[static_cast<size_t>(offset + base)].texels;
      std::copy(texels.begin(), texels.end(),
                to.image->levels[static_cast<size_t>(offset + first)].texels.begin());
    }
  }
}

}  // namespace exec

}  // namespace clearpipe::api
