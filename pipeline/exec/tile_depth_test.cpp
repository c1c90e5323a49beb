// The bounds of a tile's depths: they hold every depth that is evaluated, and what they hide is
// never missed.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/tile_depth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "pipeline/exec/frame_scene.h"

namespace clearpipe::pipeline {
namespace {

TEST(TileDepth, RangesHoldEveryPixelOfTheBox) {
  std::mt19937 random(1);
  const auto number = [&](float most) {
    return std::uniform_real_distribution<float>(-most, most)(random);
  };
  for (int i = 0; i < 3000; ++i) {
    // From level planes to slivers, whose large terms cancel.
    const float steep = std::exp2(number(20) - 10);
    const Plane plane{number(1) * (i % 2 == 0 ? 1 : steep), number(steep), number(steep)};
    const float x_ref = number(2000), y_ref = number(2000);
    Tile tile;
    tile.x = kTileWidth * static_cast<int>(random() % 20);
    tile.y = kTileHeight * static_cast<int>(random() % 20);
    PrimitiveRecord box;
    box.x0 = static_cast<int16_t>(tile.x - 5 + static_cast<int>(random() % 40));
    box.y0 = static_cast<int16_t>(tile.y - 5 + static_cast<int>(random() % 20));
    box.x1 =
        static_cast<int16_t>(std::max<int>(box.x0, tile.x) + 1 + static_cast<int>(random() % 90));
    box.y1 =
        static_cast<int16_t>(std::max<int>(box.y0, tile.y) + 1 + static_cast<int>(random() % 40));
    const DepthRange range = depth_range(plane, x_ref, y_ref, box, tile, 16777215.0f);
    for (int y = std::max<int>(box.y0, tile.y); y < std::min<int>(box.y1, tile.y + kTileHeight);
         ++y) {
      for (int x = std::max<int>(box.x0, tile.x); x < std::min<int>(box.x1, tile.x + kTileWidth);
           ++x) {
        // As interpolate-inl.h evaluates planes and depth_stencil-inl.h rounds them.
        const float dx = static_cast<float>(x) + (0.5f - x_ref);
        const float dy = static_cast<float>(y) + (0.5f - y_ref);
        const float row = plane.value + plane.dy * dy;
        const float z = std::min(std::max(row + plane.dx * dx, 0.0f), 1.0f);
        const auto depth = static_cast<uint32_t>(std::nearbyint(z * 16777215.0f));
        ASSERT_GE(depth, range.least) << i;
        ASSERT_LE(depth, range.most) << i;
      }
    }
  }
}

// Layers of random depth in one frame, where bounds are known, and each in a frame of its own,
// where they are not.
TEST(TileDepth, HiddenLayersAreNotMissed) {
  std::mt19937 random(2);
  const auto number = [&](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  for (int round = 0; round < 60; ++round) {
    Scene together, apart;
    ClearCommand clear;
    clear.rect = {0, 0, kWidth, kHeight};
    clear.colour = clear.depth = true;
    clear.stencil = round % 2 == 0;
    clear.depth_value = random() % 0x1000000;
    for (Scene* scene : {&together, &apart}) ASSERT_TRUE(scene->frame.clear(clear));
    apart.frame.finish();
    for (int layer = 0; layer < 12; ++layer) {
      FragmentState state;
      state.depth_test = true;
      state.depth_func = static_cast<CompareFunc>(random() % 8);
      if (random() % 3 != 0) state.depth_func = CompareFunc::kLessEqual;
      state.depth_write = random() % 4 != 0;
      state.alpha_test = random() % 5 == 0;
      state.alpha_func = CompareFunc::kGreater;
      state.alpha_reference = 0.5f;
      state.stencil.enabled = random() % 6 == 0;
      state.stencil.depth_fail = StencilOp::kIncrementWrap;
      // A rectangle over everything, or less, level or inclined.
      const float x = random() % 3 == 0 ? number(-1, 0) : -2, to_x = random() % 3 == 0 ? 0.5f : 2;
      const float z = number(-1, 1), slope = random() % 2 == 0 ? number(-0.5f, 0.5f) : 0;
      const std::vector<float> corners = {x, -2, z, to_x, -2, z + slope, x,    2, z,
                                          x, 2,  z, to_x, -2, z + slope, to_x, 2, z + slope};
      const Vec4 colour{number(0, 1), number(0, 1), number(0, 1), number(0, 1)};
      for (Scene* scene : {&together, &apart}) {
        scene->fragment = state;
        scene->draw(corners, colour);
      }
      apart.frame.finish();
    }
    together.frame.finish();
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        ASSERT_EQ(together.pixel(x, y), apart.pixel(x, y)) << round << ": " << x << ", " << y;
      }
    }
  }
}

TEST(TileDepth, HidesWhatLiesBehind) {
  std::vector<uint32_t> memory(kTilePixels);
  UniformTiles uniform{{0xffffffffu}, {1000u << 8}};
  TileDepth depth(TilePlane(memory.data(), uniform, 0));
  EXPECT_TRUE(depth.hides(CompareFunc::kLess, {1000, 2000}));
  EXPECT_FALSE(depth.hides(CompareFunc::kLessEqual, {1000, 2000}));
  EXPECT_TRUE(depth.hides(CompareFunc::kGreaterEqual, {10, 999}));
  EXPECT_FALSE(depth.hides(CompareFunc::kAlways, {10, 999}));
  DepthRule rule;
  rule.write = true;
  rule.func = CompareFunc::kLess;
  depth.drawn(rule, {100, 200}, false);
  EXPECT_FALSE(depth.hides(CompareFunc::kLess, {300, 400}));
  EXPECT_FALSE(depth.hides(CompareFunc::kGreaterEqual, {150, 160}));
  depth.drawn(rule, {100, 200}, true);
  EXPECT_TRUE(depth.hides(CompareFunc::kLess, {300, 400}));
  rule.discards = true;
  depth.drawn(rule, {10, 20}, true);
  EXPECT_FALSE(depth.hides(CompareFunc::kLess, {100, 110}));
  rule.func = CompareFunc::kAlways;
  depth.drawn(rule);
  EXPECT_FALSE(depth.hides(CompareFunc::kLess, {300, 400}));
  depth.cleared(150, true);
  EXPECT_TRUE(depth.hides(CompareFunc::kLess, {300, 400}));
  depth.cleared(350, false);
  EXPECT_FALSE(depth.hides(CompareFunc::kLess, {300, 400}));
}

// may_hide() is asked first: whatever hides() says yes to, it must.
TEST(TileDepth, MayHideWhereverSomethingIsHidden) {
  std::mt19937 random(3);
  std::vector<uint32_t> memory(kTilePixels);
  for (int round = 0; round < 4000; ++round) {
    constexpr uint32_t kSome[] = {0, 1, 500, 0xfffffe, 0xffffff};
    UniformTiles uniform{{0xffffffffu}, {kSome[random() % 5] << 8}};
    TileDepth depth(TilePlane(memory.data(), uniform, 0));
    if (random() % 2 == 0) depth.cleared(kSome[random() % 5], false);
    DepthRule rule;
    rule.test = rule.traceless = true;
    rule.func = static_cast<CompareFunc>(random() % 8);
    DepthRange range{kSome[random() % 5], kSome[random() % 5]};
    if (range.least > range.most) std::swap(range.least, range.most);
    // A primitive at the far or the near end, which nothing is behind of, is drawn for nothing.
    if (range.least == 0xffffff || range.most == 0) continue;
    EXPECT_TRUE(depth.may_hide(rule) || !depth.hides(rule.func, range)) << round;
  }
}

}  // namespace
}  // namespace clearpipe::pipeline
