// The objects of EGL and the rules of their lives: displays own surfaces and contexts; a destroyed
// object lives on while it is current (3.5.5, 3.7.3). Handles are addresses, but none is followed
// before it has been found in its display.
// SPDX-License-Identifier: MIT
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <memory>
#include <mutex>
#include <vector>

#include "api/context.h"
#include "icd/config.h"
#include "pipeline/surface.h"

namespace clearpipe::icd {

struct Surface {
  const Config* config = nullptr;
  pipeline::Target target;
  EGLint width = 0, height = 0;
  bool largest_pbuffer = false;
  EGLint swap_behavior = EGL_BUFFER_PRESERVED;
  EGLint multisample_resolve = EGL_MULTISAMPLE_RESOLVE_DEFAULT;
  EGLint mipmap_level = 0;
  bool current = false;    // as draw or read surface of some thread's context
  bool destroyed = false;  // goes when it is no longer current
};

struct Context {
  const Config* config = nullptr;  // null: created without a config
  api::Context* context = nullptr;
  Surface* draw = nullptr;
  Surface* read = nullptr;
  bool current = false;
  bool destroyed = false;
  ~Context() {
    if (context != nullptr) api::destroy_context(context);
  }
};

struct Display {
  EGLenum platform = EGL_PLATFORM_SURFACELESS_MESA;
  bool initialized = false;
  std::vector<std::unique_ptr<Surface>> surfaces;
  std::vector<std::unique_ptr<Context>> contexts;

  Surface* surface(EGLSurface handle);  // null: no living surface of this display
  Context* context(EGLContext handle);

  // Frees what is destroyed and not current; after eglTerminate everything counts as destroyed.
  void sweep();
};

// All EGL state of the process is guarded by this.
std::mutex& egl_mutex();

// The display of a handle, or null.
Display* find_display(EGLDisplay handle);

// The display of a platform, created at the first call; null when the platform is not ours.
Display* get_display(EGLenum platform, void* native_display);

// What a thread has bound (2.3, 3.7.1). A thread that ends releases its context.
struct Thread {
  EGLint error = EGL_SUCCESS;
  EGLenum api = EGL_OPENGL_ES_API;
  Display* display = nullptr;
  Context* context = nullptr;
  ~Thread();
};
Thread& this_thread();

// Releases the thread's context and surfaces.
void release_current(Thread& thread);

}  // namespace clearpipe::icd
