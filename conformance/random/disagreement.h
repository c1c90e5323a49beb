// Whether two implementations made the same of a stream.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "conformance/compare.h"
#include "conformance/random/stream.h"

namespace clearpipe::conformance::random {

struct Verdict {
  Agreement agreement;
  std::string complaint;  // empty: all is well
};

// At most `limit` percent of the pixels may differ by more than 8/255; errors must be the same, and
// values up to rounding.
Verdict judge(const Outcome& outcome, const Outcome& expected, double limit);

}  // namespace clearpipe::conformance::random
