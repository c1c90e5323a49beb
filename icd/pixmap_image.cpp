// See pixmap_image.h.
// SPDX-License-Identifier: MIT
#include "icd/pixmap_image.h"

#include <algorithm>

namespace clearpipe::icd {

namespace {

class PixmapImage final : public api::NativeImage {
 public:
  PixmapImage(std::shared_ptr<NativeSurface> pixmap, Size size)
      : NativeImage(size.width, size.height, pixmap->has_alpha()), pixmap_(std::move(pixmap)) {
    buffer_.width = width;
    buffer_.height = height;
    buffer_.has_alpha = has_alpha;
    buffer_.pixels = std::make_shared<uint32_t[]>(count());
  }
  ~PixmapImage() override { pixmap_->close(); }

  bool load(uint32_t* pixels) noexcept override {
    if (pixmap_->fetch(buffer_) != EGL_SUCCESS) return false;
    std::copy_n(buffer_.pixels.get(), count(), pixels);
    return true;
  }
  void store(const uint32_t* pixels) noexcept override {
    std::copy_n(pixels, count(), buffer_.pixels.get());
    const Rect all = {0, 0, width, height};
    pixmap_->post(buffer_, {&all, 1}, 0);
  }

 private:
  size_t count() const { return static_cast<size_t>(width) * static_cast<size_t>(height); }

  const std::shared_ptr<NativeSurface> pixmap_;
  pipeline::ColourBuffer buffer_;  // in rows
};

}  // namespace

std::shared_ptr<api::NativeImage> make_pixmap_image(std::shared_ptr<NativeSurface> pixmap,
                                                    Size size) {
  return std::make_shared<PixmapImage>(std::move(pixmap), size);
}

}  // namespace clearpipe::icd
