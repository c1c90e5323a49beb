// EGL commands that lock surfaces (EGL_KHR_lock_surface3, 3.5.5ls).
// SPDX-License-Identifier: MIT
#include <memory>
#include <new>

#include "icd/entry.h"
#include "icd/surface.h"

namespace clearpipe::icd::entry {

namespace {

// Table [locksurf.attr]; the EGL error, or EGL_SUCCESS.
EGLint parse_lock(const EGLint* list, SurfaceLock& out) {
  constexpr EGLint kUsage = EGL_READ_SURFACE_BIT_KHR | EGL_WRITE_SURFACE_BIT_KHR;
  for (; list != nullptr && *list != EGL_NONE; list += 2) {
    if (list[0] == EGL_MAP_PRESERVE_PIXELS_KHR) {
      if (list[1] != EGL_FALSE && list[1] != EGL_TRUE) return EGL_BAD_ATTRIBUTE;
      out.preserves_pixels = list[1] == EGL_TRUE;
    } else if (list[0] != EGL_LOCK_USAGE_HINT_KHR || (list[1] & ~kUsage) != 0) {
      return EGL_BAD_ATTRIBUTE;
    }
  }
  return EGL_SUCCESS;
}

}  // namespace

EGLBoolean LockSurfaceKHR(EGLDisplay dpy, EGLSurface handle, const EGLint* attrib_list) noexcept
    try {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_FALSE;
  Surface* surface = display->surface(handle);
  if (surface == nullptr) return fail(EGL_BAD_SURFACE, EGL_FALSE);
  if (!is_lockable(*surface->config) || surface->lock || surface->current) {
    return fail(EGL_BAD_ACCESS, EGL_FALSE);
  }
  auto made = std::make_unique<SurfaceLock>();
  if (const EGLint error = parse_lock(attrib_list, *made); error != EGL_SUCCESS) {
    return fail(error, EGL_FALSE);
  }
  // Its size is the window's, and stays while it is locked.
  if (!follow_size(*surface)) return fail(EGL_BAD_NATIVE_WINDOW, EGL_FALSE);
  if (surface->kind == Surface::Kind::kPixmap) surface->native->fetch(*surface->target.colour);
  surface->lock = std::move(made);
  return succeed(EGL_TRUE);
} catch (const std::bad_alloc&) {
  return fail(EGL_BAD_ALLOC, EGL_FALSE);
}

EGLBoolean UnlockSurfaceKHR(EGLDisplay dpy, EGLSurface handle) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_FALSE;
  Surface* surface = display->surface(handle);
  if (surface == nullptr) return fail(EGL_BAD_SURFACE, EGL_FALSE);
  if (!surface->lock) return fail(EGL_BAD_ACCESS, EGL_FALSE);
  const bool drawn = surface->lock->is_mapped;
  if (!unlock_surface(*surface)) return fail(EGL_BAD_ACCESS, EGL_FALSE);
  if (drawn) copy_to_pixmap(*surface);
  return succeed(EGL_TRUE);
}

EGLBoolean QuerySurface64KHR(EGLDisplay dpy, EGLSurface handle, EGLint attribute,
                             EGLAttribKHR* value) noexcept {
  if (attribute != EGL_BITMAP_POINTER_KHR) {
    EGLint small = 0;
    // Some attributes of some surfaces leave the value as it is.
    if (value != nullptr) small = static_cast<EGLint>(*value);
    const EGLBoolean done =
        QuerySurface(dpy, handle, attribute, value != nullptr ? &small : nullptr);
    if (done == EGL_TRUE) *value = small;
    return done;
  }
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_FALSE;
  Surface* surface = display->surface(handle);
  if (surface == nullptr) return fail(EGL_BAD_SURFACE, EGL_FALSE);
  if (value == nullptr) return fail(EGL_BAD_PARAMETER, EGL_FALSE);
  if (!surface->lock || !map_surface(*surface)) return fail(EGL_BAD_ACCESS, EGL_FALSE);
  *value = reinterpret_cast<EGLAttribKHR>(surface->lock->memory.data());
  return succeed(EGL_TRUE);
}

}  // namespace clearpipe::icd::entry
