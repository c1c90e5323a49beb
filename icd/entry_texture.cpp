// EGL commands that make surfaces textures (3.6, EGL_NOK_texture_from_pixmap).
// SPDX-License-Identifier: MIT
#include <new>

#include "icd/entry.h"

namespace clearpipe::icd::entry {

namespace {

// The surface of a handle, if it can be a texture; else null, and the error is noted
// (3.6.1, 3.6.2).
Surface* texture_surface(EGLDisplay dpy, EGLSurface handle, EGLint buffer) {
  Display* display = initialized_display(dpy);
  if (display == nullptr) return nullptr;
  Surface* surface = display->surface(handle);
  Surface* const none = nullptr;
  if (surface == nullptr || surface->kind == Surface::Kind::kWindow) {
    return fail(EGL_BAD_SURFACE, none);
  }
  if (surface->lock) return fail(EGL_BAD_ACCESS, none);
  if (buffer != EGL_BACK_BUFFER) return fail(EGL_BAD_PARAMETER, none);
  if (surface->texture_format == EGL_NO_TEXTURE) return fail(EGL_BAD_MATCH, none);
  return surface;
}

}  // namespace

EGLBoolean BindTexImage(EGLDisplay dpy, EGLSurface handle, EGLint buffer) noexcept try {
  const Thread& thread = this_thread();
  finish_current(thread);
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Surface* surface = texture_surface(dpy, handle, buffer);
  if (surface == nullptr) return EGL_FALSE;
  if (!surface->texture.expired()) return fail(EGL_BAD_ACCESS, EGL_FALSE);
  if (thread.context == nullptr) return succeed(EGL_TRUE);  // ignored
  if (!api::takes_surface_texture(thread.context->context)) return fail(EGL_BAD_MATCH, EGL_FALSE);
  if (surface->kind == Surface::Kind::kPixmap) surface->native->fetch(*surface->target.colour);
  // A mipmap is generated from the base level, or is what was drawn to its levels.
  const bool generate = surface->mipmap_texture && surface->mipmap_level == 0;
  std::vector<std::shared_ptr<pipeline::ColourBuffer>> levels;
  for (const pipeline::Target& level : surface->levels) {
    if (level.width > 0 && level.height > 0) levels.push_back(level.colour);
  }
  surface->texture = api::bind_surface_texture(
      thread.context->context, levels, surface->texture_format == EGL_TEXTURE_RGBA, generate);
  return surface->texture.expired() ? fail(EGL_BAD_ALLOC, EGL_FALSE) : succeed(EGL_TRUE);
} catch (const std::bad_alloc&) {
  return fail(EGL_BAD_ALLOC, EGL_FALSE);
}

EGLBoolean ReleaseTexImage(EGLDisplay dpy, EGLSurface handle, EGLint buffer) noexcept {
  finish_current(this_thread());
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Surface* surface = texture_surface(dpy, handle, buffer);
  if (surface == nullptr) return EGL_FALSE;
  api::release_surface_texture(surface->texture);
  surface->texture.reset();
  return succeed(EGL_TRUE);
}

}  // namespace clearpipe::icd::entry
