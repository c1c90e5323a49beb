// Positions, normals, clip tests, the viewport, points and fog against their equations (2.10, 2.11,
// 3.3, 3.8).
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <random>

#include "pipeline/vertex/vertex_test_kernels.h"

namespace clearpipe::pipeline {
namespace {

constexpr double kUlp = 1.0 / (1 << 23);

class Numbers {
 public:
  explicit Numbers(uint32_t seed) : random_(seed) {}
  float operator()(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random_);
  }
  void fill(Lane* lanes, int count, float low, float high) {
    for (int c = 0; c < count; ++c) {
      for (float& value : lanes[c]) value = (*this)(low, high);
    }
  }
  Mat4 matrix() {
    Mat4 result;
    for (float& value : result.m) value = (*this)(-2, 2);
    return result;
  }

 private:
  std::mt19937 random_;
};

uint32_t bits_of(float value) {
  uint32_t bits;
  std::memcpy(&bits, &value, 4);
  return bits;
}

TEST(VertexTransform, PositionSumsFromLeftToRight) {
  Numbers numbers(31);
  for (int round = 0; round < 50; ++round) {
    const auto batch = std::make_unique<VertexBatch>();
    Lane* in = batch->attribute[0];
    numbers.fill(in, 4, -10, 10);
    const Mat4 matrix = numbers.matrix();
    for_each_target([&](const VertexTestKernels& kernels, const char* name) {
      kernels.transform_position(matrix, in, kVertexBatch, batch->clip);
      for (size_t i = 0; i < kVertexBatch; ++i) {
        for (int row = 0; row < 4; ++row) {
          float sum = matrix.m[row] * in[0][i];
          double exact = static_cast<double>(matrix.m[row]) * in[0][i];
          double magnitude = std::abs(exact);
          for (int c = 1; c < 4; ++c) {
            sum = sum + matrix.m[4 * c + row] * in[c][i];
            const double term = static_cast<double>(matrix.m[4 * c + row]) * in[c][i];
            exact += term;
            magnitude += std::abs(term);
          }
          ASSERT_EQ(bits_of(batch->clip[row][i]), bits_of(sum)) << name;
          ASSERT_NEAR(batch->clip[row][i], exact, 4 * kUlp * magnitude) << name;
        }
      }
    });
  }
}

TEST(VertexTransform, TextureMatrixOfTheUnitsThatHaveOne) {
  Numbers numbers(32);
  const auto batch = std::make_unique<VertexBatch>();
  for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
    numbers.fill(batch->attribute[4 + unit], 4, -3, 3);
  }
  VertexState state;
  state.texture_units = 0x0b;
  state.texture_matrix = 0x06;
  for (Mat4& matrix : state.texture_matrices) matrix = numbers.matrix();
  for_each_target([&](const VertexTestKernels& kernels, const char* name) {
    std::memset(batch->texture, 0, sizeof(batch->texture));
    kernels.transform_texture(state, *batch, kVertexBatch);
    for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
      for (int row = 0; row < 4; ++row) {
        double exact = 0;
        for (int c = 0; c < 4 && unit == 1; ++c) {
          exact += static_cast<double>(state.texture_matrices[unit].m[4 * c + row]) *
                   batch->attribute[4 + unit][c][17];
        }
        ASSERT_NEAR(batch->texture[unit][row][17], exact, 1e-5) << name << " unit " << unit;
      }
    }
  });
}

// u - 2 n (n . u), for vertices on both sides of w = 0.
TEST(VertexTransform, ReflectionVectors) {
  Numbers numbers(37);
  const auto batch = std::make_unique<VertexBatch>();
  numbers.fill(batch->eye, 4, -5, 5);
  numbers.fill(batch->normal, 3, -1, 1);
  for (int c = 0; c < 3; ++c) batch->eye[c][7] = 0;
  for_each_target([&](const VertexTestKernels& kernels, const char* name) {
    kernels.reflection_vector(batch->eye, batch->normal, kVertexBatch, batch->reflection);
    for (size_t i = 0; i < kVertexBatch; ++i) {
      double u[3], length = 0, n_dot_u = 0;
      for (int c = 0; c < 3; ++c) {
        u[c] = static_cast<double>(batch->eye[c][i]) / batch->eye[3][i];
        length += u[c] * u[c];
      }
      for (int c = 0; c < 3; ++c) {
        if (length > 0) u[c] /= std::sqrt(length);
        n_dot_u += u[c] * batch->normal[c][i];
      }
      for (int c = 0; c < 3; ++c) {
        const double exact = u[c] - 2 * batch->normal[c][i] * n_dot_u;
        ASSERT_NEAR(batch->reflection[c][i], exact, 1e-6) << name << " " << i;
      }
    }
  });
}

// s, t and r are the vector, q is what was given; the texture matrix comes after it.
TEST(VertexTransform, GeneratedCoordinates) {
  Numbers numbers(38);
  const auto batch = std::make_unique<VertexBatch>();
  for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
    numbers.fill(batch->attribute[4 + unit], 4, -3, 3);
  }
  numbers.fill(batch->normal, 3, -1, 1);
  numbers.fill(batch->reflection, 3, -1, 1);
  VertexState state;
  state.texture_units = 0x1f;
  state.reflection_map = 0x06;
  state.normal_map = 0x18;
  state.texture_matrix = 0x0c;
  for (Mat4& matrix : state.texture_matrices) matrix = numbers.matrix();
  for_each_target([&](const VertexTestKernels& kernels, const char* name) {
    std::memset(batch->texture, 0, sizeof(batch->texture));
    kernels.transform_texture(state, *batch, kVertexBatch);
    for (int unit = 1; unit < 5; ++unit) {
      const Lane* source = unit < 3 ? batch->reflection : batch->normal;
      const bool has_matrix = unit == 2 || unit == 3;
      for (int row = 0; row < 4; ++row) {
        const Lane* q = batch->attribute[4 + unit] + 3;
        double exact = row < 3 ? source[row][9] : (*q)[9];
        if (has_matrix) {
          exact = static_cast<double>(state.texture_matrices[unit].m[12 + row]) * (*q)[9];
          for (int c = 0; c < 3; ++c) {
            exact +=
                static_cast<double>(state.texture_matrices[unit].m[4 * c + row]) * source[c][9];
          }
        }
        ASSERT_NEAR(batch->texture[unit][row][9], exact, 1e-5) << name << " unit " << unit;
      }
    }
  });
}

TEST(VertexTransform, NormalsAreRescaledOrMadeUnitLength) {
  Numbers numbers(33);
  for (int mode = 0; mode < 4; ++mode) {
    const auto batch = std::make_unique<VertexBatch>();
    Lane* in = batch->attribute[1];
    numbers.fill(in, 3, -1, 1);
    for (int c = 0; c < 3; ++c) in[c][5] = 0;
    VertexState state;
    for (float& value : state.normal_matrix) value = numbers(-2, 2);
    state.rescale = 0.37f;
    state.rescale_normal = (mode & 1) != 0;
    state.normalize = (mode & 2) != 0;
    for_each_target([&](const VertexTestKernels& kernels, const char* name) {
      kernels.transform_normal(state, in, kVertexBatch, batch->normal);
      for (size_t i = 0; i < kVertexBatch; ++i) {
        double n[3], square = 0;
        for (int row = 0; row < 3; ++row) {
          n[row] = 0;
          for (int c = 0; c < 3; ++c) {
            n[row] += static_cast<double>(state.normal_matrix[3 * c + row]) * in[c][i];
          }
          if (mode == 1) n[row] *= state.rescale;
          square += n[row] * n[row];
        }
        const double length = state.normalize && square > 0 ? std::sqrt(square) : 1;
        for (int row = 0; row < 3; ++row) {
          // Where terms cancel, a short vector keeps the error of the long ones it is made of.
          ASSERT_NEAR(batch->normal[row][i], n[row] / length, 3e-6 / std::min(length, 1.0))
              << name << " mode " << mode;
        }
      }
    });
  }
}

uint32_t expected_outcode(const float p[4], const GuardBand& g) {
  uint32_t code = 0;
  const float w = p[3];
  if (!(p[0] >= -w)) code |= kOutcodeLeft;
  if (!(p[0] <= w)) code |= kOutcodeRight;
  if (!(p[1] >= -w)) code |= kOutcodeBottom;
  if (!(p[1] <= w)) code |= kOutcodeTop;
  if (!(p[2] >= -w)) code |= kOutcodeNear;
  if (!(p[2] <= w)) code |= kOutcodeFar;
  const bool finite =
      std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]) && std::isfinite(p[3]);
  if (!finite || !(w > 0) || p[0] < g.x_min * w || p[0] > g.x_max * w || p[1] < g.y_min * w ||
      p[1] > g.y_max * w) {
    code |= kOutcodeGuard;
  }
  return code;
}

TEST(VertexClip, OutcodesOfTheVolumeAndTheGuardBand) {
  Numbers numbers(34);
  const float special[] = {0,
                           -0.0f,
                           1,
                           -1,
                           std::numeric_limits<float>::infinity(),
                           -std::numeric_limits<float>::infinity(),
                           std::numeric_limits<float>::quiet_NaN(),
                           3e38f,
                           1e-40f,
                           8};
  GuardBand guard{-4, 6, -3, 5};
  for (int round = 0; round < 100; ++round) {
    const auto batch = std::make_unique<VertexBatch>();
    numbers.fill(batch->clip, 4, -8, 8);
    for (size_t i = 0; i < kVertexBatch; i += 2) {
      batch->clip[3][i] = std::abs(batch->clip[3][i]);
      if (round >= 50) {
        for (Lane& lane : batch->clip) lane[i] = special[static_cast<int>(numbers(0, 9.99f))];
      }
    }
    for_each_target([&](const VertexTestKernels& kernels, const char* name) {
      kernels.test_clip_volume(batch->clip, guard, kVertexBatch, batch->outcode);
      for (size_t i = 0; i < kVertexBatch; ++i) {
        const float p[4] = {batch->clip[0][i], batch->clip[1][i], batch->clip[2][i],
                            batch->clip[3][i]};
        ASSERT_EQ(bits_of(batch->outcode[i]), expected_outcode(p, guard))
            << name << " " << p[0] << " " << p[1] << " " << p[2] << " " << p[3];
      }
    });
  }
}

TEST(VertexClip, UserPlanesGiveDistancesAndBits) {
  Numbers numbers(35);
  const auto batch = std::make_unique<VertexBatch>();
  numbers.fill(batch->eye, 4, -5, 5);
  VertexState state;
  state.clip_planes = 0xa5;
  for (Vec4& plane : state.clip_plane) {
    plane = {numbers(-1, 1), numbers(-1, 1), numbers(-1, 1), numbers(-1, 1)};
  }
  for_each_target([&](const VertexTestKernels& kernels, const char* name) {
    for (float& code : batch->outcode) {
      const uint32_t before = kOutcodeNear;
      std::memcpy(&code, &before, 4);
    }
    kernels.test_user_planes(state, batch->eye, kVertexBatch, batch->clip_distance, batch->outcode);
    for (size_t i = 0; i < kVertexBatch; ++i) {
      uint32_t expected = kOutcodeNear;
      for (int plane = 0; plane < kMaxClipPlanes; ++plane) {
        if ((state.clip_planes >> plane & 1) == 0) continue;
        const Vec4& p = state.clip_plane[plane];
        const double distance = static_cast<double>(p.x) * batch->eye[0][i] +
                                static_cast<double>(p.y) * batch->eye[1][i] +
                                static_cast<double>(p.z) * batch->eye[2][i] +
                                static_cast<double>(p.w) * batch->eye[3][i];
        ASSERT_NEAR(batch->clip_distance[plane][i], distance, 1e-5) << name;
        if (distance < 0) expected |= static_cast<uint32_t>(kOutcodeUser) << plane;
      }
      ASSERT_EQ(bits_of(batch->outcode[i]), expected) << name;
    }
  });
}

TEST(VertexViewport, ScaleAndTranslationRoundOnce) {
  Numbers numbers(36);
  for (int round = 0; round < 200; ++round) {
    const auto batch = std::make_unique<VertexBatch>();
    numbers.fill(batch->clip, 3, -4, 4);
    numbers.fill(batch->clip + 3, 1, 0.1f, 9);
    const Viewport viewport{numbers(1, 2000), numbers(-2000, -1), numbers(0, 0.5f),
                            numbers(0, 2000), numbers(0, 2000),   0.5f};
    for_each_target([&](const VertexTestKernels& kernels, const char* name) {
      kernels.project(batch->clip, viewport, kVertexBatch, batch->window);
      for (size_t i = 0; i < kVertexBatch; ++i) {
        const float r = 1.0f / batch->clip[3][i];
        ASSERT_EQ(batch->window[3][i], r) << name;
        const float scale[3] = {viewport.scale_x, viewport.scale_y, viewport.scale_z};
        const float centre[3] = {viewport.centre_x, viewport.centre_y, viewport.centre_z};
        for (int axis = 0; axis < 3; ++axis) {
          const float device = batch->clip[axis][i] * r;
          ASSERT_EQ(bits_of(batch->window[axis][i]),
                    bits_of(std::fma(device, scale[axis], centre[axis])))
              << name;
        }
      }
    });
  }
}

TEST(VertexViewport, ClippedVerticesAreProjectedToTheSamePlaceWithinAnUlp) {
  float record[vertex_record::kTexture] = {1.5f, -0.5f, 0.25f, 2.0f};
  const Viewport viewport{100, 50, 0.5f, 110, 60, 0.5f};
  project_vertex(record, viewport);
  EXPECT_FLOAT_EQ(record[4], 0.75f * 100 + 110);
  EXPECT_FLOAT_EQ(record[5], -0.25f * 50 + 60);
  EXPECT_FLOAT_EQ(record[6], 0.125f * 0.5f + 0.5f);
  EXPECT_EQ(record[7], 0.5f);
}

TEST(VertexPoint, SizeIsAttenuatedClampedAndFaded) {
  Numbers numbers(37);
  for (int attenuated = 0; attenuated < 2; ++attenuated) {
    const auto batch = std::make_unique<VertexBatch>();
    numbers.fill(batch->eye, 4, -6, 6);
    alignas(64) Lane requested;
    for (float& value : requested) value = numbers(0, 40);
    VertexState state;
    state.point_size_min = 2;
    state.point_size_max = 25;
    state.point_fade_threshold = 6;
    state.point_attenuated = attenuated != 0;
    state.point_attenuation[0] = 0.3f;
    state.point_attenuation[1] = 0.1f;
    state.point_attenuation[2] = 0.2f;
    for_each_target([&](const VertexTestKernels& kernels, const char* name) {
      kernels.point_size(state, requested, batch->eye, kVertexBatch, batch->point_size,
                         batch->point_alpha);
      kernels.fog(batch->eye[2], kVertexBatch, batch->fog);
      for (size_t i = 0; i < kVertexBatch; ++i) {
        const double d =
            std::sqrt(std::pow(batch->eye[0][i], 2.0) + std::pow(batch->eye[1][i], 2.0) +
                      std::pow(batch->eye[2][i], 2.0));
        double size = requested[i];
        if (attenuated != 0) size /= std::sqrt(0.3 + 0.1 * d + 0.2 * d * d);
        size = std::min(std::max(size, 2.0), 25.0);
        const double fade = size < 6 ? size / 6 * size / 6 : 1;
        ASSERT_NEAR(batch->point_size[i], size, 1e-5 * size) << name;
        ASSERT_NEAR(batch->point_alpha[i], fade, 1e-5) << name;
        ASSERT_EQ(batch->fog[i], std::abs(batch->eye[2][i])) << name;
      }
    });
  }
}

}  // namespace
}  // namespace clearpipe::pipeline
