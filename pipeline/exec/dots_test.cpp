// Dots against the same points in draws that are too small for dots: the same pixels and depths,
// whatever the state. Runs on the SIMD target that CLEARPIPE_SIMD selects.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "pipeline/exec/dots.h"
#include "pipeline/exec/frame_scene.h"

namespace clearpipe::pipeline {
namespace {

constexpr uint32_t kPoints = 3000;

struct Points {
  std::vector<float> xyz, rgba;
};

// All over the surface, some outside of it, many in one place; a few are nowhere.
Points random_points(uint32_t seed) {
  std::mt19937 engine(seed);
  const auto between = [&](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(engine);
  };
  Points points;
  for (uint32_t i = 0; i < kPoints; ++i) {
    const float reach = i % 3 == 0 ? 0.05f : 1.1f;
    for (int axis = 0; axis < 2; ++axis) points.xyz.push_back(between(-reach, reach));
    points.xyz.push_back(std::round(between(-4, 4)) / 4);  // many depths are equal
    for (int c = 0; c < 4; ++c) points.rgba.push_back(between(-0.2f, 1.2f));
  }
  points.xyz[300] = std::numeric_limits<float>::quiet_NaN();
  points.xyz[601] = std::numeric_limits<float>::infinity();
  points.xyz[900] = 1e9f;
  points.xyz[1201] = -3e37f;
  return points;
}

// Draws them so many at a time.
void draw_points(Scene& scene, const Points& points, uint32_t at_once) {
  scene.frame.set_vertex_state(scene.vertex);
  scene.frame.set_raster_state(scene.raster);
  scene.frame.set_fragment_state(scene.fragment);
  for (uint32_t first = 0; first < kPoints; first += at_once) {
    DrawCommand command;
    command.primitive = Primitive::kPoints;
    command.count = std::min(at_once, kPoints - first);
    command.attributes[static_cast<int>(Attribute::kPosition)] = floats(points.xyz, first, 3);
    command.attributes[static_cast<int>(Attribute::kColour)] = floats(points.rgba, first, 4);
    command.attributes[static_cast<int>(Attribute::kPointSize)].constant.x =
        scene.vertex.point_size;
    ASSERT_TRUE(scene.frame.draw(command));
  }
}

// What `prepare` makes of two scenes, drawn as dots and in small draws.
template <class Prepare>
void compare(const std::string& name, const Prepare& prepare, bool expect_pixels = true) {
  const Points points = random_points(7);
  static_assert(kPoints > kLeastDots);
  Planes planes[2];
  for (const bool dots : {false, true}) {
    Scene scene;
    prepare(scene);
    ClearCommand clear;
    clear.rect = {0, 0, kWidth, kHeight};
    clear.colour = clear.depth = clear.stencil = true;
    clear.depth_value = 0xbfffff;  // that of z = 0.5
    clear.stencil_value = 0x5a;
    clear.colour_value = 0x10203040;
    ASSERT_TRUE(scene.frame.clear(clear));
    draw_points(scene, points, dots ? kPoints : kLeastDots - 28);
    scene.frame.finish();
    planes[dots] = planes_of(scene);
  }
  EXPECT_EQ(planes[0].colour, planes[1].colour) << name;
  EXPECT_EQ(planes[0].depth, planes[1].depth) << name;
  const bool changed =
      planes[1].colour != std::vector<uint32_t>(planes[1].colour.size(), 0x10203040u);
  EXPECT_EQ(changed, expect_pixels) << name;
}

TEST(Dots, AreThePointsOfSmallDraws) {
  for (const CompareFunc func :
       {CompareFunc::kNever, CompareFunc::kLess, CompareFunc::kEqual, CompareFunc::kLessEqual,
        CompareFunc::kGreater, CompareFunc::kNotEqual, CompareFunc::kGreaterEqual,
        CompareFunc::kAlways}) {
    for (const bool write : {false, true}) {
      const auto prepare = [&](Scene& scene) {
        scene.fragment.depth_test = true;
        scene.fragment.depth_write = write;
        scene.fragment.depth_func = func;
      };
      const bool some = func != CompareFunc::kNever;
      compare(std::to_string(static_cast<int>(func)) + (write ? " writes" : ""), prepare, some);
    }
  }
  compare("no test", [](Scene&) {});
}

TEST(Dots, AreInsideOfTheScissorBoxAndTheViewport) {
  compare("scissor", [](Scene& scene) { scene.raster.scissor = {30, 20, 131, 51}; });
  compare("viewport", [](Scene& scene) { scene.raster.viewport = {100, 60, 0.5f, 90, 20, 0.5f}; });
  compare("not mirrored", [](Scene& scene) {
    scene.target.mirrored = false;
    scene.frame.set_target(scene.target);
    scene.raster.scissor = {30, 20, 131, 51};
  });
}

TEST(Dots, HaveTheFormatOfTheSurface) {
  for (const ColourFormat format : {ColourFormat::kRgb565, ColourFormat::kRgba4}) {
    compare(std::to_string(static_cast<int>(format)), [&](Scene& scene) {
      scene.target.colour = make_colour_buffer(kWidth, kHeight, true, 1);
      scene.target.colour->format = format;
      scene.frame.set_target(scene.target);
    });
  }
}

// States that dots are not for come out the same, too.
TEST(Dots, AreNotAllPoints) {
  compare("blended", [](Scene& scene) {
    scene.fragment.blend.enabled = true;
    scene.fragment.blend.src_rgb = BlendFactor::kSrcAlpha;
  });
  compare("masked", [](Scene& scene) { scene.fragment.colour_mask = 5; });
  compare("alpha test", [](Scene& scene) {
    scene.fragment.alpha_test = true;
    scene.fragment.alpha_func = CompareFunc::kGreater;
    scene.fragment.alpha_reference = 0.5f;
  });
  compare("stencil", [](Scene& scene) {
    scene.fragment.stencil.enabled = true;
    scene.fragment.stencil.pass = StencilOp::kIncrement;
  });
  for (const float size : {1.4f, 1.5f, 1.6f, 3.0f}) {
    compare(std::to_string(size), [&](Scene& scene) { scene.vertex.point_size = size; });
  }
  compare("at least 3", [](Scene& scene) { scene.vertex.point_size_min = 3; });
  compare("sprites", [](Scene& scene) { scene.raster.point_sprite = true; });
  compare("smooth", [](Scene& scene) { scene.raster.point_smooth = true; });
}

// What is drawn before them and after them stays before and after.
TEST(Dots, KeepTheirOrder) {
  const Points points = random_points(8);
  const std::vector<float> cover = {-1, -1, 0, 3, -1, 0, -1, 3, 0};
  const std::vector<float> half = {-1, -1, 0, 1, -1, 0, -1, 1, 0};
  Planes planes[2];
  for (const bool dots : {false, true}) {
    const uint32_t at_once = dots ? kPoints : 50;
    Scene scene;
    scene.draw(cover, {0, 0, 1, 1});
    draw_points(scene, points, at_once);
    scene.draw(half, {1, 0, 0, 1});
    draw_points(scene, random_points(9), at_once);
    scene.fragment.blend.enabled = true;
    draw_points(scene, random_points(10), at_once);
    scene.fragment.blend.enabled = false;
    draw_points(scene, random_points(11), at_once);
    scene.frame.finish();
    planes[dots] = planes_of(scene);
  }
  EXPECT_EQ(planes[0].colour, planes[1].colour);
}

}  // namespace
}  // namespace clearpipe::pipeline
