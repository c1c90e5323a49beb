// S3TC (appendix of EXT_texture_compression_s3tc): two colours of 5, 6 and 5 bits and two bits a
// texel that choose among them and those between; with DXT3 four bits of alpha a texel, with DXT5
// two alphas and three bits a texel. What lies between is rounded to 8 bits once.
// SPDX-License-Identifier: MIT
#include "api/compressed_blocks.h"
#include "api/pixel_format.h"

namespace clearpipe::api {

namespace {

struct Rgb565 {
  explicit Rgb565(const uint8_t* p) : packed(p[0] | static_cast<uint32_t>(p[1]) << 8) {}
  uint32_t packed;
};

// (a * first + b * second) / (a + b), opaque.
uint32_t between(Rgb565 first, Rgb565 second, uint32_t a, uint32_t b) {
  const auto component = [&](uint32_t shift, uint32_t max) {
    const uint32_t sum = a * (first.packed >> shift & max) + b * (second.packed >> shift & max);
    const uint32_t one = (a + b) * max;
    return (sum * 510 + one) / (2 * one);
  };
  return rgba(component(11, 31), component(5, 63), component(0, 31), 255);
}

// The colours of the four codes: with three colours, the last is black, and transparent if wanted.
void palette_of_block(const uint8_t* block, bool may_have_three, uint32_t last,
                      uint32_t (&palette)[4]) {
  const Rgb565 first(block), second(block + 2);
  palette[0] = between(first, second, 1, 0);
  palette[1] = between(first, second, 0, 1);
  if (may_have_three && first.packed <= second.packed) {
    palette[2] = between(first, second, 1, 1);
    palette[3] = last;
  } else {
    palette[2] = between(first, second, 2, 1);
    palette[3] = between(first, second, 1, 2);
  }
}

void decode_colours(const uint8_t* block, bool may_have_three, uint32_t last, BlockTexels& texels) {
  uint32_t palette[4];
  palette_of_block(block, may_have_three, last, palette);
  for (int i = 0; i < 16; ++i) texels[i] = palette[block[4 + i / 4] >> 2 * (i % 4) & 3];
}

template <uint32_t kLast>
void decode_dxt1_block(const uint8_t* block, BlockTexels& texels) {
  decode_colours(block, true, kLast, texels);
}

void set_alpha(uint32_t& texel, uint32_t alpha) { texel = (texel & ~kOpaque) | alpha << 24; }

void decode_dxt3_block(const uint8_t* block, BlockTexels& texels) {
  decode_colours(block + 8, false, 0, texels);
  for (int i = 0; i < 16; ++i) set_alpha(texels[i], 17 * (block[i / 2] >> 4 * (i % 2) & 15u));
}

// Eight alphas, or six and 0 and 1 when the first is not the larger one.
void alphas_of_block(const uint8_t* block, uint32_t (&alphas)[8]) {
  const uint32_t first = block[0], second = block[1], steps = first > second ? 7 : 5;
  alphas[0] = first;
  alphas[1] = second;
  for (uint32_t i = 1; i < steps; ++i) {
    alphas[i + 1] = (2 * ((steps - i) * first + i * second) + steps) / (2 * steps);
  }
  if (steps == 5) {
    alphas[6] = 0;
    alphas[7] = 255;
  }
}

void decode_dxt5_block(const uint8_t* block, BlockTexels& texels) {
  decode_colours(block + 8, false, 0, texels);
  uint32_t alphas[8];
  alphas_of_block(block, alphas);
  uint64_t codes = 0;
  for (int i = 0; i < 6; ++i) codes |= uint64_t{block[2 + i]} << 8 * i;
  for (int i = 0; i < 16; ++i) set_alpha(texels[i], alphas[codes >> 3 * i & 7]);
}

}  // namespace

void decode_dxt1_rgb(const uint8_t* data, const DecodeTarget& to) {
  decode_blocks<decode_dxt1_block<kOpaque>, 8>(data, to);
}

void decode_dxt1_rgba(const uint8_t* data, const DecodeTarget& to) {
  decode_blocks<decode_dxt1_block<0>, 8>(data, to);
}

void decode_dxt3(const uint8_t* data, const DecodeTarget& to) {
  decode_blocks<decode_dxt3_block, 16>(data, to);
}

void decode_dxt5(const uint8_t* data, const DecodeTarget& to) {
  decode_blocks<decode_dxt5_block, 16>(data, to);
}

}  // namespace clearpipe::api
