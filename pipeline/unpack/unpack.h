// Unpacking: pixels as an application lays them out in memory become the RGBA8 texels that images
// are made of (3.6.2, 3.7.1). Each layout is unpacked in one place, for images and palettes alike.
//
// Components of 8 bits stay as they are; those of fewer bits are 255 v / (2^n - 1), rounded to
// nearest. Colours that are not given are 0, alpha 255; luminance is red, green and blue (table
// 3.9).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace clearpipe::pipeline {

// Named from the first byte on; of those in 16 bits, from the highest bit on.
enum class UnpackLayout : uint8_t {
  kRgba8,
  kBgra8,
  kRgb8,
  kLuminanceAlpha8,
  kLuminance8,
  kAlpha8,
  kRgb565,
  kRgba4444,
  kRgba5551,
};

size_t bytes_of(UnpackLayout layout);

// `count` pixels that follow each other; neither memory need be aligned.
void unpack_pixels(UnpackLayout layout, const void* from, size_t count, uint32_t* to);

// Rows of pixels, each `row_bytes` behind the one before, and of texels, each `row_texels` behind;
// large ones on all cores.
struct UnpackRectangle {
  const void* from = nullptr;
  size_t row_bytes = 0;
  int width = 0, height = 0;
  uint32_t* to = nullptr;
  size_t row_texels = 0;
};
void unpack_rectangle(UnpackLayout layout, const UnpackRectangle& rectangle);

}  // namespace clearpipe::pipeline
