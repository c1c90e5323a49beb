// Surfaces as textures (eglBindTexImage, 3.6 of EGL 1.5): see context.h.
//
// What is drawn to a surface while it is bound is indeterminate, and so is what it holds when it is
// released. So the texture gets a copy, and the surface is as independent of it as it can be.
// SPDX-License-Identifier: MIT
#include "api/surface_texture.h"

#include "api/texture_levels.h"

namespace clearpipe::api {

namespace {

pipeline::ImageLevel level_of(const pipeline::ColourBuffer& from, bool alpha) {
  pipeline::ImageLevel level = make_level(from.width, from.height);
  for (int y = 0; y < from.height; ++y) {
    pipeline::read_pixels(from, 0, y, from.width,
                          level.texels.data() + static_cast<ptrdiff_t>(y) * from.width);
  }
  if (!alpha) {
    for (uint32_t& texel : level.texels) texel |= 0xff000000u;
  }
  return level;
}

void remove_images(TextureObject& texture) {
  texture.image = std::make_shared<pipeline::Image>();
  texture.uses.clear();
  texture.level.fill({});
  ++texture.version;
}

}  // namespace

bool takes_surface_texture(Context* context) noexcept {
  const std::lock_guard<std::mutex> lock(context->share->mutex);
  return context->active_unit().texture->storage_levels == 0;
}

std::weak_ptr<SurfaceTexture> bind_surface_texture(
    Context* context, const std::vector<std::shared_ptr<pipeline::ColourBuffer>>& levels,
    bool alpha, bool mipmap) noexcept try {
  const std::lock_guard<std::mutex> lock(context->share->mutex);
  const TexturePtr& texture = context->active_unit().texture;
  auto binding = std::make_shared<SurfaceTexture>();
  binding->share = context->share;
  binding->texture = texture;
  Levels images;
  for (const auto& from : levels) images.push_back(level_of(*from, alpha));
  if (mipmap && texture->generate_mipmap && !images.empty()) {
    images.resize(1);
    add_mipmaps(images, last_generated_level(*texture, images[0]));
  }
  const GLenum format = alpha ? GL_RGBA : GL_RGB;
  finish_drawing_to(*context, *texture);
  orphan(*texture);
  remove_images(*texture);
  install_levels(*context, *texture, 0, images, format, format);
  texture->surface = binding;
  return binding;
} catch (...) {
  return {};
}

void release_surface_texture(std::weak_ptr<SurfaceTexture> binding) noexcept try {
  const std::shared_ptr<SurfaceTexture> bound = binding.lock();
  if (!bound) return;
  const auto share = bound->share.lock();
  if (!share) return;
  const std::lock_guard<std::mutex> lock(share->mutex);
  const TexturePtr texture = bound->texture.lock();
  if (texture && texture->surface == bound) forget_surface(*texture);
} catch (...) {
  // The texture keeps its images: no memory for an empty one.
}

void forget_surface(TextureObject& texture) {
  if (!texture.surface) return;
  remove_images(texture);
  texture.surface = nullptr;
}

}  // namespace clearpipe::api
