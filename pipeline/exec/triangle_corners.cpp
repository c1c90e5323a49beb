// Corners of triangles, on every SIMD target: see triangle_corners.h.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/triangle_corners.h"

#include <cstring>

#include "pipeline/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/exec/triangle_corners.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::exec::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class Index>
void list_corners(const std::byte* indices, size_t triangles, uint32_t first,
                  int32_t* const (&corner)[3]) {
  const hn::CappedTag<int32_t, 16> d;
  const hn::RebindToUnsigned<decltype(d)> du;
  const hn::Rebind<Index, decltype(d)> d_index;
  const size_t lanes = hn::Lanes(d);
  const auto less = hn::Set(du, first);
  size_t i = 0;
  for (; i + lanes <= triangles; i += lanes) {
    hn::Vec<decltype(d_index)> index[3];
    hn::LoadInterleaved3(d_index, reinterpret_cast<const Index*>(indices) + 3 * i, index[0],
                         index[1], index[2]);
    for (int k = 0; k < 3; ++k) {
      hn::Vec<decltype(du)> element;
      if constexpr (sizeof(Index) == sizeof(uint32_t)) {
        element = index[k];
      } else {
        element = hn::PromoteTo(du, index[k]);
      }
      hn::StoreU(hn::BitCast(d, hn::Sub(element, less)), d, corner[k] + i);
    }
  }
  for (; i < triangles; ++i) {
    Index index[3];
    std::memcpy(index, indices + i * sizeof(index), sizeof(index));
    for (int k = 0; k < 3; ++k) corner[k][i] = static_cast<int32_t>(index[k] - first);
  }
}

void ListCorners(IndexType type, const std::byte* indices, size_t triangles, uint32_t first,
                 int32_t* const (&corner)[3]) {
  switch (type) {
    case IndexType::kNone:
      break;
    case IndexType::kUnsignedByte:
      return list_corners<uint8_t>(indices, triangles, first, corner);
    case IndexType::kUnsignedShort:
      return list_corners<uint16_t>(indices, triangles, first, corner);
    case IndexType::kUnsignedInt:
      return list_corners<uint32_t>(indices, triangles, first, corner);
  }
}

}  // namespace clearpipe::pipeline::exec::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace clearpipe::pipeline {
namespace exec {

HWY_EXPORT(ListCorners);

using CornersFunction = void (*)(IndexType, const std::byte*, size_t, uint32_t,
                                 int32_t* const (&)[3]);

static CornersFunction resolve_corners() {
  select_simd_target();
  return static_cast<CornersFunction>(HWY_DYNAMIC_DISPATCH(ListCorners));
}

}  // namespace exec

void triangle_corners(IndexType type, const std::byte* indices, size_t triangles, uint32_t first,
                      int32_t* const (&corner)[3]) {
  static const exec::CornersFunction function = exec::resolve_corners();
  function(type, indices, triangles, first, corner);
}

}  // namespace clearpipe::pipeline
#endif  // HWY_ONCE
