// Texture sampling against the equations of 3.7.7 and 3.7.8 in double precision, on every SIMD
// target of the machine: NEAREST exact, LINEAR within the stated bounds, the same bits on all
// targets, and no read outside a level for coordinates that are not sensible numbers.
// SPDX-License-Identifier: MIT
#include "pipeline/simd.h"

#include "pipeline/fragment/sample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "hwy/targets.h"

namespace clearpipe::pipeline {
namespace {

constexpr std::array<Wrap, 3> kWraps = {Wrap::kRepeat, Wrap::kClampToEdge, Wrap::kMirroredRepeat};
constexpr std::array<Filter, 2> kFilters = {Filter::kNearest, Filter::kLinear};
constexpr std::array<MipFilter, 3> kMips = {MipFilter::kNone, MipFilter::kNearest,
                                            MipFilter::kLinear};
constexpr std::array<std::array<int, 2>, 9> kSizes = {
    {{1, 1}, {2, 2}, {64, 16}, {1, 32}, {3, 5}, {100, 37}, {7, 64}, {256, 255}, {33, 1}}};

std::vector<int64_t> targets_of_machine() {
  hwy::SetSupportedTargetsForTest(0);
  std::vector<int64_t> list;
  for (int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1) {
    list.push_back(left & -left);
  }
  return list;
}

// Restricts dispatch to one target while it lives.
class OnTarget {
 public:
  explicit OnTarget(int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
  ~OnTarget() {
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
  OnTarget(const OnTarget&) = delete;
  OnTarget& operator=(const OnTarget&) = delete;
};

ImageRef random_image(int width, int height, uint32_t seed) {
  std::mt19937 random(seed);
  auto image = std::make_shared<Image>();
  for (;;) {
    ImageLevel level{width, height, {}};
    level.texels = Texels(static_cast<size_t>(width) * static_cast<size_t>(height));
    for (uint32_t& texel : level.texels) texel = random();
    image->levels.push_back(std::move(level));
    if (width == 1 && height == 1) return image;
    width = std::max(width / 2, 1);
    height = std::max(height / 2, 1);
  }
}

TextureUnit unit_of(ImageRef image, Sampler sampler) {
  TextureUnit unit;
  unit.enabled = true;
  sampler.max_level = static_cast<int>(image->levels.size()) - 1;
  unit.image = std::move(image);
  unit.sampler = sampler;
  return unit;
}

std::unique_ptr<FragmentBatch> sampled(const TextureUnit& unit, const FragmentBatch& input) {
  auto batch = std::make_unique<FragmentBatch>(input);
  const SampleState state = make_sample_state(unit);
  select_sample_function(state)(state, *batch, 1);
  return batch;
}

bool same_colours(const FragmentBatch& a, const FragmentBatch& b) {
  for (int c = 0; c < 4; ++c) {
    if (!std::equal(a.texture[1][c], a.texture[1][c] + a.count, b.texture[1][c])) return false;
  }
  return true;
}

// ---- The oracle ---------------------------------------------------------------------------------

int wrapped(Wrap wrap, int64_t i, int size) {
  if (wrap == Wrap::kClampToEdge) return static_cast<int>(std::clamp<int64_t>(i, 0, size - 1));
  const int64_t period = wrap == Wrap::kRepeat ? size : 2 * size;
  const int64_t in = ((i % period) + period) % period;
  return static_cast<int>(in < size ? in : period - 1 - in);
}

using Colour = std::array<double, 4>;  // 0 to 255

Colour texel_of(const ImageLevel& level, int x, int y) {
  const uint32_t t = level.texels[static_cast<size_t>(y) * static_cast<size_t>(level.width) +
                                  static_cast<size_t>(x)];
  return {double(t & 255), double((t >> 8) & 255), double((t >> 16) & 255), double(t >> 24)};
}

Colour mix(double a, const Colour& x, const Colour& y) {
  Colour result;
  for (size_t c = 0; c < 4; ++c) result[c] = (1 - a) * x[c] + a * y[c];
  return result;
}

// steps: a scaled coordinate is rounded to this fraction of a texel first; 0 leaves it alone.
Colour level_oracle(const ImageLevel& level, const Sampler& sampler, Filter filter, double s,
                    double t, double steps) {
  double u = s * level.width, v = t * level.height;
  if (filter == Filter::kNearest) {
    return texel_of(level,
                    wrapped(sampler.wrap_s, static_cast<int64_t>(std::floor(u)), level.width),
                    wrapped(sampler.wrap_t, static_cast<int64_t>(std::floor(v)), level.height));
  }
  if (steps > 0) {
    u = std::nearbyint(u * steps) / steps;
    v = std::nearbyint(v * steps) / steps;
  }
  const double i = std::floor(u - 0.5), j = std::floor(v - 0.5);
  const auto at = [&](int di, int dj) {
    return texel_of(level, wrapped(sampler.wrap_s, static_cast<int64_t>(i) + di, level.width),
                    wrapped(sampler.wrap_t, static_cast<int64_t>(j) + dj, level.height));
  };
  const double a = u - 0.5 - i, b = v - 0.5 - j;
  return mix(b, mix(a, at(0, 0), at(1, 0)), mix(a, at(0, 1), at(1, 1)));
}

Colour oracle(const TextureUnit& unit, double s, double t, double lod, double steps) {
  const Sampler& sampler = unit.sampler;
  const std::vector<ImageLevel>& levels = unit.image->levels;
  const int base = sampler.base_level, last = sampler.max_level;
  const double lambda = lod + sampler.lod_bias;
  const bool near_mip = sampler.mip != MipFilter::kNone && sampler.min == Filter::kNearest;
  const double c = near_mip && sampler.mag == Filter::kLinear ? 0.5 : 0.0;
  const auto at = [&](int level, Filter filter) {
    return level_oracle(levels[static_cast<size_t>(level)], sampler, filter, s, t, steps);
  };
  if (lambda <= c) return at(base, sampler.mag);
  if (sampler.mip == MipFilter::kNone) return at(base, sampler.min);
  if (sampler.mip == MipFilter::kNearest) {
    const int d = lambda <= 0.5 ? base : base + static_cast<int>(std::ceil(lambda + 0.5)) - 1;
    return at(std::min(d, last), sampler.min);
  }
  const int d1 = base + static_cast<int>(std::floor(lambda));
  if (d1 >= last) return at(last, sampler.min);
  double fraction = lambda - std::floor(lambda);
  if (steps > 0) fraction = std::floor(fraction * steps) / steps;
  return mix(fraction, at(d1, sampler.min), at(d1 + 1, sampler.min));
}

// ---- Inputs -------------------------------------------------------------------------------------

// A coordinate whose scaled value stays clear of the edge between texels and between steps of 1/256
// on every level, so that the precision of the multiplication cannot decide.
float clear_coordinate(std::mt19937& random, const std::vector<int>& sizes) {
  std::uniform_real_distribution<float> range(-3.0f, 4.0f);
  for (;;) {
    const float s = range(random);
    const bool clear = std::all_of(sizes.begin(), sizes.end(), [&](int size) {
      const double step = double(s) * size * 256;
      const double from_half = std::abs(step - std::floor(step) - 0.5);
      const double u = double(s) * size;
      return from_half > 0.1 && std::abs(u - std::nearbyint(u)) > 1e-4;
    });
    if (clear) return s;
  }
}

void fill(FragmentBatch& batch, const Image& image, std::mt19937& random, int count) {
  std::vector<int> widths, heights;
  for (const ImageLevel& level : image.levels) {
    widths.push_back(level.width);
    heights.push_back(level.height);
  }
  std::uniform_int_distribution<int> eighths(-10, 60);
  batch.count = count;
  for (int i = 0; i < kBatchSize; ++i) {
    batch.s[i] = clear_coordinate(random, widths);
    batch.t[i] = clear_coordinate(random, heights);
    batch.lod[i] = static_cast<float>(eighths(random)) / 8.0f + 0.0626f;
  }
}

template <class Function>
void for_each_sampler(const Function& function) {
  for (Wrap s : kWraps) {
    for (Wrap t : kWraps) {
      for (Filter min : kFilters) {
        for (Filter mag : kFilters) {
          for (MipFilter mip : kMips) {
            Sampler sampler;
            sampler.wrap_s = s;
            sampler.wrap_t = t;
            sampler.min = min;
            sampler.mag = mag;
            sampler.mip = mip;
            function(sampler);
          }
        }
      }
    }
  }
}

std::string describe(const Sampler& p, const ImageLevel& level, int64_t target) {
  return std::string(hwy::TargetName(target)) + " size " + std::to_string(level.width) + "x" +
         std::to_string(level.height) + " wrap " + std::to_string(int(p.wrap_s)) +
         std::to_string(int(p.wrap_t)) + " min " + std::to_string(int(p.min)) + " mag " +
         std::to_string(int(p.mag)) + " mip " + std::to_string(int(p.mip));
}

// ---- Tests --------------------------------------------------------------------------------------

// Bounds in units of 1/255. Eight-bit arithmetic: each interpolation rounds by at most 1/2, and the
// first of two is averaged by the second; against the pure equations each weight is off by 1/512
// (that of the levels, truncated, by 1/256) of a difference of at most 255. Fine arithmetic: three
// roundings and widenings of 1/8192, weights of 1/65536.
TEST(Sample, FollowsTheEquations) {
  for (const int64_t target : targets_of_machine()) {
    const OnTarget on(target);
    std::mt19937 random(7);
    for (const auto& size : kSizes) {
      const ImageRef image = random_image(size[0], size[1], 11);
      for_each_sampler([&](const Sampler& sampler) {
        const TextureUnit unit = unit_of(image, sampler);
        FragmentBatch input;
        fill(input, *image, random, kBatchSize);
        const auto output = sampled(unit, input);
        const bool fine =
            sampler.wrap_s == Wrap::kMirroredRepeat || sampler.wrap_t == Wrap::kMirroredRepeat;
        const bool levels = sampler.mip == MipFilter::kLinear;
        const bool linear = sampler.min == Filter::kLinear || sampler.mag == Filter::kLinear;
        double same_weights = 0.04, pure = 0.04;
        if (fine) {
          same_weights = pure = linear || levels ? 0.15 : 0.04;
        } else {
          same_weights += (linear ? 1.0 : 0) + (levels ? 0.5 : 0);
          pure += (linear ? 2.0 : 0) + (levels ? 1.5 : 0);
        }
        double worst_same = 0, worst_pure = 0;
        for (int i = 0; i < input.count; ++i) {
          const double steps = fine ? 0 : 256;
          const Colour a = oracle(unit, input.s[i], input.t[i], input.lod[i], steps);
          const Colour b = oracle(unit, input.s[i], input.t[i], input.lod[i], 0);
          for (size_t c = 0; c < 4; ++c) {
            const double value = output->texture[1][c][i] * 255.0 / 8192.0;
            worst_same = std::max(worst_same, std::abs(value - a[c]));
            worst_pure = std::max(worst_pure, std::abs(value - b[c]));
          }
        }
        EXPECT_LE(worst_same, same_weights) << describe(sampler, image->levels[0], target);
        EXPECT_LE(worst_pure, pure) << describe(sampler, image->levels[0], target);
      });
    }
  }
}

TEST(Sample, NearestCopiesTheTexel) {
  for (const int64_t target : targets_of_machine()) {
    const OnTarget on(target);
    std::mt19937 random(3);
    for (const auto& size : kSizes) {
      const ImageRef image = random_image(size[0], size[1], 5);
      for (Wrap s : kWraps) {
        for (Wrap t : kWraps) {
          Sampler sampler;
          sampler.wrap_s = s;
          sampler.wrap_t = t;
          sampler.min = sampler.mag = Filter::kNearest;
          sampler.mip = MipFilter::kNone;
          const TextureUnit unit = unit_of(image, sampler);
          FragmentBatch input;
          fill(input, *image, random, kBatchSize);
          const auto output = sampled(unit, input);
          for (int i = 0; i < input.count; ++i) {
            const Colour a = oracle(unit, input.s[i], input.t[i], 0, 0);
            for (size_t c = 0; c < 4; ++c) {
              const int v = static_cast<int>(a[c]);
              ASSERT_EQ(output->texture[1][c][i], colour_from_unorm8(v))
                  << describe(sampler, image->levels[0], target);
            }
          }
        }
      }
    }
  }
}

TEST(Sample, AllTargetsAgreeToTheBit) {
  const std::vector<int64_t> targets = targets_of_machine();
  std::mt19937 random(19);
  for (const auto& size : kSizes) {
    const ImageRef image = random_image(size[0], size[1], 23);
    for_each_sampler([&](Sampler sampler) {
      sampler.lod_bias = 0.3f;
      const TextureUnit unit = unit_of(image, sampler);
      FragmentBatch input;
      input.count = kBatchSize;
      std::uniform_real_distribution<float> coordinate(-20, 20), lod(-2, 9);
      for (int i = 0; i < kBatchSize; ++i) {
        // Half of them at exact eighths of a texel, where rounding has ties.
        input.s[i] =
            i % 2 ? coordinate(random) : std::floor(coordinate(random) * 8) / 512 / float(size[0]);
        input.t[i] =
            i % 2 ? coordinate(random) : std::floor(coordinate(random) * 8) / 512 / float(size[1]);
        input.lod[i] = lod(random);
      }
      std::unique_ptr<FragmentBatch> first;
      for (const int64_t target : targets) {
        const OnTarget on(target);
        auto output = sampled(unit, input);
        if (first == nullptr) {
          first = std::move(output);
        } else {
          EXPECT_TRUE(same_colours(*first, *output)) << describe(sampler, image->levels[0], target);
        }
      }
    });
  }
}

TEST(Sample, HostileCoordinatesStayInsideAndAgree) {
  const float inf = std::numeric_limits<float>::infinity();
  const std::vector<float> hostile = {
      0.0f,    -0.0f,      1.0f,         -1.0f,       std::nanf(""),
      inf,     -inf,       1e30f,        -1e30f,      1e10f,
      -1e10f,  8388607.5f, -8388608.0f,  16777216.0f, 1e-40f,
      -1e-40f, -1e-9f,     0.99999994f,  1.0000001f,  std::numeric_limits<float>::max(),
      3e7f,    -3e7f,      2147483648.0f};
  const std::vector<int64_t> targets = targets_of_machine();
  for (const auto& size : kSizes) {
    const ImageRef image = random_image(size[0], size[1], 29);
    for_each_sampler([&](const Sampler& sampler) {
      const TextureUnit unit = unit_of(image, sampler);
      for (size_t shift = 0; shift < hostile.size(); ++shift) {
        FragmentBatch input;
        input.count = kBatchSize;
        for (size_t i = 0; i < kBatchSize; ++i) {
          input.s[i] = hostile[i % hostile.size()];
          input.t[i] = hostile[(i + shift) % hostile.size()];
          input.lod[i] = hostile[(i + 2 * shift + 3) % hostile.size()];
        }
        std::unique_ptr<FragmentBatch> first;
        for (const int64_t target : targets) {
          const OnTarget on(target);
          auto output = sampled(unit, input);
          if (first == nullptr) {
            first = std::move(output);
          } else {
            ASSERT_TRUE(same_colours(*first, *output))
                << describe(sampler, image->levels[0], target);
          }
        }
      }
    });
  }
}

// A fragment's colour depends on its own coordinates alone: not on its place or its neighbours.
TEST(Sample, PlaceInTheBatchDoesNotMatter) {
  const ImageRef image = random_image(100, 37, 31);
  for (const int64_t target : targets_of_machine()) {
    const OnTarget on(target);
    for_each_sampler([&](const Sampler& sampler) {
      const TextureUnit unit = unit_of(image, sampler);
      std::mt19937 random(37);
      FragmentBatch input;
      fill(input, *image, random, kBatchSize);
      const auto forwards = sampled(unit, input);
      std::reverse(input.s, input.s + kBatchSize);
      std::reverse(input.t, input.t + kBatchSize);
      std::reverse(input.lod, input.lod + kBatchSize);
      const auto backwards = sampled(unit, input);
      for (int c = 0; c < 4; ++c) {
        for (int i = 0; i < kBatchSize; ++i) {
          ASSERT_EQ(forwards->texture[1][c][i], backwards->texture[1][c][kBatchSize - 1 - i]);
        }
      }
    });
  }
}

// A batch whose fragments share a level takes a shorter way, with the same result.
TEST(Sample, OneLevelForAllEqualsLevelsMixed) {
  const ImageRef image = random_image(64, 16, 53);
  for (const int64_t target : targets_of_machine()) {
    const OnTarget on(target);
    for_each_sampler([&](const Sampler& sampler) {
      const TextureUnit unit = unit_of(image, sampler);
      std::mt19937 random(59);
      FragmentBatch mixed;
      fill(mixed, *image, random, kBatchSize);
      for (const float lod : {-1.0f, 0.3f, 1.25f, 1.75f, 5.5f, 20.0f}) {
        std::fill(mixed.lod, mixed.lod + kBatchSize, lod);
        const auto together = sampled(unit, mixed);
        for (int i = 0; i < kBatchSize; i += 3) mixed.lod[i] = 3.4f;
        const auto apart = sampled(unit, mixed);
        for (int c = 0; c < 4; ++c) {
          for (int i = 0; i < kBatchSize; ++i) {
            if (i % 3 == 0) continue;
            ASSERT_EQ(together->texture[1][c][i], apart->texture[1][c][i])
                << describe(sampler, image->levels[0], target) << " lod " << lod;
          }
        }
      }
    });
  }
}

// 3.7.8: with LINEAR magnification and NEAREST_MIPMAP_* minification the switch is at 1/2, else 0.
TEST(Sample, MagnificationThreshold) {
  Sampler sampler;
  sampler.mag = Filter::kLinear;
  sampler.min = Filter::kNearest;
  sampler.mip = MipFilter::kNearest;
  const ImageRef image = random_image(8, 8, 41);
  EXPECT_EQ(make_sample_state(unit_of(image, sampler)).lod_threshold, 0.5f);
  sampler.mip = MipFilter::kNone;
  EXPECT_EQ(make_sample_state(unit_of(image, sampler)).lod_threshold, 0.0f);
  EXPECT_TRUE(make_sample_state(unit_of(image, sampler)).needs_lod);
  sampler.min = Filter::kLinear;
  EXPECT_FALSE(make_sample_state(unit_of(image, sampler)).needs_lod);
  sampler.mip = MipFilter::kLinear;
  EXPECT_EQ(make_sample_state(unit_of(image, sampler)).lod_threshold, 0.0f);
  EXPECT_TRUE(make_sample_state(unit_of(image, sampler)).needs_lod);
}

TEST(Sample, BaseAndMaxLevelLimitTheChain) {
  Sampler sampler;
  sampler.mag = sampler.min = Filter::kNearest;
  sampler.mip = MipFilter::kNearest;
  TextureUnit unit = unit_of(random_image(16, 16, 43), sampler);
  unit.sampler.base_level = 1;
  unit.sampler.max_level = 3;
  FragmentBatch input;
  input.count = 3;
  for (int i = 0; i < kBatchSize; ++i) input.s[i] = input.t[i] = 0.6f;
  std::fill(input.lod, input.lod + kBatchSize, 0.0f);
  input.lod[0] = -5;
  input.lod[1] = 1;
  input.lod[2] = 9;
  const auto output = sampled(unit, input);
  for (int i = 0; i < 3; ++i) {
    const ImageLevel& level = unit.image->levels[static_cast<size_t>(i + 1)];
    const int x = static_cast<int>(0.6 * level.width);
    const int v = static_cast<int>(texel_of(level, x, x)[0]);
    EXPECT_EQ(output->texture[1][0][i], colour_from_unorm8(v)) << i;
  }
}

TEST(Sample, AnAbsentImageReadsBlack) {
  TextureUnit unit;
  FragmentBatch input;
  input.count = kBatchSize;
  for (int i = 0; i < kBatchSize; ++i) input.s[i] = input.t[i] = input.lod[i] = float(i);
  const auto output = sampled(unit, input);
  EXPECT_EQ(output->texture[1][0][5], 0);
  EXPECT_EQ(output->texture[1][3][5], kColourOne);
}

}  // namespace
}  // namespace clearpipe::pipeline
