// Planes of tiles: which of their bits are known, from clears to draws and from frame to frame.
// SPDX-License-Identifier: MIT
#include "pipeline/merge/merge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace clearpipe::pipeline {
namespace {

constexpr uint32_t kDepth = 0xffffff00u, kStencil = 0xffu;

struct StoredTile {
  std::vector<uint32_t> memory = std::vector<uint32_t>(kTilePixels, 0xabababab);
  UniformTiles uniform{{0xffffffffu}, {0}};

  TilePlane plane() { return {memory.data(), uniform, 0}; }
  uint32_t pixel(size_t i) const { return uniform.is_uniform(0) ? uniform.value[0] : memory[i]; }
};

TEST(TilePlane, DepthIsClearedAloneWhereStencilIsKnown) {
  StoredTile tile;
  TilePlane plane = tile.plane();
  EXPECT_TRUE(plane.set_bits(0x12345678, 0xffffffffu));
  plane.change(kDepth)[7] = 0x99999978;
  EXPECT_FALSE(plane.is_uniform());
  plane.store();
  plane = tile.plane();
  EXPECT_TRUE(plane.set_bits(0xaaaaaa00, kDepth));
  EXPECT_EQ(plane.uniform_value(), 0xaaaaaa78u);
  plane.store();
  EXPECT_TRUE(tile.uniform.is_uniform(0));
  plane = tile.plane();
  EXPECT_EQ(plane.change(kStencil)[7], 0xaaaaaa78u);
  EXPECT_FALSE(plane.set_bits(0, kDepth));
}

// Clears of some bits and changes of some pixels in any order, against an array of pixels.
TEST(TilePlane, HoldsWhatWasWritten) {
  std::mt19937 random(1);
  StoredTile tile;
  std::vector<uint32_t> expected(kTilePixels, 0);
  TilePlane plane = tile.plane();
  for (int round = 0; round < 500; ++round) {
    constexpr uint32_t kMasks[] = {0xffffffffu, kDepth, kStencil, 0x0f};
    const uint32_t mask = kMasks[random() % 4];
    const uint32_t value = static_cast<uint32_t>(random());
    const auto write = [&](uint32_t& pixel) { pixel = (pixel & ~mask) | (value & mask); };
    if (random() % 2 == 0) {
      std::for_each(expected.begin(), expected.end(), write);
      if (!plane.set_bits(value, mask)) {
        uint32_t* pixels = plane.change(0);
        std::for_each(pixels, pixels + kTilePixels, write);
      }
    } else {
      const size_t place = random() % kTilePixels;
      write(expected[place]);
      write(plane.change(mask)[place]);
    }
    if (random() % 3 == 0) plane.load();
    if (random() % 3 != 0) continue;
    plane.store();
    for (size_t i = 0; i < kTilePixels; ++i) ASSERT_EQ(tile.pixel(i), expected[i]) << round;
    plane = tile.plane();
  }
}

}  // namespace
}  // namespace clearpipe::pipeline
