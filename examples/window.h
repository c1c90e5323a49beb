// SPDX-License-Identifier: MIT
//
// A window for gears, as X11 and Wayland have them: what EGL needs to know of it (a platform with
// its display, and a surface), and what happens to it.
#ifndef EXAMPLES_WINDOW_H
#define EXAMPLES_WINDOW_H

#include <EGL/egl.h>

typedef struct AppWindow AppWindow;

// What a window system offers. Each stands in a file of its own, after the AppWindow that all
// share.
struct AppWindow {
  int width, height;
  int closed;   // the user has closed it
  int exposed;  // what it shows is lost, or has another size: it must be drawn again
  EGLenum platform;
  void* native_display;
  // Makes the window, in the form that the config asks for, and shows it. EGL_NO_SURFACE: it could
  // not.
  EGLSurface (*show)(AppWindow*, EGLDisplay, EGLConfig);
  // Takes note of what has happened; waits until something does if `wait` is not 0.
  void (*events)(AppWindow*, int wait);
  // After eglTerminate.
  void (*close)(AppWindow*);
};

// Null: there is no such server.
AppWindow* connect_x11(int width, int height);
AppWindow* connect_wayland(int width, int height);

#endif
