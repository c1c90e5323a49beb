// Small draws, whose vertices share streams and jobs: each must look as if it were alone.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <vector>

#include "pipeline/exec/frame_scene.h"
#include "pipeline/exec/programs.h"

namespace clearpipe::pipeline {
namespace {

// A square of 4 pixels, the i-th of a row of them, as a list of triangles and as a strip.
std::vector<float> square(int i, bool strip) {
  const float x0 = 2.0f * (8 * static_cast<float>(i)) / kWidth - 1, x1 = x0 + 8.0f / kWidth;
  const float y0 = -1, y1 = -1 + 8.0f / kHeight;
  if (strip) return {x0, y0, 0, x1, y0, 0, x0, y1, 0, x1, y1, 0};
  return {x0, y0, 0, x1, y0, 0, x0, y1, 0, x0, y1, 0, x1, y0, 0, x1, y1, 0};
}

constexpr uint32_t kRed = 0xff0000ff, kGreen = 0xff00ff00, kBlue = 0xffff0000;

TEST(SmallDraws, KeepTheirCurrentColours) {
  Scene scene;
  for (int i = 0; i < 12; ++i) {
    scene.draw(square(i, false), i % 2 == 0 ? Vec4{1, 0, 0, 1} : Vec4{0, 1, 0, 1});
  }
  scene.frame.finish();
  for (int i = 0; i < 12; ++i) {
    EXPECT_EQ(scene.pixel(8 * i + 1, 1), i % 2 == 0 ? kRed : kGreen) << i;
    EXPECT_EQ(scene.pixel(8 * i + 6, 1), 0u) << i;
  }
}

TEST(SmallDraws, ListsAndStripsTakeTurns) {
  Scene scene;
  for (int i = 0; i < 16; ++i) {
    scene.draw(square(i, i % 3 == 0), {0, 0, 1, 1},
               i % 3 == 0 ? Primitive::kTriangleStrip : Primitive::kTriangles);
  }
  scene.frame.finish();
  for (int i = 0; i < 16; ++i) {
    for (int x = 0; x < 8; ++x) {
      EXPECT_EQ(scene.pixel(8 * i + x, 3), x < 4 ? kBlue : 0u) << i << " " << x;
    }
  }
}

// The vertices past the last whole triangle of a draw are none of the next draw's.
TEST(SmallDraws, OddVerticesOfAListAreIgnored) {
  Scene scene;
  std::vector<float> more = square(0, false);
  more.insert(more.end(), {1, 1, 0});
  scene.draw(more, {1, 0, 0, 1});
  scene.draw(square(1, false), {0, 1, 0, 1});
  scene.frame.finish();
  EXPECT_EQ(scene.pixel(1, 1), kRed);
  EXPECT_EQ(scene.pixel(9, 1), kGreen);
  EXPECT_EQ(scene.pixel(100, 50), 0u);
}

TEST(SmallDraws, AClearBetweenThemComesBetweenThem) {
  Scene scene;
  scene.draw(square(0, false), {1, 0, 0, 1});
  ClearCommand clear;
  clear.rect = {0, 0, kWidth, kHeight};
  clear.colour = true;
  clear.colour_value = kBlue;
  ASSERT_TRUE(scene.frame.clear(clear));
  scene.draw(square(1, false), {0, 1, 0, 1});
  scene.frame.finish();
  EXPECT_EQ(scene.pixel(1, 1), kBlue);
  EXPECT_EQ(scene.pixel(9, 1), kGreen);
}

// More vertices than one piece of a stream's memory holds, with a matrix that changes now and then.
TEST(SmallDraws, ManyOfThemWithMatrices) {
  Scene scene;
  for (int i = 0; i < 3000; ++i) {
    if (i % 100 == 0) {
      scene.vertex.model_view_projection = {};
      scene.vertex.model_view_projection.m[13] = 0.5f * static_cast<float>(i / 100 % 2);
    }
    scene.draw(square(i % 18, false), {1, 0, 0, 1});
  }
  scene.draw(square(5, false), {0, 0, 1, 1});
  scene.frame.finish();
  for (int i = 0; i < 18; ++i) EXPECT_EQ(scene.pixel(8 * i + 1, 1), kRed) << i;
  EXPECT_EQ(scene.pixel(41, 18), kBlue);  // 0.5 is 17.5 pixels
  EXPECT_EQ(scene.pixel(49, 18), kRed);
  EXPECT_EQ(scene.pixel(49, 30), 0u);
}

// A matrix for each draw, more of them than a batch of vertices holds: all come out of one job.
TEST(SmallDraws, EachWithAMatrixOfItsOwn) {
  Scene scene;
  for (int i = 0; i < 18 * 8; ++i) {
    scene.vertex.model_view_projection = {};
    scene.vertex.model_view_projection.m[12] = 2.0f * 8 * static_cast<float>(i % 18) / kWidth;
    scene.vertex.model_view_projection.m[13] = 2.0f * 8 * static_cast<float>(i / 18) / kHeight;
    const bool strip = i % 5 == 0;
    scene.draw(square(0, strip), i % 2 == 0 ? Vec4{1, 0, 0, 1} : Vec4{0, 0, 1, 1},
               strip ? Primitive::kTriangleStrip : Primitive::kTriangles);
  }
  scene.frame.finish();
  for (int i = 0; i < 18 * 8; ++i) {
    const int x = 8 * (i % 18), y = 8 * (i / 18);
    EXPECT_EQ(scene.pixel(x + 1, y + 1), i % 2 == 0 ? kRed : kBlue) << i;
    EXPECT_EQ(scene.pixel(x + 5, y + 1), 0u) << i;
  }
}

// What a fragment state was drawn with before is not what it is drawn with after other state
// changed, nor in the next frame.
TEST(SmallDraws, FragmentStatesComeBackToOtherState) {
  Scene scene;
  for (int frame = 0; frame < 2; ++frame) {
    for (int i = 0; i < 16; ++i) {
      scene.fragment.colour_mask = i % 2 == 0 ? 0xf : 0x1;
      scene.raster.cull = i / 4 % 2 == frame ? CullFace::kNone : CullFace::kFrontAndBack;
      scene.draw(square(i, false), {1, 0, 1, 1});
    }
    scene.frame.finish();
    for (int i = 0; i < 16; ++i) {
      const bool drawn = frame == 1 || i / 4 % 2 == 0;
      const uint32_t colour = i % 2 == 0 ? 0xffff00ffu : 0x000000ffu;
      EXPECT_EQ(scene.pixel(8 * i + 1, 1), drawn ? colour : 0u) << frame << " " << i;
    }
  }
}

TEST(SmallDraws, EachLitWithANormalMatrixOfItsOwn) {
  Scene scene;
  scene.vertex.lighting = true;
  scene.vertex.material.diffuse = {0, 1, 0, 1};
  Light& light = scene.vertex.lights[2];
  light.enabled = true;
  light.diffuse = {1, 1, 1, 1};
  light.position = {0, 0, 1, 0};
  light.half_vector = {0, 0, 1, 0};
  for (int i = 0; i < 18; ++i) {
    // The normal matrix turns the x axis to the light, or nowhere.
    scene.vertex.normal_matrix = {0, 0, i % 3 == 0 ? 1.0f : 0.0f, 0, 0, 0, 0, 0, 0};
    scene.normal = {1, 0, 0, 0};
    scene.draw(square(i, false), {1, 0, 0, 1});
  }
  scene.frame.finish();
  for (int i = 0; i < 18; ++i) {
    EXPECT_EQ(scene.pixel(8 * i + 1, 1), i % 3 == 0 ? kGreen : 0xff000000u) << i;
  }
}

// Elements of buffers are clamped to the last one, in a stream as elsewhere.
TEST(SmallDraws, IndicesPastTheBufferReadItsLastElement) {
  Scene scene;
  const std::vector<float> corners = square(0, true);
  auto store = std::make_shared<BufferData>(corners.size() * sizeof(float));
  std::memcpy(store->data(), corners.data(), store->size());
  scene.draw(square(3, false), {1, 0, 0, 1});
  DrawCommand command;
  for (AttributeSource& source : command.attributes) source.constant = {0, 0, 0, 1};
  command.attributes[static_cast<int>(Attribute::kColour)].constant = {0, 1, 0, 1};
  AttributeSource& position = command.attributes[static_cast<int>(Attribute::kPosition)];
  position.is_array = true;
  position.size = 3;
  position.stride = 12;
  position.pointer = store->data();
  position.buffer = &store;
  position.max_index = 3;
  const uint16_t indices[] = {0, 1, 2, 2, 1, 9};
  command.index_type = IndexType::kUnsignedShort;
  command.indices = reinterpret_cast<const std::byte*>(indices);
  command.count = 6;
  ASSERT_TRUE(scene.frame.draw(command));
  scene.frame.finish();
  EXPECT_EQ(scene.pixel(3, 3), kGreen);
  EXPECT_EQ(scene.pixel(25, 1), kRed);
}

TEST(ProgramTable, FindsAStateAgain) {
  ProgramTable table;
  FragmentState plain, blended;
  blended.blend.enabled = true;
  blended.blend.dst_rgb = BlendFactor::kOne;
  ProgramHolder& first = table.find(plain, {});
  ProgramHolder& second = table.find(blended, {});
  EXPECT_NE(&first, &second);
  EXPECT_EQ(&table.find(plain, {}), &first);
  EXPECT_EQ(&table.find(blended, {}), &second);
  EXPECT_NE(&table.find(plain, {.srgb = true}), &first);
  // What differs in nothing that the hash looks at differs nevertheless.
  FragmentState offset = plain;
  offset.sample_coverage_value = 0.5f;
  EXPECT_NE(&table.find(offset, {}), &first);
}

TEST(ProgramTable, HoldsImagesUntilTheFrameIsDone) {
  ProgramTable table;
  auto image = std::make_shared<Image>();
  FragmentState textured;
  textured.unit[3].enabled = true;
  textured.unit[3].image = image;
  table.find(textured, {});
  EXPECT_EQ(image.use_count(), 3);
  table.reset();
  EXPECT_EQ(image.use_count(), 2);
}

// The halves of rectangles by themselves, in states that differ in what has no effect, and in one
// draw, where they become one primitive (setup/pairs.h).
TEST(SmallDraws, HalvesOfRectanglesMakeTheSamePixels) {
  Scene apart, together;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> place(-1.05f, 1), unit(0, 1);
  for (int i = 0; i < 400; ++i) {
    const float x0 = place(random), y0 = place(random), z = place(random);
    const float x1 = x0 + 0.3f * unit(random), y1 = y0 + 0.5f * unit(random);
    const Vec4 colour{unit(random), unit(random), unit(random), unit(random)};
    const bool blend = random() % 2 == 0, offset = random() % 4 == 0;
    for (Scene* scene : {&apart, &together}) {
      scene->fragment.depth_test = scene->fragment.depth_write = true;
      scene->fragment.depth_func = CompareFunc::kLess;
      scene->fragment.blend.enabled = blend;
      scene->fragment.blend.src_rgb = BlendFactor::kSrcAlpha;
      scene->fragment.blend.dst_rgb = BlendFactor::kOne;
      scene->raster.offset_fill = offset;
      scene->raster.offset_factor = scene->raster.offset_units = 3;
    }
    together.draw({x0, y0, z, x1, y0, z, x0, y1, z, x1, y1, z}, colour, Primitive::kTriangleStrip);
    apart.draw({x0, y0, z, x1, y0, z, x0, y1, z}, colour);
    apart.fragment.alpha_reference = 1 - apart.fragment.alpha_reference;
    apart.draw({x0, y1, z, x1, y0, z, x1, y1, z}, colour);
  }
  apart.frame.finish();
  together.frame.finish();
  EXPECT_EQ(planes_of(apart), planes_of(together));
}

TEST(Surface, RectanglesReadAsTheirRows) {
  Scene scene;
  scene.draw({-1, -1, 0, 0.7f, -0.2f, 0, -1, 1, 0}, {1, 0.25f, 0, 1});
  scene.draw(square(3, false), {0, 1, 0, 1});
  scene.frame.finish();
  const int x = 13, y = 9, count = 120, rows = 50, step = 130;
  std::vector<uint32_t> read(static_cast<size_t>(step) * rows, 7);
  read_rectangle(*scene.target.colour, x, y, count, rows, read.data(), step * sizeof(uint32_t));
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < step; ++i) {
      const uint32_t expected = i < count ? scene.pixel(x + i, y + j) : 7;
      ASSERT_EQ(read[static_cast<size_t>(j * step + i)], expected) << i << "," << j;
    }
  }
}

}  // namespace
}  // namespace clearpipe::pipeline
