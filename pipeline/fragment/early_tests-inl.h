// The depth and stencil tests of a whole coverage before anything else is computed, where nothing
// can be seen of their place (4.1.4, 4.1.5): pixels that fail leave the coverage.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_EARLY_TESTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_EARLY_TESTS_INL_H_
#undef CLEARPIPE_FRAGMENT_EARLY_TESTS_INL_H_
#else
#define CLEARPIPE_FRAGMENT_EARLY_TESTS_INL_H_
#endif

#include <hwy/highway.h>

#include <bit>
#include <cstring>
#include <type_traits>

#include "pipeline/fragment/depth_stencil-inl.h"
#include "pipeline/fragment/split_plane-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Lanes of a row mask as a mask of vectors, and back.
template <class D>
HWY_INLINE hn::Mask<D> mask_of_bits(D d, uint64_t bits) {
  uint8_t bytes[8];
  std::memcpy(bytes, &bits, sizeof(bytes));
  return hn::LoadMaskBits(d, bytes);
}
template <class D>
HWY_INLINE uint64_t bits_of_mask(D d, hn::Mask<D> mask) {
  uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  uint32_t bits;
  std::memcpy(&bits, bytes, sizeof(bits));
  return bits;
}

template <class Stencil, class State>
HWY_INLINE void test_rows(const Stencil& stencil, const State& depth, const SplitPlane& z,
                          Tile& tile, Coverage& coverage) {
  const hn::ScalableTag<float> df;
  const hn::RebindToSigned<decltype(df)> d;
  constexpr int kLanes = static_cast<int>(hn::MaxLanes(df));
  constexpr uint64_t kAll = (uint64_t{1} << kLanes) - 1;
  auto* row_values = reinterpret_cast<int32_t*>(tile.depth_stencil);
  for (int row = coverage.first_row; row < coverage.last_row; ++row) {
    const uint64_t covered = coverage.rows[row];
    int32_t* const stored = row_values + row * kTileWidth;
    uint64_t kept = 0;
    for (int x = 0; x < kTileWidth; x += kLanes) {
      const uint64_t bits = covered >> x & kAll;
      if (bits == 0) continue;
      const auto value = depth.test ? to_depth_value(df, depth, z.at(row, x)) : hn::Zero(d);
      auto packed = hn::Load(d, stored + x);
      const auto passes =
          depth_stencil_test(d, stencil, depth, mask_of_bits(d, bits), value, packed);
      if (depth.write || stencil.enabled) hn::Store(packed, d, stored + x);
      kept |= bits_of_mask(d, passes) << x;
    }
    coverage.rows[row] = kept;
  }
}

template <class Stencil>
inline void test_early(const Stencil& stencil, const DepthState& depth, const SplitPlane& z,
                       Tile& tile, Coverage& coverage) {
  const auto test = [&](auto func) {
    if (z.lies_within(coverage.first_row, coverage.last_row, 0.0f, 1.0f)) {
      test_rows(stencil, KnownDepthState<func(), true>{depth.write, depth.most}, z, tile, coverage);
    } else {
      test_rows(stencil, KnownDepthState<func(), false>{depth.write, depth.most}, z, tile,
                coverage);
    }
  };
  if (!depth.test || depth.whole) {
    test_rows(stencil, depth, z, tile, coverage);
  } else if (depth.func == CompareFunc::kLess) {
    test(std::integral_constant<CompareFunc, CompareFunc::kLess>());
  } else if (depth.func == CompareFunc::kLessEqual) {
    test(std::integral_constant<CompareFunc, CompareFunc::kLessEqual>());
  } else {
    test_rows(stencil, NarrowDepthState(depth), z, tile, coverage);
  }
}

// `plane` is the depth, relative to the reference of `planes`. Values are read and written in the
// tile.
inline void test_early(const FragmentProgram& program, const PrimitivePlanes& planes,
                       const Plane& plane, Tile& tile, Coverage& coverage) {
  const DepthState depth = depth_state(program);
  SplitPlane z;
  if (depth.test) z.set(plane, TilePlaces(tile, planes));
  if (program.stencil.enabled) {
    test_early(program.stencil, depth, z, tile, coverage);
  } else {
    test_early(NoStencilState(), depth, z, tile, coverage);
  }
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
