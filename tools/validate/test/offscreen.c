// Programs for the tests of clearpipe-validate that draw without a window: right ones, and ones
// that are wrong on purpose. Usage: offscreen MODE, below. SPDX-License-Identifier: MIT
#define _GNU_SOURCE
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES/gl.h>
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

enum { kSize = 64, kFrames = 6 };

// Nothing of EGL or GL is linked: every function is asked for.
static void* egl;
static __typeof__(&eglGetProcAddress) get_proc_address;

#define EGL(name) ((__typeof__(&name))dlsym(egl, #name))
#define GL(name) ((__typeof__(&name))get_proc_address(#name))

static EGLDisplay display;
static EGLSurface surface;

static void start(void) {
  egl = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (!egl) exit(3);
  get_proc_address = EGL(eglGetProcAddress);
  display = EGL(eglGetPlatformDisplay)(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
  const EGLint wanted[] = {EGL_SURFACE_TYPE,  EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_ES_BIT, EGL_RED_SIZE,    8,
                           EGL_NONE};
  const EGLint size[] = {EGL_WIDTH, kSize, EGL_HEIGHT, kSize, EGL_NONE};
  EGLConfig config;
  EGLint count = 0;
  if (!EGL(eglInitialize)(display, NULL, NULL) ||
      !EGL(eglChooseConfig)(display, wanted, &config, 1, &count) || count != 1) {
    exit(3);
  }
  EGLContext context = EGL(eglCreateContext)(display, config, EGL_NO_CONTEXT, NULL);
  surface = EGL(eglCreatePbufferSurface)(display, config, size);
  if (!EGL(eglMakeCurrent)(display, surface, surface, context)) exit(3);
}

// Left of `share` red, else blue, under a texture if one is enabled.
static void draw(float share) {
  const float corners[] = {-1, -1, share * 2 - 1, -1, -1, 1, share * 2 - 1, 1};
  const float coordinates[] = {0, 0, 1, 0, 0, 1, 1, 1};
  GL(glClearColor)(0, 0, 1, 1);
  GL(glClear)(GL_COLOR_BUFFER_BIT);
  GL(glEnableClientState)(GL_VERTEX_ARRAY);
  GL(glEnableClientState)(GL_TEXTURE_COORD_ARRAY);
  GL(glVertexPointer)(2, GL_FLOAT, 0, corners);
  GL(glTexCoordPointer)(2, GL_FLOAT, 0, coordinates);
  GL(glColor4f)(1, 0, 0, 1);
  GL(glDrawArrays)(GL_TRIANGLE_STRIP, 0, 4);
}

static void undefined_texture(void) {
  GLuint name = 0;
  GL(glGenTextures)(1, &name);
  GL(glBindTexture)(GL_TEXTURE_2D, name);
  GL(glTexParameterf)(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  GL(glTexImage2D)(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
  GL(glEnable)(GL_TEXTURE_2D);
}

static double seconds(void) {
  struct timespec steady;
  struct timeval day;
  clock_gettime(CLOCK_MONOTONIC, &steady);
  gettimeofday(&day, NULL);
  // All of them must follow.
  const double fraction =
      (double)day.tv_usec * 1e-6 + (double)(day.tv_sec % 7) + (double)(time(NULL) % 3);
  return (double)steady.tv_sec + (double)steady.tv_nsec * 1e-9 + fraction;
}

int main(int argc, char** argv) {
  const char* mode = argc > 1 ? argv[1] : "";
  const char* renderer = NULL;
  uint8_t pixels[4];
  if (strcmp(mode, "no-egl") == 0) return 0;
  start();
  renderer = (const char*)GL(glGetString)(GL_RENDERER);
  if (strcmp(mode, "undefined") == 0) undefined_texture();
  const double begin = seconds();
  for (int i = 1; i <= kFrames || strcmp(mode, "endless") == 0; ++i) {
    float share = (float)i / (kFrames + 1);
    // Asks for its time by sleeping, which must not take it on a steady clock.
    if (strcmp(mode, "clock") == 0) {
      usleep(12345);
      // A microsecond more or less shows, so no two runs on a real clock look alike by chance.
      const double turns = (seconds() - begin) * 99991;
      share = (float)(turns - (double)(long long)turns);
    }
    // On clearpipe alone.
    if (strcmp(mode, "differs") == 0 && strstr(renderer, "clearpipe")) share = 1 - share;
    draw(share);
    if (strcmp(mode, "crash") == 0 && i == 4) abort();
    if (strcmp(mode, "finish") == 0) GL(glFinish)();
    if (strcmp(mode, "read") == 0) {
      GL(glReadPixels)(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    }
    if (strcmp(mode, "never") == 0 || strcmp(mode, "finish") == 0 || strcmp(mode, "read") == 0) {
      continue;
    }
    if (strcmp(mode, "endless") != 0) GL(glFinish)();
    // The finish has ended the frame already.
    EGL(eglSwapBuffers)(display, surface);
  }
  puts("end of the program");
  return 0;
}
