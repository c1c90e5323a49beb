// Multisampled fragments (4.1.3, 4.1.10): what happens to a sample must be what happens to a pixel
// of a target without samples, whose stages shade_test.cpp holds against their equations. ctest
// runs it on each SIMD target. SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <random>

#include "pipeline/fragment/own_tile.h"
#include "pipeline/fragment/program.h"

namespace clearpipe::pipeline {
namespace {

using Program = std::unique_ptr<FragmentProgram, void (*)(FragmentProgram*)>;

Program make_program(const FragmentState& state, bool multisampled, FragmentCoverage coverage) {
  return {make_fragment_program(state, {true, true, multisampled}, coverage),
          destroy_fragment_program};
}

struct Bench {
  FragmentState state;
  PrimitivePlanes planes;
  std::array<OwnTile, kSampleCount> tiles;
  std::array<Coverage, kSampleCount> coverage;
  FragmentCoverage kind = FragmentCoverage::kMultisample;

  Bench() {
    planes.flat_colour = true;
    for (Coverage& sample : coverage) {
      std::fill(std::begin(sample.rows), std::end(sample.rows), ~uint64_t{0});
      sample.first_row = 0;
      sample.last_row = kTileHeight;
    }
  }

  void set_colour(double r, double g, double b, double a) {
    const double c[4] = {r, g, b, a};
    for (int i = 0; i < 4; ++i) planes.colour[i] = {static_cast<float>(c[i]) * kColourOne, 0, 0};
  }

  void run() {
    std::array<Tile, kSampleCount> views;
    std::copy(tiles.begin(), tiles.end(), views.begin());
    shade_samples(*make_program(state, true, kind), planes, coverage.data(), views.data());
  }

  // Which samples of a pixel were written, one bit each, where the tiles were zero.
  int written(int x, int y) const {
    int samples = 0;
    for (int s = 0; s < kSampleCount; ++s) {
      if (tiles[s].colour[y * kTileWidth + x] != 0) samples |= 1 << s;
    }
    return samples;
  }
};

FragmentState random_state(std::mt19937& random) {
  const auto one_of = [&](int count) { return static_cast<int>(random() % count); };
  FragmentState state;
  state.alpha_test = one_of(3) == 0;
  state.alpha_func = static_cast<CompareFunc>(one_of(8));
  state.alpha_reference = static_cast<float>(one_of(256)) / 255;
  StencilState& stencil = state.stencil;
  stencil.enabled = one_of(2) == 0;
  stencil.func = static_cast<CompareFunc>(one_of(8));
  stencil.reference = static_cast<uint8_t>(random());
  stencil.value_mask = static_cast<uint8_t>(random());
  stencil.write_mask = static_cast<uint8_t>(random());
  stencil.fail = static_cast<StencilOp>(one_of(8));
  stencil.depth_fail = static_cast<StencilOp>(one_of(8));
  stencil.pass = static_cast<StencilOp>(one_of(8));
  state.depth_test = one_of(2) == 0;
  state.depth_write = one_of(3) != 0;
  state.depth_func = static_cast<CompareFunc>(one_of(8));
  state.blend.enabled = one_of(2) == 0;
  state.blend.src_rgb = static_cast<BlendFactor>(one_of(11));
  state.blend.dst_rgb = static_cast<BlendFactor>(one_of(10));
  state.blend.src_alpha = static_cast<BlendFactor>(one_of(11));
  state.blend.dst_alpha = static_cast<BlendFactor>(one_of(10));
  state.blend.rgb = state.blend.alpha = static_cast<BlendEquation>(one_of(5));
  state.logic_op_enabled = one_of(4) == 0;
  state.logic_op = static_cast<LogicOp>(one_of(16));
  if (one_of(3) == 0) state.colour_mask = static_cast<uint8_t>(one_of(16));
  return state;
}

// Rows of all kinds, and samples without any.
void make_random(std::mt19937& random, Coverage& coverage) {
  coverage.first_row = static_cast<int>(random() % kTileHeight);
  coverage.last_row = coverage.first_row + static_cast<int>(random() % 12);
  coverage.last_row = std::min(coverage.last_row, kTileHeight);
  for (int row = 0; row < kTileHeight; ++row) {
    const uint64_t bits = uint64_t{random()} << 32 | random();
    coverage.rows[row] = random() % 3 == 0 ? bits : random() % 2 == 0 ? ~uint64_t{0} : bits & ~bits;
  }
}

TEST(Multisample, SamplesAreTreatedAsPixelsAre) {
  std::mt19937 random(21);
  for (int round = 0; round < 3000; ++round) {
    Bench bench;
    bench.state = random_state(random);
    const float change = round % 2 == 0 ? 0 : 0.01f;
    bench.planes.flat_colour = change == 0;
    for (Plane& plane : bench.planes.colour) {
      plane = {static_cast<float>(random() & 255) / 255 * kColourOne, change * kColourOne,
               -change * kColourOne};
    }
    // Multiples of 8 steps of depth, so that the places of the samples are whole numbers of them.
    constexpr float kStep = 8.0f / 16777216;
    bench.planes.depth = {0.5f, 512 * kStep, -256 * kStep};
    bench.planes.x_ref = 0.5f;
    bench.planes.y_ref = 0.5f;
    for (Coverage& sample : bench.coverage) make_random(random, sample);
    for (Tile& tile : bench.tiles) {
      for (int i = 0; i < kTileWidth * kTileHeight; ++i) {
        tile.colour[i] = random();
        const int x = i % kTileWidth, y = i / kTileWidth;
        const uint32_t depth = 8388608u + (512u * x - 256u * y) * 8u + random() % 3 - 1;
        tile.depth_stencil[i] = depth << 8 | (random() & 255);
      }
    }
    const bool apart = round % 3 != 0;
    bench.kind = apart ? FragmentCoverage::kMultisample : FragmentCoverage::kCentre;

    std::array<OwnTile, kSampleCount> expected = bench.tiles;
    const Program pixel_program = make_program(bench.state, false, FragmentCoverage::kCentre);
    for (int s = 0; s < kSampleCount; ++s) {
      PrimitivePlanes planes = bench.planes;
      if (apart) {
        planes.depth.value += (static_cast<float>(kSamplePlaces[s].x) * planes.depth.dx +
                               static_cast<float>(kSamplePlaces[s].y) * planes.depth.dy) /
                              256;
      }
      shade(*pixel_program, planes, bench.coverage[s], expected[s]);
    }
    bench.run();
    for (int s = 0; s < kSampleCount; ++s) {
      for (int i = 0; i < kTileWidth * kTileHeight; ++i) {
        ASSERT_EQ(bench.tiles[s].colour[i], expected[s].colour[i]) << round << " sample " << s;
        ASSERT_EQ(bench.tiles[s].depth_stencil[i], expected[s].depth_stencil[i])
            << round << " sample " << s;
      }
    }
  }
}

TEST(Multisample, DepthIsFoundAtTheSample) {
  std::mt19937 random(22);
  std::uniform_real_distribution<float> slope(-0.01f, 0.01f), place(0, 64);
  for (int round = 0; round < 100; ++round) {
    for (const bool late : {false, true}) {
      Bench bench;
      bench.state.depth_test = true;
      bench.state.depth_func = CompareFunc::kAlways;
      bench.state.alpha_test = late;
      bench.planes.x_ref = place(random);
      bench.planes.y_ref = place(random);
      bench.planes.depth = {0.5f, slope(random) / 2, slope(random) / 2};
      const Plane& depth = bench.planes.depth;
      bench.run();
      for (int s = 0; s < kSampleCount; ++s) {
        for (int i = 0; i < kTileWidth * kTileHeight; ++i) {
          const double x = i % kTileWidth + 0.5 + kSamplePlaces[s].x / 256.0 - bench.planes.x_ref;
          const double y = i / kTileWidth + 0.5 + kSamplePlaces[s].y / 256.0 - bench.planes.y_ref;
          const double z = double{depth.value} + double{depth.dx} * x + double{depth.dy} * y;
          ASSERT_NEAR(bench.tiles[s].depth_stencil[i] >> 8, std::clamp(z, 0.0, 1.0) * 16777215, 4)
              << s;
        }
      }
    }
  }
}

// 4.1.3: the number of samples is proportional to alpha: none for 0, all for 1.
TEST(Multisample, AlphaToCoverage) {
  int before = 0;
  for (int alpha = 0; alpha < 256; ++alpha) {
    Bench bench;
    bench.state.alpha_to_coverage = true;
    bench.set_colour(1, 0, 0, alpha / 255.0);
    bench.coverage[1].rows[5] = 0;
    bench.run();
    const int count = static_cast<int>(std::ceil(alpha / 255.0 * kSampleCount));
    ASSERT_EQ(bench.written(9, 4), (1 << count) - 1) << alpha;
    ASSERT_EQ(bench.written(9, 5), ((1 << count) - 1) & ~2) << alpha;
    ASSERT_GE(count, before);
    before = count;
    const uint32_t colour = 0xffu | static_cast<uint32_t>(alpha) << 24;
    ASSERT_EQ(bench.tiles[0].colour[0], count > 0 ? colour : 0u);
  }
}

// Samples that alpha takes away are not tested either (4.1.10).
TEST(Multisample, AlphaToCoverageComesBeforeTheTests) {
  Bench bench;
  bench.state.alpha_to_coverage = true;
  bench.state.depth_test = true;
  bench.state.depth_func = CompareFunc::kAlways;
  bench.state.stencil.enabled = true;
  bench.state.stencil.pass = StencilOp::kInvert;
  bench.state.colour_mask = 0;
  bench.planes.depth = {1, 0, 0};
  bench.set_colour(0, 0, 0, 0.5);
  bench.run();
  for (int s = 0; s < kSampleCount; ++s) {
    EXPECT_EQ(bench.tiles[s].depth_stencil[77], s < 2 ? ~uint32_t{0} : 0u) << s;
  }
}

// 4.1.3, 4.1.4: ALPHA_TO_ONE follows ALPHA_TO_COVERAGE and comes before the alpha test.
TEST(Multisample, AlphaToOne) {
  Bench bench;
  bench.state.alpha_to_one = bench.state.alpha_to_coverage = true;
  bench.state.alpha_test = true;
  bench.state.alpha_func = CompareFunc::kEqual;
  bench.state.alpha_reference = 1;
  bench.set_colour(1, 0, 0, 0.3);
  bench.run();
  EXPECT_EQ(bench.written(3, 3), 3);
  EXPECT_EQ(bench.tiles[0].colour[3], 0xff0000ffu);
}

TEST(Multisample, SampleCoverage) {
  for (int step = 0; step <= 16; ++step) {
    for (const bool invert : {false, true}) {
      Bench bench;
      bench.state.sample_coverage = true;
      bench.state.sample_coverage_value = static_cast<float>(step) / 16;
      bench.state.sample_coverage_invert = invert;
      bench.state.depth_test = step % 2 == 0;
      bench.state.depth_func = CompareFunc::kAlways;
      bench.planes.depth = {1, 0, 0};
      bench.set_colour(1, 1, 1, 1);
      bench.run();
      const int mask = (1 << (step / 4)) - 1;
      const int expected = invert ? 15 & ~mask : mask;
      ASSERT_EQ(bench.written(63, 31), expected) << step << " " << invert;
      for (int s = 0; s < kSampleCount; ++s) {
        const bool tested = bench.state.depth_test && (expected >> s & 1) != 0;
        ASSERT_EQ(bench.tiles[s].depth_stencil[100], tested ? 0xffffff00u : 0u);
      }
    }
  }
}

// 4.1.3: nothing of it when the samples are not covered one by one (MULTISAMPLE disabled).
TEST(Multisample, OperationsNeedMultisampleRasterization) {
  for (const FragmentCoverage kind : {FragmentCoverage::kCentre, FragmentCoverage::kSmooth}) {
    Bench bench;
    bench.kind = kind;
    bench.planes.region = {true, 1000, 0, 0};
    bench.state.alpha_to_coverage = bench.state.alpha_to_one = true;
    bench.state.sample_coverage = true;
    bench.state.sample_coverage_value = 0.5f;
    bench.set_colour(0, 0, 0, 0x40 / 255.0);
    bench.run();
    EXPECT_EQ(bench.written(8, 8), 15);
    EXPECT_EQ(bench.tiles[3].colour[8], 0x40000000u);
  }
}

// 3.10: the fade factor multiplies alpha, and so takes part in ALPHA_TO_COVERAGE.
TEST(Multisample, PointsFade) {
  Bench bench;
  bench.kind = FragmentCoverage::kMultisamplePoint;
  bench.planes.point_fade = 0.25f;
  bench.state.alpha_to_coverage = true;
  bench.set_colour(0, 0, 0, 0.8);
  bench.run();
  EXPECT_EQ(bench.written(8, 8), 1);
  EXPECT_EQ(bench.tiles[0].colour[8], 51u << 24);
}

}  // namespace
}  // namespace clearpipe::pipeline
