// Looking at a pointer that may be none: a native display of an unknown kind.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace clearpipe::icd {

// Whether so many bytes can be read there.
bool is_readable(const void* pointer, size_t bytes);

}  // namespace clearpipe::icd
