// See lock_surface.h.
// SPDX-License-Identifier: MIT
#include "icd/lock_surface.h"

#include <new>

#include "icd/display.h"

namespace clearpipe::icd {

namespace {

using pipeline::ColourFormat;

// A format that the extension has no name for.
constexpr EGLint kOtherFormat = 1;

}  // namespace

EGLint mapped_format(const Config& config) {
  if (!is_lockable(config)) return EGL_NONE;
  if (config.format == ColourFormat::kRgb565) return EGL_FORMAT_RGB_565_EXACT_KHR;
  return config.red == 8 && config.alpha == 8 ? EGL_FORMAT_RGBA_8888_EXACT_KHR : kOtherFormat;
}

bool matches_format(const Config& config, EGLint format) {
  const EGLint own = mapped_format(config);
  if (format == EGL_FORMAT_RGB_565_KHR) return own == EGL_FORMAT_RGB_565_EXACT_KHR;
  if (format == EGL_FORMAT_RGBA_8888_KHR) return own == EGL_FORMAT_RGBA_8888_EXACT_KHR;
  return own == format;
}

PixelLayout mapped_layout(const Config& config) {
  switch (config.format) {
    case ColourFormat::kRgb565:
      return kRgb565;
    case ColourFormat::kRgb5A1:
      return {2, {{{11, 5}, {6, 5}, {1, 5}, {0, 1}}}};
    case ColourFormat::kRgba4:
      return {2, {{{12, 4}, {8, 4}, {4, 4}, {0, 4}}}};
    case ColourFormat::kRgba8:
    case ColourFormat::kRgb8:
      break;
  }
  return config.alpha > 0 ? kBgra : kBgrx;
}

size_t mapped_pitch(const Config& config, EGLint width) {
  const auto bytes = static_cast<size_t>(mapped_layout(config).bytes);
  return (static_cast<size_t>(width) * bytes + 3) / 4 * 4;
}

bool map_surface(Surface& surface) try {
  SurfaceLock& lock = *surface.lock;
  if (lock.is_mapped) return true;
  const size_t pitch = mapped_pitch(*surface.config, surface.width);
  lock.memory.resize(pitch * static_cast<size_t>(surface.height));
  const bool preserves = lock.preserves_pixels || (surface.kind == Surface::Kind::kWindow &&
                                                   surface.swap_behavior == EGL_BUFFER_PRESERVED);
  const PixelLayout layout = mapped_layout(*surface.config);
  std::vector<uint32_t> row(static_cast<size_t>(surface.width));
  for (EGLint y = 0; preserves && y < surface.height; ++y) {
    pipeline::read_pixels(*surface.target.colour, 0, surface.height - 1 - y, surface.width,
                          row.data());
    to_layout(layout, row.data(), row.size(), lock.memory.data() + pitch * static_cast<size_t>(y));
  }
  lock.is_mapped = true;
  return true;
} catch (const std::bad_alloc&) {
  surface.lock->memory = {};
  return false;
}

bool unlock_surface(Surface& surface) try {
  const auto lock = std::move(surface.lock);
  if (!lock->is_mapped) return true;
  const size_t pitch = mapped_pitch(*surface.config, surface.width);
  const PixelLayout layout = mapped_layout(*surface.config);
  std::vector<uint32_t> row(static_cast<size_t>(surface.width));
  for (EGLint y = 0; y < surface.height; ++y) {
    from_layout(layout, lock->memory.data() + pitch * static_cast<size_t>(y), row.size(),
                row.data());
    pipeline::write_pixels(*surface.target.colour, 0, surface.height - 1 - y, surface.width,
                           row.data());
  }
  return true;
} catch (const std::bad_alloc&) {
  return false;
}

}  // namespace clearpipe::icd
