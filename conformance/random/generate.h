// Streams from seeds: the same seed gives the same stream everywhere.
// SPDX-License-Identifier: MIT
#pragma once

#include <bitset>
#include <cstdint>

#include "conformance/random/stream.h"

namespace clearpipe::conformance::random {

enum class Group : uint8_t {
#define GROUP(name) name,
#include "conformance/random/groups.def"
#undef GROUP
  count
};

inline constexpr size_t kGroups = static_cast<size_t>(Group::count);
using Groups = std::bitset<kGroups>;

const char* name_of(Group group);

// The first group of a seed is seed modulo kGroups, so that every range of seeds has all groups.
Groups groups_of(uint32_t seed);

Stream generate(uint32_t seed);

}  // namespace clearpipe::conformance::random
