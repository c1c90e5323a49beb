// The front phase of a packet: elements -> vertex records -> primitives -> clip -> setup -> bins.
// SPDX-License-Identifier: MIT
#include <hwy/cache_control.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <span>

#include "pipeline/exec/corners.h"
#include "pipeline/exec/dots.h"
#include "pipeline/exec/frame_data.h"
#include "pipeline/exec/index_range.h"
#include "pipeline/exec/triangle_corners.h"
#include "pipeline/fragment/small.h"
#include "pipeline/setup/lanes.h"
#include "pipeline/setup/pairs.h"

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

// Whether the vertices of both draws can come out of one vertex job.
bool share_job(const DrawRecord& a, const DrawRecord& b) {
  return a.shared == nullptr && b.shared == nullptr && a.sources == b.sources &&
         a.state->vertex_group == b.state->vertex_group;
}

bool setup_primitive(const SetupState& state, int corners, const float* const* v,
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

}  // namespace

// Whether the primitives of two draws with vertices of one job are set up alike.
bool share_setup(const DrawRecord& a, const DrawRecord& b) {
  if (corner_count(a.primitive) != corner_count(b.primitive)) return false;
  if (a.state == b.state) return true;
  if (b.primitive < Primitive::kTriangles || !draws_small(b)) return false;
  const SetupState &s = a.state->setup, &t = b.state->setup;
  return s.bounds.x0 == t.bounds.x0 && s.bounds.y0 == t.bounds.y0 && s.bounds.x1 == t.bounds.x1 &&
         s.bounds.y1 == t.bounds.y1 && s.raster.cull == t.raster.cull &&
         s.raster.front_is_clockwise == t.raster.front_is_clockwise;
}

// Whether points are shaded by themselves: those of one size, which no small primitive has. Where
// sizes vary, small ones would wait in batches that each large one ends.
bool has_large_points(const DrawRecord& draw) {
  const AttributeSource& size = draw.sources->attributes[static_cast<int>(Attribute::kPointSize)];
  return draw.state->shades_points && !size.is_array && !draw.vertex->point_attenuated &&
         size.constant.x > kSmallSide;
}

// The scratch memory of one worker: the elements of the ranges at hand with a table that finds an
// element already listed, so that a vertex used by several primitives is transformed once.
class FrontWorker {
 public:
  void run(const DrawList& draws, const TileGrid& grid, Packet& packet) {
    if (packet.is_dots) return dots_.run(draws, grid, bin_scratch_, arena_, packet);
    packet.bins.reset(grid, bin_scratch_);
    const std::vector<PacketRange>& ranges = packet.ranges;
    primitives_.start(0);
    small_.start(packet.primitive_count);
    strokes_.start(draws[ranges[0].draw].state->draws_strokes ? packet.primitive_count : 0);
    range_records_.start(ranges.size());
    for (size_t first = 0; first < ranges.size();) {
      const DrawRecord& draw = draws[ranges[first].draw];
      size_t end = first + 1;
      uint32_t count = ranges[first].primitive_count;
      while (end < ranges.size() && share_job(draw, draws[ranges[end].draw]) &&
             count + ranges[end].primitive_count <= kPacketPrimitives) {
        count += ranges[end++].primitive_count;
      }
      run_ranges(draws, {ranges.data() + first, ranges.data() + end}, packet);
      first = end;
    }
    packet.bins.close(arena_);
    packet.primitives = primitives_.finish();
    packet.small = small_.finish();
    packet.strokes = strokes_.finish();
    packet.records = range_records_.finish();
  }

  void reset() {
    arena_.reset();
    primitives_.reset();
    small_.reset();
    strokes_.reset();
    range_records_.reset();
  }

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

  // Lists the elements of a range, and of each corner of its primitives which of them it is; the
  // first primitive is number `first` of the job.
  void list_elements(const DrawRecord& draw, const PacketRange& range, uint32_t first) {
    const bool apart = draw.index_type == IndexType::kNone && corners_of(draw.primitive) != 0;
    if (apart) {  // each vertex belongs to one primitive
      for_each_corner(draw, range, [this, first](int k, uint32_t i, uint32_t element) {
        elements_[element_count_] = element;
        lanes_.corner[k][first + i] = static_cast<int32_t>(element_count_++);
      });
    } else {
      for_each_corner(draw, range, [this, first](int k, uint32_t i, uint32_t element) {
        lanes_.corner[k][first + i] = local_vertex(element);
      });
    }
  }

  // The same, and notes which matrices the elements go with. With others, the same element is
  // another vertex.
  void list_run(const DrawRecord& draw, const PacketRange& range, uint32_t first) {
    const VertexState* matrices = draw.vertex;
    if (run_count_ == 0 || runs_[run_count_ - 1].matrices != matrices) {
      ++generation_;
      hwy::Prefetch(matrices);  // for the vertex job
      runs_[run_count_++] = {matrices, 0};
    }
    const uint32_t listed = element_count_;
    list_elements(draw, range, first);
    runs_[run_count_ - 1].count += element_count_ - listed;
  }

  // The same of a range whose draw has records of its own.
  void list_shared(const DrawRecord& draw, const PacketRange& range) {
    const uint32_t first = draw.first_shared;
    if (draw.primitive == Primitive::kTriangles) {
      const size_t before = size_t{3} * range.first_primitive * index_bytes(draw.index_type);
      int32_t* const corner[3] = {lanes_.corner[0].data(), lanes_.corner[1].data(),
                                  lanes_.corner[2].data()};
      return triangle_corners(draw.index_type, draw.indices + before, range.primitive_count,
                              first + draw.index_base, corner);
    }
    for_each_corner(draw, range, [this, first](int k, uint32_t i, uint32_t element) {
      lanes_.corner[k][i] = static_cast<int32_t>(element - first);
    });
  }

  // Ranges of draws whose vertices come out of one job.
  void run_ranges(const DrawList& draws, std::span<const PacketRange> ranges, Packet& packet) {
    const DrawRecord& draw = draws[ranges[0].draw];
    if (draw.shared != nullptr) {
      list_shared(draw, ranges[0]);
      records_ = draw.shared;
    } else {
      element_count_ = run_count_ = 0;
      uint32_t count = 0;
      for (const PacketRange& range : ranges) {
        list_run(draws[range.draw], range, count);
        count += range.primitive_count;
      }
      float* records =
          arena_.allocate_array<float>(size_t{draw.state->clip.layout.stride} * element_count_);
      VertexJob job = make_vertex_job(draw, elements_.data(), element_count_, records);
      if (run_count_ > 1) job.runs = runs_.data();
      run_vertex_stages(job);
      records_ = records;
    }
    emit(draws, ranges, packet);
  }

  // Primitives from the records of their vertices; ranges of triangles or of lines whose draws
  // setup cannot tell apart are set up together.
  void emit(const DrawList& draws, std::span<const PacketRange> ranges, Packet& packet) {
    uint32_t first = 0;
    for (size_t r = 0; r < ranges.size();) {
      const DrawRecord& draw = draws[ranges[r].draw];
      const int corners = corner_count(draw.primitive);
      draws_small_ = draws_small(draw);
      const bool large_points = has_large_points(draw);
      draws_narrow_ = draws_narrow(draw) && !large_points;
      // Squares of pixels that are written as they are cost less than others.
      widest_narrow_ =
          writes_primitive_colours(*draw.state->program) ? RowWidth::kMedium : RowWidth::kNarrow;
      size_t end = r;
      uint32_t count = 0;
      while (end < ranges.size() && share_setup(draw, draws[ranges[end].draw])) {
        count += ranges[end++].primitive_count;
      }
      const auto kind = static_cast<PrimitiveKind>(corners - 1);
      const bool in_lanes = draws_small_ && !large_points;
      if (in_lanes) {
        LaneJob job = lane_job(records_, lanes_, first, count);
        job.corners_alone = draw.state->draws_strokes;
        setup_lanes(kind, draw.state->setup, job);
      }
      for (; r < end; first += ranges[r++].primitive_count) {
        const DrawState& state = *draws[ranges[r].draw].state;
        range_records_.push_back(records_);
        if (in_lanes && kind == PrimitiveKind::kTriangle && merges_pairs(state.setup)) {
          merge_pairs(state.setup, lane_job(records_, lanes_, first, ranges[r].primitive_count));
        }
        for (uint32_t i = first; i < first + ranges[r].primitive_count; ++i) {
          const auto fate = in_lanes ? static_cast<LaneFate>(lanes_.fate[i]) : LaneFate::kGeneral;
          if (fate == LaneFate::kGeneral) {
            emit_corners(state, ranges[r].draw, corners, i, packet);
          } else if (fate == LaneFate::kSnapped || fate == LaneFate::kSnappedOther) {
            emit_line(state, ranges[r].draw, fate == LaneFate::kSnapped, i, packet);
          } else if (fate != LaneFate::kNothing) {
            emit_settled(state.setup, kind, fate, i, packet);
          }
        }
      }
    }
  }

  // A primitive that setup in lanes has settled.
  void emit_settled(const SetupState& setup, PrimitiveKind kind, LaneFate fate, uint32_t i,
                    Packet& packet) {
    const bool other = fate == LaneFate::kSmallOther;
    float size = 0;
    if (kind == PrimitiveKind::kLine) size = other ? -1.0f : 1.0f;
    if (kind == PrimitiveKind::kPoint && setup.raster.point_sprite) {
      const float* record = records_ + ptrdiff_t{lanes_.corner[0][i]} * setup.layout.stride;
      size = supported_width(record[vertex_record::kPointSize]);
    }
    const int squares = lanes_.more[i] != 0 ? kSquaresOfLane : 1;
    for (int square = 0; square < squares; ++square) {
      const uint64_t mask = lanes_.mask(i, square);
      if (mask == 0) continue;
      // In its place: a copy of what was just written in pieces would wait for them.
      SmallPrimitive& small = small_.emplace_back();
      small.mask = mask;
      small.x = static_cast<int16_t>(lanes_.x[i] + square % kLaneSquares * kSmallSide);
      small.y = static_cast<int16_t>(lanes_.y[i] + square / kLaneSquares * kSmallSide);
      small.kind = kind;
      small.size = size;
      small.back_facing = kind == PrimitiveKind::kTriangle && other;
      add_last_small(i, packet);
    }
  }

  // Primitive i of the job, one by itself.
  void emit_corners(const DrawState& draw, uint32_t draw_index, int corners, uint32_t i,
                    Packet& packet) {
    const float* v[3] = {};
    uint32_t any = 0, all = ~0u;
    for (int k = 0; k < corners; ++k) {
      v[k] = records_ + static_cast<ptrdiff_t>(lanes_.corner[k][i]) * draw.clip.layout.stride;
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
    } else if (setup_primitive(draw.setup, corners, v, record)) {
      add_large_or_small(record, i, packet);
    }
  }

  // A line whose corners are known from setup in lanes.
  void emit_line(const DrawState& draw, uint32_t draw_index, bool x_major, uint32_t i,
                 Packet& packet) {
    const ptrdiff_t stride = draw.clip.layout.stride;
    const float* const v0 = records_ + lanes_.corner[0][i] * stride;
    const float* const v1 = records_ + lanes_.corner[1][i] * stride;
    SnappedPoint corners[4];
    for (int k = 0; k < 4; ++k) corners[k] = {lanes_.snapped_x[k][i], lanes_.snapped_y[k][i]};
    if (draw.draws_strokes) {
      StrokeRecord& stroke = strokes_.emplace_back();
      stroke.draw = draw_index;
      if (setup_stroke(draw.setup, v0, v1, x_major, corners, stroke)) {
        packet.bins.add(stroke, kStrokeEntry + static_cast<uint32_t>(strokes_.size() - 1));
      } else {
        strokes_.pop_back();
      }
      return;
    }
    PrimitiveRecord record;
    record.draw = draw_index;
    if (setup_snapped_line(draw.setup, v0, v1, x_major, corners, record)) {
      add_large_or_small(record, i, packet);
    }
  }

  // A primitive that crosses planes; a point that does is gone.
  void clip(const DrawState& draw, int corners, const float* v[3], uint32_t outcodes,
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

  void add_large_or_small(PrimitiveRecord& record, uint32_t i, Packet& packet) {
    if (!draws_small_ || !is_small(record)) {
      add(record, packet);
    } else if (make_small(record, small_.emplace_back())) {
      add_last_small(i, packet);
    } else {
      small_.pop_back();
    }
  }

  void add(PrimitiveRecord& record, Packet& packet) {
    record.narrow = draws_narrow_ && record.width <= widest_narrow_;
    packet.bins.add(record, static_cast<uint32_t>(primitives_.size()));
    primitives_.push_back(record);
  }

  // The last small primitive: primitive i of the job, of the last range whose records the packet
  // has.
  void add_last_small(uint32_t i, Packet& packet) {
    SmallPrimitive& primitive = small_.back();
    static_assert(kPacketPrimitives <= 0x10000, "every range has a primitive");
    for (int k = 0; k < 3; ++k) {
      primitive.vertex[k] = static_cast<uint32_t>(lanes_.corner[k][i]);
    }
    primitive.range = static_cast<uint16_t>(range_records_.size() - 1);
    packet.bins.add(primitive, kSmallEntry + static_cast<uint32_t>(small_.size() - 1));
  }

  Arena arena_;
  BinScratch bin_scratch_;
  DotWorker dots_;
  // The lists of the packet at hand.
  ArenaLists<PrimitiveRecord> primitives_;
  ArenaLists<SmallPrimitive> small_;
  ArenaLists<StrokeRecord> strokes_;
  ArenaLists<const float*> range_records_;
  // What is small in the draw at hand becomes a small primitive; what is narrow stays so.
  bool draws_small_ = false, draws_narrow_ = false;
  RowWidth widest_narrow_ = RowWidth::kNarrow;
  uint32_t element_count_ = 0;
  std::array<uint32_t, kPacketVertices> elements_;
  uint32_t run_count_ = 0;
  std::array<VertexRun, kPacketPrimitives> runs_;
  const float* records_ = nullptr;  // the vertices of the job at hand
  LaneSet<kPacketPrimitives> lanes_;
  uint32_t generation_ = 0;
  std::array<uint32_t, kTableSize> table_generation_{};
  std::array<uint16_t, kTableSize> table_vertex_{};
};

FrontWorkerPtr make_front_worker() { return FrontWorkerPtr(new FrontWorker); }
void FrontWorkerDeleter::operator()(FrontWorker* worker) const { delete worker; }
void reset_front_worker(FrontWorker& worker) { worker.reset(); }

void run_front(FrontWorker& worker, const DrawList& draws, const TileGrid& grid, Packet& packet) {
  worker.run(draws, grid, packet);
}

}  // namespace clearpipe::pipeline
