// A draw or a clear as api/ hands it to the pipeline.
//
// Client memory named here is only borrowed for the duration of Frame::draw; a frame that reads a
// buffer object later holds its data store until it is done.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "pipeline/image_memory.h"
#include "pipeline/state.h"

namespace clearpipe::pipeline {

// The data store of a buffer object. Replaced, never changed, while a frame holds it. One that is
// made by its size has no values yet.
using BufferData = std::vector<std::byte, ImageAllocator<std::byte>>;
using BufferRef = std::shared_ptr<BufferData>;

enum class Primitive : uint8_t {
  kPoints,
  kLines,
  kLineLoop,
  kLineStrip,
  kTriangles,
  kTriangleStrip,
  kTriangleFan
};

enum class ComponentType : uint8_t { kByte, kUnsignedByte, kShort, kFixed, kFloat };

// The attributes of a vertex, in the order the vertex stages keep them.
enum class Attribute : uint8_t {
  kPosition,
  kNormal,
  kColour,
  kPointSize,
  kTexCoord0,
  kTexCoord1,
  kTexCoord2,
  kTexCoord3,
  kTexCoord4,
  kTexCoord5,
  kTexCoord6,
  kTexCoord7,
  kMatrixIndex,
  kWeight
};
inline constexpr int kAttributeCount = 14;

// Where one attribute comes from (2.8).
struct AttributeSource {
  bool is_array = false;  // else: `constant` for every vertex
  ComponentType type = ComponentType::kFloat;
  uint8_t size = 4;                    // components per element; missing ones are 0,0,0,1
  bool normalized = false;             // integers map to [0,1] or [-1,1] (table 2.7)
  uint32_t stride = 0;                 // bytes between elements, never 0 for arrays
  const std::byte* pointer = nullptr;  // first element: client memory or inside `buffer`
  const BufferRef* buffer = nullptr;   // set when `pointer` lies in a buffer object
  uint32_t max_index = 0xffffffffu;  // largest element inside `buffer`; larger indices are clamped
  Vec4 constant;
};

enum class IndexType : uint8_t { kNone, kUnsignedByte, kUnsignedShort, kUnsignedInt };

struct DrawCommand {
  Primitive primitive = Primitive::kTriangles;
  std::array<AttributeSource, kAttributeCount> attributes;
  uint32_t first = 0;  // for IndexType::kNone
  uint32_t count = 0;
  IndexType index_type = IndexType::kNone;
  const std::byte* indices = nullptr;  // client memory or inside `index_buffer`
  const BufferRef* index_buffer = nullptr;
};

// glClear (4.2.3): planes are cleared inside `rect`, respecting the masks.
struct ClearCommand {
  Rect rect;
  bool colour = false, depth = false, stencil = false;
  uint32_t colour_value = 0;  // RGBA8, already converted
  uint8_t colour_mask = 0xf;
  uint32_t depth_value = 0xffffff;  // as many bits as the buffer has
  uint8_t stencil_value = 0, stencil_mask = 0xff;
};

}  // namespace clearpipe::pipeline
