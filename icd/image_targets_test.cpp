// EGLImages of the faces of cube maps (EGL_KHR_gl_texture_cubemap_image), and external textures
// that have one (OES_EGL_image_external).
// SPDX-License-Identifier: MIT
#include "icd/image_test.h"

namespace clearpipe::icd {
namespace {

// Each face of a cube map, and one below the base, is an image by itself.
TEST_F(ImageTest, FacesOfACubeMap) {
  const GLuint cube = cube_map({kRed, kGreen, kBlue, kWhite, 0xff00ffffu, 0xffff00ffu}, 2);
  const uint32_t changed = 0xff123456u;
  for (GLenum face = 0; face < 6; ++face) {
    for (const EGLAttrib level : {0, 1}) {
      const EGLImage image =
          create(EGL_GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, cube, {EGL_GL_TEXTURE_LEVEL, level});
      ASSERT_NE(image, EGL_NO_IMAGE) << face;
      const GLuint target = target_texture(image);
      const uint32_t expected = level == 0 ? colours_[face] : ~colours_[face] | 0xff000000u;
      EXPECT_EQ(look_at(target), expected) << face << " level " << level;
      // What is uploaded to the sibling is in this face of this level, and in no other.
      tex_sub_image(changed, 0, kSize >> level);
      EXPECT_EQ(pixel_of_face(cube, face, static_cast<GLint>(level)), changed) << face;
      for (GLenum other = 0; other < 6; ++other) {
        if (other == face) continue;
        EXPECT_EQ(pixel_of_face(cube, other, 0), colours_[other]) << face << " and " << other;
      }
      glBindTexture(GL_TEXTURE_2D, target);
      tex_sub_image(expected, 0, kSize >> level);
    }
  }
  // The cube map is sampled as it was: its first face along the positive x axis.
  static const float kX[] = {1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0};
  glEnable(GL_TEXTURE_CUBE_MAP_OES);
  glTexCoordPointer(3, GL_FLOAT, 0, kX);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  draw_texture();
  glDisable(GL_TEXTURE_CUBE_MAP_OES);
  EXPECT_EQ(pixel(), kRed);
  expect_gl_error(GL_NO_ERROR);
}

TEST_F(ImageTest, RefusedFacesOfCubeMaps) {
  constexpr EGLenum kFace = EGL_GL_TEXTURE_CUBE_MAP_NEGATIVE_Y;
  EXPECT_EGL_FAIL(create(kFace, texture(kRed)), EGL_NO_IMAGE, EGL_BAD_PARAMETER);
  EXPECT_EGL_FAIL(create(kFace, 0), EGL_NO_IMAGE, EGL_BAD_PARAMETER);
  const GLuint cube = cube_map({kRed, kRed, kRed, kRed, kRed, kRed}, 1);
  EXPECT_EGL_FAIL(create(kFace, cube, {EGL_GL_TEXTURE_LEVEL, 1}), EGL_NO_IMAGE, EGL_BAD_MATCH);
  EXPECT_NE(create(kFace, cube), EGL_NO_IMAGE);
  EXPECT_EGL_FAIL(create(kFace, cube), EGL_NO_IMAGE, EGL_BAD_ACCESS);
  EXPECT_NE(create(kFace + 1, cube), EGL_NO_IMAGE);
  // Without one of its faces, whichever is asked for; and with a level that one face has.
  GLuint incomplete = 0;
  glGenTextures(1, &incomplete);
  glBindTexture(GL_TEXTURE_CUBE_MAP_OES, incomplete);
  for (GLenum face = 0; face < 5; ++face) face_image(face, 0, kRed);
  EXPECT_EGL_FAIL(create(kFace, incomplete), EGL_NO_IMAGE, EGL_BAD_PARAMETER);
  face_image(5, 0, kRed);
  face_image(2, 1, kRed);
  EXPECT_EGL_FAIL(create(kFace, incomplete), EGL_NO_IMAGE, EGL_BAD_PARAMETER);
}

TEST_F(ImageTest, ExternalTextures) {
  const GLuint source = texture(kRed);
  const EGLImage image = image_of_texture(source);
  const EGLContext other = context();
  bind(other);
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_EXTERNAL_OES, name);
  glEnable(GL_TEXTURE_EXTERNAL_OES);
  image_target_texture(GL_TEXTURE_EXTERNAL_OES, image);
  EXPECT_EQ(look_at(0), kRed);
  bind(context_);
  tex_sub_image(kBlue);
  glFinish();
  bind(other);
  EXPECT_EQ(look_at(0), kBlue);
  EXPECT_EGL_OK(eglDestroyImage(display, image));
  EXPECT_EQ(look_at(0), kBlue);
  expect_gl_error(GL_NO_ERROR);
  // It is no source of images.
  EXPECT_EGL_FAIL(image_of_texture(name), EGL_NO_IMAGE, EGL_BAD_PARAMETER);
}

}  // namespace
}  // namespace clearpipe::icd
