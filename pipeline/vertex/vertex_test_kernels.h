// The vertex stage functions of one SIMD target, for tests.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>

#include "pipeline/vertex/vertex_batch.h"

namespace clearpipe::pipeline {

struct VertexTestKernels {
  void (*fetch)(const AttributeSource& source, const uint32_t* elements, size_t count, Lane* out);
  void (*transform_position)(const Mat4& matrix, const Lane* in, size_t count, Lane* out);
  void (*transform_normal)(const VertexState& state, const Lane* in, size_t count, Lane* out);
  // With so many vertex units, the palette of the state.
  void (*skin_position)(const VertexState& state, int units, VertexBatch& batch, size_t count);
  void (*skin_normal)(const VertexState& state, int units, VertexBatch& batch, size_t count);
  void (*reflection_vector)(const Lane* eye, const Lane* normal, size_t count, Lane* out);
  void (*transform_texture)(const VertexState& state, VertexBatch& batch, size_t count);
  void (*test_clip_volume)(const Lane* clip, const GuardBand& guard, size_t count, float* outcode);
  void (*test_user_planes)(const VertexState& state, const Lane* eye, size_t count, Lane* distance,
                           float* outcode);
  void (*project)(const Lane* clip, const Viewport& viewport, size_t count, Lane* window);
  void (*light)(const VertexState& state, const Lane* eye, const Lane* normals, const Lane* current,
                size_t count, Lane* colour, Lane* back_colour);
  void (*clamp_colour)(const Lane* in, size_t count, Lane* out);
  void (*point_size)(const VertexState& state, const float* requested, const Lane* eye,
                     size_t count, float* derived, float* fade);
  void (*fog)(const float* eye_z, size_t count, float* fog);
  void (*log2)(const float* x, size_t count, float* out);
  void (*exp2)(const float* x, size_t count, float* out);
  void (*power)(const float* x, const float* y, size_t count, float* out);
};

// Calls `body(kernels, name)` once per target this processor has;
// while it runs, every kernel table of the program resolves to that target. Returns how many ran.
int for_each_target(
    const std::function<void(const VertexTestKernels& kernels, const char* name)>& body);

}  // namespace clearpipe::pipeline
