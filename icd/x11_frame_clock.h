// The frames of a screen, as the Present extension counts them for a window: what the swap interval
// waits for.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "icd/x11_platform.h"

namespace clearpipe::icd {

class X11FrameClock {
 public:
  // Blocks until so many frames have been shown since the last call returned; gives up when told
  // to, or when the server keeps silent. The events come in a queue of their own, which no other
  // part of the application reads.
  void wait(const X11Platform& display, xcb_window_t window, EGLint frames,
            const std::function<bool()>& give_up);
  void stop(const X11Platform& display, xcb_window_t window);

 private:
  bool start(const X11Platform& display, xcb_window_t window);

  bool failed_ = false;
  uint32_t id_ = 0;
  uint32_t stamp_ = 0;
  xcb_special_event_t* events_ = nullptr;
  uint32_t serial_ = 0;
  uint64_t shown_ = 0;  // the frame the last call returned in
};

}  // namespace clearpipe::icd
