// SPDX-License-Identifier: MIT
//
// A window of Wayland: a surface in the role of a toplevel (xdg-shell). The compositor may propose
// another size, wish it closed, and asks now and then whether the program is alive.

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <stdlib.h>
#include <string.h>
#include <wayland-client.h>
#include <wayland-egl.h>

#include "window.h"
#include "xdg-shell-client-protocol.h"

typedef struct {
  AppWindow base;
  struct wl_display* display;
  struct wl_registry* registry;
  struct wl_compositor* compositor;
  struct xdg_wm_base* shell;
  struct wl_surface* surface;
  struct xdg_surface* role;
  struct xdg_toplevel* toplevel;
  struct wl_egl_window* window;
  int wanted_width, wanted_height;  // 0: the program's choice
  int configured;
} WaylandAppWindow;

static void ping(void* data, struct xdg_wm_base* shell, uint32_t serial) {
  (void)data;
  xdg_wm_base_pong(shell, serial);
}
static const struct xdg_wm_base_listener shell_listener = {ping};

static void global(void* data, struct wl_registry* registry, uint32_t name, const char* interface,
                   uint32_t version) {
  WaylandAppWindow* self = data;
  (void)version;
  if (!strcmp(interface, wl_compositor_interface.name)) {
    self->compositor = wl_registry_bind(registry, name, &wl_compositor_interface, 1);
  } else if (!strcmp(interface, xdg_wm_base_interface.name)) {
    self->shell = wl_registry_bind(registry, name, &xdg_wm_base_interface, 1);
    xdg_wm_base_add_listener(self->shell, &shell_listener, self);
  }
}
static void global_remove(void* data, struct wl_registry* registry, uint32_t name) {
  (void)data, (void)registry, (void)name;
}
static const struct wl_registry_listener registry_listener = {global, global_remove};

static void propose(void* data, struct xdg_toplevel* toplevel, int32_t width, int32_t height,
                    struct wl_array* states) {
  WaylandAppWindow* self = data;
  (void)toplevel, (void)states;
  self->wanted_width = width;
  self->wanted_height = height;
}
static void want_closed(void* data, struct xdg_toplevel* toplevel) {
  (void)toplevel;
  ((WaylandAppWindow*)data)->base.closed = 1;
}
static const struct xdg_toplevel_listener toplevel_listener = {.configure = propose,
                                                               .close = want_closed};

// The end of a proposal: it is taken.
static void configure(void* data, struct xdg_surface* role, uint32_t serial) {
  WaylandAppWindow* self = data;
  xdg_surface_ack_configure(role, serial);
  self->configured = 1;
  if (self->wanted_width < 1 || self->wanted_height < 1) return;
  if (self->wanted_width == self->base.width && self->wanted_height == self->base.height) return;
  self->base.width = self->wanted_width;
  self->base.height = self->wanted_height;
  self->base.exposed = 1;
  if (self->window) {
    wl_egl_window_resize(self->window, self->base.width, self->base.height, 0, 0);
  }
}
static const struct xdg_surface_listener role_listener = {configure};

static void events(AppWindow* base, int wait) {
  WaylandAppWindow* self = (WaylandAppWindow*)base;
  // eglSwapBuffers reads what the compositor sends, so there is no need to wait for it in between.
  const int result =
      wait ? wl_display_dispatch(self->display) : wl_display_dispatch_pending(self->display);
  if (result < 0) base->closed = 1;
  wl_display_flush(self->display);
}

static EGLSurface show(AppWindow* base, EGLDisplay egl, EGLConfig config) {
  WaylandAppWindow* self = (WaylandAppWindow*)base;
  self->surface = wl_compositor_create_surface(self->compositor);
  self->role = xdg_wm_base_get_xdg_surface(self->shell, self->surface);
  xdg_surface_add_listener(self->role, &role_listener, self);
  self->toplevel = xdg_surface_get_toplevel(self->role);
  xdg_toplevel_add_listener(self->toplevel, &toplevel_listener, self);
  xdg_toplevel_set_title(self->toplevel, "gears");
  wl_surface_commit(self->surface);
  // A surface may have a picture only when its role has been configured.
  while (!self->configured && !base->closed) events(base, 1);
  base->exposed = 0;
  self->window = wl_egl_window_create(self->surface, base->width, base->height);
  return eglCreatePlatformWindowSurface(egl, config, self->window, NULL);
}

static void close_window(AppWindow* base) {
  WaylandAppWindow* self = (WaylandAppWindow*)base;
  if (self->window) wl_egl_window_destroy(self->window);
  if (self->toplevel) xdg_toplevel_destroy(self->toplevel);
  if (self->role) xdg_surface_destroy(self->role);
  if (self->surface) wl_surface_destroy(self->surface);
  if (self->shell) xdg_wm_base_destroy(self->shell);
  if (self->compositor) wl_compositor_destroy(self->compositor);
  wl_registry_destroy(self->registry);
  wl_display_disconnect(self->display);
  free(self);
}

AppWindow* connect_wayland(int width, int height) {
  struct wl_display* display = wl_display_connect(NULL);
  WaylandAppWindow* self = display ? calloc(1, sizeof(WaylandAppWindow)) : NULL;
  if (!self) return NULL;
  self->base = (AppWindow){.width = width,
                           .height = height,
                           .platform = EGL_PLATFORM_WAYLAND_EXT,
                           .native_display = display,
                           .show = show,
                           .events = events,
                           .close = close_window};
  self->display = display;
  self->registry = wl_display_get_registry(display);
  wl_registry_add_listener(self->registry, &registry_listener, self);
  wl_display_roundtrip(display);
  if (self->compositor && self->shell) return &self->base;
  close_window(&self->base);
  return NULL;
}
