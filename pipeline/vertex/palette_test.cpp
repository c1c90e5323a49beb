// Skinned positions and normals against the sums of OES_matrix_palette in double precision.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "pipeline/vertex/vertex_test_kernels.h"

namespace clearpipe::pipeline {
namespace {

struct Skin {
  std::mt19937 random;
  MatrixPalette palette;
  VertexState state;
  std::unique_ptr<VertexBatch> batch = std::make_unique<VertexBatch>();

  explicit Skin(unsigned seed) : random(seed) {
    state.palette = &palette;
    for (float& value : palette.matrix) value = number(-2, 2);
    for (float& value : palette.normal_matrix) value = number(-2, 2);
    for (int c = 0; c < 4; ++c) {
      for (size_t i = 0; i < kVertexBatch; ++i) {
        batch->attribute[0][c][i] = number(-10, 10);
        batch->attribute[1][c][i] = number(-1, 1);
        index()[c][i] = static_cast<float>(random() % 256);  // any byte
        if (i % 4 != 0) index()[c][i] = static_cast<float>(random() % kPaletteMatrices);
        weight()[c][i] = number(-1, 1);
      }
    }
  }
  float number(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  }
  Lane* index() { return batch->attribute[static_cast<int>(Attribute::kMatrixIndex)]; }
  Lane* weight() { return batch->attribute[static_cast<int>(Attribute::kWeight)]; }
  // Which matrix a unit picks; what is not in the palette counts as its last.
  size_t picked(int unit, size_t i) {
    return static_cast<size_t>(std::min(index()[unit][i], float{kPaletteMatrices - 1}));
  }
};

TEST(VertexPalette, PositionsAreWeightedSums) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    Skin skin(seed);
    for (int units = 1; units <= kVertexUnits; ++units) {
      for_each_target([&](const VertexTestKernels& kernels, const char* name) {
        kernels.skin_position(skin.state, units, *skin.batch, kVertexBatch);
        for (size_t i = 0; i < kVertexBatch; ++i) {
          for (size_t row = 0; row < 4; ++row) {
            double exact = 0;
            float rounded = 0;
            for (int unit = 0; unit < units; ++unit) {
              const float* m = skin.palette.matrix.data() + 16 * skin.picked(unit, i);
              const float weight = skin.weight()[unit][i];
              float product = 0;
              for (size_t c = 0; c < 4; ++c) {
                const float v = skin.batch->attribute[0][c][i];
                exact += double{weight} * double{m[4 * c + row]} * double{v};
                product = c == 0 ? m[row] * v : product + m[4 * c + row] * v;
              }
              rounded = unit == 0 ? weight * product : rounded + weight * product;
            }
            ASSERT_NEAR(skin.batch->eye[row][i], exact, 1e-4) << name << " units " << units;
            ASSERT_EQ(skin.batch->eye[row][i], rounded) << name << " units " << units;
          }
        }
      });
    }
  }
}

TEST(VertexPalette, NormalsAreTransformedByTheSumOfInverses) {
  for (unsigned mode = 0; mode < 4; ++mode) {
    Skin skin(mode);
    skin.state.rescale_normal = (mode & 1) != 0;
    skin.state.normalize = (mode & 2) != 0;
    skin.state.rescale = 99;  // of the modelview matrix, which does not count
    for (int unit = 0; unit < kVertexUnits; ++unit) skin.weight()[unit][7] = 0;  // no matrix at all
    for (int units = 1; units <= kVertexUnits; ++units) {
      for_each_target([&](const VertexTestKernels& kernels, const char* name) {
        kernels.skin_normal(skin.state, units, *skin.batch, kVertexBatch);
        for (size_t i = 0; i < kVertexBatch; ++i) {
          double m[9] = {}, n[3] = {};
          for (int unit = 0; unit < units; ++unit) {
            const float* picked = skin.palette.normal_matrix.data() + 9 * skin.picked(unit, i);
            for (int k = 0; k < 9; ++k) m[k] += double{skin.weight()[unit][i]} * double{picked[k]};
          }
          for (int row = 0; row < 3; ++row) {
            for (int c = 0; c < 3; ++c) {
              n[row] += m[3 * c + row] * double{skin.batch->attribute[1][c][i]};
            }
          }
          const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
          const double third = std::sqrt(m[6] * m[6] + m[7] * m[7] + m[8] * m[8]);
          double scale = 1;
          if (skin.state.normalize) {
            scale = length > 0 ? 1 / length : 0;
          } else if (skin.state.rescale_normal) {
            scale = third > 1e-6 ? 1 / third : 1;
          }
          for (int row = 0; row < 3; ++row) {
            const double expected = n[row] * scale;
            ASSERT_NEAR(skin.batch->normal[row][i], expected, 1e-5 * std::max(1.0, scale))
                << name << " mode " << mode << " units " << units << " vertex " << i;
          }
        }
      });
    }
  }
}

}  // namespace
}  // namespace clearpipe::pipeline
