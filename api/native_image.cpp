// See native_image.h.
// SPDX-License-Identifier: MIT
#include "api/native_image.h"

#include <algorithm>

namespace clearpipe::api {

namespace {

struct NativeImageList {
  std::mutex mutex;  // taken before those of images
  std::vector<std::weak_ptr<EglImage>> images;
};
NativeImageList& list() {
  static auto* const images = new NativeImageList;
  return *images;
}

}  // namespace

void load_native_image(EglImage& image) {
  if (!image.native) return;
  const std::lock_guard<std::mutex> lock(image.mutex);
  std::vector<uint32_t> pixels(image.known.size());
  if (!image.native->load(pixels.data()) || pixels == image.known) return;
  auto memory = std::make_shared_for_overwrite<uint32_t[]>(pixels.size());
  std::copy(pixels.begin(), pixels.end(), memory.get());
  image.memory = std::move(memory);
  image.uses.clear();
  image.known = std::move(pixels);
}

void note_native_image(Context& c, const EglImagePtr& image) {
  if (!image || !image->native) return;
  if (std::find(c.native_images.begin(), c.native_images.end(), image) == c.native_images.end()) {
    c.native_images.push_back(image);
  }
}

void store_native_images(Context& c) noexcept {
  for (const EglImagePtr& image : c.native_images) {
    const std::lock_guard<std::mutex> lock(image->mutex);
    const uint32_t* pixels = image->memory.get();
    if (std::equal(image->known.begin(), image->known.end(), pixels)) continue;
    std::copy_n(pixels, image->known.size(), image->known.begin());
    image->native->store(image->known.data());
  }
  c.native_images.clear();
}

EglImagePtr make_native_image(std::shared_ptr<NativeImage> native) {
  auto image = std::make_shared<EglImage>();
  image->width = native->width;
  image->height = native->height;
  image->internal = image->format = native->has_alpha ? GL_RGBA : GL_RGB;
  image->renderbuffer_internal = native->has_alpha ? GL_RGBA8_OES : GL_RGB8_OES;
  image->known.resize(static_cast<size_t>(image->width) * static_cast<size_t>(image->height));
  image->memory = std::make_shared<uint32_t[]>(image->known.size());
  image->native = std::move(native);
  load_native_image(*image);
  NativeImageList& all = list();
  const std::lock_guard<std::mutex> lock(all.mutex);
  std::erase_if(all.images, [](const auto& old) { return old.expired(); });
  all.images.push_back(image);
  return image;
}

void load_native_images() noexcept try {
  NativeImageList& all = list();
  const std::lock_guard<std::mutex> lock(all.mutex);
  for (const auto& weak : all.images) {
    if (const EglImagePtr image = weak.lock()) load_native_image(*image);
  }
} catch (...) {
  // No memory: siblings keep what they have.
}

}  // namespace clearpipe::api
