// The EGL commands as programs call them, declared from egl15.def and egl_ext.def: what entry.h has
// of them, and debug output after it (EGL_KHR_debug).
// SPDX-License-Identifier: MIT
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace clearpipe::icd::command {

#define CALL(type, name, parameters, ...) type EGLAPIENTRY name parameters noexcept;
#include "icd/egl15.def"
#include "icd/egl_ext.def"
#undef CALL

}  // namespace clearpipe::icd::command
