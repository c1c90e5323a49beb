// SPDX-License-Identifier: MIT
//
// Pictures as PNG files: RGBA, 8 bits, rows from the top.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace bench {

struct Picture {
  int width = 0, height = 0;
  std::vector<uint8_t> pixels;
};

// Both end the process with a message when they cannot.
Picture read_png(const std::string& path);
void write_png(const Picture& picture, const std::string& path);

}  // namespace bench
