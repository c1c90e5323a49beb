// See compressed_format.h.
// SPDX-License-Identifier: MIT
#include "api/compressed_format.h"

#include <algorithm>

namespace clearpipe::api {

namespace {

constexpr CompressedFormat kFormats[] = {
    // OES_compressed_ETC1_RGB8_texture, EXT_compressed_ETC1_RGB8_sub_texture
    {GL_ETC1_RGB8_OES, GL_RGB, 8, ImageSizes::kAll, ImageParts::kBlocksToTheEdge, decode_etc1},
    // EXT_texture_compression_dxt1
    {GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_RGB, 8, ImageSizes::kAll, ImageParts::kBlocksOrAllOfIt,
     decode_dxt1_rgb},
    {GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, GL_RGBA, 8, ImageSizes::kAll, ImageParts::kBlocksOrAllOfIt,
     decode_dxt1_rgba},
    // ANGLE_texture_compression_dxt3, ANGLE_texture_compression_dxt5
    {GL_COMPRESSED_RGBA_S3TC_DXT3_ANGLE, GL_RGBA, 16, ImageSizes::kOneTwoOrBlocks,
     ImageParts::kBlocksOrAllOfIt, decode_dxt3},
    {GL_COMPRESSED_RGBA_S3TC_DXT5_ANGLE, GL_RGBA, 16, ImageSizes::kOneTwoOrBlocks,
     ImageParts::kBlocksOrAllOfIt, decode_dxt5},
};

}  // namespace

const CompressedFormat* compressed_format(GLenum internal) {
  const auto* found =
      std::find_if(std::begin(kFormats), std::end(kFormats),
                   [internal](const CompressedFormat& f) { return f.internal == internal; });
  return found != std::end(kFormats) ? found : nullptr;
}

int64_t compressed_bytes(const CompressedFormat& format, int width, int height) {
  return int64_t{(width + 3) / 4} * ((height + 3) / 4) * format.block_bytes;
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
  };
  return kAll;
}

}  // namespace clearpipe::api
