// The least and the greatest of a draw's indices (2.8).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "pipeline/command.h"

namespace clearpipe::pipeline {

struct IndexRange {
  uint32_t least = 0xffffffffu, greatest = 0;
};

// Of `count` indices of a type other than kNone; any alignment will do.
IndexRange index_range(IndexType type, const std::byte* indices, size_t count);

}  // namespace clearpipe::pipeline
