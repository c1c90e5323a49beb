// See pixel_layout.h.
// SPDX-License-Identifier: MIT
#include "icd/pixel_layout.h"

#include <cstring>

#include "pipeline/colour_format.h"

namespace clearpipe::icd {

namespace {

// Rounded to the nearest value of so many bits, and back to 8, as surfaces of that format hold it.
uint32_t narrow(uint32_t value, int bits) {
  const uint32_t most = (1u << bits) - 1;
  return (value * most + 127) / 255;
}
uint32_t widen(uint32_t value, int bits) {
  if (bits <= 8) return pipeline::widen_component(value, bits);
  const uint32_t most = (1u << bits) - 1;
  return (value * 255 + most / 2) / most;
}

template <typename Pixel>
void narrow_row(const PixelLayout& layout, const uint32_t* from, size_t count, void* to) {
  auto* out = static_cast<uint8_t*>(to);
  for (size_t i = 0; i < count; ++i) {
    uint32_t pixel = 0;
    for (int c = 0; c < 4; ++c) {
      const Component& component = layout.rgba[static_cast<size_t>(c)];
      if (component.bits == 0) continue;
      pixel |= narrow(from[i] >> (8 * c) & 255, component.bits) << component.shift;
    }
    const auto stored = static_cast<Pixel>(pixel);
    std::memcpy(out + i * sizeof(Pixel), &stored, sizeof(Pixel));
  }
}

template <typename Pixel>
void widen_row(const PixelLayout& layout, const void* from, size_t count, uint32_t* to) {
  const auto* in = static_cast<const uint8_t*>(from);
  for (size_t i = 0; i < count; ++i) {
    Pixel stored;
    std::memcpy(&stored, in + i * sizeof(Pixel), sizeof(Pixel));
    uint32_t pixel = layout.rgba[3].bits == 0 ? 0xff000000u : 0;
    for (int c = 0; c < 4; ++c) {
      const Component& component = layout.rgba[static_cast<size_t>(c)];
      if (component.bits == 0) continue;
      const uint32_t value = static_cast<uint32_t>(stored) >> component.shift;
      pixel |= widen(value & ((1u << component.bits) - 1), component.bits) << (8 * c);
    }
    to[i] = pixel;
  }
}

// Red and blue change places: the loop that compilers make vectors of.
void exchange_row(const uint32_t* from, size_t count, void* to, uint32_t keep) {
  auto* out = static_cast<uint8_t*>(to);
  for (size_t i = 0; i < count; ++i) {
    const uint32_t p = from[i];
    const uint32_t pixel = (p & keep) | (p >> 16 & 255) | (p & 255) << 16;
    std::memcpy(out + 4 * i, &pixel, 4);
  }
}

}  // namespace

void to_layout(const PixelLayout& layout, const uint32_t* from, size_t count, void* to) {
  if (layout == kBgra) return exchange_row(from, count, to, 0xff00ff00u);
  if (layout == kBgrx) return exchange_row(from, count, to, 0x0000ff00u);
  if (layout.bytes == 2) return narrow_row<uint16_t>(layout, from, count, to);
  narrow_row<uint32_t>(layout, from, count, to);
}

void from_layout(const PixelLayout& layout, const void* from, size_t count, uint32_t* to) {
  if (layout.bytes == 2) return widen_row<uint16_t>(layout, from, count, to);
  widen_row<uint32_t>(layout, from, count, to);
}

}  // namespace clearpipe::icd
