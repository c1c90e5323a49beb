// How covered pixels become colours: the program a fragment state selects, the planes of the
// primitive it runs on, and the call that runs it over the coverage of a tile.
//
// A program is chosen once per state change (fragment/select.cpp): a chain of stages that runs any
// state, or the fused form, which is quicker and runs most of them. Both give the same bits.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "pipeline/colour_format.h"
#include "pipeline/raster/samples.h"
#include "pipeline/raster/tile.h"
#include "pipeline/state.h"

namespace clearpipe::pipeline {

// 1.0 in the fixed point of the fragment stages' colours (fragment/colour-inl.h).
inline constexpr int16_t kColourOne = 1 << 13;

// A linear function of window position (3.5.1): value + dx * (x - x_ref) + dy * (y - y_ref), where
// (x_ref, y_ref) belongs to the primitive. Evaluated exactly in this order, so that the result
// depends on the pixel alone: (value + dy * (y - y_ref)) + dx * (x - x_ref).
struct Plane {
  float value = 0, dx = 0, dy = 0;
};

// How a fragment comes about and what it covers (3.2).
enum class FragmentCoverage : uint8_t {
  kCentre,            // the pixel's centre is covered; all of the pixel is then
  kSmooth,            // antialiased points and lines: the area covered is a factor of alpha (3.9)
  kMultisample,       // some of the pixel's samples are covered (3.2.1)
  kMultisamplePoint,  // the same, and the fade factor multiplies alpha (3.10)
};
inline constexpr int kFragmentCoverages = 4;

constexpr bool is_multisample(FragmentCoverage coverage) {
  return coverage >= FragmentCoverage::kMultisample;
}

// The region an antialiased point or line covers, relative to the planes' reference: a circle
// (3.3.1) or the rectangle around the segment to (dx, dy) (3.4.2).
struct SmoothRegion {
  bool is_circle = false;
  float half_width = 0;
  float dx = 0, dy = 0;
};

// The planes of one primitive. Varyings other than depth are divided by w_clip when `perspective`.
struct PrimitivePlanes {
  float x_ref = 0, y_ref = 0;  // window coordinates; pixel (i, j) has its centre at i+0.5, j+0.5
  bool perspective = false;    // false: 1/w is the same at all vertices, inv_w is not evaluated
  bool flat_colour = false;    // the colour planes are constant: dx = dy = 0 and not divided by w
  SmoothRegion region;         // with FragmentCoverage::kSmooth
  float point_fade = 1;        // with FragmentCoverage::kMultisamplePoint (equation 3.2)
  Plane depth;                 // window z, [0,1], polygon offset added (clamped per fragment)
  Plane inv_w;
  Plane fog;                           // fog coordinate
  Plane colour[4];                     // r, g, b, a, in units of 1 / kColourOne
  Plane texture[kMaxTextureUnits][4];  // s, t, r, q; set for enabled units
};

struct FragmentProgram;  // opaque outside fragment/

// Select and build the program of a state, for fragments that come about in one way. The result is
// owned by the caller's arena through destroy_fragment_program.
struct FragmentTarget {
  bool has_depth = false, has_stencil = false;
  int depth_bits = 24;
  bool multisampled = false;  // then the program is for shade_samples
  bool srgb = false;          // colours are written sRGB-encoded
  ColourFormat format = ColourFormat::kRgba8;

  bool operator==(const FragmentTarget&) const = default;
};
FragmentProgram* make_fragment_program(const FragmentState& state, const FragmentTarget& target,
                                       FragmentCoverage coverage);
void destroy_fragment_program(FragmentProgram* program);

// The same in the memory of a program that is no longer needed.
void remake_fragment_program(FragmentProgram& program, const FragmentState& state,
                             const FragmentTarget& target, FragmentCoverage coverage);

// Which varyings the program reads, so that setup computes no other plane.
struct FragmentInputs {
  bool depth = false, colour = false, fog = false;
  uint8_t texture_units = 0;  // bit u
};
FragmentInputs fragment_inputs(const FragmentProgram& program);

// Whether primitives of some width in pixels, which have no perspective, are shaded well by
// themselves (strips-inl.h), and need no batch (small.h).
bool shades_strips(const FragmentProgram& program);

// What the depth test of the program does (4.1.5).
struct DepthRule {
  bool test = false;  // on values that can be compared as integers of 24 bits
  bool write = false;
  bool discards = false;   // something else may keep a fragment from being stored
  bool traceless = false;  // a fragment that fails changes nothing, the stencil neither
  CompareFunc func = CompareFunc::kAlways;
  float one = 16777215.0f;  // the buffer's value of depth 1
};

// What the program does to the tile's planes.
struct FragmentOutputs {
  DepthRule depth;
  bool colour = false;    // writes colour
  bool solid = false;     // and it is that of the primitive, for all of its pixels
  bool replaces = false;  // every covered pixel gets a colour that does not depend on what it had
  bool depth_stencil_read = false;
  uint32_t depth_stencil_write = 0;  // the bits of values that may change
};
FragmentOutputs fragment_outputs(const FragmentProgram& program);

// The pixel that a program with FragmentOutputs::solid writes for a primitive of one colour.
uint32_t solid_pixel(const FragmentProgram& program, const PrimitivePlanes& planes);

// Shades the pixels in `coverage`; colour and depth/stencil of `tile` are updated in place.
void shade(const FragmentProgram& program, const PrimitivePlanes& planes, const Coverage& coverage,
           Tile& tile);

// The same for a multisampled target: coverage and a tile for each sample.
void shade_samples(const FragmentProgram& program, const PrimitivePlanes& planes,
                   const Coverage coverage[kSampleCount], Tile tiles[kSampleCount]);

}  // namespace clearpipe::pipeline
