// Colours of fewer than 8 bits a component. A buffer holds RGBA8 all the same, so that reading,
// sampling, blending and presenting know nothing of formats: of each component it holds the bits
// that the format has, and below them the same bits again, which is the value that they stand for
// as 8 bits. What is stored is truncated (4.1.8, dithering disabled, as in the reference, which
// never dithers); clear colours are rounded to nearest.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace clearpipe::pipeline {

// kRgb8 is that of programs alone, for buffers without alpha: alpha is stored as 255, so that they
// replace whole pixels.
enum class ColourFormat : uint8_t { kRgba8, kRgb8, kRgb565, kRgb5A1, kRgba4 };

// The bits of red, green, blue and alpha; alpha may be absent besides (ColourBuffer::has_alpha).
constexpr std::array<int, 4> component_bits(ColourFormat format) {
  switch (format) {
    case ColourFormat::kRgb565:
      return {5, 6, 5, 8};
    case ColourFormat::kRgb5A1:
      return {5, 5, 5, 1};
    case ColourFormat::kRgba4:
      return {4, 4, 4, 4};
    case ColourFormat::kRgba8:
    case ColourFormat::kRgb8:
      break;
  }
  return {8, 8, 8, 8};
}

// A value of so many bits as 8: its bits, repeated.
constexpr uint32_t widen_component(uint32_t value, int bits) {
  uint32_t wide = value << (8 - bits);
  for (int have = bits; have < 8; have *= 2) wide |= wide >> have;
  return wide;
}

// Truncation as masks of a packed pixel: bits that stay, and bits that are those 4, 5 or 6 places
// above them; where a component has one bit, all of it is that bit, the highest of the pixel. Bits
// of an absent alpha are set.
struct Truncation {
  uint32_t keep = 0, from4 = 0, from5 = 0, from6 = 0, from_top = 0, set = 0;
};
constexpr Truncation truncation_of(ColourFormat format) {
  const std::array<int, 4> bits = component_bits(format);
  Truncation masks;
  if (format == ColourFormat::kRgb8) masks.set = 0xff000000u;
  for (size_t c = 0; c < 4; ++c) {
    const uint32_t low = (1u << (8 - bits[c])) - 1, shift = static_cast<uint32_t>(8 * c);
    if (bits[c] == 1) {
      masks.from_top |= 255u << shift;
      continue;
    }
    masks.keep |= (255u & ~low) << shift;
    (bits[c] == 4 ? masks.from4 : bits[c] == 5 ? masks.from5 : masks.from6) |= low << shift;
  }
  return masks;
}

constexpr uint32_t truncate(ColourFormat format, uint32_t pixel) {
  if (format == ColourFormat::kRgba8) return pixel;
  const Truncation t = truncation_of(format);
  const uint32_t top = pixel >> 31 != 0 ? t.from_top : 0;
  return (pixel & t.keep) | (pixel >> 4 & t.from4) | (pixel >> 5 & t.from5) |
         (pixel >> 6 & t.from6) | top | t.set;
}

// A component in [0, 1], rounded to what the format has.
inline uint32_t round_component(ColourFormat format, size_t c, float value) {
  const int bits = component_bits(format)[c];
  const auto most = static_cast<float>((1 << bits) - 1);
  return widen_component(static_cast<uint32_t>(std::nearbyint(value * most)), bits);
}

}  // namespace clearpipe::pipeline
