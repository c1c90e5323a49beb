// Compressed textures that the desktop has too: S3TC (EXT_texture_compression_dxt1,
// ANGLE_texture_compression_dxt3 and dxt5).
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "conformance/scenes/draw.h"

namespace clearpipe::conformance {

namespace {

// Not in GLES/glext.h.
constexpr GLenum kDxt3 = 0x83F2, kDxt5 = 0x83F3;

// Random blocks for every level of a texture of that size, a part of the base replaced.
void compressed_texture(const Gl& gl, GLenum format, GLsizei width, GLsizei height) {
  const size_t block_bytes = format < kDxt3 ? 8 : 16;
  Random random(format);
  const auto blocks = [&](GLsizei w, GLsizei h) {
    std::vector<uint8_t> data(static_cast<size_t>((w + 3) / 4 * ((h + 3) / 4)) * block_bytes);
    for (uint8_t& byte : data) byte = random.byte();
    return data;
  };
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  for (GLint level = 0; width >> level > 0 || height >> level > 0; ++level) {
    const GLsizei w = std::max(width >> level, 1), h = std::max(height >> level, 1);
    const std::vector<uint8_t> data = blocks(w, h);
    gl.CompressedTexImage2D(GL_TEXTURE_2D, level, format, w, h, 0,
                            static_cast<GLsizei>(data.size()), data.data());
  }
  const std::vector<uint8_t> part = blocks(8, 4);
  gl.CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 4, 8, 8, 4, format,
                             static_cast<GLsizei>(part.size()), part.data());
}

// Every texel many pixels wide.
void plain(const Gl& gl, GLenum format, GLsizei width, GLsizei height, GLint filter) {
  compressed_texture(gl, format, width, height);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  clear(gl, 0.4f, 0.3f, 0.6f, 0.7f);
  pixel_projection(gl);
  gl.Enable(GL_TEXTURE_2D);
  draw(gl, GL_TRIANGLES, rectangle(3.2f, 5.1f, 251.7f, 249.4f), kTexCoords);
}

void with_mipmaps(const Gl& gl, GLenum format) {
  compressed_texture(gl, format, 64, 64);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  clear(gl);
  perspective(gl);
  gl.Enable(GL_TEXTURE_2D);
  gl.Translatef(0, -0.6f, -1.2f);
  gl.Rotatef(-72, 1, 0, 0);
  gl.Rotatef(17, 0, 0, 1);
  draw(gl, GL_TRIANGLES, rectangle(-2.2f, -1, 2.2f, 12, 0, -0.3f, -0.2f, 2, 6), kTexCoords);
}

}  // namespace

SCENE(compressed, dxt1_rgb, kColours) {
  plain(gl, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 32, 32, GL_NEAREST);
}
SCENE(compressed, dxt1_rgba, kColours) {
  plain(gl, GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, 32, 32, GL_NEAREST);
}
SCENE(compressed, dxt1_odd_size, kColours) {
  plain(gl, GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, 22, 13, GL_LINEAR);
}
SCENE(compressed, dxt3, kColours) { plain(gl, kDxt3, 32, 32, GL_NEAREST); }
SCENE(compressed, dxt5, kColours) { plain(gl, kDxt5, 32, 32, GL_NEAREST); }
SCENE(compressed, dxt5_linear, kColours) { plain(gl, kDxt5, 32, 16, GL_LINEAR); }
SCENE(compressed, dxt1_mipmaps, kColours) { with_mipmaps(gl, GL_COMPRESSED_RGBA_S3TC_DXT1_EXT); }
SCENE(compressed, dxt5_mipmaps, kColours) { with_mipmaps(gl, kDxt5); }

}  // namespace clearpipe::conformance
