// Strokes against the same lines in a state that no stroke is for, though it gives the same pixels:
// an alpha test that all pass. Runs on the SIMD target that CLEARPIPE_SIMD selects.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "pipeline/exec/frame_scene.h"

namespace clearpipe::pipeline {
namespace {

struct Lines {
  std::vector<float> xyz, rgba;
  uint32_t count() const { return static_cast<uint32_t>(xyz.size() / 3); }
};

// Ends of any kind: far and near, some on centres and corners of pixels, on rows, columns and
// diagonals, partly outside.
Lines random_lines(uint32_t seed, uint32_t count) {
  std::mt19937 engine(seed);
  const auto between = [&](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(engine);
  };
  const auto window = [](float pixels, int size) { return pixels * 2 / float(size) - 1; };
  Lines lines;
  float x = 0, y = 0;
  for (uint32_t i = 0; i < 2 * count; ++i) {
    if (i % 2 == 0) {
      x = between(-20, kWidth + 20);
      y = between(-20, kHeight + 20);
    } else {
      const float reach = i % 3 == 0 ? 3.0f : i % 5 == 0 ? 200.0f : 30.0f;
      const float dx = between(-reach, reach), dy = between(-reach, reach);
      x += i % 7 == 0 ? 0 : dx;
      y += i % 11 == 0 ? 0 : i % 13 == 0 ? dx : dy;
    }
    if (i % 6 < 2) {
      x = std::round(2 * x) / 2;
      y = std::round(2 * y) / 2;
    }
    lines.xyz.insert(lines.xyz.end(), {window(x, kWidth), window(y, kHeight),
                                       std::round(between(-4, 4)) / 4 + between(-0.1f, 0.1f)});
    for (int c = 0; c < 4; ++c) lines.rgba.push_back(between(-0.2f, 1.2f));
  }
  return lines;
}

void draw_lines(Scene& scene, const Lines& lines, Primitive primitive = Primitive::kLines) {
  scene.frame.set_vertex_state(scene.vertex);
  scene.frame.set_raster_state(scene.raster);
  scene.frame.set_fragment_state(scene.fragment);
  DrawCommand command;
  command.primitive = primitive;
  command.count = lines.count();
  for (AttributeSource& source : command.attributes) source.constant = {0, 0, 0, 1};
  command.attributes[static_cast<int>(Attribute::kPosition)] = floats(lines.xyz, 0, 3);
  command.attributes[static_cast<int>(Attribute::kColour)] = floats(lines.rgba, 0, 4);
  ASSERT_TRUE(scene.frame.draw(command));
}

// What `draw` does to a scene that `prepare` has made, with strokes and without.
template <class Prepare, class Draw>
void compare(const std::string& name, const Prepare& prepare, const Draw& draw) {
  Planes planes[2];
  for (const bool strokes : {false, true}) {
    Scene scene;
    scene.fragment.depth_test = true;
    prepare(scene);
    if (!strokes) {
      scene.fragment.alpha_test = true;
      scene.fragment.alpha_func = CompareFunc::kGreaterEqual;
      scene.fragment.alpha_reference = 0;
    }
    ClearCommand clear;
    clear.rect = {0, 0, kWidth, kHeight};
    clear.colour = clear.depth = clear.stencil = true;
    clear.depth_value = 0xbfffff;  // that of z = 0.5
    clear.stencil_value = 0x5a;
    clear.colour_value = 0x10203040;
    ASSERT_TRUE(scene.frame.clear(clear));
    draw(scene);
    scene.frame.finish();
    planes[strokes] = planes_of(scene);
  }
  EXPECT_TRUE(planes[0] == planes[1]) << name;
  const std::vector<uint32_t> nothing(planes[1].colour.size(), 0x10203040u);
  EXPECT_NE(planes[1].colour, nothing) << name;
}

template <class Prepare>
void compare(const std::string& name, const Prepare& prepare) {
  const Lines lines = random_lines(7, 300);
  compare(name, prepare, [&](Scene& scene) { draw_lines(scene, lines); });
}

TEST(Strokes, AreAsWideAsPolygons) {
  for (const float width :
       {0.5f, 1.0f, 1.5f, 2.0f, 2.4f, 3.0f, 4.0f, 5.0f, 7.0f, 8.0f, 9.0f, 13.0f, 16.0f, 16.6f}) {
    compare(std::to_string(width), [&](Scene& scene) { scene.raster.line_width = width; });
  }
}

TEST(Strokes, AreTestedAsOtherFragments) {
  for (const CompareFunc func :
       {CompareFunc::kLess, CompareFunc::kEqual, CompareFunc::kLessEqual, CompareFunc::kGreater,
        CompareFunc::kNotEqual, CompareFunc::kGreaterEqual, CompareFunc::kAlways}) {
    for (const bool write : {false, true}) {
      for (const float width : {1.0f, 3.0f}) {
        const auto prepare = [&](Scene& scene) {
          scene.fragment.depth_write = write;
          scene.fragment.depth_func = func;
          scene.raster.line_width = width;
        };
        // Lines over themselves have equal depths.
        const Lines lines = random_lines(5, 200);
        compare(std::to_string(static_cast<int>(func)) + (write ? " writes" : ""), prepare,
                [&](Scene& scene) {
                  if (func == CompareFunc::kEqual) {
                    scene.fragment.depth_func = CompareFunc::kLess;
                    draw_lines(scene, lines);
                    scene.fragment.depth_func = func;
                  }
                  draw_lines(scene, lines);
                });
      }
    }
  }
  compare("no test", [](Scene& scene) { scene.fragment.depth_test = false; });
}

TEST(Strokes, HaveTheColoursOfLines) {
  for (const float width : {1.0f, 4.0f}) {
    compare("flat", [&](Scene& scene) {
      scene.raster.flat_shade = true;
      scene.raster.line_width = width;
    });
    compare("perspective", [&](Scene& scene) {
      scene.vertex.model_view_projection.m[11] = 0.6f;  // w = 1 + 0.6 z
      scene.raster.line_width = width;
    });
    for (const ColourFormat format : {ColourFormat::kRgb565, ColourFormat::kRgba4}) {
      compare(std::to_string(static_cast<int>(format)), [&](Scene& scene) {
        scene.target.colour = make_colour_buffer(kWidth, kHeight, true, 1);
        scene.target.colour->format = format;
        scene.frame.set_target(scene.target);
        scene.raster.line_width = width;
      });
    }
  }
}

TEST(Strokes, AreInsideOfTheScissorBoxAndTheViewport) {
  for (const float width : {1.0f, 2.0f, 6.0f}) {
    for (const bool mirrored : {false, true}) {
      const auto prepare = [&](Scene& scene) {
        scene.target.mirrored = mirrored;
        scene.frame.set_target(scene.target);
        scene.raster.line_width = width;
      };
      compare("whole", prepare);
      compare("scissor", [&](Scene& scene) {
        prepare(scene);
        scene.raster.scissor = {30, 20, 131, 51};
      });
      compare("viewport", [&](Scene& scene) {
        prepare(scene);
        scene.raster.viewport = {100, 60, 0.5f, 90, 20, 0.5f};
      });
      // Far beyond the surface, some beyond the guard band, through its middle.
      Lines far;
      for (int i = -12; i < 12; ++i) {
        const float a = float(i) * 0.0003f, b = float(i % 5) * 0.0004f;
        far.xyz.insert(far.xyz.end(), {-1, a, 0.1f, 1, -b, 0.2f, b, 1, 0.1f, a, -1, 0.2f});
        for (int k = 0; k < 16; ++k) far.rgba.push_back(float(k + i + 20) / 50);
      }
      for (const float scale : {5000.0f, 30000.0f}) {
        compare(
            "far " + std::to_string(scale) + " " + std::to_string(width) +
                (mirrored ? " mirrored" : ""),
            [&](Scene& scene) {
              prepare(scene);
              scene.raster.viewport = {scale, scale, 0.5f, 75, 35, 0.5f};
            },
            [&](Scene& scene) { draw_lines(scene, far); });
      }
    }
  }
}

TEST(Strokes, MakeStripsAndLoops) {
  const Lines lines = random_lines(3, 400);
  for (const Primitive primitive : {Primitive::kLineStrip, Primitive::kLineLoop}) {
    compare(
        std::to_string(static_cast<int>(primitive)), [](Scene&) {},
        [&](Scene& scene) { draw_lines(scene, lines, primitive); });
  }
}

// Packets of many, and what is drawn before them, between them and after them.
TEST(Strokes, KeepTheirOrder) {
  const Lines many = random_lines(8, 9000), few = random_lines(9, 40);
  const std::vector<float> half = {-1, -1, 0.2f, 1, -1, 0.2f, -1, 1, 0.2f};
  compare(
      "order", [](Scene& scene) { scene.fragment.depth_func = CompareFunc::kLessEqual; },
      [&](Scene& scene) {
        scene.draw(half, {1, 0, 0, 1});
        draw_lines(scene, few);
        scene.fragment.depth_test = false;
        draw_lines(scene, many);
        scene.draw(half, {0, 1, 0, 1});
        draw_lines(scene, many, Primitive::kLineStrip);
        scene.fragment.depth_test = true;
        scene.draw(half, {0, 0, 1, 1}, Primitive::kPoints);
        draw_lines(scene, few);
      });
}

}  // namespace
}  // namespace clearpipe::pipeline
