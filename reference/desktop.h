// What the translations of gles1_on_gl share: the desktop's commands and the shadow of the vertex
// arrays.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "conformance/gl.h"

namespace clearpipe::reference {

using conformance::Gl;

// Commands of the desktop that ES lacks.
struct DesktopOnly {
  void (*Frustum)(double, double, double, double, double, double) = nullptr;
  void (*Ortho)(double, double, double, double, double, double) = nullptr;
  void (*ClipPlane)(GLenum, const double*) = nullptr;
  void (*GetClipPlane)(GLenum, double*) = nullptr;
  void (*GetBufferSubData)(GLenum, GLintptr, GLsizeiptr, void*) = nullptr;
  void (*TexGeni)(GLenum, GLenum, GLint) = nullptr;
};

extern Gl desktop;  // the commands of the same name
extern DesktopOnly desktop_only;

inline float from_fixed(GLfixed value) { return static_cast<float>(value) / 65536.0f; }

// Put the translations into the table.
void translate_fixed(Gl& gl);
void translate_arrays(Gl& gl);

}  // namespace clearpipe::reference
