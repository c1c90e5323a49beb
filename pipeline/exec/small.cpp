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
using fragment::HWY_NAMESPACE::SmallScratch;
using fragment::HWY_NAMESPACE::SquareParts;
using fragment::HWY_NAMESPACE::WholeSquare;

SmallBatch& batch_of(std::byte* memory) {
  return *std::launder(reinterpret_cast<SmallBatch*>(memory));
}

void begin(std::byte* memory, std::byte* other, std::byte* scratch, const FragmentProgram& program,
           Tile& tile) {
  static_assert(std::is_trivially_destructible_v<SmallBatch>);
  static_assert(sizeof(SmallBatch) <= SmallShader::kBatchBytes);
  static_assert(sizeof(SmallScratch) <= SmallShader::kScratchBytes);
  if (other != nullptr) batch_of(other).share();
  new (memory) SmallBatch(program, tile, *new (scratch) SmallScratch, other == nullptr);
}

template <class Parts>
HWY_INLINE void keep_order(SmallBatch* other, const Parts& pixels) {
  if (other != nullptr && other->has(pixels)) other->flush();
}

size_t add(std::byte* memory, std::byte* other_memory, const DrawList& draws, const Packet& packet,
           std::span<const uint32_t> entries, Tile& tile) {
  SmallBatch& batch = batch_of(memory);
  SmallBatch* const other = other_memory != nullptr ? &batch_of(other_memory) : nullptr;
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
    hwy::Prefetch(primitives + (entries[ahead] & ~(kSmallEntry | kStrokeEntry)));
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
    batch.add<SquareParts>(primitive.kind, primitive.back_facing, primitive.size, vertex,
                           std::span<const SmallCoverage, 1>(&coverage, 1),
                           [other](const SquareParts& parts)
                               HWY_ATTR { keep_order(other, parts); });
  }
  return taken;
}

void add_squares(std::byte* memory, std::byte* other_memory, const SetupState& state,
                 const PrimitiveRecord& primitive, const CoveredSquares& squares) {
  SmallBatch& batch = batch_of(memory);
  SmallBatch* const other = other_memory != nullptr ? &batch_of(other_memory) : nullptr;
  batch.set_state(state);
  batch.add<WholeSquare>(primitive.kind, primitive.back_facing, primitive.size, primitive.vertex,
                         std::span(squares.square).first(static_cast<size_t>(squares.count)),
                         [other](const WholeSquare& square)
                             HWY_ATTR { keep_order(other, square); });
}

void flush(std::byte* memory) { batch_of(memory).flush(); }

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

bool draws_narrow(const DrawRecord& draw) {
  const FragmentCoverage coverage = draw.state->setup.coverage;
  return (coverage == FragmentCoverage::kCentre || coverage == FragmentCoverage::kSmooth) &&
         batches_small(*draw.state->program);
}

size_t SmallShader::add(const DrawList& draws, const Packet& packet,
                        std::span<const uint32_t> entries, Tile& tile) {
  const SmallPrimitive& first = packet.small[entries[0] & ~kSmallEntry];
  const FragmentProgram* program = draws[packet.ranges[first.range].draw].state->program;
  find(*program, tile);
  return exec::resolve().add(batches_[last_].memory, other_memory(), draws, packet, entries, tile);
}

void SmallShader::add(const DrawState& draw, const PrimitiveRecord& primitive,
                      const CoveredSquares& squares, Tile& tile) {
  find(*draw.program, tile);
  exec::resolve().add_squares(batches_[last_].memory, other_memory(), draw.setup, primitive,
                              squares);
}

void SmallShader::find(const FragmentProgram& program, Tile& tile) {
  if (batches_[last_].program == &program) return;
  last_ = 1 - last_;
  Batch& batch = batches_[last_];
  if (batch.program == &program) return;
  if (batch.program != nullptr) exec::resolve().flush(batch.memory);
  batch.program = &program;
  exec::resolve().begin(batch.memory, other_memory(), scratch_, program, tile);
}

void SmallShader::flush() {
  for (Batch& batch : batches_) {
    if (batch.program != nullptr) exec::resolve().flush(batch.memory);
    batch.program = nullptr;
  }
}

}  // namespace clearpipe::pipeline
#endif  // HWY_ONCE
