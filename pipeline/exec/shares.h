// Numbered pieces of work, shared out among workers so that a worker mostly gets the same ones in
// every frame: what it wrote the last time is in its own caches then, while fetching it from those
// of another processor can take longer than the work.
//
// Each worker has a share of pieces that follow each other, and takes them from the front. Who has
// finished its own takes from the back of the others'.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace clearpipe::pipeline {

class Shares {
 public:
  // Pieces 0 to count - 1, before anybody takes one.
  void divide(size_t count, size_t workers) {
    if (shares_.size() != workers) shares_ = std::vector<Share>(workers);
    for (size_t w = 0; w < workers; ++w) {
      shares_[w].rest.store(pack(count * w / workers, count * (w + 1) / workers),
                            std::memory_order_relaxed);
    }
  }

  // The next piece for a worker; false when none is left.
  bool take(size_t worker, size_t& piece) {
    for (size_t i = 0; i < shares_.size(); ++i) {
      const size_t owner = worker + i < shares_.size() ? worker + i : worker + i - shares_.size();
      if (take_from(shares_[owner].rest, i == 0, piece)) return true;
    }
    return false;
  }

 private:
  struct alignas(64) Share {
    std::atomic<uint64_t> rest{0};  // the first that is left, and the end above it
  };

  static uint64_t pack(size_t first, size_t end) { return uint64_t{end} << 32 | first; }

  static bool take_from(std::atomic<uint64_t>& rest, bool front, size_t& piece) {
    uint64_t now = rest.load(std::memory_order_relaxed);
    for (;;) {
      const size_t first = now & 0xffffffffu, end = now >> 32;
      if (first >= end) return false;
      const uint64_t less = front ? pack(first + 1, end) : pack(first, end - 1);
      if (rest.compare_exchange_weak(now, less, std::memory_order_relaxed)) {
        piece = front ? first : end - 1;
        return true;
      }
    }
  }

  std::vector<Share> shares_;
};

}  // namespace clearpipe::pipeline
