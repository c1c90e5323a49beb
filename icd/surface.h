// Surfaces (3.5): what they are created with, and the buffers they own.
// SPDX-License-Identifier: MIT
#pragma once

#include "icd/display.h"

namespace clearpipe::icd {

// Reads the attributes of a pbuffer (3.5.2) for the surface's config; the EGL error of what is
// wrong with them, or EGL_SUCCESS.
EGLint parse_pbuffer(const EGLint* list, Surface& out);

// As above for a window or a pixmap, which the surface is (3.5.1, 3.5.4).
EGLint parse_native(const EGLint* list, Surface& out);
EGLint parse_native(const EGLAttrib* list, Surface& out);

// Buffers of the surface's size; false when memory does not suffice. A pbuffer that has a mipmap
// has buffers for every level (EGL_MIPMAP_TEXTURE).
bool make_buffers(Surface& surface);

// The level that is drawn to from now on: the closest one that there is (EGL_MIPMAP_LEVEL). Bind
// the targets of a context after it.
void select_level(Surface& surface, EGLint level);

// Gives a window's surface the size that the window has now (3.10.1.1); where memory does not
// suffice for it, the surface keeps its size. False: there is no such window any more. To be called
// on the thread to which the surface is current, or where it is current to none.
bool follow_size(Surface& surface);

// What was drawn to a pixmap's surface comes to the pixmap.
void copy_to_pixmap(Surface& surface);

// Its handle is void, and its window or pixmap is let go of, although it may be current.
void destroy(Surface& surface);

}  // namespace clearpipe::icd
