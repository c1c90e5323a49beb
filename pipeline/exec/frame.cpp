// Recording a frame and running it: see frame.h.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/frame.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <new>
#include <vector>

#include "pipeline/exec/draw_state.h"
#include "pipeline/exec/frame_data.h"
#include "pipeline/exec/record_arrays.h"
#include "pipeline/exec/shared_vertices.h"
#include "pipeline/exec/shares.h"
#include "pipeline/exec/workers.h"

namespace clearpipe::pipeline {

namespace {

// A frame that grows past this many primitives is executed so far, which bounds its memory.
constexpr uint32_t kMaxFramePrimitives = 128 * 1024;
constexpr size_t kMaxFrameDraws = 16 * 1024;

}  // namespace

struct Frame::Impl {
  TileGrid grid;
  CurrentState state;
  ArrayRecorder arrays;
  Arena arena;
  std::vector<DrawRecord> draws;
  std::vector<std::unique_ptr<Packet>> packets;  // the first packet_count are in use
  size_t packet_count = 0;
  uint32_t primitive_total = 0;

  SharedVertices shared_vertices;
  TileWork tile_work;
  std::vector<FrontWorkerPtr> front_workers;
  std::vector<std::unique_ptr<BackWorker>> back_workers;
  Shares chunks, packet_shares, tiles;
  std::atomic<uint32_t> chunks_done{0}, packets_done{0}, tiles_ready{0};
  std::atomic<bool> failed{false};

  Packet& add_packet() {
    if (packet_count == packets.size()) {
      packets.push_back(std::make_unique<Packet>());
    }
    Packet& packet = *packets[packet_count];
    packet.reset();
    ++packet_count;
    return packet;
  }

  Packet& open_packet() {
    if (packet_count != 0) {
      Packet& last = *packets[packet_count - 1];
      if (!last.is_clear && last.primitive_count < kPacketPrimitives) {
        return last;
      }
    }
    return add_packet();
  }

  void forget_recorded() {
    draws.clear();
    packet_count = 0;
    primitive_total = 0;
    state.reset();
    arrays.reset();
    arena.reset();
    for (const FrontWorkerPtr& worker : front_workers) {
      if (worker) reset_front_worker(*worker);
    }
  }

  // Whether a list of triangles, lines or points may go on with the next one: the elements follow
  // each other in one stream, and nothing but packets knows where draws end.
  static bool continues(const DrawRecord& last, const DrawRecord& next) {
    const uint32_t corners = corners_of(last.primitive);
    return corners != 0 && next.primitive == last.primitive && next.state == last.state &&
           next.vertex == last.vertex && next.sources == last.sources &&
           next.index_type == IndexType::kNone && last.index_type == IndexType::kNone &&
           last.count % corners == 0 &&
           next.first - next.index_base == last.first + last.count - last.index_base;
  }

  void record(const DrawCommand& command, uint32_t count) {
    DrawRecord draw;
    draw.state = state.of(command.primitive, arena);
    if (draw.state == nullptr) return;
    draw.vertex = state.vertices(arena);
    arrays.record(command, state.attributes(), arena, draw);
    uint32_t skipped = 0;  // primitives of the draw that is continued
    if (!draws.empty() && continues(draws.back(), draw)) {
      skipped = primitive_count(draw.primitive, draws.back().count);
      draws.back().count += draw.count;
    } else {
      draws.push_back(draw);
    }
    add_primitives(static_cast<uint32_t>(draws.size() - 1), skipped, count);
    primitive_total += count;
  }

  void add_primitives(uint32_t draw_index, uint32_t first, uint32_t count) {
    const uint32_t end = first + count;
    while (first < end) {
      Packet& packet = open_packet();
      const uint32_t part = std::min(end - first, kPacketPrimitives - packet.primitive_count);
      if (!packet.ranges.empty() && packet.ranges.back().draw == draw_index) {
        packet.ranges.back().primitive_count += part;
      } else {
        packet.ranges.push_back({draw_index, first, part});
      }
      packet.primitive_count += part;
      first += part;
    }
  }

  // Without memory the frame fails as a whole, when nobody works on it any more.
  template <typename Work>
  void unless_failed(const Work& work) try {
    if (!failed.load(std::memory_order_relaxed)) work();
  } catch (const std::bad_alloc&) {
    failed = true;
  }

  void run_chunks(size_t worker) {
    uint32_t done = 0;
    for (size_t i = 0; chunks.take(worker, i); ++done) shared_vertices.run(draws, i);
    const uint32_t total = static_cast<uint32_t>(shared_vertices.chunk_count());
    if (done != 0 && chunks_done.fetch_add(done, std::memory_order_acq_rel) + done == total) {
      chunks_done.notify_all();
    }
  }

  void run_packets(size_t worker) {
    uint32_t done = 0;
    for (size_t i = 0; packet_shares.take(worker, i); ++done) {
      if (packets[i]->is_clear) continue;
      unless_failed([&] { run_front(*front_workers[worker], draws, grid, *packets[i]); });
    }
    const uint32_t total = static_cast<uint32_t>(packet_count);
    if (done != 0 && packets_done.fetch_add(done, std::memory_order_acq_rel) + done == total) {
      unless_failed([&] { make_tile_work(packets, packet_count, grid, tile_work); });
      tiles_ready.store(1, std::memory_order_release);
      tiles_ready.notify_all();
    }
  }

  void run_tiles(size_t worker) {
    if (failed) return;
    for (size_t i = 0; tiles.take(worker, i);) {
      run_back(draws, packets, tile_work, state.target(), grid, static_cast<int>(i),
               *back_workers[worker]);
    }
  }

  // All phases, so that a worker wakes up once a frame.
  static void task(void* context, int number) {
    Impl& frame = *static_cast<Impl*>(context);
    const auto worker = static_cast<size_t>(number);
    frame.run_chunks(worker);
    wait_until(frame.chunks_done, static_cast<uint32_t>(frame.shared_vertices.chunk_count()));
    frame.run_packets(worker);
    wait_until(frame.tiles_ready, 1);
    frame.run_tiles(worker);
  }

  void make_workers(size_t count) {
    while (front_workers.size() < count) {
      front_workers.push_back(make_front_worker());
    }
    while (back_workers.size() < count) {
      back_workers.push_back(std::make_unique_for_overwrite<BackWorker>());
    }
  }

  // Whether the tiles are less work than waking a thread to share it, from what the packets hold.
  bool is_little() const {
    // Nanoseconds, roughly.
    constexpr int64_t kTile = 80, kPrimitive = 150, kPixel = 8, kWakeUp = 60000;
    int64_t work = kTile * grid.count();
    for (size_t i = 0; i < packet_count && work < kWakeUp; ++i) {
      if (packets[i]->is_clear) continue;
      work += kPrimitive * static_cast<int64_t>(packets[i]->small.size());
      for (const PrimitiveRecord& p : packets[i]->primitives) {
        work += kPrimitive + kPixel * (p.x1 - p.x0) * (p.y1 - p.y0);
      }
    }
    return work < kWakeUp;
  }

  void execute() {
    chunks_done = packets_done = tiles_ready = 0;
    failed = false;
    make_workers(1);
    shared_vertices.prepare(draws, arena);
    const auto workers = static_cast<size_t>(worker_count());
    chunks.divide(shared_vertices.chunk_count(), workers);
    packet_shares.divide(packet_count, workers);
    tiles.divide(static_cast<size_t>(grid.count()), workers);
    // A packet is built by one worker anyway.
    const auto is_draw = [](const std::unique_ptr<Packet>& p) { return !p->is_clear; };
    const auto end = packets.begin() + static_cast<ptrdiff_t>(packet_count);
    if (std::count_if(packets.begin(), end, is_draw) <= 1) {
      run_chunks(0);
      run_packets(0);
      if (is_little()) {
        run_tiles(0);
        return check();
      }
    }
    make_workers(workers);
    run_on_workers(&task, this);
    check();
  }

  void check() const {
    if (failed) throw std::bad_alloc();
  }
};

Frame::Frame() : impl_(std::make_unique<Impl>()) {}
Frame::~Frame() = default;

void Frame::set_target(const Target& target) {
  const Target& now = impl_->state.target();
  if (target.colour == now.colour && target.depth_stencil == now.depth_stencil &&
      target.width == now.width && target.height == now.height && target.mirrored == now.mirrored) {
    return;
  }
  finish();
  impl_->state.set_target(target);
  impl_->grid = make_tile_grid(target.width, target.height);
}

void Frame::set_vertex_state(const VertexState& state) { impl_->state.set_vertex_state(state); }
void Frame::set_raster_state(const RasterState& state) { impl_->state.set_raster_state(state); }
void Frame::set_fragment_state(const FragmentState& state) {
  impl_->state.set_fragment_state(state);
}

bool Frame::draw(const DrawCommand& command) try {
  const uint32_t count = primitive_count(command.primitive, command.count);
  if (count == 0 || impl_->grid.count() == 0) {
    return true;
  }
  if (impl_->primitive_total >= kMaxFramePrimitives || impl_->draws.size() >= kMaxFrameDraws ||
      impl_->state.is_full()) {
    finish();
  }
  impl_->record(command, count);
  return true;
} catch (const std::bad_alloc&) {
  return false;
}

bool Frame::clear(const ClearCommand& command) try {
  ClearCommand clear = command;
  const Target& target = impl_->state.target();
  clear.rect = {std::max(clear.rect.x0, 0), std::max(clear.rect.y0, 0),
                std::min(clear.rect.x1, target.width), std::min(clear.rect.y1, target.height)};
  if (target.colour && !target.colour->has_alpha) {
    clear.colour_mask &= 0x7;
    // Alpha is 255 already; clearing it to the same keeps the clear a plain fill.
    if (clear.colour_mask == 0x7) {
      clear.colour_mask = 0xf;
      clear.colour_value |= 0xff000000u;
    }
  }
  // Bits that the buffer does not have may be cleared with the others: again a plain fill.
  if (const auto& planes = target.depth_stencil; planes && !planes->partial_view) {
    if (clear.depth && !planes->has_stencil) {
      clear.stencil = true;
      clear.stencil_mask = 0xff;
      clear.stencil_value = 0;
    }
    if (clear.stencil && !planes->has_depth) clear.depth = true;
    if (clear.depth && planes->depth_bits == 32) {  // its lower bits are where stencil would be
      clear.stencil_value = static_cast<uint8_t>(clear.depth_value);
      clear.depth_value >>= 8;
    }
  }
  if (clear.rect.x0 >= clear.rect.x1 || clear.rect.y0 >= clear.rect.y1) {
    return true;
  }
  Packet& packet = impl_->add_packet();
  packet.is_clear = true;
  packet.clear = clear;
  return true;
} catch (const std::bad_alloc&) {
  return false;
}

void Frame::finish() {
  if (impl_->packet_count != 0) {
    impl_->execute();
    impl_->forget_recorded();
  }
}

bool Frame::empty() const { return impl_->packet_count == 0; }

}  // namespace clearpipe::pipeline
