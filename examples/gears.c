// SPDX-License-Identifier: MIT
//
// Three meshing spur gears, lit, in OpenGL ES 1.1. The program is written against the Khronos
// headers and the system's libEGL and libGLESv1_CM, so that it shows whichever implementation the
// loader picks. It draws into a pbuffer, turns the gears by a fixed angle each frame, prints
// the frame rate on one line and can write its last frame as a PNG file. With --window it draws
// into a window, of Wayland or else of X11, until that is closed; of N frames it keeps the last.
//
//   gears [--window] [--frames N] [--size WxH] [--output file.png]

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES/gl.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "gears_scene.h"
#include "window.h"

// -----------------------------------------------------------------------------------------------
// EGL, the clock, the PNG file.

static void fail(const char* what) {
  fprintf(stderr, "gears: %s failed (EGL error 0x%04x)\n", what, (unsigned)eglGetError());
  exit(1);
}

// A display without any window system where the implementation offers one, else the default
// display.
static EGLDisplay open_display(void) {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  EGLDisplay display = EGL_NO_DISPLAY;
  if (extensions && strstr(extensions, "EGL_MESA_platform_surfaceless")) {
    display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
  }
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, NULL, NULL)) {
    display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, NULL, NULL)) fail("eglInitialize");
  }
  return display;
}

// The window that the environment leads to.
static AppWindow* connect_window(int width, int height) {
  AppWindow* window = getenv("WAYLAND_DISPLAY") ? connect_wayland(width, height) : NULL;
  if (!window) window = connect_x11(width, height);
  if (!window) {
    fprintf(stderr, "gears: there is neither a Wayland compositor nor an X server\n");
    exit(1);
  }
  return window;
}

static EGLDisplay open_window_display(const AppWindow* window) {
  EGLDisplay display = eglGetPlatformDisplay(window->platform, window->native_display, NULL);
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, NULL, NULL)) fail("eglInitialize");
  return display;
}

// Into the window, or if there is none into a pbuffer.
static EGLSurface open_surface(EGLDisplay display, AppWindow* window, int width, int height) {
  const EGLint config_attributes[] = {EGL_SURFACE_TYPE,
                                      window ? EGL_WINDOW_BIT : EGL_PBUFFER_BIT,
                                      EGL_RENDERABLE_TYPE,
                                      EGL_OPENGL_ES_BIT,
                                      EGL_RED_SIZE,
                                      8,
                                      EGL_GREEN_SIZE,
                                      8,
                                      EGL_BLUE_SIZE,
                                      8,
                                      EGL_ALPHA_SIZE,
                                      8,
                                      EGL_DEPTH_SIZE,
                                      24,
                                      EGL_NONE};
  static const EGLint context_attributes[] = {EGL_CONTEXT_CLIENT_VERSION, 1, EGL_NONE};
  const EGLint surface_attributes[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
  EGLConfig configs[64];
  EGLint count = 0, chosen = 0, red = 0;
  if (!eglChooseConfig(display, config_attributes, configs, 64, &count) || count < 1) {
    fail("eglChooseConfig");
  }
  // The deepest colours come first, but not every window system shows ten bits.
  for (EGLint i = count - 1; i >= 0; --i) {
    eglGetConfigAttrib(display, configs[i], EGL_RED_SIZE, &red);
    if (red == 8) chosen = i;
  }
  const EGLConfig config = configs[chosen];
  if (!eglBindAPI(EGL_OPENGL_ES_API)) fail("eglBindAPI");
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, context_attributes);
  if (context == EGL_NO_CONTEXT) fail("eglCreateContext");
  EGLSurface surface = window ? window->show(window, display, config)
                              : eglCreatePbufferSurface(display, config, surface_attributes);
  if (surface == EGL_NO_SURFACE) fail("making the surface");
  if (!eglMakeCurrent(display, surface, surface, context)) fail("eglMakeCurrent");
  return surface;
}

// The window's size is the view's.
static void follow(AppWindow* window) {
  window->exposed = 0;
  set_gears_view(window->width, window->height);
}

// Keeps the frame in the window until the user closes that.
static void keep(AppWindow* window, EGLDisplay display, EGLSurface surface, int frame) {
  eglSwapBuffers(display, surface);
  while (!window->closed) {
    window->events(window, 1);
    if (!window->exposed) continue;
    follow(window);
    draw_gears(frame);
    eglSwapBuffers(display, surface);
  }
}

static double now(void) {
  struct timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static void write_png(const char* path, int width, int height) {
  unsigned char* pixels = malloc((size_t)width * (size_t)height * 4);
  png_image image;
  memset(&image, 0, sizeof(image));
  image.version = PNG_IMAGE_VERSION;
  image.width = (png_uint_32)width;
  image.height = (png_uint_32)height;
  image.format = PNG_FORMAT_RGBA;
  if (!pixels) {
    fprintf(stderr, "gears: out of memory\n");
    exit(1);
  }
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  // The rows come bottom first: a negative stride turns them over.
  if (!png_image_write_to_file(&image, path, 0, pixels, -width * 4, NULL)) {
    fprintf(stderr, "gears: %s: %s\n", path, image.message);
    exit(1);
  }
  free(pixels);
}

static void usage(void) {
  fprintf(stderr, "usage: gears [--window] [--frames N] [--size WxH] [--output file.png]\n");
  exit(2);
}

int main(int argc, char** argv) {
  int frames = 0, width = 800, height = 600, in_window = 0;
  const char* output = NULL;
  for (int i = 1; i < argc; ++i) {
    char end = 0;
    if (!strcmp(argv[i], "--window")) {
      in_window = 1;
      continue;
    }
    const char* option = argv[i++];
    if (i == argc) usage();
    if (!strcmp(option, "--frames")) {
      if (sscanf(argv[i], "%d%c", &frames, &end) != 1 || frames < 1) usage();
    } else if (!strcmp(option, "--size")) {
      if (sscanf(argv[i], "%dx%d%c", &width, &height, &end) != 2) usage();
      if (width < 1 || height < 1 || width > 16384 || height > 16384) usage();
    } else if (!strcmp(option, "--output")) {
      output = argv[i];
    } else {
      usage();
    }
  }
  const int endless = in_window && frames == 0;
  if (frames == 0) frames = 300;

  AppWindow* window = in_window ? connect_window(width, height) : NULL;
  EGLDisplay display = window ? open_window_display(window) : open_display();
  EGLSurface surface = open_surface(display, window, width, height);
  if (window) width = window->width, height = window->height;
  set_up_gears(width, height);

  // The first frame may carry work that is done once, so it is timed by itself.
  const double start = now();
  draw_gears(0);
  glFinish();
  const double first = now();
  int frame = 1;
  for (; (endless || frame < frames) && !(window && window->closed); ++frame) {
    if (!eglSwapBuffers(display, surface)) fail("eglSwapBuffers");
    if (window) window->events(window, 0);
    if (window && window->exposed) follow(window);
    draw_gears(frame);
    glFinish();
  }
  const double seconds = frame > 1 ? now() - first : first - start;
  const double fps = (frame > 1 ? frame - 1 : 1) / seconds;

  if (window) width = window->width, height = window->height;
  if (output) write_png(output, width, height);
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR) {
    fprintf(stderr, "gears: OpenGL ES error 0x%04x\n", error);
    return 1;
  }
  printf("gears: fps=%.1f frames=%d size=%dx%d first_frame_ms=%.2f renderer=\"%s\"\n", fps, frame,
         width, height, 1e3 * (first - start), (const char*)glGetString(GL_RENDERER));
  fflush(stdout);
  if (window) keep(window, display, surface, frame - 1);
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglTerminate(display);
  if (window) window->close(window);
  return 0;
}
