// Vertices that packets share: a large indexed draw against the same triangles without indices.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/shared_vertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "pipeline/exec/frame_scene.h"
#include "pipeline/exec/index_range.h"
#include "pipeline/exec/triangle_corners.h"

namespace clearpipe::pipeline {
namespace {

constexpr int kGrid = 40;  // 3200 triangles, some packets

// A bent grid with a colour at each vertex, and `unused` vertices before it.
struct Grid {
  std::vector<float> positions, colours;
  std::vector<uint32_t> indices;

  explicit Grid(int unused) {
    for (int i = 0; i < unused; ++i) add_vertex(0.9f, -0.9f, 0);
    for (int y = 0; y <= kGrid; ++y) {
      for (int x = 0; x <= kGrid; ++x) {
        const float u = static_cast<float>(x) / kGrid, v = static_cast<float>(y) / kGrid;
        add_vertex(2.2f * u - 1.1f, 1.8f * v - 0.9f, 0.3f * std::sin(7 * u + 5 * v));
      }
    }
    for (int y = 0; y < kGrid; ++y) {
      for (int x = 0; x < kGrid; ++x) {
        const uint32_t corner = static_cast<uint32_t>(unused + y * (kGrid + 1) + x);
        for (const uint32_t step : {0, 1, kGrid + 1, 1, kGrid + 2, kGrid + 1}) {
          indices.push_back(corner + step);
        }
      }
    }
  }

  void add_vertex(float x, float y, float z) {
    positions.insert(positions.end(), {x, y, z});
    colours.insert(colours.end(), {std::fabs(x), std::fabs(y), z + 0.5f});
  }
};

void set_array(DrawCommand& command, Attribute attribute, const std::vector<float>& values) {
  AttributeSource& source = command.attributes[static_cast<int>(attribute)];
  source.is_array = true;
  source.size = 3;
  source.stride = 12;
  source.pointer = reinterpret_cast<const std::byte*>(values.data());
}

std::vector<uint32_t> pixels_of(const Grid& grid, const void* indices, IndexType type) {
  Scene scene;
  scene.fragment.depth_test = true;
  scene.vertex.clip_planes = 1;  // cuts some triangles
  scene.vertex.clip_plane[0] = {1, 0.3f, 0, 0.8f};
  scene.frame.set_vertex_state(scene.vertex);
  scene.frame.set_raster_state(scene.raster);
  scene.frame.set_fragment_state(scene.fragment);
  ClearCommand clear;
  clear.rect = scene.raster.scissor;
  clear.colour = clear.depth = true;
  EXPECT_TRUE(scene.frame.clear(clear));
  DrawCommand command;
  command.count = static_cast<uint32_t>(grid.indices.size());
  for (AttributeSource& source : command.attributes) source.constant = {0, 0, 0, 1};
  set_array(command, Attribute::kPosition, grid.positions);
  set_array(command, Attribute::kColour, grid.colours);
  command.index_type = type;
  command.indices = static_cast<const std::byte*>(indices);
  EXPECT_TRUE(scene.frame.draw(command));
  scene.frame.finish();
  std::vector<uint32_t> pixels(kWidth * kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) pixels[y * kWidth + x] = scene.pixel(x, y);
  }
  return pixels;
}

// The same triangles, each with vertices of its own.
Grid without_indices(const Grid& grid) {
  Grid apart(0);
  apart.positions.clear();
  apart.colours.clear();
  for (const uint32_t index : grid.indices) {
    for (int c = 0; c < 3; ++c) {
      apart.positions.push_back(grid.positions[3 * index + c]);
      apart.colours.push_back(grid.colours[3 * index + c]);
    }
  }
  return apart;
}

TEST(SharedVertices, AreThoseOfTheElements) {
  for (const int unused : {0, 77}) {
    const Grid grid(unused);
    const Grid apart = without_indices(grid);
    const std::vector<uint32_t> expected = pixels_of(apart, nullptr, IndexType::kNone);
    EXPECT_NE(expected[kWidth * 35 + 75], expected[kWidth * 20 + 40]);
    const std::vector<uint16_t> narrow(grid.indices.begin(), grid.indices.end());
    EXPECT_EQ(pixels_of(grid, grid.indices.data(), IndexType::kUnsignedInt), expected);
    EXPECT_EQ(pixels_of(grid, narrow.data(), IndexType::kUnsignedShort), expected);
  }
}

TEST(IndexRange, OfEveryTypeAndCount) {
  std::mt19937 random(3);
  for (size_t count = 1; count < 200; count += random() % 5 + 1) {
    std::vector<uint32_t> wide(count);
    for (uint32_t& index : wide) index = 3 + random() % 0xfffffffcu;
    std::vector<uint16_t> narrow(wide.begin(), wide.end());
    std::vector<uint8_t> bytes(count + 1);
    for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(random());
    const auto expect = [count](IndexType type, const auto* values) {
      const IndexRange range = index_range(type, reinterpret_cast<const std::byte*>(values), count);
      EXPECT_EQ(range.least, *std::min_element(values, values + count));
      EXPECT_EQ(range.greatest, *std::max_element(values, values + count));
    };
    expect(IndexType::kUnsignedInt, wide.data());
    expect(IndexType::kUnsignedShort, narrow.data());
    expect(IndexType::kUnsignedByte, bytes.data() + 1);
  }
}

TEST(TriangleCorners, OfEveryTypeAndCount) {
  std::mt19937 random(4);
  for (size_t triangles = 0; triangles < 100; ++triangles) {
    std::vector<uint32_t> wide(3 * triangles);
    for (uint32_t& index : wide) index = static_cast<uint32_t>(random());
    const std::vector<uint16_t> narrow(wide.begin(), wide.end());
    std::vector<uint8_t> bytes{0};
    bytes.insert(bytes.end(), wide.begin(), wide.end());
    const auto first = static_cast<uint32_t>(random());
    const auto expect = [&](IndexType type, const auto* indices) {
      constexpr int32_t kUntouched = 77;
      std::vector<int32_t> corners[3];
      for (auto& corner : corners) corner.resize(triangles + 1, kUntouched);
      int32_t* const corner[3] = {corners[0].data(), corners[1].data(), corners[2].data()};
      triangle_corners(type, reinterpret_cast<const std::byte*>(indices), triangles, first, corner);
      for (size_t k = 0; k < 3; ++k) {
        for (size_t i = 0; i < triangles; ++i) {
          ASSERT_EQ(corner[k][i], static_cast<int32_t>(indices[3 * i + k] - first))
              << k << " " << i;
        }
        EXPECT_EQ(corner[k][triangles], kUntouched);
      }
    };
    expect(IndexType::kUnsignedInt, wide.data());
    expect(IndexType::kUnsignedShort, narrow.data());
    expect(IndexType::kUnsignedByte, bytes.data() + 1);
  }
}

// Which draws have them: large ones, whose elements lie close together.
TEST(SharedVertices, OfLargeDenseDraws) {
  DrawState state;
  state.clip.layout = make_vertex_layout({});
  const VertexState vertex;
  const Grid grid(1000);
  std::vector<uint32_t> scattered = grid.indices;
  scattered[5] = 4000000000u;
  DrawList draws;
  for (int i = 0; i < 4; ++i) {
    DrawRecord draw;
    draw.state = &state;
    draw.vertex = &vertex;
    draw.index_type = IndexType::kUnsignedInt;
    draw.count = static_cast<uint32_t>(grid.indices.size());
    draw.indices = reinterpret_cast<const std::byte*>(grid.indices.data());
    draw.index_base = 10;
    draws.push_back(draw);
  }
  draws[1].count = 300;
  draws[2].indices = reinterpret_cast<const std::byte*>(scattered.data());
  draws[3].index_type = IndexType::kNone;
  SharedVertices shared;
  Arena arena;
  shared.prepare(draws, 0, arena);
  EXPECT_NE(draws[0].shared, nullptr);
  EXPECT_EQ(draws[0].first_shared, 990u);
  EXPECT_EQ(shared.chunk_count(), 2u);  // 1681 vertices
  for (int i = 1; i < 4; ++i) EXPECT_EQ(draws[i].shared, nullptr) << i;
}

}  // namespace
}  // namespace clearpipe::pipeline
