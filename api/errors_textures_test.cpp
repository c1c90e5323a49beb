// Errors of texture extensions: cube maps and generated coordinates (OES_texture_cube_map),
// immutable textures (EXT_texture_storage, APPLE_copy_texture_levels), PVRTC.
// SPDX-License-Identifier: MIT
#include "api/error_cases.h"
#include "api/texture_tokens.h"

namespace clearpipe::api {
namespace {

constexpr GLenum kFace = GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES, kByte = GL_UNSIGNED_BYTE;
constexpr GLenum kStr = GL_TEXTURE_GEN_STR_OES, kMode = GL_TEXTURE_GEN_MODE_OES;
constexpr GLenum kNormal = GL_NORMAL_MAP_OES, kEtc1 = GL_ETC1_RGB8_OES;

// Names of textures that the cases use.
constexpr GLuint kLarge = 20, kSmall = 21, kOpaque = 22, kOdd = 23, kCubeMap = 24, kPlain = 25,
                 kNone = 26;

class TextureErrors : public ErrorTest {
 protected:
  static void image(GLenum target, GLint level, GLsizei width, GLsizei height) {
    glTexImage2D(target, level, GL_RGBA, width, height, 0, GL_RGBA, kByte, nullptr);
  }
  static void copy(GLenum target, GLsizei width, GLsizei height) {
    glCopyTexImage2D(target, 0, GL_RGBA, 0, 0, width, height, 0);
  }
  static void part(GLenum target, GLint level, GLint x, GLsizei width) {
    glTexSubImage2D(target, level, x, 0, width, 1, GL_RGBA, kByte, f);
  }
  static void faces(GLsizei size) {
    for (GLenum i = 0; i < 6; ++i) image(kFace + i, 0, size, size);
  }
  static void storage(GLuint name, GLsizei levels, GLenum internal, GLsizei size,
                      GLenum target = k2D) {
    glBindTexture(target, name);
    glTexStorage2DEXT(target, levels, internal, size, size);
    ASSERT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  }
};

TEST_F(TextureErrors, TargetsOfTextures) {
  glBindTexture(kCube, kCubeMap);
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_ENUM, glBindTexture(kFace, 77)),
      REFUSED(GL_INVALID_OPERATION, glBindTexture(k2D, kCubeMap)),
      REFUSED(GL_INVALID_OPERATION, glBindTexture(kCube, 1)),
      REFUSED(GL_INVALID_ENUM, glTexParameteri(kFace, GL_TEXTURE_MIN_FILTER, GL_LINEAR)),
      REFUSED(GL_INVALID_ENUM, glGetTexParameteriv(kFace, GL_TEXTURE_MIN_FILTER, nullptr)),
      REFUSED(GL_INVALID_ENUM, glTexParameteri(kCube, GL_TEXTURE_IMMUTABLE_FORMAT_EXT, GL_TRUE)),
  };
  expect_refused(kCases);
}

TEST_F(TextureErrors, ImagesOfCubeMaps) {
  glBindTexture(kCube, kCubeMap);
  faces(4);
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_VALUE, image(kFace, 0, 4, 2)),
      REFUSED(GL_INVALID_VALUE, image(kFace, -1, 4, 4)),
      REFUSED(GL_INVALID_VALUE, image(kFace, 15, 1, 1)),
      REFUSED(GL_INVALID_VALUE, image(kFace + 5, 14, 2, 2)),
      REFUSED(GL_INVALID_VALUE, image(kFace + 5, 0, 16385, 16385)),
      REFUSED(GL_INVALID_ENUM, image(kFace + 6, 0, 4, 4)),
      REFUSED(GL_INVALID_ENUM, image(kCube, 0, 4, 4)),
      REFUSED(GL_INVALID_VALUE, copy(kFace, 4, 2)),
      REFUSED(GL_INVALID_ENUM, copy(kCube, 4, 4)),
      REFUSED(GL_INVALID_ENUM, part(kCube, 0, 0, 1)),
      REFUSED(GL_INVALID_OPERATION, part(kFace, 1, 0, 1)),
      REFUSED(GL_INVALID_VALUE, part(kFace, 0, 4, 1)),
      REFUSED(GL_INVALID_ENUM, glCopyTexSubImage2D(kCube, 0, 0, 0, 0, 0, 1, 1)),
      REFUSED(GL_INVALID_VALUE, glCompressedTexImage2D(kFace, 0, kEtc1, 8, 4, 0, 16, f)),
      REFUSED(GL_INVALID_ENUM, glCompressedTexImage2D(kCube, 0, kEtc1, 4, 4, 0, 8, f)),
      REFUSED(GL_INVALID_ENUM, glCompressedTexSubImage2D(kCube, 0, 0, 0, 4, 4, kEtc1, 8, f)),
      REFUSED(GL_INVALID_ENUM, glGenerateMipmapOES(kFace)),
  };
  expect_refused(kCases);
  image(kFace + 2, 0, 2, 2);
  const ErrorCase kIncomplete[] = {REFUSED(GL_INVALID_OPERATION, glGenerateMipmapOES(kCube))};
  expect_refused(kIncomplete);
}

TEST_F(TextureErrors, EncodedImages) {
  static constexpr GLenum kFb = GL_FRAMEBUFFER_OES, kPoint = GL_COLOR_ATTACHMENT0_OES;
  static constexpr GLenum kSrgb = GL_SRGB_EXT, kSrgba = GL_SRGB_ALPHA_EXT;
  glBindTexture(k2D, kPlain);
  glTexImage2D(k2D, 0, kSrgb, 4, 4, 0, kSrgb, kByte, nullptr);
  glBindFramebufferOES(kFb, 31);
  const ErrorCase kCases[] = {
    REFUSED(GL_INVALID_OPERATION, glTexImage2D(k2D, 0, kSrgb, 4, 4, 0, GL_RGB, kByte, nullptr)),
    REFUSED(GL_INVALID_OPERATION, glTexImage2D(k2D, 0, GL_RGB, 4, 4, 0, kSrgb, kByte, nullptr)),
    REFUSED(GL_INVALID_OPERATION, glTexImage2D(k2D, 0, kSrgba, 4, 4, 0, kSrgb, kByte, nullptr)),
    REFUSED(GL_INVALID_OPERATION,
            glTexImage2D(k2D, 0, kSrgb, 4, 4, 0, kSrgb, GL_UNSIGNED_SHORT_5_6_5, nullptr)),
    REFUSED(GL_INVALID_VALUE,
            glTexImage2D(k2D, 0, GL_SRGB8_ALPHA8_EXT, 4, 4, 0, kSrgba, kByte, nullptr)),
    REFUSED(GL_INVALID_OPERATION, glTexSubImage2D(k2D, 0, 0, 0, 1, 1, GL_RGB, kByte, f)),
    REFUSED(GL_INVALID_OPERATION, glTexSubImage2D(k2D, 0, 0, 0, 1, 1, kSrgba, kByte, f)),
    REFUSED(GL_INVALID_ENUM, glCopyTexImage2D(k2D, 0, kSrgb, 0, 0, 1, 1, 0)),
    REFUSED(GL_INVALID_OPERATION, glGenerateMipmapOES(k2D)),
    REFUSED(GL_INVALID_ENUM, glRenderbufferStorageOES(GL_RENDERBUFFER_OES, kSrgba, 4, 4)),
    REFUSED(GL_INVALID_ENUM, GLint encoding; glGetFramebufferAttachmentParameterivOES(
                kFb, kPoint, GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING_EXT, &encoding)),
  };
  expect_refused(kCases);
  glBindFramebufferOES(kFb, 0);
  const ErrorCase kRead[] = {
      REFUSED(GL_INVALID_ENUM, glReadPixels(0, 0, 1, 1, kSrgba, kByte, f)),
  };
  expect_refused(kRead);
}

// Nothing but an EGLImage gives an external texture an image, and it has one level.
TEST_F(TextureErrors, ExternalTextures) {
  static constexpr GLenum kExternal = GL_TEXTURE_EXTERNAL_OES, kFb = GL_FRAMEBUFFER_OES;
  static constexpr GLenum kPoint = GL_COLOR_ATTACHMENT0_OES;
  static constexpr GLfloat kTrue = 1;
  glBindTexture(kExternal, kPlain);
  glBindFramebufferOES(kFb, 30);
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_ENUM, image(kExternal, 0, 4, 4)),
      REFUSED(GL_INVALID_ENUM, part(kExternal, 0, 0, 1)),
      REFUSED(GL_INVALID_ENUM, copy(kExternal, 4, 4)),
      REFUSED(GL_INVALID_ENUM, glCopyTexSubImage2D(kExternal, 0, 0, 0, 0, 0, 1, 1)),
      REFUSED(GL_INVALID_ENUM, glCompressedTexImage2D(kExternal, 0, kEtc1, 4, 4, 0, 8, f)),
      REFUSED(GL_INVALID_ENUM, glCompressedTexSubImage2D(kExternal, 0, 0, 0, 4, 4, kEtc1, 8, f)),
      REFUSED(GL_INVALID_ENUM, glTexStorage2DEXT(kExternal, 1, GL_RGBA8_OES, 4, 4)),
      REFUSED(GL_INVALID_ENUM, glGenerateMipmapOES(kExternal)),
      REFUSED(GL_INVALID_ENUM,
              glTexParameteri(kExternal, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR)),
      REFUSED(GL_INVALID_ENUM,
              glTexParameterx(kExternal, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST)),
      REFUSED(GL_INVALID_ENUM, glTexParameteri(kExternal, GL_TEXTURE_WRAP_S, GL_REPEAT)),
      REFUSED(GL_INVALID_ENUM,
              glTexParameteri(kExternal, GL_TEXTURE_WRAP_T, GL_MIRRORED_REPEAT_OES)),
      REFUSED(GL_INVALID_ENUM, glTexParameterfv(kExternal, GL_GENERATE_MIPMAP, &kTrue)),
      REFUSED(GL_INVALID_ENUM, glTexParameteri(kExternal, GL_REQUIRED_TEXTURE_IMAGE_UNITS_OES, 1)),
      REFUSED(GL_INVALID_OPERATION, glBindTexture(kExternal, 1)),
      REFUSED(GL_INVALID_OPERATION, glBindTexture(k2D, kPlain)),
      REFUSED(GL_INVALID_OPERATION, glBindTexture(kCube, kPlain)),
      REFUSED(GL_INVALID_VALUE, glEGLImageTargetTexture2DOES(kExternal, nullptr)),
      REFUSED(GL_INVALID_ENUM, glFramebufferTexture2DOES(kFb, kPoint, kExternal, kPlain, 0)),
      REFUSED(GL_INVALID_OPERATION, glFramebufferTexture2DOES(kFb, kPoint, k2D, kPlain, 0)),
      REFUSED(GL_INVALID_OPERATION, glFramebufferTexture2DOES(kFb, kPoint, kFace, kPlain, 0)),
  };
  expect_refused(kCases);
  glTexParameteri(kExternal, GL_GENERATE_MIPMAP, GL_FALSE);  // what it is
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(TextureErrors, FacesAsAttachments) {
  static constexpr GLenum kFb = GL_FRAMEBUFFER_OES, kPoint = GL_COLOR_ATTACHMENT0_OES;
  glBindTexture(kCube, kCubeMap);
  faces(4);
  glBindFramebufferOES(kFb, 30);
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_ENUM, glFramebufferTexture2DOES(kFb, kPoint, kCube, kCubeMap, 0)),
      REFUSED(GL_INVALID_OPERATION, glFramebufferTexture2DOES(kFb, kPoint, k2D, kCubeMap, 0)),
      REFUSED(GL_INVALID_OPERATION, glFramebufferTexture2DOES(kFb, kPoint, kFace, 1, 0)),
      REFUSED(GL_INVALID_OPERATION, glFramebufferTexture2DOES(kFb, kPoint, kFace, 99, 0)),
      REFUSED(GL_INVALID_VALUE, glFramebufferTexture2DOES(kFb, kPoint, kFace, kCubeMap, 15)),
  };
  expect_refused(kCases);
}

TEST_F(TextureErrors, GeneratedCoordinates) {
  static constexpr GLenum kS = 0x2000, kPlane = 0x2501, kSphereMap = 0x2402, kGenS = 0x0C60;
  static constexpr GLfloat kFloat = kNormal;
  static constexpr GLint kInteger = kNormal, kSphere = kSphereMap;
  const ErrorCase kCases[] = {
    REFUSED(GL_INVALID_ENUM, glTexGenfOES(kS, kMode, kFloat)),
    REFUSED(GL_INVALID_ENUM, glTexGenfvOES(kStr, kPlane, &kFloat)),
    REFUSED(GL_INVALID_ENUM, glTexGeniOES(kStr, kMode, kSphere)),
    REFUSED(GL_INVALID_ENUM, glTexGenivOES(kStr, kMode, &kSphere)),
    REFUSED(GL_INVALID_ENUM, glTexGenxOES(kStr, kMode, kNormal << 16)),
    REFUSED(GL_INVALID_ENUM, glTexGenxvOES(kStr, kPlane, &kInteger)),
    REFUSED(GL_INVALID_ENUM, glGetTexGenfvOES(kS, kMode, f)),
    REFUSED(GL_INVALID_ENUM, GLint mode; glGetTexGenivOES(kStr, kPlane, &mode)),
    REFUSED(GL_INVALID_ENUM, GLint mode; glGetTexGenxvOES(kS, kMode, &mode)),
    REFUSED(GL_INVALID_ENUM, glEnable(kGenS)),
  };
  expect_refused(kCases);
}

TEST_F(TextureErrors, Storage) {
  glBindTexture(k2D, 0);
  const ErrorCase kDefault[] = {
      REFUSED(GL_INVALID_OPERATION, glTexStorage2DEXT(k2D, 1, GL_RGBA8_OES, 4, 4)),
      REFUSED(GL_INVALID_OPERATION, glTexStorage2DEXT(kCube, 1, GL_RGBA8_OES, 4, 4)),
  };
  expect_refused(kDefault);
  glBindTexture(k2D, 1);
  glBindTexture(kCube, kCubeMap);
  const auto format = [](GLenum internal) {
    glTexStorage2DEXT(k2D, 1, internal, 4, 4);
    return glGetError();
  };
  for (const GLenum internal :
       {GL_RGBA, GL_RGB, GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_BGRA_EXT,
        GL_PALETTE4_RGB8_OES, GL_LUMINANCE4_ALPHA4_OES, GL_DEPTH24_STENCIL8_OES,
        GL_DEPTH_COMPONENT16_OES, GL_RGB10_A2_EXT, GL_RGBA32F_EXT}) {
    EXPECT_EQ(format(internal), GLenum{GL_INVALID_ENUM}) << std::hex << internal;
  }
  static constexpr GLenum k8 = GL_RGBA8_OES, kDxt5 = GL_COMPRESSED_RGBA_S3TC_DXT5_ANGLE;
  static constexpr GLenum kPvrtc = GL_COMPRESSED_RGB_PVRTC_2BPPV1_IMG;
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_ENUM, glTexStorage2DEXT(kFace, 1, k8, 4, 4)),
      REFUSED(GL_INVALID_ENUM, glTexStorage2DEXT(k2D, 1, GL_RGBA, 4, 4)),
      REFUSED(GL_INVALID_VALUE, glTexStorage2DEXT(k2D, 0, k8, 4, 4)),
      REFUSED(GL_INVALID_VALUE, glTexStorage2DEXT(k2D, -1, k8, 4, 4)),
      REFUSED(GL_INVALID_VALUE, glTexStorage2DEXT(k2D, 1, k8, 0, 4)),
      REFUSED(GL_INVALID_VALUE, glTexStorage2DEXT(k2D, 1, k8, 4, -1)),
      REFUSED(GL_INVALID_VALUE, glTexStorage2DEXT(k2D, 1, k8, 16385, 4)),
      REFUSED(GL_INVALID_VALUE, glTexStorage2DEXT(kCube, 1, k8, 4, 8)),
      REFUSED(GL_INVALID_OPERATION, glTexStorage2DEXT(k2D, 4, k8, 4, 4)),
      REFUSED(GL_INVALID_OPERATION, glTexStorage2DEXT(k2D, 5, k8, 15, 1)),
      REFUSED(GL_INVALID_OPERATION, glTexStorage2DEXT(k2D, 1, kDxt5, 6, 4)),
      REFUSED(GL_INVALID_OPERATION, glTexStorage2DEXT(k2D, 2, kDxt5, 12, 12)),
      REFUSED(GL_INVALID_OPERATION, glTexStorage2DEXT(k2D, 1, kPvrtc, 12, 12)),
  };
  expect_refused(kCases);
}

TEST_F(TextureErrors, ImmutableTextures) {
  storage(kLarge, 1, GL_RGBA8_OES, 16);
  static constexpr GLenum kPalette = GL_PALETTE4_RGBA8_OES;
  static const std::vector<uint8_t> kData(192);
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_OPERATION, image(k2D, 0, 16, 16)),
      REFUSED(GL_INVALID_OPERATION, image(k2D, 1, 8, 8)),
      REFUSED(GL_INVALID_OPERATION, copy(k2D, 16, 16)),
      REFUSED(GL_INVALID_OPERATION,
              glCompressedTexImage2D(k2D, 0, kEtc1, 16, 16, 0, 128, kData.data())),
      REFUSED(GL_INVALID_OPERATION,
              glCompressedTexImage2D(k2D, 0, kPalette, 16, 16, 0, 192, kData.data())),
      REFUSED(GL_INVALID_OPERATION, glTexStorage2DEXT(k2D, 1, GL_RGBA8_OES, 16, 16)),
      REFUSED(GL_INVALID_OPERATION, part(k2D, 1, 0, 1)),
  };
  expect_refused(kCases);
}

TEST_F(TextureErrors, CopiesOfLevels) {
  storage(kLarge, 3, GL_RGBA8_OES, 16);
  storage(kSmall, 2, GL_RGBA8_OES, 8);
  storage(kOpaque, 3, GL_RGB8_OES, 16);
  storage(kOdd, 2, GL_RGBA8_OES, 12);
  storage(kCubeMap, 3, GL_RGBA8_OES, 16, kCube);
  glBindTexture(k2D, kPlain);
  image(k2D, 0, 16, 16);
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_VALUE, glCopyTextureLevelsAPPLE(0, kSmall, 0, 1)),
      REFUSED(GL_INVALID_VALUE, glCopyTextureLevelsAPPLE(kLarge, 0, 0, 1)),
      REFUSED(GL_INVALID_OPERATION, glCopyTextureLevelsAPPLE(kNone, kSmall, 0, 1)),
      REFUSED(GL_INVALID_OPERATION, glCopyTextureLevelsAPPLE(kLarge, kNone, 0, 1)),
      REFUSED(GL_INVALID_OPERATION, glCopyTextureLevelsAPPLE(kPlain, kSmall, 0, 1)),
      REFUSED(GL_INVALID_OPERATION, glCopyTextureLevelsAPPLE(kLarge, kPlain, 0, 1)),
      REFUSED(GL_INVALID_OPERATION, glCopyTextureLevelsAPPLE(kLarge, kOpaque, 0, 1)),
      REFUSED(GL_INVALID_OPERATION, glCopyTextureLevelsAPPLE(kLarge, kCubeMap, 0, 1)),
      REFUSED(GL_INVALID_OPERATION, glCopyTextureLevelsAPPLE(kLarge, kOdd, 0, 1)),
      REFUSED(GL_INVALID_OPERATION, glCopyTextureLevelsAPPLE(kSmall, kLarge, 0, 2)),
      REFUSED(GL_INVALID_VALUE, glCopyTextureLevelsAPPLE(kLarge, kSmall, -1, 1)),
      REFUSED(GL_INVALID_VALUE, glCopyTextureLevelsAPPLE(kLarge, kSmall, 2, 1)),
      REFUSED(GL_INVALID_VALUE, glCopyTextureLevelsAPPLE(kLarge, kSmall, 0, 0)),
      REFUSED(GL_INVALID_VALUE, glCopyTextureLevelsAPPLE(kLarge, kSmall, 1, 2)),
  };
  expect_refused(kCases);
}

TEST_F(TextureErrors, Pvrtc) {
  static constexpr GLenum k4 = GL_COMPRESSED_RGB_PVRTC_4BPPV1_IMG;
  static constexpr GLenum k2 = GL_COMPRESSED_RGBA_PVRTC_2BPPV1_IMG;
  static const std::vector<uint8_t> kData(256);
  static const auto give = [](GLenum format, GLint level, GLsizei width, GLsizei height,
                              GLint border, GLsizei size) {
    glCompressedTexImage2D(k2D, level, format, width, height, border, size, kData.data());
  };
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_VALUE, give(k4, 0, 16, 16, 1, 128)),
      REFUSED(GL_INVALID_VALUE, give(k4, -1, 16, 16, 0, 128)),
      REFUSED(GL_INVALID_VALUE, give(k4, 0, 12, 16, 0, 96)),
      REFUSED(GL_INVALID_VALUE, give(k2, 0, 16, 24, 0, 96)),
      REFUSED(GL_INVALID_VALUE, give(k4, 0, 32, 16, 0, 128)),
      REFUSED(GL_INVALID_VALUE, give(k2, 0, 2, 2, 0, 8)),
      REFUSED(GL_INVALID_VALUE, glTexImage2D(k2D, 0, k4, 4, 4, 0, GL_RGB, kByte, kData.data())),
  };
  expect_refused(kCases);
  glBindTexture(k2D, kPlain);
  give(k4, 0, 16, 16, 0, 128);
  static const auto part4 = [](GLint x, GLint y, GLsizei width, GLsizei height, GLsizei size) {
    glCompressedTexSubImage2D(k2D, 0, x, y, width, height, k4, size, kData.data());
  };
  const ErrorCase kParts[] = {
      REFUSED(GL_INVALID_OPERATION, part4(0, 0, 8, 16, 64)),
      REFUSED(GL_INVALID_OPERATION, part4(0, 0, 16, 8, 64)),
      REFUSED(GL_INVALID_OPERATION, part4(8, 0, 8, 16, 64)),
      REFUSED(GL_INVALID_VALUE, part4(0, 0, 16, 16, 127)),
      REFUSED(GL_INVALID_VALUE, part4(4, 0, 16, 16, 128)),
      REFUSED(GL_INVALID_OPERATION,
              glTexSubImage2D(k2D, 0, 0, 0, 1, 1, GL_RGB, kByte, kData.data())),
  };
  expect_refused(kParts);
}

}  // namespace
}  // namespace clearpipe::api
