// The implementation-dependent values of tables 6.20 to 6.22, in one place.
// SPDX-License-Identifier: MIT
#pragma once

#include "pipeline/raster/samples.h"
#include "pipeline/state.h"

namespace clearpipe::api {

inline constexpr int kTextureUnits = pipeline::kMaxTextureUnits;
inline constexpr int kLights = pipeline::kMaxLights;
inline constexpr int kClipPlanes = pipeline::kMaxClipPlanes;
inline constexpr int kModelviewStackDepth = 32;
inline constexpr int kProjectionStackDepth = 32;
inline constexpr int kTextureStackDepth = 10;
inline constexpr int kPaletteMatrices = pipeline::kPaletteMatrices;  // OES_matrix_palette
inline constexpr int kVertexUnits = pipeline::kVertexUnits;
inline constexpr int kMaxTextureSize = 16384;
inline constexpr int kMaxCubeMapSize = 16384;
inline constexpr int kTextureLevels = pipeline::kMaxLevels;
// The levels of a mipmap whose base level has that longer side.
constexpr int longest_mipmap(int size) {
  int levels = 1;
  for (; size > 1; size /= 2) ++levels;
  return levels;
}
inline constexpr int kMaxRenderbufferSize = 16384;
inline constexpr int kMaxSamples = pipeline::kSampleCount;
inline constexpr float kMaxTextureLodBias = 15;
inline constexpr float kMaxAnisotropy = 16;
inline constexpr int kMaxViewport = 16384;
inline constexpr float kMaxPointSize = 255;
inline constexpr float kMaxLineWidth = 255;
inline constexpr int kMaxDebugMessageLength = 4096;
inline constexpr int kMaxDebugLoggedMessages = 128;
inline constexpr int kMaxDebugGroups = 64;
inline constexpr int kMaxLabelLength = 256;
inline constexpr int kMaxServerWait = 1000000000;  // nanoseconds (APPLE_sync)
inline constexpr int kSubpixelBits = 8;

}  // namespace clearpipe::api
