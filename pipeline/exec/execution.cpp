// Running packets: see execution.h.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/execution.h"

#include <algorithm>
#include <new>

#include "pipeline/exec/workers.h"

namespace clearpipe::pipeline {

void Execution::prepare(DrawList& draws, size_t first_draw,
                        std::span<const std::unique_ptr<Packet>> packets, const Target& target,
                        const TileGrid& grid, Arena& arena) {
  draws_ = &draws;
  target_ = &target;
  grid_ = grid;
  packets_.clear();
  for (const std::unique_ptr<Packet>& packet : packets) packets_.push_back(packet.get());
  chunks_done_ = packets_done_ = parts_done_ = tiles_done_ = 0;
  failed_ = false;
  shared_vertices_.prepare(draws, first_draw, arena);
  const auto workers = static_cast<size_t>(worker_count());
  chunks_.divide(shared_vertices_.chunk_count(), workers);
  packet_shares_.divide(packets_.size(), workers);
  tile_work_.divide(grid, workers);
  parts_.divide(workers, workers);
  tiles_.divide(static_cast<size_t>(grid.count()), workers);
}

bool Execution::run() {
  make_workers(1);
  // A packet is built by one worker anyway.
  const auto is_draw = [](const Packet* packet) { return !packet->is_clear; };
  if (std::count_if(packets_.begin(), packets_.end(), is_draw) <= 1) {
    run_chunks(0);
    run_packets(0);
    if (is_little()) {
      run_parts(0);
      run_tiles(0);
      return !failed_;
    }
  }
  make_workers(static_cast<size_t>(worker_count()));
  run_on_workers(&task, this);
  return !failed_;
}

void Execution::start() {
  make_workers(static_cast<size_t>(worker_count()));
  started_ = true;
  start_on_workers(&task, this);
}

bool Execution::finish() {
  if (!started_) return true;
  started_ = false;
  finish_on_workers(&task, this);
  return !failed_;
}

void Execution::forget() {
  for (const FrontWorkerPtr& worker : front_workers_) reset_front_worker(*worker);
}

namespace {

// Of so many pieces of a phase, some more are done.
void note_done(std::atomic<uint32_t>& count, uint32_t more, size_t all) {
  if (more != 0 && count.fetch_add(more, std::memory_order_acq_rel) + more == all) {
    count.notify_all();
  }
}

}  // namespace

// All phases, so that a worker wakes up once.
void Execution::task(void* context, int number) {
  Execution& execution = *static_cast<Execution*>(context);
  const auto worker = static_cast<size_t>(number);
  execution.run_chunks(worker);
  wait_until(execution.chunks_done_,
             static_cast<uint32_t>(execution.shared_vertices_.chunk_count()));
  execution.run_packets(worker);
  wait_until(execution.packets_done_, static_cast<uint32_t>(execution.packets_.size()));
  execution.run_parts(worker);
  wait_until(execution.parts_done_, static_cast<uint32_t>(worker_count()));
  execution.run_tiles(worker);
}

// Without memory all fails as a whole, when nobody works on it any more.
template <typename Work>
void Execution::unless_failed(const Work& work) try {
  if (!failed_.load(std::memory_order_relaxed)) work();
} catch (const std::bad_alloc&) {
  failed_ = true;
}

void Execution::make_workers(size_t count) {
  while (front_workers_.size() < count) {
    front_workers_.push_back(make_front_worker());
  }
  while (back_workers_.size() < count) {
    // Of its memory it touches what it needs.
    back_workers_.push_back(std::make_unique_for_overwrite<BackWorker>());
  }
}

void Execution::run_chunks(size_t worker) {
  uint32_t done = 0;
  for (size_t i = 0; chunks_.take(worker, i); ++done) shared_vertices_.run(*draws_, i);
  note_done(chunks_done_, done, shared_vertices_.chunk_count());
}

void Execution::run_packets(size_t worker) {
  uint32_t done = 0;
  for (size_t i = 0; packet_shares_.take(worker, i); ++done) {
    if (packets_[i]->is_clear) continue;
    unless_failed([&] { run_front(*front_workers_[worker], *draws_, grid_, *packets_[i]); });
  }
  note_done(packets_done_, done, packets_.size());
}

void Execution::run_parts(size_t worker) {
  uint32_t done = 0;
  for (size_t i = 0; parts_.take(worker, i); ++done) {
    unless_failed([&] { tile_work_.make(i, packets_); });
  }
  note_done(parts_done_, done, static_cast<size_t>(worker_count()));
}

void Execution::run_tiles(size_t worker) {
  if (failed_) return;
  uint32_t done = 0;
  for (size_t i = 0; tiles_.take(worker, i); ++done) {
    run_back(*draws_, packets_, tile_work_, *target_, grid_, static_cast<int>(i),
             *back_workers_[worker]);
  }
  tiles_done_.fetch_add(done, std::memory_order_acq_rel);
}

// Whether the tiles are less work than waking a thread to share it, from what the packets hold.
bool Execution::is_little() const {
  // Nanoseconds, roughly.
  constexpr int64_t kTile = 80, kPrimitive = 150, kDot = 10, kPixel = 8, kWakeUp = 60000;
  int64_t work = kTile * grid_.count();
  for (size_t i = 0; i < packets_.size() && work < kWakeUp; ++i) {
    if (packets_[i]->is_clear) continue;
    if (packets_[i]->is_dots) work += kDot * packets_[i]->primitive_count;
    work +=
        kPrimitive * static_cast<int64_t>(packets_[i]->small.size() + packets_[i]->strokes.size());
    for (const PrimitiveRecord& p : packets_[i]->primitives) {
      work += kPrimitive + kPixel * (p.x1 - p.x0) * (p.y1 - p.y0);
    }
  }
  return work < kWakeUp;
}

}  // namespace clearpipe::pipeline
