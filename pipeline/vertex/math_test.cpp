// log2, exp2 and pow of the vertex stages: error bounds, special values, equal bits.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "pipeline/vertex/vertex_test_kernels.h"

namespace clearpipe::pipeline {
namespace {

constexpr size_t kCount = 1 << 16;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

TEST(VertexMath, Log2IsAccurateAndTheSameOnEveryTarget) {
  std::mt19937 random(11);
  std::uniform_int_distribution<uint32_t> bits(0x00800000u, 0x7f7fffffu);
  std::vector<float> x(kCount), first;
  for (float& value : x) {
    const uint32_t b = bits(random);
    std::memcpy(&value, &b, 4);
  }
  for (size_t i = 0; i < 1000; ++i) x[i] = 0.99f + 0.00002f * static_cast<float>(i);
  const int targets = for_each_target([&](const VertexTestKernels& kernels, const char* name) {
    std::vector<float> out(kCount);
    kernels.log2(x.data(), kCount, out.data());
    for (size_t i = 0; i < kCount; ++i) {
      const double exact = std::log2(static_cast<double>(x[i]));
      ASSERT_NEAR(out[i], exact, std::abs(exact) * std::ldexp(1.0, -23) + 1e-12)
          << name << " log2 " << x[i];
    }
    if (first.empty()) first = out;
    EXPECT_TRUE(same_bits(first, out)) << name;
  });
  EXPECT_GE(targets, 2);
}

TEST(VertexMath, Exp2IsAccurateAndTheSameOnEveryTarget) {
  std::mt19937 random(12);
  std::uniform_real_distribution<float> range(-126.0f, 127.9f);
  std::vector<float> x(kCount), first;
  for (float& value : x) value = range(random);
  for_each_target([&](const VertexTestKernels& kernels, const char* name) {
    std::vector<float> out(kCount);
    kernels.exp2(x.data(), kCount, out.data());
    for (size_t i = 0; i < kCount; ++i) {
      const double exact = std::exp2(static_cast<double>(x[i]));
      ASSERT_NEAR(out[i] / exact, 1.0, std::ldexp(1.0, -22)) << name << " exp2 " << x[i];
    }
    if (first.empty()) first = out;
    EXPECT_TRUE(same_bits(first, out)) << name;
  });
}

TEST(VertexMath, PowStaysBelowItsErrorBoundUpToExponent128) {
  std::mt19937 random(13);
  std::uniform_real_distribution<float> base(0.0f, 1.0f), exponent(0.0f, 128.0f);
  std::vector<float> x(kCount), y(kCount), first;
  for (size_t i = 0; i < kCount; ++i) {
    x[i] = i % 2 == 0 ? base(random) : 1.0f - 0.05f * base(random);
    y[i] = i % 5 == 0 ? 128.0f : exponent(random);
  }
  for_each_target([&](const VertexTestKernels& kernels, const char* name) {
    std::vector<float> out(kCount);
    kernels.power(x.data(), y.data(), kCount, out.data());
    for (size_t i = 0; i < kCount; ++i) {
      const double exact = std::pow(static_cast<double>(x[i]), static_cast<double>(y[i]));
      if (exact < 1.001 * std::numeric_limits<float>::min()) {
        ASSERT_LE(out[i], 1.002 * std::numeric_limits<float>::min()) << name;
      } else {
        ASSERT_NEAR(out[i] / exact, 1.0, std::ldexp(1.0, -20)) << name << x[i] << "^" << y[i];
      }
    }
    if (first.empty()) first = out;
    EXPECT_TRUE(same_bits(first, out)) << name;
  });
}

TEST(VertexMath, SpecialValues) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<float> x = {0, 0, 1, 0.5f, nan, -1, 1e-40f, 0.25f, 2, 1, 0.5f, 0, 4, 1, 1, 1};
  std::vector<float> y = {0, 5, 99, 0, 2, 3, 0.5f, 0.5f, 10, 0, 1, 128, 1000, 128, 1, 2};
  std::vector<float> expected = {1, 0, 1, 1, 0, 0, 0, 0.5f, 1024, 1, 0.5f, 0, kInfinity, 1, 1, 1};
  for_each_target([&](const VertexTestKernels& kernels, const char* name) {
    std::vector<float> out(16);
    kernels.power(x.data(), y.data(), 16, out.data());
    for (size_t i = 0; i < 16; ++i) EXPECT_EQ(out[i], expected[i]) << name << " " << i;
    const std::vector<float> t = {-1000, 1000, 0, 1, -1, 127, -126, 128, 3, 4, 5, 6, 7, 8, 9, 10};
    kernels.exp2(t.data(), 16, out.data());
    EXPECT_EQ(out[0], 0) << name;
    EXPECT_EQ(out[1], kInfinity) << name;
    EXPECT_EQ(out[7], kInfinity) << name;
    for (size_t i : {2, 3, 4, 5, 6, 8, 9, 15}) {
      EXPECT_EQ(out[i], std::ldexp(1.0f, static_cast<int>(t[i]))) << name;
    }
  });
}

}  // namespace
}  // namespace clearpipe::pipeline
