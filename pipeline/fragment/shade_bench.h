// A row of a tile to shade, and table 4.1 with the blend equations in double precision, for tests
// of the fragment stages. SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <memory>

#include "pipeline/fragment/own_tile.h"
#include "pipeline/fragment/program.h"

namespace clearpipe::pipeline {

using Colour = std::array<double, 4>;

struct Bench {
  FragmentState state;
  PrimitivePlanes planes;
  OwnTile tile;
  Coverage coverage{};
  FragmentCoverage coverage_kind = FragmentCoverage::kCentre;
  FragmentTarget target = {true, true};

  Bench() {
    planes.flat_colour = true;
    coverage.first_row = 0;
    coverage.last_row = 1;
    coverage.rows[0] = ~uint64_t{0};
  }

  void set_colour(const Colour& c) {
    for (int i = 0; i < 4; ++i) planes.colour[i] = {static_cast<float>(c[i]) * kColourOne, 0, 0};
  }

  void run() {
    const std::unique_ptr<FragmentProgram, void (*)(FragmentProgram*)> program(
        make_fragment_program(state, target, coverage_kind), destroy_fragment_program);
    shade(*program, planes, coverage, tile);
  }
};

inline int component(uint32_t pixel, int c) { return pixel >> (8 * c) & 0xff; }

inline uint32_t pack(const std::array<int, 4>& c) {
  return static_cast<uint32_t>(c[0]) | static_cast<uint32_t>(c[1]) << 8 |
         static_cast<uint32_t>(c[2]) << 16 | static_cast<uint32_t>(c[3]) << 24;
}

inline double clamp01(double v) { return std::clamp(v, 0.0, 1.0); }

inline double factor_of(BlendFactor f, int c, const Colour& s, const Colour& d) {
  switch (f) {
    case BlendFactor::kZero:
      return 0;
    case BlendFactor::kOne:
      return 1;
    case BlendFactor::kSrcColour:
      return s[c];
    case BlendFactor::kOneMinusSrcColour:
      return 1 - s[c];
    case BlendFactor::kDstColour:
      return d[c];
    case BlendFactor::kOneMinusDstColour:
      return 1 - d[c];
    case BlendFactor::kSrcAlpha:
      return s[3];
    case BlendFactor::kOneMinusSrcAlpha:
      return 1 - s[3];
    case BlendFactor::kDstAlpha:
      return d[3];
    case BlendFactor::kOneMinusDstAlpha:
      return 1 - d[3];
    case BlendFactor::kSrcAlphaSaturate:
      return c == 3 ? 1 : std::min(s[3], 1 - d[3]);
  }
  return 0;
}

inline double blended(BlendEquation equation, double s, double sf, double d, double df) {
  switch (equation) {
    case BlendEquation::kAdd:
      return s * sf + d * df;
    case BlendEquation::kSubtract:
      return s * sf - d * df;
    case BlendEquation::kReverseSubtract:
      return d * df - s * sf;
    case BlendEquation::kMin:
      return std::min(s, d);
    case BlendEquation::kMax:
      return std::max(s, d);
  }
  return 0;
}

}  // namespace clearpipe::pipeline
