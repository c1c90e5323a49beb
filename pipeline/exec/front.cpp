// The front phase of a packet: elements -> vertex records -> primitives -> clip -> setup -> bins.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstring>

#include "pipeline/exec/frame_data.h"
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

namespace {

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
    primitive_vertices<kPrimitive>(range.first_primitive + i, draw.command.count, vertex);
    for (int k = 0; k < corners; ++k) f(k, i, element_of(vertex[k]));
  }
}

template <class ElementOf, class F>
void for_each_corner_with(const DrawRecord& draw, const PacketRange& range,
                          const ElementOf& element_of, const F& f) {
  switch (draw.command.primitive) {
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
  return [indices = draw.command.indices, base = draw.index_base](uint32_t vertex) {
    Index value;
    std::memcpy(&value, indices + sizeof(Index) * size_t{vertex}, sizeof(value));
    return value - base;
  };
}

template <class F>
void for_each_corner(const DrawRecord& draw, const PacketRange& range, const F& f) {
  switch (draw.command.index_type) {
    case IndexType::kNone: {
      const uint32_t first = draw.command.first - draw.index_base;
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

}  // namespace

// The scratch memory of one worker: the elements of the range at hand with a table that finds an
// element already listed, so that a vertex used by several primitives is transformed once.
class FrontWorker {
 public:
  void run(const std::vector<DrawRecord>& draws, const TileGrid& grid, Packet& packet) {
    packet.bins.reset(grid, bin_scratch_);
    packet.primitives.clear();
    packet.small.clear();
    packet.records.clear();
    for (const PacketRange& range : packet.ranges) {
      run_range(draws[range.draw], range, packet);
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

  void run_range(const DrawRecord& draw, const PacketRange& range, Packet& packet) {
    ++generation_;
    element_count_ = 0;
    const int corners = corner_count(draw.command.primitive);
    for_each_corner(draw, range, [this](int corner, uint32_t primitive, uint32_t element) {
      triangles_.corner[corner][primitive] = local_vertex(element);
    });
    const int stride = draw.setup.layout.stride;
    float* records = static_cast<float*>(arena_.allocate(sizeof(float) * stride * element_count_));
    VertexJob job;
    job.draw = &draw.command;
    job.state = draw.vertex;
    job.viewport = draw.clip.viewport;
    job.guard = draw.clip.guard;
    job.layout = draw.setup.layout;
    job.elements = elements_.data();
    job.count = element_count_;
    job.records = records;
    run_vertex_stages(job);
    packet.records.push_back(records);

    draws_small_ = draws_small(draw);
    if (corners == 3 && draws_small_) {
      emit_triangles(draw, range, records, packet);
      return;
    }
    for (uint32_t i = 0; i < range.primitive_count; ++i) {
      emit_corners(draw, range.draw, corners, records, i, packet);
    }
  }

  // Triangles that are settled many at once, and the others.
  void emit_triangles(const DrawRecord& draw, const PacketRange& range, const float* records,
                      Packet& packet) {
    for (auto& corner : triangles_.corner) {
      std::fill_n(corner.begin() + range.primitive_count, kTriangleLanes, 0);
    }
    TriangleJob job;
    job.records = records;
    for (int k = 0; k < 3; ++k) job.corner[k] = triangles_.corner[k].data();
    job.count = range.primitive_count;
    job.fate = triangles_.fate.data();
    job.x = triangles_.x.data();
    job.y = triangles_.y.data();
    job.mask_low = triangles_.mask_low.data();
    job.mask_high = triangles_.mask_high.data();
    setup_triangles(draw.setup, job);
    SmallPrimitive small;
    small.size = 0;
    small.kind = PrimitiveKind::kTriangle;
    for (uint32_t i = 0; i < range.primitive_count; ++i) {
      const auto fate = static_cast<TriangleFate>(triangles_.fate[i]);
      if (fate == TriangleFate::kNothing) continue;
      if (fate == TriangleFate::kGeneral) {
        emit_corners(draw, range.draw, 3, records, i, packet);
        continue;
      }
      small.mask = static_cast<uint64_t>(triangles_.mask_high[i]) << 32 | triangles_.mask_low[i];
      small.x = static_cast<int16_t>(triangles_.x[i]);
      small.y = static_cast<int16_t>(triangles_.y[i]);
      small.back_facing = fate == TriangleFate::kSmallBack;
      add_small(i, small, packet);
    }
  }

  // Primitive i of the range, one by itself.
  void emit_corners(const DrawRecord& draw, uint32_t draw_index, int corners, const float* records,
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
    if ((all & ~uint32_t{kOutcodeGuard}) != 0) return;  // outside one plane as a whole
    PrimitiveRecord record;
    record.draw = draw_index;
    if (any != 0) {
      clip(draw, corners, v, any, record, packet);
    } else if (setup(draw.setup, corners, v, record)) {
      SmallPrimitive small;
      if (!draws_small_ || !is_small(record)) {
        add(record, packet);
      } else if (make_small(record, small)) {
        add_small(i, small, packet);
      }
    }
  }

  static bool setup(const SetupState& state, int corners, const float* const* v,
                    PrimitiveRecord& out) {
    switch (corners) {
      case 1:
        return setup_point(state, v[0], out);
      case 2:
        return setup_line(state, v[0], v[1], out);
      default:
        return setup_triangle(state, v[0], v[1], v[2], out);
    }
  }

  // A primitive that crosses planes; a point that does is gone.
  void clip(const DrawRecord& draw, int corners, const float* v[3], uint32_t outcodes,
            PrimitiveRecord& record, Packet& packet) {
    if (corners == 3) {
      const float* polygon[kMaxClippedCorners];
      const int count = clip_triangle(draw.clip, v, outcodes, arena_, polygon);
      for (int i = 2; i < count; ++i) {
        PrimitiveRecord piece = record;
        if (setup_triangle(draw.setup, polygon[0], polygon[i - 1], polygon[i], piece)) {
          add(piece, packet);
        }
      }
    } else if (corners == 2 && clip_line(draw.clip, v, outcodes, arena_) &&
               setup_line(draw.setup, v[0], v[1], record)) {
      add(record, packet);
    }
  }

  static void add(const PrimitiveRecord& record, Packet& packet) {
    packet.bins.add(record, static_cast<uint32_t>(packet.primitives.size()));
    packet.primitives.push_back(record);
  }

  // Primitive i of the range at hand, the last whose records the packet has.
  void add_small(uint32_t i, SmallPrimitive& primitive, Packet& packet) const {
    for (int k = 0; k < 3; ++k) {
      primitive.vertex[k] = static_cast<uint32_t>(triangles_.corner[k][i]);
    }
    primitive.range = static_cast<uint16_t>(packet.records.size() - 1);
    packet.bins.add(primitive, kSmallEntry + static_cast<uint32_t>(packet.small.size()));
    packet.small.push_back(primitive);
  }

  Arena arena_;
  BinScratch bin_scratch_;
  uint32_t element_count_ = 0;
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
