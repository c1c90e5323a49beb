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
inline constexpr int kMaxTextureSize = 16384;
inline constexpr int kTextureLevels = 15;  // 16384 down to 1
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
inline constexpr int kSubpixelBits = 8;

}  // namespace clearpipe::api
