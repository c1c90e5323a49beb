// Whole vertex jobs: the layout of records, and results that depend neither on the SIMD target nor
// on a vertex's place in the job.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <random>
#include <vector>

#include "pipeline/vertex/vertex_test_kernels.h"

namespace clearpipe::pipeline {
namespace {

// A draw with every attribute in arrays of random floats, and a state that uses all of them.
class Job {
 public:
  Job(uint32_t seed, size_t elements, Primitive primitive) : random_(seed) {
    draw_.primitive = primitive;
    for (int a = 0; a < kAttributeCount; ++a) {
      data_[a].resize(elements * 4);
      for (float& value : data_[a]) value = number(-2, 2);
      AttributeSource& source = draw_.attributes[a];
      source.is_array = true;
      source.stride = 16;
      source.max_index = static_cast<uint32_t>(elements - 1);
      source.pointer = reinterpret_cast<const std::byte*>(data_[a].data());
    }
    for (float& value : state_.model_view_projection.m) value = number(-1, 1);
    state_.model_view_projection.m[15] = 4;
    for (float& value : state_.model_view.m) value = number(-1, 1);
    state_.model_view.m[15] = 3;
    state_.fog = state_.lighting = state_.two_sided = state_.normalize = true;
    state_.colour_material = true;
    state_.material.shininess = 17;
    state_.material.specular = {0.5f, 0.5f, 0.5f, 1};
    for (int i = 0; i < kMaxLights; ++i) {
      Light& light = state_.lights[i];
      light.enabled = light.positional = true;
      light.spot = i % 2 == 1;
      light.attenuated = i % 3 == 1;
      light.attenuation[1] = 0.25f;
      light.position = {number(-4, 4), number(-4, 4), number(1, 4), 1};
      light.diffuse = light.specular = {0.2f, 0.1f, 0.15f, 1};
      light.spot_direction = {0, 0, -1, 0};
      light.spot_exponent = 3.5f;
      light.spot_cutoff_cos = 0.3f;
    }
    state_.texture_units = 0xad;
    state_.texture_matrix = 0x2c;
    for (Mat4& matrix : state_.texture_matrices) {
      for (float& value : matrix.m) value = number(-1, 1);
    }
    state_.clip_planes = 0x81;
    state_.clip_plane[0] = {1, 0.5f, 0.25f, 1};
    state_.clip_plane[7] = {-1, 0.5f, 0.25f, 1};
    state_.point_attenuated = true;
    state_.point_attenuation[1] = 0.5f;
  }

  float number(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random_);
  }

  const DrawCommand& draw() const { return draw_; }
  VertexState& state() { return state_; }
  VertexLayout layout() const { return make_vertex_layout(state_); }

  std::vector<float> run(const std::vector<uint32_t>& elements) {
    VertexJob job;
    job.draw = &draw_;
    job.state = &state_;
    job.viewport = {320, -240, 0.5f, 320, 240, 0.5f};
    job.guard = {-20, 20, -20, 20};
    job.layout = layout();
    job.elements = elements.data();
    job.count = elements.size();
    // One record more than asked for, to see that nothing is written there.
    const size_t floats = (elements.size() + 1) * job.layout.stride;
    const size_t bytes = (floats * sizeof(float) + 63) / 64 * 64;
    const std::unique_ptr<float, decltype(&std::free)> records(
        static_cast<float*>(std::aligned_alloc(64, bytes)), &std::free);
    std::fill_n(records.get(), floats, -77.0f);
    job.records = records.get();
    current_vertex_kernels().run(job, make_vertex_plan(draw_, state_));
    for (size_t i = floats - job.layout.stride; i < floats; ++i) {
      EXPECT_EQ(records.get()[i], -77.0f);
    }
    return {records.get(), records.get() + floats - job.layout.stride};
  }

 private:
  std::mt19937 random_;
  DrawCommand draw_;
  VertexState state_;
  std::vector<float> data_[kAttributeCount];
};

TEST(VertexRecord, LayoutHasRoomForWhatTheStateAsksFor) {
  VertexState state;
  EXPECT_EQ(make_vertex_layout(state).stride, vertex_record::kTexture);
  state.texture_units = 0x81;
  state.clip_planes = 2;
  state.two_sided = true;
  VertexLayout layout = make_vertex_layout(state);
  EXPECT_EQ(layout.texture_offset[0], 16);
  EXPECT_EQ(layout.texture_offset[7], 20);
  EXPECT_EQ(layout.back_colour_offset, 0);
  EXPECT_EQ(layout.clip_distance_offset, 24);
  EXPECT_EQ(layout.stride, 32);
  state.lighting = true;
  layout = make_vertex_layout(state);
  EXPECT_EQ(layout.back_colour_offset, 24);
  EXPECT_EQ(layout.clip_distance_offset, 28);
  EXPECT_EQ(layout.stride, 36);
}

TEST(VertexRecord, SameBitsOnEveryTargetAtEveryPlaceInTheJob) {
  for (Primitive primitive : {Primitive::kTriangles, Primitive::kPoints}) {
    Job job(51, 300, primitive);
    std::vector<uint32_t> elements;
    for (uint32_t i = 0; i < 201; ++i) elements.push_back(i * 7 % 300);
    const size_t stride = job.layout().stride;
    std::vector<float> first;
    int targets = for_each_target([&](const VertexTestKernels&, const char* name) {
      const std::vector<float> records = job.run(elements);
      if (first.empty()) first = records;
      ASSERT_EQ(std::memcmp(first.data(), records.data(), first.size() * sizeof(float)), 0) << name;
      // Any vertex alone, or at the end of a short job, gives the record it had among the others.
      for (size_t i : {0, 1, 63, 64, 100, 200}) {
        const std::vector<float> alone = job.run({elements[i]});
        EXPECT_EQ(std::memcmp(alone.data(), &first[i * stride], stride * sizeof(float)), 0) << name;
        const std::vector<float> third = job.run({5, 6, elements[i]});
        EXPECT_EQ(std::memcmp(&third[2 * stride], &first[i * stride], stride * sizeof(float)), 0)
            << name;
      }
    });
    EXPECT_GE(targets, 2);
  }
}

TEST(VertexRecord, FieldsStandWhereTheLayoutSays) {
  Job job(52, 10, Primitive::kTriangles);
  VertexState& state = job.state();
  state.lighting = false;
  const VertexLayout layout = job.layout();
  const auto record = job.run({3});
  const auto* position = reinterpret_cast<const float*>(job.draw().attributes[0].pointer) + 12;
  double eye[4] = {};
  for (int row = 0; row < 4; ++row) {
    double clip = 0;
    for (int c = 0; c < 4; ++c) {
      clip += static_cast<double>(state.model_view_projection.m[4 * c + row]) * position[c];
      eye[row] += static_cast<double>(state.model_view.m[4 * c + row]) * position[c];
    }
    EXPECT_NEAR(record[vertex_record::kClip + row], clip, 1e-5);
  }
  EXPECT_NEAR(record[vertex_record::kFog], std::abs(eye[2]), 1e-5);
  EXPECT_EQ(record[vertex_record::kPointSize], 1.0f);
  EXPECT_EQ(record[vertex_record::kPointAlpha], 1.0f);
  const auto* colour = reinterpret_cast<const float*>(job.draw().attributes[2].pointer) + 12;
  for (int c = 0; c < 4; ++c) {
    EXPECT_EQ(record[vertex_record::kColour + c], std::min(std::max(colour[c], 0.0f), 1.0f));
  }
  // Unit 0 has no texture matrix, unit 2 has one.
  const auto* s0 = reinterpret_cast<const float*>(job.draw().attributes[4].pointer) + 12;
  const auto* s2 = reinterpret_cast<const float*>(job.draw().attributes[6].pointer) + 12;
  for (int row = 0; row < 4; ++row) {
    double transformed = 0;
    for (int c = 0; c < 4; ++c) {
      transformed += static_cast<double>(state.texture_matrices[2].m[4 * c + row]) * s2[c];
    }
    EXPECT_EQ(record[layout.texture_offset[0] + row], s0[row]);
    EXPECT_NEAR(record[layout.texture_offset[2] + row], transformed, 1e-5);
  }
  const Vec4& plane = state.clip_plane[7];
  EXPECT_NEAR(record[layout.clip_distance_offset + 7],
              plane.x * eye[0] + plane.y * eye[1] + plane.z * eye[2] + plane.w * eye[3], 1e-5);
  EXPECT_EQ(record[layout.clip_distance_offset + 1], 0.0f);
}

TEST(VertexRecord, PointSizeComesFromTheArrayOrTheState) {
  Job job(53, 10, Primitive::kPoints);
  VertexState& state = job.state();
  state.point_attenuated = false;
  state.point_size = 5;
  const auto* sizes = reinterpret_cast<const float*>(job.draw().attributes[3].pointer);
  EXPECT_EQ(job.run({4})[vertex_record::kPointSize], std::max(sizes[16], 0.0f));
  const_cast<DrawCommand&>(job.draw()).attributes[3].is_array = false;
  EXPECT_EQ(job.run({4})[vertex_record::kPointSize], 5.0f);
}

}  // namespace
}  // namespace clearpipe::pipeline
