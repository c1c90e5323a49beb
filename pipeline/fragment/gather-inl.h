// Gathering: the pixels that a coverage selects become a batch, and what the stages made of them
// goes back.
//
// A batch is filled with the runs of set bits of the coverage's rows, so that stored values are
// copied in and out a run at a time.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_GATHER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_GATHER_INL_H_
#undef CLEARPIPE_FRAGMENT_GATHER_INL_H_
#else
#define CLEARPIPE_FRAGMENT_GATHER_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "pipeline/fragment/batch.h"
#include "pipeline/fragment/program.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {

class GatheredBatch {
 public:
  GatheredBatch(const PrimitivePlanes& planes, const Tile& tile)
      : tile_x_(tile.x), tile_y_(tile.y), to_x_(0.5f - planes.x_ref), to_y_(0.5f - planes.y_ref) {
    batch_.count = 0;
  }

  FragmentBatch& batch() { return batch_; }
  bool empty() const { return batch_.count == 0; }
  bool full() const { return batch_.count == kBatchSize; }

  // Takes as much of a run of pixels as there is room for; returns how many.
  int append(int row, int column, int length) {
    const int at = batch_.count;
    length = std::min(length, kBatchSize - at);
    const int offset = row * kTileWidth + column;
    // In the same order as the early depth test, so that both see the same depth.
    const float y = static_cast<float>(tile_y_ + row) + to_y_;
    const int x = tile_x_ + column;
    for (int i = 0; i < length; ++i) {
      batch_.x[at + i] = static_cast<float>(x + i) + to_x_;
      batch_.y[at + i] = y;
      batch_.offset[at + i] = static_cast<uint16_t>(offset + i);
      batch_.live[at + i] = -1;
    }
    runs_[run_count_++] = {static_cast<uint16_t>(offset), static_cast<uint16_t>(length)};
    batch_.count += length;
    return length;
  }

  // Stages work on whole vectors: the places behind the last fragment repeat it.
  void pad() {
    const int last = batch_.count - 1;
    const int end = std::min((batch_.count + 63) / 64 * 64, kBatchSize);
    for (int i = batch_.count; i < end; ++i) {
      batch_.x[i] = batch_.x[last];
      batch_.y[i] = batch_.y[last];
      batch_.offset[i] = batch_.offset[last];
      batch_.live[i] = 0;
      batch_.stored_colour[i] = 0;
      batch_.stored_depth_stencil[i] = 0;
    }
  }

  // The fragments' values of a plane of the tile, into and out of an array of the batch.
  void load(const uint32_t* plane, uint32_t* values) const {
    for (int i = 0; i < run_count_; ++i) {
      std::memcpy(values, plane + runs_[i].offset, runs_[i].length * 4u);
      values += runs_[i].length;
    }
  }
  void store(const uint32_t* values, uint32_t* plane) const {
    for (int i = 0; i < run_count_; ++i) {
      std::memcpy(plane + runs_[i].offset, values, runs_[i].length * 4u);
      values += runs_[i].length;
    }
  }

  void clear() {
    batch_.count = 0;
    run_count_ = 0;
  }

 private:
  struct Run {
    uint16_t offset, length;
  };

  int tile_x_, tile_y_;
  float to_x_, to_y_;
  int run_count_ = 0;
  Run runs_[kBatchSize];
  FragmentBatch batch_;
};

// Calls add(row, column, length) for each run of set bits of a row.
template <class Add>
void for_each_run(int row, uint64_t bits, const Add& add) {
  while (bits != 0) {
    const int first = std::countr_zero(bits);
    const int length = std::countr_one(bits >> first);
    add(row, first, length);
    if (first + length == kTileWidth) break;
    bits &= ~uint64_t{0} << (first + length);
  }
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
