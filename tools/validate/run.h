// One run of the program on one implementation, with the capture library preloaded.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include "conformance/implementation.h"
#include "tools/validate/options.h"

namespace clearpipe::validate {

struct Implementation {
  std::string name;      // for people
  std::string manifest;  // its EGL vendor's
  bool mesa = false;
};

struct Run {
  std::string renderer, version;  // empty: the program drew nothing
  int frames = 0;                 // that ended
  int samples = 0;
  std::map<int, std::string> files;  // of the captured frames, by number
  std::map<int, int> undefined;      // textures used without contents, and the first such frame
  std::string error;                 // of capturing
  bool finished = false;             // after the last frame that was wanted, or by itself
  std::string ending;                // "ended with status 0", "was killed by signal 11 (...)", ...
  std::string output;                // the last lines that it printed
};

// Runs the program in its folder, which is made; throws std::runtime_error when it cannot.
Run run(const Options& options, const Implementation& implementation, const std::string& folder);

// Of one of `files`; throws when it is cut short.
conformance::Image read_frame(const std::string& path);

}  // namespace clearpipe::validate
