// The lighting equation in double precision against the stage, for random lights and materials
// (2.12.1, equations 2.2 to 2.5), and the same bits on every target.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <random>

#include "pipeline/vertex/vertex_test_kernels.h"

namespace clearpipe::pipeline {
namespace {

using Double3 = std::array<double, 3>;

double dot(const Double3& a, const Double3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Double3 unit(const Double3& v) {
  const double length = std::sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

Double3 three(const Vec4& v) { return {v.x, v.y, v.z}; }

class Scene {
 public:
  explicit Scene(uint32_t seed) : random_(seed) {}

  float number(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random_);
  }
  bool coin() { return (random_() & 1) != 0; }
  Vec4 colour(float high) {
    return {number(0, high), number(0, high), number(0, high), number(0, 1)};
  }

  Vec4 direction() {
    const Double3 v = unit({number(-1, 1), number(-1, 1), number(-1, 1)});
    return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]), 0};
  }

  Light light() {
    Light result;
    result.enabled = random_() % 3 != 0;
    result.positional = coin();
    result.spot = coin();
    result.ambient = colour(0.1f);
    result.diffuse = colour(0.4f);
    result.specular = colour(0.4f);
    if (result.positional) {
      result.position = {number(-5, 5), number(-5, 5), number(2, 5), number(0.5f, 2)};
      result.attenuated = coin();
      if (result.attenuated) {
        result.attenuation[0] = number(0.2f, 1);
        result.attenuation[1] = number(0, 0.3f);
        result.attenuation[2] = number(0, 0.1f);
      }
    } else {
      result.position = direction();
      const Double3 h = unit({result.position.x, result.position.y, result.position.z + 1.0});
      result.half_vector = {static_cast<float>(h[0]), static_cast<float>(h[1]),
                            static_cast<float>(h[2]), 0};
    }
    if (result.spot) {
      result.spot_direction = direction();
      result.spot_exponent = coin() ? number(0, 128) : 0;
      result.spot_cutoff_cos = number(0, 1);
    }
    return result;
  }

  VertexState state() {
    VertexState result;
    result.lighting = true;
    result.two_sided = coin();
    result.colour_material = coin();
    result.scene_ambient = colour(0.2f);
    result.material = {colour(1), colour(1), colour(1), colour(0.2f), coin() ? number(0, 128) : 0};
    for (Light& l : result.lights) l = light();
    return result;
  }

  void vertices(VertexBatch& batch) {
    for (size_t i = 0; i < kVertexBatch; ++i) {
      const Vec4 n = direction();
      const float normal[3] = {n.x, n.y, n.z};
      for (int c = 0; c < 3; ++c) {
        batch.eye[c][i] = number(-3, 3);
        batch.normal[c][i] = normal[c];
      }
      batch.eye[3][i] = number(0.5f, 2);
      for (int c = 0; c < 4; ++c) batch.attribute[2][c][i] = number(0, 1);
    }
  }

 private:
  std::mt19937 random_;
};

// The equation for one vertex. `margin` shrinks to how near the cone's edge, a discontinuity, is.
std::array<double, 4> light_vertex(const VertexState& state, const VertexBatch& batch, size_t i,
                                   double side, double& margin) {
  Double3 acm = three(state.material.ambient), dcm = three(state.material.diffuse);
  double alpha = state.material.diffuse.w;
  if (state.colour_material) {
    for (int c = 0; c < 3; ++c) acm[c] = dcm[c] = batch.attribute[2][c][i];
    alpha = batch.attribute[2][3][i];
  }
  const Double3 scm = three(state.material.specular), ecm = three(state.material.emission);
  const Double3 n = {side * batch.normal[0][i], side * batch.normal[1][i],
                     side * batch.normal[2][i]};
  Double3 sum;
  for (int c = 0; c < 3; ++c) sum[c] = ecm[c] + acm[c] * three(state.scene_ambient)[c];
  for (const Light& light : state.lights) {
    if (!light.enabled) continue;
    Double3 vp = three(light.position);
    double att = 1;
    if (light.positional) {
      for (int c = 0; c < 3; ++c) {
        vp[c] = vp[c] / light.position.w - static_cast<double>(batch.eye[c][i]) / batch.eye[3][i];
      }
      const double d = std::sqrt(dot(vp, vp));
      att = 1 / (light.attenuation[0] + light.attenuation[1] * d + light.attenuation[2] * d * d);
    }
    vp = unit(vp);
    const Double3 h = unit({vp[0], vp[1], vp[2] + 1});
    double spot = 1;
    if (light.spot) {
      const double cosine = std::max(-dot(vp, three(light.spot_direction)), 0.0);
      margin = std::min(margin, std::abs(cosine - light.spot_cutoff_cos));
      spot = cosine >= light.spot_cutoff_cos ? std::pow(cosine, light.spot_exponent) : 0;
    }
    const double n_dot_l = std::max(dot(n, vp), 0.0);
    const double f = n_dot_l != 0 ? 1 : 0;
    margin = std::min(margin, std::abs(dot(n, vp)));
    const double shine = f * std::pow(std::max(dot(n, h), 0.0), state.material.shininess);
    for (int c = 0; c < 3; ++c) {
      sum[c] += att * spot *
                (acm[c] * three(light.ambient)[c] + n_dot_l * dcm[c] * three(light.diffuse)[c] +
                 shine * scm[c] * three(light.specular)[c]);
    }
  }
  std::array<double, 4> result = {sum[0], sum[1], sum[2], alpha};
  for (double& c : result) c = std::clamp(c, 0.0, 1.0);
  return result;
}

TEST(VertexLighting, FollowsTheEquationOnEveryTargetWithTheSameBits) {
  Scene scene(41);
  int compared = 0;
  for (int round = 0; round < 200; ++round) {
    const auto batch = std::make_unique<VertexBatch>();
    const VertexState state = scene.state();
    scene.vertices(*batch);
    alignas(64) Lane first[8] = {};
    bool have_first = false;
    for_each_target([&](const VertexTestKernels& kernels, const char* name) {
      std::memset(batch->back_colour, 0, sizeof(batch->back_colour));
      kernels.light(state, batch->eye, batch->normal, batch->attribute[2], kVertexBatch,
                    batch->colour, batch->back_colour);
      if (!have_first) {
        have_first = true;
        std::memcpy(first, batch->colour, sizeof(batch->colour));
        std::memcpy(first + 4, batch->back_colour, sizeof(batch->back_colour));
      }
      EXPECT_EQ(std::memcmp(first, batch->colour, sizeof(batch->colour)), 0) << name;
      EXPECT_EQ(std::memcmp(first + 4, batch->back_colour, sizeof(batch->back_colour)), 0) << name;
      for (size_t i = 0; i < kVertexBatch; ++i) {
        for (int side = 0; side < (state.two_sided ? 2 : 1); ++side) {
          double margin = 1;
          const auto expected = light_vertex(state, *batch, i, side == 0 ? 1 : -1, margin);
          if (margin < 1e-5) continue;
          const Lane* colour = side == 0 ? batch->colour : batch->back_colour;
          for (int c = 0; c < 4; ++c) {
            ASSERT_NEAR(colour[c][i], expected[c], 1e-4) << name << " round " << round;
          }
          ++compared;
        }
      }
    });
  }
  EXPECT_GT(compared, 20000);
}

TEST(VertexLighting, ColoursWithoutLightingAreClamped) {
  const auto batch = std::make_unique<VertexBatch>();
  const float values[] = {-1, 0.25f, 2, std::numeric_limits<float>::quiet_NaN()};
  const float expected[] = {0, 0.25f, 1, 0};
  for (size_t i = 0; i < kVertexBatch; ++i) {
    for (Lane& lane : batch->attribute[2]) lane[i] = values[i % 4];
  }
  for_each_target([&](const VertexTestKernels& kernels, const char* name) {
    kernels.clamp_colour(batch->attribute[2], kVertexBatch, batch->colour);
    for (size_t i = 0; i < kVertexBatch; ++i) {
      for (const Lane& lane : batch->colour) ASSERT_EQ(lane[i], expected[i % 4]) << name;
    }
  });
}

TEST(VertexLighting, ALightAtTheVertexItselfStaysFinite) {
  const auto batch = std::make_unique<VertexBatch>();
  VertexState state;
  state.lighting = true;
  state.lights[0].enabled = state.lights[0].positional = state.lights[0].attenuated = true;
  state.lights[0].position = {0, 0, 0, 1};
  state.lights[0].attenuation[0] = 0;
  state.lights[0].attenuation[2] = 1;
  state.lights[0].diffuse = {1, 1, 1, 1};
  state.material.diffuse = {1, 1, 1, 0.5f};
  std::memset(batch.get(), 0, sizeof(VertexBatch));
  for (float& w : batch->eye[3]) w = 1;
  for (float& z : batch->normal[2]) z = 1;
  for_each_target([&](const VertexTestKernels& kernels, const char* name) {
    kernels.light(state, batch->eye, batch->normal, batch->attribute[2], kVertexBatch,
                  batch->colour, batch->back_colour);
    for (int c = 0; c < 3; ++c) {
      EXPECT_GE(batch->colour[c][0], 0.0f) << name;
      EXPECT_LE(batch->colour[c][0], 1.0f) << name;
    }
    EXPECT_EQ(batch->colour[3][0], 0.5f) << name;
  });
}

}  // namespace
}  // namespace clearpipe::pipeline
