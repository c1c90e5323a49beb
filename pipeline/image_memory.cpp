// See image_memory.h.
// SPDX-License-Identifier: MIT
#include "pipeline/image_memory.h"

#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <new>
#include <utility>

namespace clearpipe::pipeline {

namespace {

constexpr std::align_val_t kAlignment{64};
// A huge page takes about as long to come by as a quarter of it in small ones.
constexpr size_t kHugePage = size_t{2} << 20, kLeastHuge = kHugePage / 2;

// Smaller images are left to the program's allocator, which is quick with them.
constexpr size_t kLeastKept = size_t{64} << 10;
constexpr size_t kMostKept = size_t{64} << 20;  // of all that is kept
constexpr size_t kMostBlocks = 8;

struct Block {
  void* memory = nullptr;
  size_t bytes = 0;
};

// The free images, the oldest first.
class FreeImages {
 public:
  // Null: there is none of that size.
  void* take(size_t bytes) noexcept {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (size_t i = count_; i-- > 0;) {
      if (blocks_[i].bytes == bytes) return remove(i).memory;
    }
    return nullptr;
  }

  void keep(Block block) noexcept {
    const std::lock_guard<std::mutex> lock(mutex_);
    while (count_ == kMostBlocks || kept_ + block.bytes > kMostKept) free_first();
    blocks_[count_++] = block;
    kept_ += block.bytes;
  }

  void forget() noexcept {
    const std::lock_guard<std::mutex> lock(mutex_);
    while (count_ != 0) free_first();
  }

 private:
  Block remove(size_t index) noexcept {
    const Block block = blocks_[index];
    for (size_t i = index + 1; i < count_; ++i) blocks_[i - 1] = blocks_[i];
    --count_;
    kept_ -= block.bytes;
    return block;
  }

  void free_first() noexcept {
    const Block block = remove(0);
    free_memory(block.memory, block.bytes);
  }

  std::mutex mutex_;
  std::array<Block, kMostBlocks> blocks_;
  size_t count_ = 0, kept_ = 0;
};

// Images may be freed until the process ends.
FreeImages& free_images() {
  static auto* const images = new FreeImages;
  return *images;
}

bool is_kept(size_t bytes) { return bytes >= kLeastKept && bytes <= kMostKept; }

}  // namespace

void* allocate_memory(size_t bytes) {
  if (bytes < kLeastHuge) return operator new(bytes, kAlignment);
  // A last page of which less than half is used is not worth its zeroing.
  const size_t huge = (bytes + kHugePage / 2) / kHugePage * kHugePage;
  void* memory = operator new (std::max(bytes, huge), std::align_val_t{kHugePage});
  madvise(memory, huge, MADV_HUGEPAGE);  // advice: nothing depends on whether it is taken
  return memory;
}

void free_memory(void* memory, size_t bytes) noexcept {
  if (bytes < kLeastHuge) {
    operator delete(memory, kAlignment);
  } else {
    operator delete (memory, std::align_val_t{kHugePage});
  }
}

void* allocate_image(size_t bytes) {
  if (!is_kept(bytes)) return allocate_memory(bytes);
  if (void* const memory = free_images().take(bytes)) return memory;
  try {
    return allocate_memory(bytes);
  } catch (const std::bad_alloc&) {
    forget_free_images();
    return allocate_memory(bytes);
  }
}

void free_image(void* memory, size_t bytes) noexcept {
  if (is_kept(bytes)) {
    free_images().keep({memory, bytes});
  } else {
    free_memory(memory, bytes);
  }
}

void forget_free_images() noexcept { free_images().forget(); }

}  // namespace clearpipe::pipeline
