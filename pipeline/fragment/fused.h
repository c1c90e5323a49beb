// The fused form of a fragment program: loops over the rows of the coverage, with values in
// registers. They call the same stage functions as the chain and give the same bits.
//
// The tests come first, then the colours, then what is not simply replaced (fused-inl.h). One form
// is compiled without textures and one with any number of them; samplers and blendings of fused.def
// are functions over a row. SPDX-License-Identifier: MIT
#pragma once

#include "pipeline/fragment/chain.h"

namespace clearpipe::pipeline {

// Sets the program's fused form, with the samplers of its units; on a target that has none, the
// program goes on as a chain.
void select_fused(FragmentProgram& program);

// The texture units that a program which is shaded in strips may use: the first so many.
inline constexpr int kStripUnits = 2;

}  // namespace clearpipe::pipeline
