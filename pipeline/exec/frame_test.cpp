// A frame as a whole: draws and clears through every stage into a surface.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/frame.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

namespace clearpipe::pipeline {
namespace {

constexpr int kWidth = 150, kHeight = 70;  // whole tiles and cut ones

struct Scene {
  Frame frame;
  Target target;
  VertexState vertex;
  RasterState raster;
  FragmentState fragment;

  Scene() {
    target.colour = make_colour_buffer(kWidth, kHeight, true);
    target.depth_stencil = make_depth_stencil_buffer(kWidth, kHeight, true, true);
    target.width = kWidth;
    target.height = kHeight;
    frame.set_target(target);
    raster.viewport = {kWidth / 2.0f, kHeight / 2.0f, 0.5f, kWidth / 2.0f, kHeight / 2.0f, 0.5f};
    raster.scissor = {0, 0, kWidth, kHeight};
  }

  void draw(const std::vector<float>& xyz, Vec4 colour) {
    frame.set_vertex_state(vertex);
    frame.set_raster_state(raster);
    frame.set_fragment_state(fragment);
    DrawCommand command;
    command.count = static_cast<uint32_t>(xyz.size() / 3);
    for (AttributeSource& source : command.attributes) source.constant = {0, 0, 0, 1};
    auto& position = command.attributes[static_cast<int>(Attribute::kPosition)];
    position.is_array = true;
    position.size = 3;
    position.stride = 12;
    position.pointer = reinterpret_cast<const std::byte*>(xyz.data());
    command.attributes[static_cast<int>(Attribute::kColour)].constant = colour;
    ASSERT_TRUE(frame.draw(command));
  }

  uint32_t pixel(int x, int y) const {
    store_uniform_tiles(*target.colour);
    return target.colour->pixels[y * kWidth + x];
  }
};

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
