// The pixel formats of table 3.4, and how their pixels lie in memory.
// SPDX-License-Identifier: MIT
#pragma once

#include <GLES/gl.h>
#include <GLES/glext.h>

#include <cstddef>
#include <cstdint>

#include "pipeline/unpack/unpack.h"

namespace clearpipe::api {

inline bool is_base_format(GLenum format) {
  return format >= GL_ALPHA && format <= GL_LUMINANCE_ALPHA;  // ALPHA RGB RGBA LUMINANCE L_A
}

// Whether the colours of images of an internal format are sRGB-encoded (EXT_sRGB).
inline bool is_srgb(GLenum internal) {
  return internal == GL_SRGB_EXT || internal == GL_SRGB_ALPHA_EXT;
}

// Whether an application may give pixels in that format, of some type.
inline bool is_upload_format(GLenum format) {
  return is_base_format(format) || format == GL_BGRA_EXT || is_srgb(format);
}

// The base format of an internal format: itself, or that of one with component sizes
// (OES_required_internalformat), or RGBA for BGRA (EXT_texture_format_BGRA8888), or that of the
// sRGB-encoded components. 0 if it is none.
inline GLenum base_format(GLenum internal) {
  switch (internal) {
    case GL_BGRA_EXT:
    case GL_SRGB_ALPHA_EXT:
    case GL_RGBA8_OES:
    case GL_RGBA4_OES:
    case GL_RGB5_A1_OES:
      return GL_RGBA;
    case GL_SRGB_EXT:
    case GL_RGB8_OES:
    case GL_RGB565_OES:
      return GL_RGB;
    case GL_LUMINANCE8_ALPHA8_OES:
    case GL_LUMINANCE4_ALPHA4_OES:
      return GL_LUMINANCE_ALPHA;
    case GL_LUMINANCE8_OES:
      return GL_LUMINANCE;
    case GL_ALPHA8_OES:
      return GL_ALPHA;
    default:
      return is_base_format(internal) ? internal : 0;
  }
}

// The format in which an application gives the pixels of an image of that internal format.
inline GLenum upload_format(GLenum internal) {
  return internal == GL_BGRA_EXT || is_srgb(internal) ? internal : base_format(internal);
}

// Whether an image of that internal format may be given in that type (table 3.4 of
// OES_required_internalformat): never in fewer bits than it asks for.
inline bool has_enough_bits(GLenum internal, GLenum type) {
  if (type == GL_UNSIGNED_BYTE || internal == upload_format(internal)) return true;
  return (type == GL_UNSIGNED_SHORT_5_6_5 && internal == GL_RGB565_OES) ||
         (type == GL_UNSIGNED_SHORT_4_4_4_4 && internal == GL_RGBA4_OES) ||
         (type == GL_UNSIGNED_SHORT_5_5_5_1 && internal == GL_RGB5_A1_OES);
}

// Whether an application may give pixels of an upload format in that type (table 3.4).
inline bool is_upload_type(GLenum format, GLenum type) {
  switch (type) {
    case GL_UNSIGNED_BYTE:
      return true;
    case GL_UNSIGNED_SHORT_5_6_5:
      return format == GL_RGB;
    case GL_UNSIGNED_SHORT_4_4_4_4:
    case GL_UNSIGNED_SHORT_5_5_5_1:
      return format == GL_RGBA;
    default:
      return false;
  }
}

// How such pixels lie in memory.
inline pipeline::UnpackLayout unpack_layout(GLenum format, GLenum type) {
  using pipeline::UnpackLayout;
  switch (type) {
    case GL_UNSIGNED_SHORT_5_6_5:
      return UnpackLayout::kRgb565;
    case GL_UNSIGNED_SHORT_4_4_4_4:
      return UnpackLayout::kRgba4444;
    case GL_UNSIGNED_SHORT_5_5_5_1:
      return UnpackLayout::kRgba5551;
    default:
      break;
  }
  switch (format) {
    case GL_RGBA:
    case GL_SRGB_ALPHA_EXT:
      return UnpackLayout::kRgba8;
    case GL_BGRA_EXT:
      return UnpackLayout::kBgra8;
    case GL_RGB:
    case GL_SRGB_EXT:
      return UnpackLayout::kRgb8;
    case GL_LUMINANCE_ALPHA:
      return UnpackLayout::kLuminanceAlpha8;
    case GL_LUMINANCE:
      return UnpackLayout::kLuminance8;
    default:
      return UnpackLayout::kAlpha8;
  }
}

inline uint32_t rgba(uint32_t r, uint32_t g, uint32_t b, uint32_t a) {
  return r | g << 8 | b << 16 | a << 24;
}

// What of a colour a base format keeps (table 3.9): luminance is the red component.
inline uint32_t components_of(uint32_t colour, GLenum format) {
  const uint32_t r = colour & 255, a = colour >> 24;
  switch (format) {
    case GL_RGBA:
      return colour;
    case GL_RGB:
      return colour | 0xff000000u;
    case GL_LUMINANCE_ALPHA:
      return rgba(r, r, r, a);
    case GL_LUMINANCE:
      return rgba(r, r, r, 255);
    default:
      return rgba(0, 0, 0, a);
  }
}

// Bytes of a pixel as ReadPixels gives it (4.3.1, EXT_read_format_bgra, OES_read_format); 0 if it
// does not, whatever the surface.
inline size_t read_bytes(GLenum format, GLenum type) {
  if (type == GL_UNSIGNED_BYTE) return format == GL_RGBA || format == GL_BGRA_EXT ? 4 : 0;
  if (format == GL_RGB && type == GL_UNSIGNED_SHORT_5_6_5) return 2;
  return format == GL_BGRA_EXT && (type == GL_UNSIGNED_SHORT_4_4_4_4_REV_EXT ||
                                   type == GL_UNSIGNED_SHORT_1_5_5_5_REV_EXT)
             ? 2
             : 0;
}

// A pixel of a surface as RGB or BGRA of that type: blue in the lowest bits, components rounded
// (4.3.1).
inline uint32_t pack_read(uint32_t pixel, GLenum type) {
  const auto scaled = [pixel](uint32_t shift, uint32_t max) {
    return ((pixel >> shift & 255) * max + 127) / 255;
  };
  switch (type) {
    case GL_UNSIGNED_SHORT_5_6_5:
      return scaled(16, 31) | scaled(8, 63) << 5 | scaled(0, 31) << 11;
    case GL_UNSIGNED_SHORT_4_4_4_4_REV_EXT:
      return scaled(16, 15) | scaled(8, 15) << 4 | scaled(0, 15) << 8 | scaled(24, 15) << 12;
    case GL_UNSIGNED_SHORT_1_5_5_5_REV_EXT:
      return scaled(16, 31) | scaled(8, 31) << 5 | scaled(0, 31) << 10 | scaled(24, 1) << 15;
    default:
      return (pixel & 0xff00ff00u) | (pixel >> 16 & 255) | (pixel & 255) << 16;
  }
}

}  // namespace clearpipe::api
