// Pairs of small triangles that are shaded as one: the halves of a rectangle, of which interfaces
// and games in two dimensions are made.
// SPDX-License-Identifier: MIT
#pragma once

#include "pipeline/setup/lanes.h"

namespace clearpipe::pipeline {

// Whether triangles of a draw are looked at: textured ones are not, as coordinates that are the
// same everywhere make no picture.
inline bool merges_pairs(const SetupState& state) { return state.inputs.texture_units == 0; }

// Of the small triangles of such a draw that the job has settled: where two that follow each other
// lie in one box, have no pixel in common and the same value of everything that is interpolated at
// all of their vertices, the first gets the pixels of the second, which is left with none. What is
// drawn stays the same, to the bit. It gives up where the first few triangles make no pairs.
void merge_pairs(const SetupState& state, const LaneJob& job);

}  // namespace clearpipe::pipeline
