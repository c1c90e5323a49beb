// Where the samples of a pixel are (3.2.1): the rotated grid that llvmpipe and Direct3D use for
// four samples, the same in every pixel.
//
// llvmpipe counts rows of a window-system surface from the top, so its places are mirrored here.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace clearpipe::pipeline {

inline constexpr int kSampleCount = 4;
inline constexpr uint8_t kAllSamples = (1 << kSampleCount) - 1;

struct SamplePlace {
  int32_t x, y;  // subpixels (raster/edge.h) from the pixel's centre, y upwards
};

inline constexpr SamplePlace kCentrePlace = {0, 0};
inline constexpr SamplePlace kSamplePlaces[kSampleCount] = {
    {-32, 96}, {96, 32}, {-96, -32}, {32, -96}};
inline constexpr int32_t kSampleReach = 96;  // no coordinate is larger

}  // namespace clearpipe::pipeline
