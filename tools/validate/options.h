// The command line of clearpipe-validate.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace clearpipe::validate {

struct Options {
  std::vector<std::string> program;  // and its arguments
  std::vector<int> frames = {1, 10, 100};
  int every = 0;  // not 0: each Nth frame instead
  // At least so many percent of a frame's pixels lie within `tolerance`/255.
  int tolerance = 2;
  double share = 99.5;
  double clock = 0;   // frames a second of the steady clock; 0: the real one
  int timeout = 120;  // seconds of each run
  bool json = false;
  std::string report = "clearpipe-report.html";
  std::string manifest, mesa_manifest;  // of the vendor libraries; empty: found
};

// Prints what is wrong, or the help, and exits.
Options read_options(int argc, char** argv);

}  // namespace clearpipe::validate
