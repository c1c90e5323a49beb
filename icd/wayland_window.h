// A window of Wayland: pixels are copied into buffers that the compositor sees too, of which there
// are as many as it holds on to at a time.
// SPDX-License-Identifier: MIT
#pragma once

#include <wayland-egl-backend.h>

#include <array>

#include "icd/pixel_layout.h"
#include "icd/wayland_platform.h"

namespace clearpipe::icd {

// Memory shared with the compositor. `stale` are the parts in which it lacks what was posted in
// other buffers since.
struct WaylandBuffer {
  wl_buffer* buffer = nullptr;
  std::byte* memory = nullptr;
  size_t bytes = 0;
  Size size;
  bool busy = false;  // the compositor reads it
  std::vector<Rect> stale;
};

class WaylandWindow : public NativeSurface {
 public:
  static EGLint make(std::shared_ptr<Platform> platform, wl_egl_window* window,
                     const Config& config, std::shared_ptr<NativeSurface>& out);
  WaylandWindow(std::shared_ptr<Platform> platform, wl_egl_window* window, const Config& config);
  ~WaylandWindow() override { close(); }

 protected:
  std::optional<Size> get_size() override;
  EGLint put(const pipeline::ColourBuffer& buffer, std::span<const Rect> parts,
             EGLint interval) override;
  void release() override;

 private:
  const WaylandPlatform& display() const { return static_cast<const WaylandPlatform&>(platform()); }
  bool start();
  // The application destroys its window, which it may do before the surface.
  static void forget_window(void* self);
  static void frame_done(void* self, wl_callback* callback, uint32_t time);
  static void buffer_released(void* buffer, wl_buffer*);

  size_t stride_of(int width) const;
  WaylandBuffer* free_buffer(Size size);
  bool make_buffer(WaylandBuffer& buffer, Size size);
  void free_memory(WaylandBuffer& buffer);
  void write(WaylandBuffer& to, const pipeline::ColourBuffer& from, const Rect& part);
  void commit(const WaylandBuffer& buffer, std::span<const Rect> parts, bool wants_frame);

  wl_egl_window* window_;  // null: destroyed
  const uint32_t format_;  // of wl_shm
  const PixelLayout layout_;
  wl_event_queue* queue_ = nullptr;
  wl_surface* surface_ = nullptr;  // the application's, with our queue
  wl_callback* frame_ = nullptr;   // of the frame that is waited for
  std::array<WaylandBuffer, 4> buffers_;
  std::vector<uint32_t> row_;
};

}  // namespace clearpipe::icd
