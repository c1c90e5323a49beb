// ETC1 (OES_compressed_ETC1_RGB8_texture): 64 bits for 4x4 texels, in two halves of one base colour
// each, to which every texel adds one of four amounts to all of its components.
// SPDX-License-Identifier: MIT
#include "api/compressed_blocks.h"
#include "api/pixel_format.h"

namespace clearpipe::api {

namespace {

// Table 3.17.2, the amounts of pixel indices 0 and 1; 2 and 3 are their negatives (table 3.17.3).
constexpr int kModifiers[8][2] = {{2, 8},   {5, 17},  {9, 29},   {13, 42},
                                  {18, 60}, {24, 80}, {33, 106}, {47, 183}};

constexpr int extend_4_bits(uint32_t v) { return static_cast<int>(v << 4 | v); }
constexpr int extend_5_bits(uint32_t v) { return static_cast<int>(v << 3 | v >> 2); }

// One component of both base colours, from the byte that holds it. In differential mode the second
// is the first plus a signed number of three bits; a sum out of range is undefined, here it wraps.
void base_component(uint8_t byte, bool differential, int& first, int& second) {
  if (differential) {
    const uint32_t base = byte >> 3u, delta = byte & 7u;
    first = extend_5_bits(base);
    second = extend_5_bits((base + delta - (delta < 4 ? 0 : 8)) & 31u);
  } else {
    first = extend_4_bits(byte >> 4u);
    second = extend_4_bits(byte & 15u);
  }
}

void decode_block(const uint8_t* block, BlockTexels& texels) {
  const bool differential = block[3] & 2, flipped = block[3] & 1;
  int base[2][3];
  for (int c = 0; c < 3; ++c) base_component(block[c], differential, base[0][c], base[1][c]);
  const int* modifiers[2] = {kModifiers[block[3] >> 5], kModifiers[block[3] >> 2 & 7]};
  const uint32_t high = static_cast<uint32_t>(block[4] << 8 | block[5]);
  const uint32_t low = static_cast<uint32_t>(block[6] << 8 | block[7]);
  for (int i = 0; i < 16; ++i) {
    // Indices go down the columns.
    const int x = i / 4, y = i % 4;
    const int half = (flipped ? y : x) / 2;
    const int amount = modifiers[half][low >> i & 1];
    const int add = high >> i & 1 ? -amount : amount;
    const auto component = [&](int c) {
      return static_cast<uint32_t>(std::clamp(base[half][c] + add, 0, 255));
    };
    texels[4 * y + x] = rgba(component(0), component(1), component(2), 255);
  }
}

}  // namespace

void decode_etc1(const uint8_t* data, const DecodeTarget& to) {
  decode_blocks<decode_block, 8>(data, to);
}

}  // namespace clearpipe::api
