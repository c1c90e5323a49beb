// Debug output: see debug.h.
// SPDX-License-Identifier: MIT
#include "icd/debug.h"

#include <cstdio>

#include "icd/display.h"

namespace clearpipe::icd {

DebugOutput& debug_output() {
  static DebugOutput output;
  return output;
}

ErrorText error_text(EGLint error) {
  switch (error) {
    case EGL_NOT_INITIALIZED:
      return {"EGL_NOT_INITIALIZED", "the display is not initialized, or cannot be"};
    case EGL_BAD_ACCESS:
      return {"EGL_BAD_ACCESS", "a resource is in use elsewhere"};
    case EGL_BAD_ALLOC:
      return {"EGL_BAD_ALLOC", "resources do not suffice"};
    case EGL_BAD_ATTRIBUTE:
      return {"EGL_BAD_ATTRIBUTE", "an attribute or its value is not recognized"};
    case EGL_BAD_CONFIG:
      return {"EGL_BAD_CONFIG", "the config is none of this display's"};
    case EGL_BAD_CONTEXT:
      return {"EGL_BAD_CONTEXT", "the context is not valid"};
    case EGL_BAD_CURRENT_SURFACE:
      return {"EGL_BAD_CURRENT_SURFACE", "the thread's surface is no longer valid"};
    case EGL_BAD_DISPLAY:
      return {"EGL_BAD_DISPLAY", "the display is not valid"};
    case EGL_BAD_MATCH:
      return {"EGL_BAD_MATCH", "arguments are inconsistent"};
    case EGL_BAD_NATIVE_PIXMAP:
      return {"EGL_BAD_NATIVE_PIXMAP", "the native pixmap is not valid"};
    case EGL_BAD_NATIVE_WINDOW:
      return {"EGL_BAD_NATIVE_WINDOW", "the native window is not valid"};
    case EGL_BAD_PARAMETER:
      return {"EGL_BAD_PARAMETER", "an argument is not valid"};
    case EGL_BAD_SURFACE:
      return {"EGL_BAD_SURFACE", "the surface is not valid for this"};
    case EGL_BAD_DEVICE_EXT:
      return {"EGL_BAD_DEVICE_EXT", "the device is not valid"};
    default:
      return {"EGL error", "unknown"};
  }
}

EGLLabelKHR label_of(const void* handle) {
  for (const auto& display : displays()) {
    const auto found = display->labels.find(handle);
    if (found != display->labels.end()) return found->second;
  }
  return nullptr;
}

Report::~Report() {
  const Thread& thread = this_thread();
  const EGLint error = thread.error;
  if (error == EGL_SUCCESS) return;
  const ErrorText text = error_text(error);
  if (api::debug_to_stderr()) {
    std::fprintf(stderr, "clearpipe: %s: %s: %s\n", command_, text.name, text.meaning);
  }
  EGLDEBUGPROCKHR callback = nullptr;
  EGLLabelKHR label = nullptr;
  const EGLint type = error == EGL_BAD_ALLOC ? EGL_DEBUG_MSG_CRITICAL_KHR : EGL_DEBUG_MSG_ERROR_KHR;
  {
    const std::lock_guard<std::mutex> lock(egl_mutex());
    const DebugOutput& output = debug_output();
    if (!output.enabled[static_cast<size_t>(type - EGL_DEBUG_MSG_CRITICAL_KHR)]) return;
    callback = output.callback;
    label = object_ != nullptr ? label_of(object_) : thread.label;
  }
  if (callback != nullptr) {
    callback(static_cast<EGLenum>(error), command_, type, thread.label, label, text.meaning);
  }
}

}  // namespace clearpipe::icd
