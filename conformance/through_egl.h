// The implementation that libglvnd finds, as any program meets it: through libEGL.so.1.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "conformance/implementation.h"

namespace clearpipe::conformance {

// Opens the surfaceless display. Which vendor answers is the environment's choice
// (__EGL_VENDOR_LIBRARY_FILENAMES). Throws std::runtime_error with the reason when there is none.
std::unique_ptr<Implementation> open_through_egl();

}  // namespace clearpipe::conformance
