// Draws that use a texture without contents: a program whose pictures depend on what memory holds
// can agree with nobody.
// SPDX-License-Identifier: MIT
#include <GLES/gl.h>
#include <GLES/glext.h>
#include <pthread.h>
#include <stddef.h>
#include <string.h>

#include "tools/validate/capture/capture.h"

enum { kMost = 256 };

static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static uint32_t undefined[kMost];
static int count = 0;

static void (*get_integer)(GLenum, GLint*);
static const GLubyte* (*get_string)(GLenum);
static void (*active_texture)(GLenum);
static GLboolean (*is_enabled)(GLenum);

static void find_real(void) {
  if (get_integer) return;
  *(void**)&active_texture = capture_real("glActiveTexture");
  *(void**)&get_string = capture_real("glGetString");
  *(void**)&is_enabled = capture_real("glIsEnabled");
  *(void**)&get_integer = capture_real("glGetIntegerv");
}

static uint32_t bound(void) {
  GLint name = 0;
  find_real();
  get_integer(GL_TEXTURE_BINDING_2D, &name);
  return (uint32_t)name;
}

static int find(uint32_t name) {
  for (int i = 0; i < count; ++i) {
    if (undefined[i] == name) return i;
  }
  return -1;
}

void capture_texture_forget(uint32_t name) {
  pthread_mutex_lock(&mutex);
  const int at = find(name);
  if (at >= 0) undefined[at] = undefined[--count];
  pthread_mutex_unlock(&mutex);
}

void capture_texture_defined(void) {
  if (count > 0) capture_texture_forget(bound());
}

void capture_texture_undefined(void) {
  const uint32_t name = bound();
  pthread_mutex_lock(&mutex);
  if (find(name) < 0 && count < kMost) undefined[count++] = name;
  pthread_mutex_unlock(&mutex);
}

void capture_check_textures(int frame) {
  if (count == 0) return;
  find_real();
  // Later versions have shaders, which say not which units they use.
  const char* version = (const char*)get_string(GL_VERSION);
  if (!version || strncmp(version, "OpenGL ES-C", 11) != 0) return;
  GLint units = 1, active = GL_TEXTURE0;
  get_integer(GL_MAX_TEXTURE_UNITS, &units);
  get_integer(GL_ACTIVE_TEXTURE, &active);
  for (GLint unit = 0; unit < units; ++unit) {
    active_texture(GL_TEXTURE0 + (GLenum)unit);
    const uint32_t name = bound();
    if (is_enabled(GL_TEXTURE_2D) && find(name) >= 0) {
      capture_log("undefined %d %u", frame, (unsigned)name);
      capture_texture_forget(name);
    }
  }
  active_texture((GLenum)active);
}
