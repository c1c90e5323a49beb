// See compressed_format.h.
// SPDX-License-Identifier: MIT
#include "api/compressed_format.h"

#include <algorithm>

namespace clearpipe::api {

namespace {

using Sizes = CompressedFamily::Sizes;
using Parts = CompressedFamily::Parts;

// OES_compressed_ETC1_RGB8_texture, EXT_compressed_ETC1_RGB8_sub_texture
constexpr CompressedFamily kEtc1{
    4, 4, 0, GL_INVALID_OPERATION, Sizes::kAll, Parts::kBlocksToTheEdge};
// EXT_texture_compression_dxt1
constexpr CompressedFamily kDxt1{
    4, 4, 0, GL_INVALID_OPERATION, Sizes::kAll, Parts::kBlocksOrAllOfIt};
// ANGLE_texture_compression_dxt3, ANGLE_texture_compression_dxt5
constexpr CompressedFamily kAngle{
    4, 4, 0, GL_INVALID_OPERATION, Sizes::kOneTwoOrBlocks, Parts::kBlocksOrAllOfIt};
// IMG_texture_compression_pvrtc
constexpr CompressedFamily kPvrtc2{8, 4, 2, GL_INVALID_VALUE, Sizes::kPowersOfTwo, Parts::kNone};
constexpr CompressedFamily kPvrtc4{4, 4, 2, GL_INVALID_VALUE, Sizes::kPowersOfTwo, Parts::kNone};

constexpr CompressedFormat kFormats[] = {
    {GL_ETC1_RGB8_OES, GL_RGB, kEtc1, 8, decode_etc1},
    {GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_RGB, kDxt1, 8, decode_dxt1_rgb},
    {GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, GL_RGBA, kDxt1, 8, decode_dxt1_rgba},
    {GL_COMPRESSED_RGBA_S3TC_DXT3_ANGLE, GL_RGBA, kAngle, 16, decode_dxt3},
    {GL_COMPRESSED_RGBA_S3TC_DXT5_ANGLE, GL_RGBA, kAngle, 16, decode_dxt5},
    {GL_COMPRESSED_RGB_PVRTC_4BPPV1_IMG, GL_RGB, kPvrtc4, 8, decode_pvrtc4_rgb},
    {GL_COMPRESSED_RGB_PVRTC_2BPPV1_IMG, GL_RGB, kPvrtc2, 8, decode_pvrtc2_rgb},
    {GL_COMPRESSED_RGBA_PVRTC_4BPPV1_IMG, GL_RGBA, kPvrtc4, 8, decode_pvrtc4_rgba},
    {GL_COMPRESSED_RGBA_PVRTC_2BPPV1_IMG, GL_RGBA, kPvrtc2, 8, decode_pvrtc2_rgba},
};

int64_t blocks(int texels, int of_a_block, int least) {
  return std::max((texels + of_a_block - 1) / of_a_block, least);
}

}  // namespace

const CompressedFormat* compressed_format(GLenum internal) {
  const auto* found =
      std::find_if(std::begin(kFormats), std::end(kFormats),
                   [internal](const CompressedFormat& f) { return f.internal == internal; });
  return found != std::end(kFormats) ? found : nullptr;
}

int64_t compressed_bytes(const CompressedFormat& format, int width, int height) {
  const CompressedFamily& f = format.family;
  return blocks(width, f.block_width, f.least_blocks) *
         blocks(height, f.block_height, f.least_blocks) * format.block_bytes;
}

std::span<const GLenum> compressed_formats() {
  static constexpr GLenum kAll[] = {
      GL_PALETTE4_RGB8_OES,
      GL_PALETTE4_RGBA8_OES,
      GL_PALETTE4_R5_G6_B5_OES,
      GL_PALETTE4_RGBA4_OES,
      GL_PALETTE4_RGB5_A1_OES,
      GL_PALETTE8_RGB8_OES,
      GL_PALETTE8_RGBA8_OES,
      GL_PALETTE8_R5_G6_B5_OES,
      GL_PALETTE8_RGBA4_OES,
      GL_PALETTE8_RGB5_A1_OES,
      GL_ETC1_RGB8_OES,
      GL_COMPRESSED_RGB_S3TC_DXT1_EXT,
      GL_COMPRESSED_RGBA_S3TC_DXT1_EXT,
      GL_COMPRESSED_RGBA_S3TC_DXT3_ANGLE,
      GL_COMPRESSED_RGBA_S3TC_DXT5_ANGLE,
      GL_COMPRESSED_RGB_PVRTC_4BPPV1_IMG,
      GL_COMPRESSED_RGB_PVRTC_2BPPV1_IMG,
      GL_COMPRESSED_RGBA_PVRTC_4BPPV1_IMG,
      GL_COMPRESSED_RGBA_PVRTC_2BPPV1_IMG,
  };
  return kAll;
}

}  // namespace clearpipe::api
