// See x11_drawable.h.
//
// Requests that may fail are all checked ones, whose errors come to us: those of other requests go
// to the application, which Xlib ends for it.
// SPDX-License-Identifier: MIT
#include "icd/x11_drawable.h"

#include <sys/ipc.h>
#include <sys/shm.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>

namespace clearpipe::icd {

namespace {

// Rows of images in ZPixmap format are padded to 32 bits, as every server has it today.
size_t stride_of(int width, const PixelLayout& layout) {
  return (static_cast<size_t>(width) * static_cast<size_t>(layout.bytes) + 3) / 4 * 4;
}

}  // namespace

bool X11Drawable::make(std::shared_ptr<Platform> platform, xcb_drawable_t drawable,
                       X11Format format, bool is_window, std::shared_ptr<NativeSurface>& out) {
  auto made = std::make_shared<X11Drawable>(std::move(platform), drawable, format, is_window);
  if (!made->make_gc()) return false;
  out = std::move(made);
  return true;
}

X11Drawable::X11Drawable(std::shared_ptr<Platform> platform, xcb_drawable_t drawable,
                         X11Format format, bool is_window)
    : NativeSurface(std::move(platform), drawable),
      drawable_(drawable),
      format_(format),
      is_window_(is_window),
      try_shm_(display().has_shm()) {}

bool X11Drawable::make_gc() {
  const X11Platform& d = display();
  gc_ = d.x.generate_id(d.connection);
  // Copying to a window must not send the application events about it.
  const uint32_t no_exposures = 0;
  xcb_generic_error_t* error = d.x.request_check(
      d.connection, d.x.create_gc_checked(d.connection, gc_, drawable_, XCB_GC_GRAPHICS_EXPOSURES,
                                          &no_exposures));
  if (error == nullptr) return d.x.connection_has_error(d.connection) == 0;
  std::free(error);
  gc_ = 0;
  return false;
}

void X11Drawable::release() {
  const X11Platform& d = display();
  clock_.stop(d, drawable_);
  unshare();
  if (gc_ != 0) d.x.free_gc(d.connection, gc_);
  d.x.flush(d.connection);
}

std::optional<Size> X11Drawable::get_size() { return display().size_of(drawable_); }

std::byte* X11Drawable::share(size_t bytes) {
  if (!try_shm_ || shared_bytes_ >= bytes) return shared_;
  unshare();
  const X11Platform& d = display();
  const int id = shmget(IPC_PRIVATE, bytes, IPC_CREAT | 0600);
  void* const memory = id != -1 ? shmat(id, nullptr, 0) : reinterpret_cast<void*>(-1);
  if (memory == reinterpret_cast<void*>(-1)) {
    if (id != -1) shmctl(id, IPC_RMID, nullptr);
    try_shm_ = false;
    return nullptr;
  }
  segment_ = d.x.generate_id(d.connection);
  xcb_generic_error_t* error = d.x.request_check(
      d.connection,
      d.x.shm.attach_checked(d.connection, segment_, static_cast<uint32_t>(id), 1 /* read only */));
  // From now on it lives for as long as someone has it attached.
  shmctl(id, IPC_RMID, nullptr);
  if (error != nullptr || d.x.connection_has_error(d.connection) != 0) {
    std::free(error);  // a server on another machine, for one
    shmdt(memory);
    segment_ = 0;
    try_shm_ = false;
    return nullptr;
  }
  shared_ = static_cast<std::byte*>(memory);
  shared_bytes_ = bytes;
  return shared_;
}

void X11Drawable::unshare() {
  if (shared_ == nullptr) return;
  display().x.shm.detach(display().connection, segment_);
  shmdt(shared_);
  shared_ = nullptr;
  shared_bytes_ = 0;
}

void X11Drawable::write_row(const pipeline::ColourBuffer& buffer, int x, int y, int width,
                            std::byte* to) {
  row_.resize(static_cast<size_t>(width));
  pipeline::read_pixels(buffer, x, y, width, row_.data());
  to_layout(format_.layout, row_.data(), row_.size(), to);
}

void X11Drawable::put_part(const pipeline::ColourBuffer& buffer, const Rect& part, size_t stride) {
  const X11Platform& d = display();
  const int top = buffer.height - part.y - part.height;
  const auto x = static_cast<int16_t>(part.x);
  const auto width = static_cast<uint16_t>(part.width);
  if (shared_ != nullptr) {
    for (int i = 0; i < part.height; ++i) {
      write_row(buffer, part.x, part.y + part.height - 1 - i, part.width,
                shared_ + static_cast<size_t>(top + i) * stride +
                    static_cast<size_t>(part.x) * static_cast<size_t>(format_.layout.bytes));
    }
    const auto cookie = d.x.shm.put_image_checked(
        d.connection, drawable_, gc_, static_cast<uint16_t>(buffer.width),
        static_cast<uint16_t>(buffer.height), static_cast<uint16_t>(part.x),
        static_cast<uint16_t>(top), width, static_cast<uint16_t>(part.height), x,
        static_cast<int16_t>(top), format_.depth, XCB_IMAGE_FORMAT_Z_PIXMAP, 0, segment_, 0);
    d.x.discard_reply(d.connection, cookie.sequence);
    return;
  }
  // As many rows at a time as a request can have.
  const size_t row_bytes = stride_of(part.width, format_.layout);
  const size_t most = static_cast<size_t>(d.x.get_maximum_request_length(d.connection)) * 4 - 64;
  const int rows = static_cast<int>(std::clamp<size_t>(most / row_bytes, 1, 4096));
  for (int done = 0; done < part.height; done += rows) {
    const int now = std::min(rows, part.height - done);
    rows_.resize(row_bytes * static_cast<size_t>(now));
    for (int i = 0; i < now; ++i) {
      write_row(buffer, part.x, part.y + part.height - 1 - done - i, part.width,
                rows_.data() + row_bytes * static_cast<size_t>(i));
    }
    const auto cookie = d.x.put_image_checked(
        d.connection, XCB_IMAGE_FORMAT_Z_PIXMAP, drawable_, gc_, width, static_cast<uint16_t>(now),
        x, static_cast<int16_t>(top + done), 0, format_.depth, static_cast<uint32_t>(rows_.size()),
        reinterpret_cast<const uint8_t*>(rows_.data()));
    d.x.discard_reply(d.connection, cookie.sequence);
  }
}

EGLint X11Drawable::put(const pipeline::ColourBuffer& buffer, std::span<const Rect> parts,
                        EGLint interval) try {
  const X11Platform& d = display();
  if (is_window_ && interval > 0) {
    clock_.wait(d, drawable_, interval, [this] { return is_closing(); });
  }
  // Its answer says that the drawable is there, and that the server is done with the shared memory.
  if (!d.size_of(drawable_)) return gone();
  const size_t stride = stride_of(buffer.width, format_.layout);
  share(stride * static_cast<size_t>(buffer.height));
  for (const Rect& part : parts) put_part(buffer, part, stride);
  d.x.flush(d.connection);
  return d.x.connection_has_error(d.connection) == 0 ? EGL_SUCCESS : gone();
} catch (const std::bad_alloc&) {
  return EGL_BAD_ALLOC;
}

EGLint X11Drawable::get(pipeline::ColourBuffer& buffer) {
  const X11Platform& d = display();
  const auto cookie =
      d.x.get_image(d.connection, XCB_IMAGE_FORMAT_Z_PIXMAP, drawable_, 0, 0,
                    static_cast<uint16_t>(buffer.width), static_cast<uint16_t>(buffer.height), ~0u);
  xcb_get_image_reply_t* reply = d.x.get_image_reply(d.connection, cookie, nullptr);
  if (reply == nullptr) return gone();
  const size_t stride = stride_of(buffer.width, format_.layout);
  const auto* rows = reinterpret_cast<const std::byte*>(d.x.get_image_data(reply));
  const size_t bytes = static_cast<size_t>(d.x.get_image_data_length(reply));
  const bool whole = bytes >= stride * static_cast<size_t>(buffer.height);
  for (int y = 0; whole && y < buffer.height; ++y) {
    from_layout(format_.layout, rows + stride * static_cast<size_t>(buffer.height - 1 - y),
                static_cast<size_t>(buffer.width),
                buffer.pixels.get() + static_cast<ptrdiff_t>(y) * buffer.width);
  }
  std::free(reply);
  return whole ? EGL_SUCCESS : gone();
}

}  // namespace clearpipe::icd
