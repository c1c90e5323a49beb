// The flags of random_test; random_test.cpp describes them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace clearpipe::conformance::random {

struct Options {
  uint32_t first = 0, last = 1999;  // both included
  std::string group;                // empty: all
  std::string subject = "clearpipe";
  std::string save, against;  // folders
  double limit = 1;           // percent of a seed's pixels beyond 8/255
  std::string output = "random";
  bool minimise = true;
};

// Takes what GoogleTest has left of the command line; prints what is wrong and exits on an error.
Options read_options(int argc, char** argv);

}  // namespace clearpipe::conformance::random
