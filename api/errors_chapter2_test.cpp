// Errors of chapter 2: vertices, arrays and buffers, transformation, lighting.
// SPDX-License-Identifier: MIT
#include "api/error_cases.h"

namespace clearpipe::api {
namespace {

class Chapter2Errors : public ErrorTest {
 protected:
  static const std::vector<ErrorCase>& arrays() {
    static const std::vector<ErrorCase> kCases = {
      // 2.7
      REFUSED(GL_INVALID_ENUM, glMultiTexCoord4f(GL_TEXTURE0 + 8, 0, 0, 0, 1)),
      REFUSED(GL_INVALID_ENUM, glMultiTexCoord4x(GL_TEXTURE0 - 1, 0, 0, 0, 1)),
      // 2.8, table 2.4
      REFUSED(GL_INVALID_VALUE, glVertexPointer(1, GL_FLOAT, 0, nullptr)),
      REFUSED(GL_INVALID_VALUE, glVertexPointer(5, GL_FLOAT, 0, nullptr)),
      REFUSED(GL_INVALID_VALUE, glVertexPointer(3, GL_FLOAT, -1, nullptr)),
      REFUSED(GL_INVALID_ENUM, glVertexPointer(3, GL_UNSIGNED_BYTE, 0, nullptr)),
      REFUSED(GL_INVALID_ENUM, glVertexPointer(3, GL_UNSIGNED_SHORT, 0, nullptr)),
      REFUSED(GL_INVALID_VALUE, glColorPointer(3, GL_FLOAT, 0, nullptr)),
      REFUSED(GL_INVALID_VALUE, glColorPointer(4, GL_FLOAT, -4, nullptr)),
      REFUSED(GL_INVALID_ENUM, glColorPointer(4, GL_BYTE, 0, nullptr)),
      REFUSED(GL_INVALID_ENUM, glColorPointer(4, GL_SHORT, 0, nullptr)),
      REFUSED(GL_INVALID_ENUM, glNormalPointer(GL_UNSIGNED_BYTE, 0, nullptr)),
      REFUSED(GL_INVALID_VALUE, glNormalPointer(GL_BYTE, -1, nullptr)),
      REFUSED(GL_INVALID_VALUE, glTexCoordPointer(1, GL_FLOAT, 0, nullptr)),
      REFUSED(GL_INVALID_VALUE, glTexCoordPointer(5, GL_FLOAT, 0, nullptr)),
      REFUSED(GL_INVALID_VALUE, glTexCoordPointer(2, GL_FLOAT, -1, nullptr)),
      REFUSED(GL_INVALID_ENUM, glTexCoordPointer(2, GL_UNSIGNED_BYTE, 0, nullptr)),
      REFUSED(GL_INVALID_ENUM, glPointSizePointerOES(GL_SHORT, 0, nullptr)),
      REFUSED(GL_INVALID_VALUE, glPointSizePointerOES(GL_FLOAT, -1, nullptr)),
      REFUSED(GL_INVALID_VALUE, glMatrixIndexPointerOES(0, GL_UNSIGNED_BYTE, 0, nullptr)),
      REFUSED(GL_INVALID_VALUE, glMatrixIndexPointerOES(5, GL_UNSIGNED_BYTE, 0, nullptr)),
      REFUSED(GL_INVALID_ENUM, glMatrixIndexPointerOES(4, GL_UNSIGNED_SHORT, 0, nullptr)),
      REFUSED(GL_INVALID_VALUE, glMatrixIndexPointerOES(4, GL_UNSIGNED_BYTE, -1, nullptr)),
      REFUSED(GL_INVALID_VALUE, glWeightPointerOES(0, GL_FLOAT, 0, nullptr)),
      REFUSED(GL_INVALID_VALUE, glWeightPointerOES(5, GL_FLOAT, 0, nullptr)),
      REFUSED(GL_INVALID_ENUM, glWeightPointerOES(4, GL_UNSIGNED_BYTE, 0, nullptr)),
      REFUSED(GL_INVALID_VALUE, glWeightPointerOES(4, GL_FLOAT, -1, nullptr)),
      REFUSED(GL_INVALID_ENUM, glEnableClientState(GL_TEXTURE_2D)),
      REFUSED(GL_INVALID_ENUM, glDisableClientState(GL_FOG)),
      REFUSED(GL_INVALID_ENUM, glClientActiveTexture(GL_TEXTURE0 + 8)),
      REFUSED(GL_INVALID_ENUM, glClientActiveTexture(0)),
      REFUSED(GL_INVALID_ENUM, glDrawArrays(GL_TRIANGLE_FAN + 1, 0, 3)),
      REFUSED(GL_INVALID_VALUE, glDrawArrays(GL_TRIANGLES, -1, 3)),
      REFUSED(GL_INVALID_VALUE, glDrawArrays(GL_TRIANGLES, 0, -1)),
      REFUSED(GL_INVALID_ENUM, glDrawElements(7, 3, GL_UNSIGNED_BYTE, nullptr)),
      REFUSED(GL_INVALID_ENUM, glDrawElements(GL_TRIANGLES, 3, GL_FLOAT, nullptr)),
      REFUSED(GL_INVALID_ENUM, glDrawElements(GL_TRIANGLES, 3, GL_SHORT, nullptr)),
      REFUSED(GL_INVALID_VALUE, glDrawElements(GL_TRIANGLES, -1, GL_UNSIGNED_BYTE, nullptr)),
      // 2.9: elements past the end of the store are never read.
      REFUSED(GL_INVALID_OPERATION, glDrawElements(GL_TRIANGLES, 9, GL_UNSIGNED_BYTE, nullptr)),
      REFUSED(GL_INVALID_OPERATION, glDrawElements(GL_TRIANGLES, 5, GL_UNSIGNED_SHORT, nullptr)),
      REFUSED(GL_INVALID_ENUM, glBindBuffer(GL_TEXTURE_2D, 1)),
      REFUSED(GL_INVALID_VALUE, GLuint n = 0; glGenBuffers(-1, &n)),
      REFUSED(GL_INVALID_VALUE, GLuint n = GL_ARRAY_BUFFER; glDeleteBuffers(-1, &n)),
      REFUSED(GL_INVALID_ENUM, glBufferData(GL_TEXTURE_2D, 1, nullptr, GL_STATIC_DRAW)),
      REFUSED(GL_INVALID_ENUM, glBufferData(GL_ARRAY_BUFFER, 1, nullptr, GL_FLOAT)),
      REFUSED(GL_INVALID_VALUE, glBufferData(GL_ARRAY_BUFFER, -1, nullptr, GL_STATIC_DRAW)),
      REFUSED(GL_INVALID_ENUM, glBufferSubData(0, 0, 1, f)),
      REFUSED(GL_INVALID_VALUE, glBufferSubData(GL_ARRAY_BUFFER, -1, 1, f)),
      REFUSED(GL_INVALID_VALUE, glBufferSubData(GL_ARRAY_BUFFER, 0, -1, f)),
      REFUSED(GL_INVALID_VALUE, glBufferSubData(GL_ARRAY_BUFFER, 8, 1, f)),
      REFUSED(GL_INVALID_VALUE, glBufferSubData(GL_ARRAY_BUFFER, INTPTR_MAX, INTPTR_MAX, f)),
    };
    return kCases;
  }
  static const std::vector<ErrorCase>& transformation_and_lighting() {
    static const std::vector<ErrorCase> kCases = {
        // 2.10
        REFUSED(GL_INVALID_VALUE, glViewport(0, 0, -1, 1)),
        REFUSED(GL_INVALID_VALUE, glViewport(0, 0, 1, -1)),
        REFUSED(GL_INVALID_ENUM, glMatrixMode(GL_MODELVIEW_MATRIX)),
        REFUSED(GL_INVALID_VALUE, glCurrentPaletteMatrixOES(48)),
        REFUSED(GL_INVALID_VALUE, glCurrentPaletteMatrixOES(~0u)),
        REFUSED(GL_INVALID_VALUE, glFrustumf(-1, 1, -1, 1, 0, 1)),
        REFUSED(GL_INVALID_VALUE, glFrustumf(-1, 1, -1, 1, 1, -1)),
        REFUSED(GL_INVALID_VALUE, glFrustumf(1, 1, -1, 1, 1, 2)),
        REFUSED(GL_INVALID_VALUE, glFrustumf(-1, 1, 1, 1, 1, 2)),
        REFUSED(GL_INVALID_VALUE, glFrustumx(-1, 1, -1, 1, 1, 1)),
        REFUSED(GL_INVALID_VALUE, glOrthof(1, 1, -1, 1, 1, 2)),
        REFUSED(GL_INVALID_VALUE, glOrthof(-1, 1, 1, 1, 1, 2)),
        REFUSED(GL_INVALID_VALUE, glOrthox(-1, 1, -1, 1, 1, 1)),
        REFUSED(GL_INVALID_ENUM, glActiveTexture(GL_TEXTURE0 + 8)),
        REFUSED(GL_INVALID_ENUM, glActiveTexture(GL_TEXTURE)),
        REFUSED(GL_INVALID_ENUM, glEnable(GL_TEXTURE)),
        REFUSED(GL_INVALID_ENUM, glEnable(GL_VERTEX_ARRAY)),
        REFUSED(GL_INVALID_ENUM, glDisable(GL_CLIP_PLANE0 + 8)),
        REFUSED(GL_INVALID_ENUM, glEnable(GL_LIGHT0 + 8)),
        // 2.11
        REFUSED(GL_INVALID_ENUM, glClipPlanef(GL_CLIP_PLANE0 + 8, f)),
        REFUSED(GL_INVALID_ENUM, glClipPlanex(0, x)),
        // 2.12, table 2.8
        REFUSED(GL_INVALID_ENUM, glLightfv(GL_LIGHT0 + 8, GL_AMBIENT, f)),
        REFUSED(GL_INVALID_ENUM, glLightfv(GL_LIGHT0, GL_EMISSION, f)),
        REFUSED(GL_INVALID_ENUM, glLightf(GL_LIGHT0, GL_AMBIENT, 1)),
        REFUSED(GL_INVALID_ENUM, glLightx(GL_LIGHT0, GL_POSITION, 1)),
        REFUSED(GL_INVALID_ENUM, glLightf(GL_LIGHT0, GL_SPOT_DIRECTION, 1)),
        REFUSED(GL_INVALID_VALUE, glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, -1)),
        REFUSED(GL_INVALID_VALUE, glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 128.5f)),
        REFUSED(GL_INVALID_VALUE, glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, -1)),
        REFUSED(GL_INVALID_VALUE, glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 90.5f)),
        REFUSED(GL_INVALID_VALUE, glLightx(GL_LIGHT0, GL_SPOT_CUTOFF, 181 << 16)),
        REFUSED(GL_INVALID_VALUE, glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, -1)),
        REFUSED(GL_INVALID_VALUE, glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, -1)),
        REFUSED(GL_INVALID_VALUE, glLightx(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, -1)),
        REFUSED(GL_INVALID_ENUM, glMaterialfv(GL_FRONT, GL_AMBIENT, f)),
        REFUSED(GL_INVALID_ENUM, glMaterialfv(GL_FRONT_AND_BACK, GL_POSITION, f)),
        REFUSED(GL_INVALID_ENUM, glMaterialf(GL_FRONT_AND_BACK, GL_DIFFUSE, 1)),
        REFUSED(GL_INVALID_ENUM, glMaterialx(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, 1)),
        REFUSED(GL_INVALID_VALUE, glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, -1)),
        REFUSED(GL_INVALID_VALUE, glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 129)),
        REFUSED(GL_INVALID_ENUM, glMaterialxv(GL_BACK, GL_SHININESS, x)),
        REFUSED(GL_INVALID_ENUM, glMaterialf(GL_FRONT_AND_BACK, GL_SPECULAR, 1)),
        REFUSED(GL_INVALID_ENUM, glMaterialf(GL_FRONT_AND_BACK, GL_EMISSION, 1)),
        REFUSED(GL_INVALID_ENUM, glLightxv(GL_LIGHT0 - 1, GL_DIFFUSE, x)),
        REFUSED(GL_INVALID_ENUM, glLightModelfv(GL_AMBIENT, f)),
        REFUSED(GL_INVALID_ENUM, glLightModelxv(GL_LIGHTING, x)),
        REFUSED(GL_INVALID_ENUM, glLightModelx(GL_LIGHT_MODEL_AMBIENT, 1)),
        REFUSED(GL_INVALID_ENUM, glLightModelf(GL_LIGHT_MODEL_AMBIENT, 1)),
        REFUSED(GL_INVALID_ENUM, glShadeModel(GL_LINEAR)),
    };
    return kCases;
  }
};

TEST_F(Chapter2Errors, Arrays) { expect_refused(arrays()); }
TEST_F(Chapter2Errors, TransformationAndLighting) { expect_refused(transformation_and_lighting()); }

TEST_F(Chapter2Errors, WithoutABuffer) {
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_OPERATION, glBufferData(GL_ARRAY_BUFFER, 1, nullptr, GL_STATIC_DRAW)),
      REFUSED(GL_INVALID_OPERATION, glBufferSubData(GL_ARRAY_BUFFER, 0, 0, f)),
  };
  expect_refused(kCases);
}

TEST_F(Chapter2Errors, FullStacks) {
  const ErrorCase kCases[] = {REFUSED(GL_STACK_OVERFLOW, glPushMatrix())};
  for (const GLenum mode : {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE}) {
    glMatrixMode(mode);
    const int depth = mode == GL_TEXTURE ? 10 : 32;
    for (int i = 1; i < depth; ++i) glPushMatrix();
    expect_refused(kCases);
    for (int i = 1; i < depth; ++i) glPopMatrix();
  }
}

TEST_F(Chapter2Errors, EmptyStacks) {
  const ErrorCase kCases[] = {REFUSED(GL_STACK_UNDERFLOW, glPopMatrix())};
  for (const GLenum mode : {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE}) {
    glMatrixMode(mode);
    expect_refused(kCases);
  }
}

// Names that are not in use, and zero, are deleted silently (2.9, 3.7.11).
TEST_F(Chapter2Errors, UnusedNamesAreNone) {
  const GLuint names[] = {0, 77, 0xffffffffu};
  glDeleteBuffers(3, names);
  glDeleteTextures(3, names);
  EXPECT_ERROR(GL_NO_ERROR);
}

}  // namespace
}  // namespace clearpipe::api
