// The formats of renderbuffers (OES_framebuffer_object, with OES_rgb8_rgba8, OES_depth24,
// OES_depth32, OES_stencil1, OES_stencil4, OES_stencil8, OES_packed_depth_stencil and EXT_sRGB).
//
// An implementation chooses the resolution of components, and says so when asked (4.4.2.1 of
// EXT_framebuffer_object): here colours and depths of 16 bits are what their names say, stencil has
// 8 bits, and other depths have 24.
// SPDX-License-Identifier: MIT
#pragma once

#include <GLES/gl.h>
#include <GLES/glext.h>

#include "pipeline/colour_format.h"

namespace clearpipe::api {

struct RenderbufferFormat {
  bool colour = false, alpha = false, depth = false, stencil = false;
  bool srgb = false;  // the colours are sRGB-encoded
  pipeline::ColourFormat format = pipeline::ColourFormat::kRgba8;
  int depth_bits = 24;
  explicit operator bool() const { return colour || depth || stencil; }
};

// Nothing in it: not the format of a renderbuffer.
inline RenderbufferFormat renderbuffer_format(GLenum internal) {
  using pipeline::ColourFormat;
  switch (internal) {
    case GL_RGB565_OES:
      return {.colour = true, .format = ColourFormat::kRgb565};
    case GL_RGB8_OES:
      return {.colour = true};
    case GL_RGBA4_OES:
      return {.colour = true, .alpha = true, .format = ColourFormat::kRgba4};
    case GL_RGB5_A1_OES:
      return {.colour = true, .alpha = true, .format = ColourFormat::kRgb5A1};
    case GL_RGBA8_OES:
      return {.colour = true, .alpha = true};
    case GL_SRGB8_ALPHA8_EXT:
      return {.colour = true, .alpha = true, .srgb = true};
    case GL_DEPTH_COMPONENT16_OES:
      return {.depth = true, .depth_bits = 16};
    case GL_DEPTH_COMPONENT24_OES:
    case GL_DEPTH_COMPONENT32_OES:
      return {.depth = true};
    case GL_STENCIL_INDEX1_OES:
    case GL_STENCIL_INDEX4_OES:
    case GL_STENCIL_INDEX8_OES:
      return {.stencil = true};
    case GL_DEPTH24_STENCIL8_OES:
      return {.depth = true, .stencil = true};
    default:
      return {};
  }
}

}  // namespace clearpipe::api
