// Recording a frame and running it: see frame.h.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/frame.h"

#include <algorithm>
#include <new>
#include <span>
#include <vector>

#include "pipeline/exec/dots.h"
#include "pipeline/exec/strokes.h"
#include "pipeline/exec/draw_state.h"
#include "pipeline/exec/execution.h"
#include "pipeline/exec/frame_data.h"
#include "pipeline/exec/record_arrays.h"
#include "pipeline/exec/workers.h"
#include "pipeline/fetch_ahead.h"

namespace clearpipe::pipeline {

namespace {

// A frame that grows past this many primitives is executed so far, which bounds its memory.
constexpr uint32_t kMaxFramePrimitives = 128 * 1024;

// With so many draws since the last time, a packet that is full may be worth waking the workers.
constexpr size_t kStartedDraws = 128;

}  // namespace

struct Frame::Impl {
  TileGrid grid;
  CurrentState state;
  ArrayRecorder arrays;
  Arena arena;
  DrawList draws;
  std::vector<std::unique_ptr<Packet>> packets;  // the first packet_count are in use
  size_t packet_count = 0;
  uint32_t primitive_total = 0;

  // Packets and draws before these are executed, and perhaps started; all packets that are counted
  // in packets_seen were thought of when it was last asked whether to start some.
  size_t executed_packets = 0, executed_draws = 0;
  size_t started_packets = 0, started_draws = 0;
  size_t packets_seen = 1;
  alignas(64) Execution execution;  // which workers look at while all the rest changes

  Packet& add_packet() {
    if (packet_count == packets.size()) {
      packets.push_back(std::make_unique<Packet>());
    }
    Packet& packet = *packets[packet_count];
    packet.reset();
    ++packet_count;
    return packet;
  }

  // The last packet, if primitives may still be added to it; else null.
  Packet* last_packet() {
    if (packet_count == started_packets) return nullptr;
    Packet& last = *packets[packet_count - 1];
    return last.is_clear || last.primitive_count >= last.most ? nullptr : &last;
  }

  // One for primitives of a draw. A large one is for one draw alone.
  Packet& open_packet(uint32_t draw_index, uint32_t most) {
    Packet* last = last_packet();
    if (last != nullptr && !last->is_dots && last->most == most &&
        (most == kPacketPrimitives || last->ranges.back().draw == draw_index)) {
      return *last;
    }
    Packet& packet = add_packet();
    packet.most = most;
    return packet;
  }
  // One for dots of a draw.
  Packet& open_dots(uint32_t draw_index) {
    Packet* last = last_packet();
    if (last != nullptr && last->is_dots &&
        draws[last->ranges.back().draw].state == draws[draw_index].state) {
      return *last;
    }
    Packet& packet = add_packet();
    packet.is_dots = true;
    packet.most = kPacketDots;
    return packet;
  }

  void forget_recorded() {
    draws.clear();
    packet_count = executed_packets = executed_draws = started_packets = started_draws = 0;
    packets_seen = 1;
    primitive_total = 0;
    state.reset();
    arrays.reset();
    arena.reset();
    execution.forget();
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
    if (draws.size() != started_draws && continues(draws.back(), draw)) {
      skipped = primitive_count(draw.primitive, draws.back().count);
      draws.back().count += draw.count;
    } else {
      draws.push_back(draw);
    }
    const auto index = static_cast<uint32_t>(draws.size() - 1);
    const bool dots = draws_dots(command, draw) && (count >= kLeastDots || ends_in_dots(index));
    add_primitives(index, skipped, count, dots);
    primitive_total += count;
  }

  // Whether dots of the draw were the last to be recorded.
  bool ends_in_dots(uint32_t draw_index) {
    const Packet* last = last_packet();
    return last != nullptr && last->is_dots && last->ranges.back().draw == draw_index;
  }

  void add_primitives(uint32_t draw_index, uint32_t first, uint32_t count, bool dots) {
    const uint32_t end = first + count;
    const uint32_t most =
        draws[draw_index].state->draws_strokes ? packet_strokes(count) : kPacketPrimitives;
    while (first < end) {
      Packet& packet = dots ? open_dots(draw_index) : open_packet(draw_index, most);
      uint32_t part = std::min(end - first, packet.most - packet.primitive_count);
      const bool goes_on = !packet.ranges.empty() && packet.ranges.back().draw == draw_index;
      // The front phase takes so many at once.
      const uint32_t in_range =
          goes_on ? packet.ranges.back().primitive_count % kPacketPrimitives : 0;
      if (!dots) part = std::min(part, kPacketPrimitives - in_range);
      if (goes_on && (dots || in_range != 0)) {
        packet.ranges.back().primitive_count += part;
      } else {
        constexpr size_t kAhead = 16;
        if (packet.ranges.size() + kAhead < packet.ranges.capacity()) {
          fetch_to_write(packet.ranges.data() + packet.ranges.size() + kAhead);
        }
        packet.ranges.push_back({draw_index, first, part});
      }
      packet.primitive_count += part;
      first += part;
    }
  }

  // Lets the workers begin with what is recorded, where recording takes long enough: but for the
  // last packet, to which draws may be added.
  void start_some() {
    if (packet_count <= packets_seen) return;
    packets_seen = packet_count;
    if (draws.size() - started_draws < kStartedDraws || worker_count() == 1) return;
    if (execution.is_started() && !execution.is_done()) return;
    finish_started();
    prepare(packet_count - 1);
    arrays.leave_room();
    started_packets = packet_count - 1;
    started_draws = draws.size();
    execution.start();
  }

  // All from the first packet that is not executed to that of number `end`.
  void prepare(size_t end) {
    const std::span<const std::unique_ptr<Packet>> all(packets);
    execution.prepare(draws, executed_draws, all.subspan(executed_packets, end - executed_packets),
                      state.target(), grid, arena);
  }

  void finish_started() {
    if (!execution.is_started()) return;
    if (!execution.finish()) throw std::bad_alloc();
    executed_packets = started_packets;
    executed_draws = started_draws;
  }

  void execute() {
    finish_started();
    if (executed_packets == packet_count) return;
    prepare(packet_count);
    if (!execution.run()) throw std::bad_alloc();
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
  if (impl_->primitive_total >= kMaxFramePrimitives || impl_->draws.size() == DrawList::kMaxDraws ||
      impl_->state.is_full()) {
    finish();
  }
  impl_->start_some();
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
