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

void SetupTriangles(const SetupState& state, const LaneJob& job) {
  constexpr size_t kLanes = hn::MaxLanes(TagI());
  for (size_t i = 0; i < job.count; i += kLanes) {
    fetch_ahead(state, job, 2, i + 2 * kLanes);
    setup_triangle_lanes(state, job, i);
  }
}

void SetupLines(const SetupState& state, const LaneJob& job) {
  constexpr size_t kLanes = hn::MaxLanes(TagI());
  for (size_t i = 0; i < job.count; i += kLanes) {
    fetch_ahead(state, job, 1, i + 2 * kLanes);
    setup_line_lanes(state, job, i);
  }
}

}  // namespace clearpipe::pipeline::setup::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace clearpipe::pipeline {
namespace setup {

HWY_EXPORT(SetupTriangles);
HWY_EXPORT(SetupLines);

using SetupFunction = void (*)(const SetupState&, const LaneJob&);

static void choose_target() { select_simd_target(); }

static SetupFunction resolve_triangles() {
  choose_target();
  return static_cast<SetupFunction>(HWY_DYNAMIC_DISPATCH(SetupTriangles));
}

static SetupFunction resolve_lines() {
  choose_target();
  return static_cast<SetupFunction>(HWY_DYNAMIC_DISPATCH(SetupLines));
}

}  // namespace setup

void setup_triangles(const SetupState& state, const LaneJob& job) {
  static const setup::SetupFunction function = setup::resolve_triangles();
  function(state, job);
}

void setup_lines(const SetupState& state, const LaneJob& job) {
  static const setup::SetupFunction function = setup::resolve_lines();
  function(state, job);
}

}  // namespace clearpipe::pipeline
#endif  // HWY_ONCE
