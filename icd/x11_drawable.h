// A window or pixmap of X11: pixels go to it through memory shared with the server (MIT-SHM), or
// through the connection where that is not to be had.
// SPDX-License-Identifier: MIT
#pragma once

#include "icd/x11_frame_clock.h"
#include "icd/x11_platform.h"

namespace clearpipe::icd {

class X11Drawable : public NativeSurface {
 public:
  static bool make(std::shared_ptr<Platform> platform, xcb_drawable_t drawable, X11Format format,
                   bool is_window, std::shared_ptr<NativeSurface>& out);
  X11Drawable(std::shared_ptr<Platform> platform, xcb_drawable_t drawable, X11Format format,
              bool is_window);
  ~X11Drawable() override { close(); }
  bool has_alpha() const override { return format_.layout.rgba[3].bits > 0; }

 protected:
  std::optional<Size> get_size() override;
  EGLint put(const pipeline::ColourBuffer& buffer, std::span<const Rect> parts,
             EGLint interval) override;
  EGLint get(pipeline::ColourBuffer& buffer) override;
  void release() override;

 private:
  const X11Platform& display() const { return static_cast<const X11Platform&>(platform()); }
  EGLint gone() const { return is_window_ ? EGL_BAD_NATIVE_WINDOW : EGL_BAD_NATIVE_PIXMAP; }
  bool make_gc();
  // Memory for so many bytes that the server sees too; null if there is none.
  std::byte* share(size_t bytes);
  void unshare();
  void put_part(const pipeline::ColourBuffer& buffer, const Rect& part, size_t stride);
  void write_row(const pipeline::ColourBuffer& buffer, int x, int y, int width, std::byte* to);

  const xcb_drawable_t drawable_;
  const X11Format format_;
  const bool is_window_;
  xcb_gcontext_t gc_ = 0;
  bool try_shm_;
  xcb_shm_seg_t segment_ = 0;
  std::byte* shared_ = nullptr;
  size_t shared_bytes_ = 0;
  std::vector<std::byte> rows_;  // without shared memory
  std::vector<uint32_t> row_;
  X11FrameClock clock_;
};

}  // namespace clearpipe::icd
