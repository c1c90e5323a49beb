// Surfaces (3.5): what they are created with, and the buffers they own.
// SPDX-License-Identifier: MIT
#pragma once

#include "icd/display.h"

namespace clearpipe::icd {

// Reads the attributes of a pbuffer (3.5.2) for the surface's config; the EGL error of what is
// wrong with them, or EGL_SUCCESS.
EGLint parse_pbuffer(const EGLint* list, Surface& out);

// Buffers of the surface's size; false when memory does not suffice. A pbuffer that has a mipmap
// has buffers for every level (EGL_MIPMAP_TEXTURE).
bool make_buffers(Surface& surface);

// The level that is drawn to from now on: the closest one that there is (EGL_MIPMAP_LEVEL). Bind
// the targets of a context after it.
void select_level(Surface& surface, EGLint level);

}  // namespace clearpipe::icd
