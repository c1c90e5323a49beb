// SPDX-License-Identifier: MIT
//
// A window of X11, through Xlib: its visual is that of the EGL config, and the window manager may
// resize it, close it, or cover it and make it be drawn again.

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <stdlib.h>

#include "window.h"

typedef struct {
  AppWindow base;
  Display* display;
  Window window;
  Colormap colours;
  Atom delete_window;
} X11AppWindow;

static void take(X11AppWindow* self, const XEvent* event) {
  switch (event->type) {
    case Expose:
      self->base.exposed = 1;
      break;
    case ConfigureNotify:
      if (event->xconfigure.width != self->base.width ||
          event->xconfigure.height != self->base.height) {
        self->base.width = event->xconfigure.width;
        self->base.height = event->xconfigure.height;
        self->base.exposed = 1;
      }
      break;
    case ClientMessage:
      if ((Atom)event->xclient.data.l[0] == self->delete_window) self->base.closed = 1;
      break;
    default:
      break;
  }
}

static void events(AppWindow* base, int wait) {
  X11AppWindow* self = (X11AppWindow*)base;
  XEvent event;
  while (wait || XPending(self->display) > 0) {
    XNextEvent(self->display, &event);
    take(self, &event);
    wait = 0;
  }
}

static EGLSurface show(AppWindow* base, EGLDisplay egl, EGLConfig config) {
  X11AppWindow* self = (X11AppWindow*)base;
  EGLint visual_id = 0;
  int count = 0;
  eglGetConfigAttrib(egl, config, EGL_NATIVE_VISUAL_ID, &visual_id);
  XVisualInfo wanted = {.visualid = (VisualID)visual_id};
  XVisualInfo* visual = XGetVisualInfo(self->display, VisualIDMask, &wanted, &count);
  if (!visual) return EGL_NO_SURFACE;

  const Window root = RootWindow(self->display, visual->screen);
  self->colours = XCreateColormap(self->display, root, visual->visual, AllocNone);
  XSetWindowAttributes attributes = {.colormap = self->colours,
                                     .event_mask = ExposureMask | StructureNotifyMask};
  self->window = XCreateWindow(
      self->display, root, 0, 0, (unsigned)base->width, (unsigned)base->height, 0, visual->depth,
      InputOutput, visual->visual, CWColormap | CWBorderPixel | CWEventMask, &attributes);
  XFree(visual);
  XStoreName(self->display, self->window, "gears");
  self->delete_window = XInternAtom(self->display, "WM_DELETE_WINDOW", False);
  XSetWMProtocols(self->display, self->window, &self->delete_window, 1);
  XMapWindow(self->display, self->window);
  // What is drawn before the window is seen would be lost.
  while (!base->exposed) events(base, 1);
  base->exposed = 0;
  return eglCreatePlatformWindowSurface(egl, config, &self->window, NULL);
}

static void close_window(AppWindow* base) {
  X11AppWindow* self = (X11AppWindow*)base;
  if (self->window) XDestroyWindow(self->display, self->window);
  if (self->colours) XFreeColormap(self->display, self->colours);
  XCloseDisplay(self->display);
  free(self);
}

AppWindow* connect_x11(int width, int height) {
  Display* display = XOpenDisplay(NULL);
  X11AppWindow* self = display ? calloc(1, sizeof(X11AppWindow)) : NULL;
  if (!self) return NULL;
  self->base = (AppWindow){.width = width,
                           .height = height,
                           .platform = EGL_PLATFORM_X11_EXT,
                           .native_display = display,
                           .show = show,
                           .events = events,
                           .close = close_window};
  self->display = display;
  return &self->base;
}
