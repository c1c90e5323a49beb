// The least and the greatest index, on every SIMD target: see index_range.h.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/index_range.h"

#include <algorithm>
#include <cstring>

#include "pipeline/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/exec/index_range.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::exec::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class T>
IndexRange range_of(const std::byte* indices, size_t count) {
  const hn::ScalableTag<T> d;
  const size_t lanes = hn::Lanes(d);
  auto least = hn::Set(d, static_cast<T>(~T{0})), greatest = hn::Zero(d);
  size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    const auto v = hn::LoadU(d, reinterpret_cast<const T*>(indices) + i);
    least = hn::Min(least, v);
    greatest = hn::Max(greatest, v);
  }
  HWY_ALIGN T low[hn::MaxLanes(d)], high[hn::MaxLanes(d)];
  hn::Store(least, d, low);
  hn::Store(greatest, d, high);
  IndexRange range{*std::min_element(low, low + lanes), *std::max_element(high, high + lanes)};
  for (; i < count; ++i) {
    T value;
    std::memcpy(&value, indices + i * sizeof(T), sizeof(value));
    range.least = std::min<uint32_t>(range.least, value);
    range.greatest = std::max<uint32_t>(range.greatest, value);
  }
  return range;
}

IndexRange FindRange(IndexType type, const std::byte* indices, size_t count) {
  switch (type) {
    case IndexType::kNone:
      break;
    case IndexType::kUnsignedByte:
      return range_of<uint8_t>(indices, count);
    case IndexType::kUnsignedShort:
      return range_of<uint16_t>(indices, count);
    case IndexType::kUnsignedInt:
      return range_of<uint32_t>(indices, count);
  }
  return {};
}

}  // namespace clearpipe::pipeline::exec::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace clearpipe::pipeline {
namespace exec {

HWY_EXPORT(FindRange);

using RangeFunction = IndexRange (*)(IndexType, const std::byte*, size_t);

static RangeFunction resolve_range() {
  select_simd_target();
  return static_cast<RangeFunction>(HWY_DYNAMIC_DISPATCH(FindRange));
}

}  // namespace exec

IndexRange index_range(IndexType type, const std::byte* indices, size_t count) {
  static const exec::RangeFunction function = exec::resolve_range();
  return function(type, indices, count);
}

}  // namespace clearpipe::pipeline
#endif  // HWY_ONCE
