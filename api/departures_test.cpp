// Where Mesa's OpenGL ES 1.1 departs from the specification: one test for each row of "Not
// followed" in reference/numerics.md that no scene can show, against the text of the section.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

class Departures : public CallTest {
 protected:
  static GLfloat number(GLenum name, int i = 0) {
    GLfloat values[4] = {-7, -7, -7, -7};
    glGetFloatv(name, values);
    return values[i];
  }
};

// 2.1: arguments of type clampf are clamped when they are specified; 3.8: so is the colour of fog;
// 4.1.4: so is the reference of the alpha test.
TEST_F(Departures, ValuesAreClampedWhenTheyAreSpecified) {
  glClearColor(2, -1, 0.5f, 3);
  EXPECT_EQ(number(GL_COLOR_CLEAR_VALUE, 0), 1);
  EXPECT_EQ(number(GL_COLOR_CLEAR_VALUE, 1), 0);
  EXPECT_EQ(number(GL_COLOR_CLEAR_VALUE, 2), 0.5f);
  EXPECT_EQ(number(GL_COLOR_CLEAR_VALUE, 3), 1);
  glClearColorx(2 << 16, -(1 << 16), 1 << 15, 0);
  EXPECT_EQ(number(GL_COLOR_CLEAR_VALUE, 0), 1);
  EXPECT_EQ(number(GL_COLOR_CLEAR_VALUE, 1), 0);
  glClearDepthf(2);
  EXPECT_EQ(number(GL_DEPTH_CLEAR_VALUE), 1);
  glDepthRangef(-1, 2);
  EXPECT_EQ(number(GL_DEPTH_RANGE, 0), 0);
  EXPECT_EQ(number(GL_DEPTH_RANGE, 1), 1);
  glAlphaFunc(GL_LESS, 2);
  EXPECT_EQ(number(GL_ALPHA_TEST_REF), 1);
  glAlphaFuncx(GL_LESS, -(2 << 16));
  EXPECT_EQ(number(GL_ALPHA_TEST_REF), 0);
  const GLfloat fog[] = {2, -1, 0.5f, 3};
  glFogfv(GL_FOG_COLOR, fog);
  EXPECT_EQ(number(GL_FOG_COLOR, 0), 1);
  EXPECT_EQ(number(GL_FOG_COLOR, 1), 0);
  EXPECT_EQ(number(GL_FOG_COLOR, 2), 0.5f);
  EXPECT_EQ(number(GL_FOG_COLOR, 3), 1);
  EXPECT_ERROR(GL_NO_ERROR);
}

// 6.1.2: a query of an enumerant returns its value, in fixed point too.
TEST_F(Departures, EnumerantsAreNotScaledToFixedPoint) {
  const auto fixed = [](GLenum name) {
    GLfixed value = -7;
    glGetFixedv(name, &value);
    return value;
  };
  EXPECT_EQ(fixed(GL_SHADE_MODEL), GL_SMOOTH);
  EXPECT_EQ(fixed(GL_DEPTH_FUNC), GL_LESS);
  EXPECT_EQ(fixed(GL_MATRIX_MODE), GL_MODELVIEW);
  EXPECT_EQ(fixed(GL_FOG_MODE), GL_EXP);
  EXPECT_EQ(fixed(GL_LINE_WIDTH), 1 << 16);
  EXPECT_ERROR(GL_NO_ERROR);
}

// 2.12.2 and 3.8: the forms with one value set no parameter that has several.
TEST_F(Departures, ScalarsSetNoVectors) {
  for (const GLenum name : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION, GL_SPOT_DIRECTION}) {
    glLightf(GL_LIGHT0, name, 1);
    EXPECT_ERROR(GL_INVALID_ENUM);
    glLightx(GL_LIGHT0, name, 1);
    EXPECT_ERROR(GL_INVALID_ENUM);
  }
  for (const GLenum name : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION}) {
    glMaterialf(GL_FRONT_AND_BACK, name, 1);
    EXPECT_ERROR(GL_INVALID_ENUM);
  }
  glLightModelf(GL_LIGHT_MODEL_AMBIENT, 1);
  EXPECT_ERROR(GL_INVALID_ENUM);
  glFogf(GL_FOG_COLOR, 1);
  EXPECT_ERROR(GL_INVALID_ENUM);
  glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, 1);
  EXPECT_ERROR(GL_INVALID_ENUM);
  glPointParameterf(GL_POINT_DISTANCE_ATTENUATION, 1);
  EXPECT_ERROR(GL_INVALID_ENUM);
}

// 2.12.5: colours are clamped after lighting, enabled or not, and then interpolated.
TEST_F(Departures, ColoursAreClampedBeforeInterpolation) {
  static const GLfloat kColours[] = {0, 0, 0, 1, 4, 4, 4, 1, 0, 0, 0, 1, 4, 4, 4, 1};
  glEnableClientState(GL_COLOR_ARRAY);
  glColorPointer(4, GL_FLOAT, 0, kColours);
  draw_quad();
  for (int x = 0; x < kSize; ++x) {
    EXPECT_NEAR(pixel(x, 8) & 255, (x + 0.5) / kSize * 255, 1) << x;
  }
}

// 3.3: d is the distance from the eye, not the depth.
TEST_F(Departures, PointsShrinkWithTheDistance) {
  static const GLfloat kPoint[] = {6, 0, -8};  // at distance 10
  static const GLfloat kInverseSquare[] = {0, 0, 1};
  glMatrixMode(GL_PROJECTION);
  glOrthof(-8, 8, -8, 8, 0, 100);
  glPointSize(40);
  glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, kInverseSquare);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, kPoint);
  glDrawArrays(GL_POINTS, 0, 1);
  int covered = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) covered += pixel(x, y) == kWhite ? 1 : 0;
  }
  EXPECT_EQ(covered, 4 * 4);
}

// 3.3.1 and OES_point_sprite: polygons keep their texture coordinates.
TEST_F(Departures, SpritesAreOnlyPoints) {
  const uint32_t texels[] = {kRed, kGreen, kBlue, kWhite};
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  glEnable(GL_TEXTURE_2D);
  glEnable(GL_POINT_SPRITE_OES);
  glTexEnvi(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, GL_TRUE);
  glPointSize(5);
  draw_quad();
  EXPECT_EQ(pixel(3, 3), kRed);
  EXPECT_EQ(pixel(12, 3), kGreen);
  EXPECT_EQ(pixel(3, 12), kBlue);
  EXPECT_EQ(pixel(12, 12), kWhite);
  EXPECT_ERROR(GL_NO_ERROR);
}

}  // namespace
}  // namespace clearpipe::api
