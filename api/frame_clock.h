// The frames a context has finished, counted. It only grows, and outlives the context while anybody
// notes a frame of it: objects that frames read (frame_uses.h), fences and sync objects.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>

namespace clearpipe::api {

class FrameCounter {
 public:
  // The number of the frame that is being recorded. Seen from elsewhere, everything that the frames
  // before it did has happened.
  uint64_t now() const { return frames_.load(std::memory_order_acquire); }
  bool is_over(uint64_t frame) const { return now() > frame; }

  void advance() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      frames_.fetch_add(1, std::memory_order_release);
    }
    advanced_.notify_all();
  }

  // Blocks until the frame is over or until `timeout` nanoseconds have passed; false: they have.
  bool wait(uint64_t frame, uint64_t timeout) const {
    // A deadline that a clock can hold: three centuries are for ever.
    constexpr uint64_t kForever = uint64_t{1} << 62;
    std::unique_lock<std::mutex> lock(mutex_);
    const auto over = [&] { return is_over(frame); };
    if (timeout >= kForever) {
      advanced_.wait(lock, over);
      return true;
    }
    return advanced_.wait_for(lock, std::chrono::nanoseconds(timeout), over);
  }

 private:
  std::atomic<uint64_t> frames_{0};
  mutable std::mutex mutex_;
  mutable std::condition_variable advanced_;
};
using FrameClock = std::shared_ptr<FrameCounter>;

}  // namespace clearpipe::api
