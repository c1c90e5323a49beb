// The formats of renderbuffers (OES_framebuffer_object, with OES_rgb8_rgba8, OES_depth24,
// OES_depth32, OES_stencil1, OES_stencil4, OES_stencil8, OES_packed_depth_stencil and EXT_sRGB).
//
// An implementation chooses the resolution of components, and says so when asked (4.4.2.1 of
// EXT_framebuffer_object): here it is always 8 bits of colour and stencil, and 24 of depth.
// SPDX-License-Identifier: MIT
#pragma once

#include <GLES/gl.h>
#include <GLES/glext.h>

namespace clearpipe::api {

struct RenderbufferFormat {
  bool colour = false, alpha = false, depth = false, stencil = false;
  bool srgb = false;  // the colours are sRGB-encoded
  explicit operator bool() const { return colour || depth || stencil; }
};

// Nothing in it: not the format of a renderbuffer.
inline RenderbufferFormat renderbuffer_format(GLenum internal) {
  switch (internal) {
    case GL_RGB565_OES:
    case GL_RGB8_OES:
      return {true, false, false, false};
    case GL_RGBA4_OES:
    case GL_RGB5_A1_OES:
    case GL_RGBA8_OES:
      return {true, true, false, false};
    case GL_SRGB8_ALPHA8_EXT:
      return {true, true, false, false, true};
    case GL_DEPTH_COMPONENT16_OES:
    case GL_DEPTH_COMPONENT24_OES:
    case GL_DEPTH_COMPONENT32_OES:
      return {false, false, true, false};
    case GL_STENCIL_INDEX1_OES:
    case GL_STENCIL_INDEX4_OES:
    case GL_STENCIL_INDEX8_OES:
      return {false, false, false, true};
    case GL_DEPTH24_STENCIL8_OES:
      return {false, false, true, true};
    default:
      return {};
  }
}

}  // namespace clearpipe::api
