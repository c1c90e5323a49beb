// Setup of many primitives at once, on every SIMD target: see lanes.h.
// SPDX-License-Identifier: MIT
#include "pipeline/setup/lanes.h"

#include <hwy/cache_control.h>

#include "pipeline/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/setup/lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "pipeline/setup/line_lanes-inl.h"
#include "pipeline/setup/point_lanes-inl.h"
#include "pipeline/setup/triangle_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::setup::HWY_NAMESPACE {

// The last vertices of the primitives from i on: a large draw's are not in the nearest cache any
// more, and most others were those of a primitive before.
HWY_INLINE void fetch_ahead(const SetupState& state, const LaneJob& job, int corner, size_t i) {
  const size_t end = std::min(i + hn::Lanes(TagI()), job.count);
  const float* const window = job.records + vertex_record::kWindow;
  for (; i < end; ++i) {
    hwy::Prefetch(window + static_cast<ptrdiff_t>(job.corner[corner][i]) * state.layout.stride);
  }
}

template <int kCorners>
void setup_lanes(const SetupState& state, const LaneJob& job) {
  constexpr size_t kLanes = hn::MaxLanes(TagI());
  for (size_t i = 0; i < job.count; i += kLanes) {
    fetch_ahead(state, job, kCorners - 1, i + 2 * kLanes);
    if constexpr (kCorners == 1) setup_point_lanes(state, job, i);
    if constexpr (kCorners == 2) setup_line_lanes(state, job, i);
    if constexpr (kCorners == 3) setup_triangle_lanes(state, job, i);
  }
}

const LaneKernels* kernels() {
  static constexpr LaneKernels kKernels = {&setup_lanes<1>, &setup_lanes<2>, &setup_lanes<3>};
  return &kKernels;
}

}  // namespace clearpipe::pipeline::setup::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace clearpipe::pipeline {
namespace setup {

HWY_EXPORT(kernels);

static const LaneKernels& resolve() {
  static const LaneKernels& resolved = []() -> const LaneKernels& {
    select_simd_target();
    return *HWY_DYNAMIC_DISPATCH(kernels)();
  }();
  return resolved;
}

}  // namespace setup

void setup_lanes(PrimitiveKind kind, const SetupState& state, const LaneJob& job) {
  setup::resolve()[static_cast<size_t>(kind)](state, job);
}

}  // namespace clearpipe::pipeline
#endif  // HWY_ONCE
