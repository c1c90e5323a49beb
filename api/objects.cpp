// Textures as wholes: completeness (3.7.10) and copy on write.
// SPDX-License-Identifier: MIT
#include "api/objects.h"

#include <algorithm>

namespace clearpipe::api {

bool is_mipmap_filter(GLenum min_filter) {
  return min_filter != GL_NEAREST && min_filter != GL_LINEAR;
}

bool is_complete(const TextureObject& texture) {
  const TextureLevel& base = texture.level[0];
  if (base.width == 0 || base.height == 0) return false;
  if (!is_mipmap_filter(texture.min_filter)) return true;
  int width = base.width, height = base.height;
  for (size_t i = 1; width > 1 || height > 1; ++i) {
    width = std::max(1, width / 2);
    height = std::max(1, height / 2);
    if (i >= texture.level.size()) return false;
    const TextureLevel& level = texture.level[i];
    if (level.width != width || level.height != height || level.format != base.format ||
        level.type != base.type) {
      return false;
    }
  }
  return true;
}

pipeline::Image& writable_image(TextureObject& texture) {
  if (texture.image.use_count() > 1) {
    texture.image = std::make_shared<pipeline::Image>(*texture.image);
  }
  return *texture.image;
}

}  // namespace clearpipe::api
