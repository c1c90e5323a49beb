// The indices of a draw: their size, the least and the greatest of them (2.8).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "pipeline/command.h"

namespace clearpipe::pipeline {

inline uint32_t index_bytes(IndexType type) {
  switch (type) {
    case IndexType::kNone:
      return 0;
    case IndexType::kUnsignedByte:
      return 1;
    case IndexType::kUnsignedShort:
      return 2;
    case IndexType::kUnsignedInt:
      return 4;
  }
  return 0;
}

struct IndexRange {
  uint32_t least = 0xffffffffu, greatest = 0;
};

// Of `count` indices of a type other than kNone; any alignment will do.
IndexRange index_range(IndexType type, const std::byte* indices, size_t count);

}  // namespace clearpipe::pipeline
