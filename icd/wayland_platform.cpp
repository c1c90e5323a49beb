// Wayland: connections, and waiting for events. See wayland_platform.h.
// SPDX-License-Identifier: MIT
#include "icd/wayland_platform.h"

#include <poll.h>

#include <cerrno>
#include <chrono>
#include <cstring>

#include "icd/wayland_window.h"

namespace clearpipe::icd {

namespace {

// A window that nobody sees gets no frames: once a second it goes on without.
constexpr auto kPatience = std::chrono::seconds(1);
constexpr int kPollMilliseconds = 50;

struct Globals {
  uint32_t shm_name = 0;
};

void add_global(void* data, wl_registry*, uint32_t name, const char* interface, uint32_t) {
  if (std::strcmp(interface, "wl_shm") == 0) static_cast<Globals*>(data)->shm_name = name;
}
void remove_global(void*, wl_registry*, uint32_t) {}
constexpr wl_registry_listener kRegistryListener = {add_global, remove_global};

}  // namespace

WaylandPlatform::WaylandPlatform(const WaylandLibrary& library, wl_display* d, bool own)
    : wl(library), display(d), own_(own), queue_(library.display_create_queue(d)) {
  if (queue_ != nullptr) bind_globals();
}

WaylandPlatform::~WaylandPlatform() {
  if (shm_ != nullptr) wl.proxy_destroy(reinterpret_cast<wl_proxy*>(shm_));
  if (queue_ != nullptr) wl.event_queue_destroy(queue_);
  if (own_) wl.display_disconnect(display);
}

bool WaylandPlatform::bind_globals() {
  void* const wrapper = wl.proxy_create_wrapper(display);
  if (wrapper == nullptr) return false;
  wl.proxy_set_queue(static_cast<wl_proxy*>(wrapper), queue_);
  auto* registry =
      wl.create<wl_registry>(wrapper, WL_DISPLAY_GET_REGISTRY, wl.registry_interface, 1, nullptr);
  wl.proxy_wrapper_destroy(wrapper);
  if (registry == nullptr) return false;
  auto* const proxy = reinterpret_cast<wl_proxy*>(registry);
  Globals globals;
  using Listener = void (*)();
  wl.proxy_add_listener(
      proxy, const_cast<Listener*>(reinterpret_cast<const Listener*>(&kRegistryListener)),
      &globals);
  wl.display_roundtrip_queue(display, queue_);
  if (globals.shm_name != 0) {
    shm_ = wl.create<wl_shm>(registry, WL_REGISTRY_BIND, wl.shm_interface, 1, globals.shm_name,
                             wl.shm_interface->name, 1u, nullptr);
    static constexpr wl_shm_listener kShmListener = {add_format};
    wl.proxy_add_listener(reinterpret_cast<wl_proxy*>(shm_),
                          const_cast<Listener*>(reinterpret_cast<const Listener*>(&kShmListener)),
                          this);
    wl.display_roundtrip_queue(display, queue_);
  }
  wl.proxy_destroy(proxy);
  return shm_ != nullptr;
}

// Every compositor has those of 8 bits.
void WaylandPlatform::add_format(void* self, wl_shm*, uint32_t format) {
  if (format == WL_SHM_FORMAT_RGB565) static_cast<WaylandPlatform*>(self)->has_rgb565_ = true;
}

std::vector<Config> WaylandPlatform::configs() {
  std::vector<Config> list = offscreen_configs();
  for (Config& config : list) {
    if (config.red != 8 && !(config.format == pipeline::ColourFormat::kRgb565 && has_rgb565_)) {
      continue;
    }
    config.native_surfaces = EGL_WINDOW_BIT;
    config.max_swap_interval = 1;  // a compositor tells of one frame at a time
  }
  return list;
}

EGLint WaylandPlatform::make_window(const Config& config, void* window, bool,
                                    std::shared_ptr<NativeSurface>& out) {
  return WaylandWindow::make(shared_from_this(), static_cast<wl_egl_window*>(window), config, out);
}

bool WaylandPlatform::dispatch(wl_event_queue* queue) const {
  return wait(
      queue, [] { return false; }, [] { return true; });
}

bool WaylandPlatform::wait(wl_event_queue* queue, const std::function<bool()>& done,
                           const std::function<bool()>& give_up) const {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  for (;;) {
    while (wl.display_prepare_read_queue(display, queue) != 0) {
      if (wl.display_dispatch_queue_pending(display, queue) < 0) return false;
    }
    const bool stop =
        done() || std::chrono::steady_clock::now() > end || wl.display_get_error(display) != 0;
    const bool last = stop || give_up();
    wl.display_flush(display);
    pollfd fd = {wl.display_get_fd(display), POLLIN, 0};
    const int ready = stop ? 0 : poll(&fd, 1, last ? 0 : kPollMilliseconds);
    if (ready > 0) {
      if (wl.display_read_events(display) < 0 && errno != EAGAIN) return false;
    } else {
      wl.display_cancel_read(display);
    }
    if (wl.display_dispatch_queue_pending(display, queue) < 0) return false;
    if (last) return wl.display_get_error(display) == 0;
  }
}

std::shared_ptr<Platform> open_wayland(wl_display* display) {
  const WaylandLibrary* library = wayland_library();
  if (library == nullptr) return nullptr;
  const bool own = display == nullptr;
  if (own) display = library->display_connect(nullptr);
  if (display == nullptr) return nullptr;
  auto platform = std::make_shared<WaylandPlatform>(*library, display, own);
  return platform->works() ? platform : nullptr;
}

}  // namespace clearpipe::icd
