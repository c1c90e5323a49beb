// Debug output of EGL (EGL_KHR_debug): the callback that hears of errors, and the labels that
// applications give to displays, objects and threads.
// SPDX-License-Identifier: MIT
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>

namespace clearpipe::icd {

// Guarded by egl_mutex().
struct DebugOutput {
  EGLDEBUGPROCKHR callback = nullptr;
  // By EGL_DEBUG_MSG_CRITICAL_KHR, ERROR, WARN and INFO (table 13.1).
  std::array<bool, 4> enabled = {true, true, false, false};
};
DebugOutput& debug_output();

// The name of an error code, and what it means (3.1).
struct ErrorText {
  const char *name, *meaning;
};
ErrorText error_text(EGLint error);

// The label of a display or of an object of a display; null if it has none.
EGLLabelKHR label_of(const void* handle);

// At the end of a command: tells the callback of the error that it noted, if any. `object` is the
// primary object of the command (table 13.2); null: the thread.
class Report {
 public:
  Report(const char* command, const void* object) : command_(command), object_(object) {}
  ~Report();
  Report(const Report&) = delete;
  Report& operator=(const Report&) = delete;

 private:
  const char* const command_;
  const void* const object_;
};

}  // namespace clearpipe::icd
