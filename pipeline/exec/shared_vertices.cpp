// Vertices of large indexed draws: see shared_vertices.h.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/shared_vertices.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "pipeline/exec/index_range.h"

namespace clearpipe::pipeline {

namespace {

// Smaller draws make one packet, or two.
constexpr uint32_t kMinPrimitives = 2 * kPacketPrimitives;

}  // namespace

void SharedVertices::prepare(DrawList& draws, size_t first, Arena& arena) {
  chunks_.clear();
  for (size_t d = first; d < draws.size(); ++d) {
    DrawRecord& draw = draws[d];
    const uint32_t primitives = primitive_count(draw.primitive, draw.count);
    if (draw.index_type == IndexType::kNone || primitives < kMinPrimitives) continue;
    const IndexRange range = index_range(draw.index_type, draw.indices, draw.count);
    // With more vertices than primitives, packets by themselves transform no more.
    if (range.greatest - range.least >= primitives) continue;
    const uint32_t count = range.greatest - range.least + 1;
    const size_t stride = draw.state->clip.layout.stride;
    if (count * stride > size_t{std::numeric_limits<int32_t>::max()}) continue;
    float* records = arena.allocate_array<float>(count * stride);
    draw.shared = records;
    draw.first_shared = range.least - draw.index_base;
    for (uint32_t at = 0; at < count; at += kChunk) {
      chunks_.push_back(
          {static_cast<uint32_t>(d), at, std::min(kChunk, count - at), records + at * stride});
    }
  }
}

void SharedVertices::run(const DrawList& draws, size_t chunk) const {
  const Chunk& part = chunks_[chunk];
  const DrawRecord& draw = draws[part.draw];
  std::array<uint32_t, kChunk> elements;
  std::iota(elements.begin(), elements.begin() + part.count, draw.first_shared + part.first);
  run_vertex_stages(make_vertex_job(draw, elements.data(), part.count, part.records));
}

}  // namespace clearpipe::pipeline
