// Setup of many primitives at once, one in each lane of a vector: of triangles facing and culling,
// of all kinds the masks of those that are small (small.h), or that are as four small ones. Most
// primitives of a mesh are done with here; what is left is for setup_triangle, setup_line and
// setup_point, which come to the same result by the same arithmetic.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "pipeline/setup/small.h"

namespace clearpipe::pipeline {

enum class LaneFate : uint8_t {
  kNothing,       // culled, outside of a clip plane as a whole, or without a pixel
  kSmall,         // small primitives: a triangle that faces the viewer, a line along x, a point
  kSmallOther,    // the same: a triangle that faces away, a line along y
  kGeneral,       // crosses a clip plane, or is not small, or its box is cut by the bounds
  kSnapped,       // a line along x that is not small, or cut by the bounds: its corners are known
  kSnappedOther,  // and of one along y
};

// The most that are done at once.
inline constexpr size_t kSetupLanes = 16;

// A primitive is settled here if its box is at most so many squares of small primitives wide and
// high; square s is column s % 2 and row s / 2 of them.
inline constexpr int kLaneSquares = 2;
inline constexpr int kSquaresOfLane = kLaneSquares * kLaneSquares;

// Up to kCount primitives, with room for the lanes behind the last.
template <size_t kCount>
struct LaneSet {
  static constexpr size_t kPadded = kCount + kSetupLanes;

  alignas(64) std::array<int32_t, kPadded> corner[3]{};  // numbers of vertex records
  // Filled by setup; the place of the first square, whether others than that are covered, and the
  // masks for small ones only.
  alignas(64) std::array<int32_t, kPadded> fate, x, y, more;
  alignas(64) std::array<uint32_t, kPadded> mask_low[kSquaresOfLane], mask_high[kSquaresOfLane];
  alignas(64) std::array<int32_t, kPadded> snapped_x[4], snapped_y[4];  // of lines: their corners

  uint64_t mask(size_t i, int square) const {
    return static_cast<uint64_t>(mask_high[square][i]) << 32 | mask_low[square][i];
  }
};

struct LaneJob {
  const float* records = nullptr;  // vertex records in state.layout
  const int32_t* corner[3] = {};
  size_t count = 0;
  bool corners_alone = false;  // of lines: none is settled as a small primitive
  // Out.
  int32_t* fate = nullptr;
  int32_t *x = nullptr, *y = nullptr, *more = nullptr;
  uint32_t *mask_low[kSquaresOfLane] = {}, *mask_high[kSquaresOfLane] = {};
  int32_t *snapped_x[4] = {}, *snapped_y[4] = {};
};

// The job of `count` primitives from `first` on.
template <size_t kCount>
LaneJob lane_job(const float* records, LaneSet<kCount>& set, size_t first, size_t count) {
  LaneJob job;
  job.records = records;
  for (int k = 0; k < 3; ++k) job.corner[k] = set.corner[k].data() + first;
  job.count = count;
  job.fate = set.fate.data() + first;
  job.x = set.x.data() + first;
  job.y = set.y.data() + first;
  job.more = set.more.data() + first;
  for (int s = 0; s < kSquaresOfLane; ++s) {
    job.mask_low[s] = set.mask_low[s].data() + first;
    job.mask_high[s] = set.mask_high[s].data() + first;
  }
  for (int k = 0; k < 4; ++k) {
    job.snapped_x[k] = set.snapped_x[k].data() + first;
    job.snapped_y[k] = set.snapped_y[k].data() + first;
  }
  return job;
}

// The setup of each kind of primitive, by PrimitiveKind, on one SIMD target.
using LaneKernels = std::array<void (*)(const SetupState&, const LaneJob&), 3>;

// Runs the job with the SIMD target in use. Corners are read, and results written, of up to
// kSetupLanes primitives behind the last, too. Points and lines are those whose pixels are decided
// by their centres.
void setup_lanes(PrimitiveKind kind, const SetupState& state, const LaneJob& job);

}  // namespace clearpipe::pipeline
