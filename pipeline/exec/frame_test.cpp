// A frame as a whole: draws and clears through every stage into a surface.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <vector>

#include "pipeline/exec/frame_scene.h"

namespace clearpipe::pipeline {
namespace {

const std::vector<float> kWholeView = {-1, -1, 0, 3, -1, 0, -1, 3, 0};

TEST(Frame, ClearFillsItsRectangleOnly) {
  Scene scene;
  ClearCommand clear;
  clear.rect = {10, 5, 140, 60};
  clear.colour = true;
  clear.colour_value = 0xff336699;
  ASSERT_TRUE(scene.frame.clear(clear));
  scene.frame.finish();
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool inside = x >= 10 && x < 140 && y >= 5 && y < 60;
      ASSERT_EQ(scene.pixel(x, y), inside ? 0xff336699u : 0u) << x << "," << y;
    }
  }
}

TEST(Frame, ATriangleOverTheViewCoversEveryPixel) {
  Scene scene;
  scene.draw(kWholeView, {1, 0.5f, 0, 1});
  scene.frame.finish();
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      ASSERT_EQ(scene.pixel(x, y), 0xff0080ffu) << x << "," << y;
    }
  }
}

TEST(Frame, LowerLeftIsRowZero) {
  Scene scene;
  scene.draw({-1, -1, 0, 0, -1, 0, -1, 0, 0}, {1, 1, 1, 1});
  scene.frame.finish();
  EXPECT_EQ(scene.pixel(0, 0), 0xffffffffu);
  EXPECT_EQ(scene.pixel(kWidth - 1, 0), 0u);
  EXPECT_EQ(scene.pixel(0, kHeight - 1), 0u);
}

TEST(Frame, DepthTestKeepsTheNearer) {
  Scene scene;
  ClearCommand clear;
  clear.rect = {0, 0, kWidth, kHeight};
  clear.depth = clear.stencil = clear.colour = true;
  ASSERT_TRUE(scene.frame.clear(clear));
  scene.fragment.depth_test = true;
  scene.draw(kWholeView, {0, 1, 0, 1});
  scene.draw({-1, -1, 0.5f, 3, -1, 0.5f, -1, 3, 0.5f}, {1, 0, 0, 1});
  scene.frame.finish();
  EXPECT_EQ(scene.pixel(70, 30), 0xff00ff00u);
}

TEST(Frame, ManyPrimitivesKeepTheirOrder) {
  Scene scene;
  std::vector<float> triangles;
  for (int i = 0; i < 3000; ++i) {
    triangles.insert(triangles.end(), kWholeView.begin(), kWholeView.end());
  }
  scene.draw(triangles, {0, 0, 1, 1});
  scene.draw(kWholeView, {1, 0, 0, 1});
  scene.frame.finish();
  EXPECT_EQ(scene.pixel(75, 35), 0xff0000ffu);
}

}  // namespace
}  // namespace clearpipe::pipeline
