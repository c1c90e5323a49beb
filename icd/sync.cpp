// Sync objects: see sync.h.
// SPDX-License-Identifier: MIT
#include "icd/sync.h"

#include <algorithm>
#include <chrono>

namespace clearpipe::icd {

void Sync::signal() {
  if (signaled_) return;
  signaled_ = true;
  ++signals_;
  changed_.notify_all();
}

bool Sync::wait(std::unique_lock<std::mutex>& lock, EGLTime timeout) {
  if (signaled_ || timeout == 0) return signaled_;
  const auto released = [this, before = signals_] { return signals_ != before; };
  if (timeout == EGL_FOREVER) {
    changed_.wait(lock, released);
    return true;
  }
  // A century: longer waits would overflow the clock.
  constexpr EGLTime kLongest = 100ull * 365 * 24 * 3600 * 1000 * 1000 * 1000;
  const std::chrono::nanoseconds length(static_cast<int64_t>(std::min(timeout, kLongest)));
  return changed_.wait_until(lock, std::chrono::steady_clock::now() + length, released);
}

}  // namespace clearpipe::icd
