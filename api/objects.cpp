// Textures as wholes: completeness (3.7.9); and when data may be written in place.
// SPDX-License-Identifier: MIT
#include "api/objects.h"

#include <algorithm>

#include "api/context_state.h"

namespace clearpipe::api {

namespace {
// A copy of so many bytes costs less than cutting a frame in two.
constexpr size_t kCopyLimit = 256 * 1024;

bool fits(const TextureLevel& level, int width, int height, GLenum internal) {
  return level.width == width && level.height == height && level.internal == internal;
}

// Where the levels of each face of a cube map begin.
constexpr std::array<size_t, pipeline::kCubeFaces> kFaces = [] {
  std::array<size_t, pipeline::kCubeFaces> first{};
  for (size_t i = 0; i < first.size(); ++i) first[i] = i * kTextureLevels;
  return first;
}();
}  // namespace

bool is_mipmap_filter(GLenum min_filter) {
  return min_filter != GL_NEAREST && min_filter != GL_LINEAR;
}

bool is_cube_complete(const TextureObject& texture) {
  const TextureLevel& base = texture.level[0];
  if (base.width == 0 || base.width != base.height) return false;
  return std::all_of(kFaces.begin(), kFaces.end(), [&](size_t face) {
    return fits(texture.level[face], base.width, base.height, base.internal);
  });
}

// OES_required_internalformat would have the format and type of all levels agree too; as with the
// core and with Mesa, levels given in different types are complete here.
bool has_mipmap(const TextureObject& texture) {
  const TextureLevel& base = texture.level[0];
  const bool cube = texture.target == GL_TEXTURE_CUBE_MAP_OES;
  if (base.width == 0 || base.height == 0 || (cube && !is_cube_complete(texture))) return false;
  const size_t last = static_cast<size_t>(last_mipmap_level(texture));
  const auto has_levels = [&](size_t face) {
    int width = base.width, height = base.height;
    for (size_t i = 1; i <= last; ++i) {
      width = std::max(1, width / 2);
      height = std::max(1, height / 2);
      if (!fits(texture.level[face + i], width, height, base.internal)) return false;
    }
    return true;
  };
  return cube ? std::all_of(kFaces.begin(), kFaces.end(), has_levels) : has_levels(0);
}

// An external texture has other parameters at first (OES_EGL_image_external).
void TextureObject::set_target(GLenum t) {
  if (target == t) return;
  target = t;
  if (target != GL_TEXTURE_EXTERNAL_OES) return;
  min_filter = GL_LINEAR;
  wrap_s = wrap_t = GL_CLAMP_TO_EDGE;
}

bool is_complete(const TextureObject& texture) {
  if (texture.target == GL_TEXTURE_EXTERNAL_OES) return true;  // black without an EGLImage
  if (is_mipmap_filter(texture.min_filter)) return has_mipmap(texture);
  if (texture.target == GL_TEXTURE_CUBE_MAP_OES) return is_cube_complete(texture);
  return texture.level[0].width > 0 && texture.level[0].height > 0;
}

int last_mipmap_level(const TextureObject& texture) {
  return last_mipmap_level(texture, std::max(texture.level[0].width, texture.level[0].height));
}

// q = min(p, level_max) (APPLE_texture_max_level), where level p is 1x1, or the last that an
// immutable texture has.
int last_mipmap_level(const TextureObject& texture, int size) {
  const int p = texture.storage_levels > 0 ? texture.storage_levels - 1 : longest_mipmap(size) - 1;
  return std::min(p, texture.max_level);
}

bool may_write_in_place(Context& context, const FrameUses& uses, size_t bytes) {
  if (!uses.pending()) return true;
  if (bytes <= kCopyLimit || uses.pending_elsewhere(context.clock)) {
    context.note_slow(Slow::kCopies);
    return false;
  }
  context.finish_frame(Slow::kFinishes);
  return true;
}

}  // namespace clearpipe::api
