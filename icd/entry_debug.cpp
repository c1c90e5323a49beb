// EGL commands of EGL_KHR_debug. They return their error; eglGetError knows nothing of it.
// SPDX-License-Identifier: MIT
#include <new>

#include "icd/debug.h"
#include "icd/entry.h"

namespace clearpipe::icd::entry {

namespace {

bool is_message_type(EGLAttrib attribute) {
  return attribute >= EGL_DEBUG_MSG_CRITICAL_KHR && attribute <= EGL_DEBUG_MSG_INFO_KHR;
}

// Whether the object is one of the display, of the kind that has the type (3.13.2).
bool is_object(Display& display, EGLenum type, EGLObjectKHR object) {
  switch (type) {
    case EGL_OBJECT_DISPLAY_KHR:
      return object == &display;
    case EGL_OBJECT_CONTEXT_KHR:
      return display.initialized && display.context(object) != nullptr;
    case EGL_OBJECT_SURFACE_KHR:
      return display.initialized && display.surface(object) != nullptr;
    case EGL_OBJECT_IMAGE_KHR:
      return display.initialized && display.has_image(object);
    case EGL_OBJECT_SYNC_KHR:
      return display.initialized && display.sync(object) != nullptr;
    default:
      return false;
  }
}

}  // namespace

EGLint DebugMessageControlKHR(EGLDEBUGPROCKHR callback, const EGLAttrib* attrib_list) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  DebugOutput next = debug_output();
  for (const EGLAttrib* a = attrib_list; a != nullptr && *a != EGL_NONE; a += 2) {
    if (!is_message_type(a[0]) || (a[1] != EGL_TRUE && a[1] != EGL_FALSE)) {
      return EGL_BAD_ATTRIBUTE;
    }
    next.enabled[static_cast<size_t>(a[0] - EGL_DEBUG_MSG_CRITICAL_KHR)] = a[1] == EGL_TRUE;
  }
  next.callback = callback;
  debug_output() = callback != nullptr ? next : DebugOutput();
  return EGL_SUCCESS;
}

EGLBoolean QueryDebugKHR(EGLint attribute, EGLAttrib* value) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  const DebugOutput& output = debug_output();
  if (value == nullptr) return fail(EGL_BAD_PARAMETER, EGL_FALSE);
  if (attribute == EGL_DEBUG_CALLBACK_KHR) {
    *value = reinterpret_cast<EGLAttrib>(output.callback);
  } else if (is_message_type(attribute)) {
    *value = output.enabled[static_cast<size_t>(attribute - EGL_DEBUG_MSG_CRITICAL_KHR)];
  } else {
    return fail(EGL_BAD_ATTRIBUTE, EGL_FALSE);
  }
  return succeed(EGL_TRUE);
}

EGLint LabelObjectKHR(EGLDisplay dpy, EGLenum type, EGLObjectKHR object, EGLLabelKHR label) noexcept
    try {
  if (type == EGL_OBJECT_THREAD_KHR) {
    this_thread().label = label;
    return EGL_SUCCESS;
  }
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = find_display(dpy);
  if (display == nullptr) return EGL_BAD_DISPLAY;
  if (!is_object(*display, type, object)) return EGL_BAD_PARAMETER;
  display->labels[object] = label;
  return EGL_SUCCESS;
} catch (const std::bad_alloc&) {
  return EGL_BAD_ALLOC;
}

}  // namespace clearpipe::icd::entry
