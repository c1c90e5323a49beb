// Cube maps against the table and equations of OES_texture_cube_map (3.8.10) in double precision,
// through shade(): a tile whose pixels look into directions of all kinds. ctest runs it on each
// SIMD target. SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include "pipeline/fragment/own_tile.h"
#include "pipeline/fragment/program.h"

namespace clearpipe::pipeline {
namespace {

constexpr int kSize = 16;

struct Vec3 {
  double s, t, r;
};

// The row of the table: a face and what its minor and major coordinates are.
struct OnFace {
  int face;
  double sc, tc, ma;
};
OnFace on_face(int face, const Vec3& v) {
  switch (face) {
    case 0:
      return {0, -v.r, -v.t, v.s};
    case 1:
      return {1, +v.r, -v.t, v.s};
    case 2:
      return {2, +v.s, +v.r, v.t};
    case 3:
      return {3, +v.s, -v.r, v.t};
    case 4:
      return {4, +v.s, -v.t, v.r};
    default:
      return {5, -v.s, -v.t, v.r};
  }
}

int face_of(const Vec3& v) {
  const double s = std::abs(v.s), t = std::abs(v.t), r = std::abs(v.r);
  if (r >= s && r >= t) return v.r > 0 ? 4 : 5;
  if (t >= s) return v.t > 0 ? 2 : 3;
  return v.s > 0 ? 0 : 1;
}

// How far the largest coordinate is from the next.
double margin(const Vec3& v) {
  double sizes[3] = {std::abs(v.s), std::abs(v.t), std::abs(v.r)};
  std::sort(sizes, sizes + 3);
  return (sizes[2] - sizes[1]) / sizes[2];
}

double at(const Plane& p, double x, double y) { return p.value + p.dx * x + p.dy * y; }

class CubeTest : public testing::Test {
 protected:
  void SetUp() override {
    planes_.flat_colour = true;
    planes_.x_ref = 31.3f;
    planes_.y_ref = 15.7f;
    coverage_.last_row = kTileHeight;
    std::fill_n(coverage_.rows, kTileHeight, ~uint64_t{0});
    TextureUnit& unit = state_.unit[2];
    unit.enabled = true;
    unit.cube = true;
    unit.sampler.wrap_s = unit.sampler.wrap_t = Wrap::kClampToEdge;
    for (CombineArgument& a : unit.combiner.rgb_argument) a.source = CombineSource::kTexture2;
    for (CombineArgument& a : unit.combiner.alpha_argument) {
      a = {CombineSource::kTexture2, CombineOperand::kAlpha};
    }
  }

  // A plane for each of s, t, r, so that the tile spans much of a sphere.
  void look(std::mt19937& random, bool perspective) {
    std::uniform_real_distribution<float> value(-1, 1), slope(-0.04f, 0.04f);
    for (int c = 0; c < 3; ++c) {
      planes_.texture[2][c] = {value(random), slope(random), slope(random)};
    }
    planes_.texture[2][3] = {-2, 0, 0};  // q does not matter
    planes_.perspective = perspective;
    planes_.inv_w = {0.7f, 0.004f, -0.006f};
  }

  Vec3 direction(double column, double row) const {
    const double x = column + 0.5 - static_cast<double>(planes_.x_ref);
    const double y = row + 0.5 - static_cast<double>(planes_.y_ref);
    const double w = planes_.perspective ? 1 / at(planes_.inv_w, x, y) : 1;
    const Plane* p = planes_.texture[2];
    return {w * at(p[0], x, y), w * at(p[1], x, y), w * at(p[2], x, y)};
  }

  void shade_tile() {
    const std::unique_ptr<FragmentProgram, void (*)(FragmentProgram*)> program(
        make_fragment_program(state_, {false, false}, FragmentCoverage::kCentre),
        destroy_fragment_program);
    shade(*program, planes_, coverage_, *tile_);
  }

  uint32_t pixel(int column, int row) const { return tile_->colour[row * kTileWidth + column]; }

  FragmentState state_;
  PrimitivePlanes planes_;
  Coverage coverage_{};
  std::unique_ptr<OwnTile> tile_ = std::make_unique<OwnTile>();
};

// Every texel says its face and place.
TEST_F(CubeTest, FaceAndPlace) {
  auto image = std::make_shared<Image>();
  image->levels.resize(kCubeFaces * kMaxLevels);
  for (uint32_t face = 0; face < 6; ++face) {
    ImageLevel& level = image->levels[face * kMaxLevels];
    level = {kSize, kSize, Texels(kSize * kSize)};
    for (uint32_t i = 0; i < kSize * kSize; ++i) {
      level.texels[i] = face * 10 | i % kSize << 8 | i / kSize << 16;
    }
  }
  Sampler& sampler = state_.unit[2].sampler;
  sampler.min = sampler.mag = Filter::kNearest;
  sampler.mip = MipFilter::kNone;
  state_.unit[2].image = image;
  std::mt19937 random(11);
  int seen[6] = {}, compared = 0;
  for (int round = 0; round < 60; ++round) {
    look(random, round % 2 == 1);
    shade_tile();
    for (int row = 0; row < kTileHeight; ++row) {
      for (int column = 0; column < kTileWidth; ++column) {
        const Vec3 v = direction(column, row);
        if (margin(v) < 1e-4) continue;
        const OnFace f = on_face(face_of(v), v);
        const double s = (f.sc / std::abs(f.ma) + 1) / 2 * kSize;
        const double t = (f.tc / std::abs(f.ma) + 1) / 2 * kSize;
        if (std::abs(s - std::round(s)) < 1e-3 || std::abs(t - std::round(t)) < 1e-3) continue;
        const uint32_t expected = static_cast<uint32_t>(f.face * 10) |
                                  static_cast<uint32_t>(s) << 8 | static_cast<uint32_t>(t) << 16;
        ASSERT_EQ(pixel(column, row), expected) << round << " " << column << " " << row;
        ++seen[f.face];
        ++compared;
      }
    }
  }
  for (const int count : seen) EXPECT_GT(count, 1000);
  EXPECT_GT(compared, 100000);
}

// Level i is 16 i everywhere: a pixel shows its level of detail.
TEST_F(CubeTest, LevelOfDetail) {
  auto image = std::make_shared<Image>();
  image->levels.resize(kCubeFaces * kMaxLevels);
  constexpr int kLevels = 9;  // 256 to 1
  for (size_t face = 0; face < 6; ++face) {
    for (int i = 0; i < kLevels; ++i) {
      const int size = 256 >> i;
      ImageLevel& level = image->levels[face * kMaxLevels + static_cast<size_t>(i)];
      level = {size, size, Texels(static_cast<size_t>(size * size))};
      std::fill(level.texels.begin(), level.texels.end(), static_cast<uint32_t>(16 * i));
    }
  }
  Sampler& sampler = state_.unit[2].sampler;
  sampler.mag = sampler.min = Filter::kLinear;
  sampler.mip = MipFilter::kLinear;
  sampler.max_level = kLevels - 1;
  state_.unit[2].image = image;
  std::mt19937 random(12);
  double lowest = 8, highest = 0;
  for (int round = 0; round < 40; ++round) {
    look(random, round % 2 == 1);
    shade_tile();
    for (int row = 0; row < kTileHeight; ++row) {
      for (int column = 0; column < kTileWidth; ++column) {
        const Vec3 v = direction(column, row);
        if (margin(v) < 1e-4) continue;
        const int face = face_of(v);
        const OnFace f = on_face(face, v);
        // The length of the derivative of (s, t) along one axis, squared.
        const auto squared = [&](const Vec3& a, const Vec3& b) {
          const OnFace d = on_face(face, {b.s - a.s, b.t - a.t, b.r - a.r});
          const double ds = 0.5 * (d.sc - f.sc * d.ma / f.ma) / f.ma;
          const double dt = 0.5 * (d.tc - f.tc * d.ma / f.ma) / f.ma;
          return 256.0 * 256.0 * (ds * ds + dt * dt);
        };
        const int x = column & ~1, y = row & ~1;
        const double rho_squared =
            std::max(squared(direction(x, row), direction(x + 1, row)),
                     squared(direction(column, y), direction(column, y + 1)));
        // The logarithm is linear between powers of two.
        int exponent;
        const double mantissa = 2 * std::frexp(rho_squared, &exponent);
        const double lambda = std::clamp((exponent - 1 + mantissa - 1) / 2, 0.0, 8.0);
        ASSERT_NEAR(pixel(column, row) & 255, 16 * lambda, 0.7) << round << " " << column;
        lowest = std::min(lowest, lambda);
        highest = std::max(highest, lambda);
      }
    }
  }
  EXPECT_LT(lowest, 1);
  EXPECT_GT(highest, 6);
}

// Directions that are none sample something, and nothing outside of the image.
TEST_F(CubeTest, NoDirection) {
  auto image = std::make_shared<Image>();
  image->levels.resize(kCubeFaces * kMaxLevels);
  for (size_t face = 0; face < 6; ++face) {
    image->levels[face * kMaxLevels] = {1, 1, {0x01020304u}};
  }
  state_.unit[2].image = image;
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float value : {0.0f, infinity, -infinity, std::nanf(""), 1e38f, -1e-40f}) {
    for (const float other : {0.0f, infinity, std::nanf("")}) {
      planes_.texture[2][0] = {value, 0, 0};
      planes_.texture[2][1] = {other, 0, 0};
      planes_.texture[2][2] = {value, value, other};
      shade_tile();
      EXPECT_EQ(pixel(3, 3), 0x01020304u);
    }
  }
}

}  // namespace
}  // namespace clearpipe::pipeline
