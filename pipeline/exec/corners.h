// The corners of a range's primitives: which elements of the arrays they are (2.6.1), by code made
// for each kind of primitive and of index.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "pipeline/exec/frame_data.h"

namespace clearpipe::pipeline {

// The vertices of primitive `p`, numbered as the draw names them (2.6.1). The last is provoking;
// odd triangles of a strip exchange the first two, so that all have the strip's winding.
template <Primitive kPrimitive>
void primitive_vertices(uint32_t p, uint32_t count, uint32_t out[3]) {
  if constexpr (kPrimitive == Primitive::kPoints) {
    out[0] = p;
  } else if constexpr (kPrimitive == Primitive::kLines) {
    out[0] = 2 * p;
    out[1] = 2 * p + 1;
  } else if constexpr (kPrimitive == Primitive::kLineLoop) {
    out[0] = p;
    out[1] = p + 1 == count ? 0 : p + 1;
  } else if constexpr (kPrimitive == Primitive::kLineStrip) {
    out[0] = p;
    out[1] = p + 1;
  } else if constexpr (kPrimitive == Primitive::kTriangles) {
    out[0] = 3 * p;
    out[1] = 3 * p + 1;
    out[2] = 3 * p + 2;
  } else if constexpr (kPrimitive == Primitive::kTriangleStrip) {
    out[0] = p + (p & 1);
    out[1] = p + 1 - (p & 1);
    out[2] = p + 2;
  } else {
    out[0] = 0;
    out[1] = p + 1;
    out[2] = p + 2;
  }
}

int corner_count(Primitive primitive) {
  switch (primitive) {
    case Primitive::kPoints:
      return 1;
    case Primitive::kLines:
    case Primitive::kLineLoop:
    case Primitive::kLineStrip:
      return 2;
    default:
      return 3;
  }
}

// Calls f(corner, primitive of the range, element) for each corner of a range, in order.
template <Primitive kPrimitive, class ElementOf, class F>
void for_each_corner_of(const DrawRecord& draw, const PacketRange& range,
                        const ElementOf& element_of, const F& f) {
  const int corners = corner_count(kPrimitive);
  for (uint32_t i = 0; i < range.primitive_count; ++i) {
    uint32_t vertex[3];
    primitive_vertices<kPrimitive>(range.first_primitive + i, draw.count, vertex);
    for (int k = 0; k < corners; ++k) f(k, i, element_of(vertex[k]));
  }
}

template <class ElementOf, class F>
void for_each_corner_with(const DrawRecord& draw, const PacketRange& range,
                          const ElementOf& element_of, const F& f) {
  switch (draw.primitive) {
#define FOR_EACH_CORNER(primitive) \
  case Primitive::primitive:       \
    return for_each_corner_of<Primitive::primitive>(draw, range, element_of, f);
    FOR_EACH_CORNER(kPoints)
    FOR_EACH_CORNER(kLines)
    FOR_EACH_CORNER(kLineLoop)
    FOR_EACH_CORNER(kLineStrip)
    FOR_EACH_CORNER(kTriangles)
    FOR_EACH_CORNER(kTriangleStrip)
    FOR_EACH_CORNER(kTriangleFan)
#undef FOR_EACH_CORNER
  }
}

template <class Index>
auto indexed_elements(const DrawRecord& draw) {
  return [indices = draw.indices, base = draw.index_base](uint32_t vertex) {
    Index value;
    std::memcpy(&value, indices + sizeof(Index) * size_t{vertex}, sizeof(value));
    return value - base;
  };
}

template <class F>
void for_each_corner(const DrawRecord& draw, const PacketRange& range, const F& f) {
  switch (draw.index_type) {
    case IndexType::kNone: {
      const uint32_t first = draw.first - draw.index_base;
      return for_each_corner_with(
          draw, range, [first](uint32_t v) { return first + v; }, f);
    }
    case IndexType::kUnsignedByte:
      return for_each_corner_with(draw, range, indexed_elements<uint8_t>(draw), f);
    case IndexType::kUnsignedShort:
      return for_each_corner_with(draw, range, indexed_elements<uint16_t>(draw), f);
    case IndexType::kUnsignedInt:
      return for_each_corner_with(draw, range, indexed_elements<uint32_t>(draw), f);
  }
}

}  // namespace clearpipe::pipeline
