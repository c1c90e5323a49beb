// EGL commands on the attributes of surfaces (3.5.6).
// SPDX-License-Identifier: MIT
#include "icd/entry.h"
#include "icd/surface.h"

namespace clearpipe::icd::entry {

namespace {

// Of table 3.5, what only pbuffers have: asked of others, nothing is said.
bool is_of_pbuffers(EGLint attribute) {
  return attribute == EGL_LARGEST_PBUFFER || attribute == EGL_TEXTURE_FORMAT ||
         attribute == EGL_TEXTURE_TARGET || attribute == EGL_MIPMAP_TEXTURE ||
         attribute == EGL_MIPMAP_LEVEL;
}

// The attributes that are the same for as long as nobody sets them; false: no such attribute.
bool get_attribute(const Surface& surface, EGLint attribute, EGLint& value) {
  switch (attribute) {
    case EGL_CONFIG_ID:
      value = surface.config->id;
      break;
    case EGL_WIDTH:
      value = surface.width;
      break;
    case EGL_HEIGHT:
      value = surface.height;
      break;
    case EGL_LARGEST_PBUFFER:
      value = surface.largest_pbuffer ? EGL_TRUE : EGL_FALSE;
      break;
    case EGL_RENDER_BUFFER:
      value = surface.render_buffer;
      break;
    case EGL_SWAP_BEHAVIOR:
      value = surface.swap_behavior;
      break;
    case EGL_MULTISAMPLE_RESOLVE:
      value = surface.multisample_resolve;
      break;
    case EGL_MIPMAP_LEVEL:
      value = surface.mipmap_level;
      break;
    case EGL_MIPMAP_TEXTURE:
      value = surface.mipmap_texture ? EGL_TRUE : EGL_FALSE;
      break;
    case EGL_TEXTURE_FORMAT:
      value = surface.texture_format;
      break;
    case EGL_TEXTURE_TARGET:
      value = surface.texture_target;
      break;
    case EGL_GL_COLORSPACE:
      value = surface.gl_colorspace;
      break;
    case EGL_VG_COLORSPACE:
      value = EGL_VG_COLORSPACE_sRGB;
      break;
    case EGL_VG_ALPHA_FORMAT:
      value = EGL_VG_ALPHA_FORMAT_NONPRE;
      break;
    case EGL_BITMAP_PITCH_KHR:
      value = static_cast<EGLint>(mapped_pitch(*surface.config, surface.width));
      break;
    case EGL_BITMAP_ORIGIN_KHR:
      value = EGL_UPPER_LEFT_KHR;
      break;
    case EGL_BITMAP_PIXEL_SIZE_KHR:
      value = 8 * mapped_layout(*surface.config).bytes;
      break;
    case EGL_BITMAP_PIXEL_RED_OFFSET_KHR:
    case EGL_BITMAP_PIXEL_GREEN_OFFSET_KHR:
    case EGL_BITMAP_PIXEL_BLUE_OFFSET_KHR:
    case EGL_BITMAP_PIXEL_ALPHA_OFFSET_KHR: {
      const auto component = static_cast<size_t>(attribute - EGL_BITMAP_PIXEL_RED_OFFSET_KHR);
      value = mapped_layout(*surface.config).rgba[component].shift;
      break;
    }
    case EGL_BITMAP_PIXEL_LUMINANCE_OFFSET_KHR:
      value = 0;
      break;
    case EGL_HORIZONTAL_RESOLUTION:
    case EGL_VERTICAL_RESOLUTION:
    case EGL_PIXEL_ASPECT_RATIO:
      value = EGL_UNKNOWN;
      break;
    default:
      return false;
  }
  return true;
}

}  // namespace

EGLBoolean QuerySurface(EGLDisplay dpy, EGLSurface handle, EGLint attribute,
                        EGLint* value) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_FALSE;
  Surface* surface = display->surface(handle);
  if (surface == nullptr) return fail(EGL_BAD_SURFACE, EGL_FALSE);
  if (value == nullptr) return fail(EGL_BAD_PARAMETER, EGL_FALSE);
  const Context* context = this_thread().context;
  const bool drawn_to_here = context != nullptr && context->draw == surface;
  // A frame that has not begun has the size that the window has now.
  if (drawn_to_here) api::begin_frame(context->context);
  if (attribute == EGL_BUFFER_AGE_EXT) {
    if (!drawn_to_here) return fail(EGL_BAD_SURFACE, EGL_FALSE);
    surface->age_is_known = true;
    // There is one buffer, so it is that of the last frame; a pbuffer has no frames.
    *value = surface->was_posted ? 1 : 0;
    return succeed(EGL_TRUE);
  }
  // A pointer and a pitch are of what is mapped, which it is by asking.
  if (attribute == EGL_BITMAP_PITCH_KHR && (!surface->lock || !map_surface(*surface))) {
    return fail(EGL_BAD_ACCESS, EGL_FALSE);
  }
  if (surface->kind != Surface::Kind::kPbuffer && is_of_pbuffers(attribute) &&
      surface->texture_format == EGL_NO_TEXTURE) {
    return succeed(EGL_TRUE);
  }
  return get_attribute(*surface, attribute, *value) ? succeed(EGL_TRUE)
                                                    : fail(EGL_BAD_ATTRIBUTE, EGL_FALSE);
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
  if (surface->lock) return fail(EGL_BAD_ACCESS, EGL_FALSE);
  switch (attribute) {
    case EGL_MIPMAP_LEVEL:
      surface->mipmap_level = value;
      if (surface->levels.size() > 1) select_level(*surface, value);
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
      surface->swap_behavior_is_set = true;
      break;
    default:
      return fail(EGL_BAD_ATTRIBUTE, EGL_FALSE);
  }
  return succeed(EGL_TRUE);
}

}  // namespace clearpipe::icd::entry
