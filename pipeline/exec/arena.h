// A bump allocator whose blocks live as long as the frame machinery: a steady frame allocates
// nothing. Everything in it is released at once by reset().
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

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
      add_block(std::max(bytes, kBlockSize));
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
  static constexpr size_t kBlockSize = size_t{256} << 10;

  struct Free {
    void operator()(std::byte* p) const { ::operator delete[](p, std::align_val_t{kAlignment}); }
  };
  struct Block {
    std::unique_ptr<std::byte[], Free> memory;
    size_t size = 0;
  };

  void add_block(size_t size) {
    Block block;
    block.memory.reset(
        static_cast<std::byte*>(::operator new[](size, std::align_val_t{kAlignment})));
    block.size = size;
    blocks_.push_back(std::move(block));
    used_ = 0;
  }

  std::vector<Block> blocks_;
  size_t block_ = 0;  // the block in use
  size_t used_ = 0;   // bytes used in it
};

}  // namespace clearpipe::pipeline
