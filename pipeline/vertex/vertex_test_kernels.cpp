// The vertex stage functions compiled for every target the compiler knows, scalar included.
// SPDX-License-Identifier: MIT
#define HWY_IS_TEST 1
#include "pipeline/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/vertex/vertex_test_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "pipeline/vertex/fetch-inl.h"
#include "pipeline/vertex/lighting-inl.h"
#include "pipeline/vertex/math-inl.h"
#include "pipeline/vertex/palette-inl.h"
#include "pipeline/vertex/point-inl.h"
#include "pipeline/vertex/project-inl.h"
#include "pipeline/vertex/texcoord-inl.h"
#include "pipeline/vertex/texgen-inl.h"
#include "pipeline/vertex/transform-inl.h"
#include "pipeline/vertex/vertex_test_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::vertex::HWY_NAMESPACE {
namespace {

void fetch_all(const AttributeSource& source, const uint32_t* elements, size_t count, Lane* out) {
  fill_constant_lanes(source, out);
  if (reads_array(source)) {
    fetch_array(source, elements, count, out);
  }
}

void log2_all(const float* x, size_t count, float* out) {
  const FloatTag d;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    hn::StoreU(log2(d, hn::LoadU(d, x + i)), d, out + i);
  }
}

void exp2_all(const float* x, size_t count, float* out) {
  const FloatTag d;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    hn::StoreU(exp2(d, hn::LoadU(d, x + i)), d, out + i);
  }
}

void power_all(const float* x, const float* y, size_t count, float* out) {
  const FloatTag d;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    hn::StoreU(power(d, hn::LoadU(d, x + i), hn::LoadU(d, y + i)), d, out + i);
  }
}

void position_all(const Mat4& matrix, const Lane* in, size_t count, Lane* out) {
  transform_position(matrix, in, count, out);
}
void normal_all(const VertexState& state, const Lane* in, size_t count, Lane* out) {
  transform_normal(state, in, count, out);
}
DrawCommand skinned(int units) {
  DrawCommand draw;
  draw.attributes[static_cast<size_t>(Attribute::kMatrixIndex)].size = static_cast<uint8_t>(units);
  return draw;
}
void skin_position_all(const VertexState& state, int units, VertexBatch& batch, size_t count) {
  skin_position(*state.palette, palette_inputs(skinned(units), batch), batch.attribute[0], count,
                batch.eye);
}
void skin_normal_all(const VertexState& state, int units, VertexBatch& batch, size_t count) {
  skin_normal(state, palette_inputs(skinned(units), batch), batch.attribute[1], count,
              batch.normal);
}
void reflection_all(const Lane* eye, const Lane* normal, size_t count, Lane* out) {
  reflection_vector(eye, normal, count, out);
}
void texture_all(const VertexState& state, VertexBatch& batch, size_t count) {
  transform_texture_coordinates(state, batch, count);
}
void clip_all(const Lane* clip, const GuardBand& guard, size_t count, float* outcode) {
  test_clip_volume(clip, guard, count, outcode);
}
void user_all(const VertexState& state, const Lane* eye, size_t count, Lane* distance,
              float* outcode) {
  test_user_planes(state, eye, count, distance, outcode);
}
void project_all(const Lane* clip, const Viewport& viewport, size_t count, Lane* window) {
  project_to_window(clip, viewport, count, window);
}
void light_all(const VertexState& state, const Lane* eye, const Lane* normals, const Lane* current,
               size_t count, Lane* colour, Lane* back_colour) {
  light_vertices(state, eye, normals, current, count, colour, back_colour);
}
void clamp_all(const Lane* in, size_t count, Lane* out) { clamp_colour(in, count, out); }
void point_all(const VertexState& state, const float* requested, const Lane* eye, size_t count,
               float* derived, float* fade) {
  derive_point_size(state, requested, eye, count, derived, fade);
}
void fog_all(const float* eye_z, size_t count, float* fog) { fog_coordinate(eye_z, count, fog); }

const VertexTestKernels* test_kernels() {
  static constexpr VertexTestKernels kKernels = {
      &fetch_all,      &position_all, &normal_all, &skin_position_all, &skin_normal_all,
      &reflection_all, &texture_all,  &clip_all,   &user_all,          &project_all,
      &light_all,      &clamp_all,    &point_all,  &fog_all,           &log2_all,
      &exp2_all,       &power_all};
  return &kKernels;
}

}  // namespace
}  // namespace clearpipe::pipeline::vertex::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace clearpipe::pipeline {

namespace vertex {
HWY_EXPORT(test_kernels);
}  // namespace vertex

int for_each_target(
    const std::function<void(const VertexTestKernels& kernels, const char* name)>& body) {
  using namespace vertex;
  int count = 0;
  // The static target needs no support from the processor beyond what the program needs anyway.
  const int64_t supported = (hwy::SupportedTargets() & HWY_TARGETS) | HWY_STATIC_TARGET;
  for (int64_t left = supported; left != 0; left &= left - 1) {
    const int64_t target = left & -left;
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(target);
    body(*HWY_DYNAMIC_DISPATCH(test_kernels)(), hwy::TargetName(target));
    ++count;
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().DeInit();
  return count;
}

}  // namespace clearpipe::pipeline
#endif  // HWY_ONCE
