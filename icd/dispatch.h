// The way of extension commands through libglvnd, which knows only EGL 1.5: it asks the vendors for
// a stub per command, and the stub finds the vendor whose display or device it is given
// (glvnd/libeglabi.h).
// SPDX-License-Identifier: MIT
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <glvnd/libeglabi.h>

namespace clearpipe::icd {

void set_dispatch_exports(const __EGLapiExports* exports);

// The stub of a command of ours, or null; and the index under which libglvnd keeps the command.
void* dispatch_address(const char* name);
void set_dispatch_index(const char* name, int index);

}  // namespace clearpipe::icd
