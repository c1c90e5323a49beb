// SPDX-License-Identifier: MIT
//
// What of the library bench_extras is found by name, beside connect_x11.
#include "bench/picture.h"

extern "C" void bench_read_png(const std::string& path, bench::Picture& picture) {
  picture = bench::read_png(path);
}

extern "C" void bench_write_png(const bench::Picture& picture, const std::string& path) {
  bench::write_png(picture, path);
}
