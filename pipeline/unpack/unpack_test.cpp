// Unpacking against the formulas of unpack.h: every value of every layout, and every number of
// pixels up to some vectors.
// SPDX-License-Identifier: MIT
#include "pipeline/unpack/unpack.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

namespace clearpipe::pipeline {
namespace {

constexpr UnpackLayout kLayouts[] = {
    UnpackLayout::kRgba8,           UnpackLayout::kBgra8,      UnpackLayout::kRgb8,
    UnpackLayout::kLuminanceAlpha8, UnpackLayout::kLuminance8, UnpackLayout::kAlpha8,
    UnpackLayout::kRgb565,          UnpackLayout::kRgba4444,   UnpackLayout::kRgba5551,
};

uint32_t rgba(uint32_t r, uint32_t g, uint32_t b, uint32_t a) {
  return r | g << 8 | b << 16 | a << 24;
}

uint32_t scaled(uint32_t value, uint32_t max) {
  return static_cast<uint32_t>(std::lround(255.0 * value / max));
}

uint32_t expected(UnpackLayout layout, const uint8_t* p) {
  const uint32_t s = p[0] | static_cast<uint32_t>(p[1]) << 8;
  switch (layout) {
    case UnpackLayout::kRgba8:
      return rgba(p[0], p[1], p[2], p[3]);
    case UnpackLayout::kBgra8:
      return rgba(p[2], p[1], p[0], p[3]);
    case UnpackLayout::kRgb8:
      return rgba(p[0], p[1], p[2], 255);
    case UnpackLayout::kLuminanceAlpha8:
      return rgba(p[0], p[0], p[0], p[1]);
    case UnpackLayout::kLuminance8:
      return rgba(p[0], p[0], p[0], 255);
    case UnpackLayout::kAlpha8:
      return rgba(0, 0, 0, p[0]);
    case UnpackLayout::kRgb565:
      return rgba(scaled(s >> 11, 31), scaled(s >> 5 & 63, 63), scaled(s & 31, 31), 255);
    case UnpackLayout::kRgba4444:
      return rgba(scaled(s >> 12, 15), scaled(s >> 8 & 15, 15), scaled(s >> 4 & 15, 15),
                  scaled(s & 15, 15));
    case UnpackLayout::kRgba5551:
      return rgba(scaled(s >> 11, 31), scaled(s >> 6 & 31, 31), scaled(s >> 1 & 31, 31),
                  scaled(s & 1, 1));
  }
  return 0;
}

// Bytes among which is every pair of neighbours, with room for a pixel behind them.
std::vector<uint8_t> many_bytes(size_t count) {
  std::vector<uint8_t> bytes(count + 4);
  uint32_t state = 1;
  for (uint8_t& byte : bytes)
    byte = static_cast<uint8_t>((state = state * 1664525 + 1013904223) >> 24);
  return bytes;
}

TEST(Unpack, EveryValueOfSixteenBitsIsWhatTheFormulaSays) {
  std::vector<uint16_t> values(65536);
  for (size_t i = 0; i < values.size(); ++i) values[i] = static_cast<uint16_t>(i);
  std::vector<uint8_t> bytes(2 * values.size() + 4);
  std::memcpy(bytes.data(), values.data(), 2 * values.size());
  for (const UnpackLayout layout : kLayouts) {
    const size_t size = bytes_of(layout), count = 2 * values.size() / size;
    std::vector<uint32_t> texels(count);
    unpack_pixels(layout, bytes.data(), count, texels.data());
    for (size_t i = 0; i < count; ++i) {
      ASSERT_EQ(texels[i], expected(layout, bytes.data() + i * size))
          << "layout " << static_cast<int>(layout) << ", pixel " << i;
    }
  }
}

TEST(Unpack, EveryNumberOfPixelsAtAnyAddressStaysWithinItsTexels) {
  constexpr size_t kMost = 200;
  constexpr uint32_t kUntouched = 0x5a5a5a5a;
  for (const UnpackLayout layout : kLayouts) {
    const size_t size = bytes_of(layout);
    for (size_t count = 0; count <= kMost; ++count) {
      // Nothing behind the last pixel may be read: a sanitizer sees it.
      const std::vector<uint8_t> source = many_bytes(kMost * 4 + 1);
      const std::vector<uint8_t> bytes(source.begin() + 1,
                                       source.begin() + 1 + static_cast<ptrdiff_t>(count * size));
      std::vector<uint32_t> texels(count + 2, kUntouched);
      unpack_pixels(layout, bytes.data(), count, texels.data() + 1);
      ASSERT_EQ(texels.front(), kUntouched);
      ASSERT_EQ(texels.back(), kUntouched);
      for (size_t i = 0; i < count; ++i) {
        ASSERT_EQ(texels[i + 1], expected(layout, source.data() + 1 + i * size))
            << "layout " << static_cast<int>(layout) << ", pixel " << i << " of " << count;
      }
    }
  }
}

// Small ones by the calling thread, large ones by all.
TEST(Unpack, RectanglesHaveRowsOfTheirOwn) {
  for (const int width : {3, 77, 900}) {
    const int height = 400;
    const size_t row_bytes = static_cast<size_t>(width) * 2 + 3;
    const size_t row_texels = static_cast<size_t>(width) + 5;
    const std::vector<uint8_t> bytes = many_bytes(row_bytes * height);
    std::vector<uint32_t> texels(row_texels * height, 7);
    unpack_rectangle(UnpackLayout::kRgb565,
                     {bytes.data(), row_bytes, width, height, texels.data(), row_texels});
    for (int y = 0; y < height; ++y) {
      const uint8_t* from = bytes.data() + static_cast<size_t>(y) * row_bytes;
      const uint32_t* to = texels.data() + static_cast<size_t>(y) * row_texels;
      for (int x = 0; x < width; ++x) {
        ASSERT_EQ(to[x], expected(UnpackLayout::kRgb565, from + 2 * x)) << x << ", " << y;
      }
      for (size_t x = static_cast<size_t>(width); x < row_texels; ++x) ASSERT_EQ(to[x], 7u);
    }
  }
}

}  // namespace
}  // namespace clearpipe::pipeline
