// What is counted of strokes: see stroke.h.
// SPDX-License-Identifier: MIT
#include "pipeline/raster/stroke.h"

#include "pipeline/raster/tile_part.h"

namespace clearpipe::pipeline {

int count_pixels(const StrokeRecord& stroke, int tile_x, int tile_y) {
  const raster::TilePart part = raster::part_of_tile(stroke, tile_x, tile_y);
  const int64_t start = stroke_start(stroke, tile_x, tile_y);
  const auto [first, end] =
      stroke.x_major ? std::pair(part.x0, part.x1) : std::pair(part.y0, part.y1);
  const auto [low, high] =
      stroke.x_major ? std::pair(part.y0, part.y1) : std::pair(part.x0, part.x1);
  int count = 0;
  for (int column = first; column < end; ++column) {
    const int64_t value = start + int64_t{stroke.slope} * column;
    const int64_t rest = ((value % stroke.step) + stroke.step) % stroke.step;
    const int64_t row = (rest - value) / stroke.step;  // the floor of the quotient, negated
    const int64_t last = std::min<int64_t>(row + stroke.width, high);
    count += static_cast<int>(std::max<int64_t>(last - std::max<int64_t>(row, low), 0));
  }
  return count;
}

}  // namespace clearpipe::pipeline
