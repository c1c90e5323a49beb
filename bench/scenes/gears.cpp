// SPDX-License-Identifier: MIT
//
// The gears of examples/, at any size.
extern "C" {
#include "examples/gears_scene.h"
}

#include "bench/scene.h"

#include <array>

namespace bench {

namespace {

double set_up(const View& view) {
  set_up_gears(view.width, view.height);
  return 1;
}

void frame(const View&, int number) { draw_gears(number); }

constexpr std::array kScenes = {
    Scene{.name = "gears",
          .what = "three lit gears",
          .unit = "frame",
          .amount = 0,
          .set_up = set_up,
          .frame = frame},
    Scene{.name = "gears_300",
          .what = "the same at 300x300",
          .unit = "frame",
          .amount = 0,
          .set_up = set_up,
          .frame = frame,
          .square = 300},
};

}  // namespace

std::span<const Scene> gears_scenes() { return kScenes; }

}  // namespace bench
