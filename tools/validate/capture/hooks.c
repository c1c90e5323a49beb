// What the program finds in place of EGL's and GL's functions, however it looks for them: by being
// linked, by eglGetProcAddress, or by dlsym.
// SPDX-License-Identifier: MIT
#define _GNU_SOURCE
#include <EGL/egl.h>
#include <GLES/gl.h>
#include <GLES/glext.h>
#include <dlfcn.h>
#include <stddef.h>
#include <string.h>

#include "tools/validate/capture/capture.h"

#define EXPORT __attribute__((visibility("default")))

typedef void (*Function)(void);

_Thread_local int capture_inside = 0;

void* capture_dlsym(void* handle, const char* name) {
  static void* (*real)(void*, const char*);
  if (!real) {
    // Its versions on the processors that Debian has; dlvsym has no hook.
    static const char* const kVersions[] = {"GLIBC_2.34", "GLIBC_2.2.5", "GLIBC_2.17",
                                            "GLIBC_2.0",  "GLIBC_2.4",   "GLIBC_2.27"};
    for (size_t i = 0; !real && i < sizeof kVersions / sizeof *kVersions; ++i) {
      *(void**)&real = dlvsym(RTLD_NEXT, "dlsym", kVersions[i]);
    }
  }
  return real(handle, name);
}

static Function real_get_proc_address(const char* name) {
  static Function (*real)(const char*);
  if (!real) *(void**)&real = capture_dlsym(RTLD_NEXT, "eglGetProcAddress");
  if (!real) {
    // The program has opened the library for itself.
    void* library = dlopen("libEGL.so.1", RTLD_LAZY | RTLD_NOLOAD);
    if (!library) return NULL;
    *(void**)&real = capture_dlsym(library, "eglGetProcAddress");
  }
  return real ? real(name) : NULL;
}

void* capture_real(const char* name) {
  const Function function = real_get_proc_address(name);
  void* address;
  memcpy(&address, &function, sizeof address);
  return address;
}

// Level 0 of a texture is given contents, or, for null, only a size.
static void given(GLenum target, GLint level, const void* contents, GLsizei width, GLsizei height) {
  if (target != GL_TEXTURE_2D || level != 0) return;
  if (contents) {
    capture_texture_defined();
  } else if (width > 0 && height > 0) {
    capture_texture_undefined();
  }
}

static void deleted(GLsizei count, const GLuint* names) {
  for (GLsizei i = 0; names && i < count; ++i) capture_texture_forget(names[i]);
}

#define BEFORE(type, name, parameters, before)     \
  static type(*real) parameters;                   \
  if (!real) *(void**)&real = capture_real(#name); \
  ++capture_inside;                                \
  if (capture_inside == 1) before;
// An implementation waits for its screen inside EGL, by the real clock.
#define HOOK_EGL(name, parameters, arguments, before) \
  EXPORT EGLBoolean name parameters {                 \
    BEFORE(EGLBoolean, name, parameters, before)      \
    const EGLBoolean result = real arguments;         \
    --capture_inside;                                 \
    return result;                                    \
  }
#define HOOK_GL(name, parameters, arguments, before) \
  EXPORT void name parameters {                      \
    BEFORE(void, name, parameters, before)           \
    real arguments;                                  \
    --capture_inside;                                \
  }
#include "tools/validate/capture/hooks.def"
#undef HOOK_EGL
#undef HOOK_GL

typedef struct {
  const char* name;
  Function replacement;
} Hook;

static const Hook kHooks[] = {
#define HOOK_EGL(name, ...) {#name, (Function)name},
#define HOOK_GL(name, ...) {#name, (Function)name},
#include "tools/validate/capture/hooks.def"
#undef HOOK_EGL
#undef HOOK_GL
};

// The replacement of that name if there is one, for callers that got `real`.
static Function replacement(const char* name, Function real) {
  if (real == NULL) return NULL;
  if (strcmp(name, "eglGetProcAddress") == 0) return (Function)eglGetProcAddress;
  for (size_t i = 0; i < sizeof kHooks / sizeof *kHooks; ++i) {
    if (strcmp(name, kHooks[i].name) == 0) return kHooks[i].replacement;
  }
  return real;
}

EXPORT Function eglGetProcAddress(const char* name) {
  return replacement(name, real_get_proc_address(name));
}

EXPORT void* dlsym(void* handle, const char* name) {
  // Any other name is a call in the tail: RTLD_NEXT depends on who calls.
  if (strncmp(name, "egl", 3) != 0 && strncmp(name, "gl", 2) != 0) {
    return capture_dlsym(handle, name);
  }
  void* real = capture_dlsym(handle, name);
  Function function;
  memcpy(&function, &real, sizeof function);
  function = replacement(name, function);
  memcpy(&real, &function, sizeof real);
  return real;
}
