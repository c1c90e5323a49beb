// See options.h.
// SPDX-License-Identifier: MIT
#include "conformance/random/options.h"

#include <cstdio>
#include <cstdlib>

namespace clearpipe::conformance::random {

namespace {

[[noreturn]] void refuse(const std::string& what) {
  std::fprintf(stderr, "random_test: %s; conformance/random/random_test.cpp lists the flags\n",
               what.c_str());
  std::exit(2);
}

}  // namespace

Options read_options(int argc, char** argv) {
  Options options;
  if (const char* folder = std::getenv("CLEARPIPE_OUTPUT")) options.output = folder;
  for (int i = 1; i < argc; ++i) {
    const std::string flag = argv[i];
    if (flag == "--no-minimise") {
      options.minimise = false;
      continue;
    }
    if (i + 1 == argc) refuse(flag + " is unknown or lacks its value");
    const std::string value = argv[++i];
    if (flag == "--seeds") {
      char dash = 0;
      const int read = std::sscanf(value.c_str(), "%u%c%u", &options.first, &dash, &options.last);
      if (read == 1) options.last = options.first;
      if ((read != 1 && (read != 3 || dash != '-')) || options.last < options.first) {
        refuse("--seeds takes FIRST-LAST or one seed, not " + value);
      }
    } else if (flag == "--group") {
      options.group = value;
    } else if (flag == "--subject") {
      options.subject = value;
      if (value != "clearpipe" && value != "llvmpipe" && value != "softpipe" && value != "gles") {
        refuse("--subject takes clearpipe, llvmpipe, softpipe or gles, not " + value);
      }
    } else if (flag == "--save") {
      options.save = value;
    } else if (flag == "--against") {
      options.against = value;
    } else if (flag == "--limit") {
      options.limit = std::atof(value.c_str());
    } else {
      refuse(flag + " is unknown");
    }
  }
  // The libraries of Mesa fix their driver when they are loaded: one of them in a process.
  const bool has_driver = options.subject == "llvmpipe" || options.subject == "softpipe";
  if (has_driver && options.against.empty() && options.save.empty()) {
    refuse("--subject " + options.subject + " needs --against or --save");
  }
  return options;
}

}  // namespace clearpipe::conformance::random
