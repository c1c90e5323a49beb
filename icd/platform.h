// What EGL needs of a platform: configs, and surfaces that belong to a window system. Platforms
// without one, surfaceless and device, have configs alone.
// SPDX-License-Identifier: MIT
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "icd/config.h"
#include "pipeline/surface.h"

namespace clearpipe::icd {

struct Size {
  EGLint width = 0, height = 0;
  bool operator==(const Size&) const = default;
};

// A part of a surface, in pixels from the lower left corner.
struct Rect {
  EGLint x = 0, y = 0, width = 0, height = 0;
};

class Platform;

// A window or a pixmap. The thread to which the surface is current uses it without egl_mutex(), as
// it may have to wait for the window system; another one may close it meanwhile, with the display
// or the surface. What is closed never speaks to the window system again.
class NativeSurface {
 public:
  // `id`: what tells it from others of its display.
  NativeSurface(std::shared_ptr<Platform> platform, uintptr_t id)
      : id(id), platform_(std::move(platform)) {}
  virtual ~NativeSurface() = default;
  NativeSurface(const NativeSurface&) = delete;
  NativeSurface& operator=(const NativeSurface&) = delete;

  const uintptr_t id;

  // Its size now; none if it is gone.
  std::optional<Size> size();

  // Shows parts of the buffer, which has the size last asked for or another one, after waiting for
  // the frame of the `interval` (3.10.3). The EGL error, or EGL_SUCCESS.
  EGLint post(const pipeline::ColourBuffer& buffer, std::span<const Rect> parts, EGLint interval);

  // What a pixmap holds becomes the contents of the buffer, which has its size.
  EGLint fetch(pipeline::ColourBuffer& buffer);

  // Whether its pixels have alpha.
  virtual bool has_alpha() const { return false; }

  // Before the last reference goes, and with the display: lets go of all native resources.
  void close();

 protected:
  virtual std::optional<Size> get_size() = 0;
  virtual EGLint put(const pipeline::ColourBuffer& buffer, std::span<const Rect> parts,
                     EGLint interval) = 0;
  virtual EGLint get(pipeline::ColourBuffer&) { return EGL_BAD_NATIVE_PIXMAP; }
  virtual void release() = 0;

  // Keeps the calls above out, for a call of the window system's.
  std::unique_lock<std::mutex> lock() { return std::unique_lock<std::mutex>(mutex_); }

  // Whether what waits should give up: someone wants to close.
  bool is_closing() const { return closing_; }
  Platform& platform() const { return *platform_; }

 private:
  std::mutex mutex_;
  std::atomic<bool> closing_{false};
  std::shared_ptr<Platform> platform_;  // null: closed
};

class Platform : public std::enable_shared_from_this<Platform> {
 public:
  Platform() = default;
  virtual ~Platform() = default;
  Platform(const Platform&) = delete;
  Platform& operator=(const Platform&) = delete;

  // In an order that decides between configs that are otherwise equal (3.4.1.2).
  virtual std::vector<Config> configs() { return offscreen_configs(); }

  // A window or pixmap as the native type of eglCreateWindowSurface has it, or as the platform's
  // extension has it for eglCreatePlatformWindowSurface: `by_pointer`. The EGL error, or
  // EGL_SUCCESS.
  virtual EGLint make_window(const Config&, void*, bool /*by_pointer*/,
                             std::shared_ptr<NativeSurface>&) {
    return EGL_BAD_NATIVE_WINDOW;
  }
  // A pixmap by the native type's number, as EGL_MATCH_NATIVE_PIXMAP has it.
  virtual bool has_pixmap(uintptr_t) { return false; }
  virtual EGLint make_pixmap(const Config&, void*, bool /*by_pointer*/,
                             std::shared_ptr<NativeSurface>&) {
    return EGL_BAD_NATIVE_PIXMAP;
  }
};

}  // namespace clearpipe::icd
