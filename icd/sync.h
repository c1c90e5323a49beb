// Sync objects (3.8.1): fences (EGL_KHR_fence_sync) and reusable syncs (EGL_KHR_reusable_sync).
//
// A fence is signaled from the start: eglCreateSync finishes what its context has recorded. So a
// fence can be polled and waited for by any thread, with or without
// EGL_SYNC_FLUSH_COMMANDS_BIT, while its context is current to another one.
// SPDX-License-Identifier: MIT
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace clearpipe::icd {

// All members are guarded by egl_mutex(). Waiting threads hold a reference, so that a sync can be
// destroyed under them.
class Sync {
 public:
  Sync(void* handle, EGLenum type, bool signaled)
      : handle(handle), type(type), signaled_(signaled) {}

  void* const handle;
  const EGLenum type;  // EGL_SYNC_FENCE or EGL_SYNC_REUSABLE_KHR

  bool signaled() const { return signaled_; }
  void signal();  // releases all that wait, even if unsignal() follows at once
  void unsignal() { signaled_ = false; }

  // Blocks until signaled or until `timeout` nanoseconds have passed; false: they have. Other
  // threads use EGL meanwhile: `lock` holds egl_mutex().
  bool wait(std::unique_lock<std::mutex>& lock, EGLTime timeout);

 private:
  bool signaled_;
  uint64_t signals_ = 0;  // how often it went from unsignaled to signaled
  std::condition_variable changed_;
};

}  // namespace clearpipe::icd
