// EGL commands that create and destroy surfaces (3.5).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <new>

#include "icd/entry.h"
#include "icd/origin.h"
#include "icd/surface.h"

namespace clearpipe::icd::entry {

namespace {

// A window or a pixmap (3.5.1, 3.5.4). `by_pointer`: see platform.h.
template <class Attribute>
EGLSurface create_native(Surface::Kind kind, EGLDisplay dpy, EGLConfig config, void* native,
                         bool by_pointer, const Attribute* attrib_list) noexcept try {
  const bool is_window = kind == Surface::Kind::kWindow;
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_NO_SURFACE;
  if (!has_native_surfaces(display->origin)) {  // whatever the arguments are
    return fail(is_window ? EGL_BAD_NATIVE_WINDOW : EGL_BAD_NATIVE_PIXMAP, EGL_NO_SURFACE);
  }
  auto surface = std::make_unique<Surface>();
  surface->config = display->config(config);
  surface->kind = kind;
  if (surface->config == nullptr) return fail(EGL_BAD_CONFIG, EGL_NO_SURFACE);
  if (!is_window && display->origin.platform == EGL_PLATFORM_WAYLAND_KHR) {
    return fail(EGL_BAD_PARAMETER, EGL_NO_SURFACE);  // it has no pixmaps
  }
  const EGLint bit = is_window ? EGL_WINDOW_BIT : EGL_PIXMAP_BIT;
  if ((surface->config->native_surfaces & bit) == 0) return fail(EGL_BAD_MATCH, EGL_NO_SURFACE);
  if (const EGLint error = parse_native(attrib_list, *surface); error != EGL_SUCCESS) {
    return fail(error, EGL_NO_SURFACE);
  }
  Platform& platform = *display->platform;
  const EGLint error =
      is_window ? platform.make_window(*surface->config, native, by_pointer, surface->native)
                : platform.make_pixmap(*surface->config, native, by_pointer, surface->native);
  if (error != EGL_SUCCESS) return fail(error, EGL_NO_SURFACE);
  for (const auto& other : display->surfaces) {
    if (!other->destroyed && other->native != nullptr && other->native->id == surface->native->id) {
      return fail(EGL_BAD_ALLOC, EGL_NO_SURFACE);
    }
  }
  const std::optional<Size> size = surface->native->size();
  if (!size) return fail(is_window ? EGL_BAD_NATIVE_WINDOW : EGL_BAD_NATIVE_PIXMAP, EGL_NO_SURFACE);
  surface->width = size->width;
  surface->height = size->height;
  if (!make_buffers(*surface)) return fail(EGL_BAD_ALLOC, EGL_NO_SURFACE);
  if (!is_window) surface->native->fetch(*surface->target.colour);
  display->surfaces.push_back(std::move(surface));
  return succeed<EGLSurface>(display->surfaces.back()->handle);
} catch (const std::bad_alloc&) {
  return fail(EGL_BAD_ALLOC, EGL_NO_SURFACE);
}

}  // namespace

EGLSurface CreatePbufferSurface(EGLDisplay dpy, EGLConfig config,
                                const EGLint* attrib_list) noexcept try {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_NO_SURFACE;
  auto surface = std::make_unique<Surface>();
  surface->config = display->config(config);
  if (surface->config == nullptr) return fail(EGL_BAD_CONFIG, EGL_NO_SURFACE);
  if (const EGLint error = parse_pbuffer(attrib_list, *surface); error != EGL_SUCCESS) {
    return fail(error, EGL_NO_SURFACE);
  }
  while (!make_buffers(*surface)) {
    // EGL_LARGEST_PBUFFER: what memory suffices for, by halves (3.5.2).
    if (!surface->largest_pbuffer || (surface->width <= 1 && surface->height <= 1)) {
      return fail(EGL_BAD_ALLOC, EGL_NO_SURFACE);
    }
    surface->width = (surface->width + 1) / 2;
    surface->height = (surface->height + 1) / 2;
  }
  display->surfaces.push_back(std::move(surface));
  return succeed<EGLSurface>(display->surfaces.back()->handle);
} catch (const std::bad_alloc&) {
  return fail(EGL_BAD_ALLOC, EGL_NO_SURFACE);
}

EGLSurface CreateWindowSurface(EGLDisplay dpy, EGLConfig config, EGLNativeWindowType window,
                               const EGLint* attrib_list) noexcept {
  return create_native(Surface::Kind::kWindow, dpy, config, reinterpret_cast<void*>(window), false,
                       attrib_list);
}

EGLSurface CreatePlatformWindowSurface(EGLDisplay dpy, EGLConfig config, void* window,
                                       const EGLAttrib* attrib_list) noexcept {
  return create_native(Surface::Kind::kWindow, dpy, config, window, true, attrib_list);
}

EGLSurface CreatePlatformWindowSurfaceEXT(EGLDisplay dpy, EGLConfig config, void* window,
                                          const EGLint* attrib_list) noexcept {
  return create_native(Surface::Kind::kWindow, dpy, config, window, true, attrib_list);
}

EGLSurface CreatePixmapSurface(EGLDisplay dpy, EGLConfig config, EGLNativePixmapType pixmap,
                               const EGLint* attrib_list) noexcept {
  return create_native(Surface::Kind::kPixmap, dpy, config, reinterpret_cast<void*>(pixmap), false,
                       attrib_list);
}

EGLSurface CreatePlatformPixmapSurface(EGLDisplay dpy, EGLConfig config, void* pixmap,
                                       const EGLAttrib* attrib_list) noexcept {
  return create_native(Surface::Kind::kPixmap, dpy, config, pixmap, true, attrib_list);
}

EGLSurface CreatePlatformPixmapSurfaceEXT(EGLDisplay dpy, EGLConfig config, void* pixmap,
                                          const EGLint* attrib_list) noexcept {
  return create_native(Surface::Kind::kPixmap, dpy, config, pixmap, true, attrib_list);
}

// Client buffers are OpenVG's images (3.5.3), and there is no OpenVG here.
EGLSurface CreatePbufferFromClientBuffer(EGLDisplay dpy, EGLenum, EGLClientBuffer, EGLConfig config,
                                         const EGLint*) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  const Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_NO_SURFACE;
  if (display->config(config) == nullptr) return fail(EGL_BAD_CONFIG, EGL_NO_SURFACE);
  return fail(EGL_BAD_PARAMETER, EGL_NO_SURFACE);
}

EGLBoolean DestroySurface(EGLDisplay dpy, EGLSurface handle) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_FALSE;
  Surface* surface = display->surface(handle);
  if (surface == nullptr) return fail(EGL_BAD_SURFACE, EGL_FALSE);
  if (surface->lock) return fail(EGL_BAD_ACCESS, EGL_FALSE);
  destroy(*surface);
  display->labels.erase(handle);
  display->sweep();
  return succeed(EGL_TRUE);
}

}  // namespace clearpipe::icd::entry
