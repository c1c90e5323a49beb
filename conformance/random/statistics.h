// Agreement counted over seeds, for each group of features.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "conformance/compare.h"
#include "conformance/random/generate.h"

namespace clearpipe::conformance::random {

class Statistics {
 public:
  // A seed counts for each of its groups.
  void add(uint32_t seed, const Agreement& agreement);

  // One line a group that had seeds, and one for all seeds.
  void print() const;

  // The share of all pixels that is within 1/255; 1 when there were none.
  double within_1() const { return all_.seeds == 0 ? 1 : all_.within_1 / all_.seeds; }

 private:
  struct Line {
    int seeds = 0;
    double equal = 0, within_1 = 0, far = 0;  // sums of shares
    double worst = 2;                         // the smallest `far`, then the smallest `equal`
    double worst_equal = 2;
    uint32_t worst_seed = 0;
  };
  static void add(Line& line, uint32_t seed, const Agreement& agreement);
  static void print(const char* name, const Line& line);

  std::array<Line, kGroups> groups_;
  Line all_;
};

}  // namespace clearpipe::conformance::random
