// The implementation-dependent values of tables 6.26 to 6.29, in one place.
// SPDX-License-Identifier: MIT
#pragma once

#include "pipeline/state.h"

namespace clearpipe::api {

inline constexpr int kTextureUnits = pipeline::kMaxTextureUnits;
inline constexpr int kLights = pipeline::kMaxLights;
inline constexpr int kClipPlanes = pipeline::kMaxClipPlanes;
inline constexpr int kModelviewStackDepth = 32;
inline constexpr int kProjectionStackDepth = 32;
inline constexpr int kTextureStackDepth = 10;
inline constexpr int kMaxTextureSize = 4096;
inline constexpr int kTextureLevels = 13;  // 4096 down to 1
inline constexpr int kMaxViewport = 8192;
inline constexpr float kMaxPointSize = 255;
inline constexpr float kMaxLineWidth = 255;
inline constexpr int kSubpixelBits = 8;

}  // namespace clearpipe::api
