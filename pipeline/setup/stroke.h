// Strokes: lines that are not antialiased, at most so wide, of which all is known after setup.
//
// In every column that such a line covers it has as many pixels above one another as it is wide
// (3.4.1, 3.4.2.1), or in every row, if it goes rather up than along, and depth and colours change
// along that axis alone. So a line is one edge, and what changes a value and a step, in a record
// that needs no vertices.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "pipeline/setup/primitive.h"

namespace clearpipe::pipeline {

// Wider lines are covered as polygons.
inline constexpr int kWidestStroke = 16;

// A value at the reference and its change from pixel to pixel along the major axis.
struct StrokeValue {
  float value, step;
};

// All of it is said for columns: those of a line along y are rows, and its rows are columns.
struct StrokeRecord {
  // Pixels are covered in columns of the box from the least row on for which slope * column + step
  // * row + start >= 0 (edge.h), with step > 0; of that and those after it as many as the line is
  // wide, as far as they are in the box.
  int64_t start;
  int32_t slope, step;
  int16_t x0, y0, x1, y1;  // of the window; half-open
  uint32_t draw;           // index of the draw in the frame
  bool x_major;
  uint8_t width;
  bool flat_colour;  // colours do not change, and are not divided by w
  bool perspective;  // 1/w changes: colours, if they do, are divided by it
  float reference;   // the window coordinate from which values count
  StrokeValue depth, inv_w;
  float colour[4], colour_step[4];  // in units of 1 / kColourOne
};

// The width of lines in whole pixels (3.4.2.1).
int stroke_width(const RasterState& state);

// Of a line with FragmentCoverage::kCentre, at most kWidestStroke wide, whose corners are known:
// setup_snapped_line() and make_planes() for it. False when nothing can be covered.
bool setup_stroke(const SetupState& state, const float* v0, const float* v1, bool x_major,
                  const SnappedPoint corners[4], StrokeRecord& out);

}  // namespace clearpipe::pipeline
