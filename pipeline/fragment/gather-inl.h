// Gathering: the pixels that a coverage selects become a batch, and what the stages made of them
// goes back.
//
// A batch is filled with the runs of set bits of the coverage's rows, so that stored values are
// copied in and out a run at a time, unless runs are short.
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
namespace hn = hwy::HWY_NAMESPACE;

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
    const auto offset = static_cast<uint16_t>(row * kTileWidth + column);
    // In the same order as the early depth test, so that both see the same depth.
    const float y = static_cast<float>(tile_y_ + row) + to_y_;
    if (const hn::ScalableTag<float> d; at + length + kLanes <= kBatchSize) {
      write(d, at, length, tile_x_ + column, y, offset);
    } else {
      write(hn::CappedTag<float, 1>(), at, length, tile_x_ + column, y, offset);
    }
    runs_[run_count_++] = {offset, static_cast<uint16_t>(length)};
    batch_.count += length;
    return length;
  }

  // Stages work on whole vectors: the places behind the last fragment repeat it.
  void pad() {
    const int last = batch_.count - 1;
    const int end = std::min((batch_.count + 63) / 64 * 64, kBatchSize);
    std::fill_n(batch_.live, batch_.count, int16_t{-1});
    std::fill(batch_.live + batch_.count, batch_.live + end, int16_t{0});
    for (int i = batch_.count; i < end; ++i) {
      batch_.x[i] = batch_.x[last];
      batch_.y[i] = batch_.y[last];
      batch_.offset[i] = batch_.offset[last];
      batch_.stored_colour[i] = 0;
      batch_.stored_depth_stencil[i] = 0;
    }
  }

  // The fragments' values of a plane of the tile, into and out of an array of the batch.
  void load(const uint32_t* plane, uint32_t* values) const {
    if (has_short_runs()) {
      for (int i = 0; i < batch_.count; ++i) values[i] = plane[batch_.offset[i]];
      return;
    }
    for (int i = 0; i < run_count_; ++i) {
      std::memcpy(values, plane + runs_[i].offset, runs_[i].length * 4u);
      values += runs_[i].length;
    }
  }
  void store(const uint32_t* values, uint32_t* plane) const {
    if (has_short_runs()) {
      for (int i = 0; i < batch_.count; ++i) plane[batch_.offset[i]] = values[i];
      return;
    }
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
  static constexpr int kLanes = static_cast<int>(hn::MaxLanes(hn::ScalableTag<float>()));

  // The pixels of a run, as many as the tag has lanes at a time.
  template <class D>
  HWY_INLINE void write(D d, int at, int length, int x, float y, uint16_t offset) {
    const hn::RebindToSigned<D> di;
    const hn::Rebind<uint16_t, D> d16;
    const auto x_of_run = hn::Add(hn::Set(di, x), hn::Iota(di, 0));
    const auto offset_of_run = hn::Add(hn::Set(d16, offset), hn::Iota(d16, 0));
    for (int i = 0; i < length; i += static_cast<int>(hn::MaxLanes(d))) {
      const auto column = hn::ConvertTo(d, hn::Add(x_of_run, hn::Set(di, i)));
      hn::StoreU(hn::Add(column, hn::Set(d, to_x_)), d, batch_.x + at + i);
      hn::StoreU(hn::Set(d, y), d, batch_.y + at + i);
      hn::StoreU(hn::Add(offset_of_run, hn::Set(d16, static_cast<uint16_t>(i))), d16,
                 batch_.offset + at + i);
    }
  }

  // So that copying each of them would cost more than copying pixels.
  bool has_short_runs() const { return batch_.count < 8 * run_count_; }

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
