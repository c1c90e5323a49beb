// EGL commands that post the colour buffer (3.10), with EGL_KHR_swap_buffers_with_damage,
// EGL_EXT_swap_buffers_with_damage and EGL_KHR_partial_update.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <new>
#include <span>

#include "icd/entry.h"
#include "icd/surface.h"

namespace clearpipe::icd::entry {

namespace {

// The surface of a handle if it is the draw surface of the thread's context, or one that can be
// locked and is current nowhere (EGL_KHR_lock_surface3, 3.9.3); else null, and the error is noted.
Surface* posted_surface(EGLDisplay dpy, EGLSurface handle) {
  Display* display = initialized_display(dpy);
  Surface* const none = nullptr;
  if (display == nullptr) return none;
  Surface* surface = display->surface(handle);
  const Context* context = this_thread().context;
  if (surface == nullptr) return fail(EGL_BAD_SURFACE, none);
  if (surface->lock) return fail(EGL_BAD_ACCESS, none);
  const bool drawn_to = context != nullptr && context->draw == surface;
  const bool without_context = is_lockable(*surface->config) && !surface->current;
  return drawn_to || without_context ? surface : fail(EGL_BAD_SURFACE, none);
}

// The parts as they lie in the surface; all of it where there are none.
std::vector<Rect> parts_of(const Surface& surface, std::span<const EGLint> rects) {
  const Rect all = {0, 0, surface.width, surface.height};
  if (rects.empty() || !surface.was_posted) return {all};
  std::vector<Rect> parts;
  for (size_t i = 0; i < rects.size(); i += 4) {
    const int64_t left = std::clamp<int64_t>(rects[i], 0, all.width);
    const int64_t bottom = std::clamp<int64_t>(rects[i + 1], 0, all.height);
    const int64_t right = std::clamp<int64_t>(int64_t{rects[i]} + rects[i + 2], left, all.width);
    const int64_t top =
        std::clamp<int64_t>(int64_t{rects[i + 1]} + rects[i + 3], bottom, all.height);
    if (left < right && bottom < top) {
      parts.push_back({static_cast<EGLint>(left), static_cast<EGLint>(bottom),
                       static_cast<EGLint>(right - left), static_cast<EGLint>(top - bottom)});
    }
  }
  return parts;
}

// Shows a window's buffer. Others may use the display meanwhile: what is posted must be current.
EGLint post_window(Surface& surface, NativeSurface& native, std::span<const Rect> parts,
                   EGLint interval) {
  const EGLint error = native.post(*surface.target.colour, parts, interval);
  if (error != EGL_SUCCESS) return error;
  surface.was_posted = true;
  surface.age_is_known = surface.damage_is_set = false;
  return EGL_SUCCESS;
}

EGLBoolean swap(EGLDisplay dpy, EGLSurface handle, const EGLint* rects, EGLint count) noexcept try {
  const Thread& thread = this_thread();
  Surface* surface = nullptr;
  std::shared_ptr<NativeSurface> native;
  std::vector<Rect> parts;
  bool without_context = false;
  {
    const std::lock_guard<std::mutex> lock(egl_mutex());
    surface = posted_surface(dpy, handle);
    if (surface == nullptr) return EGL_FALSE;
    if (count < 0 || (count > 0 && rects == nullptr)) return fail(EGL_BAD_PARAMETER, EGL_FALSE);
    native = surface->native;
    parts = parts_of(*surface, {rects, static_cast<size_t>(count) * 4});
    without_context = thread.context == nullptr || thread.context->draw != surface;
    if (without_context) surface->current = true;  // nobody may free or bind it meanwhile
  }
  EGLint error = EGL_SUCCESS;
  const bool is_window = surface->kind == Surface::Kind::kWindow;
  if (without_context) {
    // The swap interval is the context's business.
    if (is_window) error = post_window(*surface, *native, parts, 0);
    const std::lock_guard<std::mutex> lock(egl_mutex());
    surface->current = false;
    if (is_window && error == EGL_SUCCESS) follow_size(*surface);
    find_display(dpy)->sweep();
    return error == EGL_SUCCESS ? succeed(EGL_TRUE) : fail(error, EGL_FALSE);
  }
  // What is current to this thread stays, and the window system may be slow: no lock from here on.
  finish_current(thread);
  // Pbuffers and pixmaps have a single buffer: nothing is exchanged, but the frame ends (3.10.1).
  if (!is_window) return succeed(EGL_TRUE);
  error = post_window(*surface, *native, parts, surface->swap_interval);
  if (error != EGL_SUCCESS) return fail(error, EGL_FALSE);
  api::expect_frame(thread.context->context);
  return succeed(EGL_TRUE);
} catch (const std::bad_alloc&) {
  return fail(EGL_BAD_ALLOC, EGL_FALSE);
}

}  // namespace

EGLBoolean SwapBuffers(EGLDisplay dpy, EGLSurface surface) noexcept {
  return swap(dpy, surface, nullptr, 0);
}

EGLBoolean SwapBuffersWithDamageKHR(EGLDisplay dpy, EGLSurface surface, const EGLint* rects,
                                    EGLint count) noexcept {
  return swap(dpy, surface, rects, count);
}

EGLBoolean SwapBuffersWithDamageEXT(EGLDisplay dpy, EGLSurface surface, const EGLint* rects,
                                    EGLint count) noexcept {
  return swap(dpy, surface, rects, count);
}

// What is drawn outside of the region is undefined, so that it may be drawn as ever.
EGLBoolean SetDamageRegionKHR(EGLDisplay dpy, EGLSurface handle, EGLint* rects,
                              EGLint count) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_FALSE;
  Surface* surface = display->surface(handle);
  if (surface == nullptr) return fail(EGL_BAD_SURFACE, EGL_FALSE);
  if (count < 0 || (count > 0 && rects == nullptr)) return fail(EGL_BAD_PARAMETER, EGL_FALSE);
  if (surface->lock) return fail(EGL_BAD_ACCESS, EGL_FALSE);
  const Context* context = this_thread().context;
  // That a window which can be locked preserves its buffer by default is no wish of the program's.
  const bool preserves =
      surface->swap_behavior == EGL_BUFFER_PRESERVED && surface->swap_behavior_is_set;
  if (context == nullptr || context->draw != surface || surface->kind != Surface::Kind::kWindow ||
      preserves) {
    return fail(EGL_BAD_MATCH, EGL_FALSE);
  }
  if (surface->damage_is_set || !surface->age_is_known) return fail(EGL_BAD_ACCESS, EGL_FALSE);
  surface->damage_is_set = true;
  return succeed(EGL_TRUE);
}

EGLBoolean CopyBuffers(EGLDisplay dpy, EGLSurface handle, EGLNativePixmapType target) noexcept try {
  finish_current(this_thread());
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_FALSE;
  const Surface* surface = display->surface(handle);
  if (surface == nullptr) return fail(EGL_BAD_SURFACE, EGL_FALSE);
  if (surface->lock) return fail(EGL_BAD_ACCESS, EGL_FALSE);
  std::shared_ptr<NativeSurface> pixmap;
  const EGLint error = display->platform->make_pixmap(
      *surface->config, reinterpret_cast<void*>(target), false, pixmap);
  if (error != EGL_SUCCESS) return fail(error, EGL_FALSE);
  if (posted_surface(dpy, handle) == nullptr) return EGL_FALSE;
  const Rect all = {0, 0, surface->width, surface->height};
  if (pixmap->size() != Size{all.width, all.height}) return fail(EGL_BAD_MATCH, EGL_FALSE);
  const EGLint posted = pixmap->post(*surface->target.colour, {&all, 1}, 0);
  return posted == EGL_SUCCESS ? succeed(EGL_TRUE) : fail(posted, EGL_FALSE);
} catch (const std::bad_alloc&) {
  return fail(EGL_BAD_ALLOC, EGL_FALSE);
}

EGLBoolean SwapInterval(EGLDisplay dpy, EGLint interval) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  if (initialized_display(dpy) == nullptr) return EGL_FALSE;
  const Context* context = this_thread().context;
  if (context == nullptr) return fail(EGL_BAD_CONTEXT, EGL_FALSE);
  if (context->draw == nullptr) return fail(EGL_BAD_SURFACE, EGL_FALSE);
  Surface& surface = *context->draw;
  surface.swap_interval = std::clamp(interval, 0, surface.config->max_swap_interval);
  return succeed(EGL_TRUE);
}

}  // namespace clearpipe::icd::entry
