// X11 (EGL_KHR_platform_x11, EGL_EXT_platform_x11, EGL_EXT_platform_xcb), through libxcb.
// SPDX-License-Identifier: MIT
#pragma once

#include "icd/pixel_layout.h"
#include "icd/platform.h"
#include "icd/x11_library.h"

namespace clearpipe::icd {

// What a window or pixmap can be drawn to with.
struct X11Format {
  uint8_t depth = 0;
  PixelLayout layout;
};

class X11Platform : public Platform {
 public:
  // Over a connection that stays with its owner, or that goes with this.
  X11Platform(const X11Library& library, xcb_connection_t* connection, bool own, int screen);
  ~X11Platform() override;

  // Whether the server is there and keeps pixels in a byte order that is known here.
  bool works() const;

  std::vector<Config> configs() override;
  EGLint make_window(const Config& config, void* window, bool by_pointer,
                     std::shared_ptr<NativeSurface>& out) override;
  bool has_pixmap(uintptr_t pixmap) override;
  EGLint make_pixmap(const Config& config, void* pixmap, bool by_pointer,
                     std::shared_ptr<NativeSurface>& out) override;

  const X11Library& x;
  xcb_connection_t* const connection;
  bool has_shm() const { return has_shm_; }
  bool has_present() const { return has_present_; }

  // No such drawable, or none with pixels: none.
  std::optional<Size> size_of(xcb_drawable_t drawable, uint8_t* depth = nullptr) const;

 private:
  const xcb_screen_t* screen() const;
  // The layout of a depth and masks; none if it cannot be drawn to.
  std::optional<PixelLayout> layout_of(uint8_t depth, const xcb_visualtype_t* visual) const;
  const xcb_visualtype_t* find_visual(xcb_visualid_t id) const;
  const xcb_visualtype_t* true_colour_visual(uint8_t depth) const;

  const bool own_;
  const int screen_number_;
  bool has_shm_ = false, has_present_ = false;
};

// A platform over an Xlib Display, an xcb_connection_t, or, with neither, a new connection to
// $DISPLAY. `screen` < 0: the default one. Null: there is none.
std::shared_ptr<Platform> open_x11(void* xlib_display, xcb_connection_t* connection, int screen);

}  // namespace clearpipe::icd
