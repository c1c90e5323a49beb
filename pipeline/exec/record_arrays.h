// Taking a draw's vertex and index data into the frame.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "pipeline/command.h"
#include "pipeline/exec/arena.h"

namespace clearpipe::pipeline {

// Makes `out` a copy of `command` whose pointers stay good until the frame is done: what lies in
// client memory is copied into the arena, compactly and only the elements that are used; what lies
// in buffer objects is kept by reference. Returns the element index that the copies begin with,
// which the caller subtracts from every index.
uint32_t record_arrays(const DrawCommand& command, Arena& arena, DrawCommand& out);

}  // namespace clearpipe::pipeline
