// OpenGL ES 1.1 on desktop OpenGL's compatibility profile: most commands are the same; the
// fixed-point ones, the float forms of double ones, and vertex arrays of types that only ES has
// are translated.
// SPDX-License-Identifier: MIT
#pragma once

#include "conformance/gl.h"

namespace clearpipe::reference {

// The table of ES commands over the desktop's commands, which `find` gives by name. One table at a
// time: the translations keep their desktop commands and their arrays in this file's variables.
conformance::Gl gles1_on_gl(void* (*find)(const char* name));

// To be called when a new context is made current: forgets the vertex arrays of the last one.
void forget_arrays();

}  // namespace clearpipe::reference
