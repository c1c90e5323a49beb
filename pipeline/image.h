// Texture images as the fragment stages sample them: every level RGBA8, rows from t = 0 upwards.
//
// Whatever format an application uploads, api/texture_upload.cpp expands it to RGBA8 once
// (luminance to (L,L,L,1), alpha to (0,0,0,A)), so that a texel is one 32-bit load. An image is
// shared by the texture object and by each pending frame that samples it; it is changed in place
// only when no frame holds it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace clearpipe::pipeline {

// Texels are R | G<<8 | B<<16 | A<<24 in little-endian memory order R,G,B,A.
struct ImageLevel {
  int width = 0;  // texels
  int height = 0;
  std::vector<uint32_t> texels;  // row-major, width * height
};

inline constexpr int kMaxLevels = 15;  // of 16384 texels, down to 1
inline constexpr int kCubeFaces = 6;

// One image with its levels of detail; absent ones have width 0. Those of a cube map's faces follow
// each other in the order +x -x +y -y +z -z: level i of face f is levels[kMaxLevels * f + i].
struct Image {
  std::vector<ImageLevel> levels;
};

using ImageRef = std::shared_ptr<const Image>;

}  // namespace clearpipe::pipeline
