// How a window system keeps pixels, and rows of ours in its layout and back.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace clearpipe::icd {

// Where a component is in a pixel; no bits: it is not there.
struct Component {
  int shift = 0, bits = 0;
  bool operator==(const Component&) const = default;
};

// Pixels of 2 or 4 bytes in the byte order of this machine.
struct PixelLayout {
  int bytes = 4;
  std::array<Component, 4> rgba{};
  bool operator==(const PixelLayout&) const = default;
};

// B, G, R and A or nothing in memory, as most window systems have it.
inline constexpr PixelLayout kBgra = {4, {{{16, 8}, {8, 8}, {0, 8}, {24, 8}}}};
inline constexpr PixelLayout kRgb565 = {2, {{{11, 5}, {5, 6}, {0, 5}, {0, 0}}}};
inline constexpr PixelLayout kBgrx = {4, {{{16, 8}, {8, 8}, {0, 8}, {0, 0}}}};

// `count` pixels of R | G<<8 | B<<16 | A<<24 in the layout; a component that it lacks is zero.
void to_layout(const PixelLayout& layout, const uint32_t* from, size_t count, void* to);

// And back; a component that it lacks is zero, alpha 255.
void from_layout(const PixelLayout& layout, const void* from, size_t count, uint32_t* to);

}  // namespace clearpipe::icd
