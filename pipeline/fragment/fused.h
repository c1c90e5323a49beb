// The fused form of a fragment program: all stages in one loop over the rows of the coverage, with
// values in registers. It calls the same stage functions as the chain and gives the same bits.
//
// A loop is compiled for each pair of samplers in fused.def; everything else that the state says is
// the same for a whole draw, and a branch on it in the loop costs next to nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "pipeline/fragment/chain.h"

namespace clearpipe::pipeline {

// How a unit's texture is sampled. Those that are named have one image of one size, and the same
// filter and wrap mode in all directions; repeated ones have power-of-two sizes. kAny calls the
// program's sample function.
enum class FusedSampler : uint8_t {
  kNone,
  kNearestRepeat,
  kNearestClamp,
  kLinearRepeat,
  kLinearClamp,
  kAny
};

// The loop for a program, or null when there is none: then it runs as a chain.
FusedFunction select_fused(const FragmentProgram& program);

}  // namespace clearpipe::pipeline
