// See srgb.h.
// SPDX-License-Identifier: MIT
#include "pipeline/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/fragment/program.h"

namespace clearpipe::pipeline {

namespace {

// The positive n-th root of a number in (0, 1], by Newton's method from above: it falls until it
// cannot fall any more.
double root(double value, int n) {
  const auto power = [](double base, int exponent) {
    double result = 1;
    for (int i = 0; i < exponent; ++i) result *= base;
    return result;
  };
  double x = 1;
  for (;;) {
    const double next = x - (power(x, n) - value) / (n * power(x, n - 1));
    if (!(next < x)) return x;
    x = next;
  }
}

double decoded(double s) {
  if (s <= 0.04045) return s / 12.92;
  const double base = (s + 0.055) / 1.055;
  return base * base * root(base * base, 5);  // 2.4 = 2 + 2/5
}

double encoded(double linear) {
  if (linear < 0.0031308) return 12.92 * linear;
  const double square = linear * linear;
  return 1.055 * root(square * square * linear, 12) - 0.055;  // 1 / 2.4 = 5/12
}

}  // namespace

const int32_t* srgb_to_linear() {
  static const auto kTable = [] {
    std::array<int32_t, 256> table;
    for (size_t i = 0; i < table.size(); ++i) {
      table[i] = static_cast<int32_t>(
          std::floor(decoded(static_cast<double>(i) / 255) * kColourOne + 0.5));
    }
    return table;
  }();
  return kTable.data();
}

uint32_t srgb_of(int linear) {
  static const auto kTable = [] {
    std::array<uint8_t, kColourOne + 1> table;
    for (size_t i = 0; i < table.size(); ++i) {
      table[i] = static_cast<uint8_t>(
          std::floor(encoded(static_cast<double>(i) / kColourOne) * 255 + 0.5));
    }
    return table;
  }();
  return kTable[static_cast<size_t>(std::clamp<int>(linear, 0, kColourOne))];
}

uint32_t linear_to_srgb(float linear) {
  return srgb_of(static_cast<int>(std::clamp(linear, 0.0f, 1.0f) * kColourOne + 0.5f));
}

uint32_t mean_srgb(const uint32_t (&samples)[kSampleCount]) {
  constexpr int kRounding = kSampleCount / 2;
  const int32_t* linear = srgb_to_linear();
  int sum[4] = {kRounding, kRounding, kRounding, kRounding};
  for (const uint32_t sample : samples) {
    for (int c = 0; c < 3; ++c) sum[c] += linear[sample >> 8 * c & 255];
    sum[3] += static_cast<int>(sample >> 24);
  }
  uint32_t mean = static_cast<uint32_t>(sum[3] / kSampleCount) << 24;
  for (int c = 0; c < 3; ++c) mean |= srgb_of(sum[c] / kSampleCount) << 8 * c;
  return mean;
}

}  // namespace clearpipe::pipeline
