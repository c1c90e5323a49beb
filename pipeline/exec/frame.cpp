// Recording a frame and running it: see frame.h.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/frame.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <new>
#include <vector>

#include "pipeline/exec/frame_data.h"
#include "pipeline/exec/record_arrays.h"
#include "pipeline/exec/workers.h"

namespace clearpipe::pipeline {

namespace {

// A frame that grows past this many primitives is executed so far, which bounds its memory.
constexpr uint32_t kMaxFramePrimitives = 128 * 1024;
constexpr size_t kMaxFrameDraws = 16 * 1024;

Rect intersect(const Rect& a, const Rect& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

}  // namespace

struct Frame::Impl {
  Target target;
  TileGrid grid;

  // Current state; the copies in the arena that draws point to are made when first drawn with.
  VertexState vertex_state;
  RasterState raster_state;
  FragmentState fragment_state;
  const VertexState* recorded_vertex = nullptr;
  std::shared_ptr<ProgramHolder> program;  // of fragment_state, null when it must be made

  Arena arena;
  std::vector<DrawRecord> draws;
  std::vector<std::shared_ptr<ProgramHolder>> programs;  // alive until the frame is done
  std::vector<std::unique_ptr<Packet>> packets;          // the first packet_count are in use
  size_t packet_count = 0;
  uint32_t primitive_total = 0;

  TileWork tile_work;
  std::vector<FrontWorkerPtr> front_workers;
  std::vector<std::unique_ptr<BackWorker>> back_workers;
  std::atomic<size_t> cursor{0};

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
    programs.clear();
    packet_count = 0;
    primitive_total = 0;
    recorded_vertex = nullptr;
    arena.reset();
    for (const FrontWorkerPtr& worker : front_workers) {
      if (worker) reset_front_worker(*worker);
    }
  }

  ProgramHolder& current_program() {
    if (!program) {
      auto holder = std::make_shared<ProgramHolder>();
      holder->state = fragment_state;
      if (target.colour && !target.colour->has_alpha) {
        holder->state.colour_mask &= 0x7;
      }
      if (!target.colour) {
        holder->state.colour_mask = 0;
      }
      if (target.depth_stencil) {
        holder->target.has_depth = target.depth_stencil->has_depth;
        holder->target.has_stencil = target.depth_stencil->has_stencil;
      }
      holder->target.multisampled = target.samples() > 1;
      holder->target.srgb = target.colour && target.colour->srgb;
      program = std::move(holder);
    }
    if (programs.empty() || programs.back() != program) {
      programs.push_back(program);
    }
    return *program;
  }

  // 3.2.1: multisample rasterization; 3.3, 3.4: antialiasing of points and lines, which sprites
  // ignore.
  FragmentCoverage coverage_of(Primitive primitive) const {
    const bool point = primitive == Primitive::kPoints;
    if (raster_state.multisample && target.samples() > 1) {
      return point ? FragmentCoverage::kMultisamplePoint : FragmentCoverage::kMultisample;
    }
    const bool line = primitive == Primitive::kLines || primitive == Primitive::kLineLoop ||
                      primitive == Primitive::kLineStrip;
    const bool smooth = (point && raster_state.point_smooth && !raster_state.point_sprite) ||
                        (line && raster_state.line_smooth);
    return smooth ? FragmentCoverage::kSmooth : FragmentCoverage::kCentre;
  }

  // Window y of window-system surfaces is computed as Mesa does, counting from the top; setup
  // mirrors the snapped value (docs/architecture.md, "Mesa's coverage").
  Viewport target_viewport() const {
    Viewport viewport = raster_state.viewport;
    if (!target.mirrored) {
      return viewport;
    }
    viewport.scale_y = -viewport.scale_y;
    viewport.centre_y = static_cast<float>(target.height) - viewport.centre_y;
    return viewport;
  }

  const VertexState* record_vertex_state() {
    auto* state = new (arena.allocate(sizeof(VertexState))) VertexState(vertex_state);
    if (const MatrixPalette* palette = state->palette) {
      state->palette = new (arena.allocate(sizeof(MatrixPalette))) MatrixPalette(*palette);
    }
    return state;
  }

  void record(const DrawCommand& command, uint32_t count) {
    DrawRecord draw;
    const FragmentCoverage coverage = coverage_of(command.primitive);
    draw.program = current_program().program(coverage);
    if (recorded_vertex == nullptr) {
      recorded_vertex = record_vertex_state();
    }
    draw.vertex = recorded_vertex;
    draw.setup.raster = raster_state;
    draw.setup.layout = make_vertex_layout(vertex_state);
    draw.setup.bounds = intersect(raster_state.scissor, {0, 0, target.width, target.height});
    draw.setup.coverage = coverage;
    draw.setup.point_fade_threshold = vertex_state.point_fade_threshold;
    draw.setup.inputs = fragment_inputs(*draw.program);
    draw.outputs = fragment_outputs(*draw.program);
    draw.setup.inputs.texture_units &= draw.setup.layout.texture_units;
    draw.setup.mirror_height = target.mirrored ? target.height : 0;
    draw.setup.two_sided = draw.setup.layout.back_colour_offset != 0;
    draw.clip.layout = draw.setup.layout;
    draw.clip.viewport = target_viewport();
    draw.clip.guard = make_guard_band(draw.clip.viewport);
    draw.clip.flat_shade = raster_state.flat_shade;
    if (draw.setup.bounds.x0 >= draw.setup.bounds.x1 ||
        draw.setup.bounds.y0 >= draw.setup.bounds.y1) {
      return;
    }
    draw.index_base = record_arrays(command, arena, draw.command);
    draws.push_back(std::move(draw));
    const uint32_t draw_index = static_cast<uint32_t>(draws.size() - 1);
    for (uint32_t first = 0; first < count;) {
      Packet& packet = open_packet();
      const uint32_t part = std::min(count - first, kPacketPrimitives - packet.primitive_count);
      packet.ranges.push_back({draw_index, first, part});
      packet.primitive_count += part;
      first += part;
    }
    primitive_total += count;
  }

  static void front_task(void* context, int worker) {
    Impl& frame = *static_cast<Impl*>(context);
    for (size_t i = frame.cursor.fetch_add(1); i < frame.packet_count;
         i = frame.cursor.fetch_add(1)) {
      if (!frame.packets[i]->is_clear) {
        run_front(*frame.front_workers[worker], frame.draws, frame.grid, *frame.packets[i]);
      }
    }
  }

  static void back_task(void* context, int worker) {
    Impl& frame = *static_cast<Impl*>(context);
    const size_t tiles = static_cast<size_t>(frame.grid.count());
    for (size_t i = frame.cursor.fetch_add(1); i < tiles; i = frame.cursor.fetch_add(1)) {
      run_back(frame.draws, frame.packets, frame.tile_work, frame.target, frame.grid,
               static_cast<int>(i), *frame.back_workers[worker]);
    }
  }

  void make_workers() {
    const size_t count = static_cast<size_t>(worker_count());
    while (front_workers.size() < count) {
      front_workers.push_back(make_front_worker());
    }
    while (back_workers.size() < count) {
      back_workers.push_back(std::make_unique<BackWorker>());
    }
  }

  void execute() {
    make_workers();
    if (!draws.empty()) {
      cursor = 0;
      run_on_workers(&front_task, this);
    }
    make_tile_work(packets, packet_count, grid, tile_work);
    cursor = 0;
    run_on_workers(&back_task, this);
  }
};

Frame::Frame() : impl_(std::make_unique<Impl>()) {}
Frame::~Frame() = default;

void Frame::set_target(const Target& target) {
  if (target.colour == impl_->target.colour &&
      target.depth_stencil == impl_->target.depth_stencil && target.width == impl_->target.width &&
      target.height == impl_->target.height && target.mirrored == impl_->target.mirrored) {
    return;
  }
  finish();
  impl_->target = target;
  impl_->grid = make_tile_grid(target.width, target.height);
  impl_->program.reset();
}

void Frame::set_vertex_state(const VertexState& state) {
  impl_->vertex_state = state;
  impl_->recorded_vertex = nullptr;
}

void Frame::set_raster_state(const RasterState& state) { impl_->raster_state = state; }

void Frame::set_fragment_state(const FragmentState& state) {
  impl_->fragment_state = state;
  impl_->program.reset();
}

bool Frame::draw(const DrawCommand& command) try {
  const uint32_t count = primitive_count(command.primitive, command.count);
  if (count == 0 || impl_->grid.count() == 0) {
    return true;
  }
  if (impl_->primitive_total >= kMaxFramePrimitives || impl_->draws.size() >= kMaxFrameDraws) {
    finish();
  }
  impl_->record(command, count);
  return true;
} catch (const std::bad_alloc&) {
  return false;
}

bool Frame::clear(const ClearCommand& command) try {
  ClearCommand clear = command;
  clear.rect = intersect(clear.rect, {0, 0, impl_->target.width, impl_->target.height});
  if (impl_->target.colour && !impl_->target.colour->has_alpha) {
    clear.colour_mask &= 0x7;
    // Alpha is 255 already; clearing it to the same keeps the clear a plain fill.
    if (clear.colour_mask == 0x7) {
      clear.colour_mask = 0xf;
      clear.colour_value |= 0xff000000u;
    }
  }
  // Bits that the buffer does not have may be cleared with the others: again a plain fill.
  if (const auto& planes = impl_->target.depth_stencil; planes && !planes->partial_view) {
    if (clear.depth && !planes->has_stencil) {
      clear.stencil = true;
      clear.stencil_mask = 0xff;
      clear.stencil_value = 0;
    }
    if (clear.stencil && !planes->has_depth) clear.depth = true;
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
