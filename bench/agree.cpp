// SPDX-License-Identifier: MIT
//
// How two PNG files agree, as far as a measurement needs to know that both drew the same:
//
//   agree a.png b.png share
//
// prints the shares of pixels that are equal and within 2/255, the largest difference, and how many
// colours the first picture has. The status is 1 if the pictures differ in size, if less than
// `share` is within 2/255, or if all pixels of the first are of one colour but those of the second
// are not.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <set>

#include "bench/picture.h"

namespace {

constexpr int kNear = 2;
constexpr size_t kEnoughColours = 1000;  // to count

uint32_t colour(const bench::Picture& picture, size_t pixel) {
  uint32_t value = 0;
  std::memcpy(&value, picture.pixels.data() + 4 * pixel, sizeof value);
  return value;
}

size_t count_colours(const bench::Picture& picture) {
  std::set<uint32_t> seen;
  const size_t pixels = picture.pixels.size() / 4;
  for (size_t i = 0; i < pixels && seen.size() < kEnoughColours; ++i)
    seen.insert(colour(picture, i));
  return seen.size();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: agree a.png b.png share\n");
    return 2;
  }
  const bench::Picture a = bench::read_png(argv[1]), b = bench::read_png(argv[2]);
  const double wanted = std::strtod(argv[3], nullptr);
  if (a.width != b.width || a.height != b.height) {
    std::printf("agree: sizes differ\n");
    return 1;
  }
  size_t equal = 0, near = 0;
  int largest = 0;
  for (size_t i = 0; i < a.pixels.size(); i += 4) {
    int apart = 0;
    for (size_t c = 0; c < 4; ++c)
      apart = std::max(apart, std::abs(a.pixels[i + c] - b.pixels[i + c]));
    equal += apart == 0;
    near += apart <= kNear;
    largest = std::max(largest, apart);
  }
  const double pixels = double(a.pixels.size()) / 4;
  const size_t colours = count_colours(a);
  std::printf("agree: equal=%.5f near=%.5f largest=%d colours=%zu\n", double(equal) / pixels,
              double(near) / pixels, largest, colours);
  return double(near) / pixels >= wanted && (colours > 1 || count_colours(b) == 1) ? 0 : 1;
}
