// Texture images as they reach the surface: formats and alignment, parts, copies from the surface,
// compressed palettes and generated mipmaps (3.6.2, 3.7.1 to 3.7.4, 3.7.7).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <string>

#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

// Draws the texture 1:1, a texel a pixel.
class Textures : public CallTest {
 protected:
  void SetUp() override {
    CallTest::SetUp();
    one_colour_texture(0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
  static std::vector<uint32_t> drawn(GLsizei width, GLsizei height) {
    glViewport(0, 0, width, height);
    draw_quad();
    return read(width, height);
  }
  static std::vector<uint32_t> read(GLsizei width, GLsizei height) {
    std::vector<uint32_t> pixels(static_cast<size_t>(width * height));
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
  }
  static uint32_t bytes(double r, double g, double b, double a) {
    const double values[4] = {r, g, b, a};
    uint32_t packed = 0;
    for (size_t i = 0; i < 4; ++i) {
      packed |= static_cast<uint32_t>(std::lround(values[i] * 255)) << 8 * i;
    }
    return packed;
  }
};

// A pixel format: its bytes, and the colour that they stand for where REPLACE takes colour or alpha
// that the format lacks from a fragment of opaque white.
struct Format {
  GLenum format, type;
  size_t bytes;
  std::function<uint32_t(const uint8_t*)> colour;
};

double field(const uint8_t* p, int shift, int bits) {
  uint16_t packed;
  std::memcpy(&packed, p, 2);
  const int max = (1 << bits) - 1;
  return static_cast<double>(packed >> shift & max) / max;
}

class Formats : public Textures {
 protected:
  static std::vector<Format> formats() {
    const auto of = [](const uint8_t* p, int i) { return p[i] / 255.0; };
    return {
        {GL_RGBA, GL_UNSIGNED_BYTE, 4,
         [of](const uint8_t* p) { return bytes(of(p, 0), of(p, 1), of(p, 2), of(p, 3)); }},
        {GL_RGB, GL_UNSIGNED_BYTE, 3,
         [of](const uint8_t* p) { return bytes(of(p, 0), of(p, 1), of(p, 2), 1); }},
        {GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, 2,
         [of](const uint8_t* p) { return bytes(of(p, 0), of(p, 0), of(p, 0), of(p, 1)); }},
        {GL_LUMINANCE, GL_UNSIGNED_BYTE, 1,
         [of](const uint8_t* p) { return bytes(of(p, 0), of(p, 0), of(p, 0), 1); }},
        {GL_ALPHA, GL_UNSIGNED_BYTE, 1,
         [of](const uint8_t* p) { return bytes(1, 1, 1, of(p, 0)); }},
        {GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 2,
         [](const uint8_t* p) {
           return bytes(field(p, 11, 5), field(p, 5, 6), field(p, 0, 5), 1);
         }},
        {GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, 2,
         [](const uint8_t* p) {
           return bytes(field(p, 12, 4), field(p, 8, 4), field(p, 4, 4), field(p, 0, 4));
         }},
        {GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, 2,
         [](const uint8_t* p) {
           return bytes(field(p, 11, 5), field(p, 6, 5), field(p, 1, 5), field(p, 0, 1));
         }},
        {GL_BGRA_EXT, GL_UNSIGNED_BYTE, 4,
         [of](const uint8_t* p) { return bytes(of(p, 2), of(p, 1), of(p, 0), of(p, 3)); }},
    };
  }
};

// Rows of 5 texels begin at multiples of the alignment; then a part of the image is replaced from
// rows of 3.
TEST_F(Formats, EachWithEveryAlignment) {
  constexpr GLsizei kWidth = 5, kHeight = 3;
  std::vector<uint8_t> data(4096);
  for (size_t i = 0; i < data.size(); ++i) data[i] = static_cast<uint8_t>(i * 73 + i / 7);
  for (const Format& f : formats()) {
    for (const size_t alignment : {1, 2, 4, 8}) {
      glPixelStorei(GL_UNPACK_ALIGNMENT, static_cast<GLint>(alignment));
      const auto texel = [&](const uint8_t* from, size_t width, size_t x, size_t y) {
        const size_t row = (width * f.bytes + alignment - 1) / alignment * alignment;
        return f.colour(from + y * row + x * f.bytes);
      };
      glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(f.format), kWidth, kHeight, 0, f.format,
                   f.type, data.data());
      std::vector<uint32_t> expected;
      for (size_t i = 0; i < kWidth * kHeight; ++i) {
        expected.push_back(texel(data.data(), kWidth, i % kWidth, i / kWidth));
      }
      const std::string what = std::to_string(f.format) + " " + std::to_string(f.type) +
                               " alignment " + std::to_string(alignment);
      EXPECT_EQ(drawn(kWidth, kHeight), expected) << what;

      const uint8_t* part = data.data() + 1000;
      glTexSubImage2D(GL_TEXTURE_2D, 0, 2, 1, 3, 2, f.format, f.type, part);
      for (size_t y = 0; y < 2; ++y) {
        for (size_t x = 0; x < 3; ++x) expected[(y + 1) * kWidth + x + 2] = texel(part, 3, x, y);
      }
      EXPECT_EQ(drawn(kWidth, kHeight), expected) << what << ", a part";
      EXPECT_ERROR(GL_NO_ERROR) << what;
    }
  }
}

// Every value of the packed formats to the nearest of 8 bits.
TEST_F(Formats, EveryValueOfThePackedFormats) {
  for (const Format& f : formats()) {
    if (f.type == GL_UNSIGNED_BYTE) continue;
    for (uint32_t base = 0; base < 65536; base += 256) {
      std::vector<uint16_t> image;
      for (uint32_t i = 0; i < 256; ++i) image.push_back(static_cast<uint16_t>(base + i));
      glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(f.format), 16, 16, 0, f.format, f.type,
                   image.data());
      std::vector<uint32_t> expected;
      for (const uint16_t v : image)
        expected.push_back(f.colour(reinterpret_cast<const uint8_t*>(&v)));
      ASSERT_EQ(drawn(16, 16), expected) << f.type << " from " << base;
    }
  }
}

// The memory of images that are gone serves new ones, but shows nothing of them.
TEST_F(Textures, ImagesWithoutPixelsAreEmpty) {
  constexpr GLsizei kTexels = 256;
  const struct {
    GLenum format;
    uint32_t expected;
  } kCases[] = {{GL_RGBA, 0}, {GL_RGB, 0xff000000u}, {GL_LUMINANCE, 0xff000000u}};
  for (const auto& c : kCases) {
    const GLuint before = one_colour_texture(kRed, kTexels);
    draw_quad();
    EXPECT_EQ(pixel(3, 3), kRed);
    glDeleteTextures(1, &before);
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(c.format), kTexels, kTexels, 0, c.format,
                 GL_UNSIGNED_BYTE, nullptr);
    glClear(GL_COLOR_BUFFER_BIT);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    draw_quad();
    const uint32_t alpha = c.format == GL_RGBA ? ~0u : 0x00ffffffu;  // the format may have none
    for (int i = 0; i < kSize; ++i) EXPECT_EQ(pixel(i, i) & alpha, c.expected & alpha);
    glDeleteTextures(1, &name);
  }
  EXPECT_ERROR(GL_NO_ERROR);
}

// Rows of 3 pixels are 12 bytes, 16 with an alignment of 8; pixels beside the surface and bytes
// between the rows stay as they were.
TEST_F(Textures, ReadPixelsWithEveryAlignment) {
  glClearColor(0, 1, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  for (const size_t alignment : {1, 2, 4, 8}) {
    glPixelStorei(GL_PACK_ALIGNMENT, static_cast<GLint>(alignment));
    const size_t row = alignment == 8 ? 4 : 3;
    std::vector<uint32_t> pixels(16, 7);
    glReadPixels(kSize - 2, -1, 3, 3, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    for (size_t i = 0; i < pixels.size(); ++i) {
      const bool inside = i % row < 2 && i / row >= 1 && i / row < 3;
      EXPECT_EQ(pixels[i], inside ? kGreen : 7u) << alignment << " " << i;
    }
  }
}

// Table 3.9: what each format keeps of the surface's colour.
TEST_F(Textures, CopiesOfTheSurfaceKeepTheirComponents) {
  struct {
    GLenum format;
    uint32_t copied;
  } const kCopies[] = {{GL_RGBA, 0x60402010},
                       {GL_RGB, 0xff402010},
                       {GL_LUMINANCE, 0xff101010},
                       {GL_LUMINANCE_ALPHA, 0x60101010},
                       {GL_ALPHA, 0x60ffffff}};
  for (const auto& c : kCopies) {
    for (const bool part : {false, true}) {
      glClearColor(0x10 / 255.0f, 0x20 / 255.0f, 0x40 / 255.0f, 0x60 / 255.0f);
      glClear(GL_COLOR_BUFFER_BIT);
      if (part) {
        const GLubyte zeros[16] = {};
        glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(c.format), 2, 2, 0, c.format,
                     GL_UNSIGNED_BYTE, zeros);
        glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 1, 1, 3, 3, 1, 1);
        EXPECT_EQ(drawn(2, 2)[3], c.copied) << c.format;
        EXPECT_NE(drawn(2, 2)[0], c.copied) << c.format;
      } else {
        glCopyTexImage2D(GL_TEXTURE_2D, 0, c.format, 3, 3, 2, 2, 0);
        EXPECT_EQ(drawn(2, 2)[3], c.copied) << c.format;
      }
      EXPECT_ERROR(GL_NO_ERROR);
    }
  }
}

TEST_F(Textures, CopiesTakeTheirPlaceAndLeaveTheRest) {
  std::vector<uint32_t> image(64, kRed);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
  glEnable(GL_SCISSOR_TEST);
  glScissor(1, 0, 1, 1);
  glClearColor(0, 0, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
  // Only the pixels (0,0) and (1,0) of these 3x2 lie on the surface; (1,0) is blue.
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 4, 5, -1, -1, 3, 2);
  image[6 * 8 + 5] = 0;
  image[6 * 8 + 6] = kBlue;
  EXPECT_EQ(drawn(8, 8), image);
}

const GLenum kPalettes[] = {GL_PALETTE4_RGB8_OES,     GL_PALETTE4_RGBA8_OES,
                            GL_PALETTE4_R5_G6_B5_OES, GL_PALETTE4_RGBA4_OES,
                            GL_PALETTE4_RGB5_A1_OES,  GL_PALETTE8_RGB8_OES,
                            GL_PALETTE8_RGBA8_OES,    GL_PALETTE8_R5_G6_B5_OES,
                            GL_PALETTE8_RGBA4_OES,    GL_PALETTE8_RGB5_A1_OES};

// All ten formats: a palette of noise, indices that count up, three levels of a 5x3 image, each
// drawn as the base level of a texture made of it alone must show.
TEST_F(Formats, CompressedPalettesWithLevels) {
  const Format* entries[5] = {};
  const std::vector<Format> all = formats();
  const size_t kEntry[5] = {1, 0, 5, 6, 7};  // table 3.11
  for (size_t i = 0; i < 5; ++i) entries[i] = &all[kEntry[i]];
  for (size_t p = 0; p < 10; ++p) {
    const Format& entry = *entries[p % 5];
    const size_t bits = p < 5 ? 4 : 8, colours = size_t{1} << bits;
    std::vector<uint8_t> data(colours * entry.bytes);
    for (size_t i = 0; i < data.size(); ++i) data[i] = static_cast<uint8_t>(i * 151 + i / 16);
    const std::vector<uint8_t> palette = data;
    std::vector<std::vector<uint32_t>> expected;
    constexpr size_t kWidth[3] = {5, 2, 1}, kHeight[3] = {3, 1, 1};
    for (size_t level = 0; level < 3; ++level) {
      const size_t texels = kWidth[level] * kHeight[level], start = data.size();
      data.resize(start + (texels * bits + 7) / 8);
      expected.emplace_back();
      for (size_t i = 0; i < texels; ++i) {
        const size_t index = (i * 11 + level + 3) % colours;
        if (bits == 8) {
          data[start + i] = static_cast<uint8_t>(index);
        } else {
          data[start + i / 2] |= static_cast<uint8_t>(i % 2 == 0 ? index << 4 : index);
        }
        expected[level].push_back(entry.colour(palette.data() + index * entry.bytes));
      }
    }
    const auto upload = [&](GLint level, size_t size) {
      glCompressedTexImage2D(GL_TEXTURE_2D, level, kPalettes[p], 5, 3, 0,
                             static_cast<GLsizei>(size), data.data());
    };
    upload(-2, data.size());
    EXPECT_ERROR(GL_NO_ERROR) << p;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    EXPECT_EQ(drawn(5, 3), expected[0]) << p;
    EXPECT_EQ(drawn(1, 1), expected[2]) << p;
    // Wrong sizes and levels are refused and change nothing.
    for (const auto& [level, size] : {std::pair<GLint, size_t>{-2, data.size() - 1},
                                      {-2, data.size() + 1},
                                      {0, data.size()},
                                      {1, data.size()},
                                      {-3, data.size()},
                                      {-15, data.size()}}) {
      upload(level, size);
      EXPECT_ERROR(GL_INVALID_VALUE) << p << " level " << level;
    }
    // They have no parts (3.7.4).
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, entry.format, entry.type, data.data());
    EXPECT_ERROR(GL_INVALID_OPERATION);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 1, 1);
    EXPECT_ERROR(GL_INVALID_OPERATION);
    glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 5, 3, kPalettes[p], 1, data.data());
    EXPECT_ERROR(GL_INVALID_OPERATION);
    EXPECT_EQ(drawn(5, 3), expected[0]) << p;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  }
}

// The average of four texels, level by level, by whatever call the base level changes.
TEST_F(Textures, MipmapsAreGenerated) {
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  std::vector<uint32_t> image;
  for (uint32_t i = 0; i < 16; ++i)
    image.push_back(0xff000000u | i * 12 << 16 | i * 5 << 8 | i * 16);
  const auto average = [&image](size_t x, size_t y, size_t size) {
    uint32_t result = 0;
    for (uint32_t shift = 0; shift < 32; shift += 8) {
      double sum = 0;
      for (size_t i = 0; i < size * size; ++i) {
        sum += image[(y * size + i / size) * 4 + x * size + i % size] >> shift & 255;
      }
      result |= static_cast<uint32_t>(std::lround(sum / static_cast<double>(size * size))) << shift;
    }
    return result;
  };
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
  EXPECT_EQ(drawn(4, 4), image);
  EXPECT_EQ(drawn(2, 2), (std::vector<uint32_t>{average(0, 0, 2), average(1, 0, 2),
                                                average(0, 1, 2), average(1, 1, 2)}));
  EXPECT_EQ(drawn(1, 1)[0], average(0, 0, 4));

  const uint32_t part[4] = {kWhite, kWhite, kWhite, kWhite};
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE, part);
  EXPECT_EQ(drawn(2, 2)[0], kWhite);
  EXPECT_EQ(drawn(2, 2)[1], average(1, 0, 2));

  glClearColor(0, 1, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 2, 2, 0, 0, 2, 2);
  EXPECT_EQ(drawn(2, 2)[3], kGreen);
  glClear(GL_COLOR_BUFFER_BIT);
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 8, 8, 0);
  EXPECT_EQ(drawn(1, 1)[0], kGreen);

  // A change of another level stays as it is, and without GENERATE_MIPMAP nothing follows.
  glTexImage2D(GL_TEXTURE_2D, 3, GL_RGB, 1, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, &kRed);
  EXPECT_EQ(drawn(1, 1)[0], kRed);
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_FALSE);
  const std::vector<uint8_t> black(8 * 8 * 3);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 8, GL_RGB, GL_UNSIGNED_BYTE, black.data());
  EXPECT_EQ(drawn(1, 1)[0], kRed);
}

// All levels have the internal format of the base level, or the texture is incomplete (3.7.9); the
// type they came from does not matter.
TEST_F(Textures, LevelsAgreeInFormatNotInType) {
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  const GLubyte data[16] = {};
  const GLushort green = 63 << 5;
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, data);
  glTexImage2D(GL_TEXTURE_2D, 1, GL_RGB, 1, 1, 0, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, &green);
  EXPECT_EQ(drawn(1, 1)[0], kGreen);
  glTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, data);
  EXPECT_EQ(drawn(1, 1)[0], kWhite);
}

}  // namespace
}  // namespace clearpipe::api
