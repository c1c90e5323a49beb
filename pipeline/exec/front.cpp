// The front phase of a packet: elements -> vertex records -> primitives -> clip -> setup -> bins.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstring>
#include <span>

#include "pipeline/exec/frame_data.h"
#include "pipeline/exec/small.h"
#include "pipeline/setup/triangles.h"

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
    packet.bins.reset(grid, tile_numbers_);
    packet.primitives.clear();
    packet.small.clear();
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
    for (uint32_t i = 0; i < range.primitive_count; ++i, ++primitive_count_) {
      uint32_t vertex[3] = {};
      const int corners =
          primitive_vertices(draw.primitive, range.first_primitive + i, draw.count, vertex);
      // Lines and points may lie in the lanes behind the last triangle: no corner is left open.
      for (int k = 0; k < 3; ++k) {
        triangles_.corner[k][primitive_count_] =
            k < corners ? local_vertex(element_index(draw, vertex[k])) : 0;
      }
    }
  }

  // Ranges of draws whose vertices come out of one job.
  void run_ranges(const std::vector<DrawRecord>& draws, std::span<const PacketRange> ranges,
                  Packet& packet) {
    ++generation_;
    element_count_ = primitive_count_ = 0;
    for (const PacketRange& range : ranges) list_elements(draws[range.draw], range);
    for (auto& corner : triangles_.corner) {
      std::fill_n(corner.begin() + primitive_count_, kTriangleLanes, 0);
    }
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
    uint32_t first = 0;  // of a range's primitives in triangles_
    for (const PacketRange& range : ranges) {
      emit_range(draws[range.draw], range, records, first, packet);
      first += range.primitive_count;
    }
  }

  // Primitives from the records of their vertices.
  void emit_range(const DrawRecord& draw, const PacketRange& range, const float* records,
                  uint32_t first, Packet& packet) {
    uint32_t unused[3];
    const int corners = primitive_vertices(draw.primitive, 0, draw.count, unused);
    draws_small_ = draws_small(*draw.state);
    if (corners == 3 && draws_small_) {
      emit_triangles(*draw.state, range, records, first, packet);
      return;
    }
    for (uint32_t i = first; i < first + range.primitive_count; ++i) {
      emit_corners(*draw.state, range.draw, corners, records, i, packet);
    }
  }

  // Triangles that are settled many at once, and the others.
  void emit_triangles(const DrawState& draw, const PacketRange& range, const float* records,
                      uint32_t first, Packet& packet) {
    TriangleJob job;
    job.records = records;
    for (int k = 0; k < 3; ++k) job.corner[k] = triangles_.corner[k].data() + first;
    job.count = range.primitive_count;
    job.fate = triangles_.fate.data();
    job.x = triangles_.x.data();
    job.y = triangles_.y.data();
    job.mask_low = triangles_.mask_low.data();
    job.mask_high = triangles_.mask_high.data();
    setup_triangles(draw.setup, job);
    const int stride = draw.setup.layout.stride;
    for (uint32_t i = 0; i < range.primitive_count; ++i) {
      const auto fate = static_cast<TriangleFate>(triangles_.fate[i]);
      if (fate == TriangleFate::kNothing) continue;
      if (fate == TriangleFate::kGeneral) {
        emit_corners(draw, range.draw, 3, records, first + i, packet);
        continue;
      }
      SmallPrimitive small;
      for (int k = 0; k < 3; ++k) {
        small.vertex[k] = records + static_cast<ptrdiff_t>(job.corner[k][i]) * stride;
      }
      small.mask = static_cast<uint64_t>(triangles_.mask_high[i]) << 32 | triangles_.mask_low[i];
      small.x = static_cast<int16_t>(triangles_.x[i]);
      small.y = static_cast<int16_t>(triangles_.y[i]);
      small.draw = range.draw;
      small.size = 0;
      small.kind = PrimitiveKind::kTriangle;
      small.back_facing = fate == TriangleFate::kSmallBack;
      add_small(small, packet);
    }
  }

  // Primitive i of triangles_, one by itself.
  void emit_corners(const DrawState& draw, uint32_t draw_index, int corners, const float* records,
                    uint32_t i, Packet& packet) {
    const float* v[3] = {};
    uint32_t any = 0, all = ~0u;
    for (int k = 0; k < corners; ++k) {
      v[k] = records + static_cast<ptrdiff_t>(triangles_.corner[k][i]) * draw.setup.layout.stride;
      uint32_t outcode;
      std::memcpy(&outcode, v[k] + vertex_record::kOutcode, sizeof(outcode));
      any |= outcode;
      all &= outcode;
    }
    // Not if outside one plane as a whole.
    if ((all & ~uint32_t{kOutcodeGuard}) == 0) emit(draw, draw_index, corners, v, any, packet);
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

  void add(bool visible, const PrimitiveRecord& record, Packet& packet) const {
    if (!visible) return;
    if (draws_small_ && is_small(record)) {
      SmallPrimitive small;
      if (!make_small(record, small)) return;
      add_small(small, packet);
    } else {
      packet.bins.add(record, static_cast<uint32_t>(packet.primitives.size()));
      packet.primitives.push_back(record);
    }
  }

  static void add_small(const SmallPrimitive& primitive, Packet& packet) {
    packet.bins.add(primitive, kSmallEntry + static_cast<uint32_t>(packet.small.size()));
    packet.small.push_back(primitive);
  }

  Arena arena_;
  TileNumbers tile_numbers_;
  uint32_t element_count_ = 0, primitive_count_ = 0;
  bool draws_small_ = false;  // what is small in the draw at hand becomes a small primitive
  std::array<uint32_t, kPacketVertices> elements_;
  TriangleSet<kPacketPrimitives> triangles_;  // of points and lines, their corners alone
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
