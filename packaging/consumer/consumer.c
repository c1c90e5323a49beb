// SPDX-License-Identifier: MIT
//
// A program of somebody who uses an installed clearpipe: it knows the Khronos headers, and what it
// is built with decides which libraries it gets. It keeps to fixed point, so that Common-Lite will
// do. It draws a triangle over the lower left half of a pbuffer, looks at a pixel on either side,
// and prints who drew it.
//
//   consumer

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES/gl.h>
#include <stdio.h>

enum { kSize = 64, kOne = 0x10000 };

static int fail(const char* what) {
  fprintf(stderr, "consumer: %s (EGL error 0x%04x)\n", what, (unsigned)eglGetError());
  return 1;
}

static int pixel_is(int x, int y, int red, int green, int blue) {
  unsigned char rgba[4] = {0};
  glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  return rgba[0] == red && rgba[1] == green && rgba[2] == blue;
}

int main(void) {
  static const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                  EGL_OPENGL_ES_BIT, EGL_NONE};
  static const EGLint size[] = {EGL_WIDTH, kSize, EGL_HEIGHT, kSize, EGL_NONE};
  static const GLfixed corners[] = {-kOne, -kOne, kOne, -kOne, -kOne, kOne};
  EGLConfig config;
  EGLint count = 0;
  EGLDisplay display =
      eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
  if (!eglInitialize(display, NULL, NULL)) return fail("eglInitialize");
  if (!eglChooseConfig(display, wanted, &config, 1, &count) || count != 1) return fail("no config");
  EGLSurface surface = eglCreatePbufferSurface(display, config, size);
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, NULL);
  if (!eglMakeCurrent(display, surface, surface, context)) return fail("eglMakeCurrent");

  glClearColorx(0, 0, kOne, kOne);
  glClear(GL_COLOR_BUFFER_BIT);
  glColor4x(kOne, 0, 0, kOne);
  glVertexPointer(2, GL_FIXED, 0, corners);
  glEnableClientState(GL_VERTEX_ARRAY);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  if (!pixel_is(kSize / 4, kSize / 4, 255, 0, 0)) return fail("the triangle is not there");
  if (!pixel_is(3 * kSize / 4, 3 * kSize / 4, 0, 0, 255))
    return fail("the background is not there");
  if (glGetError() != GL_NO_ERROR) return fail("an error of OpenGL ES");

  printf("consumer: vendor=\"%s\" renderer=\"%s\"\n", eglQueryString(display, EGL_VENDOR),
         (const char*)glGetString(GL_RENDERER));
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglTerminate(display);
  return eglReleaseThread() ? 0 : 1;
}
