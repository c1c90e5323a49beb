// A frame with a target and state of its own, for tests.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "pipeline/exec/frame.h"

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

}  // namespace clearpipe::pipeline
