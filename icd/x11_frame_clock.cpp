// See x11_frame_clock.h.
// SPDX-License-Identifier: MIT
#include "icd/x11_frame_clock.h"

#include <chrono>
#include <cstdlib>
#include <thread>

namespace clearpipe::icd {

namespace {

using Clock = std::chrono::steady_clock;

// A window that is destroyed gets no more events, and no answer that says so.
constexpr auto kFramePatience = std::chrono::milliseconds(500);

}  // namespace

bool X11FrameClock::start(const X11Platform& d, xcb_window_t window) {
  if (failed_ || events_ != nullptr) return !failed_;
  failed_ = true;
  if (!d.has_present()) return false;
  const uint32_t id = d.x.generate_id(d.connection);
  events_ = d.x.register_for_special_xge(d.connection, d.x.present.id, id, &stamp_);
  xcb_generic_error_t* error = d.x.request_check(
      d.connection, d.x.present.select_input_checked(d.connection, id, window,
                                                     XCB_PRESENT_EVENT_MASK_COMPLETE_NOTIFY));
  if (error == nullptr && events_ != nullptr) {
    id_ = id;
    failed_ = false;
    return true;
  }
  std::free(error);
  stop(d, window);
  return false;
}

void X11FrameClock::stop(const X11Platform& d, xcb_window_t window) {
  if (id_ != 0) {
    const auto cookie = d.x.present.select_input_checked(d.connection, id_, window, 0);
    d.x.discard_reply(d.connection, cookie.sequence);
  }
  if (events_ != nullptr) d.x.unregister_for_special_event(d.connection, events_);
  events_ = nullptr;
  id_ = 0;
}

void X11FrameClock::wait(const X11Platform& d, xcb_window_t window, EGLint frames,
                         const std::function<bool()>& give_up) {
  if (!start(d, window)) return;
  // A frame of long ago is as good as one that has just been shown: then this returns at once.
  const auto cookie = d.x.present.notify_msc_checked(d.connection, window, ++serial_,
                                                     shown_ + static_cast<uint64_t>(frames), 0, 0);
  d.x.discard_reply(d.connection, cookie.sequence);
  d.x.flush(d.connection);
  const auto end = Clock::now() + kFramePatience * frames;
  while (Clock::now() < end && !give_up() && d.x.connection_has_error(d.connection) == 0) {
    auto* event = reinterpret_cast<xcb_present_complete_notify_event_t*>(
        d.x.poll_for_special_event(d.connection, events_));
    if (event == nullptr) {
      std::this_thread::sleep_for(std::chrono::microseconds(500));
      continue;
    }
    const bool ours =
        event->kind == XCB_PRESENT_COMPLETE_KIND_NOTIFY_MSC && event->serial == serial_;
    if (ours) shown_ = event->msc;
    std::free(event);
    if (ours) return;
  }
  failed_ = true;  // the next frames do not wait for it again
}

}  // namespace clearpipe::icd
