// A frame with a target and state of its own, for tests.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "pipeline/exec/frame.h"
#include "pipeline/raster/tile.h"

namespace clearpipe::pipeline {

inline constexpr int kWidth = 150, kHeight = 70;  // whole tiles and cut ones

struct Scene {
  Frame frame;
  Target target;
  VertexState vertex;
  RasterState raster;
  FragmentState fragment;
  Vec4 normal{0, 0, 0, 1};

  explicit Scene(int samples = 1) {
    target.colour = make_colour_buffer(kWidth, kHeight, true, samples);
    target.depth_stencil = make_depth_stencil_buffer(kWidth, kHeight, true, true, samples);
    target.width = kWidth;
    target.height = kHeight;
    frame.set_target(target);
    raster.viewport = {kWidth / 2.0f, kHeight / 2.0f, 0.5f, kWidth / 2.0f, kHeight / 2.0f, 0.5f};
    raster.scissor = {0, 0, kWidth, kHeight};
  }

  void draw(const std::vector<float>& xyz, Vec4 colour,
            Primitive primitive = Primitive::kTriangles) {
    frame.set_vertex_state(vertex);
    frame.set_raster_state(raster);
    frame.set_fragment_state(fragment);
    DrawCommand command;
    command.primitive = primitive;
    command.count = static_cast<uint32_t>(xyz.size() / 3);
    for (AttributeSource& source : command.attributes) source.constant = {0, 0, 0, 1};
    auto& position = command.attributes[static_cast<int>(Attribute::kPosition)];
    position.is_array = true;
    position.size = 3;
    position.stride = 12;
    position.pointer = reinterpret_cast<const std::byte*>(xyz.data());
    command.attributes[static_cast<int>(Attribute::kColour)].constant = colour;
    command.attributes[static_cast<int>(Attribute::kNormal)].constant = normal;
    command.attributes[static_cast<int>(Attribute::kPointSize)].constant.x = vertex.point_size;
    ASSERT_TRUE(frame.draw(command));
  }

  uint32_t pixel(int x, int y) const {
    uint32_t value = 0;
    read_pixels(*target.colour, x, y, 1, &value);
    return value;
  }
};

// An array of so many floats for each vertex, from one of them on.
inline AttributeSource floats(const std::vector<float>& values, size_t first, uint8_t size) {
  AttributeSource source;
  source.is_array = true;
  source.size = size;
  source.stride = size * uint32_t{sizeof(float)};
  source.pointer = reinterpret_cast<const std::byte*>(values.data() + first * size);
  return source;
}

// What a finished scene has in its surface, row by row.
struct Planes {
  std::vector<uint32_t> colour, depth;
  bool operator==(const Planes&) const = default;
};

inline Planes planes_of(const Scene& scene) {
  Planes planes{std::vector<uint32_t>(kWidth * kHeight), std::vector<uint32_t>(kWidth * kHeight)};
  const DepthStencilBuffer& depths = *scene.target.depth_stencil;
  for (int y = 0; y < kHeight; ++y) {
    read_pixels(*scene.target.colour, 0, y, kWidth, planes.colour.data() + y * kWidth);
    for (int x = 0; x < kWidth; ++x) {
      const size_t place = place_in_tiles(kWidth, x, y), tile = place / kTilePixels;
      planes.depth[size_t(y) * kWidth + size_t(x)] =
          depths.uniform->is_uniform(tile) ? depths.uniform->value[tile] : depths.values[place];
    }
  }
  return planes;
}

}  // namespace clearpipe::pipeline
