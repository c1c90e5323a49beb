// Setup of many triangles at once, a triangle a lane: facing, culling, and the mask of those that
// are small (small.h). Most triangles of a mesh are done with here; what is left is for
// setup_triangle, which comes to the same result by the same arithmetic.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "pipeline/setup/small.h"

namespace clearpipe::pipeline {

enum class TriangleFate : uint8_t {
  kNothing,     // culled, outside of a clip plane as a whole, or without a pixel
  kSmallFront,  // a small primitive that faces the viewer
  kSmallBack,   // one that does not
  kGeneral,     // crosses a clip plane, or is not small, or its box is cut by the bounds
};

// The most that are done at once.
inline constexpr size_t kTriangleLanes = 16;

// Up to kCount triangles of a draw, with room for the lanes behind the last.
template <size_t kCount>
struct TriangleSet {
  static constexpr size_t kPadded = kCount + kTriangleLanes;

  alignas(64) std::array<int32_t, kPadded> corner[3]{};  // numbers of vertex records
  // Filled by setup_triangles; the mask and its place for small ones only.
  alignas(64) std::array<int32_t, kPadded> fate, x, y;
  alignas(64) std::array<uint32_t, kPadded> mask_low, mask_high;
};

struct TriangleJob {
  const float* records = nullptr;  // vertex records in state.layout
  const int32_t* corner[3] = {};
  size_t count = 0;
  // Out.
  int32_t* fate = nullptr;
  int32_t *x = nullptr, *y = nullptr;
  uint32_t *mask_low = nullptr, *mask_high = nullptr;
};

// Runs the job with the SIMD target in use. Lanes behind the last triangle are written, too, and
// the corners there must be numbers of vertices.
void setup_triangles(const SetupState& state, const TriangleJob& job);

}  // namespace clearpipe::pipeline
