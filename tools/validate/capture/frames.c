// When a frame ends, which are wanted, and how they come into files.
// SPDX-License-Identifier: MIT
#define _GNU_SOURCE
#include <EGL/egl.h>
#include <GLES/gl.h>
#include <GLES/glext.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "tools/validate/capture/capture.h"

enum { kMostFrames = 4096 };

static struct {
  bool active;
  char folder[4096];
  int log;
  int every;  // 0: the list decides
  int list[kMostFrames], count;
} settings;

static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static int frame = 0;  // that have ended
static bool drawn = false;

static void read_frames(const char* text) {
  if (sscanf(text, "every %d", &settings.every) == 1) return;
  char* end = NULL;
  for (const char* at = text; settings.count < kMostFrames; at = end + 1) {
    settings.list[settings.count++] = (int)strtol(at, &end, 10);
    if (*end != ',') return;
  }
}

__attribute__((constructor)) static void start(void) {
  const char* folder = getenv("CLEARPIPE_CAPTURE_FOLDER");
  const char* frames = getenv("CLEARPIPE_CAPTURE_FRAMES");
  if (!folder || !frames || strlen(folder) >= sizeof settings.folder - 32) return;
  strcpy(settings.folder, folder);
  read_frames(frames);
  settings.log = -1;
  settings.active = true;
}

// Of several processes of a program the first that draws is the one that is captured.
static bool open_log(void) {
  static bool tried = false;
  if (tried) return settings.log >= 0;
  tried = true;
  char path[sizeof settings.folder + 32];
  snprintf(path, sizeof path, "%s/log", settings.folder);
  settings.log = open(path, O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
  return settings.log >= 0;
}

void capture_log(const char* format, ...) {
  char line[512];
  va_list arguments;
  va_start(arguments, format);
  int length = vsnprintf(line, sizeof line - 1, format, arguments);
  va_end(arguments);
  if (length > (int)sizeof line - 2) length = (int)sizeof line - 2;
  line[length++] = '\n';
  if (open_log() && write(settings.log, line, (size_t)length) != length) settings.active = false;
}

static bool is_wanted(int number) {
  if (settings.every > 0) return number % settings.every == 0;
  for (int i = 0; i < settings.count; ++i) {
    if (settings.list[i] == number) return true;
  }
  return false;
}

static bool is_last(int number) {
  if (settings.every > 0) return false;
  for (int i = 0; i < settings.count; ++i) {
    if (settings.list[i] > number) return false;
  }
  return true;
}

// The real commands that reading takes.
static struct {
  EGLSurface (*get_surface)(EGLint);
  EGLDisplay (*get_display)(void);
  EGLContext (*get_context)(void);
  EGLBoolean (*query_surface)(EGLDisplay, EGLSurface, EGLint, EGLint*);
  void (*get_integer)(GLenum, GLint*);
  const GLubyte* (*get_string)(GLenum);
  void (*pixel_store)(GLenum, GLint);
  void (*read_pixels)(GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void*);
  void (*bind_framebuffer)(GLenum, GLuint);
} real;

static void find_real(void) {
  if (real.get_surface) return;
  *(void**)&real.get_surface = capture_real("eglGetCurrentSurface");
  *(void**)&real.get_display = capture_real("eglGetCurrentDisplay");
  *(void**)&real.get_context = capture_real("eglGetCurrentContext");
  *(void**)&real.query_surface = capture_real("eglQuerySurface");
  *(void**)&real.get_integer = capture_real("glGetIntegerv");
  *(void**)&real.get_string = capture_real("glGetString");
  *(void**)&real.pixel_store = capture_real("glPixelStorei");
  *(void**)&real.read_pixels = capture_real("glReadPixels");
  *(void**)&real.bind_framebuffer = capture_real("glBindFramebufferOES");
}

// Who draws, once.
static void introduce(void) {
  static bool done = false;
  if (done) return;
  done = true;
  GLint samples = 0;
  real.get_integer(GL_SAMPLES, &samples);
  capture_log("renderer %s", (const char*)real.get_string(GL_RENDERER));
  capture_log("version %s", (const char*)real.get_string(GL_VERSION));
  capture_log("samples %d", (int)samples);
}

static void write_frame(int width, int height, const uint8_t* pixels) {
  char path[sizeof settings.folder + 32], whole[sizeof settings.folder + 32];
  snprintf(path, sizeof path, "%s/part", settings.folder);
  snprintf(whole, sizeof whole, "%s/frame-%d", settings.folder, frame);
  FILE* file = fopen(path, "wb");
  if (!file) {
    capture_log("error cannot write %s", path);
    return;
  }
  fprintf(file, "%d %d\n", width, height);
  const size_t size = (size_t)width * (size_t)height * 4;
  const bool good = fwrite(pixels, 1, size, file) == size;
  // Under its name only when it is whole.
  if (fclose(file) != 0 || !good || rename(path, whole) != 0)
    capture_log("error cannot write %s", whole);
}

// The surface's pixels, whichever framebuffer object is bound; without a surface, those of the
// framebuffer object inside the viewport.
static void read_frame(EGLSurface surface) {
  GLint bound = 0, alignment = 4, box[4] = {0, 0, 0, 0};
  if (surface != EGL_NO_SURFACE) {
    real.query_surface(real.get_display(), surface, EGL_WIDTH, &box[2]);
    real.query_surface(real.get_display(), surface, EGL_HEIGHT, &box[3]);
    real.get_integer(GL_FRAMEBUFFER_BINDING_OES, &bound);
  } else {
    real.get_integer(GL_VIEWPORT, box);
  }
  uint8_t* pixels = box[2] > 0 && box[3] > 0 ? calloc((size_t)box[2] * (size_t)box[3], 4) : NULL;
  if (!pixels) {
    capture_log("error frame %d has no size", frame);
    return;
  }
  if (bound != 0) real.bind_framebuffer(GL_FRAMEBUFFER_OES, 0);
  real.get_integer(GL_PACK_ALIGNMENT, &alignment);
  real.pixel_store(GL_PACK_ALIGNMENT, 1);
  real.read_pixels(box[0], box[1], box[2], box[3], GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  real.pixel_store(GL_PACK_ALIGNMENT, alignment);
  if (bound != 0) real.bind_framebuffer(GL_FRAMEBUFFER_OES, (GLuint)bound);
  write_frame(box[2], box[3], pixels);
  free(pixels);
}

static void end_frame(EGLSurface surface) {
  introduce();
  ++frame;
  drawn = false;
  if (is_wanted(frame)) read_frame(surface);
  capture_log("frame %d", frame);
  capture_clock_advance();
  if (is_last(frame)) {
    capture_log("done");
    // The program may go on for ever; nobody needs more of it.
    _exit(0);
  }
}

// A window has buffers to swap. Only pbuffers have EGL_LARGEST_PBUFFER, for others the value stays
// as it is (3.5.6); pixmaps are drawn to singly buffered.
static bool is_window(EGLSurface surface) {
  if (surface == EGL_NO_SURFACE) return false;
  EGLint largest = -1, buffer = EGL_BACK_BUFFER;
  real.query_surface(real.get_display(), surface, EGL_LARGEST_PBUFFER, &largest);
  real.query_surface(real.get_display(), surface, EGL_RENDER_BUFFER, &buffer);
  return largest == -1 && buffer == EGL_BACK_BUFFER;
}

void capture_cleared(void) { drawn = true; }

void capture_drawn(void) {
  if (!settings.active) return;
  drawn = true;
  capture_check_textures(frame + 1);
}

void capture_swap(void) {
  if (!settings.active) return;
  pthread_mutex_lock(&mutex);
  find_real();
  const EGLSurface surface = real.get_surface(EGL_DRAW);
  // A pbuffer's swap does nothing: after a finish, it is not another frame.
  if (surface != EGL_NO_SURFACE && (drawn || is_window(surface))) end_frame(surface);
  pthread_mutex_unlock(&mutex);
}

void capture_finish(void) {
  if (!settings.active) return;
  pthread_mutex_lock(&mutex);
  find_real();
  if (drawn && real.get_context() != EGL_NO_CONTEXT) {
    const EGLSurface surface = real.get_surface(EGL_DRAW);
    if (!is_window(surface)) end_frame(surface);
  }
  pthread_mutex_unlock(&mutex);
}
