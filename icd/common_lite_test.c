/* A program of the Common-Lite profile, linked with libGLESv1_CL.so.1 and libEGL.so.1: it clears to
 * one colour, draws half of the surface in another with fixed-point calls alone, and looks at both.
 * SPDX-License-Identifier: MIT */
#include <EGL/egl.h>
#include <GLES/gl.h>
#include <stdio.h>
#include <string.h>

static int is_colour(GLint x, GLubyte red, GLubyte green) {
  const GLubyte wanted[4] = {red, green, 0, 255};
  GLubyte pixel[4] = {0, 0, 0, 0};
  glReadPixels(x, 4, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  return memcmp(pixel, wanted, 4) == 0;
}

int main(void) {
  static const EGLint kConfig[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES_BIT, EGL_SURFACE_TYPE,
                                   EGL_PBUFFER_BIT, EGL_NONE};
  static const EGLint kSize[] = {EGL_WIDTH, 8, EGL_HEIGHT, 8, EGL_NONE};
  static const GLfixed kHalf[] = {-65536, -65536, 0, -65536, -65536, 65536, 0, 65536};
  EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  EGLConfig config;
  EGLint count = 0;
  if (!eglInitialize(display, NULL, NULL) ||
      !eglChooseConfig(display, kConfig, &config, 1, &count) || count != 1) {
    return 1;
  }
  EGLSurface surface = eglCreatePbufferSurface(display, config, kSize);
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, NULL);
  if (!eglMakeCurrent(display, surface, surface, context)) return 2;
  glClearColorx(65536, 0, 0, 65536);
  glClear(GL_COLOR_BUFFER_BIT);
  glColor4x(0, 65536, 0, 65536);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FIXED, 0, kHalf);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  if (!is_colour(2, 0, 255) || !is_colour(6, 255, 0) || glGetError() != GL_NO_ERROR) {
    fputs("the picture is wrong\n", stderr);
    return 3;
  }
  eglTerminate(display);
  return 0;
}
