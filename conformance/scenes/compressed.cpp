// Compressed textures: S3TC (EXT_texture_compression_dxt1, ANGLE_texture_compression_dxt3 and
// dxt5), ETC1 and paletted images (3.7.4).
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "conformance/scenes/draw.h"

namespace clearpipe::conformance {

namespace {

// Not in GLES/glext.h.
constexpr GLenum kDxt3 = 0x83F2, kDxt5 = 0x83F3;

// OES_compressed_ETC1_RGB8_texture leaves open what a sum of base and difference outside of 5 bits
// is: such differences become zero.
void define_sums(std::vector<uint8_t>& blocks) {
  for (size_t block = 0; block < blocks.size(); block += 8) {
    if ((blocks[block + 3] & 2) == 0) continue;  // two bases
    for (size_t c = 0; c < 3; ++c) {
      uint8_t& byte = blocks[block + c];
      const int sum = (byte >> 3) + ((byte & 7) ^ 4) - 4;
      if (sum < 0 || sum > 31) byte = byte & 0xf8;
    }
  }
}

// Random blocks for every level of a texture of that size, a part of the base replaced.
void compressed_texture(const Gl& gl, GLenum format, GLsizei width, GLsizei height) {
  const size_t block_bytes = format == kDxt3 || format == kDxt5 ? 16 : 8;
  Random random(format);
  const auto blocks = [&](GLsizei w, GLsizei h) {
    std::vector<uint8_t> data(static_cast<size_t>((w + 3) / 4 * ((h + 3) / 4)) * block_bytes);
    for (uint8_t& byte : data) byte = random.byte();
    if (format == GL_ETC1_RGB8_OES) define_sums(data);
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

// The ten formats with palettes, as they follow each other: of 4 and of 8 bits an index.
struct Palette {
  GLenum format;
  size_t entries, entry_bytes;
};
constexpr Palette kPalettes[] = {
    {GL_PALETTE4_RGB8_OES, 16, 3},     {GL_PALETTE4_RGBA8_OES, 16, 4},
    {GL_PALETTE4_R5_G6_B5_OES, 16, 2}, {GL_PALETTE4_RGBA4_OES, 16, 2},
    {GL_PALETTE4_RGB5_A1_OES, 16, 2},  {GL_PALETTE8_RGB8_OES, 256, 3},
    {GL_PALETTE8_RGBA8_OES, 256, 4},   {GL_PALETTE8_R5_G6_B5_OES, 256, 2},
    {GL_PALETTE8_RGBA4_OES, 256, 2},   {GL_PALETTE8_RGB5_A1_OES, 256, 2},
};

// A random palette and random indices of `levels` levels. Half bytes are left over at the end of
// levels with an odd number of texels.
void paletted_texture(const Gl& gl, const Palette& palette, GLsizei width, GLsizei height,
                      int levels) {
  size_t bytes = palette.entries * palette.entry_bytes;
  for (int level = 0; level < levels; ++level) {
    const auto texels = static_cast<size_t>(std::max(width >> level, 1)) *
                        static_cast<size_t>(std::max(height >> level, 1));
    bytes += palette.entries == 16 ? (texels + 1) / 2 : texels;
  }
  Random random(palette.format);
  std::vector<uint8_t> data(bytes);
  for (uint8_t& byte : data) byte = random.byte();
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                   levels > 1 ? GL_NEAREST_MIPMAP_LINEAR : GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.CompressedTexImage2D(GL_TEXTURE_2D, 1 - levels, palette.format, width, height, 0,
                          static_cast<GLsizei>(bytes), data.data());
  gl.Enable(GL_TEXTURE_2D);
}

void with_mipmaps(const Gl& gl, GLenum format) {
  compressed_texture(gl, format, 64, 64);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  textured_plate(gl, 2);
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
ES_SCENE(compressed, etc1, kColours) {
  plain(gl, GL_ETC1_RGB8_OES, 32, 32, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  draw(gl, GL_TRIANGLES, rectangle(60.3f, 70.2f, 180.6f, 190.4f), kTexCoords);
}

// A cell for each format; alpha shows over the background.
ES_SCENE(compressed, paletted, kColours) {
  clear(gl, 0.4f, 0.3f, 0.6f, 0.7f);
  pixel_projection(gl);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  int cell = 0;
  for (const Palette& palette : kPalettes) {
    paletted_texture(gl, palette, 16, 8, 1);
    const auto x = static_cast<float>(cell % 2 * 128), y = static_cast<float>(cell / 2 * 51);
    draw(gl, GL_TRIANGLES, rectangle(x + 2.2f, y + 2.1f, x + 125.7f, y + 49.4f), kTexCoords);
    ++cell;
  }
}

// All levels in one call.
ES_SCENE(compressed, paletted_mipmaps,
         except_at_borders("NEAREST: 3.7.7, a texel's border decides")) {
  clear(gl);
  perspective(gl);
  gl.Translatef(0, -0.6f, -1.2f);
  gl.Rotatef(-72, 1, 0, 0);
  float x = -2.2f;
  for (const Palette& palette : {kPalettes[1], kPalettes[7]}) {
    paletted_texture(gl, palette, 16, 16, 5);
    draw(gl, GL_TRIANGLES, rectangle(x, -1, x + 2.1f, 12, 0, -0.3f, -0.2f, 5, 15), kTexCoords);
    x += 2.3f;
  }
}

}  // namespace clearpipe::conformance
