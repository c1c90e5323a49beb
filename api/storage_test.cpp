// Immutable textures (EXT_texture_storage), copies of their levels (APPLE_copy_texture_levels), and
// sizes that are no powers of two (APPLE_texture_2D_limited_npot).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "api/call_fixture.h"
#include "api/texture_tokens.h"

namespace clearpipe::api {
namespace {

constexpr GLenum kFirst = GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES;

class Storage : public CallTest {
 protected:
  static GLuint texture(GLenum target = k2D) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(target, name);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(target);
    return name;
  }
  static GLuint storage(GLsizei levels, GLsizei width, GLsizei height,
                        GLenum internal = GL_RGBA8_OES) {
    const GLuint name = texture();
    glTexStorage2DEXT(k2D, levels, internal, width, height);
    EXPECT_ERROR(GL_NO_ERROR) << std::hex << internal;
    return name;
  }
  static void fill(GLint level, GLsizei width, GLsizei height, uint32_t colour,
                   GLenum target = k2D) {
    const std::vector<uint32_t> data(static_cast<size_t>(width * height), colour);
    glTexSubImage2D(target, level, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
  }
  // What a draw of so many pixels shows: of 16x16 texels, 16 shows level 0, and so on.
  static uint32_t drawn(GLsizei size) {
    glViewport(0, 0, size, size);
    draw_quad();
    return pixel(0, 0);
  }
  static GLint parameter(GLenum name, GLenum target = k2D) {
    GLint value = -1;
    glGetTexParameteriv(target, name, &value);
    return value;
  }
};

TEST_F(Storage, HasAllLevelsAtOnce) {
  glColor4f(1, 1, 1, 1);
  texture();
  EXPECT_EQ(parameter(GL_TEXTURE_IMMUTABLE_FORMAT_EXT), 0);
  glTexStorage2DEXT(k2D, 5, GL_RGBA8_OES, 16, 16);
  EXPECT_EQ(parameter(GL_TEXTURE_IMMUTABLE_FORMAT_EXT), 1);
  const uint32_t colours[5] = {kRed, kGreen, kBlue, 0xff808080u, 0xff00ffffu};
  for (GLint i = 0; i < 5; ++i) fill(i, 16 >> i, 16 >> i, colours[i]);
  for (GLint i = 0; i < 5; ++i) EXPECT_EQ(drawn(16 >> i), colours[i]) << i;
  EXPECT_ERROR(GL_NO_ERROR);
}

// p is the last level that there is: the mipmap is complete without the others.
TEST_F(Storage, FewerLevels) {
  storage(2, 16, 8);
  fill(0, 16, 8, kRed);
  fill(1, 8, 4, kGreen);
  EXPECT_EQ(drawn(16), kRed);
  EXPECT_EQ(drawn(2), kGreen);
  glGenerateMipmapOES(k2D);
  EXPECT_EQ(drawn(2), kRed);
  fill(2, 4, 2, kBlue);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  glTexParameteri(k2D, GL_GENERATE_MIPMAP, GL_TRUE);
  fill(0, 16, 8, kBlue);
  EXPECT_EQ(drawn(2), kBlue);
  glTexParameteri(k2D, GL_TEXTURE_MAX_LEVEL_APPLE, 0);
  fill(0, 16, 8, kGreen);
  EXPECT_EQ(drawn(2), kGreen);
  glTexParameteri(k2D, GL_TEXTURE_MAX_LEVEL_APPLE, 1000);
  EXPECT_EQ(drawn(2), kBlue) << "levels beyond the last that is used are left alone";
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(Storage, Formats) {
  struct {
    GLenum internal, format, type;
    uint32_t texel, drawn;
  } const kRows[] = {
      {GL_RGB565_OES, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 0x001f, 0xffff0000},
      {GL_RGBA4_OES, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, 0x12fc, 0xccff2211},
      {GL_RGB5_A1_OES, GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, 0xf801, 0xff0000ff},
      {GL_RGB8_OES, GL_RGB, GL_UNSIGNED_BYTE, 0x412111, 0xff412111},
      {GL_RGBA8_OES, GL_RGBA, GL_UNSIGNED_BYTE, 0x81412111, 0x81412111},
      {GL_LUMINANCE8_ALPHA8_EXT, GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, 0x4121, 0x41212121},
      {GL_LUMINANCE8_EXT, GL_LUMINANCE, GL_UNSIGNED_BYTE, 0x21, 0xff212121},
      {GL_ALPHA8_EXT, GL_ALPHA, GL_UNSIGNED_BYTE, 0x21, 0x21ffffff},
      {GL_BGRA8_EXT, GL_BGRA_EXT, GL_UNSIGNED_BYTE, 0x81412111, 0x81112141},
  };
  glColor4f(1, 1, 1, 1);
  for (const auto& row : kRows) {
    storage(1, 1, 1, row.internal);
    glTexSubImage2D(k2D, 0, 0, 0, 1, 1, row.format, row.type, &row.texel);
    EXPECT_ERROR(GL_NO_ERROR) << std::hex << row.internal;
    EXPECT_EQ(drawn(1), row.drawn) << std::hex << row.internal;
  }
  // One block each, of one colour: all are 0 but those of PVRTC's first image.
  for (const GLenum internal :
       {GL_ETC1_RGB8_OES, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_COMPRESSED_RGBA_S3TC_DXT5_ANGLE,
        GL_COMPRESSED_RGBA_PVRTC_4BPPV1_IMG}) {
    const bool pvrtc = internal == GL_COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;
    storage(1, 4, 4, internal);
    const std::array<uint8_t, 32> data{};
    const GLsizei size = pvrtc ? 32 : internal == GL_COMPRESSED_RGBA_S3TC_DXT5_ANGLE ? 16 : 8;
    glCompressedTexSubImage2D(k2D, 0, 0, 0, 4, 4, internal, size, data.data());
    EXPECT_ERROR(GL_NO_ERROR) << std::hex << internal;
    const uint32_t colour = drawn(4);
    EXPECT_EQ(colour & 0xffffff, internal == GL_ETC1_RGB8_OES ? 0x020202u : 0u);
  }
  // Nothing is specified yet: RGB has an alpha of one all the same.
  storage(1, 4, 4, GL_RGB8_OES);
  EXPECT_EQ(drawn(4) >> 24, 255u);
}

TEST_F(Storage, IsImmutable) {
  const uint32_t data[256] = {};
  storage(1, 16, 16);
  fill(0, 16, 16, kGreen);
  for (const GLint level : {0, 1}) {
    glTexImage2D(k2D, level, GL_RGBA8_OES, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, data);
    EXPECT_ERROR(GL_INVALID_OPERATION);
    glCopyTexImage2D(k2D, level, GL_RGBA8_OES, 0, 0, 16, 16, 0);
    EXPECT_ERROR(GL_INVALID_OPERATION);
    glCompressedTexImage2D(k2D, level, GL_ETC1_RGB8_OES, 16, 16, 0, 128, data);
    EXPECT_ERROR(GL_INVALID_OPERATION);
  }
  glCompressedTexImage2D(k2D, 0, GL_PALETTE4_RGBA8_OES, 16, 16, 0, 64 + 128, data);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  glTexStorage2DEXT(k2D, 1, GL_RGBA8_OES, 16, 16);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  EXPECT_EQ(drawn(16), kGreen);
  glClearColor(0, 0, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glCopyTexSubImage2D(k2D, 0, 0, 0, 0, 0, 16, 16);
  EXPECT_EQ(drawn(16), kBlue);
  EXPECT_ERROR(GL_NO_ERROR);
}

// Levels that are not replaced go away.
TEST_F(Storage, ReplacesWhatTheTextureHad) {
  texture();
  for (GLint i = 0; i < 5; ++i) {
    glTexImage2D(k2D, i, GL_RGBA, 16 >> i, 16 >> i, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels(kRed, 16 >> i).data());
  }
  EXPECT_EQ(drawn(16), kRed);
  glTexStorage2DEXT(k2D, 2, GL_RGBA8_OES, 16, 16);
  EXPECT_NE(drawn(16), kRed);
  fill(2, 4, 4, kGreen);
  EXPECT_ERROR(GL_INVALID_OPERATION);
}

TEST_F(Storage, OfCubeMaps) {
  texture(kCube);
  glTexStorage2DEXT(kCube, 2, GL_RGBA8_OES, 4, 4);
  EXPECT_ERROR(GL_NO_ERROR);
  EXPECT_EQ(parameter(GL_TEXTURE_IMMUTABLE_FORMAT_EXT, kCube), 1);
  for (unsigned face = 0; face < 6; ++face) fill(0, 4, 4, 0xff000000u + face, kFirst + face);
  fill(1, 2, 2, kRed, kFirst + 5);
  fill(2, 1, 1, kRed, kFirst + 5);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  const float quad[] = {-1, -1, 1, -1, -1, 1, 1, 1};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, quad);
  glMultiTexCoord4f(GL_TEXTURE0, 0, 0, -1, 1);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  EXPECT_EQ(pixel(3, 3), 0xff000005u);
  glTexImage2D(kFirst, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_ERROR(GL_INVALID_OPERATION);
}

TEST_F(Storage, IsDrawnTo) {
  const GLuint name = storage(3, 16, 16, GL_RGBA8_OES);
  GLuint framebuffer = 0;
  glGenFramebuffersOES(1, &framebuffer);
  glBindFramebufferOES(GL_FRAMEBUFFER_OES, framebuffer);
  glFramebufferTexture2DOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, k2D, name, 1);
  EXPECT_EQ(glCheckFramebufferStatusOES(GL_FRAMEBUFFER_OES),
            static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE_OES));
  glClearColor(0, 1, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glBindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
  EXPECT_EQ(drawn(8), kGreen);
}

class CopyLevels : public Storage {
 protected:
  static GLenum copy(GLuint to, GLuint from, GLint base, GLsizei count) {
    glCopyTextureLevelsAPPLE(to, from, base, count);
    return glGetError();
  }
};

TEST_F(CopyLevels, GoToThoseOfTheirSize) {
  const GLuint from = storage(4, 8, 8);
  const uint32_t colours[4] = {kRed, kGreen, kBlue, 0xff00ffffu};
  for (GLint i = 0; i < 4; ++i) fill(i, 8 >> i, 8 >> i, colours[i]);
  const GLuint to = storage(5, 16, 16);
  for (GLint i = 0; i < 5; ++i) fill(i, 16 >> i, 16 >> i, kWhite);
  EXPECT_EQ(copy(to, from, 1, 2), GLenum{GL_NO_ERROR});
  EXPECT_EQ(drawn(16), kWhite);
  EXPECT_EQ(drawn(8), kWhite);
  EXPECT_EQ(drawn(4), kGreen);
  EXPECT_EQ(drawn(2), kBlue);
  EXPECT_EQ(drawn(1), kWhite);
  EXPECT_EQ(copy(to, from, 0, 4), GLenum{GL_NO_ERROR});
  EXPECT_EQ(drawn(8), kRed);
  EXPECT_EQ(drawn(1), 0xff00ffffu);
  EXPECT_EQ(drawn(16), kWhite);
  // What was copied is a copy.
  glBindTexture(k2D, from);
  fill(0, 8, 8, kWhite);
  glBindTexture(k2D, to);
  EXPECT_EQ(drawn(8), kRed);
}

TEST_F(CopyLevels, WaitForPendingDraws) {
  const GLuint from = storage(1, 8, 8);
  fill(0, 8, 8, kRed);
  const GLuint to = storage(1, 8, 8);
  fill(0, 8, 8, kGreen);
  draw_half(0);
  EXPECT_EQ(copy(to, from, 0, 1), GLenum{GL_NO_ERROR});
  draw_half(1);
  EXPECT_EQ(left(), kGreen);
  EXPECT_EQ(right(), kRed);
}

// A level of 13 texels has half of 6, as one of 12 has.
TEST_F(CopyLevels, OfSizesThatAreNoPowersOfTwo) {
  const GLuint from = storage(3, 6, 6);
  for (GLint i = 0; i < 3; ++i) fill(i, 6 >> i, 6 >> i, kBlue);
  const GLuint to = storage(4, 12, 13);
  for (GLint i = 0; i < 4; ++i) fill(i, 12 >> i, 13 >> i, kRed);
  EXPECT_EQ(copy(to, from, 0, 3), GLenum{GL_NO_ERROR});
  EXPECT_EQ(drawn(16), kRed);
  EXPECT_EQ(drawn(6), kBlue);
}

// APPLE_texture_2D_limited_npot allows them with CLAMP_TO_EDGE and without mipmaps.
TEST_F(Storage, SizesThatAreNoPowersOfTwo) {
  one_colour_texture(0);
  glTexParameteri(k2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(k2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(k2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  std::vector<uint32_t> image;
  for (uint32_t i = 0; i < 7 * 5; ++i) image.push_back(0xff000000u + 7 * i);
  glTexImage2D(k2D, 0, GL_RGBA, 7, 5, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
  glViewport(0, 0, 7, 5);
  draw_quad();
  std::vector<uint32_t> pixels(7 * 5);
  glReadPixels(0, 0, 7, 5, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  EXPECT_EQ(pixels, image);
  EXPECT_ERROR(GL_NO_ERROR);
}

}  // namespace
}  // namespace clearpipe::api
