// glGet*: values that need the conversions of 6.1.2, and what follows units and surfaces. All other
// variables are in state_test.cpp.
// SPDX-License-Identifier: MIT
#include <bit>
#include <cmath>
#include <limits>

#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

using Queries = CallTest;

TEST_F(Queries, NumbersRoundAndSaturate) {
  glFogf(GL_FOG_START, -2.25f);
  glPolygonOffset(2.5f, 40000);
  GLint integer = 0;
  GLfixed fixed = 0;
  glGetIntegerv(GL_FOG_START, &integer);
  EXPECT_EQ(integer, -2);
  glGetFixedv(GL_POLYGON_OFFSET_UNITS, &fixed);
  EXPECT_EQ(fixed, std::numeric_limits<GLfixed>::max());
  glPolygonOffset(2.5f, -1e20f);
  glGetIntegerv(GL_POLYGON_OFFSET_UNITS, &integer);
  EXPECT_EQ(integer, std::numeric_limits<GLint>::min());
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

// OES_query_matrix: of the stack that MATRIX_MODE names, to the last bit.
TEST_F(Queries, MatricesAsMantissaAndExponent) {
  const GLfloat kInfinity = std::numeric_limits<GLfloat>::infinity();
  const GLfloat values[16] = {1, -1,        0.1f,  3.14159274f, 1e30f,  -1e-30f,
                              0, 65536,     1e38f, kInfinity,   -0.75f, kInfinity - kInfinity,
                              2, 123456.7f, 5,     -1e-45f};
  for (const GLenum mode : {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE}) {
    glMatrixMode(mode);
    glLoadIdentity();
    GLfixed mantissa[16];
    GLint exponent[16];
    EXPECT_EQ(glQueryMatrixxOES(mantissa, exponent), 0u);
    glLoadMatrixf(values);
    EXPECT_EQ(glQueryMatrixxOES(mantissa, exponent), 1u << 9 | 1u << 11);
    for (int i = 0; i < 16; ++i) {
      if (i == 9 || i == 11) continue;
      EXPECT_EQ(std::ldexp(mantissa[i] / 65536.0, exponent[i]), static_cast<double>(values[i]))
          << i;
    }
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
