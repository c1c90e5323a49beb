// Errors of chapter 3: rasterization, pixel rectangles, textures and fog.
// SPDX-License-Identifier: MIT
#include "api/error_cases.h"

namespace clearpipe::api {
namespace {

class Chapter3Errors : public ErrorTest {
 protected:
  static void image(GLenum target, GLint level, GLint internal, GLsizei width, GLsizei height,
                    GLint border, GLenum format, GLenum type) {
    glTexImage2D(target, level, internal, width, height, border, format, type, nullptr);
  }
  static void part(GLint level, GLint left, GLint bottom, GLsizei width, GLsizei height,
                   GLenum format, GLenum type) {
    glTexSubImage2D(GL_TEXTURE_2D, level, left, bottom, width, height, format, type, f);
  }
  static void copy(GLint level, GLenum internal, GLsizei width, GLsizei height, GLint border) {
    glCopyTexImage2D(GL_TEXTURE_2D, level, internal, 0, 0, width, height, border);
  }
  static void copy_part(GLint level, GLint left, GLint bottom, GLsizei width, GLsizei height) {
    glCopyTexSubImage2D(GL_TEXTURE_2D, level, left, bottom, 0, 0, width, height);
  }
  static constexpr GLenum kByte = GL_UNSIGNED_BYTE;

  static const std::vector<ErrorCase>& rasterization() {
    static const std::vector<ErrorCase> kCases = {
        // 3.3 to 3.5
        REFUSED(GL_INVALID_VALUE, glPointSize(0)),
        REFUSED(GL_INVALID_VALUE, glPointSizex(-1)),
        REFUSED(GL_INVALID_VALUE, glPointParameterf(GL_POINT_SIZE_MIN, -1)),
        REFUSED(GL_INVALID_VALUE, glPointParameterx(GL_POINT_SIZE_MAX, -1)),
        REFUSED(GL_INVALID_VALUE, glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, -1)),
        REFUSED(GL_INVALID_ENUM, glPointParameterf(GL_POINT_DISTANCE_ATTENUATION, 1)),
        REFUSED(GL_INVALID_ENUM, glPointParameterfv(GL_POINT_SIZE, f)),
        REFUSED(GL_INVALID_ENUM, glPointParameterxv(GL_POINT_SMOOTH, x)),
        REFUSED(GL_INVALID_ENUM, glPointParameterx(GL_POINT_DISTANCE_ATTENUATION, 1)),
        REFUSED(GL_INVALID_VALUE, glLineWidth(0)),
        REFUSED(GL_INVALID_VALUE, glLineWidthx(-1)),
        REFUSED(GL_INVALID_ENUM, glCullFace(GL_CW)),
        REFUSED(GL_INVALID_ENUM, glFrontFace(GL_FRONT)),
        // 3.6.1
        REFUSED(GL_INVALID_ENUM, glPixelStorei(GL_RGBA, 1)),
        REFUSED(GL_INVALID_VALUE, glPixelStorei(GL_PACK_ALIGNMENT, 0)),
        REFUSED(GL_INVALID_VALUE, glPixelStorei(GL_PACK_ALIGNMENT, 3)),
        REFUSED(GL_INVALID_VALUE, glPixelStorei(GL_UNPACK_ALIGNMENT, 16)),
        REFUSED(GL_INVALID_VALUE, glPixelStorei(GL_UNPACK_ALIGNMENT, -4)),
        // 3.8
        REFUSED(GL_INVALID_ENUM, glFogf(GL_FOG, 1)),
        REFUSED(GL_INVALID_ENUM, glFogf(GL_FOG_MODE, GL_NEAREST)),
        REFUSED(GL_INVALID_ENUM, glFogx(GL_FOG_MODE, 1)),
        REFUSED(GL_INVALID_VALUE, glFogf(GL_FOG_DENSITY, -1)),
        REFUSED(GL_INVALID_VALUE, glFogx(GL_FOG_DENSITY, -1)),
        REFUSED(GL_INVALID_ENUM, glFogf(GL_FOG_COLOR, 1)),
        REFUSED(GL_INVALID_ENUM, glFogfv(GL_FOG_HINT, f)),
        REFUSED(GL_INVALID_ENUM, glFogxv(GL_FOG_MODE, x)),
    };
    return kCases;
  }
  static const std::vector<ErrorCase>& images() {
    static const std::vector<ErrorCase> kCases = {
        // 3.7.1
        REFUSED(GL_INVALID_ENUM, image(0, 0, GL_RGBA, 1, 1, 0, GL_RGBA, kByte)),
        REFUSED(GL_INVALID_VALUE, image(k2D, -1, GL_RGBA, 1, 1, 0, GL_RGBA, kByte)),
        REFUSED(GL_INVALID_VALUE, image(k2D, 15, GL_RGBA, 1, 1, 0, GL_RGBA, kByte)),
        REFUSED(GL_INVALID_VALUE, image(k2D, 0, GL_RGB10_A2_EXT, 1, 1, 0, GL_RGBA, kByte)),
        REFUSED(GL_INVALID_VALUE, image(k2D, 0, GL_BGRA8_EXT, 1, 1, 0, GL_BGRA_EXT, kByte)),
        REFUSED(GL_INVALID_OPERATION, image(k2D, 0, GL_RGBA8_OES, 1, 1, 0, GL_RGB, kByte)),
        REFUSED(GL_INVALID_OPERATION,
                image(k2D, 0, GL_RGBA8_OES, 1, 1, 0, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4)),
        REFUSED(GL_INVALID_OPERATION,
                image(k2D, 0, GL_RGB5_A1_OES, 1, 1, 0, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4)),
        REFUSED(GL_INVALID_OPERATION, image(k2D, 0, GL_RGBA, 1, 1, 0, GL_BGRA_EXT, kByte)),
        REFUSED(GL_INVALID_OPERATION, image(k2D, 0, GL_BGRA_EXT, 1, 1, 0, GL_RGBA, kByte)),
        REFUSED(GL_INVALID_OPERATION,
                image(k2D, 0, GL_BGRA_EXT, 1, 1, 0, GL_BGRA_EXT, GL_UNSIGNED_SHORT_4_4_4_4)),
        REFUSED(GL_INVALID_OPERATION, part(0, 0, 0, 1, 1, GL_BGRA_EXT, kByte)),
        REFUSED(GL_INVALID_ENUM, copy(0, GL_BGRA_EXT, 1, 1, 0)),
        REFUSED(GL_INVALID_VALUE, image(k2D, 0, 4, 1, 1, 0, GL_RGBA, kByte)),
        REFUSED(GL_INVALID_VALUE, image(k2D, 0, GL_RGBA, -1, 1, 0, GL_RGBA, kByte)),
        REFUSED(GL_INVALID_VALUE, image(k2D, 0, GL_RGBA, 1, -1, 0, GL_RGBA, kByte)),
        REFUSED(GL_INVALID_VALUE, image(k2D, 0, GL_RGBA, 16385, 1, 0, GL_RGBA, kByte)),
        REFUSED(GL_INVALID_VALUE, image(k2D, 14, GL_RGBA, 1, 2, 0, GL_RGBA, kByte)),
        REFUSED(GL_INVALID_VALUE, image(k2D, 0, GL_RGBA, 1, 1, 1, GL_RGBA, kByte)),
        REFUSED(GL_INVALID_OPERATION, image(k2D, 0, GL_RGB, 1, 1, 0, GL_RGBA, kByte)),
        REFUSED(GL_INVALID_ENUM, image(k2D, 0, GL_RGBA, 1, 1, 0, GL_DEPTH_TEST, kByte)),
        REFUSED(GL_INVALID_ENUM, image(k2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_FLOAT)),
        REFUSED(GL_INVALID_OPERATION,
                image(k2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5)),
        REFUSED(GL_INVALID_OPERATION,
                image(k2D, 0, GL_RGB, 1, 1, 0, GL_RGB, GL_UNSIGNED_SHORT_4_4_4_4)),
        REFUSED(GL_INVALID_OPERATION,
                image(k2D, 0, GL_ALPHA, 1, 1, 0, GL_ALPHA, GL_UNSIGNED_SHORT_5_5_5_1)),
        // 3.7.2
        REFUSED(GL_INVALID_ENUM, glTexSubImage2D(0, 0, 0, 0, 1, 1, GL_RGBA, kByte, f)),
        REFUSED(GL_INVALID_VALUE, part(-1, 0, 0, 1, 1, GL_RGBA, kByte)),
        REFUSED(GL_INVALID_VALUE, part(15, 0, 0, 1, 1, GL_RGBA, kByte)),
        REFUSED(GL_INVALID_OPERATION, part(1, 0, 0, 1, 1, GL_RGBA, kByte)),
        REFUSED(GL_INVALID_VALUE, part(0, -1, 0, 1, 1, GL_RGBA, kByte)),
        REFUSED(GL_INVALID_VALUE, part(0, 0, -1, 1, 1, GL_RGBA, kByte)),
        REFUSED(GL_INVALID_VALUE, part(0, 2, 0, 3, 1, GL_RGBA, kByte)),
        REFUSED(GL_INVALID_VALUE, part(0, 0, 4, 1, 1, GL_RGBA, kByte)),
        REFUSED(GL_INVALID_VALUE, part(0, INT32_MAX, 0, INT32_MAX, 1, GL_RGBA, kByte)),
        REFUSED(GL_INVALID_VALUE, part(0, 0, 0, -1, 1, GL_RGBA, kByte)),
        REFUSED(GL_INVALID_VALUE, part(0, 0, 0, 1, -1, GL_RGBA, kByte)),
        REFUSED(GL_INVALID_OPERATION, part(0, 0, 0, 1, 1, GL_RGB, kByte)),
        REFUSED(GL_INVALID_ENUM, part(0, 0, 0, 1, 1, GL_FLOAT, kByte)),
        REFUSED(GL_INVALID_ENUM, part(0, 0, 0, 1, 1, GL_RGBA, GL_RGBA)),
        REFUSED(GL_INVALID_OPERATION, part(0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5)),
        REFUSED(GL_INVALID_ENUM, glCopyTexImage2D(0, 0, GL_RGBA, 0, 0, 1, 1, 0)),
        REFUSED(GL_INVALID_VALUE, copy(-1, GL_RGBA, 1, 1, 0)),
        REFUSED(GL_INVALID_VALUE, copy(15, GL_RGBA, 1, 1, 0)),
        REFUSED(GL_INVALID_VALUE, copy(0, GL_RGBA, -1, 1, 0)),
        REFUSED(GL_INVALID_VALUE, copy(0, GL_RGBA, 1, 16385, 0)),
        REFUSED(GL_INVALID_VALUE, copy(0, GL_RGBA, 1, 1, 1)),
        REFUSED(GL_INVALID_ENUM, copy(0, GL_FLOAT, 1, 1, 0)),
        REFUSED(GL_INVALID_ENUM, glCopyTexSubImage2D(0, 0, 0, 0, 0, 0, 1, 1)),
        REFUSED(GL_INVALID_VALUE, copy_part(-1, 0, 0, 1, 1)),
        REFUSED(GL_INVALID_VALUE, copy_part(15, 0, 0, 1, 1)),
        REFUSED(GL_INVALID_OPERATION, copy_part(1, 0, 0, 1, 1)),
        REFUSED(GL_INVALID_VALUE, copy_part(0, -1, 0, 1, 1)),
        REFUSED(GL_INVALID_VALUE, copy_part(0, 0, 3, 1, 2)),
        REFUSED(GL_INVALID_VALUE, copy_part(0, 0, 0, 1, -1)),
        // 3.7.3; the sizes of palettes are in texture_test.cpp
        REFUSED(GL_INVALID_ENUM, glCompressedTexImage2D(k2D, 0, GL_RGB, 1, 1, 0, 3, f)),
        REFUSED(GL_INVALID_ENUM,
                glCompressedTexImage2D(0, 0, GL_PALETTE4_RGB8_OES, 1, 1, 0, 49, f)),
        REFUSED(GL_INVALID_VALUE,
                glCompressedTexImage2D(k2D, 0, GL_PALETTE4_RGB8_OES, 1, 1, 1, 49, f)),
        REFUSED(GL_INVALID_VALUE,
                glCompressedTexImage2D(k2D, 0, GL_PALETTE4_RGB8_OES, -1, 1, 0, 48, f)),
        REFUSED(GL_INVALID_VALUE,
                glCompressedTexImage2D(k2D, 0, GL_PALETTE4_RGB8_OES, 1, 1, 0, -1, f)),
        REFUSED(GL_INVALID_VALUE,
                glCompressedTexImage2D(k2D, 0, GL_PALETTE4_RGB8_OES, 1, 1, 0, 50, f)),
        REFUSED(GL_INVALID_VALUE,
                glCompressedTexImage2D(k2D, 0, GL_PALETTE4_RGB8_OES, 1, 1, 0, 49, nullptr)),
        REFUSED(GL_INVALID_VALUE,
                glCompressedTexImage2D(k2D, 0, GL_PALETTE8_RGB5_A1_OES, 16385, 1, 0, 16897, f)),
        REFUSED(GL_INVALID_VALUE,
                glCompressedTexImage2D(k2D, 1, GL_PALETTE4_RGB8_OES, 1, 1, 0, 49, f)),
        REFUSED(GL_INVALID_VALUE,
                glCompressedTexImage2D(k2D, -15, GL_PALETTE4_RGB8_OES, 1, 1, 0, 49, f)),
        REFUSED(GL_INVALID_VALUE,
                glCompressedTexImage2D(k2D, -1, GL_PALETTE4_RGB8_OES, 1, 1, 0, 50, f)),
        REFUSED(GL_INVALID_ENUM, glCompressedTexSubImage2D(k2D, 0, 0, 0, 1, 1, GL_RGBA, 4, f)),
        REFUSED(GL_INVALID_ENUM,
                glCompressedTexSubImage2D(0, 0, 0, 0, 1, 1, GL_PALETTE4_RGB8_OES, 49, f)),
        REFUSED(GL_INVALID_OPERATION,
                glCompressedTexSubImage2D(k2D, 0, 0, 0, 1, 1, GL_PALETTE4_RGB8_OES, 49, f)),
    };
    return kCases;
  }
  static const std::vector<ErrorCase>& parameters() {
    static const std::vector<ErrorCase> kCases = {
      // 3.7.5, table 3.13
      REFUSED(GL_INVALID_ENUM, glTexParameteri(0, GL_TEXTURE_WRAP_S, GL_REPEAT)),
      REFUSED(GL_INVALID_ENUM, glTexParameteri(k2D, GL_TEXTURE_ENV_MODE, GL_REPEAT)),
      REFUSED(GL_INVALID_ENUM, glTexParameteri(k2D, GL_TEXTURE_WRAP_S, GL_LINEAR)),
      REFUSED(GL_INVALID_ENUM, glTexParameterf(k2D, GL_TEXTURE_WRAP_T, -1)),
      REFUSED(GL_INVALID_ENUM, glTexParameterx(k2D, GL_TEXTURE_MIN_FILTER, GL_REPEAT)),
      REFUSED(GL_INVALID_ENUM, glTexParameteri(k2D, GL_TEXTURE_MIN_FILTER, 0x2704)),
      REFUSED(GL_INVALID_ENUM,
              glTexParameteri(k2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR_MIPMAP_NEAREST)),
      REFUSED(GL_INVALID_ENUM, glTexParameteriv(k2D, GL_TEXTURE_MAG_FILTER, x)),
      REFUSED(GL_INVALID_ENUM, glTexParameterfv(k2D, GL_TEXTURE_MIN_FILTER, f)),
      REFUSED(GL_INVALID_ENUM, glTexParameterxv(k2D, GL_TEXTURE_WRAP_S, x)),
      // 3.7.11
      REFUSED(GL_INVALID_ENUM, glBindTexture(GL_TEXTURE, 2)),
      REFUSED(GL_INVALID_VALUE, GLuint n = 0; glGenTextures(-1, &n)),
      REFUSED(GL_INVALID_VALUE, GLuint n = 1; glDeleteTextures(-1, &n)),
      // 3.7.12
      REFUSED(GL_INVALID_ENUM, glTexEnvi(k2D, GL_TEXTURE_ENV_MODE, GL_REPLACE)),
      REFUSED(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_COORD_REPLACE_OES, 1)),
      REFUSED(GL_INVALID_ENUM, glTexEnvi(GL_POINT_SPRITE_OES, GL_TEXTURE_ENV_MODE, 1)),
      REFUSED(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_SUBTRACT)),
      REFUSED(GL_INVALID_ENUM, glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, 1)),
      REFUSED(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DECAL)),
      REFUSED(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_DOT3_RGB)),
      REFUSED(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_DOT3_RGBA)),
      REFUSED(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_SRC_COLOR)),
      REFUSED(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_SRC2_ALPHA, GL_TEXTURE0 + 8)),
      REFUSED(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND1_RGB, GL_DST_COLOR)),
      REFUSED(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_ALPHA, GL_SRC_COLOR)),
      REFUSED(GL_INVALID_ENUM, glTexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, 1)),
      REFUSED(GL_INVALID_ENUM, glTexEnvfv(GL_TEXTURE_ENV, GL_SRC1_RGB, f)),
      REFUSED(GL_INVALID_ENUM, glTexEnviv(GL_TEXTURE_ENV, GL_OPERAND2_RGB, x)),
      REFUSED(GL_INVALID_ENUM, glTexEnvxv(GL_TEXTURE_ENV, GL_OPERAND1_ALPHA, x)),
      REFUSED(GL_INVALID_VALUE, glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 3)),
      REFUSED(GL_INVALID_VALUE, glTexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, 0)),
    };
    return kCases;
  }
};

TEST_F(Chapter3Errors, Rasterization) { expect_refused(rasterization()); }
TEST_F(Chapter3Errors, Images) { expect_refused(images()); }
TEST_F(Chapter3Errors, Parameters) { expect_refused(parameters()); }

// Table 3.9: a surface without alpha cannot give formats with alpha.
TEST_F(Chapter3Errors, CopiesFromASurfaceWithoutAlpha) {
  const pipeline::Target opaque = make_target(kSize, kSize, false);
  make_current(context_, opaque, opaque);
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_OPERATION, copy(0, GL_ALPHA, 1, 1, 0)),
      REFUSED(GL_INVALID_OPERATION, copy(0, GL_LUMINANCE_ALPHA, 1, 1, 0)),
      REFUSED(GL_INVALID_OPERATION, copy(0, GL_RGBA, 1, 1, 0)),
      REFUSED(GL_INVALID_OPERATION, copy_part(0, 0, 0, 1, 1)),
  };
  expect_refused(kCases);
  glBindTexture(GL_TEXTURE_2D, 2);
  for (const GLenum format : {GL_LUMINANCE, GL_RGB}) {
    copy(0, format, 1, 1, 0);
    EXPECT_ERROR(GL_NO_ERROR) << format;
  }
}

}  // namespace
}  // namespace clearpipe::api
