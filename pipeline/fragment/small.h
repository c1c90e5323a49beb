// Whether a program can shade fragments of many small primitives in one batch (small-inl.h).
// SPDX-License-Identifier: MIT
#pragma once

#include "pipeline/fragment/program.h"

namespace clearpipe::pipeline {

// The texture units that such a program may use: the first so many.
inline constexpr int kSmallUnits = 2;

bool batches_small(const FragmentProgram& program);

// Whether the colours of primitives are those of their pixels, which replace what was there where
// no depth test keeps them from it.
bool writes_primitive_colours(const FragmentProgram& program);

}  // namespace clearpipe::pipeline
