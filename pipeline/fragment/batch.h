// The batch of fragments that the chain's stages work on, one after another, in structure-of-arrays
// form, every array a whole number of vectors. Its size is no power of two, or the arrays would lie
// in the same sets of the cache.
//
// Colours are signed 16-bit fixed point with 13 fraction bits (kColourOne is 1.0), so intermediate
// results of combiners keep a range of [-4, 4). The conversion from and to 8 bits is exact.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "pipeline/fragment/program.h"
#include "pipeline/raster/samples.h"
#include "pipeline/state.h"

namespace clearpipe::pipeline {

inline constexpr int kBatchSize = 448;

// An 8-bit colour component as the nearest fixed-point value.
constexpr int16_t colour_from_unorm8(int v) {
  return static_cast<int16_t>((v << 5) + ((v + 4) >> 3));
}

struct FragmentBatch {
  int count = 0;  // fragments in use; the rest of the last vector holds harmless copies

  alignas(64) float x[kBatchSize];  // pixel centre minus PrimitivePlanes::x_ref
  alignas(64) float y[kBatchSize];
  alignas(64) float w[kBatchSize];  // w_clip: 1 / interpolated 1/w; 1 without perspective
  // Texture coordinates s, t of the unit being sampled, already divided by q and w, and the same at
  // the three corners of the fragment's 2x2 quad that give the level of detail (3.7.7).
  alignas(64) float s[kBatchSize], t[kBatchSize];
  // Of a cube map, the face that (s, t) lies on: 0 to 5, times kFaceKey (sample.h). Else not used.
  alignas(64) int32_t face[kBatchSize];
  alignas(64) float lod[kBatchSize];  // log2 of the scale factor rho, before bias and clamping
  // With anisotropic filtering: the longer derivative of (s, t), and the number of samples on it.
  alignas(64) float along_s[kBatchSize], along_t[kBatchSize], probes[kBatchSize];

  alignas(64) int16_t live[kBatchSize];  // -1: the fragment lives; 0: discarded
  // The coverage of a fragment on a multisampled target, as far as its samples live (4.1.10).
  alignas(64) int16_t sample_live[kSampleCount][kBatchSize];
  alignas(64) int16_t coverage[kBatchSize];               // of antialiased points and lines
  alignas(64) uint16_t offset[kBatchSize];                // index into the tile's planes
  alignas(64) uint32_t stored_depth_stencil[kBatchSize];  // gathered from the tile
  alignas(64) uint32_t stored_colour[kBatchSize];
  alignas(64) uint32_t colour[kBatchSize];  // the fragment's final colour, RGBA8

  alignas(64) int16_t primary[4][kBatchSize];
  alignas(64) int16_t previous[4][kBatchSize];  // result of the last texture unit; then the colour
  alignas(64) int16_t texture[kMaxTextureUnits][4][kBatchSize];
};

}  // namespace clearpipe::pipeline
