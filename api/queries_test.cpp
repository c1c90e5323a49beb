// glGet*: the initial value of every variable in all four types with the conversions of 6.1.2, and
// values that need them.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>

#include "api/call_fixture.h"
#include "api/initial_state.h"

namespace clearpipe::api {
namespace {

using Queries = CallTest;

GLint saturated(double value) {
  constexpr double kLow = std::numeric_limits<GLint>::min(),
                   kHigh = std::numeric_limits<GLint>::max();
  return static_cast<GLint>(std::clamp(value, kLow, kHigh));
}

GLint as_integer(Kind kind, double value) {
  return saturated(kind == Kind::kColour ? (4294967295.0 * value - 1) / 2 : std::round(value));
}

GLfixed as_fixed(Kind kind, double value) {
  return saturated(kind == Kind::kEnumerant ? value : std::floor(value * 65536 + 0.5));
}

// What the four queries write for `v`, and that they write nothing behind it.
void expect_value(const InitialValue& v) {
  constexpr size_t kMost = 20;
  GLboolean booleans[kMost];
  GLint integers[kMost], fixed[kMost];
  GLfloat floats[kMost];
  std::fill_n(booleans, kMost, GLboolean{77});
  std::fill_n(integers, kMost, 77);
  std::fill_n(fixed, kMost, 77);
  std::fill_n(floats, kMost, 77.0f);
  glGetBooleanv(v.name, booleans);
  glGetIntegerv(v.name, integers);
  glGetFixedv(v.name, fixed);
  glGetFloatv(v.name, floats);
  EXPECT_ERROR(GL_NO_ERROR) << v.text;
  const size_t count = v.values.size();
  for (size_t i = 0; i < count; ++i) {
    const std::string where = std::string(v.text) + " " + std::to_string(i);
    EXPECT_EQ(booleans[i], v.values[i] != 0) << where;
    EXPECT_EQ(integers[i], as_integer(v.kind, v.values[i])) << where;
    EXPECT_EQ(fixed[i], as_fixed(v.kind, v.values[i])) << where;
    EXPECT_EQ(floats[i], static_cast<GLfloat>(v.values[i])) << where;
  }
  EXPECT_EQ(booleans[count], 77) << v.text;
  EXPECT_EQ(integers[count], 77) << v.text;
  EXPECT_EQ(fixed[count], 77) << v.text;
  EXPECT_EQ(floats[count], 77.0f) << v.text;
}

TEST_F(Queries, InitialValuesInEveryType) {
  for (const InitialValue& v : initial_values()) expect_value(v);
}

TEST_F(Queries, EveryVariableHasAnInitialValueHere) {
  const GLenum kQueries[] = {
#define QUERY(name, kind, ...) name,
#include "api/queries.def"
#undef QUERY
  };
  for (const GLenum name : kQueries) {
    EXPECT_TRUE(std::any_of(initial_values().begin(), initial_values().end(),
                            [name](const InitialValue& v) { return v.name == name; }))
        << std::hex << name;
  }
}

TEST_F(Queries, ValuesThatAreNotWhole) {
  glColor4f(0.5f, -1, 0.25f, 0);
  glClearDepthf(0.5f);
  glDepthRangef(0.25f, 0.75f);
  glAlphaFunc(GL_LESS, 0.5f);
  glLineWidth(2.5f);
  glPolygonOffset(-1.5f, 40000.0f);
  glFogf(GL_FOG_START, -2.25f);
  glSampleCoverage(0.25f, GL_TRUE);
  const InitialValue kValues[] = {
      {GL_CURRENT_COLOR, "colour", Kind::kColour, {0.5, -1, 0.25, 0}},
      {GL_DEPTH_CLEAR_VALUE, "depth clear value", Kind::kColour, {0.5}},
      {GL_DEPTH_RANGE, "depth range", Kind::kColour, {0.25, 0.75}},
      {GL_ALPHA_TEST_REF, "alpha reference", Kind::kNumber, {0.5}},
      {GL_LINE_WIDTH, "line width", Kind::kNumber, {2.5}},
      {GL_POLYGON_OFFSET_UNITS, "saturates as fixed", Kind::kNumber, {40000}},
      {GL_SAMPLE_COVERAGE_VALUE, "sample coverage", Kind::kNumber, {0.25}},
      {GL_SAMPLE_COVERAGE_INVERT, "sample coverage", Kind::kBoolean, {1}},
  };
  for (const InitialValue& v : kValues) expect_value(v);
  GLint start = 0;
  glGetIntegerv(GL_FOG_START, &start);
  EXPECT_EQ(start, -2);
}

TEST_F(Queries, MatricesAsBits) {
  const GLenum kMatrices[][2] = {
      {GL_MODELVIEW, GL_MODELVIEW_MATRIX_FLOAT_AS_INT_BITS_OES},
      {GL_PROJECTION, GL_PROJECTION_MATRIX_FLOAT_AS_INT_BITS_OES},
      {GL_TEXTURE, GL_TEXTURE_MATRIX_FLOAT_AS_INT_BITS_OES},
  };
  for (const auto& [mode, name] : kMatrices) {
    glMatrixMode(mode);
    glTranslatef(0.1f, -3, static_cast<float>(mode));
    GLint bits[16];
    glGetIntegerv(name, bits);
    EXPECT_EQ(bits[12], std::bit_cast<GLint>(0.1f));
    EXPECT_EQ(bits[14], std::bit_cast<GLint>(static_cast<float>(mode)));
  }
}

// Variables of a unit follow ACTIVE_TEXTURE or CLIENT_ACTIVE_TEXTURE.
TEST_F(Queries, UnitsAreToldApart) {
  glActiveTexture(GL_TEXTURE3);
  glEnable(GL_TEXTURE_2D);
  glBindTexture(GL_TEXTURE_2D, 9);
  glMultiTexCoord4f(GL_TEXTURE3, 1, 2, 3, 4);
  glClientActiveTexture(GL_TEXTURE5);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  GLint bound = 0;
  GLfloat coords[4] = {};
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  glGetFloatv(GL_CURRENT_TEXTURE_COORDS, coords);
  EXPECT_EQ(bound, 9);
  EXPECT_EQ(coords[2], 3.0f);
  EXPECT_TRUE(glIsEnabled(GL_TEXTURE_2D));
  EXPECT_TRUE(glIsEnabled(GL_TEXTURE_COORD_ARRAY));
  glActiveTexture(GL_TEXTURE5);
  glClientActiveTexture(GL_TEXTURE3);
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  EXPECT_EQ(bound, 0);
  EXPECT_FALSE(glIsEnabled(GL_TEXTURE_2D));
  EXPECT_FALSE(glIsEnabled(GL_TEXTURE_COORD_ARRAY));
}

// The planes of the surface that is bound, not those of the first one.
TEST_F(Queries, BitsAreThoseOfTheSurface) {
  struct {
    bool alpha, depth, stencil;
  } const kSurfaces[] = {{true, true, true},
                         {false, true, true},
                         {true, false, true},
                         {true, true, false},
                         {false, false, false}};
  const auto bits = [](GLenum name) {
    GLint value = -1;
    glGetIntegerv(name, &value);
    return value;
  };
  for (const auto& s : kSurfaces) {
    const pipeline::Target surface = make_target(kSize, kSize, s.alpha, s.depth, s.stencil);
    make_current(context_, surface, surface);
    EXPECT_EQ(bits(GL_RED_BITS), 8);
    EXPECT_EQ(bits(GL_ALPHA_BITS), s.alpha ? 8 : 0);
    EXPECT_EQ(bits(GL_DEPTH_BITS), s.depth ? 24 : 0);
    EXPECT_EQ(bits(GL_STENCIL_BITS), s.stencil ? 8 : 0);
    // A test without its plane passes, and an alpha that is not kept reads as 1 (4.1.5, 4.1.6).
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_NEVER);
    glColor4f(1, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    draw_quad();
    const uint32_t clear = s.alpha ? 0 : 0xff000000u, red = s.alpha ? 0x000000ffu : kRed;
    EXPECT_EQ(pixel(8, 8), s.depth ? clear : red);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_NEVER, 0, ~0u);
    glClear(GL_COLOR_BUFFER_BIT);
    draw_quad();
    EXPECT_EQ(pixel(8, 8), s.stencil ? clear : red);
    glDisable(GL_STENCIL_TEST);
  }
  make_current(context_, {}, {});
  for (const GLenum name : {GL_RED_BITS, GL_ALPHA_BITS, GL_DEPTH_BITS, GL_STENCIL_BITS}) {
    EXPECT_EQ(bits(name), 0);
  }
}

}  // namespace
}  // namespace clearpipe::api
