// The texture environment through drawn pixels against its equations in double precision: every
// function, source, operand and scale of COMBINE (tables 3.17 to 3.19), and the functions of tables
// 3.15 and 3.16 with every base format.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

using Colour = std::array<double, 4>;

uint32_t to_bytes(const Colour& c) {
  uint32_t bytes = 0;
  for (size_t i = 0; i < 4; ++i) bytes |= static_cast<uint32_t>(std::lround(c[i] * 255)) << 8 * i;
  return bytes;
}

void expect_colour(uint32_t seen, const Colour& expected, const std::string& what) {
  for (size_t i = 0; i < 4; ++i) {
    const double value = seen >> 8 * i & 255;
    EXPECT_LE(std::fabs(value - std::clamp(expected[i], 0.0, 1.0) * 255), 1.0)
        << what << ", component " << i << ": " << value << " for " << expected[i] * 255;
  }
}

struct Argument {
  GLenum source, operand;
};
// A half of a combiner: of the colours or of alpha.
struct Half {
  GLenum function;
  Argument argument[3];
  GLint scale = 1;
};

// Unit 0 modulates the primary colour by its texture; unit 1 combines.
class Combiners : public CallTest {
 protected:
  void SetUp() override {
    CallTest::SetUp();
    texture(GL_TEXTURE0, texture0_);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    texture(GL_TEXTURE1, texture1_);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    set_colours(primary_, constant_);
    glViewport(0, 0, 2, 2);
  }
  static void texture(GLenum unit, const Colour& colour) {
    glActiveTexture(unit);
    one_colour_texture(to_bytes(colour));
  }
  static void set_colours(const Colour& primary, const Colour& constant) {
    glColor4f(static_cast<float>(primary[0]), static_cast<float>(primary[1]),
              static_cast<float>(primary[2]), static_cast<float>(primary[3]));
    const GLfloat values[4] = {static_cast<float>(constant[0]), static_cast<float>(constant[1]),
                               static_cast<float>(constant[2]), static_cast<float>(constant[3])};
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, values);
  }

  static void set(const Half& half, bool alpha) {
    glTexEnvi(GL_TEXTURE_ENV, alpha ? GL_COMBINE_ALPHA : GL_COMBINE_RGB,
              static_cast<GLint>(half.function));
    for (GLenum i = 0; i < 3; ++i) {
      glTexEnvi(GL_TEXTURE_ENV, (alpha ? GL_SRC0_ALPHA : GL_SRC0_RGB) + i,
                static_cast<GLint>(half.argument[i].source));
      glTexEnvi(GL_TEXTURE_ENV, (alpha ? GL_OPERAND0_ALPHA : GL_OPERAND0_RGB) + i,
                static_cast<GLint>(half.argument[i].operand));
    }
    glTexEnvi(GL_TEXTURE_ENV, alpha ? GL_ALPHA_SCALE : GL_RGB_SCALE, half.scale);
  }

  Colour source(GLenum name) const {
    switch (name) {
      case GL_TEXTURE0:
        return texture0_;
      case GL_TEXTURE1:
      case GL_TEXTURE:
        return texture1_;
      case GL_CONSTANT:
        return constant_;
      case GL_PRIMARY_COLOR:
        return primary_;
      default: {
        Colour previous;
        for (size_t i = 0; i < 4; ++i) previous[i] = primary_[i] * texture0_[i];
        return previous;
      }
    }
  }
  double value(const Argument& a, size_t component) const {
    const Colour c = source(a.source);
    switch (a.operand) {
      case GL_SRC_COLOR:
        return c[component];
      case GL_ONE_MINUS_SRC_COLOR:
        return 1 - c[component];
      case GL_SRC_ALPHA:
        return c[3];
      default:
        return 1 - c[3];
    }
  }
  double combined(const Half& half, size_t component) const {
    const double a = value(half.argument[0], component), b = value(half.argument[1], component),
                 c = value(half.argument[2], component);
    switch (half.function) {
      case GL_REPLACE:
        return a * half.scale;
      case GL_MODULATE:
        return a * b * half.scale;
      case GL_ADD:
        return (a + b) * half.scale;
      case GL_ADD_SIGNED:
        return (a + b - 0.5) * half.scale;
      case GL_INTERPOLATE:
        return (a * c + b * (1 - c)) * half.scale;
      case GL_SUBTRACT:
        return (a - b) * half.scale;
      default: {
        double sum = 0;
        for (size_t i = 0; i < 3; ++i) {
          sum += (value(half.argument[0], i) - 0.5) * (value(half.argument[1], i) - 0.5);
        }
        return 4 * sum * half.scale;
      }
    }
  }
  void check(const Half& rgb, const Half& alpha, const std::string& what) {
    set(rgb, false);
    set(alpha, true);
    draw_quad();
    Colour expected;
    for (size_t i = 0; i < 3; ++i) expected[i] = combined(rgb, i);
    // DOT3_RGBA ignores the function of alpha; ALPHA_SCALE remains.
    expected[3] = rgb.function == GL_DOT3_RGBA ? combined(rgb, 0) / rgb.scale * alpha.scale
                                               : combined(alpha, 3);
    expect_colour(pixel(0, 0), expected, what);
  }

  // A texture of a base format that has no more of the colour than it can hold.
  static void one_texel(GLenum format, const Colour& colour) {
    const uint32_t bytes = to_bytes(colour);
    const GLubyte r = bytes & 255, g = bytes >> 8 & 255, b = bytes >> 16 & 255, a = bytes >> 24;
    const std::vector<GLubyte> data = format == GL_ALPHA ? std::vector<GLubyte>{a}
                                      : format == GL_LUMINANCE_ALPHA
                                          ? std::vector<GLubyte>{r, a}
                                          : std::vector<GLubyte>{r, g, b, a};
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), 1, 1, 0, format, GL_UNSIGNED_BYTE,
                 data.data());
  }

  static Colour byte_colour(int r, int g, int b, int a) {
    return {r / 255.0, g / 255.0, b / 255.0, a / 255.0};
  }
  const Colour texture0_ = byte_colour(210, 100, 35, 180),
               texture1_ = byte_colour(30, 240, 150, 90), primary_ = byte_colour(128, 220, 70, 200),
               constant_ = byte_colour(200, 60, 110, 40);
};

constexpr GLenum kFunctions[] = {GL_REPLACE,     GL_MODULATE, GL_ADD,      GL_ADD_SIGNED,
                                 GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA};
constexpr size_t kAlphaFunctions = 6;
constexpr GLenum kSources[] = {GL_TEXTURE,  GL_CONSTANT, GL_PRIMARY_COLOR,
                               GL_PREVIOUS, GL_TEXTURE0, GL_TEXTURE1};
constexpr GLenum kOperands[] = {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_SRC_COLOR,
                                GL_ONE_MINUS_SRC_COLOR};
constexpr GLint kScales[] = {1, 2, 4};

const Half kPlainRgb = {
    GL_REPLACE,
    {{GL_TEXTURE, GL_SRC_COLOR}, {GL_PREVIOUS, GL_SRC_COLOR}, {GL_CONSTANT, GL_SRC_COLOR}}};
const Half kPlainAlpha = {
    GL_REPLACE,
    {{GL_TEXTURE, GL_SRC_ALPHA}, {GL_PREVIOUS, GL_SRC_ALPHA}, {GL_CONSTANT, GL_SRC_ALPHA}}};

TEST_F(Combiners, EveryFunctionWithEverySourceAndOperandInEveryPlace) {
  for (const GLenum function : kFunctions) {
    for (size_t place = 0; place < 3; ++place) {
      for (const GLenum source : kSources) {
        for (const GLenum operand : kOperands) {
          Half rgb = kPlainRgb;
          rgb.function = function;
          rgb.argument[place] = {source, operand};
          check(rgb, kPlainAlpha, "rgb " + std::to_string(function));
        }
      }
    }
  }
}

TEST_F(Combiners, EveryAlphaFunctionWithEverySourceAndOperandInEveryPlace) {
  for (size_t f = 0; f < kAlphaFunctions; ++f) {
    for (size_t place = 0; place < 3; ++place) {
      for (const GLenum source : kSources) {
        for (size_t operand = 0; operand < 2; ++operand) {
          Half alpha = kPlainAlpha;
          alpha.function = kFunctions[f];
          alpha.argument[place] = {source, kOperands[operand]};
          check(kPlainRgb, alpha, "alpha " + std::to_string(kFunctions[f]));
        }
      }
    }
  }
}

TEST_F(Combiners, EveryFunctionWithEveryScale) {
  for (const GLenum function : kFunctions) {
    for (const GLint scale : kScales) {
      for (const GLint alpha_scale : kScales) {
        Half rgb = kPlainRgb, alpha = kPlainAlpha;
        rgb.function = function;
        rgb.scale = scale;
        alpha.function = kFunctions[static_cast<size_t>(alpha_scale) % kAlphaFunctions];
        alpha.scale = alpha_scale;
        check(rgb, alpha, "scale " + std::to_string(function) + " " + std::to_string(scale));
      }
    }
  }
}

TEST_F(Combiners, AnyCombinationOfThem) {
  std::mt19937 random(5);
  const auto any = [&random](const auto& list, size_t count) { return list[random() % count]; };
  for (int i = 0; i < 500; ++i) {
    Half rgb{any(kFunctions, 8), {}, any(kScales, 3)};
    Half alpha{any(kFunctions, kAlphaFunctions), {}, any(kScales, 3)};
    for (size_t k = 0; k < 3; ++k) {
      rgb.argument[k] = {any(kSources, 6), any(kOperands, 4)};
      alpha.argument[k] = {any(kSources, 6), any(kOperands, 2)};
    }
    check(rgb, alpha, "round " + std::to_string(i));
  }
}

// OES_texture_env_crossbar: an argument from a unit that samples nothing disables the unit that
// names it, unless its function does not use the argument.
TEST_F(Combiners, ATextureThatIsNotThereDisablesTheUnit) {
  Half rgb = kPlainRgb;
  rgb.argument[0] = {GL_TEXTURE5, GL_SRC_COLOR};
  set(rgb, false);
  set(kPlainAlpha, true);
  draw_quad();
  expect_colour(pixel(0, 0), source(GL_PREVIOUS), "disabled");
  std::swap(rgb.argument[0], rgb.argument[1]);
  rgb.argument[0] = {GL_TEXTURE, GL_SRC_COLOR};
  set(rgb, false);
  draw_quad();
  expect_colour(pixel(0, 0), texture1_, "not used");
}

// Tables 3.15 and 3.16; DECAL is defined for RGB and RGBA only.
TEST_F(Combiners, TheOtherFunctionsWithEveryFormat) {
  const GLenum kModes[] = {GL_REPLACE, GL_MODULATE, GL_DECAL, GL_BLEND, GL_ADD};
  struct {
    GLenum format;
    bool colour, alpha;
    GLubyte data[4];
    Colour source;
  } const kFormats[] = {{GL_ALPHA, false, true, {90}, byte_colour(0, 0, 0, 90)},
                        {GL_LUMINANCE, true, false, {150}, byte_colour(150, 150, 150, 255)},
                        {GL_LUMINANCE_ALPHA, true, true, {150, 90}, byte_colour(150, 150, 150, 90)},
                        {GL_RGB, true, false, {30, 240, 150}, byte_colour(30, 240, 150, 255)},
                        {GL_RGBA, true, true, {30, 240, 150, 90}, byte_colour(30, 240, 150, 90)}};
  const Colour cp = source(GL_PREVIOUS), cc = constant_;
  for (const auto& format : kFormats) {
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format.format), 1, 1, 0, format.format,
                 GL_UNSIGNED_BYTE, format.data);
    for (const GLenum mode : kModes) {
      if (mode == GL_DECAL && format.format != GL_RGB && format.format != GL_RGBA) continue;
      glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, static_cast<GLint>(mode));
      draw_quad();
      Colour expected = cp;
      const Colour& cs = format.source;
      for (size_t i = 0; i < 3 && format.colour; ++i) {
        expected[i] = mode == GL_REPLACE    ? cs[i]
                      : mode == GL_MODULATE ? cp[i] * cs[i]
                      : mode == GL_DECAL    ? cp[i] * (1 - cs[3]) + cs[i] * cs[3]
                      : mode == GL_BLEND    ? cp[i] * (1 - cs[i]) + cc[i] * cs[i]
                                            : cp[i] + cs[i];
      }
      if (format.alpha && mode != GL_DECAL) {
        expected[3] = mode == GL_REPLACE ? cs[3] : cp[3] * cs[3];
      }
      expect_colour(pixel(0, 0), expected,
                    std::to_string(format.format) + " " + std::to_string(mode));
    }
  }
}

// Table 3.24 of IMG_texture_env_enhanced_fixed_function, row by row: Cv and Av of a base format, as
// numbers of Cf, Af, Cs, As and Ac.
TEST_F(Combiners, TheEnvironmentsOfImgWithEveryFormat) {
  struct Row {
    GLenum mode, format;
    double (*colour)(double cf, double af, double cs, double as, double ac);
    double (*alpha)(double af, double as, double ac);
  };
#define COLOUR(value)                                                                    \
  []([[maybe_unused]] double cf, [[maybe_unused]] double af, [[maybe_unused]] double cs, \
     [[maybe_unused]] double as, [[maybe_unused]] double ac) -> double { return value; }
#define ALPHA(value)                                         \
  []([[maybe_unused]] double af, [[maybe_unused]] double as, \
     [[maybe_unused]] double ac) -> double { return value; }
  const Row kRows[] = {
      {GL_MODULATE_COLOR_IMG, GL_ALPHA, COLOUR(cf), ALPHA(as)},
      {GL_MODULATE_COLOR_IMG, GL_LUMINANCE, COLOUR(cf * cs), ALPHA(af)},
      {GL_MODULATE_COLOR_IMG, GL_LUMINANCE_ALPHA, COLOUR(cf * cs), ALPHA(as)},
      {GL_MODULATE_COLOR_IMG, GL_RGB, COLOUR(cf * cs), ALPHA(af)},
      {GL_MODULATE_COLOR_IMG, GL_RGBA, COLOUR(cf * cs), ALPHA(as)},
      {GL_RECIP_ADD_SIGNED_ALPHA_IMG, GL_ALPHA, COLOUR(cf), ALPHA((1 - as) + af - 0.5)},
      {GL_RECIP_ADD_SIGNED_ALPHA_IMG, GL_LUMINANCE, COLOUR(cf), ALPHA(af - 0.5)},
      {GL_RECIP_ADD_SIGNED_ALPHA_IMG, GL_LUMINANCE_ALPHA, COLOUR(cf), ALPHA((1 - as) + af - 0.5)},
      {GL_RECIP_ADD_SIGNED_ALPHA_IMG, GL_RGB, COLOUR(cf), ALPHA(af - 0.5)},
      {GL_RECIP_ADD_SIGNED_ALPHA_IMG, GL_RGBA, COLOUR(cf), ALPHA((1 - as) + af - 0.5)},
      {GL_TEXTURE_ALPHA_MODULATE_IMG, GL_ALPHA, COLOUR(0), ALPHA(as)},
      {GL_TEXTURE_ALPHA_MODULATE_IMG, GL_LUMINANCE, COLOUR(cs), ALPHA(1)},
      {GL_TEXTURE_ALPHA_MODULATE_IMG, GL_LUMINANCE_ALPHA, COLOUR(as * cs), ALPHA(as)},
      {GL_TEXTURE_ALPHA_MODULATE_IMG, GL_RGB, COLOUR(cs), ALPHA(1)},
      {GL_TEXTURE_ALPHA_MODULATE_IMG, GL_RGBA, COLOUR(as * cs), ALPHA(as)},
      {GL_FACTOR_ALPHA_MODULATE_IMG, GL_ALPHA, COLOUR(0), ALPHA(ac)},
      {GL_FACTOR_ALPHA_MODULATE_IMG, GL_LUMINANCE, COLOUR(ac * cs), ALPHA(ac)},
      {GL_FACTOR_ALPHA_MODULATE_IMG, GL_LUMINANCE_ALPHA, COLOUR(ac * cs), ALPHA(ac)},
      {GL_FACTOR_ALPHA_MODULATE_IMG, GL_RGB, COLOUR(ac * cs), ALPHA(ac)},
      {GL_FACTOR_ALPHA_MODULATE_IMG, GL_RGBA, COLOUR(ac * cs), ALPHA(ac)},
      {GL_FRAGMENT_ALPHA_MODULATE_IMG, GL_ALPHA, COLOUR(0), ALPHA(af)},
      {GL_FRAGMENT_ALPHA_MODULATE_IMG, GL_LUMINANCE, COLOUR(af * cs), ALPHA(af)},
      {GL_FRAGMENT_ALPHA_MODULATE_IMG, GL_LUMINANCE_ALPHA, COLOUR(af * cs), ALPHA(af)},
      {GL_FRAGMENT_ALPHA_MODULATE_IMG, GL_RGB, COLOUR(af * cs), ALPHA(af)},
      {GL_FRAGMENT_ALPHA_MODULATE_IMG, GL_RGBA, COLOUR(af * cs), ALPHA(af)},
      {GL_ADD_BLEND_IMG, GL_ALPHA, COLOUR(cf), ALPHA(af * as)},
      {GL_ADD_BLEND_IMG, GL_LUMINANCE, COLOUR(cf + (1 - af) * cs), ALPHA(af)},
      {GL_ADD_BLEND_IMG, GL_LUMINANCE_ALPHA, COLOUR(cf + (1 - af) * cs), ALPHA(af * as)},
      {GL_ADD_BLEND_IMG, GL_RGB, COLOUR(cf + (1 - af) * cs), ALPHA(af)},
      {GL_ADD_BLEND_IMG, GL_RGBA, COLOUR(cf + (1 - af) * cs), ALPHA(af * as)},
      {GL_DOT3_RGBA_IMG, GL_RGB, nullptr, nullptr},
      {GL_DOT3_RGBA_IMG, GL_RGBA, nullptr, nullptr},
  };
#undef COLOUR
#undef ALPHA
  const Colour cf = source(GL_PREVIOUS);
  for (const Row& row : kRows) {
    Colour cs = row.format == GL_LUMINANCE || row.format == GL_LUMINANCE_ALPHA
                    ? byte_colour(150, 150, 150, 90)
                    : byte_colour(30, 240, 150, 90);
    one_texel(row.format, cs);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, static_cast<GLint>(row.mode));
    draw_quad();
    Colour expected;
    double dot = 0;
    for (size_t i = 0; i < 3; ++i) {
      dot += 4 * (cf[i] - 0.5) * (cs[i] - 0.5);
      if (row.colour) expected[i] = row.colour(cf[i], cf[3], cs[i], cs[3], constant_[3]);
    }
    if (row.alpha) expected[3] = row.alpha(cf[3], cs[3], constant_[3]);
    if (!row.colour) expected.fill(dot);
    expect_colour(pixel(0, 0), expected,
                  std::to_string(row.mode) + " " + std::to_string(row.format));
  }
}

}  // namespace
}  // namespace clearpipe::api
