// The OpenGL ES 1.1 commands as a table of pointers, so that one scene runs on any implementation.
// SPDX-License-Identifier: MIT
#pragma once

#include <GLES/gl.h>
#define GL_GLEXT_PROTOTYPES
#include <GLES/glext.h>

namespace clearpipe::conformance {

// Members are named as the commands, without the prefix: gl.DrawArrays(...). The list is the one
// list of calls; only the names are taken from it.
struct Gl {
#define CALL(type, name, parameters, ...) type(GL_APIENTRY* name) parameters = nullptr;
#include "api/gles1.def"
#undef CALL
};

// Fills the table by a lookup of the form void* find(const char* name with the prefix).
template <class Find>
Gl load_gl(const Find& find) {
  Gl gl;
#define CALL(type, name, parameters, ...) \
  gl.name = reinterpret_cast<type(GL_APIENTRY*) parameters>(find("gl" #name));
#include "api/gles1.def"
#undef CALL
  return gl;
}

}  // namespace clearpipe::conformance
