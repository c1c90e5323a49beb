// Which pixels of a tile a primitive covers, as squares: for primitives that cover few pixels of
// each row, such as lines and slivers, and of most rows of their box only here and there.
// SPDX-License-Identifier: MIT
#pragma once

#include "pipeline/setup/small.h"

namespace clearpipe::pipeline {

// The squares of 8x8 pixels of a tile in which something is covered.
struct CoveredSquares {
  static constexpr int kColumns = kTileWidth / kSmallSide, kRows = kTileHeight / kSmallSide;

  int count = 0;
  SmallCoverage square[kColumns * kRows];
};

// Fills `squares`; false when no pixel of the tile is covered. The pixels are those of cover_tile,
// but of circles all of their box. Not of primitives that are covered by samples.
bool cover_squares(const PrimitiveRecord& primitive, int tile_x, int tile_y,
                   CoveredSquares& squares);

}  // namespace clearpipe::pipeline
