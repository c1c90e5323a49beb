// The corners of triangles of a list by their indices, many at once (2.6.1).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "pipeline/command.h"

namespace clearpipe::pipeline {

// corner[k][i] becomes index 3 * i + k, less `first`. Of a type other than kNone; any alignment of
// the indices will do.
void triangle_corners(IndexType type, const std::byte* indices, size_t triangles, uint32_t first,
                      int32_t* const (&corner)[3]);

}  // namespace clearpipe::pipeline
