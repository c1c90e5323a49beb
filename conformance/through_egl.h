// The implementation that libglvnd finds, as any program meets it: through libEGL.so.1.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "conformance/implementation.h"

namespace clearpipe::conformance {

// What a pbuffer is made of: of exactly these sizes.
struct Buffers {
  int red = 8, green = 8, blue = 8, alpha = 8;
  int depth = 24, stencil = 8;
  int samples = 0;
  bool srgb = false;  // of the sRGB colour space
};

// Opens the surfaceless display, with buffers of so many samples a pixel (0: not multisampled).
// Which vendor answers is the environment's choice (__EGL_VENDOR_LIBRARY_FILENAMES). Throws
// std::runtime_error with the reason when there is none.
std::unique_ptr<Implementation> open_through_egl(int samples = 0);
std::unique_ptr<Implementation> open_through_egl(const Buffers& buffers);

// The same on Mesa's own OpenGL ES 1.1, if the environment names Mesa's vendor library too: opened
// by its device.
std::unique_ptr<Implementation> open_mesa_through_egl(int samples);
std::unique_ptr<Implementation> open_mesa_through_egl(const Buffers& buffers);

}  // namespace clearpipe::conformance
