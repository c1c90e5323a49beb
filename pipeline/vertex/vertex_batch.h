// A batch of vertices in SoA form, and the plan that says which stages a job needs.
//
// One batch is what the vertex stages hand each other: an array of floats per component, small
// enough that all of it stays in the first-level cache. The plan is decided once per job, so that a
// stage does no work nobody reads (2.8 to 2.12).
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "pipeline/state.h"
#include "pipeline/vertex/vertex_stage.h"

namespace clearpipe::pipeline {

// Vertices per batch: a multiple of every vector length in use.
inline constexpr size_t kVertexBatch = 64;

using Lane = float[kVertexBatch];

struct alignas(64) VertexBatch {
  Lane attribute[kAttributeCount][4];  // as fetched (2.8); no later stage writes here
  Lane clip[4];                        // clip coordinates
  Lane eye[4];                         // eye coordinates; only z when the plan says so
  Lane normal[3];                      // in eye coordinates, as lighting uses it
  Lane colour[4];                      // primary colour, in [0,1]
  Lane back_colour[4];
  Lane window[4];                     // x, y, z, 1/w
  Lane reflection[3];                 // reflection vector, for generated coordinates
  Lane generated[4];                  // coordinates of one unit, before the texture matrix
  Lane texture[kMaxTextureUnits][4];  // coordinates as generated, or after the texture matrix
  Lane clip_distance[kMaxClipPlanes];
  // Stored as one group of four per vertex, in the order of the record.
  Lane outcode;  // bits of Outcode in the bits of the float
  Lane point_size;
  Lane fog;
  Lane point_alpha;
};

struct VertexPlan {
  uint32_t attributes = 0;  // bit per Attribute that some stage reads
  bool eye_position = false;
  bool eye_z = false;  // only the eye z coordinate is needed
  bool normal = false;
  bool points = false;  // the primitive is a point, so its size matters
};

VertexPlan make_vertex_plan(const DrawCommand& draw, const VertexState& state);

// The kernels of one SIMD target.
struct VertexKernels {
  void (*run)(const VertexJob& job, const VertexPlan& plan);
};

// The table of the best target that is enabled now; run_vertex_stages asks once, tests ask again
// after they changed the set of targets.
const VertexKernels& current_vertex_kernels();

}  // namespace clearpipe::pipeline
