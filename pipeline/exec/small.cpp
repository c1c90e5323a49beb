// Small primitives of a tile: see small.h.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/small.h"

#include "pipeline/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/exec/small.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "pipeline/fragment/small-inl.h"
#include "pipeline/setup/small_planes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {

size_t ShadeSmall(const std::vector<DrawRecord>& draws, const DrawState& state,
                  const SmallPrimitive* primitives, std::span<const uint32_t> entries, Tile& tile) {
  SmallBatch batch(*state.program, tile);
  PrimitivePlanes planes;
  size_t taken = 0;
  for (; taken < entries.size() && (entries[taken] & kSmallEntry) != 0; ++taken) {
    const SmallPrimitive& primitive = primitives[entries[taken] & ~kSmallEntry];
    if (draws[primitive.draw].state != &state) break;
    const SmallCoverage coverage =
        small_coverage(primitive.mask, primitive.x, primitive.y, tile.x, tile.y);
    setup::HWY_NAMESPACE::small_planes(state.setup, primitive, planes);
    batch.add(planes, coverage);
  }
  batch.flush();
  return taken;
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace clearpipe::pipeline {
namespace fragment {

HWY_EXPORT(ShadeSmall);

using ShadeSmallFunction = size_t (*)(const std::vector<DrawRecord>&, const DrawState&,
                                      const SmallPrimitive*, std::span<const uint32_t>, Tile&);

static ShadeSmallFunction resolve() {
  select_simd_target();
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return static_cast<ShadeSmallFunction>(HWY_DYNAMIC_DISPATCH(ShadeSmall));
}

}  // namespace fragment

bool draws_small(const DrawState& draw) {
  return draw.setup.coverage == FragmentCoverage::kCentre && batches_small(*draw.program);
}

size_t shade_small(const std::vector<DrawRecord>& draws, const DrawState& state,
                   const SmallPrimitive* primitives, std::span<const uint32_t> entries,
                   Tile& tile) {
  static const fragment::ShadeSmallFunction function = fragment::resolve();
  return function(draws, state, primitives, entries, tile);
}

}  // namespace clearpipe::pipeline
#endif  // HWY_ONCE
