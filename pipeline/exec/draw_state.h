// The state of a frame as it changes from draw to draw, and what draws take of it.
//
// What a draw needs is worked out when one is recorded after a change, and shared by all that
// follow until the next, and by those that come back to a fragment state. A change that vertices do
// not see leaves them in their group: a vertex job takes the vertices of many draws (front.cpp).
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "pipeline/exec/frame_data.h"
#include "pipeline/exec/programs.h"

namespace clearpipe::pipeline {

class CurrentState {
 public:
  CurrentState() { clip_.guard = make_guard_band(clip_.viewport); }

  void set_target(const Target& target);
  void set_vertex_state(const VertexState& state);
  void set_raster_state(const RasterState& state);
  void set_fragment_state(const FragmentState& state);

  const Target& target() const { return target_; }

  // For a draw of such primitives; null when it can touch no pixel. Throws std::bad_alloc.
  const DrawState* of(Primitive primitive, Arena& arena) {
    const size_t kind = kind_of(primitive);
    if (!known_[kind]) {
      drawn_[kind] = find(primitive, arena);
      known_[kind] = true;
    }
    return drawn_[kind];
  }

  const VertexState* vertices(Arena& arena) {
    if (recorded_ == nullptr) record_vertices(arena);
    return recorded_;
  }

  // Bit per Attribute that vertices of such draws need, but for the size of points.
  uint32_t attributes() const { return attributes_; }

  bool is_full() const { return programs_.is_full(); }

  // The frame is done; the state remains.
  void reset();

 private:
  // Points, lines and polygons differ in their coverage.
  static size_t kind_of(Primitive primitive) {
    return primitive == Primitive::kPoints ? 0 : primitive <= Primitive::kLineStrip ? 1 : 2;
  }

  void forget_draws() {
    known_.fill(false);
    ++generation_;
  }
  void forget_vertices();
  void record_vertices(Arena& arena);
  const DrawState* find(Primitive primitive, Arena& arena);
  const DrawState* make(Primitive primitive, Arena& arena);
  FragmentCoverage coverage_of(Primitive primitive) const;
  ProgramHolder& program();
  Viewport viewport() const;

  Target target_;
  VertexState vertex_;
  RasterState raster_;
  FragmentState fragment_;

  ProgramTable programs_;
  ProgramHolder* program_ = nullptr;  // of fragment_, null when it must be looked for

  // Null: vertex_ and what follows from it are not in the frame's memory.
  const VertexState* recorded_ = nullptr;
  uint32_t vertex_group_ = 0;
  bool new_group_ = true;  // not only the matrices of vertex_ have changed since
  uint32_t attributes_ = 0;
  ClipState clip_;

  uint64_t generation_ = 1;      // of all that draw states are made from but fragment_
  std::array<bool, 3> known_{};  // by kind: the state of the last draw holds
  std::array<const DrawState*, 3> drawn_{};
};

}  // namespace clearpipe::pipeline
