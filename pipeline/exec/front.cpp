// The front phase of a packet: elements -> vertex records -> primitives -> clip -> setup -> bins.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstring>
#include <span>

#include "pipeline/exec/frame_data.h"

namespace clearpipe::pipeline {

uint32_t primitive_count(Primitive primitive, uint32_t count) {
  switch (primitive) {
    case Primitive::kPoints:
      return count;
    case Primitive::kLines:
      return count / 2;
    case Primitive::kLineLoop:
      return count < 2 ? 0 : count;
    case Primitive::kLineStrip:
      return count < 2 ? 0 : count - 1;
    case Primitive::kTriangles:
      return count / 3;
    case Primitive::kTriangleStrip:
    case Primitive::kTriangleFan:
      return count < 3 ? 0 : count - 2;
  }
  return 0;
}

uint32_t corners_of(Primitive primitive) {
  switch (primitive) {
    case Primitive::kPoints:
      return 1;
    case Primitive::kLines:
      return 2;
    case Primitive::kTriangles:
      return 3;
    default:
      return 0;
  }
}

namespace {

// The vertices of primitive `p`, numbered as the draw names them (2.6.1). The last is provoking;
// odd triangles of a strip exchange the first two, so that all have the strip's winding.
int primitive_vertices(Primitive primitive, uint32_t p, uint32_t count, uint32_t out[3]) {
  switch (primitive) {
    case Primitive::kPoints:
      out[0] = p;
      return 1;
    case Primitive::kLines:
      out[0] = 2 * p;
      out[1] = 2 * p + 1;
      return 2;
    case Primitive::kLineLoop:
      out[0] = p;
      out[1] = p + 1 == count ? 0 : p + 1;
      return 2;
    case Primitive::kLineStrip:
      out[0] = p;
      out[1] = p + 1;
      return 2;
    case Primitive::kTriangles:
      out[0] = 3 * p;
      out[1] = 3 * p + 1;
      out[2] = 3 * p + 2;
      return 3;
    case Primitive::kTriangleStrip:
      out[0] = p + (p & 1);
      out[1] = p + 1 - (p & 1);
      out[2] = p + 2;
      return 3;
    case Primitive::kTriangleFan:
      out[0] = 0;
      out[1] = p + 1;
      out[2] = p + 2;
      return 3;
  }
  return 0;
}

uint32_t element_index(const DrawRecord& draw, uint32_t vertex) {
  switch (draw.index_type) {
    case IndexType::kNone:
      return draw.first + vertex - draw.index_base;
    case IndexType::kUnsignedByte:
      return std::to_integer<uint32_t>(draw.indices[vertex]) - draw.index_base;
    case IndexType::kUnsignedShort: {
      uint16_t value;
      std::memcpy(&value, draw.indices + size_t{2} * vertex, sizeof(value));
      return value - draw.index_base;
    }
    case IndexType::kUnsignedInt: {
      uint32_t value;
      std::memcpy(&value, draw.indices + size_t{4} * vertex, sizeof(value));
      return value - draw.index_base;
    }
  }
  return 0;
}

}  // namespace

// Whether the vertices of both draws can come out of one vertex job.
bool share_job(const DrawRecord& a, const DrawRecord& b) {
  return a.sources == b.sources && a.state->vertex_group == b.state->vertex_group;
}

// The scratch memory of one worker: the elements of the ranges at hand with a table that finds an
// element already listed, so that a vertex used by several primitives is transformed once.
class FrontWorker {
 public:
  void run(const std::vector<DrawRecord>& draws, const TileGrid& grid, Packet& packet) {
    packet.bins.reset(grid);
    packet.primitives.clear();
    const std::vector<PacketRange>& ranges = packet.ranges;
    for (size_t first = 0; first < ranges.size();) {
      const DrawRecord& draw = draws[ranges[first].draw];
      size_t end = first + 1;
      while (end < ranges.size() && share_job(draw, draws[ranges[end].draw])) ++end;
      run_ranges(draws, {ranges.data() + first, ranges.data() + end}, packet);
      first = end;
    }
    packet.bins.close();
  }

  void reset() { arena_.reset(); }

 private:
  static constexpr uint32_t kTableSize = 4096;  // a power of two, more than twice kPacketVertices
  static_assert(kTableSize >= 2 * kPacketVertices);

  uint16_t local_vertex(uint32_t element) {
    uint32_t slot = (element * 2654435761u) >> 20;
    while (table_generation_[slot] == generation_) {
      if (elements_[table_vertex_[slot]] == element) {
        return table_vertex_[slot];
      }
      slot = (slot + 1) & (kTableSize - 1);
    }
    table_generation_[slot] = generation_;
    table_vertex_[slot] = static_cast<uint16_t>(element_count_);
    elements_[element_count_] = element;
    return static_cast<uint16_t>(element_count_++);
  }

  // Lists the elements of a range, and of each corner of its primitives which of them it is.
  void list_elements(const DrawRecord& draw, const PacketRange& range) {
    uint16_t* corner = corner_.data() + corner_count_;
    const uint32_t first = range.first_primitive;
    if (draw.index_type == IndexType::kNone && corners_of(draw.primitive) != 0) {
      // Each vertex belongs to one primitive.
      const uint32_t corners = corners_of(draw.primitive) * range.primitive_count;
      const uint32_t element = element_index(draw, corners_of(draw.primitive) * first);
      for (uint32_t i = 0; i < corners; ++i) {
        elements_[element_count_] = element + i;
        corner[i] = static_cast<uint16_t>(element_count_++);
      }
      corner_count_ += corners;
      return;
    }
    for (uint32_t i = 0; i < range.primitive_count; ++i) {
      uint32_t vertex[3] = {};
      const int corners = primitive_vertices(draw.primitive, first + i, draw.count, vertex);
      for (int k = 0; k < corners; ++k) *corner++ = local_vertex(element_index(draw, vertex[k]));
    }
    corner_count_ = static_cast<uint32_t>(corner - corner_.data());
  }

  // Ranges of draws whose vertices come out of one job.
  void run_ranges(const std::vector<DrawRecord>& draws, std::span<const PacketRange> ranges,
                  Packet& packet) {
    ++generation_;
    element_count_ = corner_count_ = 0;
    for (const PacketRange& range : ranges) list_elements(draws[range.draw], range);
    const DrawRecord& draw = draws[ranges[0].draw];
    const ClipState& clip = draw.state->clip;
    const int stride = clip.layout.stride;
    float* records = static_cast<float*>(arena_.allocate(sizeof(float) * stride * element_count_));
    VertexJob job;
    job.draw = draw.sources;
    job.state = draw.state->vertex;
    job.viewport = clip.viewport;
    job.guard = clip.guard;
    job.layout = clip.layout;
    job.elements = elements_.data();
    job.count = element_count_;
    job.records = records;
    run_vertex_stages(job);
    const uint16_t* corner = corner_.data();
    for (const PacketRange& range : ranges) {
      corner = emit_range(draws[range.draw], range, records, corner, packet);
    }
  }

  // Primitives from the records of their vertices; returns the corners that follow.
  const uint16_t* emit_range(const DrawRecord& draw, const PacketRange& range, float* records,
                             const uint16_t* corner, Packet& packet) {
    uint32_t unused[3];
    const int corners = primitive_vertices(draw.primitive, 0, draw.count, unused);
    const int stride = draw.state->clip.layout.stride;
    for (uint32_t i = 0; i < range.primitive_count; ++i, corner += corners) {
      const float* v[3] = {};
      uint32_t any = 0, all = ~0u;
      for (int k = 0; k < corners; ++k) {
        v[k] = records + static_cast<size_t>(corner[k]) * stride;
        uint32_t outcode;
        std::memcpy(&outcode, v[k] + vertex_record::kOutcode, sizeof(outcode));
        any |= outcode;
        all &= outcode;
      }
      if (all != 0 && (all & ~uint32_t{kOutcodeGuard}) != 0) {
        continue;  // outside one plane as a whole
      }
      emit(*draw.state, range.draw, corners, v, any, packet);
    }
    return corner;
  }

  void emit(const DrawState& draw, uint32_t draw_index, int corners, const float* v[3],
            uint32_t outcodes, Packet& packet) {
    PrimitiveRecord record;
    record.draw = draw_index;
    if (corners == 3) {
      if (outcodes == 0) {
        add(setup_triangle(draw.setup, v[0], v[1], v[2], record), record, packet);
        return;
      }
      const float* polygon[kMaxClippedCorners];
      const int count = clip_triangle(draw.clip, v, outcodes, arena_, polygon);
      for (int i = 2; i < count; ++i) {
        PrimitiveRecord piece = record;
        add(setup_triangle(draw.setup, polygon[0], polygon[i - 1], polygon[i], piece), piece,
            packet);
      }
    } else if (corners == 2) {
      if (outcodes == 0 || clip_line(draw.clip, v, outcodes, arena_)) {
        add(setup_line(draw.setup, v[0], v[1], record), record, packet);
      }
    } else if (outcodes == 0) {
      add(setup_point(draw.setup, v[0], record), record, packet);
    }
  }

  static void add(bool visible, const PrimitiveRecord& record, Packet& packet) {
    if (visible) {
      packet.bins.add(record, static_cast<uint32_t>(packet.primitives.size()));
      packet.primitives.push_back(record);
    }
  }

  Arena arena_;
  uint32_t element_count_ = 0, corner_count_ = 0;
  std::array<uint32_t, kPacketVertices> elements_;
  std::array<uint16_t, kPacketVertices> corner_;
  uint32_t generation_ = 0;
  std::array<uint32_t, kTableSize> table_generation_{};
  std::array<uint16_t, kTableSize> table_vertex_{};
};

FrontWorkerPtr make_front_worker() { return FrontWorkerPtr(new FrontWorker); }
void FrontWorkerDeleter::operator()(FrontWorker* worker) const { delete worker; }
void reset_front_worker(FrontWorker& worker) { worker.reset(); }

void run_front(FrontWorker& worker, const std::vector<DrawRecord>& draws, const TileGrid& grid,
               Packet& packet) {
  worker.run(draws, grid, packet);
}

}  // namespace clearpipe::pipeline
