// The attribute list of eglCreateContext: see context_attributes.h.
// SPDX-License-Identifier: MIT
#include "icd/context_attributes.h"

namespace clearpipe::icd {

namespace {

EGLint parse_boolean(EGLint value, bool& out) {
  if (value != EGL_FALSE && value != EGL_TRUE) return EGL_BAD_ATTRIBUTE;
  out = value == EGL_TRUE;
  return EGL_SUCCESS;
}

// Attributes of OpenGL alone, its profiles and forward compatibility, fall under the default.
EGLint parse_attribute(EGLint name, EGLint value, ContextAttributes& out) {
  switch (name) {
    case EGL_CONTEXT_MAJOR_VERSION:
      out.major = value;
      return EGL_SUCCESS;
    case EGL_CONTEXT_MINOR_VERSION:
      out.minor = value;
      return EGL_SUCCESS;
    case EGL_CONTEXT_FLAGS_KHR:  // EGL_KHR_create_context: the other bits are for OpenGL
      if ((value & ~EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR) != 0) return EGL_BAD_ATTRIBUTE;
      out.debug = value != 0;
      return EGL_SUCCESS;
    case EGL_CONTEXT_OPENGL_DEBUG:
      return parse_boolean(value, out.debug);
    case EGL_CONTEXT_OPENGL_NO_ERROR_KHR:
      return parse_boolean(value, out.no_error);
    case EGL_CONTEXT_OPENGL_ROBUST_ACCESS:
    case EGL_CONTEXT_OPENGL_ROBUST_ACCESS_EXT:
      return parse_boolean(value, out.robust_access);
    case EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY:
    case EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT:
      if (value != EGL_NO_RESET_NOTIFICATION && value != EGL_LOSE_CONTEXT_ON_RESET) {
        return EGL_BAD_ATTRIBUTE;
      }
      out.reset_notification = value;
      return EGL_SUCCESS;
    case EGL_CONTEXT_RELEASE_BEHAVIOR_KHR:
      // A context that is released without being flushed may be flushed all the same.
      if (value != EGL_CONTEXT_RELEASE_BEHAVIOR_NONE_KHR &&
          value != EGL_CONTEXT_RELEASE_BEHAVIOR_FLUSH_KHR) {
        return EGL_BAD_ATTRIBUTE;
      }
      return EGL_SUCCESS;
    default:
      return EGL_BAD_ATTRIBUTE;
  }
}

}  // namespace

EGLint parse_context_attributes(const EGLint* list, ContextAttributes& out) {
  for (; list != nullptr && *list != EGL_NONE; list += 2) {
    const EGLint error = parse_attribute(list[0], list[1], out);
    if (error != EGL_SUCCESS) return error;
  }
  // The versions there are: 1.0 and 1.1; later ones are not for any config here (3.7.1.1).
  if (out.major != 1 || out.minor < 0 || out.minor > 1) return EGL_BAD_MATCH;
  // EGL_KHR_create_context_no_error: nothing is left to be debugged, nor is there a promise.
  if (out.no_error && (out.debug || out.robust_access)) return EGL_BAD_MATCH;
  return EGL_SUCCESS;
}

api::ContextFlags context_flags(const ContextAttributes& attributes) {
  return {attributes.debug, attributes.no_error, attributes.robust_access,
          attributes.reset_notification == EGL_LOSE_CONTEXT_ON_RESET};
}

bool may_share(const ContextAttributes& a, const ContextAttributes& b) {
  return a.reset_notification == b.reset_notification && a.no_error == b.no_error;
}

}  // namespace clearpipe::icd
