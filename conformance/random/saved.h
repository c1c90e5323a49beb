// Outcomes in files, so that one process can compare with what another has drawn.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "conformance/random/stream.h"

namespace clearpipe::conformance::random {

// Writes, or reads, FOLDER/SEED. Both throw std::runtime_error with the reason when they cannot.
void save(const Outcome& outcome, const std::string& folder, uint32_t seed);
Outcome load(const std::string& folder, uint32_t seed);

}  // namespace clearpipe::conformance::random
