// Native surfaces between the threads that use and close them: see platform.h.
// SPDX-License-Identifier: MIT
#include "icd/platform.h"

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
  return get(buffer);
}

void NativeSurface::close() {
  closing_ = true;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (platform_ == nullptr) return;
  release();
  platform_ = nullptr;
}

}  // namespace clearpipe::icd
