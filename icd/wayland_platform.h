// Wayland (EGL_KHR_platform_wayland, EGL_EXT_platform_wayland), through memory shared with the
// compositor (wl_shm).
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "icd/platform.h"
#include "icd/wayland_library.h"

namespace clearpipe::icd {

class WaylandPlatform : public Platform {
 public:
  // Over a connection that stays with its owner, or that goes with this.
  WaylandPlatform(const WaylandLibrary& library, wl_display* display, bool own);
  ~WaylandPlatform() override;

  // Whether the compositor is there and shares memory.
  bool works() const { return shm_ != nullptr; }

  std::vector<Config> configs() override;
  EGLint make_window(const Config& config, void* window, bool by_pointer,
                     std::shared_ptr<NativeSurface>& out) override;

  const WaylandLibrary& wl;
  wl_display* const display;
  wl_shm* shm() const { return shm_; }
  bool has_rgb565() const { return has_rgb565_; }

  // Events come in a queue of a window's own, which only its thread looks at. Handles those that
  // are there; waits for more until `done`, until told to give up, or until nothing has come
  // for too long. False: the connection is broken.
  bool dispatch(wl_event_queue* queue) const;
  bool wait(wl_event_queue* queue, const std::function<bool()>& done,
            const std::function<bool()>& give_up) const;

 private:
  bool bind_globals();
  static void add_format(void* self, wl_shm*, uint32_t format);

  const bool own_;
  wl_event_queue* queue_ = nullptr;
  wl_shm* shm_ = nullptr;
  bool has_rgb565_ = false;  // buffers of it
};

// Null display: a connection of its own, to $WAYLAND_DISPLAY. Null: there is none.
std::shared_ptr<Platform> open_wayland(wl_display* display);

}  // namespace clearpipe::icd
