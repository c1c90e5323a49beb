// See disagreement.h.
// SPDX-License-Identifier: MIT
#include "conformance/random/disagreement.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace clearpipe::conformance::random {

namespace {

std::string hexadecimal(GLenum value) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%04x", value);
  return text;
}

}  // namespace

Verdict judge(const Outcome& outcome, const Outcome& expected, double limit) {
  Verdict verdict;
  const Tolerance tolerance = {2, 0, 8, 1 - limit / 100, nullptr};
  verdict.agreement = compare(outcome.image, expected.image, tolerance);
  if (!holds(verdict.agreement, tolerance)) {
    char text[64];
    std::snprintf(text, sizeof text, "%.2f%% of the pixels beyond 8/255; ",
                  100 * (1 - verdict.agreement.far));
    verdict.complaint += text;
  }
  for (size_t i = 0; i < std::min(outcome.errors.size(), expected.errors.size()); ++i) {
    if (outcome.errors[i] == expected.errors[i]) continue;
    verdict.complaint += "error " + std::to_string(i) + " is " + hexadecimal(outcome.errors[i]) +
                         ", not " + hexadecimal(expected.errors[i]) + "; ";
  }
  for (size_t i = 0; i < std::min(outcome.values.size(), expected.values.size()); ++i) {
    const float a = outcome.values[i], b = expected.values[i];
    if (std::fabs(a - b) <= 1e-5f + 1e-4f * std::fabs(b)) continue;
    verdict.complaint += "value " + std::to_string(i) + " is " + std::to_string(a) + ", not " +
                         std::to_string(b) + "; ";
  }
  return verdict;
}

}  // namespace clearpipe::conformance::random
