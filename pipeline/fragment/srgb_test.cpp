// The sRGB encoding against the equations of EXT_sRGB in double precision: of what is sampled, of
// what is written, blended and resolved. ctest runs it on each SIMD target.
// SPDX-License-Identifier: MIT
#include "pipeline/srgb.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "pipeline/fragment/shade_bench.h"

namespace clearpipe::pipeline {
namespace {

double to_linear(double cs) {
  return cs <= 0.04045 ? cs / 12.92 : std::pow((cs + 0.055) / 1.055, 2.4);
}
double to_srgb(double cl) {
  return cl < 0.0031308 ? 12.92 * cl : 1.055 * std::pow(cl, 1 / 2.4) - 0.055;
}

Colour linear_colour(uint32_t pixel) {
  Colour c;
  for (int i = 0; i < 3; ++i) c[i] = to_linear(component(pixel, i) / 255.0);
  c[3] = component(pixel, 3) / 255.0;
  return c;
}

// What of a linear colour is stored, in units of 1 / 255.
double stored(double linear, int c) { return (c == 3 ? linear : to_srgb(linear)) * 255; }

// A component of the fragments has 13 bits, of which the steepest part of the encoding makes steps
// of 0.4.
constexpr double kStep = 12.92 * 255 / kColourOne;

Bench srgb_bench() {
  Bench bench;
  bench.target.srgb = true;
  return bench;
}

TEST(Srgb, EveryComponentComesBack) {
  for (int v = 0; v < 256; ++v) {
    const int32_t linear = srgb_to_linear()[v];
    ASSERT_NEAR(linear, to_linear(v / 255.0) * kColourOne, 0.5) << v;
    ASSERT_EQ(linear_to_srgb(static_cast<float>(linear) / kColourOne), v);
  }
  EXPECT_EQ(linear_to_srgb(-1), 0);
  EXPECT_EQ(linear_to_srgb(2), 255);
}

TEST(Srgb, ColoursAreWrittenEncoded) {
  for (int v = 0; v <= 1000; ++v) {
    Bench bench = srgb_bench();
    const Colour colour = {v / 1000.0, v / 5000.0, 1.5, v / 1000.0};
    bench.set_colour(colour);
    bench.run();
    for (int c = 0; c < 4; ++c) {
      ASSERT_NEAR(component(bench.tile.colour[v % 64], c), stored(clamp01(colour[c]), c),
                  0.51 + kStep / 2)
          << v << " component " << c;
    }
  }
}

TEST(Srgb, ColoursAreBlendedLinear) {
  std::mt19937 random(5);
  for (int equation = 0; equation < 5; ++equation) {
    for (int src = 0; src < 11; ++src) {
      for (int dst = 0; dst < 11; ++dst) {
        Bench bench = srgb_bench();
        BlendState& blend = bench.state.blend;
        blend.enabled = true;
        blend.rgb = blend.alpha = static_cast<BlendEquation>(equation);
        blend.src_rgb = blend.src_alpha = static_cast<BlendFactor>(src);
        blend.dst_rgb = blend.dst_alpha = static_cast<BlendFactor>(dst);
        Colour s;
        for (double& v : s) v = (random() & 255) / 255.0;
        bench.set_colour(s);
        std::array<uint32_t, 64> before;
        for (int x = 0; x < 64; ++x) before[x] = bench.tile.colour[x] = random();
        bench.run();
        for (int x = 0; x < 64; ++x) {
          const Colour d = linear_colour(before[x]);
          for (int c = 0; c < 4; ++c) {
            const double result =
                clamp01(blended(blend.rgb, s[c], factor_of(blend.src_rgb, c, s, d), d[c],
                                factor_of(blend.dst_rgb, c, s, d)));
            // Each of two terms has two operands, each half a step off; and the sum is rounded.
            ASSERT_NEAR(component(bench.tile.colour[x], c), stored(result, c), 0.51 + 2.5 * kStep)
                << equation << " " << src << " " << dst << " component " << c;
          }
        }
      }
    }
  }
}

TEST(Srgb, LogicOperationsAndMasksAreOfEncodedColours) {
  Bench bench = srgb_bench();
  bench.state.logic_op_enabled = true;
  bench.state.logic_op = LogicOp::kXor;
  bench.state.colour_mask = 0b1101;  // not green
  bench.set_colour({to_linear(200 / 255.0), 1, to_linear(100 / 255.0), 40 / 255.0});
  std::fill_n(bench.tile.colour, 64, pack({15, 16, 17, 18}));
  bench.run();
  EXPECT_EQ(bench.tile.colour[0], pack({15 ^ 200, 16, 17 ^ 100, 18 ^ 40}));
}

TEST(Srgb, SamplesAreBlendedAsPixels) {
  std::mt19937 random(6);
  Bench pixels = srgb_bench();
  pixels.state.blend.enabled = true;
  pixels.state.blend.src_rgb = BlendFactor::kSrcAlpha;
  pixels.state.blend.dst_rgb = BlendFactor::kOneMinusSrcAlpha;
  pixels.set_colour({0.9, 0.4, 0.1, 0.3});
  pixels.target.multisampled = true;
  OwnTile tiles[kSampleCount];
  Tile views[kSampleCount];
  Coverage coverage[kSampleCount];
  for (int s = 0; s < kSampleCount; ++s) {
    std::generate_n(tiles[s].colour, 64, std::ref(random));
    views[s] = tiles[s];
    coverage[s] = pixels.coverage;
  }
  const OwnTile before = tiles[2];
  const std::unique_ptr<FragmentProgram, void (*)(FragmentProgram*)> program(
      make_fragment_program(pixels.state, pixels.target, FragmentCoverage::kMultisample),
      destroy_fragment_program);
  shade_samples(*program, pixels.planes, coverage, views);
  pixels.target.multisampled = false;
  pixels.tile = before;
  pixels.run();
  for (int x = 0; x < 64; ++x) ASSERT_EQ(tiles[2].colour[x], pixels.tile.colour[x]) << x;
}

TEST(Srgb, SamplesAreResolvedLinear) {
  std::mt19937 random(7);
  for (int round = 0; round < 10000; ++round) {
    uint32_t samples[kSampleCount];
    Colour sum = {};
    for (uint32_t& sample : samples) {
      sample = random();
      const Colour colour = linear_colour(sample);
      for (int c = 0; c < 4; ++c) sum[c] += colour[c];
    }
    const uint32_t mean = mean_srgb(samples);
    for (int c = 0; c < 4; ++c) {
      ASSERT_NEAR(component(mean, c), stored(sum[c] / kSampleCount, c), 0.51 + kStep);
    }
  }
}

// A texture of one row, whose coordinate runs over the columns of the tile.
class SrgbTextureTest : public testing::Test {
 protected:
  static constexpr int kSize = 64;

  SrgbTextureTest() {
    auto image = std::make_shared<Image>();
    image->levels.push_back({kSize, 1, Texels(kSize)});
    std::mt19937 random(8);
    for (uint32_t& texel : image->levels[0].texels) texel = random();
    texels_ = image->levels[0].texels;
    TextureUnit& unit = bench_.state.unit[0];
    unit.enabled = true;
    unit.srgb = true;
    unit.image = image;
    unit.sampler.mip = MipFilter::kNone;
    for (CombineArgument& a : unit.combiner.rgb_argument) a.source = CombineSource::kTexture0;
    for (CombineArgument& a : unit.combiner.alpha_argument) {
      a = {CombineSource::kTexture0, CombineOperand::kAlpha};
    }
    bench_.planes.texture[0][3] = {1, 0, 0};
  }

  // Of the texel at a place that may lie outside of the image, with REPEAT or MIRRORED_REPEAT.
  Colour texel(int i) const {
    const bool mirrored = bench_.state.unit[0].sampler.wrap_s == Wrap::kMirroredRepeat;
    const int period = mirrored ? 2 * kSize : kSize;
    const int place = (i % period + period) % period;
    return linear_colour(texels_[static_cast<size_t>(place < kSize ? place : period - 1 - place)]);
  }

  // With a coordinate of (first + step x) texels at the centre of column x.
  void sample(Filter filter, Wrap wrap, double first, double step) {
    Sampler& sampler = bench_.state.unit[0].sampler;
    sampler.min = sampler.mag = filter;
    sampler.wrap_s = sampler.wrap_t = wrap;
    bench_.planes.x_ref = 0.5f;
    bench_.planes.texture[0][0] = {static_cast<float>(first / kSize),
                                   static_cast<float>(step / kSize), 0};
    bench_.run();
    for (int x = 0; x < 64; ++x) {
      const double at = first + step * x - (filter == Filter::kLinear ? 0.5 : 0);
      const int below = static_cast<int>(std::floor(at));
      const double weight = filter == Filter::kLinear ? at - below : 0;
      const Colour a = texel(below), b = texel(below + 1);
      for (int c = 0; c < 4; ++c) {
        const double expected = a[c] + (b[c] - a[c]) * weight;
        ASSERT_NEAR(component(bench_.tile.colour[x], c), expected * 255, 0.6)
            << x << " component " << c;
      }
    }
  }

  Bench bench_;
  Texels texels_;
};

TEST_F(SrgbTextureTest, NearestTexelsAreLinear) {
  sample(Filter::kNearest, Wrap::kRepeat, 0.5, 1);
  sample(Filter::kNearest, Wrap::kMirroredRepeat, -100.5, 3);
}

TEST_F(SrgbTextureTest, LinearColoursAreInterpolated) {
  sample(Filter::kLinear, Wrap::kRepeat, 0.25, 0.375);
  sample(Filter::kLinear, Wrap::kMirroredRepeat, -7.25, 1.625);
}

// All faces of a cube map, and nothing of it is decoded twice.
TEST_F(SrgbTextureTest, CubeMaps) {
  auto image = std::make_shared<Image>();
  image->levels.resize(kCubeFaces * kMaxLevels);
  for (uint32_t face = 0; face < 6; ++face) {
    image->levels[face * kMaxLevels] = {1, 1, {pack({int(30 * face), 255, 128, 64})}};
  }
  TextureUnit& unit = bench_.state.unit[0];
  unit.cube = true;
  unit.image = image;
  for (int face = 0; face < 6; ++face) {
    for (int i = 0; i < 3; ++i) {
      const float sign = face % 2 == 0 ? 1 : -1;
      bench_.planes.texture[0][i] = {i == face / 2 ? sign : 0.25f, 0, 0};
    }
    bench_.run();
    EXPECT_NEAR(component(bench_.tile.colour[9], 0), to_linear(30 * face / 255.0) * 255, 0.6);
    EXPECT_EQ(component(bench_.tile.colour[9], 3), 64);
  }
}

}  // namespace
}  // namespace clearpipe::pipeline
