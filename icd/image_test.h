// What the tests of EGLImages share: contexts with textures, renderbuffers and framebuffers of one
// colour, and looks at what is in them.
// SPDX-License-Identifier: MIT
#pragma once

#include "icd/egl_test.h"

namespace clearpipe::icd {

inline constexpr uint32_t kRed = 0xff0000ffu, kGreen = 0xff00ff00u, kBlue = 0xffff0000u,
                          kWhite = 0xffffffffu;
inline constexpr int kSize = 8;

class ImageTest : public EglTest {
 protected:
  void SetUp() override {
    EglTest::SetUp();
    surface_ = pbuffer(kSize, kSize);
    context_ = context();
    bind(context_);
  }
  void bind(EGLContext ctx) { ASSERT_TRUE(eglMakeCurrent(display, surface_, surface_, ctx)); }

  static EGLClientBuffer buffer(GLuint name) {
    return reinterpret_cast<EGLClientBuffer>(static_cast<uintptr_t>(name));
  }
  EGLImage create(EGLenum target, GLuint name, std::vector<EGLAttrib> attributes = {}) {
    attributes.push_back(EGL_NONE);
    return eglCreateImage(display, eglGetCurrentContext(), target, buffer(name), attributes.data());
  }
  EGLImage image_of_texture(GLuint name, EGLAttrib level = 0) {
    return create(EGL_GL_TEXTURE_2D, name, {EGL_GL_TEXTURE_LEVEL, level});
  }
  static std::vector<uint32_t> texels(uint32_t colour, int size) {
    return std::vector<uint32_t>(static_cast<size_t>(size * size), colour);
  }
  static void tex_image(uint32_t colour, int level = 0, int size = kSize) {
    glTexImage2D(GL_TEXTURE_2D, level, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels(colour, size).data());
  }
  static void tex_sub_image(uint32_t colour, int level = 0, int size = kSize) {
    glTexSubImage2D(GL_TEXTURE_2D, level, 0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE,
                    texels(colour, size).data());
  }
  // A new texture, bound, without images.
  static GLuint empty_texture() {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return name;
  }
  static GLuint texture(uint32_t colour) {
    const GLuint name = empty_texture();
    tex_image(colour);
    return name;
  }
  static void face_image(GLenum face, GLint level, uint32_t colour) {
    const int size = kSize >> level;
    glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face, level, GL_RGBA, size, size, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, texels(colour, size).data());
  }
  // A cube map with one or all levels: the base in these colours, the rest in their complements.
  GLuint cube_map(const std::array<uint32_t, 6>& colours, int levels) {
    colours_ = colours;
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_CUBE_MAP_OES, name);
    glTexParameteri(GL_TEXTURE_CUBE_MAP_OES, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_CUBE_MAP_OES, GL_TEXTURE_MIN_FILTER,
                    levels == 1 ? GL_NEAREST : GL_NEAREST_MIPMAP_NEAREST);
    for (GLenum face = 0; face < 6; ++face) {
      for (GLint i = 0; kSize >> i > 0 && (i == 0 || levels > 1); ++i) {
        face_image(face, i, i == 0 ? colours[face] : ~colours[face] | 0xff000000u);
      }
    }
    return name;
  }
  // Of a face as a framebuffer.
  uint32_t pixel_of_face(GLuint name, GLenum face, GLint level) {
    framebuffer();
    framebuffer_texture(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES,
                        GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face, name, level);
    const uint32_t value = pixel();
    to_surface();
    return value;
  }
  GLuint target_texture(EGLImage image) {
    const GLuint name = empty_texture();
    image_target_texture(GL_TEXTURE_2D, image);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    return name;
  }
  // Draws with what is bound to the texture unit, onto black.
  static void draw_texture() {
    static const float kQuad[] = {-1, -1, 1, -1, -1, 1, 1, 1};
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, kQuad);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glDisable(GL_TEXTURE_2D);
  }
  static uint32_t pixel(int x = 1, int y = 1) {
    uint32_t value = 0;
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &value);
    return value;
  }
  static uint32_t look_at(GLuint name) {
    glBindTexture(GL_TEXTURE_2D, name);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    draw_texture();
    return pixel();
  }
  GLuint framebuffer() {
    GLuint name = 0;
    gen_framebuffers(1, &name);
    bind_framebuffer(GL_FRAMEBUFFER_OES, name);
    return name;
  }
  // A framebuffer that draws to the texture, bound.
  GLuint framebuffer_of_texture(GLuint name, GLint level = 0) {
    const GLuint result = framebuffer();
    framebuffer_texture(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, name, level);
    EXPECT_EQ(check_framebuffer(GL_FRAMEBUFFER_OES),
              static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE_OES));
    return result;
  }
  GLuint empty_renderbuffer() {
    GLuint name = 0;
    gen_renderbuffers(1, &name);
    bind_renderbuffer(GL_RENDERBUFFER_OES, name);
    return name;
  }
  GLuint renderbuffer(GLenum format, int size = kSize) {
    const GLuint name = empty_renderbuffer();
    renderbuffer_storage(GL_RENDERBUFFER_OES, format, size, size);
    return name;
  }
  GLuint framebuffer_of_renderbuffer(GLuint name) {
    const GLuint result = framebuffer();
    framebuffer_renderbuffer(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_RENDERBUFFER_OES,
                             name);
    EXPECT_EQ(check_framebuffer(GL_FRAMEBUFFER_OES),
              static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE_OES));
    return result;
  }
  void to_surface() { bind_framebuffer(GL_FRAMEBUFFER_OES, 0); }
  void expect_gl_error(GLenum error) { EXPECT_EQ(glGetError(), error); }

  EGLSurface surface_ = EGL_NO_SURFACE;
  EGLContext context_ = EGL_NO_CONTEXT;
  std::array<uint32_t, 6> colours_ = {};

  PFNEGLCREATEIMAGEKHRPROC create_khr = proc<PFNEGLCREATEIMAGEKHRPROC>("eglCreateImageKHR");
  PFNEGLDESTROYIMAGEKHRPROC destroy_khr = proc<PFNEGLDESTROYIMAGEKHRPROC>("eglDestroyImageKHR");
  PFNGLEGLIMAGETARGETTEXTURE2DOESPROC image_target_texture =
      proc<PFNGLEGLIMAGETARGETTEXTURE2DOESPROC>("glEGLImageTargetTexture2DOES");
  PFNGLEGLIMAGETARGETRENDERBUFFERSTORAGEOESPROC image_target_renderbuffer =
      proc<PFNGLEGLIMAGETARGETRENDERBUFFERSTORAGEOESPROC>("glEGLImageTargetRenderbufferStorageOES");
  PFNGLGENFRAMEBUFFERSOESPROC gen_framebuffers =
      proc<PFNGLGENFRAMEBUFFERSOESPROC>("glGenFramebuffersOES");
  PFNGLBINDFRAMEBUFFEROESPROC bind_framebuffer =
      proc<PFNGLBINDFRAMEBUFFEROESPROC>("glBindFramebufferOES");
  PFNGLFRAMEBUFFERTEXTURE2DOESPROC framebuffer_texture =
      proc<PFNGLFRAMEBUFFERTEXTURE2DOESPROC>("glFramebufferTexture2DOES");
  PFNGLFRAMEBUFFERRENDERBUFFEROESPROC framebuffer_renderbuffer =
      proc<PFNGLFRAMEBUFFERRENDERBUFFEROESPROC>("glFramebufferRenderbufferOES");
  PFNGLCHECKFRAMEBUFFERSTATUSOESPROC check_framebuffer =
      proc<PFNGLCHECKFRAMEBUFFERSTATUSOESPROC>("glCheckFramebufferStatusOES");
  PFNGLGENRENDERBUFFERSOESPROC gen_renderbuffers =
      proc<PFNGLGENRENDERBUFFERSOESPROC>("glGenRenderbuffersOES");
  PFNGLBINDRENDERBUFFEROESPROC bind_renderbuffer =
      proc<PFNGLBINDRENDERBUFFEROESPROC>("glBindRenderbufferOES");
  PFNGLRENDERBUFFERSTORAGEOESPROC renderbuffer_storage =
      proc<PFNGLRENDERBUFFERSTORAGEOESPROC>("glRenderbufferStorageOES");
  PFNGLGETRENDERBUFFERPARAMETERIVOESPROC get_renderbuffer =
      proc<PFNGLGETRENDERBUFFERPARAMETERIVOESPROC>("glGetRenderbufferParameterivOES");
  PFNGLDELETERENDERBUFFERSOESPROC delete_renderbuffers =
      proc<PFNGLDELETERENDERBUFFERSOESPROC>("glDeleteRenderbuffersOES");
  PFNGLGENERATEMIPMAPOESPROC generate_mipmap =
      proc<PFNGLGENERATEMIPMAPOESPROC>("glGenerateMipmapOES");
};

}  // namespace clearpipe::icd
