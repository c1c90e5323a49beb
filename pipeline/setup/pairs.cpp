// Pairs of small triangles: see pairs.h.
// SPDX-License-Identifier: MIT
#include "pipeline/setup/pairs.h"

#include <cstring>

namespace clearpipe::pipeline {

namespace {

template <size_t kCount>
bool are_same(const float* a, const float* b, int offset) {
  return std::memcmp(a + offset, b + offset, kCount * sizeof(float)) == 0;
}

// Whether two vertices have the same of all that planes are made of but their places.
bool interpolate_alike(const SetupState& state, const float* a, const float* b) {
  constexpr int kDepthAndW = vertex_record::kWindow + 2;
  return are_same<2>(a, b, kDepthAndW) && are_same<4>(a, b, vertex_record::kColour) &&
         (!state.two_sided || are_same<4>(a, b, state.layout.back_colour_offset)) &&
         (!state.inputs.fog || are_same<1>(a, b, vertex_record::kFog));
}

bool interpolate_alike(const SetupState& state, const LaneJob& job, size_t i) {
  const auto record = [&](int corner, size_t of) {
    return job.records + ptrdiff_t{job.corner[corner][of]} * state.layout.stride;
  };
  const float* const first = record(0, i);
  for (int k = 1; k < 3; ++k) {
    if (!interpolate_alike(state, first, record(k, i))) return false;
  }
  for (int k = 0; k < 3; ++k) {
    const int32_t corner = job.corner[k][i + 1];
    const bool shared =
        corner == job.corner[0][i] || corner == job.corner[1][i] || corner == job.corner[2][i];
    if (!shared && !interpolate_alike(state, first, record(k, i + 1))) return false;
  }
  return true;
}

bool are_apart(const LaneJob& job, size_t i) {
  uint32_t common = 0;
  for (int s = 0; s < kSquaresOfLane; ++s) {
    common |= (job.mask_low[s][i] & job.mask_low[s][i + 1]) |
              (job.mask_high[s][i] & job.mask_high[s][i + 1]);
  }
  return common == 0;
}

bool is_pair(const SetupState& state, const LaneJob& job, size_t i) {
  const auto fate = static_cast<LaneFate>(job.fate[i]);
  return (fate == LaneFate::kSmall || fate == LaneFate::kSmallOther) &&
         job.fate[i + 1] == job.fate[i] && job.x[i + 1] == job.x[i] && job.y[i + 1] == job.y[i] &&
         interpolate_alike(state, job, i) && are_apart(job, i);
}

}  // namespace

void merge_pairs(const SetupState& state, const LaneJob& job) {
  constexpr size_t kTried = 16;  // without a pair
  size_t tried = 0;
  for (size_t i = 0; i + 1 < job.count && tried < kTried; ++i, ++tried) {
    if (!is_pair(state, job, i)) continue;
    for (int s = 0; s < kSquaresOfLane; ++s) {
      job.mask_low[s][i] |= job.mask_low[s][i + 1];
      job.mask_high[s][i] |= job.mask_high[s][i + 1];
    }
    job.more[i] |= job.more[i + 1];
    job.fate[i + 1] = static_cast<int32_t>(LaneFate::kNothing);
    ++i;
    tried = 0;
  }
}

}  // namespace clearpipe::pipeline
