// Lines that are not antialiased, of colours that are written as they are: drawn at once, a vector
// of columns after another, or of rows. Depth and colours change along the major axis alone
// (3.4.1), so that all pixels of a column have one value of each.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "pipeline/exec/frame_data.h"
#include "pipeline/raster/tile.h"
#include "pipeline/setup/stroke.h"

namespace clearpipe::pipeline {

// Whether lines that are drawn with the state, which has all but that, are strokes.
bool draws_strokes(const DrawState& state);

// How many a packet has of so many. Of scattered lines, a tile then finds more in one place; but
// all workers are to have some.
constexpr uint32_t packet_strokes(uint32_t count) {
  constexpr uint32_t kParts = 8, kMost = 4096;
  return std::clamp(count / kParts / kPacketPrimitives * kPacketPrimitives, kPacketPrimitives,
                    kMost);
}

// Draws what a tile has of one.
void draw_stroke(const FragmentProgram& program, const StrokeRecord& stroke, Tile& tile);

}  // namespace clearpipe::pipeline
