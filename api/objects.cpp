// Textures as wholes: completeness (3.7.9); and when data may be written in place.
// SPDX-License-Identifier: MIT
#include "api/objects.h"

#include <algorithm>

#include "api/context_state.h"

namespace clearpipe::api {

namespace {
// A copy of so many bytes costs less than cutting a frame in two.
constexpr size_t kCopyLimit = 256 * 1024;
}  // namespace

bool is_mipmap_filter(GLenum min_filter) {
  return min_filter != GL_NEAREST && min_filter != GL_LINEAR;
}

// OES_required_internalformat would have the format and type of all levels agree too; as with the
// core and with Mesa, levels given in different types are complete here.
bool has_mipmap(const TextureObject& texture) {
  const TextureLevel& base = texture.level[0];
  if (base.width == 0 || base.height == 0) return false;
  int width = base.width, height = base.height;
  for (size_t i = 1, last = static_cast<size_t>(last_mipmap_level(texture)); i <= last; ++i) {
    width = std::max(1, width / 2);
    height = std::max(1, height / 2);
    const TextureLevel& level = texture.level[i];
    if (level.width != width || level.height != height || level.internal != base.internal) {
      return false;
    }
  }
  return true;
}

bool is_complete(const TextureObject& texture) {
  return is_mipmap_filter(texture.min_filter)
             ? has_mipmap(texture)
             : texture.level[0].width > 0 && texture.level[0].height > 0;
}

// q = min(p, level_max), where level p is 1x1 (APPLE_texture_max_level).
int last_mipmap_level(const TextureObject& texture) {
  int p = 0;
  for (int size = std::max(texture.level[0].width, texture.level[0].height); size > 1; size /= 2) {
    ++p;
  }
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
