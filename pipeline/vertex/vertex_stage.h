// What the vertex stages take and give: a list of element indices in, transformed vertex records
// out (2.8 to 2.12).
//
// Stages work on SoA batches inside; what leaves them is one record per vertex, because primitives
// are assembled, clipped and set up by vertex.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "pipeline/command.h"
#include "pipeline/state.h"

namespace clearpipe::pipeline {

// Offsets, in floats, of a vertex record. Texture coordinates (s,t,r,q) of the units in
// VertexState::texture_units follow kTexture in unit order, four floats each, then, with two-sided
// lighting, the back colour and, with user clip planes, eight clip distances (plane . eye
// position).
namespace vertex_record {
inline constexpr int kClip = 0;         // clip coordinates x, y, z, w (2.10)
inline constexpr int kWindow = 4;       // window x, y, z in [0,1], and 1/w_clip
inline constexpr int kOutcode = 8;      // bits of Outcode, as an integer
inline constexpr int kPointSize = 9;    // derived size before clamping to the supported range (3.3)
inline constexpr int kFog = 10;         // fog coordinate, |eye z| (3.8)
inline constexpr int kPointAlpha = 11;  // fade factor of a point smaller than the threshold, else 1
inline constexpr int kColour = 12;      // primary colour, clamped to [0,1] (2.12.8)
inline constexpr int kTexture = 16;
}  // namespace vertex_record

struct VertexLayout {
  uint8_t texture_units = 0;                      // bit u
  uint8_t texture_offset[kMaxTextureUnits] = {};  // floats from the record's start
  uint8_t back_colour_offset = 0;                 // 0: none
  uint8_t clip_distance_offset = 0;               // 0: none; else eight floats, one per user plane
  uint8_t stride = vertex_record::kTexture;       // floats per record, a multiple of 4
};

VertexLayout make_vertex_layout(const VertexState& state);

// Bit per Attribute that the vertex stages read in that state, but for the size of points.
uint32_t vertex_attributes(const VertexState& state);

// Which planes a vertex is outside of. User clip plane i is kOutcodeUser << i.
enum Outcode : uint32_t {
  kOutcodeLeft = 1u << 0,
  kOutcodeRight = 1u << 1,  // x < -w, x > w
  kOutcodeBottom = 1u << 2,
  kOutcodeTop = 1u << 3,
  kOutcodeNear = 1u << 4,
  kOutcodeFar = 1u << 5,
  kOutcodeGuard = 1u << 6,  // outside the guard band in x or y, or w <= 0
  kOutcodeUser = 1u << 8,
};

// The guard band in clip space: a vertex is inside when x_min * w <= x <= x_max * w, and so for y.
// It is the range of window coordinates that raster/edge.h can take.
struct GuardBand {
  float x_min = -1, x_max = 1, y_min = -1, y_max = 1;  // multiples of w
};

// The vertices of a job that follow each other with the same matrices.
struct VertexRun {
  const VertexState* matrices = nullptr;  // differs from the state of the job in these alone
  uint32_t count = 0;
};

struct VertexJob {
  const DrawCommand* draw = nullptr;  // attribute sources
  const VertexState* state = nullptr;
  Viewport viewport;
  GuardBand guard;
  VertexLayout layout;
  const uint32_t* elements = nullptr;  // element index of each vertex
  size_t count = 0;
  float* records = nullptr;  // out: count * layout.stride, 64-byte aligned
  // Together `count` vertices; null: all have the matrices of the state.
  const VertexRun* runs = nullptr;
};

// Runs every vertex stage on the job with the SIMD target in use.
void run_vertex_stages(const VertexJob& job);

// Window coordinates of one record from its clip coordinates, with the arithmetic of the stages
// (2.10.1); for vertices that clipping made.
void project_vertex(float* record, const Viewport& viewport);

}  // namespace clearpipe::pipeline
