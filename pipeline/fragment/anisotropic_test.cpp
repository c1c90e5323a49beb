// Anisotropic filtering against its equation (EXT_texture_filter_anisotropic): the mean of samples
// that are themselves tested in sample_test.cpp; the same bits on every SIMD target.
// SPDX-License-Identifier: MIT
#include "pipeline/simd.h"

#include "pipeline/fragment/sample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include "hwy/targets.h"

namespace clearpipe::pipeline {
namespace {

TextureUnit trilinear_unit(float anisotropy, Wrap wrap) {
  std::mt19937 random(7);
  auto image = std::make_shared<Image>();
  for (int size = 64; size > 0; size /= 2) {
    ImageLevel level{size, size, {}};
    level.texels = Texels(static_cast<size_t>(size) * static_cast<size_t>(size));
    for (uint32_t& texel : level.texels) texel = random();
    image->levels.push_back(std::move(level));
  }
  TextureUnit unit;
  unit.enabled = true;
  unit.sampler.wrap_s = unit.sampler.wrap_t = wrap;
  unit.sampler.min = unit.sampler.mag = Filter::kLinear;
  unit.sampler.mip = MipFilter::kLinear;
  unit.sampler.max_level = 6;
  unit.sampler.max_anisotropy = anisotropy;
  unit.image = std::move(image);
  return unit;
}

FragmentBatch random_footprints() {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> coordinate(-2, 3), along(-0.4f, 0.4f), lod(-1, 6);
  FragmentBatch batch = {};
  batch.count = kBatchSize;
  for (int i = 0; i < kBatchSize; ++i) {
    batch.s[i] = coordinate(random);
    batch.t[i] = coordinate(random);
    batch.lod[i] = lod(random);
    batch.along_s[i] = along(random);
    batch.along_t[i] = along(random);
    batch.probes[i] = static_cast<float>(1 + random() % 16);
  }
  return batch;
}

std::unique_ptr<FragmentBatch> sampled(const TextureUnit& unit, const FragmentBatch& input) {
  auto batch = std::make_unique<FragmentBatch>(input);
  const SampleState state = make_sample_state(unit);
  select_sample_function(state)(state, *batch, 0);
  return batch;
}

template <class Function>
void on_every_target(const Function& function) {
  hwy::SetSupportedTargetsForTest(0);
  for (int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1) {
    hwy::SetSupportedTargetsForTest(left & -left);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    function();
    hwy::SetSupportedTargetsForTest(0);
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

TEST(Anisotropic, IsTheMeanOfSamplesAlongTheFootprint) {
  const FragmentBatch input = random_footprints();
  on_every_target([&] {
    const TextureUnit isotropic = trilinear_unit(1, Wrap::kRepeat);
    const auto output = sampled(trilinear_unit(16, Wrap::kRepeat), input);
    for (int f = 0; f < kBatchSize; ++f) {
      const int n = static_cast<int>(input.probes[f]);
      FragmentBatch probes = input;
      for (int i = 1; i <= n; ++i) {
        const double place = i / (n + 1.0) - 0.5;
        probes.s[i] = static_cast<float>(input.s[f] + input.along_s[f] * place);
        probes.t[i] = static_cast<float>(input.t[f] + input.along_t[f] * place);
        probes.lod[i] = input.lod[f];
      }
      const auto samples = sampled(isotropic, probes);
      for (int c = 0; c < 4; ++c) {
        double sum = 0;
        for (int i = 1; i <= n; ++i) sum += samples->texture[0][c][i];
        // A weight of 8 bits may round the other way; a probe then moves by 1/255.
        ASSERT_NEAR(output->texture[0][c][f], sum / n, 40) << f << " of " << n;
      }
    }
    EXPECT_TRUE(std::equal(input.s, input.s + kBatchSize, output->s));
    EXPECT_TRUE(std::equal(input.t, input.t + kBatchSize, output->t));
  });
}

TEST(Anisotropic, AllTargetsAgreeToTheBit) {
  const float inf = std::numeric_limits<float>::infinity();
  FragmentBatch input = random_footprints();
  for (int i = 0; i < 8; ++i) {
    input.s[i] = i % 2 ? inf : std::nanf("");
    input.along_s[i] = i % 3 ? -inf : std::nanf("");
    input.probes[i] = static_cast<float>(i + 1);
  }
  for (const Wrap wrap : {Wrap::kRepeat, Wrap::kClampToEdge, Wrap::kMirroredRepeat}) {
    std::unique_ptr<FragmentBatch> first;
    on_every_target([&] {
      auto output = sampled(trilinear_unit(4, wrap), input);
      if (!first) first = std::move(output);
      for (int c = 0; output && c < 4; ++c) {
        EXPECT_TRUE(std::equal(first->texture[0][c], first->texture[0][c] + kBatchSize,
                               output->texture[0][c]));
      }
    });
  }
}

// Neither the fragments beside one nor their number of probes count.
TEST(Anisotropic, OneProbeIsTheSampleItself) {
  FragmentBatch input = random_footprints();
  for (int i = 0; i < kBatchSize; i += 2) {
    input.probes[i] = 1;
    input.along_s[i] = std::numeric_limits<float>::infinity();
  }
  on_every_target([&] {
    const auto output = sampled(trilinear_unit(16, Wrap::kRepeat), input);
    const auto isotropic = sampled(trilinear_unit(1, Wrap::kRepeat), input);
    for (int c = 0; c < 4; ++c) {
      for (int i = 0; i < kBatchSize; i += 2) {
        ASSERT_EQ(output->texture[0][c][i], isotropic->texture[0][c][i]);
      }
    }
  });
}

}  // namespace
}  // namespace clearpipe::pipeline
