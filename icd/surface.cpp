// Surfaces: the attributes they are created with, and their buffers. See surface.h.
// SPDX-License-Identifier: MIT
#include "icd/surface.h"

#include <algorithm>
#include <new>

namespace clearpipe::icd {

namespace {

EGLint parse_boolean(EGLAttrib value, bool& out) {
  if (value != EGL_FALSE && value != EGL_TRUE) return EGL_BAD_ATTRIBUTE;
  out = value == EGL_TRUE;
  return EGL_SUCCESS;
}

// What surfaces of every kind may be created with; the EGL error or EGL_SUCCESS.
EGLint parse_attribute(EGLAttrib name, EGLAttrib value, Surface& out) {
  switch (name) {
    case EGL_GL_COLORSPACE:
      out.gl_colorspace = static_cast<EGLint>(value);
      if (value == EGL_GL_COLORSPACE_LINEAR) return EGL_SUCCESS;
      if (value != EGL_GL_COLORSPACE_SRGB) return EGL_BAD_ATTRIBUTE;
      // Colours of fewer bits are not encoded (3.5.1).
      return out.config->format == pipeline::ColourFormat::kRgba8 ? EGL_SUCCESS : EGL_BAD_MATCH;
    case EGL_VG_COLORSPACE:  // no config has the bit of the other value (table 3.2)
      if (value == EGL_VG_COLORSPACE_sRGB) return EGL_SUCCESS;
      return value == EGL_VG_COLORSPACE_LINEAR ? EGL_BAD_MATCH : EGL_BAD_ATTRIBUTE;
    case EGL_VG_ALPHA_FORMAT:
      if (value == EGL_VG_ALPHA_FORMAT_NONPRE) return EGL_SUCCESS;
      return value == EGL_VG_ALPHA_FORMAT_PRE ? EGL_BAD_MATCH : EGL_BAD_ATTRIBUTE;
    default:
      return EGL_BAD_ATTRIBUTE;
  }
}

// Of surfaces that can be textures: pbuffers (3.5.2) and pixmaps (EGL_NOK_texture_from_pixmap).
EGLint parse_texture_attribute(EGLAttrib name, EGLAttrib value, Surface& out) {
  switch (name) {
    case EGL_MIPMAP_TEXTURE:
      return parse_boolean(value, out.mipmap_texture);
    case EGL_TEXTURE_FORMAT:
      out.texture_format = static_cast<EGLint>(value);
      return value == EGL_NO_TEXTURE || value == EGL_TEXTURE_RGB || value == EGL_TEXTURE_RGBA
                 ? EGL_SUCCESS
                 : EGL_BAD_ATTRIBUTE;
    case EGL_TEXTURE_TARGET:
      out.texture_target = static_cast<EGLint>(value);
      return value == EGL_NO_TEXTURE || value == EGL_TEXTURE_2D ? EGL_SUCCESS : EGL_BAD_ATTRIBUTE;
    default:
      return parse_attribute(name, value, out);
  }
}

// 3.5.2: both or neither. Every config binds to one of the formats, which is all that is asked; a
// texture of RGBA is opaque if the config has no alpha.
EGLint check_texture(const Surface& surface) {
  const bool fits =
      (surface.texture_format == EGL_NO_TEXTURE) == (surface.texture_target == EGL_NO_TEXTURE);
  return fits ? EGL_SUCCESS : EGL_BAD_MATCH;
}

EGLint parse_pbuffer_attribute(EGLint name, EGLint value, Surface& out) {
  switch (name) {
    case EGL_WIDTH:
      out.width = value;
      return value < 0 ? EGL_BAD_PARAMETER : EGL_SUCCESS;
    case EGL_HEIGHT:
      out.height = value;
      return value < 0 ? EGL_BAD_PARAMETER : EGL_SUCCESS;
    case EGL_LARGEST_PBUFFER:
      return parse_boolean(value, out.largest_pbuffer);
    default:
      return parse_texture_attribute(name, value, out);
  }
}

EGLint parse_window_attribute(EGLAttrib name, EGLAttrib value, Surface& out) {
  if (name == EGL_SWAP_BEHAVIOR && is_lockable(*out.config)) {  // EGL_KHR_lock_surface3, 3.5.1
    out.swap_behavior = static_cast<EGLint>(value);
    out.swap_behavior_is_set = true;
    return value == EGL_BUFFER_PRESERVED || value == EGL_BUFFER_DESTROYED ? EGL_SUCCESS
                                                                          : EGL_BAD_ATTRIBUTE;
  }
  if (name != EGL_RENDER_BUFFER) return parse_attribute(name, value, out);
  // What is asked for; drawn to is the back buffer, as it may be (3.5.1).
  out.render_buffer = static_cast<EGLint>(value);
  return value == EGL_BACK_BUFFER || value == EGL_SINGLE_BUFFER ? EGL_SUCCESS : EGL_BAD_ATTRIBUTE;
}

template <class Attribute>
EGLint parse_native_list(const Attribute* list, Surface& out) {
  const bool is_window = out.kind == Surface::Kind::kWindow;
  // 3.5.6, with EGL_KHR_lock_surface3: what was drawn is there when a window is locked.
  out.swap_behavior =
      is_window && is_lockable(*out.config) ? EGL_BUFFER_PRESERVED : EGL_BUFFER_DESTROYED;
  out.render_buffer = is_window ? EGL_BACK_BUFFER : EGL_SINGLE_BUFFER;
  for (; list != nullptr && *list != EGL_NONE; list += 2) {
    const EGLint error = is_window ? parse_window_attribute(list[0], list[1], out)
                                   : parse_texture_attribute(list[0], list[1], out);
    if (error != EGL_SUCCESS) return error;
  }
  return check_texture(out);
}

// Buffers of a size as the config has them; false when memory does not suffice. A surface without
// pixels still has buffers that can be bound.
bool make_target(const Surface& surface, int width, int height, pipeline::Target& target) {
  const Config& config = *surface.config;
  target.width = width;
  target.height = height;
  width = std::max(width, 1);
  height = std::max(height, 1);
  const int samples = std::max(config.samples, 1);
  target.colour = pipeline::make_colour_buffer(width, height, config.alpha > 0, samples);
  if (!target.colour) return false;
  target.colour->format = config.format;
  // What is drawn is encoded, as contexts with EXT_sRGB do (3.5.1).
  target.colour->srgb = surface.gl_colorspace == EGL_GL_COLORSPACE_SRGB;
  target.depth_stencil = nullptr;
  if (config.depth > 0 || config.stencil > 0) {
    target.depth_stencil = pipeline::make_depth_stencil_buffer(width, height, config.depth > 0,
                                                               config.stencil > 0, samples);
    if (!target.depth_stencil) return false;
    if (config.depth > 0) target.depth_stencil->depth_bits = config.depth;
  }
  return true;
}

}  // namespace

EGLint parse_pbuffer(const EGLint* list, Surface& out) {
  for (; list != nullptr && *list != EGL_NONE; list += 2) {
    const EGLint error = parse_pbuffer_attribute(list[0], list[1], out);
    if (error != EGL_SUCCESS) return error;
  }
  if (const EGLint error = check_texture(out); error != EGL_SUCCESS) return error;
  if (out.largest_pbuffer) {
    out.width = std::min<EGLint>(out.width, kMaxPbuffer);
    out.height = std::min<EGLint>(out.height, kMaxPbuffer);
  }
  return out.width > kMaxPbuffer || out.height > kMaxPbuffer ? EGL_BAD_ALLOC : EGL_SUCCESS;
}

EGLint parse_native(const EGLint* list, Surface& out) { return parse_native_list(list, out); }
EGLint parse_native(const EGLAttrib* list, Surface& out) { return parse_native_list(list, out); }

bool make_buffers(Surface& surface) {
  if (surface.width > kMaxPbuffer || surface.height > kMaxPbuffer ||
      !make_target(surface, surface.width, surface.height, surface.target)) {
    return false;
  }
  // A pixmap's pixels are written from outside as well.
  if (surface.kind == Surface::Kind::kPixmap &&
      !pipeline::lay_out_in_rows(*surface.target.colour)) {
    return false;
  }
  surface.levels = {surface.target};
  if (surface.kind != Surface::Kind::kPbuffer || !surface.mipmap_texture ||
      surface.texture_format == EGL_NO_TEXTURE) {
    return true;
  }
  for (int width = surface.width, height = surface.height; width > 1 || height > 1;) {
    width = std::max(width / 2, 1);
    height = std::max(height / 2, 1);
    if (!make_target(surface, width, height, surface.levels.emplace_back())) return false;
  }
  return true;
}

void select_level(Surface& surface, EGLint level) {
  const EGLint last = static_cast<EGLint>(surface.levels.size()) - 1;
  surface.target = surface.levels[static_cast<size_t>(std::clamp(level, 0, last))];
}

bool follow_size(Surface& surface) {
  if (surface.kind != Surface::Kind::kWindow) return true;
  const std::optional<Size> size = surface.native->size();
  if (!size) return false;
  if (*size == Size{surface.width, surface.height}) return true;
  const Size before = {surface.width, surface.height};
  surface.width = size->width;
  surface.height = size->height;
  try {
    if (make_buffers(surface)) {
      surface.was_posted = false;
      return true;
    }
  } catch (const std::bad_alloc&) {
    // As below.
  }
  surface.width = before.width;
  surface.height = before.height;
  surface.target = surface.levels[0];
  return true;
}

void copy_to_pixmap(Surface& surface) {
  if (surface.kind != Surface::Kind::kPixmap || surface.destroyed) return;
  const Rect all = {0, 0, surface.width, surface.height};
  surface.native->post(*surface.target.colour, {&all, 1}, 0);
}

void destroy(Surface& surface) {
  surface.destroyed = true;
  if (surface.native != nullptr) surface.native->close();
}

void Context::frame_begins() noexcept {
  for (Surface* surface : {draw, read}) {
    if (surface != nullptr) follow_size(*surface);
  }
  bind_targets(*this);
}

void Context::surface_is_drawn() noexcept {
  if (draw != nullptr) copy_to_pixmap(*draw);
}

}  // namespace clearpipe::icd
