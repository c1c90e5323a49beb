// Every fragment stage against its equation in double precision, through shade(): a tile whose
// pixels carry the cases. ctest runs it on each SIMD target.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "pipeline/fragment/shade_bench.h"

namespace clearpipe::pipeline {
namespace {

TEST(Shade, EveryEightBitColourComesBack) {
  for (int v = 0; v < 256; ++v) {
    Bench bench;
    bench.set_colour({v / 255.0, (255 - v) / 255.0, 0, 1});
    bench.run();
    ASSERT_EQ(bench.tile.colour[0], pack({v, 255 - v, 0, 255}));
    ASSERT_EQ(bench.tile.colour[63], bench.tile.colour[0]);
    ASSERT_EQ(bench.tile.colour[64], 0u) << "outside the coverage";
  }
}

TEST(Shade, ColourFollowsItsPlaneAndPerspective) {
  Bench bench;
  bench.planes.flat_colour = false;
  bench.planes.perspective = true;
  bench.planes.x_ref = 3.25f;
  bench.planes.inv_w = {0.5f, 0.03f, 0};
  bench.planes.colour[0] = {0.1f * kColourOne, 0.02f * kColourOne, 0};
  bench.planes.colour[3] = {0.5f * kColourOne, 0.03f * kColourOne, 0};
  bench.run();
  for (int x = 0; x < 64; ++x) {
    const double dx = x + 0.5 - 3.25;
    const double expected = clamp01((0.1 + 0.02 * dx) / (0.5 + 0.03 * dx)) * 255;
    ASSERT_NEAR(component(bench.tile.colour[x], 0), expected, 0.53) << x;
    ASSERT_EQ(component(bench.tile.colour[x], 3), 255);
  }
}

TEST(Shade, EveryBlendFactorAndEquation) {
  std::mt19937 random(3);
  for (int equation = 0; equation < 5; ++equation) {
    for (int src = 0; src < 11; ++src) {
      for (int dst = 0; dst < 11; ++dst) {
        Bench bench;
        BlendState& blend = bench.state.blend;
        blend.enabled = true;
        blend.rgb = blend.alpha = static_cast<BlendEquation>(equation);
        blend.src_rgb = blend.src_alpha = static_cast<BlendFactor>(src);
        blend.dst_rgb = blend.dst_alpha = static_cast<BlendFactor>(dst);
        Colour s;
        for (double& v : s) v = (random() & 255) / 255.0;
        bench.set_colour(s);
        std::array<uint32_t, 64> before;
        for (int x = 0; x < 64; ++x) {
          before[x] = bench.tile.colour[x] = random();
        }
        bench.run();
        for (int x = 0; x < 64; ++x) {
          Colour d;
          for (int c = 0; c < 4; ++c) d[c] = component(before[x], c) / 255.0;
          for (int c = 0; c < 4; ++c) {
            const double expected =
                clamp01(blended(blend.rgb, s[c], factor_of(blend.src_rgb, c, s, d), d[c],
                                factor_of(blend.dst_rgb, c, s, d)));
            ASSERT_NEAR(component(bench.tile.colour[x], c), expected * 255, 1.01)
                << equation << " " << src << " " << dst << " component " << c;
          }
        }
      }
    }
  }
}

bool passes(CompareFunc func, int a, int b) {
  switch (func) {
    case CompareFunc::kNever:
      return false;
    case CompareFunc::kLess:
      return a < b;
    case CompareFunc::kEqual:
      return a == b;
    case CompareFunc::kLessEqual:
      return a <= b;
    case CompareFunc::kGreater:
      return a > b;
    case CompareFunc::kNotEqual:
      return a != b;
    case CompareFunc::kGreaterEqual:
      return a >= b;
    case CompareFunc::kAlways:
      return true;
  }
  return false;
}

TEST(Shade, DepthTestEarlyAndLateAgreeWithTheFunction) {
  for (int func = 0; func < 8; ++func) {
    for (const bool late : {false, true}) {
      Bench bench;
      bench.state.depth_test = true;
      bench.state.depth_func = static_cast<CompareFunc>(func);
      bench.state.alpha_test = late;  // always passes, but moves the depth test behind it
      bench.planes.depth = {0.25f, 0, 0};
      bench.set_colour({1, 1, 1, 1});
      const int depth = static_cast<int>(std::nearbyint(0.25 * 16777215.0));
      for (int x = 0; x < 64; ++x) {
        bench.tile.depth_stencil[x] = static_cast<uint32_t>(depth + x % 3 - 1) << 8 | 0x5a;
      }
      bench.run();
      for (int x = 0; x < 64; ++x) {
        const int stored = depth + x % 3 - 1;
        const bool pass = passes(bench.state.depth_func, depth, stored);
        ASSERT_EQ(bench.tile.colour[x], pass ? 0xffffffffu : 0u) << func << " " << x;
        ASSERT_EQ(bench.tile.depth_stencil[x],
                  static_cast<uint32_t>(pass ? depth : stored) << 8 | 0x5a);
      }
    }
  }
}

// Passes of one scene with and without the alpha test must agree on every depth (appendix A).
TEST(Shade, DepthIsTheSameEarlyAndLate) {
  uint32_t written[2][64];
  std::mt19937 random(5);
  for (int round = 0; round < 2000; ++round) {
    // Columns on both sides of 512, where the distance to the reference loses a bit.
    const float x_ref = static_cast<float>(random() % 4096) / 4096 + 5.0f / 131072;
    for (const bool late : {false, true}) {
      Bench bench;
      bench.state.depth_test = true;
      bench.state.depth_func = CompareFunc::kAlways;
      bench.state.alpha_test = late;
      bench.tile.x = 480;
      bench.planes.x_ref = x_ref;
      bench.planes.depth = {0, 0.0018f, 0};
      bench.run();
      std::copy_n(bench.tile.depth_stencil, 64, written[late]);
    }
    for (int x = 0; x < 64; ++x) ASSERT_EQ(written[0][x], written[1][x]) << x_ref << " " << x;
  }
}

int stencil_result(StencilOp op, int stored, int reference) {
  switch (op) {
    case StencilOp::kKeep:
      return stored;
    case StencilOp::kZero:
      return 0;
    case StencilOp::kReplace:
      return reference;
    case StencilOp::kIncrement:
      return std::min(stored + 1, 255);
    case StencilOp::kDecrement:
      return std::max(stored - 1, 0);
    case StencilOp::kInvert:
      return ~stored & 255;
    case StencilOp::kIncrementWrap:
      return (stored + 1) & 255;
    case StencilOp::kDecrementWrap:
      return (stored - 1) & 255;
  }
  return stored;
}

TEST(Shade, StencilOperationsForEachOutcome) {
  constexpr int kReference = 0x35, kMask = 0x7d, kWriteMask = 0x9f;
  for (int func = 0; func < 8; ++func) {
    for (int op = 0; op < 8; ++op) {
      Bench bench;
      StencilState& stencil = bench.state.stencil;
      stencil = {true,
                 static_cast<CompareFunc>(func),
                 kReference,
                 kMask,
                 kWriteMask,
                 static_cast<StencilOp>(op),
                 static_cast<StencilOp>((op + 3) % 8),
                 static_cast<StencilOp>((op + 5) % 8)};
      bench.state.depth_test = true;
      bench.planes.depth = {0.5f, 0, 0};
      bench.set_colour({1, 1, 1, 1});
      for (int x = 0; x < 64; ++x) {
        const uint32_t depth = x % 2 != 0 ? 0xffffffu : 0u;
        bench.tile.depth_stencil[x] = depth << 8 | static_cast<uint32_t>(x * 4 + x / 16);
      }
      bench.run();
      for (int x = 0; x < 64; ++x) {
        const int stored = x * 4 + x / 16;
        const bool stencil_passes = passes(stencil.func, kReference & kMask, stored & kMask);
        const bool depth_passes = x % 2 != 0;
        const StencilOp chosen = !stencil_passes ? stencil.fail
                                 : depth_passes  ? stencil.pass
                                                 : stencil.depth_fail;
        const int value = stencil_result(chosen, stored, kReference);
        ASSERT_EQ(static_cast<int>(bench.tile.depth_stencil[x] & 255),
                  (value & kWriteMask) | (stored & ~kWriteMask & 255))
            << func << " " << op << " " << x;
        ASSERT_EQ(bench.tile.colour[x] != 0, stencil_passes && depth_passes);
      }
    }
  }
}

TEST(Shade, AlphaTestMeetsEightBitReferencesExactly) {
  for (int func = 0; func < 8; ++func) {
    for (int alpha = 0; alpha < 256; alpha += 3) {
      for (const int reference : {0, 1, 77, 128, 254, 255, alpha}) {
        Bench bench;
        bench.state.alpha_test = true;
        bench.state.alpha_func = static_cast<CompareFunc>(func);
        bench.state.alpha_reference = static_cast<float>(reference) / 255.0f;
        bench.set_colour({1, 0, 0, alpha / 255.0});
        bench.run();
        ASSERT_EQ(bench.tile.colour[5] != 0, passes(bench.state.alpha_func, alpha, reference))
            << func << " " << alpha << " " << reference;
      }
    }
  }
}

TEST(Shade, LogicOperationsFollowTheirTruthTables) {
  for (int op = 0; op < 16; ++op) {
    Bench bench;
    bench.state.logic_op_enabled = true;
    bench.state.logic_op = static_cast<LogicOp>(op);
    bench.state.blend.enabled = true;  // ignored (4.1.9)
    bench.set_colour({0x33 / 255.0, 0x0f / 255.0, 0xff / 255.0, 0x55 / 255.0});
    const uint32_t source = pack({0x33, 0x0f, 0xff, 0x55});
    for (int x = 0; x < 64; ++x) bench.tile.colour[x] = 0x9e3779b9u * static_cast<uint32_t>(x + 1);
    const auto before = std::to_array(bench.tile.memory.colour);
    bench.run();
    for (int x = 0; x < 64; ++x) {
      uint32_t expected = 0;
      for (int bit = 0; bit < 32; ++bit) {
        const int s = source >> bit & 1, d = before[x] >> bit & 1;
        const int minterm = s ? (d ? 0 : 1) : (d ? 2 : 3);
        expected |= static_cast<uint32_t>(op >> minterm & 1) << bit;
      }
      ASSERT_EQ(bench.tile.colour[x], expected) << op;
    }
  }
}

TEST(Shade, ColourMaskKeepsComponents) {
  for (uint8_t mask = 0; mask < 16; ++mask) {
    Bench bench;
    bench.state.colour_mask = mask;
    bench.set_colour({1, 1, 1, 1});
    for (int x = 0; x < 64; ++x) bench.tile.colour[x] = 0x11223344u;
    bench.run();
    for (int c = 0; c < 4; ++c) {
      ASSERT_EQ(component(bench.tile.colour[9], c),
                (mask >> c & 1) != 0 ? 255 : component(0x11223344u, c));
    }
  }
}

TEST(Shade, FogFactorsFollowTheirEquations) {
  for (const FogMode mode : {FogMode::kLinear, FogMode::kExp, FogMode::kExp2}) {
    Bench bench;
    bench.state.fog = mode;
    bench.state.fog_density = 0.07f;
    bench.state.fog_start = 2;
    bench.state.fog_end = 41;
    bench.state.fog_colour = {0.2f, 0.4f, 1, 0};
    bench.set_colour({1, 0.5, 0, 0.25});
    bench.planes.fog = {0, 1, 0};
    bench.run();
    for (int x = 0; x < 64; ++x) {
      const double c = x + 0.5;
      const double f = mode == FogMode::kLinear ? clamp01((41 - c) / 39)
                       : mode == FogMode::kExp  ? std::exp(-0.07 * c)
                                                : std::exp(-0.07 * c * 0.07 * c);
      ASSERT_NEAR(component(bench.tile.colour[x], 0), 255 * (f * 1 + (1 - f) * 0.2), 0.6) << x;
      ASSERT_NEAR(component(bench.tile.colour[x], 2), 255 * (1 - f), 0.6) << x;
      ASSERT_EQ(component(bench.tile.colour[x], 3), 64);
    }
  }
}

TEST(Shade, CombinersFollowTheirEquations) {
  auto image = std::make_shared<Image>();
  image->levels.push_back({1, 1, {pack({200, 90, 30, 160})}});
  const Colour t = {200 / 255.0, 90 / 255.0, 30 / 255.0, 160 / 255.0};
  const Colour p = {0.3, 0.8, 0.55, 0.65}, k = {0.9, 0.1, 0.45, 0.35};
  for (int function = 0; function < 9; ++function) {
    for (int scale = 0; scale < 3; ++scale) {
      Bench bench;
      TextureUnit& unit = bench.state.unit[0];
      unit.enabled = true;
      unit.image = image;
      unit.sampler.mip = MipFilter::kNone;
      unit.constant = {0.9f, 0.1f, 0.45f, 0.35f};
      Combiner& combiner = unit.combiner;
      combiner.rgb = static_cast<Combine>(function);
      combiner.alpha = function < 7 ? combiner.rgb : Combine::kModulate;
      combiner.rgb_scale_log2 = static_cast<uint8_t>(scale);
      combiner.alpha_scale_log2 = static_cast<uint8_t>((scale + 1) % 3);
      combiner.rgb_argument = {{{CombineSource::kTexture0, CombineOperand::kColour},
                                {CombineSource::kPrevious, CombineOperand::kOneMinusColour},
                                {CombineSource::kConstant, CombineOperand::kAlpha}}};
      combiner.alpha_argument = {{{CombineSource::kTexture0, CombineOperand::kAlpha},
                                  {CombineSource::kPrimaryColour, CombineOperand::kOneMinusAlpha},
                                  {CombineSource::kConstant, CombineOperand::kAlpha}}};
      bench.set_colour(p);
      for (int i = 0; i < 4; ++i) bench.planes.texture[0][i] = {i == 3 ? 1.0f : 0.5f, 0, 0};
      bench.run();
      double dot = 0;
      for (int c = 0; c < 3; ++c) dot += 4 * (t[c] - 0.5) * ((1 - p[c]) - 0.5);
      for (int c = 0; c < 4; ++c) {
        const double a0 = t[c], a1 = 1 - p[c], a2 = k[3];
        double v = 0;
        switch (c == 3 ? combiner.alpha : combiner.rgb) {
          case Combine::kReplace:
            v = a0;
            break;
          case Combine::kModulate:
            v = a0 * a1;
            break;
          case Combine::kAdd:
            v = a0 + a1;
            break;
          case Combine::kAddSigned:
            v = a0 + a1 - 0.5;
            break;
          case Combine::kInterpolate:
            v = a0 * a2 + a1 * (1 - a2);
            break;
          case Combine::kSubtract:
            v = a0 - a1;
            break;
          case Combine::kModulateAdd:
            v = a0 * a2 + a1;
            break;
          case Combine::kDot3Rgb:
          case Combine::kDot3Rgba:
            v = clamp01(dot);
            break;
        }
        if (combiner.rgb == Combine::kDot3Rgba) v = clamp01(dot);
        const int log2 = c == 3 ? combiner.alpha_scale_log2 : combiner.rgb_scale_log2;
        const double expected = clamp01(v * (1 << log2)) * 255;
        ASSERT_NEAR(component(bench.tile.colour[7], c), expected, 0.75)
            << function << " scale " << (1 << log2) << " component " << c;
      }
    }
  }
}

}  // namespace
}  // namespace clearpipe::pipeline
