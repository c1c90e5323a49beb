// SPDX-License-Identifier: MIT
//
// Pixels that come and go: textures given anew, pictures read back, framebuffer objects, copies,
// and frames shown in a window.
#include "bench/scene.h"
#include "bench/shapes.h"

#include <GLES/glext.h>

#include <array>
#include <vector>

namespace bench {

namespace {

constexpr int kTextureSize = 1024;

std::vector<GLubyte> pixels;

// The texture's texels come from memory that differs from frame to frame.
double set_up_upload(const View&) {
  use_noise_texture(1, {.size = 1});
  pixels = noise_bytes(4, size_t(kTextureSize) * kTextureSize * 4 + 16 * 64);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, kTextureSize, kTextureSize, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               nullptr);
  use_corner_coordinates(0, 1, false);
  return double(kTextureSize) * kTextureSize;
}

// A small rectangle shows it, as what is never drawn need never arrive.
void show_texture() {
  glClear(GL_COLOR_BUFFER_BIT);
  glPushMatrix();
  glScalef(0.1f, 0.1f, 1);
  draw_whole();
  glPopMatrix();
}

void upload(const View&, int number) {
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kTextureSize, kTextureSize, GL_RGBA, GL_UNSIGNED_BYTE,
                  pixels.data() + 16 * (number % 64));
  show_texture();
}

void upload_new(const View&, int number) {
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, kTextureSize, kTextureSize, 0, GL_RGB,
               GL_UNSIGNED_SHORT_5_6_5, pixels.data() + 16 * (number % 64));
  show_texture();
}

// A picture that was drawn once, of which each frame changes a little.
double set_up_readback(const View& view) {
  pixels.resize(size_t(view.width) * size_t(view.height) * 4);
  use_corner_colours();
  draw_whole();
  return view.pixels();
}

void readback(const View& view, int number) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(number % 8, 0, 8, 8);
  draw_whole();
  glReadPixels(0, 0, view.width, view.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
}

GLuint target;
PFNGLGENFRAMEBUFFERSOESPROC glGenFramebuffersOES;
PFNGLBINDFRAMEBUFFEROESPROC glBindFramebufferOES;
PFNGLFRAMEBUFFERTEXTURE2DOESPROC glFramebufferTexture2DOES;
PFNGLCHECKFRAMEBUFFERSTATUSOESPROC glCheckFramebufferStatusOES;

double set_up_framebuffer(const View& view) {
  find_function("glGenFramebuffersOES", glGenFramebuffersOES);
  find_function("glBindFramebufferOES", glBindFramebufferOES);
  find_function("glFramebufferTexture2DOES", glFramebufferTexture2DOES);
  find_function("glCheckFramebufferStatusOES", glCheckFramebufferStatusOES);
  target = use_noise_texture(1, {.size = 512, .wrap = GL_CLAMP_TO_EDGE});
  GLuint framebuffer;
  glGenFramebuffersOES(1, &framebuffer);
  glBindFramebufferOES(GL_FRAMEBUFFER_OES, framebuffer);
  glFramebufferTexture2DOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, target, 0);
  if (glCheckFramebufferStatusOES(GL_FRAMEBUFFER_OES) != GL_FRAMEBUFFER_COMPLETE_OES) {
    fail("the framebuffer object");
  }
  glBindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
  use_corner_coordinates(0, 1);
  target = framebuffer;
  return 512.0 * 512 + view.pixels();
}

// Draws a texture, and then with it.
void to_a_texture(const View& view, int number) {
  glBindFramebufferOES(GL_FRAMEBUFFER_OES, target);
  glViewport(0, 0, 512, 512);
  glDisable(GL_TEXTURE_2D);
  use_corner_colours();
  glClearColor(0.1f, 0.2f, 0.3f, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glPushMatrix();
  glRotatef(20 + float(number % 20), 0, 0, 1);
  draw_whole();
  glPopMatrix();

  glBindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
  glViewport(0, 0, view.width, view.height);
  glDisableClientState(GL_COLOR_ARRAY);
  glColor4f(1, 1, 1, 1);
  glEnable(GL_TEXTURE_2D);
  draw_whole();
}

double set_up_copy(const View& view) {
  use_noise_texture(1, {.size = 256});
  use_corner_coordinates(0, 2);
  use_corner_colours();
  return 256.0 * 256 + view.pixels();
}

void copy_to_a_texture(const View&, int) {
  draw_whole();
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 256, 256);
  glClear(GL_COLOR_BUFFER_BIT);
  show_texture();
}

double set_up_window(const View& view) {
  use_corner_colours();
  return view.pixels();
}

void show(const View&, int number) {
  glClearColor(0.1f * float(number % 8), 0.3f, 0.3f, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glPushMatrix();
  glRotatef(float(number % 90), 0, 0, 1);
  glScalef(0.5f, 0.5f, 1);
  draw_whole();
  glPopMatrix();
}

constexpr std::array kScenes = {
    Scene{.name = "upload_rgba",
          .what = "1024 x 1024 texels replaced",
          .unit = "texel",
          .amount = 0,
          .set_up = set_up_upload,
          .frame = upload,
          .bytes = 4,
          .traffic = "copy"},
    Scene{.name = "upload_new_565",
          .what = "a new image of 1024 x 1024 texels of 16 bits",
          .unit = "texel",
          .amount = 0,
          .set_up = set_up_upload,
          .frame = upload_new},
    Scene{.name = "readback",
          .what = "the whole surface read",
          .unit = "pixel",
          .amount = 0,
          .set_up = set_up_readback,
          .frame = readback,
          .bytes = 4,
          .traffic = "copy"},
    Scene{.name = "framebuffer_object",
          .what = "a texture of 512 x 512 drawn, and drawn with",
          .unit = "pixel",
          .amount = 0,
          .set_up = set_up_framebuffer,
          .frame = to_a_texture},
    Scene{.name = "copy_to_texture",
          .what = "256 x 256 pixels copied into a texture",
          .unit = "pixel",
          .amount = 0,
          .set_up = set_up_copy,
          .frame = copy_to_a_texture,
          .share = 0.98},
    Scene{.name = "window",
          .what = "frames shown in a window of X11",
          .unit = "pixel",
          .amount = 0,
          .set_up = set_up_window,
          .frame = show,
          .window = true},
};

}  // namespace

std::span<const Scene> transfer_scenes() { return kScenes; }

}  // namespace bench
