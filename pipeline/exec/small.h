// Small primitives of a tile: from their records to pixels, on the SIMD target in use.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "pipeline/exec/frame_data.h"
#include "pipeline/setup/small.h"

namespace clearpipe::pipeline {

// Whether what a draw makes small is made a small primitive.
bool draws_small(const DrawState& draw);

// Shades primitives of a packet in a tile: as many from the first entry of `entries` on as are
// small ones of draws with its state, `state`; returns how many that are.
size_t shade_small(const std::vector<DrawRecord>& draws, const DrawState& state,
                   const SmallPrimitive* primitives, std::span<const uint32_t> entries, Tile& tile);

}  // namespace clearpipe::pipeline
