// SPDX-License-Identifier: MIT
//
// A context of OpenGL ES 1 with a surface to draw into: a pbuffer on a display without a window
// system, or a window of X11.
#pragma once

#include "bench/scene.h"

namespace bench {

// Fills in display and surface; of a window also the size, which the server decides.
void open_context(View& view, bool window);
void close_context(const View& view);

}  // namespace bench
