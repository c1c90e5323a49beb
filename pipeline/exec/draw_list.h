// The draws of a frame. None moves when another is added: workers may read those before it
// meanwhile. SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "pipeline/exec/draw_record.h"
#include "pipeline/fetch_ahead.h"

namespace clearpipe::pipeline {

class DrawList {
 public:
  static constexpr size_t kMaxDraws = 16 * 1024;

  // There must be fewer than kMaxDraws. Throws std::bad_alloc.
  void push_back(const DrawRecord& draw) {
    std::unique_ptr<DrawRecord[]>& block = blocks_[size_ / kBlock];
    if (!block) block = std::make_unique_for_overwrite<DrawRecord[]>(kBlock);
    constexpr size_t kAhead = 8;
    fetch_to_write(&block[(size_ + kAhead) % kBlock], sizeof(DrawRecord));
    block[size_++ % kBlock] = draw;
  }

  // Forgets the draws, keeps the memory.
  void clear() { size_ = 0; }

  size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  DrawRecord& operator[](size_t i) { return blocks_[i / kBlock][i % kBlock]; }
  const DrawRecord& operator[](size_t i) const { return blocks_[i / kBlock][i % kBlock]; }
  DrawRecord& back() { return (*this)[size_ - 1]; }

 private:
  static constexpr size_t kBlock = 256;

  // Apart, as workers look for draws while others are added.
  alignas(64) std::array<std::unique_ptr<DrawRecord[]>, kMaxDraws / kBlock> blocks_;
  alignas(64) size_t size_ = 0;
};

}  // namespace clearpipe::pipeline
