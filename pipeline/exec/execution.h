// Running packets of a frame on all cores: the vertices that draws share, the front phase of each
// packet, the lists of what each tile has to draw, the back phase of each tile.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "pipeline/exec/arena.h"
#include "pipeline/exec/draw_list.h"
#include "pipeline/exec/frame_data.h"
#include "pipeline/exec/shared_vertices.h"
#include "pipeline/exec/shares.h"

namespace clearpipe::pipeline {

class Execution {
 public:
  Execution() = default;
  ~Execution() { finish(); }
  Execution(const Execution&) = delete;
  Execution& operator=(const Execution&) = delete;

  // What is to be done next: packets, in their order. Draws from `first_draw` on were in none
  // before. All that is given stays until it is done. Throws std::bad_alloc.
  void prepare(DrawList& draws, size_t first_draw, std::span<const std::unique_ptr<Packet>> packets,
               const Target& target, const TileGrid& grid, Arena& arena);

  // Does it. False when memory did not suffice: then not all is done.
  bool run();

  // Lets the workers do it, if they are not busy with something else, until finish(). Draws may be
  // added to the list meanwhile.
  void start();
  bool is_started() const { return started_; }
  bool is_done() const {
    return tiles_done_.load(std::memory_order_acquire) == static_cast<uint32_t>(grid_.count());
  }
  // Does what is left of what was started, as run().
  bool finish();

  // Nobody looks any more at what packets were given by their front phase.
  void forget();

 private:
  static void task(void* context, int number);

  template <typename Work>
  void unless_failed(const Work& work);
  void make_workers(size_t count);
  void run_chunks(size_t worker);
  void run_packets(size_t worker);
  void run_parts(size_t worker);
  void run_tiles(size_t worker);
  bool is_little() const;

  DrawList* draws_ = nullptr;
  const Target* target_ = nullptr;
  TileGrid grid_;
  std::vector<Packet*> packets_;
  SharedVertices shared_vertices_;
  TileWork tile_work_;
  std::vector<FrontWorkerPtr> front_workers_;
  std::vector<std::unique_ptr<BackWorker>> back_workers_;
  Shares chunks_, packet_shares_, parts_, tiles_;
  std::atomic<uint32_t> chunks_done_{0}, packets_done_{0}, parts_done_{0}, tiles_done_{0};
  std::atomic<bool> failed_{false};
  bool started_ = false;
};

}  // namespace clearpipe::pipeline
