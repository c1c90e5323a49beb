// The fused form of a fragment program: all stages in one loop over the rows of the coverage, with
// values in registers. It calls the same stage functions as the chain and gives the same bits.
//
// One loop is compiled without textures and one with any number of them, whose samplers
// (fused.def) are functions over a group of pixels. Everything else that the state says is the same
// for a whole draw, and a branch on it in the loop costs next to nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include "pipeline/fragment/chain.h"

namespace clearpipe::pipeline {

// Sets the program's fused form, with the samplers of its units; on a target that has none, the
// program goes on as a chain.
void select_fused(FragmentProgram& program);

}  // namespace clearpipe::pipeline
