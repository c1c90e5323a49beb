// PVRTC (IMG_texture_compression_pvrtc; the Khronos Data Format Specification describes it): two
// images of low resolution, A and B, are enlarged bilinearly, and a weight for each texel mixes
// them. A word of 64 bits has a colour of A and of B and the weights of 4x4 texels, or of 8x4 in
// the formats with 2 bits a texel. Words beyond an edge are those at the opposite edge.
// SPDX-License-Identifier: MIT
#include <array>
#include <bit>
#include <cstring>

#include "api/compressed_format.h"
#include "api/pixel_format.h"

namespace clearpipe::api {

namespace {

constexpr int kRows = 4;  // of texels in a word

// 5 bits each of red, green and blue, 4 of alpha.
using LowColour = std::array<int, 4>;

constexpr int bits(uint32_t word, int low, int count) {
  return static_cast<int>(word >> low & ((1u << count) - 1));
}
constexpr int three_to_five(int v) { return v << 2 | v >> 1; }
constexpr int four_to_five(int v) { return v << 1 | v >> 3; }

// The colours in the upper half of a word. A lacks the last bit of blue, where the mode stands.
LowColour colour_a(uint32_t w) {
  if (bits(w, 15, 1)) return {bits(w, 10, 5), bits(w, 5, 5), four_to_five(bits(w, 1, 4)), 15};
  return {four_to_five(bits(w, 8, 4)), four_to_five(bits(w, 4, 4)), three_to_five(bits(w, 1, 3)),
          bits(w, 12, 3) << 1};
}
LowColour colour_b(uint32_t w) {
  if (bits(w, 31, 1)) return {bits(w, 26, 5), bits(w, 21, 5), bits(w, 16, 5), 15};
  return {four_to_five(bits(w, 24, 4)), four_to_five(bits(w, 20, 4)), four_to_five(bits(w, 16, 4)),
          bits(w, 28, 3) << 1};
}

// The weight of B in eighths. With kTransparent alpha is zero, with the others the texel has none
// of its own and takes the mean of its neighbours'.
using Weight = uint8_t;
constexpr Weight kTransparent = 0x10, kFromAll = 0x20, kFromSides = 0x21, kFromEnds = 0x22;

class Pvrtc {
 public:
  // An image of at least two words in each direction.
  Pvrtc(const uint8_t* data, int texels_per_word, int width, int height)
      : columns_(texels_per_word),
        words_x_(std::max(width / columns_, 2)),
        words_y_(std::max(height / kRows, 2)),
        a_(static_cast<size_t>(words_x_ * words_y_)),
        b_(a_.size()),
        weights_(a_.size() * static_cast<size_t>(columns_ * kRows)) {
    for (int y = 0; y < words_y_; ++y) {
      for (int x = 0; x < words_x_; ++x) {
        uint32_t word[2];
        std::memcpy(word, data + 8 * place_of(x, y), sizeof word);
        static_assert(std::endian::native == std::endian::little);
        a_[index(x, y)] = colour_a(word[1]);
        b_[index(x, y)] = colour_b(word[1]);
        if (columns_ == 4) {
          unpack_four_bits(x, y, word[0], word[1] & 1);
        } else {
          unpack_two_bits(x, y, word[0], word[1] & 1);
        }
      }
    }
  }

  uint32_t texel(int x, int y) const {
    const Weight stored = weight_at(x, y);
    const int weight = stored == kTransparent ? 4 : mean_weight(x, y, stored);
    const LowColour a = enlarged(a_, x, y), b = enlarged(b_, x, y);
    const auto mixed = [&](size_t c) {
      return static_cast<uint32_t>((a[c] * (8 - weight) + b[c] * weight) / 8);
    };
    return rgba(mixed(0), mixed(1), mixed(2), stored == kTransparent ? 0 : mixed(3));
  }

 private:
  size_t index(int word_x, int word_y) const {
    return static_cast<size_t>(word_y * words_x_ + word_x);
  }

  // Words are stored with the bits of x and y in turns, those of y first, as far as both have some.
  size_t place_of(int x, int y) const {
    size_t place = 0;
    int shift = 0;
    for (; 1 << shift < std::min(words_x_, words_y_); ++shift) {
      place |= static_cast<size_t>((y >> shift & 1) | (x >> shift & 1) << 1) << 2 * shift;
    }
    return place | static_cast<size_t>((x | y) >> shift) << 2 * shift;
  }

  // Any texel's weight; the image repeats itself.
  const Weight& weight_at(int x, int y) const {
    const int width = words_x_ * columns_, height = words_y_ * kRows;
    return weights_[static_cast<size_t>((y & (height - 1)) * width + (x & (width - 1)))];
  }
  Weight& weight_in(int word_x, int word_y, int x, int y) {
    return weights_[static_cast<size_t>((word_y * kRows + y) * words_x_ * columns_ +
                                        word_x * columns_ + x)];
  }

  static constexpr Weight kPlain[4] = {0, 3, 5, 8};
  static constexpr Weight kPunchThrough[4] = {0, 4, kTransparent, 8};

  void unpack_four_bits(int word_x, int word_y, uint32_t data, bool punch_through) {
    for (int i = 0; i < 16; ++i) {
      const uint32_t code = data >> 2 * i & 3;
      weight_in(word_x, word_y, i % 4, i / 4) = punch_through ? kPunchThrough[code] : kPlain[code];
    }
  }

  // Either a bit for each texel, or two bits for each second one, like a chessboard. Then the
  // lowest bit says whether the others have the mean of all neighbours; if not, bit 20 says which
  // ones count. The texels whose bits serve for that have one left, which stands for both.
  void unpack_two_bits(int word_x, int word_y, uint32_t data, bool interpolated) {
    if (!interpolated) {
      for (int i = 0; i < 32; ++i) weight_in(word_x, word_y, i % 8, i / 8) = data >> i & 1 ? 8 : 0;
      return;
    }
    const Weight others = !(data & 1) ? kFromAll : data >> 20 & 1 ? kFromEnds : kFromSides;
    const auto double_bit = [&data](int low) {
      data = (data & ~(1u << low)) | (data >> (low + 1) & 1) << low;
    };
    if (data & 1) double_bit(20);
    double_bit(0);
    for (int y = 0; y < kRows; ++y) {
      for (int x = 0; x < 8; ++x) {
        Weight& weight = weight_in(word_x, word_y, x, y);
        weight = (x ^ y) & 1 ? others : kPlain[data >> 2 * (4 * y + x / 2) & 3];
      }
    }
  }

  int mean_weight(int x, int y, Weight stored) const {
    const auto vertical = [&] { return weight_at(x, y - 1) + weight_at(x, y + 1); };
    const auto horizontal = [&] { return weight_at(x - 1, y) + weight_at(x + 1, y); };
    switch (stored) {
      case kFromAll:
        return (vertical() + horizontal() + 2) / 4;
      case kFromSides:
        return (horizontal() + 1) / 2;
      case kFromEnds:
        return (vertical() + 1) / 2;
      default:
        return stored;
    }
  }

  // The colour of a low image at a texel, 8 bits a component. Colours lie at the centres of words.
  LowColour enlarged(const std::vector<LowColour>& image, int x, int y) const {
    const int width = words_x_ * columns_, height = words_y_ * kRows;
    const int from_x = (x - columns_ / 2) & (width - 1), from_y = (y - kRows / 2) & (height - 1);
    const int right = from_x % columns_, down = from_y % kRows;
    const int x0 = from_x / columns_, y0 = from_y / kRows;
    const int x1 = (x0 + 1) & (words_x_ - 1), y1 = (y0 + 1) & (words_y_ - 1);
    const LowColour &c00 = image[index(x0, y0)], &c10 = image[index(x1, y0)];
    const LowColour &c01 = image[index(x0, y1)], &c11 = image[index(x1, y1)];
    // 16 or 32 times the colour; with what follows the highest bits also stand for the lowest.
    const int extra = columns_ / 8;
    LowColour result;
    for (size_t c = 0; c < 4; ++c) {
      const int upper = c00[c] * (columns_ - right) + c10[c] * right;
      const int lower = c01[c] * (columns_ - right) + c11[c] * right;
      const int sum = upper * (kRows - down) + lower * down;
      result[c] = c < 3 ? (sum >> (1 + extra)) + (sum >> (6 + extra))
                        : (sum >> extra) + (sum >> (4 + extra));
    }
    return result;
  }

  int columns_, words_x_, words_y_;
  std::vector<LowColour> a_, b_;
  std::vector<Weight> weights_;
};

void decode(const uint8_t* data, int texels_per_word, uint32_t opaque, const DecodeTarget& to) {
  const Pvrtc image(data, texels_per_word, to.width, to.height);
  uint32_t* texel = to.level.texels.data();
  for (int y = 0; y < to.height; ++y) {
    for (int x = 0; x < to.width; ++x) *texel++ = image.texel(x, y) | opaque;
  }
}

}  // namespace

void decode_pvrtc4_rgb(const uint8_t* data, const DecodeTarget& to) {
  decode(data, 4, kOpaque, to);
}
void decode_pvrtc4_rgba(const uint8_t* data, const DecodeTarget& to) { decode(data, 4, 0, to); }
void decode_pvrtc2_rgb(const uint8_t* data, const DecodeTarget& to) {
  decode(data, 8, kOpaque, to);
}
void decode_pvrtc2_rgba(const uint8_t* data, const DecodeTarget& to) { decode(data, 8, 0, to); }

}  // namespace clearpipe::api
