// Surfaces as textures (3.6): eglBindTexImage and eglReleaseTexImage of pbuffers, and drawing to
// the levels of a mipmap. SPDX-License-Identifier: MIT

#include "icd/egl_test.h"

namespace clearpipe::icd {
namespace {

constexpr uint32_t kRed = 0xff0000ffu, kGreen = 0xff00ff00u, kBlue = 0xffff0000u,
                   kWhite = 0xffffffffu;

class SurfaceTextureTest : public EglTest {
 protected:
  void SetUp() override {
    EglTest::SetUp();
    screen_ = pbuffer(8, 8);
    context_ = context();
    ASSERT_TRUE(eglMakeCurrent(display, screen_, screen_, context_));
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  }
  EGLSurface texture_pbuffer(EGLint format = EGL_TEXTURE_RGBA, EGLint width = 8, EGLint height = 8,
                             EGLint mipmap = EGL_FALSE) {
    const EGLint list[] = {EGL_WIDTH,
                           width,
                           EGL_HEIGHT,
                           height,
                           EGL_TEXTURE_FORMAT,
                           format,
                           EGL_TEXTURE_TARGET,
                           EGL_TEXTURE_2D,
                           EGL_MIPMAP_TEXTURE,
                           mipmap,
                           EGL_NONE};
    return eglCreatePbufferSurface(display, config, list);
  }
  // Draws one colour to the surface, and goes back to the one that is looked at.
  void fill(EGLSurface surface, uint32_t colour) {
    ASSERT_TRUE(eglMakeCurrent(display, surface, surface, context_));
    clear(colour);
    ASSERT_TRUE(eglMakeCurrent(display, screen_, screen_, context_));
  }
  static GLuint new_texture(GLint filter = GL_NEAREST) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    return name;
  }
  bool bind(EGLSurface surface) { return eglBindTexImage(display, surface, EGL_BACK_BUFFER); }
  bool release(EGLSurface surface) { return eglReleaseTexImage(display, surface, EGL_BACK_BUFFER); }
  // The texture drawn over a part of the surface that gives it this many pixels.
  static uint32_t look(GLsizei size = 8) {
    static const float kQuad[] = {-1, -1, 1, -1, -1, 1, 1, 1};
    static const float kCorners[] = {0, 0, 1, 0, 0, 1, 1, 1};
    glViewport(0, 0, size, size);
    clear(0);
    glColor4f(0, 0, 0, 0);
    glEnable(GL_TEXTURE_2D);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, kQuad);
    glTexCoordPointer(2, GL_FLOAT, 0, kCorners);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    uint32_t pixel = 0;
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
    return pixel;
  }

  EGLSurface screen_ = EGL_NO_SURFACE;
  EGLContext context_ = EGL_NO_CONTEXT;
};

TEST_F(SurfaceTextureTest, Attributes) {
  const EGLSurface surface = texture_pbuffer(EGL_TEXTURE_RGB, 8, 8, EGL_TRUE);
  ASSERT_NE(surface, EGL_NO_SURFACE);
  EXPECT_EQ(query(surface, EGL_TEXTURE_FORMAT), EGL_TEXTURE_RGB);
  EXPECT_EQ(query(surface, EGL_TEXTURE_TARGET), EGL_TEXTURE_2D);
  EXPECT_EQ(query(surface, EGL_MIPMAP_TEXTURE), EGL_TRUE);
  config = choose({EGL_ALPHA_SIZE, 0});
  EXPECT_NE(texture_pbuffer(EGL_TEXTURE_RGB), EGL_NO_SURFACE);
  EXPECT_NE(texture_pbuffer(EGL_TEXTURE_RGBA), EGL_NO_SURFACE);
}

TEST_F(SurfaceTextureTest, Errors) {
  const EGLSurface plain = pbuffer(8, 8), surface = texture_pbuffer();
  for (const auto call : {eglBindTexImage, eglReleaseTexImage}) {
    EXPECT_EGL_FAIL(call(display, plain, EGL_BACK_BUFFER), EGL_FALSE, EGL_BAD_MATCH);
    EXPECT_EGL_FAIL(call(display, surface, EGL_SINGLE_BUFFER), EGL_FALSE, EGL_BAD_PARAMETER);
    EXPECT_EGL_FAIL(call(display, random_handle(), EGL_BACK_BUFFER), EGL_FALSE, EGL_BAD_SURFACE);
    EXPECT_EGL_FAIL(call(random_handle(), surface, EGL_BACK_BUFFER), EGL_FALSE, EGL_BAD_DISPLAY);
  }
  new_texture();
  EXPECT_EGL_OK(bind(surface));
  EXPECT_EGL_FAIL(bind(surface), EGL_FALSE, EGL_BAD_ACCESS);
  EXPECT_EGL_OK(release(surface));
  EXPECT_EGL_OK(release(surface));  // not bound any more: no effect, no error
  EXPECT_EGL_OK(bind(surface));
  EXPECT_EGL_OK(release(surface));
  ASSERT_TRUE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
  EXPECT_EGL_OK(bind(surface));  // ignored without a context
  EXPECT_EGL_OK(bind(surface));
}

TEST_F(SurfaceTextureTest, TheTextureShowsTheSurface) {
  const EGLSurface surface = texture_pbuffer();
  fill(surface, kRed & 0x80ffffffu);
  new_texture();
  EXPECT_TRUE(bind(surface));
  EXPECT_EQ(look(), kRed & 0x80ffffffu);
  EXPECT_TRUE(release(surface));
  EXPECT_EQ(look(), 0u);  // no image: as if texturing were disabled
  fill(surface, kGreen);
  EXPECT_TRUE(bind(surface));
  EXPECT_EQ(look(), kGreen);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

// A texture of the format RGB has no alpha, whatever the surface has.
TEST_F(SurfaceTextureTest, FormatWithoutAlpha) {
  const EGLSurface surface = texture_pbuffer(EGL_TEXTURE_RGB);
  fill(surface, kBlue & 0x20ffffffu);
  new_texture();
  EXPECT_TRUE(bind(surface));
  EXPECT_EQ(look(), kBlue & 0x00ffffffu);  // REPLACE takes the fragment's alpha (table 3.15)
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
  EXPECT_EQ(look() >> 24, 0u);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_REPLACE);
  EXPECT_EQ(look() >> 24, 255u);
}

// A surface without alpha makes opaque textures of RGBA.
TEST_F(SurfaceTextureTest, SurfaceWithoutAlpha) {
  config = choose({EGL_ALPHA_SIZE, 0});
  const EGLSurface surface = texture_pbuffer(EGL_TEXTURE_RGBA);
  const EGLContext opaque = context(context_);
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, opaque));
  clear(kBlue & 0x20ffffffu);
  ASSERT_TRUE(eglMakeCurrent(display, screen_, screen_, context_));
  new_texture();
  EXPECT_EGL_OK(bind(surface));
  EXPECT_EQ(look(), kBlue);
}

// Specified otherwise or deleted, the texture releases the surface (3.6.1).
TEST_F(SurfaceTextureTest, ImplicitRelease) {
  const EGLSurface surface = texture_pbuffer();
  fill(surface, kRed);
  GLuint name = new_texture();
  EXPECT_TRUE(bind(surface));
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &kWhite);
  EXPECT_EQ(look(), kWhite);
  EXPECT_EGL_OK(bind(surface));
  EXPECT_EQ(look(), kRed);
  // Another level: even so, and the surface's images are gone.
  glTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &kWhite);
  EXPECT_EQ(look(), 0u);
  EXPECT_EGL_OK(bind(surface));
  glDeleteTextures(1, &name);
  new_texture();
  EXPECT_EGL_OK(bind(surface));
  EXPECT_EQ(look(), kRed);
  // Another surface bound to the same texture.
  const EGLSurface other = texture_pbuffer();
  fill(other, kGreen);
  EXPECT_EGL_OK(bind(other));
  EXPECT_EQ(look(), kGreen);
  EXPECT_EGL_OK(release(surface));
  EXPECT_EQ(look(), kGreen);
  EXPECT_EGL_OK(bind(texture_pbuffer()));
  EXPECT_EGL_OK(bind(other));
}

// A part of the image changed, it is still the surface's.
TEST_F(SurfaceTextureTest, PartsMayBeReplaced) {
  const EGLSurface surface = texture_pbuffer();
  fill(surface, kRed);
  new_texture();
  EXPECT_TRUE(bind(surface));
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &kWhite);
  EXPECT_EQ(look(), kWhite);
  EXPECT_EGL_FAIL(bind(surface), EGL_FALSE, EGL_BAD_ACCESS);
}

// The texture is the share group's, and so are its images.
TEST_F(SurfaceTextureTest, SharedTextures) {
  const EGLSurface surface = texture_pbuffer();
  fill(surface, kRed);
  const GLuint name = new_texture();
  EXPECT_TRUE(bind(surface));
  const EGLContext other = context(context_);
  ASSERT_TRUE(eglMakeCurrent(display, screen_, screen_, other));
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  glBindTexture(GL_TEXTURE_2D, name);
  EXPECT_EQ(look(), kRed);
  EXPECT_TRUE(release(surface));
  EXPECT_EQ(look(), 0u);
  // Destroyed while it is bound: the texture keeps its images.
  EXPECT_TRUE(bind(surface));
  EXPECT_EGL_OK(eglDestroySurface(display, surface));
  EXPECT_EQ(look(), kRed);
}

TEST_F(SurfaceTextureTest, NoImagesOfIt) {
  const EGLSurface surface = texture_pbuffer();
  const GLuint name = new_texture();
  EXPECT_TRUE(bind(surface));
  const auto buffer = reinterpret_cast<EGLClientBuffer>(static_cast<uintptr_t>(name));
  EXPECT_EGL_FAIL(eglCreateImage(display, context_, EGL_GL_TEXTURE_2D, buffer, nullptr),
                  EGL_NO_IMAGE, EGL_BAD_ACCESS);
}

// Levels drawn one by one (EGL_MIPMAP_LEVEL, 3.5.6).
TEST_F(SurfaceTextureTest, DrawnLevels) {
  constexpr uint32_t kColours[] = {kRed, kGreen, kBlue, kWhite};
  const EGLSurface surface = texture_pbuffer(EGL_TEXTURE_RGBA, 8, 8, EGL_TRUE);
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, context_));
  for (EGLint level = 0; level < 4; ++level) {
    EXPECT_EGL_OK(eglSurfaceAttrib(display, surface, EGL_MIPMAP_LEVEL, level));
    clear(kColours[level]);
    uint32_t inside = 0, outside = 0x1234u;
    glReadPixels((8 >> level) - 1, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &inside);
    glReadPixels(8 >> level, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &outside);
    EXPECT_EQ(inside, kColours[level]);
    EXPECT_NE(outside, kColours[level]);
  }
  // Beyond the last one, the last one.
  EXPECT_EGL_OK(eglSurfaceAttrib(display, surface, EGL_MIPMAP_LEVEL, 9));
  EXPECT_EQ(query(surface, EGL_MIPMAP_LEVEL), 9);
  clear(kWhite & 0x7fffffffu);
  EXPECT_EQ(query(surface, EGL_WIDTH), 8);
  ASSERT_TRUE(eglMakeCurrent(display, screen_, screen_, context_));
  new_texture(GL_NEAREST_MIPMAP_NEAREST);
  EXPECT_TRUE(bind(surface));
  for (int level = 0; level < 3; ++level) EXPECT_EQ(look(8 >> level), kColours[level]);
  EXPECT_EQ(look(1), kWhite & 0x7fffffffu);
}

// A surface without a texture has no levels: the attribute may be set, without effect.
TEST_F(SurfaceTextureTest, LevelOfNothing) {
  EXPECT_EGL_OK(eglSurfaceAttrib(display, screen_, EGL_MIPMAP_LEVEL, 2));
  clear(kGreen);
  uint32_t pixel = 0;
  glReadPixels(7, 7, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
  EXPECT_EQ(pixel, kGreen);
}

// Generated on binding when surface and texture both say so (3.6.1).
TEST_F(SurfaceTextureTest, GeneratedLevels) {
  for (const EGLint mipmap : {EGL_TRUE, EGL_FALSE}) {
    const EGLSurface surface = texture_pbuffer(EGL_TEXTURE_RGBA, 8, 8, mipmap);
    fill(surface, kGreen);
    new_texture(GL_NEAREST_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    EXPECT_TRUE(bind(surface));
    EXPECT_EQ(look(1), mipmap ? kGreen : 0u);
  }
}

TEST_F(SurfaceTextureTest, SurfaceWithoutPixels) {
  const EGLSurface surface = texture_pbuffer(EGL_TEXTURE_RGBA, 0, 0, EGL_TRUE);
  new_texture();
  EXPECT_EGL_OK(bind(surface));
  EXPECT_EQ(look(), 0u);
  EXPECT_EGL_OK(release(surface));
}

}  // namespace
}  // namespace clearpipe::icd
