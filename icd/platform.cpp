// Native surfaces between the threads that use and close them: see platform.h.
// SPDX-License-Identifier: MIT
#include "icd/platform.h"

#include <algorithm>

namespace clearpipe::icd {

std::optional<Size> NativeSurface::size() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (platform_ == nullptr) return std::nullopt;
  return get_size();
}

EGLint NativeSurface::post(const pipeline::ColourBuffer& buffer, std::span<const Rect> parts,
                           EGLint interval) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (platform_ == nullptr) return EGL_BAD_NATIVE_WINDOW;
  return put(buffer, parts, interval);
}

EGLint NativeSurface::fetch(pipeline::ColourBuffer& buffer) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (platform_ == nullptr) return EGL_BAD_NATIVE_PIXMAP;
  const EGLint error = get(buffer);
  // A pixmap may hold more than the surface's format has.
  if (error == EGL_SUCCESS && buffer.format != pipeline::ColourFormat::kRgba8) {
    uint32_t* const pixels = buffer.pixels.get();
    std::transform(pixels, pixels + static_cast<ptrdiff_t>(buffer.width) * buffer.height, pixels,
                   [&](uint32_t pixel) { return pipeline::truncate(buffer.format, pixel); });
  }
  return error;
}

void NativeSurface::close() {
  closing_ = true;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (platform_ == nullptr) return;
  release();
  platform_ = nullptr;
}

}  // namespace clearpipe::icd
