// A bump allocator whose blocks live as long as the frame machinery: a steady frame allocates
// nothing. Everything in it is released at once by reset().
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "pipeline/image_memory.h"

namespace clearpipe::pipeline {

class Arena {
 public:
  static constexpr size_t kAlignment = 64;

  // Uninitialised memory, 64-byte aligned. Throws std::bad_alloc.
  void* allocate(size_t bytes) {
    bytes = (bytes + kAlignment - 1) & ~(kAlignment - 1);
    while (block_ < blocks_.size() && used_ + bytes > blocks_[block_].size) {
      ++block_;
      used_ = 0;
    }
    if (block_ == blocks_.size()) {
      add_block(bytes);
    }
    std::byte* result = blocks_[block_].memory.get() + used_;
    used_ += bytes;
    return result;
  }

  template <class T>
  T* allocate_array(size_t count) {
    static_assert(std::is_trivially_destructible_v<T>);
    return static_cast<T*>(allocate(count * sizeof(T)));
  }

  // Forgets everything; keeps the memory.
  void reset() {
    block_ = 0;
    used_ = 0;
  }

 private:
  static constexpr size_t kLeastBlock = size_t{256} << 10, kMostBlock = size_t{2} << 20;

  struct Free {
    size_t size = 0;
    void operator()(std::byte* p) const { free_memory(p, size); }
  };
  struct Block {
    std::unique_ptr<std::byte[], Free> memory;
    size_t size = 0;
  };

  // Together twice as large each time, until a block is a huge page (image_memory.h).
  void add_block(size_t bytes) {
    const size_t size = std::max(bytes, std::clamp(total_, kLeastBlock, kMostBlock));
    Block block{{static_cast<std::byte*>(allocate_memory(size)), Free{size}}, size};
    blocks_.push_back(std::move(block));
    total_ += size;
    used_ = 0;
  }

  std::vector<Block> blocks_;
  size_t block_ = 0;  // the block in use
  size_t used_ = 0;   // bytes used in it
  size_t total_ = 0;  // bytes of all blocks
};

}  // namespace clearpipe::pipeline
