// Setup of many triangles at once, on every SIMD target: see triangles.h.
// SPDX-License-Identifier: MIT
#include "pipeline/setup/triangles.h"

#include "pipeline/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/setup/triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "pipeline/setup/triangles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::setup::HWY_NAMESPACE {

void SetupTriangles(const SetupState& state, const TriangleJob& job) {
  for (size_t i = 0; i < job.count; i += hn::Lanes(TagI())) setup_lanes(state, job, i);
}

}  // namespace clearpipe::pipeline::setup::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace clearpipe::pipeline {
namespace setup {

HWY_EXPORT(SetupTriangles);

using SetupTrianglesFunction = void (*)(const SetupState&, const TriangleJob&);

static SetupTrianglesFunction resolve() {
  select_simd_target();
  return static_cast<SetupTrianglesFunction>(HWY_DYNAMIC_DISPATCH(SetupTriangles));
}

}  // namespace setup

void setup_triangles(const SetupState& state, const TriangleJob& job) {
  static const setup::SetupTrianglesFunction function = setup::resolve();
  function(state, job);
}

}  // namespace clearpipe::pipeline
#endif  // HWY_ONCE
