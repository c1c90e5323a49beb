// Scenes on OSMesa: Mesa's llvmpipe through desktop OpenGL.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "conformance/implementation.h"

namespace clearpipe::reference {

// Opens libOSMesa.so.8 and pins its driver (numerics.md says why). Throws std::runtime_error with
// the reason when it cannot. One at a time, and one driver in a process: Mesa fixes it when it is
// loaded.
std::unique_ptr<conformance::Implementation> open_osmesa(const char* driver = "llvmpipe");

}  // namespace clearpipe::reference
