// Vertices of large indexed draws, transformed once for all packets of the draw.
//
// Neighbouring packets of a mesh use the same vertices: in rows of triangles each vertex is used by
// two packets. When the elements that a draw uses lie close together, all of them become records
// before the front phase, in chunks that the workers share, and packets need no table to find
// theirs.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "pipeline/exec/arena.h"
#include "pipeline/exec/frame_data.h"

namespace clearpipe::pipeline {

class SharedVertices {
 public:
  // Finds the draws, from `first` on, and sets the shared records of theirs; the memory comes from
  // the arena. Throws std::bad_alloc.
  void prepare(DrawList& draws, size_t first, Arena& arena);

  // The chunks that have to be run then, in any order, on any worker.
  size_t chunk_count() const { return chunks_.size(); }
  void run(const DrawList& draws, size_t chunk) const;

 private:
  static constexpr uint32_t kChunk = 1024;

  struct Chunk {
    uint32_t draw, first, count;  // elements, counted from the draw's first
    float* records;
  };

  std::vector<Chunk> chunks_;
};

}  // namespace clearpipe::pipeline
