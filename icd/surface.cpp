// Surfaces: the attributes they are created with, and their buffers. See surface.h.
// SPDX-License-Identifier: MIT
#include "icd/surface.h"

#include <algorithm>

namespace clearpipe::icd {

namespace {

EGLint parse_boolean(EGLint value, bool& out) {
  if (value != EGL_FALSE && value != EGL_TRUE) return EGL_BAD_ATTRIBUTE;
  out = value == EGL_TRUE;
  return EGL_SUCCESS;
}

// One attribute of 3.5.2; the EGL error or EGL_SUCCESS.
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
    case EGL_MIPMAP_TEXTURE:
      return parse_boolean(value, out.mipmap_texture);
    case EGL_TEXTURE_FORMAT:
      out.texture_format = value;
      return value == EGL_NO_TEXTURE || value == EGL_TEXTURE_RGB || value == EGL_TEXTURE_RGBA
                 ? EGL_SUCCESS
                 : EGL_BAD_ATTRIBUTE;
    case EGL_TEXTURE_TARGET:
      out.texture_target = value;
      return value == EGL_NO_TEXTURE || value == EGL_TEXTURE_2D ? EGL_SUCCESS : EGL_BAD_ATTRIBUTE;
    case EGL_GL_COLORSPACE:  // kept for queries; OpenGL ES 1 does not convert (3.5.1)
      out.gl_colorspace = value;
      return value == EGL_GL_COLORSPACE_LINEAR || value == EGL_GL_COLORSPACE_SRGB
                 ? EGL_SUCCESS
                 : EGL_BAD_ATTRIBUTE;
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

// Buffers of a size as the config has them; false when memory does not suffice. A surface without
// pixels still has buffers that can be bound.
bool make_target(const Config& config, int width, int height, pipeline::Target& target) {
  target.width = width;
  target.height = height;
  width = std::max(width, 1);
  height = std::max(height, 1);
  const int samples = std::max(config.samples, 1);
  target.colour = pipeline::make_colour_buffer(width, height, config.alpha > 0, samples);
  if (!target.colour) return false;
  target.depth_stencil = nullptr;
  if (config.depth > 0 || config.stencil > 0) {
    target.depth_stencil = pipeline::make_depth_stencil_buffer(width, height, config.depth > 0,
                                                               config.stencil > 0, samples);
    if (!target.depth_stencil) return false;
  }
  return true;
}

}  // namespace

EGLint parse_pbuffer(const EGLint* list, Surface& out) {
  for (; list != nullptr && *list != EGL_NONE; list += 2) {
    const EGLint error = parse_pbuffer_attribute(list[0], list[1], out);
    if (error != EGL_SUCCESS) return error;
  }
  // 3.5.2: both or neither; and the config must be one that binds to the format (table 3.1).
  if ((out.texture_format == EGL_NO_TEXTURE) != (out.texture_target == EGL_NO_TEXTURE) ||
      (out.texture_format == EGL_TEXTURE_RGBA && out.config->alpha == 0)) {
    return EGL_BAD_MATCH;
  }
  if (out.largest_pbuffer) {
    out.width = std::min(out.width, kMaxPbuffer);
    out.height = std::min(out.height, kMaxPbuffer);
  }
  return out.width > kMaxPbuffer || out.height > kMaxPbuffer ? EGL_BAD_ALLOC : EGL_SUCCESS;
}

bool make_buffers(Surface& surface) {
  if (!make_target(*surface.config, surface.width, surface.height, surface.target)) return false;
  surface.levels = {surface.target};
  if (!surface.mipmap_texture || surface.texture_format == EGL_NO_TEXTURE) return true;
  for (int width = surface.width, height = surface.height; width > 1 || height > 1;) {
    width = std::max(width / 2, 1);
    height = std::max(height / 2, 1);
    if (!make_target(*surface.config, width, height, surface.levels.emplace_back())) return false;
  }
  return true;
}

void select_level(Surface& surface, EGLint level) {
  const EGLint last = static_cast<EGLint>(surface.levels.size()) - 1;
  surface.target = surface.levels[static_cast<size_t>(std::clamp(level, 0, last))];
}

}  // namespace clearpipe::icd
