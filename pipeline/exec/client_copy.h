// Copies of the vertex arrays of a draw that lie in client memory, which its program may change
// when the call returns (2.8).
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "pipeline/command.h"
#include "pipeline/exec/arena.h"

namespace clearpipe::pipeline {

class ClientCopies {
 public:
  // Of a draw that uses elements first to last.
  void start(uint32_t first, uint32_t last);

  // Makes the source, which lies in client memory, name a copy of these elements in the arena,
  // compact and numbered from 0. The copy is made by run(). Throws std::bad_alloc.
  void add(AttributeSource& source, Arena& arena);

  // Makes the copies, large ones on all workers: a piece of each array after another, since arrays
  // often lie between one another.
  void run();

 private:
  static constexpr size_t kPiece = 4096;  // elements

  struct Array {
    const std::byte* from;
    std::byte* to;
    size_t from_stride, to_stride, bytes;  // of an element
  };

  void copy_piece(size_t piece) const;

  std::array<Array, kAttributeCount> arrays_;
  size_t array_count_ = 0;
  size_t first_ = 0, elements_ = 0;
};

}  // namespace clearpipe::pipeline
