// Compressed images as they reach the surface, texel for texel against the equations of their
// extensions: ETC1 and S3TC; parts of them, and the errors of both. PVRTC is in pvrtc_test.cpp.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "api/call_fixture.h"
#include "api/texture_tokens.h"

namespace clearpipe::api {
namespace {

struct Colour {
  double r = 0, g = 0, b = 0, a = 1;
  uint32_t packed() const {
    // Halves go up, also where sums of doubles are a little less.
    const auto byte = [](double v) { return static_cast<uint32_t>(std::lround(v * 255 + 1e-9)); };
    return byte(r) | byte(g) << 8 | byte(b) << 16 | byte(a) << 24;
  }
};

Colour mix(const Colour& x, const Colour& y, double a, double b) {
  return {(a * x.r + b * y.r) / (a + b), (a * x.g + b * y.g) / (a + b),
          (a * x.b + b * y.b) / (a + b), 1};
}

Colour unpack_565(uint32_t v) {
  return {(v >> 11) / 31.0, (v >> 5 & 63) / 63.0, (v & 31) / 31.0, 1};
}

// The appendix of EXT_texture_compression_dxt1, and of EXT_texture_compression_s3tc.
Colour s3tc_colour(const uint8_t* block, int x, int y, bool dxt1) {
  const uint32_t color0 = block[0] + block[1] * 256u, color1 = block[2] + block[3] * 256u;
  const uint32_t bits =
      block[4] + 256u * (block[5] + 256u * (block[6] + 256u * static_cast<uint32_t>(block[7])));
  const uint32_t code = bits >> (2 * (4 * y + x)) & 3;
  const Colour first = unpack_565(color0), second = unpack_565(color1);
  if (code < 2) return code == 0 ? first : second;
  if (dxt1 && color0 <= color1) return code == 2 ? mix(first, second, 1, 1) : Colour{0, 0, 0, 0};
  return code == 2 ? mix(first, second, 2, 1) : mix(first, second, 1, 2);
}

uint32_t dxt1_rgb(const uint8_t* block, int x, int y) {
  Colour colour = s3tc_colour(block, x, y, true);
  colour.a = 1;
  return colour.packed();
}

uint32_t dxt1_rgba(const uint8_t* block, int x, int y) {
  return s3tc_colour(block, x, y, true).packed();
}

uint64_t little_endian(const uint8_t* bytes, int count) {
  uint64_t value = 0;
  for (int i = count; i-- > 0;) value = value * 256 + bytes[i];
  return value;
}

uint32_t dxt3(const uint8_t* block, int x, int y) {
  Colour colour = s3tc_colour(block + 8, x, y, false);
  colour.a = static_cast<double>(little_endian(block, 8) >> (4 * (4 * y + x)) & 15) / 15.0;
  return colour.packed();
}

uint32_t dxt5(const uint8_t* block, int x, int y) {
  Colour colour = s3tc_colour(block + 8, x, y, false);
  const double alpha0 = block[0] / 255.0, alpha1 = block[1] / 255.0;
  const int code = static_cast<int>(little_endian(block + 2, 6) >> (3 * (4 * y + x)) & 7);
  if (code < 2) {
    colour.a = code == 0 ? alpha0 : alpha1;
  } else if (block[0] > block[1]) {
    colour.a = ((8 - code) * alpha0 + (code - 1) * alpha1) / 7;
  } else {
    colour.a = code == 6 ? 0 : code == 7 ? 1 : ((6 - code) * alpha0 + (code - 1) * alpha1) / 5;
  }
  return colour.packed();
}

// OES_compressed_ETC1_RGB8_texture, by the numbers of its bits.
class Etc1 {
 public:
  explicit Etc1(const uint8_t* q) {
    for (int i = 0; i < 8; ++i) word_ = 256 * word_ + q[i];
  }
  uint64_t word() const { return word_; }
  int bits(int high, int low) const {
    return static_cast<int>(word_ >> low & ((uint64_t{1} << (high - low + 1)) - 1));
  }
  int component(int c, int half) const {
    const int top = 63 - 8 * c;
    if (bits(33, 33) == 0) {
      const int v = half == 0 ? bits(top, top - 3) : bits(top - 4, top - 7);
      return v * 17;
    }
    int v = bits(top, top - 4);
    if (half == 1) v += delta(c);
    return v * 8 + v / 4;
  }
  // Whether the second base colour is in range; the block is undefined otherwise.
  bool defined() const {
    if (bits(33, 33) == 0) return true;
    for (int c = 0; c < 3; ++c) {
      const int sum = bits(63 - 8 * c, 59 - 8 * c) + delta(c);
      if (sum < 0 || sum > 31) return false;
    }
    return true;
  }
  uint32_t texel(int x, int y) const {
    static constexpr int kTable[8][4] = {
        {-8, -2, 2, 8},     {-17, -5, 5, 17},   {-29, -9, 9, 29},     {-42, -13, 13, 42},
        {-60, -18, 18, 60}, {-80, -24, 24, 80}, {-106, -33, 33, 106}, {-183, -47, 47, 183}};
    const int half = (bits(32, 32) == 1 ? y : x) < 2 ? 0 : 1;
    const int* table = kTable[half == 0 ? bits(39, 37) : bits(36, 34)];
    const int pixel = 4 * x + y;  // a, b, c, ...
    const int index = 2 * bits(16 + pixel, 16 + pixel) + bits(pixel, pixel);
    const int modifier = index == 3 ? table[0] : index == 2 ? table[1] : table[2 + index];
    uint32_t packed = 0xff000000u;
    for (int c = 0; c < 3; ++c) {
      packed |= static_cast<uint32_t>(std::clamp(component(c, half) + modifier, 0, 255)) << 8 * c;
    }
    return packed;
  }

 private:
  int delta(int c) const {
    const int v = bits(58 - 8 * c, 56 - 8 * c);
    return v < 4 ? v : v - 8;
  }
  uint64_t word_ = 0;
};

uint32_t etc1(const uint8_t* block, int x, int y) { return Etc1(block).texel(x, y); }

struct Format {
  GLenum internal;
  size_t block_bytes;
  uint32_t (*texel)(const uint8_t* block, int x, int y);
};
const Format kFormats[] = {{GL_ETC1_RGB8_OES, 8, etc1},
                           {GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 8, dxt1_rgb},
                           {GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, 8, dxt1_rgba},
                           {GL_COMPRESSED_RGBA_S3TC_DXT3_ANGLE, 16, dxt3},
                           {GL_COMPRESSED_RGBA_S3TC_DXT5_ANGLE, 16, dxt5}};

class Compressed : public CallTest {
 protected:
  void SetUp() override {
    CallTest::SetUp();
    one_colour_texture(0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
  std::vector<uint8_t> random_blocks(const Format& f, int width, int height) {
    std::vector<uint8_t> data(size_t(width + 3) / 4 * (size_t(height + 3) / 4) * f.block_bytes);
    for (uint8_t& byte : data) byte = static_cast<uint8_t>(random_() >> 24);
    if (f.internal != GL_ETC1_RGB8_OES) return data;
    for (size_t at = 0; at < data.size(); at += 8) {
      while (!Etc1(data.data() + at).defined()) {
        for (size_t i = at; i < at + 3; ++i) data[i] = static_cast<uint8_t>(random_() >> 24);
      }
    }
    return data;
  }
  static void decode(const Format& f, const std::vector<uint8_t>& data, int x, int y, int width,
                     int height, int stride, std::vector<uint32_t>& image) {
    const size_t row = size_t(width + 3) / 4 * f.block_bytes;
    for (int j = 0; j < height; ++j) {
      for (int i = 0; i < width; ++i) {
        const uint8_t* block = data.data() + row * size_t(j / 4) + f.block_bytes * size_t(i / 4);
        image[size_t((y + j) * stride + x + i)] = f.texel(block, i % 4, j % 4);
      }
    }
  }
  static void give(GLint level, const Format& f, int width, int height,
                   const std::vector<uint8_t>& data) {
    glCompressedTexImage2D(GL_TEXTURE_2D, level, f.internal, width, height, 0,
                           static_cast<GLsizei>(data.size()), data.data());
  }
  static void give_part(const Format& f, int x, int y, int width, int height,
                        const std::vector<uint8_t>& data) {
    glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, x, y, width, height, f.internal,
                              static_cast<GLsizei>(data.size()), data.data());
  }
  static std::vector<uint32_t> drawn(GLsizei width, GLsizei height) {
    glViewport(0, 0, width, height);
    draw_quad();
    std::vector<uint32_t> pixels(size_t(width * height));
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
  }
  std::mt19937 random_{5};
};

TEST_F(Compressed, EveryTexelIsWhatItsBlockSays) {
  for (const Format& f : kFormats) {
    for (const int size : {1, 2, 4, 8, 16}) {
      for (int i = 0; i < 60; ++i) {
        const int width = size, height = i % 2 == 0 ? size : 16;
        const std::vector<uint8_t> data = random_blocks(f, width, height);
        give(0, f, width, height, data);
        std::vector<uint32_t> expected(size_t(width * height));
        decode(f, data, 0, 0, width, height, width, expected);
        ASSERT_EQ(drawn(width, height), expected) << std::hex << f.internal << " " << size;
      }
    }
  }
  EXPECT_ERROR(GL_NO_ERROR);
}

// The examples in the text of OES_compressed_ETC1_RGB8_texture.
TEST_F(Compressed, Etc1Examples) {
  // R1' 28, dR2 -4; G1' 4, dG2 2; B1' 3, dB2 0; table 2 for both; differential.
  std::vector<uint8_t> block = {28 << 3 | 4, 4 << 3 | 2, 3 << 3, 2 << 5 | 2 << 2 | 2, 0, 0, 0, 0};
  give(0, kFormats[0], 4, 4, block);
  EXPECT_EQ(drawn(4, 4)[0], 0xff212af0u);  // (231, 33, 24) + 9
  EXPECT_EQ(drawn(4, 4)[3], 0xff213acfu);  // (198, 49, 24) + 9
  block[7] = 8;                            // pixel d: 29
  give(0, kFormats[0], 4, 4, block);
  EXPECT_EQ(drawn(4, 4)[12], 0xff353effu);  // 260 is 255
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(Compressed, PartsOfBlocks) {
  for (const Format& f : kFormats) {
    std::vector<uint32_t> expected(16 * 12);
    const std::vector<uint8_t> whole = random_blocks(f, 16, 12);
    give(0, f, 16, 12, whole);
    decode(f, whole, 0, 0, 16, 12, 16, expected);
    const std::vector<uint8_t> part = random_blocks(f, 8, 4);
    give_part(f, 4, 8, 8, 4, part);
    decode(f, part, 4, 8, 8, 4, 16, expected);
    EXPECT_EQ(drawn(16, 12), expected) << std::hex << f.internal;
    give_part(f, 8, 4, 0, 4, {});
    EXPECT_EQ(drawn(16, 12), expected);
    EXPECT_ERROR(GL_NO_ERROR);

    // Neither whole blocks nor what reaches the edge.
    for (const auto& [x, y, width, height] :
         std::vector<std::array<int, 4>>{{2, 0, 4, 4}, {0, 2, 4, 4}, {0, 0, 6, 4}, {0, 0, 4, 3}}) {
      give_part(f, x, y, width, height, random_blocks(f, width, height));
      EXPECT_ERROR(GL_INVALID_OPERATION) << std::hex << f.internal << " " << x << " " << width;
    }
    give_part(f, 12, 0, 8, 4, random_blocks(f, 8, 4));
    EXPECT_ERROR(GL_INVALID_VALUE);
    give_part(f, 0, -4, 4, 4, random_blocks(f, 4, 4));
    EXPECT_ERROR(GL_INVALID_VALUE);
    for (const int wrong : {-1, 1}) {
      std::vector<uint8_t> data = random_blocks(f, 4, 4);
      data.resize(data.size() + static_cast<size_t>(wrong));
      give_part(f, 0, 0, 4, 4, data);
      EXPECT_ERROR(GL_INVALID_VALUE);
    }
    for (const Format& other : kFormats) {
      if (other.internal == f.internal) continue;
      give_part(other, 0, 0, 4, 4, random_blocks(other, 4, 4));
      EXPECT_ERROR(GL_INVALID_OPERATION);
    }
    EXPECT_EQ(drawn(16, 12), expected) << std::hex << f.internal;
  }
}

// The last blocks of 10x6 reach past the edge. ETC1 takes them for themselves; DXT1 takes the whole
// width or height only, and the larger formats of ANGLE have no such images.
TEST_F(Compressed, PartsAtTheEdge) {
  for (const Format& f : kFormats) {
    const bool etc = f.block_bytes == 8 && f.internal == GL_ETC1_RGB8_OES;
    const std::vector<uint8_t> whole = random_blocks(f, 10, 6);
    give(0, f, 10, 6, whole);
    if (f.block_bytes == 16) {
      EXPECT_ERROR(GL_INVALID_OPERATION);
      continue;
    }
    std::vector<uint32_t> expected(10 * 6);
    decode(f, whole, 0, 0, 10, 6, 10, expected);
    const std::vector<uint8_t> corner = random_blocks(f, 2, 2);
    give_part(f, 8, 4, 2, 2, corner);
    EXPECT_ERROR(etc ? GL_NO_ERROR : GL_INVALID_OPERATION);
    if (etc) decode(f, corner, 8, 4, 2, 2, 10, expected);
    const std::vector<uint8_t> row = random_blocks(f, 10, 4);
    give_part(f, 0, 0, 10, 4, row);
    decode(f, row, 0, 0, 10, 4, 10, expected);
    EXPECT_EQ(drawn(10, 6), expected) << std::hex << f.internal;
    EXPECT_ERROR(GL_NO_ERROR);
  }
}

TEST_F(Compressed, LevelsAndGeneration) {
  for (const Format& f : kFormats) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    std::vector<uint8_t> last;
    for (GLint level = 0; level < 4; ++level) {
      last = random_blocks(f, 8 >> level, 8 >> level);
      give(level, f, 8 >> level, 8 >> level, last);
      // Nothing is generated: until the last level is there, the texture is incomplete.
      EXPECT_EQ(drawn(8, 8)[0] == kWhite, level < 3) << level;
    }
    EXPECT_EQ(drawn(1, 1)[0], f.texel(last.data(), 0, 0)) << std::hex << f.internal;
    give_part(f, 0, 0, 4, 4, random_blocks(f, 4, 4));
    EXPECT_EQ(drawn(1, 1)[0], f.texel(last.data(), 0, 0)) << std::hex << f.internal;
    EXPECT_ERROR(GL_NO_ERROR);
    // Levels of two formats are incomplete.
    const Format& other = kFormats[f.internal == GL_ETC1_RGB8_OES ? 1 : 0];
    give(3, other, 1, 1, random_blocks(other, 1, 1));
    EXPECT_EQ(drawn(8, 8)[0], kWhite);
    one_colour_texture(0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
}

TEST_F(Compressed, Errors) {
  const uint8_t data[64] = {};
  const auto image = [&](GLenum target, GLint level, const Format& f, int width, int height,
                         GLint border, size_t size) {
    glCompressedTexImage2D(target, level, f.internal, width, height, border,
                           static_cast<GLsizei>(size), data);
    return glGetError();
  };
  for (const Format& f : kFormats) {
    const size_t bytes = f.block_bytes;
    const GLenum t = GL_TEXTURE_2D, value = GL_INVALID_VALUE, operation = GL_INVALID_OPERATION;
    EXPECT_EQ(image(GL_TEXTURE, 0, f, 4, 4, 0, bytes), GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(image(t, 0, f, 4, 4, 1, bytes), operation);
    EXPECT_EQ(image(t, -1, f, 4, 4, 0, bytes), value);
    EXPECT_EQ(image(t, 15, f, 1, 1, 0, bytes), value);
    EXPECT_EQ(image(t, 0, f, -4, 4, 0, bytes), value);
    EXPECT_EQ(image(t, 0, f, 4, 16388, 0, bytes), value);
    EXPECT_EQ(image(t, 0, f, 4, 4, 0, bytes - 1), value);
    EXPECT_EQ(image(t, 0, f, 4, 4, 0, bytes + 1), value);
    EXPECT_EQ(image(t, 0, f, 8, 4, 0, bytes), value);
    for (const int size : {3, 5, 6, 7}) {
      const GLenum error = image(t, 1, f, size, 4, 0, bytes * (size > 4 ? 2 : 1));
      EXPECT_EQ(error, bytes == 16 ? operation : GLenum{GL_NO_ERROR}) << size;
    }
    EXPECT_EQ(image(t, 0, f, 0, 0, 0, 0), GLenum{GL_NO_ERROR});
    EXPECT_EQ(image(t, 0, f, 4, 4, 0, bytes), GLenum{GL_NO_ERROR});

    // No other command takes the format or changes the image.
    const bool s3tc = f.internal != GL_ETC1_RGB8_OES;
    glTexImage2D(t, 0, static_cast<GLint>(f.internal), 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, data);
    EXPECT_ERROR(s3tc ? GL_INVALID_OPERATION : GL_INVALID_VALUE);
    glCopyTexImage2D(t, 0, f.internal, 0, 0, 4, 4, 0);
    EXPECT_ERROR(s3tc ? GL_INVALID_OPERATION : GL_INVALID_ENUM);
    for (const GLenum format : {GL_RGB, GL_RGBA}) {
      glTexSubImage2D(t, 0, 0, 0, 1, 1, format, GL_UNSIGNED_BYTE, data);
      EXPECT_ERROR(GL_INVALID_OPERATION);
    }
    glCopyTexSubImage2D(t, 0, 0, 0, 0, 0, 1, 1);
    EXPECT_ERROR(GL_INVALID_OPERATION);
    glCompressedTexSubImage2D(GL_TEXTURE, 0, 0, 0, 4, 4, f.internal, static_cast<GLsizei>(bytes),
                              data);
    EXPECT_ERROR(GL_INVALID_ENUM);
    for (const GLint level : {-1, 15}) {
      glCompressedTexSubImage2D(t, level, 0, 0, 4, 4, f.internal, static_cast<GLsizei>(bytes),
                                data);
      EXPECT_ERROR(GL_INVALID_VALUE);
    }
    glCompressedTexSubImage2D(t, 5, 0, 0, 4, 4, f.internal, static_cast<GLsizei>(bytes), data);
    EXPECT_ERROR(GL_INVALID_OPERATION);
    glGenerateMipmapOES(t);
    EXPECT_ERROR(GL_INVALID_OPERATION);
  }
}

TEST_F(Compressed, TheFormatsAreListed) {
  GLint count = 0, formats[32] = {};
  glGetIntegerv(GL_NUM_COMPRESSED_TEXTURE_FORMATS, &count);
  ASSERT_LE(count, 32);
  glGetIntegerv(GL_COMPRESSED_TEXTURE_FORMATS, formats);
  for (const Format& f : kFormats) {
    EXPECT_EQ(std::count(formats, formats + count, static_cast<GLint>(f.internal)), 1);
  }
}

}  // namespace
}  // namespace clearpipe::api
