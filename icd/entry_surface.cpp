// EGL commands on surfaces (3.5, 3.6, 3.10).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <new>

#include "icd/entry.h"
#include "icd/surface.h"

namespace clearpipe::icd::entry {

namespace {

// Windows and pixmaps: no config of a surfaceless display renders to them (3.5.1, 3.5.4).
EGLSurface refuse_native_surface(EGLDisplay dpy, EGLConfig config) {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  if (initialized_display(dpy) == nullptr) return EGL_NO_SURFACE;
  if (find_config(config) == nullptr) return fail(EGL_BAD_CONFIG, EGL_NO_SURFACE);
  return fail(EGL_BAD_MATCH, EGL_NO_SURFACE);
}

}  // namespace

EGLSurface CreatePbufferSurface(EGLDisplay dpy, EGLConfig config,
                                const EGLint* attrib_list) noexcept try {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_NO_SURFACE;
  auto surface = std::make_unique<Surface>();
  surface->config = find_config(config);
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

EGLSurface CreateWindowSurface(EGLDisplay dpy, EGLConfig config, EGLNativeWindowType,
                               const EGLint*) noexcept {
  return refuse_native_surface(dpy, config);
}

EGLSurface CreatePlatformWindowSurface(EGLDisplay dpy, EGLConfig config, void*,
                                       const EGLAttrib*) noexcept {
  return refuse_native_surface(dpy, config);
}

EGLSurface CreatePixmapSurface(EGLDisplay dpy, EGLConfig config, EGLNativePixmapType,
                               const EGLint*) noexcept {
  return refuse_native_surface(dpy, config);
}

EGLSurface CreatePlatformPixmapSurface(EGLDisplay dpy, EGLConfig config, void*,
                                       const EGLAttrib*) noexcept {
  return refuse_native_surface(dpy, config);
}

EGLSurface CreatePlatformWindowSurfaceEXT(EGLDisplay dpy, EGLConfig config, void*,
                                          const EGLint*) noexcept {
  return refuse_native_surface(dpy, config);
}

EGLSurface CreatePlatformPixmapSurfaceEXT(EGLDisplay dpy, EGLConfig config, void*,
                                          const EGLint*) noexcept {
  return refuse_native_surface(dpy, config);
}

// Client buffers are OpenVG's images (3.5.3), and there is no OpenVG here.
EGLSurface CreatePbufferFromClientBuffer(EGLDisplay dpy, EGLenum, EGLClientBuffer, EGLConfig config,
                                         const EGLint*) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  if (initialized_display(dpy) == nullptr) return EGL_NO_SURFACE;
  if (find_config(config) == nullptr) return fail(EGL_BAD_CONFIG, EGL_NO_SURFACE);
  return fail(EGL_BAD_PARAMETER, EGL_NO_SURFACE);
}

EGLBoolean DestroySurface(EGLDisplay dpy, EGLSurface handle) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_FALSE;
  Surface* surface = display->surface(handle);
  if (surface == nullptr) return fail(EGL_BAD_SURFACE, EGL_FALSE);
  surface->destroyed = true;
  display->labels.erase(handle);
  display->sweep();
  return succeed(EGL_TRUE);
}

// Table 3.5 (queryable surface attributes).
EGLBoolean QuerySurface(EGLDisplay dpy, EGLSurface handle, EGLint attribute,
                        EGLint* value) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_FALSE;
  const Surface* surface = display->surface(handle);
  if (surface == nullptr) return fail(EGL_BAD_SURFACE, EGL_FALSE);
  if (value == nullptr) return fail(EGL_BAD_PARAMETER, EGL_FALSE);
  switch (attribute) {
    case EGL_CONFIG_ID:
      *value = surface->config->id;
      break;
    case EGL_WIDTH:
      *value = surface->width;
      break;
    case EGL_HEIGHT:
      *value = surface->height;
      break;
    case EGL_LARGEST_PBUFFER:
      *value = surface->largest_pbuffer ? EGL_TRUE : EGL_FALSE;
      break;
    case EGL_RENDER_BUFFER:
      *value = EGL_BACK_BUFFER;
      break;
    case EGL_SWAP_BEHAVIOR:
      *value = surface->swap_behavior;
      break;
    case EGL_MULTISAMPLE_RESOLVE:
      *value = surface->multisample_resolve;
      break;
    case EGL_MIPMAP_LEVEL:
      *value = surface->mipmap_level;
      break;
    case EGL_MIPMAP_TEXTURE:
      *value = surface->mipmap_texture ? EGL_TRUE : EGL_FALSE;
      break;
    case EGL_TEXTURE_FORMAT:
      *value = surface->texture_format;
      break;
    case EGL_TEXTURE_TARGET:
      *value = surface->texture_target;
      break;
    case EGL_GL_COLORSPACE:
      *value = surface->gl_colorspace;
      break;
    case EGL_VG_COLORSPACE:
      *value = EGL_VG_COLORSPACE_sRGB;
      break;
    case EGL_VG_ALPHA_FORMAT:
      *value = EGL_VG_ALPHA_FORMAT_NONPRE;
      break;
    case EGL_HORIZONTAL_RESOLUTION:
    case EGL_VERTICAL_RESOLUTION:
    case EGL_PIXEL_ASPECT_RATIO:
      *value = EGL_UNKNOWN;
      break;
    default:
      return fail(EGL_BAD_ATTRIBUTE, EGL_FALSE);
  }
  return succeed(EGL_TRUE);
}

EGLBoolean SurfaceAttrib(EGLDisplay dpy, EGLSurface handle, EGLint attribute,
                         EGLint value) noexcept {
  const Thread& thread = this_thread();
  finish_current(thread);
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_FALSE;
  Surface* surface = display->surface(handle);
  if (surface == nullptr) return fail(EGL_BAD_SURFACE, EGL_FALSE);
  switch (attribute) {
    case EGL_MIPMAP_LEVEL:
      surface->mipmap_level = value;
      select_level(*surface, value);
      if (thread.context != nullptr) bind_targets(*thread.context);
      break;
    case EGL_MULTISAMPLE_RESOLVE:
      // The box is the default here too.
      if (value == EGL_MULTISAMPLE_RESOLVE_BOX && surface->config->samples == 0) {
        return fail(EGL_BAD_MATCH, EGL_FALSE);
      }
      if (value != EGL_MULTISAMPLE_RESOLVE_DEFAULT && value != EGL_MULTISAMPLE_RESOLVE_BOX) {
        return fail(EGL_BAD_PARAMETER, EGL_FALSE);
      }
      surface->multisample_resolve = value;
      break;
    case EGL_SWAP_BEHAVIOR:
      if (value != EGL_BUFFER_PRESERVED && value != EGL_BUFFER_DESTROYED) {
        return fail(EGL_BAD_PARAMETER, EGL_FALSE);
      }
      surface->swap_behavior = value;
      break;
    default:
      return fail(EGL_BAD_ATTRIBUTE, EGL_FALSE);
  }
  return succeed(EGL_TRUE);
}

EGLBoolean SwapBuffers(EGLDisplay dpy, EGLSurface handle) noexcept {
  const Thread& thread = this_thread();
  {
    const std::lock_guard<std::mutex> lock(egl_mutex());
    Display* display = initialized_display(dpy);
    if (display == nullptr) return EGL_FALSE;
    const Surface* surface = display->surface(handle);
    if (surface == nullptr) return fail(EGL_BAD_SURFACE, EGL_FALSE);
    if (thread.context == nullptr || thread.context->draw != surface) {
      return fail(EGL_BAD_SURFACE, EGL_FALSE);
    }
  }
  // A pbuffer is single-buffered: nothing is exchanged, but the frame ends (3.10.1).
  finish_current(thread);
  return succeed(EGL_TRUE);
}

// A surfaceless display has no native pixmaps (3.10.2).
EGLBoolean CopyBuffers(EGLDisplay dpy, EGLSurface handle, EGLNativePixmapType) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_FALSE;
  if (display->surface(handle) == nullptr) return fail(EGL_BAD_SURFACE, EGL_FALSE);
  return fail(EGL_BAD_NATIVE_PIXMAP, EGL_FALSE);
}

EGLBoolean SwapInterval(EGLDisplay dpy, EGLint) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  if (initialized_display(dpy) == nullptr) return EGL_FALSE;
  const Context* context = this_thread().context;
  if (context == nullptr) return fail(EGL_BAD_CONTEXT, EGL_FALSE);
  if (context->draw == nullptr) return fail(EGL_BAD_SURFACE, EGL_FALSE);
  return succeed(EGL_TRUE);  // has effect on windows only
}

}  // namespace clearpipe::icd::entry
