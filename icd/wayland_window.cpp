// See wayland_window.h.
// SPDX-License-Identifier: MIT
#include "icd/wayland_window.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <new>

namespace clearpipe::icd {

namespace {

// More parts than this are not worth telling apart.
constexpr size_t kMostParts = 64;

template <class ListenerTable>
void add_listener(const WaylandLibrary& wl, void* object, const ListenerTable& table, void* data) {
  using Listener = void (*)();
  wl.proxy_add_listener(static_cast<wl_proxy*>(object),
                        const_cast<Listener*>(reinterpret_cast<const Listener*>(&table)), data);
}

bool is_rgb565(const Config& config) { return config.format == pipeline::ColourFormat::kRgb565; }

}  // namespace

EGLint WaylandWindow::make(std::shared_ptr<Platform> platform, wl_egl_window* window,
                           const Config& config, std::shared_ptr<NativeSurface>& out) {
  if (window == nullptr || window->surface == nullptr) return EGL_BAD_NATIVE_WINDOW;
  if (window->driver_private != nullptr) return EGL_BAD_ALLOC;  // it has a surface already
  auto made = std::make_shared<WaylandWindow>(std::move(platform), window, config);
  if (!made->start()) return EGL_BAD_ALLOC;
  out = std::move(made);
  return EGL_SUCCESS;
}

WaylandWindow::WaylandWindow(std::shared_ptr<Platform> platform, wl_egl_window* window,
                             const Config& config)
    : NativeSurface(std::move(platform), reinterpret_cast<uintptr_t>(window)),
      window_(window),
      format_(is_rgb565(config)  ? WL_SHM_FORMAT_RGB565
              : config.alpha > 0 ? WL_SHM_FORMAT_ARGB8888
                                 : WL_SHM_FORMAT_XRGB8888),
      layout_(is_rgb565(config) ? kRgb565 : kBgra) {}

// Compositors want rows of whole words.
size_t WaylandWindow::stride_of(int width) const {
  return (static_cast<size_t>(width) * static_cast<size_t>(layout_.bytes) + 3) / 4 * 4;
}

bool WaylandWindow::start() {
  const WaylandLibrary& wl = display().wl;
  queue_ = wl.display_create_queue(display().display);
  surface_ = static_cast<wl_surface*>(wl.proxy_create_wrapper(window_->surface));
  window_->driver_private = this;
  window_->destroy_window_callback = forget_window;
  if (queue_ == nullptr || surface_ == nullptr) return false;
  wl.proxy_set_queue(reinterpret_cast<wl_proxy*>(surface_), queue_);
  return true;
}

void WaylandWindow::forget_window(void* self) {
  auto* window = static_cast<WaylandWindow*>(self);
  const auto lock = window->lock();
  window->window_ = nullptr;
}

void WaylandWindow::release() {
  const WaylandLibrary& wl = display().wl;
  if (window_ != nullptr) {
    window_->driver_private = nullptr;
    window_->destroy_window_callback = nullptr;
  }
  if (frame_ != nullptr) wl.proxy_destroy(reinterpret_cast<wl_proxy*>(frame_));
  for (WaylandBuffer& buffer : buffers_) free_memory(buffer);
  if (surface_ != nullptr) wl.proxy_wrapper_destroy(surface_);
  if (queue_ != nullptr) wl.event_queue_destroy(queue_);
  wl.display_flush(display().display);
}

std::optional<Size> WaylandWindow::get_size() {
  if (window_ == nullptr) return std::nullopt;
  return Size{std::max(window_->width, 1), std::max(window_->height, 1)};
}

void WaylandWindow::frame_done(void* self, wl_callback* callback, uint32_t) {
  auto* window = static_cast<WaylandWindow*>(self);
  window->display().wl.proxy_destroy(reinterpret_cast<wl_proxy*>(callback));
  window->frame_ = nullptr;
}

void WaylandWindow::buffer_released(void* buffer, wl_buffer*) {
  static_cast<WaylandBuffer*>(buffer)->busy = false;
}

bool WaylandWindow::make_buffer(WaylandBuffer& buffer, Size size) {
  free_memory(buffer);
  const WaylandLibrary& wl = display().wl;
  const int64_t stride = static_cast<int64_t>(stride_of(size.width)), bytes = stride * size.height;
  if (bytes > INT32_MAX) return false;
  const int fd = memfd_create("clearpipe", MFD_CLOEXEC);
  if (fd == -1) return false;
  void* const memory = ftruncate(fd, bytes) == 0 ? mmap(nullptr, static_cast<size_t>(bytes),
                                                        PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0)
                                                 : MAP_FAILED;
  if (memory == MAP_FAILED) {
    ::close(fd);
    return false;
  }
  buffer.memory = static_cast<std::byte*>(memory);
  buffer.bytes = static_cast<size_t>(bytes);
  buffer.size = size;
  buffer.stale = {{0, 0, size.width, size.height}};
  auto* pool = wl.create<wl_shm_pool>(display().shm(), WL_SHM_CREATE_POOL, wl.shm_pool_interface, 1,
                                      nullptr, fd, static_cast<int32_t>(bytes));
  ::close(fd);
  if (pool == nullptr) return false;
  // What is made of an object gets the events of its queue.
  wl.proxy_set_queue(reinterpret_cast<wl_proxy*>(pool), queue_);
  buffer.buffer =
      wl.create<wl_buffer>(pool, WL_SHM_POOL_CREATE_BUFFER, wl.buffer_interface, 1, nullptr, 0,
                           size.width, size.height, static_cast<int32_t>(stride), format_);
  wl.destroy(pool, WL_SHM_POOL_DESTROY);
  if (buffer.buffer == nullptr) return false;
  static constexpr wl_buffer_listener kListener = {buffer_released};
  add_listener(wl, buffer.buffer, kListener, &buffer);
  return true;
}

void WaylandWindow::free_memory(WaylandBuffer& buffer) {
  if (buffer.buffer != nullptr) display().wl.destroy(buffer.buffer, WL_BUFFER_DESTROY);
  if (buffer.memory != nullptr) munmap(buffer.memory, buffer.bytes);
  buffer = {};
}

// One that the compositor does not read, in the size; one is made, or waited for.
WaylandBuffer* WaylandWindow::free_buffer(Size size) {
  WaylandBuffer* found = nullptr;
  const auto look = [&] {
    found = nullptr;
    for (WaylandBuffer& buffer : buffers_) {
      if (buffer.busy) continue;
      if (found == nullptr || (buffer.size == size && found->size != size)) found = &buffer;
    }
    return found != nullptr;
  };
  if (!look()) display().wait(queue_, look, [this] { return is_closing(); });
  if (found == nullptr) return nullptr;
  return found->size == size || make_buffer(*found, size) ? found : nullptr;
}

void WaylandWindow::write(WaylandBuffer& to, const pipeline::ColourBuffer& from, const Rect& part) {
  row_.resize(static_cast<size_t>(part.width));
  for (int i = 0; i < part.height; ++i) {
    const int y = part.y + i, from_top = from.height - 1 - y;
    pipeline::read_pixels(from, part.x, y, part.width, row_.data());
    to_layout(layout_, row_.data(), row_.size(),
              to.memory + static_cast<size_t>(from_top) * stride_of(from.width) +
                  static_cast<size_t>(part.x) * static_cast<size_t>(layout_.bytes));
  }
}

void WaylandWindow::commit(const WaylandBuffer& buffer, std::span<const Rect> parts,
                           bool wants_frame) {
  const WaylandLibrary& wl = display().wl;
  const uint32_t version = wl.proxy_get_version(reinterpret_cast<wl_proxy*>(surface_));
  // Where the window moves as it is resized; told once.
  const bool moves = version < WL_SURFACE_OFFSET_SINCE_VERSION;
  wl.request(surface_, WL_SURFACE_ATTACH, buffer.buffer, moves ? window_->dx : 0,
             moves ? window_->dy : 0);
  if (!moves && (window_->dx != 0 || window_->dy != 0)) {
    wl.request(surface_, WL_SURFACE_OFFSET, window_->dx, window_->dy);
  }
  window_->dx = window_->dy = 0;
  window_->attached_width = buffer.size.width;
  window_->attached_height = buffer.size.height;
  for (const Rect& part : parts) {
    if (version >= WL_SURFACE_DAMAGE_BUFFER_SINCE_VERSION) {
      wl.request(surface_, WL_SURFACE_DAMAGE_BUFFER, part.x,
                 buffer.size.height - part.y - part.height, part.width, part.height);
    } else {
      // In coordinates that the application may have scaled: all of it.
      wl.request(surface_, WL_SURFACE_DAMAGE, 0, 0, INT32_MAX, INT32_MAX);
    }
  }
  if (wants_frame) {
    static constexpr wl_callback_listener kListener = {frame_done};
    frame_ = wl.create<wl_callback>(surface_, WL_SURFACE_FRAME, wl.callback_interface, 1, nullptr);
    if (frame_ != nullptr) add_listener(wl, frame_, kListener, this);
  }
  wl.request(surface_, WL_SURFACE_COMMIT);
}

EGLint WaylandWindow::put(const pipeline::ColourBuffer& from, std::span<const Rect> parts,
                          EGLint interval) try {
  if (window_ == nullptr) return EGL_BAD_NATIVE_WINDOW;
  const auto closing = [this] { return is_closing(); };
  const auto shown = [this] { return frame_ == nullptr; };
  const bool alive =
      interval > 0 ? display().wait(queue_, shown, closing) : display().dispatch(queue_);
  if (!alive) return EGL_BAD_NATIVE_WINDOW;
  if (frame_ != nullptr) {  // it did not come, or is not wanted any more
    display().wl.proxy_destroy(reinterpret_cast<wl_proxy*>(frame_));
    frame_ = nullptr;
  }
  WaylandBuffer* to = free_buffer({from.width, from.height});
  if (to == nullptr) {
    return display().wl.display_get_error(display().display) != 0 ? EGL_BAD_NATIVE_WINDOW
                                                                  : EGL_BAD_ALLOC;
  }
  for (WaylandBuffer& buffer : buffers_) {
    if (buffer.buffer == nullptr || buffer.size != to->size) continue;
    buffer.stale.insert(buffer.stale.end(), parts.begin(), parts.end());
    if (buffer.stale.size() > kMostParts) {
      buffer.stale = {{0, 0, buffer.size.width, buffer.size.height}};
    }
  }
  for (const Rect& part : to->stale) write(*to, from, part);
  to->stale.clear();
  to->busy = true;
  commit(*to, parts, interval > 0);
  display().wl.display_flush(display().display);
  return display().wl.display_get_error(display().display) == 0 ? EGL_SUCCESS
                                                                : EGL_BAD_NATIVE_WINDOW;
} catch (const std::bad_alloc&) {
  return EGL_BAD_ALLOC;
}

}  // namespace clearpipe::icd
