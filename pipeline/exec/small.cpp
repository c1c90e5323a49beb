// Small primitives of a tile: from their records to pixels, on every SIMD target. See small.h.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/small.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <new>
#include <type_traits>

#include "pipeline/exec/frame_data.h"
#include "pipeline/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/exec/small.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "pipeline/fragment/small-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::exec::HWY_NAMESPACE {

using fragment::HWY_NAMESPACE::SmallBatch;

void begin(std::byte* memory, const FragmentProgram& program, Tile& tile) {
  static_assert(std::is_trivially_destructible_v<SmallBatch>);
  static_assert(sizeof(SmallBatch) <= SmallShader::kBatchBytes);
  new (memory) SmallBatch(program, tile);
}

size_t add(std::byte* memory, const std::vector<DrawRecord>& draws, const Packet& packet,
           std::span<const uint32_t> entries, Tile& tile) {
  SmallBatch& batch = *std::launder(reinterpret_cast<SmallBatch*>(memory));
  const SmallPrimitive* primitives = packet.small.data();
  uint32_t range = ~0u;
  const DrawState* draw = nullptr;
  const float* records = nullptr;
  size_t stride = 0;
  size_t taken = 0;
  for (; taken < entries.size() && (entries[taken] & kSmallEntry) != 0; ++taken) {
    const SmallPrimitive& primitive = primitives[entries[taken] & ~kSmallEntry];
    // If that entry's is no small primitive, the address is of nothing, which is no harm.
    const size_t ahead = std::min(taken + 4, entries.size() - 1);
    hwy::Prefetch(primitives + (entries[ahead] & ~kSmallEntry));
    if (primitive.range != range) {
      range = primitive.range;
      const DrawState& next = *draws[packet.ranges[range].draw].state;
      if (draw != nullptr && next.program != draw->program) break;
      draw = &next;
      batch.set_state(draw->setup);
      records = packet.records[range];
      stride = draw->setup.layout.stride;
    }
    const float* const vertex[3] = {records + primitive.vertex[0] * stride,
                                    records + primitive.vertex[1] * stride,
                                    records + primitive.vertex[2] * stride};
    const SmallCoverage coverage =
        small_coverage(primitive.mask, primitive.x, primitive.y, tile.x, tile.y);
    batch.add(primitive.kind, primitive.back_facing, primitive.size, vertex,
              std::span<const SmallCoverage, 1>(&coverage, 1));
  }
  return taken;
}

void add_squares(std::byte* memory, const SetupState& state, const PrimitiveRecord& primitive,
                 const CoveredSquares& squares) {
  SmallBatch& batch = *std::launder(reinterpret_cast<SmallBatch*>(memory));
  batch.set_state(state);
  batch.add(primitive.kind, primitive.back_facing, primitive.size, primitive.vertex,
            std::span(squares.square).first(static_cast<size_t>(squares.count)));
}

void flush(std::byte* memory) { std::launder(reinterpret_cast<SmallBatch*>(memory))->flush(); }

const SmallKernels* kernels() {
  static constexpr SmallKernels kKernels = {&begin, &add, &add_squares, &flush};
  return &kKernels;
}

}  // namespace clearpipe::pipeline::exec::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace clearpipe::pipeline {
namespace exec {

HWY_EXPORT(kernels);

static const SmallKernels& resolve() {
  static const SmallKernels& resolved = []() -> const SmallKernels& {
    select_simd_target();
    return *HWY_DYNAMIC_DISPATCH(kernels)();
  }();
  return resolved;
}

}  // namespace exec

bool draws_small(const DrawRecord& draw) {
  return draw.state->setup.coverage == FragmentCoverage::kCentre &&
         batches_small(*draw.state->program);
}

size_t SmallShader::add(const std::vector<DrawRecord>& draws, const Packet& packet,
                        std::span<const uint32_t> entries, Tile& tile) {
  const SmallPrimitive& first = packet.small[entries[0] & ~kSmallEntry];
  const FragmentProgram* program = draws[packet.ranges[first.range].draw].state->program;
  begin(*program, tile);
  return exec::resolve().add(batch_, draws, packet, entries, tile);
}

void SmallShader::add(const DrawState& draw, const PrimitiveRecord& primitive,
                      const CoveredSquares& squares, Tile& tile) {
  begin(*draw.program, tile);
  exec::resolve().add_squares(batch_, draw.setup, primitive, squares);
}

void SmallShader::begin(const FragmentProgram& program, Tile& tile) {
  if (program_ == &program) return;
  flush();
  program_ = &program;
  exec::resolve().begin(batch_, program, tile);
}

void SmallShader::flush() {
  if (program_ == nullptr) return;
  exec::resolve().flush(batch_);
  program_ = nullptr;
}

}  // namespace clearpipe::pipeline
#endif  // HWY_ONCE
