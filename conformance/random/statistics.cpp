// See statistics.h.
// SPDX-License-Identifier: MIT
#include "conformance/random/statistics.h"

#include <cmath>
#include <cstdio>
#include <tuple>

namespace clearpipe::conformance::random {

void Statistics::add(Line& line, uint32_t seed, const Agreement& agreement) {
  ++line.seeds;
  line.equal += agreement.equal;
  line.within_1 += agreement.within_1;
  line.far += agreement.far;
  if (std::tie(agreement.far, agreement.equal) < std::tie(line.worst, line.worst_equal)) {
    line.worst = agreement.far;
    line.worst_equal = agreement.equal;
    line.worst_seed = seed;
  }
}

void Statistics::add(uint32_t seed, const Agreement& agreement) {
  const Groups groups = groups_of(seed);
  for (size_t i = 0; i < kGroups; ++i) {
    if (groups[i]) add(groups_[i], seed, agreement);
  }
  add(all_, seed, agreement);
}

void Statistics::print(const char* name, const Line& line) {
  // Rounded down: 100% means all.
  const auto percent = [&](double sum) { return std::floor(sum / line.seeds * 1e5) / 1e3; };
  std::printf(
      "random %s: %d seeds, equal %.3f%%, within 1/255 %.3f%%, within 8/255 %.3f%%, worst seed %u "
      "(%.2f%% beyond 8/255)\n",
      name, line.seeds, percent(line.equal), percent(line.within_1), percent(line.far),
      line.worst_seed, 100 * (1 - line.worst));
}

void Statistics::print() const {
  for (size_t i = 0; i < kGroups; ++i) {
    if (groups_[i].seeds != 0) print(name_of(static_cast<Group>(i)), groups_[i]);
  }
  if (all_.seeds != 0) print("all", all_);
}

}  // namespace clearpipe::conformance::random
