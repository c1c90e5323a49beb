// Pbuffers, surface attributes and posting (3.5, 3.6, 3.10).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "icd/egl_test.h"

namespace clearpipe::icd {
namespace {

class SurfaceTest : public EglTest {
 protected:
  EGLSurface create(std::vector<EGLint> attributes) {
    attributes.push_back(EGL_NONE);
    return eglCreatePbufferSurface(display, config, attributes.data());
  }
  void expect_refused(const std::vector<EGLint>& attributes, EGLint error) {
    EXPECT_EGL_FAIL(create(attributes), EGL_NO_SURFACE, error);
  }
  EGLint config_attrib(EGLint attribute) {
    EGLint value = 0;
    eglGetConfigAttrib(display, config, attribute, &value);
    return value;
  }
};

TEST_F(SurfaceTest, AttributesAndTheirDefaults) {
  const EGLSurface surface = eglCreatePbufferSurface(display, config, nullptr);
  ASSERT_NE(surface, EGL_NO_SURFACE);
  EXPECT_EQ(query(surface, EGL_WIDTH), 0);
  EXPECT_EQ(query(surface, EGL_HEIGHT), 0);
  EXPECT_EQ(query(surface, EGL_CONFIG_ID), config_attrib(EGL_CONFIG_ID));
  EXPECT_EQ(query(surface, EGL_LARGEST_PBUFFER), EGL_FALSE);
  EXPECT_EQ(query(surface, EGL_MIPMAP_TEXTURE), EGL_FALSE);
  EXPECT_EQ(query(surface, EGL_MIPMAP_LEVEL), 0);
  EXPECT_EQ(query(surface, EGL_TEXTURE_FORMAT), EGL_NO_TEXTURE);
  EXPECT_EQ(query(surface, EGL_TEXTURE_TARGET), EGL_NO_TEXTURE);
  EXPECT_EQ(query(surface, EGL_RENDER_BUFFER), EGL_BACK_BUFFER);
  EXPECT_EQ(query(surface, EGL_MULTISAMPLE_RESOLVE), EGL_MULTISAMPLE_RESOLVE_DEFAULT);
  EXPECT_EQ(query(surface, EGL_GL_COLORSPACE), EGL_GL_COLORSPACE_LINEAR);
  EXPECT_EQ(query(surface, EGL_VG_COLORSPACE), EGL_VG_COLORSPACE_sRGB);
  EXPECT_EQ(query(surface, EGL_VG_ALPHA_FORMAT), EGL_VG_ALPHA_FORMAT_NONPRE);
  EXPECT_EQ(query(surface, EGL_HORIZONTAL_RESOLUTION), EGL_UNKNOWN);
  EXPECT_EQ(query(surface, EGL_VERTICAL_RESOLUTION), EGL_UNKNOWN);
  EXPECT_EQ(query(surface, EGL_PIXEL_ASPECT_RATIO), EGL_UNKNOWN);

  const EGLSurface other = create(
      {EGL_WIDTH, 5, EGL_HEIGHT, 7, EGL_LARGEST_PBUFFER, EGL_TRUE, EGL_MIPMAP_TEXTURE, EGL_TRUE,
       EGL_GL_COLORSPACE, EGL_GL_COLORSPACE_SRGB, EGL_TEXTURE_FORMAT, EGL_NO_TEXTURE,
       EGL_TEXTURE_TARGET, EGL_NO_TEXTURE, EGL_VG_COLORSPACE, EGL_VG_COLORSPACE_sRGB});
  ASSERT_NE(other, EGL_NO_SURFACE);
  EXPECT_EQ(query(other, EGL_WIDTH), 5);
  EXPECT_EQ(query(other, EGL_HEIGHT), 7);
  EXPECT_EQ(query(other, EGL_LARGEST_PBUFFER), EGL_TRUE);
  EXPECT_EQ(query(other, EGL_MIPMAP_TEXTURE), EGL_TRUE);
  EXPECT_EQ(query(other, EGL_GL_COLORSPACE), EGL_GL_COLORSPACE_SRGB);
}

TEST_F(SurfaceTest, RefusedAttributes) {
  expect_refused({EGL_WIDTH, -1}, EGL_BAD_PARAMETER);
  expect_refused({EGL_HEIGHT, -1}, EGL_BAD_PARAMETER);
  expect_refused({EGL_RED_SIZE, 8}, EGL_BAD_ATTRIBUTE);
  expect_refused({0x7fff, 8}, EGL_BAD_ATTRIBUTE);
  expect_refused({EGL_LARGEST_PBUFFER, 2}, EGL_BAD_ATTRIBUTE);
  expect_refused({EGL_MIPMAP_TEXTURE, 2}, EGL_BAD_ATTRIBUTE);
  expect_refused({EGL_TEXTURE_FORMAT, EGL_RGB_BUFFER}, EGL_BAD_ATTRIBUTE);
  expect_refused({EGL_TEXTURE_FORMAT, EGL_TEXTURE_RGBA}, EGL_BAD_MATCH);
  expect_refused({EGL_TEXTURE_FORMAT, EGL_TEXTURE_RGB, EGL_TEXTURE_TARGET, EGL_NO_TEXTURE},
                 EGL_BAD_MATCH);
  expect_refused({EGL_TEXTURE_TARGET, EGL_TEXTURE_2D}, EGL_BAD_MATCH);
  expect_refused({EGL_TEXTURE_TARGET, EGL_TRUE}, EGL_BAD_ATTRIBUTE);
  expect_refused({EGL_GL_COLORSPACE, EGL_TRUE}, EGL_BAD_ATTRIBUTE);
  expect_refused({EGL_VG_COLORSPACE, EGL_VG_COLORSPACE_LINEAR}, EGL_BAD_MATCH);
  expect_refused({EGL_VG_ALPHA_FORMAT, EGL_VG_ALPHA_FORMAT_PRE}, EGL_BAD_MATCH);
  EXPECT_EGL_FAIL(eglCreatePbufferSurface(display, random_handle(), nullptr), EGL_NO_SURFACE,
                  EGL_BAD_CONFIG);
  EXPECT_EGL_FAIL(eglCreatePbufferSurface(display, nullptr, nullptr), EGL_NO_SURFACE,
                  EGL_BAD_CONFIG);
}

TEST_F(SurfaceTest, Sizes) {
  const EGLint width = config_attrib(EGL_MAX_PBUFFER_WIDTH);
  const EGLint height = config_attrib(EGL_MAX_PBUFFER_HEIGHT);
  const EGLContext ctx = context();
  for (const auto& [w, h] :
       {std::pair<EGLint, EGLint>{0, 0}, {0, 9}, {9, 0}, {1, 1}, {width, 1}, {1, height}}) {
    const EGLSurface surface = pbuffer(w, h);
    ASSERT_NE(surface, EGL_NO_SURFACE) << w << " " << h;
    EXPECT_EQ(query(surface, EGL_WIDTH), w);
    EXPECT_EQ(query(surface, EGL_HEIGHT), h);
    ASSERT_TRUE(eglMakeCurrent(display, surface, surface, ctx));
    glScissor(0, 0, w, h);
    const uint32_t pixel = clear_and_read(0, 0, 1, 1, std::max(w - 1, 0), std::max(h - 1, 0));
    EXPECT_EQ(pixel, w > 0 && h > 0 ? 0xffff0000u : 0u) << w << " " << h;
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_EGL_OK(eglDestroySurface(display, surface));
  }
  expect_refused({EGL_WIDTH, width + 1, EGL_HEIGHT, 1}, EGL_BAD_ALLOC);
  expect_refused({EGL_WIDTH, 1, EGL_HEIGHT, height + 1}, EGL_BAD_ALLOC);
  expect_refused({EGL_WIDTH, 0x7fffffff, EGL_HEIGHT, 0x7fffffff}, EGL_BAD_ALLOC);
  const EGLSurface largest =
      create({EGL_WIDTH, 0x7fffffff, EGL_HEIGHT, 1, EGL_LARGEST_PBUFFER, EGL_TRUE});
  ASSERT_NE(largest, EGL_NO_SURFACE);
  EXPECT_EQ(query(largest, EGL_WIDTH), width);
  EXPECT_EQ(query(largest, EGL_HEIGHT), 1);
}

// The first binding sets viewport and scissor box, later ones do not (3.7.3).
TEST_F(SurfaceTest, FirstBindingSetsTheViewport) {
  const EGLSurface small = pbuffer(11, 13), large = pbuffer(40, 50);
  const EGLContext ctx = context();
  GLint box[4];
  for (const EGLSurface surface : {small, large}) {
    ASSERT_TRUE(eglMakeCurrent(display, surface, surface, ctx));
    for (const GLenum name : {GL_VIEWPORT, GL_SCISSOR_BOX}) {
      glGetIntegerv(name, box);
      EXPECT_EQ(box[2], 11);
      EXPECT_EQ(box[3], 13);
    }
  }
}

TEST_F(SurfaceTest, QueryAndSetErrors) {
  const EGLSurface surface = pbuffer(4, 4);
  EGLint value = 77;
  EXPECT_EGL_FAIL(eglQuerySurface(display, random_handle(), EGL_WIDTH, &value), EGL_FALSE,
                  EGL_BAD_SURFACE);
  EXPECT_EGL_FAIL(eglQuerySurface(display, EGL_NO_SURFACE, EGL_WIDTH, &value), EGL_FALSE,
                  EGL_BAD_SURFACE);
  EXPECT_EGL_FAIL(eglQuerySurface(display, surface, EGL_RED_SIZE, &value), EGL_FALSE,
                  EGL_BAD_ATTRIBUTE);
  EXPECT_EGL_FAIL(eglQuerySurface(display, surface, EGL_WIDTH, nullptr), EGL_FALSE,
                  EGL_BAD_PARAMETER);
  EXPECT_EQ(value, 77);
  EXPECT_EGL_FAIL(eglSurfaceAttrib(display, random_handle(), EGL_MIPMAP_LEVEL, 1), EGL_FALSE,
                  EGL_BAD_SURFACE);
  EXPECT_EGL_FAIL(eglSurfaceAttrib(display, surface, EGL_WIDTH, 1), EGL_FALSE, EGL_BAD_ATTRIBUTE);
  EXPECT_EGL_FAIL(
      eglSurfaceAttrib(display, surface, EGL_MULTISAMPLE_RESOLVE, EGL_MULTISAMPLE_RESOLVE_BOX),
      EGL_FALSE, EGL_BAD_MATCH);
  EXPECT_EGL_FAIL(eglSurfaceAttrib(display, surface, EGL_SWAP_BEHAVIOR, 5), EGL_FALSE,
                  EGL_BAD_PARAMETER);
}

// 3.5.6: the box is the filter, and can be asked for where there is something to filter.
TEST_F(SurfaceTest, MultisampleSurfaces) {
  const EGLConfig multisampled =
      choose({EGL_SAMPLES, 4, EGL_RED_SIZE, 8, EGL_DEPTH_SIZE, 24, EGL_STENCIL_SIZE, 8});
  ASSERT_NE(multisampled, nullptr);
  EGLint types = 0;
  EXPECT_EGL_OK(eglGetConfigAttrib(display, multisampled, EGL_SURFACE_TYPE, &types));
  EXPECT_TRUE(types & EGL_MULTISAMPLE_RESOLVE_BOX_BIT);
  EXPECT_FALSE(config_attrib(EGL_SURFACE_TYPE) & EGL_MULTISAMPLE_RESOLVE_BOX_BIT);
  const EGLSurface surface = pbuffer(multisampled, 9, 9);
  EXPECT_EQ(query(surface, EGL_MULTISAMPLE_RESOLVE), EGL_MULTISAMPLE_RESOLVE_DEFAULT);
  for (const EGLint filter : {EGL_MULTISAMPLE_RESOLVE_BOX, EGL_MULTISAMPLE_RESOLVE_DEFAULT}) {
    EXPECT_EGL_OK(eglSurfaceAttrib(display, surface, EGL_MULTISAMPLE_RESOLVE, filter));
    EXPECT_EQ(query(surface, EGL_MULTISAMPLE_RESOLVE), filter);
  }
  EXPECT_EGL_FAIL(eglSurfaceAttrib(display, surface, EGL_MULTISAMPLE_RESOLVE, 5), EGL_FALSE,
                  EGL_BAD_PARAMETER);

  // The edge of a triangle along the diagonal, after a swap.
  const EGLContext made = eglCreateContext(display, multisampled, EGL_NO_CONTEXT, nullptr);
  ASSERT_NE(made, EGL_NO_CONTEXT);
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, made));
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  EXPECT_EQ(samples, 4);
  EXPECT_EQ(clear_and_read(0, 0, 0, 1), 0xff000000u);
  const float corners[] = {-1, -1, 1, -1, -1, 1};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, corners);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  EXPECT_EGL_OK(eglSwapBuffers(display, surface));
  for (int x = 0; x < 9; ++x) {
    uint32_t pixel = 0;
    glReadPixels(x, 8 - x, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
    EXPECT_EQ(pixel, 0xff808080u) << x;  // two of the four places lie below the diagonal
  }
  // Buffers of another kind do not fit (2.2).
  EXPECT_EGL_FAIL(eglMakeCurrent(display, pbuffer(9, 9), pbuffer(9, 9), made), EGL_FALSE,
                  EGL_BAD_MATCH);
}

TEST_F(SurfaceTest, SetAttributes) {
  const EGLSurface surface = pbuffer(4, 4);
  EXPECT_EGL_OK(eglSurfaceAttrib(display, surface, EGL_MIPMAP_LEVEL, 3));
  EXPECT_EQ(query(surface, EGL_MIPMAP_LEVEL), 3);
  EXPECT_EGL_OK(
      eglSurfaceAttrib(display, surface, EGL_MULTISAMPLE_RESOLVE, EGL_MULTISAMPLE_RESOLVE_DEFAULT));
  for (const EGLint behaviour : {EGL_BUFFER_DESTROYED, EGL_BUFFER_PRESERVED}) {
    EXPECT_EGL_OK(eglSurfaceAttrib(display, surface, EGL_SWAP_BEHAVIOR, behaviour));
    EXPECT_EQ(query(surface, EGL_SWAP_BEHAVIOR), behaviour);
  }
  EXPECT_TRUE(config_attrib(EGL_SURFACE_TYPE) & EGL_SWAP_BEHAVIOR_PRESERVED_BIT);
}

// Whatever the arguments are (EGL_MESA_platform_surfaceless).
TEST_F(SurfaceTest, NoWindowsPixmapsOrClientBuffers) {
  int native = 0;
  for (const EGLConfig any : {config, EGLConfig{random_handle()}, EGLConfig{}}) {
    EXPECT_EGL_FAIL(eglCreateWindowSurface(display, any, 0, nullptr), EGL_NO_SURFACE,
                    EGL_BAD_NATIVE_WINDOW);
    EXPECT_EGL_FAIL(eglCreatePixmapSurface(display, any, 0, nullptr), EGL_NO_SURFACE,
                    EGL_BAD_NATIVE_PIXMAP);
    EXPECT_EGL_FAIL(eglCreatePlatformWindowSurface(display, any, &native, nullptr), EGL_NO_SURFACE,
                    EGL_BAD_NATIVE_WINDOW);
    EXPECT_EGL_FAIL(eglCreatePlatformPixmapSurface(display, any, &native, nullptr), EGL_NO_SURFACE,
                    EGL_BAD_NATIVE_PIXMAP);
  }
  for (const EGLenum type : {EGL_OPENVG_IMAGE, EGL_NONE}) {
    EXPECT_EGL_FAIL(
        eglCreatePbufferFromClientBuffer(display, type, random_handle(), config, nullptr),
        EGL_NO_SURFACE, EGL_BAD_PARAMETER);
  }
  const EGLSurface surface = pbuffer(4, 4);
  EXPECT_EGL_FAIL(eglCopyBuffers(display, surface, 0), EGL_FALSE, EGL_BAD_NATIVE_PIXMAP);
  EXPECT_EGL_FAIL(eglCopyBuffers(display, random_handle(), 0), EGL_FALSE, EGL_BAD_SURFACE);
}

TEST_F(SurfaceTest, DestroyedHandlesAreVoidForGood) {
  const EGLSurface surface = pbuffer(4, 4);
  EXPECT_EGL_OK(eglDestroySurface(display, surface));
  for (int i = 0; i < 64; ++i) ASSERT_NE(pbuffer(4, 4), surface);
  EXPECT_EGL_FAIL(eglDestroySurface(display, surface), EGL_FALSE, EGL_BAD_SURFACE);
  EXPECT_EGL_FAIL(eglSwapBuffers(display, surface), EGL_FALSE, EGL_BAD_SURFACE);
}

// 3.5.5: what is destroyed while current is still drawn to; only its handle is void.
TEST_F(SurfaceTest, DestroyWhileCurrent) {
  const EGLSurface surface = pbuffer(4, 4);
  const EGLContext ctx = context();
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, ctx));
  EXPECT_EGL_OK(eglDestroySurface(display, surface));
  EXPECT_EQ(clear_and_read(1, 0, 1, 1, 3, 3), 0xffff00ffu);
  EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), surface);
  EXPECT_EGL_FAIL(eglSwapBuffers(display, surface), EGL_FALSE, EGL_BAD_SURFACE);
  EXPECT_EGL_FAIL(eglWaitClient(), EGL_FALSE, EGL_BAD_CURRENT_SURFACE);
  EXPECT_EGL_FAIL(eglWaitGL(), EGL_FALSE, EGL_BAD_CURRENT_SURFACE);
  EXPECT_EGL_FAIL(eglWaitNative(EGL_CORE_NATIVE_ENGINE), EGL_FALSE, EGL_BAD_CURRENT_SURFACE);
  const EGLSurface next = pbuffer(4, 4);
  EXPECT_EGL_OK(eglMakeCurrent(display, next, next, ctx));
  EXPECT_EGL_OK(eglWaitClient());
}

// 3.10: a pbuffer keeps its pixels; what is posted is the draw surface of the current context, or,
// by EGL_KHR_lock_surface3, one that can be locked and is current to none.
TEST_F(SurfaceTest, Posting) {
  const EGLSurface draw = pbuffer(4, 4), read = pbuffer(4, 4);
  const EGLContext ctx = context();
  const EGLSurface samples = pbuffer(choose({EGL_SAMPLES, 4}), 4, 4);
  EXPECT_EGL_FAIL(eglSwapBuffers(display, samples), EGL_FALSE, EGL_BAD_SURFACE);
  EXPECT_EGL_OK(eglSwapBuffers(display, draw));
  EXPECT_EGL_FAIL(eglSwapInterval(display, 1), EGL_FALSE, EGL_BAD_CONTEXT);
  ASSERT_TRUE(eglMakeCurrent(display, draw, read, ctx));
  EXPECT_EGL_FAIL(eglSwapBuffers(display, read), EGL_FALSE, EGL_BAD_SURFACE);
  EXPECT_EGL_FAIL(eglSwapBuffers(display, EGL_NO_SURFACE), EGL_FALSE, EGL_BAD_SURFACE);
  EXPECT_EGL_FAIL(eglSwapBuffers(display, random_handle()), EGL_FALSE, EGL_BAD_SURFACE);
  for (const EGLint interval : {-5, 0, 1, 100}) EXPECT_EGL_OK(eglSwapInterval(display, interval));
  EXPECT_EQ(clear_and_read(1, 1, 0, 1), 0u);  // drawn to one surface, read from the other
  EXPECT_EGL_OK(eglSwapBuffers(display, draw));
  ASSERT_TRUE(eglMakeCurrent(display, draw, draw, ctx));
  uint32_t pixel = 0;
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
  EXPECT_EQ(pixel, 0xff00ffffu);
  ASSERT_TRUE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, ctx));
  EXPECT_EGL_FAIL(eglSwapInterval(display, 1), EGL_FALSE, EGL_BAD_SURFACE);
  EXPECT_EGL_FAIL(eglSwapBuffers(display, samples), EGL_FALSE, EGL_BAD_SURFACE);
}

// A config without alpha reads as opaque whatever is written.
TEST_F(SurfaceTest, WithoutAlpha) {
  config = choose({EGL_ALPHA_SIZE, 0});
  const EGLSurface surface = pbuffer(4, 4);
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, context()));
  EXPECT_EQ(clear_and_read(0, 1, 0, 0), 0xff00ff00u);
  GLint bits = -1;
  glGetIntegerv(GL_ALPHA_BITS, &bits);
  EXPECT_EQ(bits, 0);
  glGetIntegerv(GL_DEPTH_BITS, &bits);
  EXPECT_EQ(bits, 0);
}

}  // namespace
}  // namespace clearpipe::icd
