// The EGL commands as C++ functions, declared from egl15.def and
// egl_ext.def. Each sets the thread's error (3.1).
// SPDX-License-Identifier: MIT
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "icd/display.h"

namespace clearpipe::icd::entry {

#define CALL(type, name, parameters, ...) type name parameters noexcept;
#include "icd/egl15.def"
#include "icd/egl_ext.def"
#undef CALL

// Under libglvnd, which keeps the current rendering API itself: where to ask for it (3.7).
void set_current_api_source(EGLenum (*source)());

// Notes the error and gives `result` back: `return fail(EGL_BAD_DISPLAY, EGL_FALSE)`.
template <class Result>
Result fail(EGLint error, Result result) {
  this_thread().error = error;
  return result;
}

template <class Result>
Result succeed(Result result) {
  return fail(EGL_SUCCESS, result);
}

// The display of a handle when it is initialized; else notes the error and returns null (3.2).
Display* initialized_display(EGLDisplay handle);

}  // namespace clearpipe::icd::entry
