// SPDX-License-Identifier: MIT
//
// See context.h.
#include "bench/context.h"

#include <EGL/eglext.h>

#include <cstring>

#include "bench/extras.h"
#include "bench/shapes.h"

namespace bench {

namespace {

AppWindow* the_window = nullptr;

EGLDisplay open_display() {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (extensions && std::strstr(extensions, "EGL_MESA_platform_surfaceless")) {
    return eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  }
  return eglGetDisplay(EGL_DEFAULT_DISPLAY);
}

// Eight bits a colour, also where deeper ones come first.
EGLConfig choose_config(EGLDisplay display, bool window) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE,
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
                           EGL_STENCIL_SIZE,
                           8,
                           EGL_NONE};
  EGLConfig configs[64];
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted, configs, 64, &count)) fail("eglChooseConfig");
  for (EGLint i = 0; i < count; ++i) {
    EGLint red = 0, samples = 0;
    eglGetConfigAttrib(display, configs[i], EGL_RED_SIZE, &red);
    eglGetConfigAttrib(display, configs[i], EGL_SAMPLES, &samples);
    if (red == 8 && samples == 0) return configs[i];
  }
  fail("finding a config");
}

}  // namespace

void open_context(View& view, bool window) {
  if (window) {
    the_window = open_x11(view.width, view.height);
    if (!the_window) fail("reaching an X server");
    view.display = eglGetPlatformDisplay(the_window->platform, the_window->native_display, nullptr);
  } else {
    view.display = open_display();
  }
  if (view.display == EGL_NO_DISPLAY || !eglInitialize(view.display, nullptr, nullptr)) {
    fail("eglInitialize");
  }
  const EGLConfig config = choose_config(view.display, window);
  eglBindAPI(EGL_OPENGL_ES_API);
  const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 1, EGL_NONE};
  const EGLContext context = eglCreateContext(view.display, config, EGL_NO_CONTEXT, version);
  if (context == EGL_NO_CONTEXT) fail("eglCreateContext");
  const EGLint size[] = {EGL_WIDTH, view.width, EGL_HEIGHT, view.height, EGL_NONE};
  view.surface = window ? the_window->show(the_window, view.display, config)
                        : eglCreatePbufferSurface(view.display, config, size);
  if (view.surface == EGL_NO_SURFACE) fail("making the surface");
  if (!eglMakeCurrent(view.display, view.surface, view.surface, context)) fail("eglMakeCurrent");
  if (window) {
    view.width = the_window->width;
    view.height = the_window->height;
    // Frames are shown as they come, not as the screen asks for them.
    eglSwapInterval(view.display, 0);
  }
  glViewport(0, 0, view.width, view.height);
}

void close_context(const View& view) {
  eglMakeCurrent(view.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglTerminate(view.display);
  if (the_window) the_window->close(the_window);
}

}  // namespace bench
