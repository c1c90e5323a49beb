// PVRTC images as they reach the surface, texel for texel against the equations of the Khronos Data
// Format Specification (PVRTC1).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <random>

#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

// One image, seen by its words as the specification numbers their bits.
class Oracle {
 public:
  Oracle(const std::vector<uint8_t>& data, int word_width, int width, int height)
      : data_(data), ww_(word_width), width_(width), height_(height) {}

  uint32_t texel(int x, int y, bool has_alpha) const {
    bool transparent = false;
    const int weight = weight_of(x, y, transparent);
    std::array<int, 4> result;
    for (int c = 0; c < 4; ++c) {
      result[c] = (image(0, c, x, y) * (8 - weight) + image(1, c, x, y) * weight) / 8;
    }
    if (transparent) result[3] = 0;
    if (!has_alpha) result[3] = 255;
    uint32_t packed = 0;
    for (int c = 0; c < 4; ++c) packed |= static_cast<uint32_t>(result[c]) << 8 * c;
    return packed;
  }

 private:
  static int mod(int a, int b) { return (a % b + b) % b; }
  static int floor_div(int a, int b) { return (a - mod(a, b)) / b; }
  int words_x() const { return width_ / ww_; }
  int words_y() const { return height_ / 4; }

  // Bit i of the offset of a word: the bits of Y and X in turns, then the rest of the longer one.
  uint64_t word(int wx, int wy) const {
    wx = mod(wx, words_x());
    wy = mod(wy, words_y());
    std::vector<int> offset_bits;
    for (int i = 0; (1 << i) < std::max(words_x(), words_y()); ++i) {
      if ((1 << i) < words_y()) offset_bits.push_back(wy >> i & 1);
      if ((1 << i) < words_x()) offset_bits.push_back(wx >> i & 1);
    }
    size_t offset = 0;
    for (size_t i = 0; i < offset_bits.size(); ++i) {
      offset |= static_cast<size_t>(offset_bits[i]) << i;
    }
    uint64_t value = 0;
    for (size_t i = 8; i-- > 0;) value = value << 8 | data_[8 * offset + i];
    return value;
  }
  static int field(uint64_t w, int high, int low) {
    return static_cast<int>(w >> low & ((uint64_t{1} << (high - low + 1)) - 1));
  }
  // Colour A (0) or B (1) as ARGB 4555.
  static int channel(uint64_t w, int which, int c) {
    const int base = which == 0 ? 32 : 48;
    const bool opaque = field(w, base + 15, base + 15) == 1;
    if (c == 3) return opaque ? 15 : field(w, base + 14, base + 12) * 2;
    if (opaque) {
      if (c == 0) return field(w, base + 14, base + 10);
      if (c == 1) return field(w, base + 9, base + 5);
      if (which == 1) return field(w, base + 4, base);
      const int blue = field(w, base + 4, base + 1);
      return blue * 2 + blue / 8;
    }
    if (c == 2 && which == 0) {
      const int blue = field(w, base + 3, base + 1);
      return blue * 4 + blue / 2;
    }
    const int low = base + (c == 0 ? 8 : c == 1 ? 4 : 0);
    const int v = field(w, low + 3, low);
    return v * 2 + v / 8;
  }
  int image(int which, int c, int x, int y) const {
    const int x_low = floor_div(x - ww_ / 2, ww_), y_low = floor_div(y - 2, 4);
    const int xr = x - ww_ / 2 - ww_ * x_low, yr = y - 2 - 4 * y_low;
    const int sum = channel(word(x_low, y_low), which, c) * (ww_ - xr) * (4 - yr) +
                    channel(word(x_low + 1, y_low), which, c) * xr * (4 - yr) +
                    channel(word(x_low, y_low + 1), which, c) * (ww_ - xr) * yr +
                    channel(word(x_low + 1, y_low + 1), which, c) * xr * yr;
    if (ww_ == 4) return c < 3 ? sum / 2 + sum / 64 : sum + sum / 16;
    return c < 3 ? sum / 4 + sum / 128 : sum / 2 + sum / 32;
  }
  int weight_of(int x, int y, bool& transparent) const {
    static constexpr int kWeights[4] = {0, 3, 5, 8};
    const uint64_t w = word(floor_div(x, ww_), floor_div(y, 4));
    const int dx = mod(x, ww_), dy = mod(y, 4);
    const bool m = field(w, 32, 32) == 1;
    if (ww_ == 4) {
      const int low = 2 * (4 * dy + dx), code = field(w, low + 1, low);
      transparent = m && code == 2;
      return !m ? kWeights[code] : code == 0 ? 0 : code == 3 ? 8 : 4;
    }
    if (!m) return field(w, 8 * dy + dx, 8 * dy + dx) ? 8 : 0;
    const bool bit0 = field(w, 0, 0) == 1, flag = field(w, 20, 20) == 1;
    if ((dx + dy) % 2 == 0) {
      const int low = 8 * dy + dx / 2 * 2, high = low + 1;
      const bool one_bit = (dx == 0 && dy == 0) || (bit0 && dx == 4 && dy == 2);
      return one_bit ? 8 * field(w, high, high) : kWeights[field(w, high, low)];
    }
    bool unused;
    const auto at = [&](int i, int j) { return weight_of(x + i, y + j, unused); };
    if (!bit0) return (at(-1, 0) + at(0, -1) + at(1, 0) + at(0, 1) + 2) / 4;
    return flag ? (at(0, -1) + at(0, 1) + 1) / 2 : (at(-1, 0) + at(1, 0) + 1) / 2;
  }

  const std::vector<uint8_t>& data_;
  const int ww_, width_, height_;
};

struct Format {
  GLenum internal;
  int word_width;
  bool has_alpha;
  int least_width() const { return 2 * word_width; }
  size_t bytes(int width, int height) const {
    return static_cast<size_t>(std::max(width, least_width()) * std::max(height, 8)) *
           (word_width == 4 ? 4 : 2) / 8;
  }
};
const Format kFormats[] = {{GL_COMPRESSED_RGB_PVRTC_4BPPV1_IMG, 4, false},
                           {GL_COMPRESSED_RGBA_PVRTC_4BPPV1_IMG, 4, true},
                           {GL_COMPRESSED_RGB_PVRTC_2BPPV1_IMG, 8, false},
                           {GL_COMPRESSED_RGBA_PVRTC_2BPPV1_IMG, 8, true}};

class PvrtcTextures : public CallTest {
 protected:
  void SetUp() override {
    CallTest::SetUp();
    target_ = make_target(64, 64);
    make_current(context_, target_, target_);
    one_colour_texture(0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
  std::vector<uint8_t> random_words(const Format& f, int width, int height) {
    std::vector<uint8_t> data(f.bytes(width, height));
    for (uint8_t& byte : data) byte = static_cast<uint8_t>(random_() >> 24);
    return data;
  }
  static GLenum give(const Format& f, int width, int height, const std::vector<uint8_t>& data) {
    glCompressedTexImage2D(GL_TEXTURE_2D, 0, f.internal, width, height, 0,
                           static_cast<GLsizei>(data.size()), data.data());
    return glGetError();
  }
  static std::vector<uint32_t> expected(const Format& f, int width, int height,
                                        const std::vector<uint8_t>& data) {
    const Oracle oracle(data, f.word_width, std::max(width, f.least_width()), std::max(height, 8));
    std::vector<uint32_t> texels;
    for (int i = 0; i < width * height; ++i) {
      texels.push_back(oracle.texel(i % width, i / width, f.has_alpha));
    }
    return texels;
  }
  static std::vector<uint32_t> drawn(GLsizei width, GLsizei height) {
    glViewport(0, 0, width, height);
    draw_quad();
    std::vector<uint32_t> pixels(static_cast<size_t>(width * height));
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
  }
  std::mt19937 random_{6};
};

TEST_F(PvrtcTextures, EveryTexelIsWhatItsWordsSay) {
  constexpr int kSizes[][2] = {{64, 64}, {64, 16}, {16, 64}, {32, 8}, {8, 32}, {8, 8},
                               {16, 8},  {4, 4},   {2, 16},  {64, 1}, {1, 1}};
  for (const Format& f : kFormats) {
    for (const auto& [width, height] : kSizes) {
      for (int i = 0; i < 6; ++i) {
        const std::vector<uint8_t> data = random_words(f, width, height);
        ASSERT_EQ(give(f, width, height, data), GLenum{GL_NO_ERROR});
        ASSERT_EQ(drawn(width, height), expected(f, width, height, data))
            << std::hex << f.internal << std::dec << " " << width << "x" << height;
      }
    }
  }
}

TEST_F(PvrtcTextures, TheWholeImageIsGivenAnew) {
  for (const Format& f : kFormats) {
    give(f, 16, 16, random_words(f, 16, 16));
    const std::vector<uint8_t> data = random_words(f, 16, 16);
    const auto part = [&](int x, int y, int width, int height, size_t size) {
      glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, x, y, width, height, f.internal,
                                static_cast<GLsizei>(size), data.data());
      return glGetError();
    };
    EXPECT_EQ(part(0, 0, 16, 16, data.size()), GLenum{GL_NO_ERROR});
    EXPECT_EQ(drawn(16, 16), expected(f, 16, 16, data));
  }
}

}  // namespace
}  // namespace clearpipe::api
