// Compressed internal formats (3.7.3): what their images are made of, what they allow, and how they
// become RGBA8 texels. All are decoded when they are given; nothing remembers the compressed data.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "api/texture_tokens.h"
#include "pipeline/image.h"

namespace clearpipe::api {

inline constexpr uint32_t kOpaque = 0xff000000u;  // the alpha of a texel of a format without

// Texels of a compressed image and the place they go to: the first at (x, y) of a level.
struct DecodeTarget {
  pipeline::ImageLevel& level;
  int x, y, width, height;
};

// What one format allows and how it is laid out, by the family of its extension.
struct CompressedFamily {
  // Texels of a block, and the least number of blocks in each direction.
  int block_width, block_height, least_blocks;
  GLenum border_error;
  // Which sizes an image may have: all, 1, 2 and multiples of 4, or powers of two.
  enum class Sizes { kAll, kOneTwoOrBlocks, kPowersOfTwo } sizes;
  // Which parts of it can be given anew, besides the whole: blocks, or what is left of them at the
  // edge; blocks, also of the whole width or height; none.
  enum class Parts { kBlocksToTheEdge, kBlocksOrAllOfIt, kNone } parts;
};

// A format whose images are blocks of texels, row by row.
struct CompressedFormat {
  GLenum internal;
  GLenum base;
  const CompressedFamily& family;
  int block_bytes;
  void (*decode)(const uint8_t* data, const DecodeTarget& to);
};

// Null: not one of them.
const CompressedFormat* compressed_format(GLenum internal);

// Bytes of an image of that size.
int64_t compressed_bytes(const CompressedFormat& format, int width, int height);

// All compressed internal formats, those with palettes too.
std::span<const GLenum> compressed_formats();

// compressed_etc1.cpp, compressed_s3tc.cpp, compressed_pvrtc.cpp
void decode_etc1(const uint8_t* data, const DecodeTarget& to);
void decode_dxt1_rgb(const uint8_t* data, const DecodeTarget& to);
void decode_dxt1_rgba(const uint8_t* data, const DecodeTarget& to);
void decode_dxt3(const uint8_t* data, const DecodeTarget& to);
void decode_dxt5(const uint8_t* data, const DecodeTarget& to);
void decode_pvrtc2_rgb(const uint8_t* data, const DecodeTarget& to);
void decode_pvrtc2_rgba(const uint8_t* data, const DecodeTarget& to);
void decode_pvrtc4_rgb(const uint8_t* data, const DecodeTarget& to);
void decode_pvrtc4_rgba(const uint8_t* data, const DecodeTarget& to);

// The compressed palettes of 3.7.4: their data begins with the palette.
struct Palette {
  int index_bits = 0;  // 0: not a palette format
  GLenum format = 0, type = 0;
};

inline Palette palette_of(GLenum internal) {
  if (internal < GL_PALETTE4_RGB8_OES || internal > GL_PALETTE8_RGB5_A1_OES) return {};
  const GLenum kind = (internal - GL_PALETTE4_RGB8_OES) % 5;
  static constexpr GLenum kTypes[5] = {GL_UNSIGNED_BYTE, GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT_5_6_5,
                                       GL_UNSIGNED_SHORT_4_4_4_4, GL_UNSIGNED_SHORT_5_5_5_1};
  const bool rgb = kind == 0 || kind == 2;
  return {internal < GL_PALETTE8_RGB8_OES ? 4 : 8, static_cast<GLenum>(rgb ? GL_RGB : GL_RGBA),
          kTypes[kind]};
}

}  // namespace clearpipe::api
