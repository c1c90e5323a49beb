// Vertices of large indexed draws: see shared_vertices.h.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/shared_vertices.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <numeric>

namespace clearpipe::pipeline {

namespace {

// Smaller draws make one packet, or two.
constexpr uint32_t kMinPrimitives = 2 * kPacketPrimitives;

struct ElementRange {
  uint32_t first = 0, last = 0;
};

template <class Index>
ElementRange used_elements(const std::byte* indices, uint32_t count) {
  Index least = std::numeric_limits<Index>::max(), greatest = 0;
  for (uint32_t i = 0; i < count; ++i) {
    Index value;
    std::memcpy(&value, indices + size_t{sizeof(Index)} * i, sizeof(value));
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  return {least, greatest};
}

ElementRange used_elements(const DrawRecord& draw) {
  switch (draw.index_type) {
    case IndexType::kNone:
      return {0, std::numeric_limits<uint32_t>::max()};
    case IndexType::kUnsignedByte:
      return used_elements<uint8_t>(draw.indices, draw.count);
    case IndexType::kUnsignedShort:
      return used_elements<uint16_t>(draw.indices, draw.count);
    case IndexType::kUnsignedInt:
      return used_elements<uint32_t>(draw.indices, draw.count);
  }
  return {};
}

}  // namespace

void SharedVertices::prepare(std::vector<DrawRecord>& draws, Arena& arena) {
  chunks_.clear();
  for (size_t d = 0; d < draws.size(); ++d) {
    DrawRecord& draw = draws[d];
    const uint32_t primitives = primitive_count(draw.primitive, draw.count);
    if (draw.index_type == IndexType::kNone || primitives < kMinPrimitives) continue;
    const ElementRange range = used_elements(draw);
    // With more vertices than primitives, packets by themselves transform no more.
    if (range.last - range.first >= primitives) continue;
    const uint32_t count = range.last - range.first + 1;
    const size_t stride = draw.state->clip.layout.stride;
    if (count * stride > size_t{std::numeric_limits<int32_t>::max()}) continue;
    float* records = arena.allocate_array<float>(count * stride);
    draw.shared = records;
    draw.first_shared = range.first - draw.index_base;
    for (uint32_t first = 0; first < count; first += kChunk) {
      chunks_.push_back({static_cast<uint32_t>(d), first, std::min(kChunk, count - first),
                         records + first * stride});
    }
  }
}

void SharedVertices::run(const std::vector<DrawRecord>& draws, size_t chunk) const {
  const Chunk& part = chunks_[chunk];
  const DrawRecord& draw = draws[part.draw];
  std::array<uint32_t, kChunk> elements;
  std::iota(elements.begin(), elements.begin() + part.count, draw.first_shared + part.first);
  run_vertex_stages(make_vertex_job(draw, elements.data(), part.count, part.records));
}

}  // namespace clearpipe::pipeline
