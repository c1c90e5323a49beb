// Buffers of fewer bits: colours as their format has them, in the chain of one and of several
// samples, and depths of 16 and 32 bits.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

#include "pipeline/colour_format.h"
#include "pipeline/fragment/shade_bench.h"

namespace clearpipe::pipeline {
namespace {

constexpr ColourFormat kFormats[] = {ColourFormat::kRgba8, ColourFormat::kRgb565,
                                     ColourFormat::kRgb5A1, ColourFormat::kRgba4};
// Those of programs: with the one that stores an absent alpha.
constexpr ColourFormat kProgramFormats[] = {ColourFormat::kRgba8, ColourFormat::kRgb8,
                                            ColourFormat::kRgb565, ColourFormat::kRgb5A1,
                                            ColourFormat::kRgba4};

// The upper bits of a component, and what they are of 255.
int kept(int value, int bits) { return value >> (8 - bits); }
int widened(int value, int bits) {
  return static_cast<int>(std::lround(value * 255.0 / ((1 << bits) - 1)));
}

TEST(ColourFormat, TruncationKeepsTheUpperBitsAndRepeatsThem) {
  for (const ColourFormat format : kFormats) {
    const auto bits = component_bits(format);
    for (int v = 0; v < 256; ++v) {
      const uint32_t pixel = truncate(format, pack({v, 255 - v, v ^ 85, v ^ 170}));
      const int in[] = {v, 255 - v, v ^ 85, v ^ 170};
      for (int c = 0; c < 4; ++c) {
        const int out = component(pixel, c), n = bits[static_cast<size_t>(c)];
        ASSERT_EQ(kept(out, n), kept(in[c], n));
        // Repeated bits are the nearest of 255, or the one below.
        ASSERT_NEAR(out, widened(kept(in[c], n), n), 1);
      }
      ASSERT_EQ(truncate(format, pixel), pixel);
    }
    for (size_t c = 0; c < 4; ++c) {
      ASSERT_EQ(round_component(format, c, 0.0f), 0u);
      ASSERT_EQ(round_component(format, c, 1.0f), 255u);
      for (float v = 0; v < 1; v += 1 / 512.0f) {
        const int n = bits[c];
        const int nearest = static_cast<int>(std::nearbyint(v * static_cast<float>((1 << n) - 1)));
        ASSERT_EQ(kept(static_cast<int>(round_component(format, c, v)), n), nearest);
      }
    }
  }
}

TEST(ColourFormat, AbsentAlphaIsStoredAsOne) {
  EXPECT_EQ(truncate(ColourFormat::kRgb8, 0x12345678u), 0xff345678u);
}

// Whatever is drawn, blended or combined leaves what an 8-bit surface would have, truncated.
TEST(ColourFormat, FragmentsAreTruncatedAtTheEnd) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const ColourFormat format : kProgramFormats) {
    for (const int operation : {0, 1, 2, 3}) {
      for (int round = 0; round < 50; ++round) {
        Bench bench;
        bench.state.blend.enabled = operation == 1;
        bench.state.blend.src_rgb = bench.state.blend.src_alpha = BlendFactor::kSrcAlpha;
        bench.state.blend.dst_rgb = bench.state.blend.dst_alpha = BlendFactor::kOneMinusSrcAlpha;
        bench.state.logic_op_enabled = operation == 2;
        bench.state.logic_op = LogicOp::kXor;
        if (operation == 3) bench.state.colour_mask = 0x5;
        bench.set_colour({unit(random), unit(random), unit(random), unit(random)});
        for (uint32_t& pixel : bench.tile.memory.colour) pixel = truncate(format, random());
        Bench wide = bench;
        bench.target.format = format;
        bench.run();
        wide.run();
        const uint32_t mask = operation == 3 ? 0x00ff00ffu : 0xffffffffu;
        for (int x = 0; x < 64; ++x) {
          const uint32_t expected = truncate(format, wide.tile.colour[x]);
          ASSERT_EQ(bench.tile.colour[x] & mask, expected & mask) << operation << " " << x;
          ASSERT_EQ(bench.tile.colour[x] & ~mask, bench.tile.colour[x] & ~mask);
        }
      }
    }
  }
}

TEST(ColourFormat, SamplesAreTruncatedAfterBlending) {
  std::mt19937 random(8);
  for (const ColourFormat format : kProgramFormats) {
    FragmentState state;
    state.blend.enabled = true;
    state.blend.src_rgb = state.blend.src_alpha = BlendFactor::kOne;
    state.blend.dst_rgb = state.blend.dst_alpha = BlendFactor::kOne;
    PrimitivePlanes planes;
    planes.flat_colour = true;
    for (auto& plane : planes.colour) plane = {0.3f * kColourOne, 0, 0};
    FragmentTarget target = {true, true};
    target.multisampled = true;
    Coverage coverage{};
    coverage.last_row = 1;
    coverage.rows[0] = ~uint64_t{0};
    const Coverage all[kSampleCount] = {coverage, coverage, coverage, coverage};
    OwnTile own[2][kSampleCount];
    for (int s = 0; s < kSampleCount; ++s) {
      for (uint32_t& pixel : own[0][s].memory.colour) pixel = truncate(format, random());
      own[1][s] = own[0][s];
    }
    for (const int i : {0, 1}) {
      target.format = i == 0 ? format : ColourFormat::kRgba8;
      const std::unique_ptr<FragmentProgram, void (*)(FragmentProgram*)> program(
          make_fragment_program(state, target, FragmentCoverage::kMultisample),
          destroy_fragment_program);
      Tile tiles[kSampleCount];
      for (int s = 0; s < kSampleCount; ++s) tiles[s] = own[i][s];
      shade_samples(*program, planes, all, tiles);
    }
    for (int s = 0; s < kSampleCount; ++s) {
      for (int x = 0; x < 64; ++x) {
        ASSERT_EQ(own[0][s].colour[x], truncate(format, own[1][s].colour[x])) << s << " " << x;
      }
    }
  }
}

// A depth as the integer that a buffer of so many bits holds, upper bits first in the word. Up to
// 24 bits the product is one of single precision.
uint32_t stored_depth(float z, int bits) {
  if (bits == 32) {
    const double scaled = static_cast<double>(z) * 0x1p32;
    return static_cast<uint32_t>(std::min(std::nearbyint(scaled), 0x1p32 - 1));
  }
  const float scaled = z * static_cast<float>((1 << bits) - 1);
  return static_cast<uint32_t>(std::nearbyint(scaled)) << 8;
}

// Depths of all magnitudes are written as the nearest value, and compared by it, early and late.
TEST(DepthFormat, WrittenAndCompared) {
  std::mt19937 random(9);
  std::uniform_real_distribution<float> exponent(-36, 0);
  for (const int bits : {16, 24, 32}) {
    for (int round = 0; round < 2000; ++round) {
      float z = round == 0 ? 0 : round == 1 ? 1 : round == 2 ? 0.5f : std::exp2(exponent(random));
      if (round % 2 == 1 && round > 2) z = 1 - z;
      Bench bench;
      bench.target.depth_bits = bits;
      bench.target.has_stencil = bits != 32;
      bench.state.depth_test = true;
      bench.state.depth_func = CompareFunc::kLess;
      bench.state.alpha_test = round % 4 > 1;
      bench.set_colour({1, 1, 1, 1});
      bench.planes.depth = {z, 0, 0};
      const uint32_t value = stored_depth(z, bits);
      const uint32_t step = bits == 32 ? 1 : 256, most = stored_depth(1, bits);
      for (int x = 0; x < 64; ++x) {
        const int64_t stored = int64_t{value} + (x % 3 - 1) * int64_t{step};
        bench.tile.depth_stencil[x] = static_cast<uint32_t>(std::clamp<int64_t>(stored, 0, most));
      }
      const OwnTile before = bench.tile;
      bench.run();
      for (int x = 0; x < 64; ++x) {
        const uint32_t old = before.memory.depth_stencil[x];
        const uint32_t now = bench.tile.depth_stencil[x];
        ASSERT_EQ(now, std::min(value, old)) << bits << " " << z << " " << x;
        ASSERT_EQ(bench.tile.colour[x] != 0, value < old) << bits << " " << z << " " << x;
      }
    }
  }
}

}  // namespace
}  // namespace clearpipe::pipeline
