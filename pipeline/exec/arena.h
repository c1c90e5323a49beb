// A bump allocator whose blocks live as long as the frame machinery: a steady frame allocates
// nothing. Everything in it is released at once by reset().
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "pipeline/fetch_ahead.h"
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
    fetch_ahead(bytes);
    return result;
  }

  template <class T>
  T* allocate_array(size_t count) {
    static_assert(std::is_trivially_destructible_v<T>);
    return static_cast<T*>(allocate(count * sizeof(T)));
  }

  // What was allocated last ends at `end` already.
  void give_back(const void* end) {
    used_ = static_cast<size_t>(static_cast<const std::byte*>(end) - blocks_[block_].memory.get());
    used_ = (used_ + kAlignment - 1) & ~(kAlignment - 1);
  }

  // Forgets everything; keeps the memory.
  void reset() {
    block_ = 0;
    used_ = 0;
  }

 private:
  static constexpr size_t kFirstBlock = size_t{256} << 10, kOtherBlocks = size_t{2} << 20;

  // What is small is written soon after it was asked for: a large part at once, and what comes
  // next.
  static constexpr size_t kAhead = 2048, kMostFetched = size_t{128} << 10;

  void fetch_ahead(size_t bytes) const {
    if (bytes > kMostFetched) return;
    const Block& block = blocks_[block_];
    const size_t end = std::min(used_ + kAhead, block.size);
    const size_t begin = bytes > kAhead ? used_ - bytes : std::min(used_ + kAhead - bytes, end);
    fetch_to_write(block.memory.get() + begin, end - begin);
  }

  struct Free {
    size_t size = 0;
    void operator()(std::byte* p) const { free_memory(p, size); }
  };
  struct Block {
    std::unique_ptr<std::byte[], Free> memory;
    size_t size = 0;
  };

  // What a small frame does not fill, then huge pages (image_memory.h): the small pages of one take
  // several times as long to come by.
  void add_block(size_t bytes) {
    const size_t size = std::max(bytes, blocks_.empty() ? kFirstBlock : kOtherBlocks);
    Block block{{static_cast<std::byte*>(allocate_memory(size)), Free{size}}, size};
    blocks_.push_back(std::move(block));
    used_ = 0;
  }

  std::vector<Block> blocks_;
  size_t block_ = 0;  // the block in use
  size_t used_ = 0;   // bytes used in it
};

// Makes lists, one after another, in an arena that nothing else uses: a list grows where it lies.
template <class T>
class ArenaLists {
 public:
  static_assert(std::is_trivially_copyable_v<T>);

  // Starts a list of perhaps so many elements.
  void start(size_t expected) {
    capacity_ = std::max<size_t>(expected, 16);
    size_ = 0;
    list_ = arena_.allocate_array<T>(capacity_);
  }

  size_t size() const { return size_; }
  T& back() { return list_[size_ - 1]; }
  void pop_back() { --size_; }
  T& emplace_back() {
    if (size_ == capacity_) grow();
    constexpr size_t kAhead = 512 / sizeof(T) + 1;
    fetch_to_write(list_ + std::min(size_ + kAhead, capacity_ - 1), sizeof(T));
    return *::new (static_cast<void*>(list_ + size_++)) T;
  }
  void push_back(const T& element) { emplace_back() = element; }

  // The list, which stays until reset().
  std::span<const T> finish() {
    arena_.give_back(list_ + size_);
    return {list_, size_};
  }

  void reset() { arena_.reset(); }

 private:
  void grow() {
    T* const larger = arena_.allocate_array<T>(2 * capacity_);
    std::memcpy(static_cast<void*>(larger), list_, size_ * sizeof(T));
    list_ = larger;
    capacity_ *= 2;
  }

  Arena arena_;
  T* list_ = nullptr;
  size_t size_ = 0, capacity_ = 0;
};

}  // namespace clearpipe::pipeline
