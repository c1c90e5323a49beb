// The layouts on every SIMD target, and rectangles of pixels: see unpack.h.
// SPDX-License-Identifier: MIT
#include "pipeline/unpack/unpack.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "pipeline/exec/pieces.h"
#include "pipeline/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/unpack/unpack.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "pipeline/unpack/unpack-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::unpack::HWY_NAMESPACE {

void UnpackPixels(UnpackLayout layout, const uint8_t* from, size_t count, uint32_t* to) {
  switch (layout) {
    case UnpackLayout::kRgba8:
      std::memcpy(to, from, count * sizeof(uint32_t));
      return;
    case UnpackLayout::kBgra8:
      return unpack_all<Bgra8>(from, count, to);
    case UnpackLayout::kRgb8:
      return unpack_all<Rgb8>(from, count, to);
    case UnpackLayout::kLuminanceAlpha8:
      return unpack_all<LuminanceAlpha8>(from, count, to);
    case UnpackLayout::kLuminance8:
      return unpack_all<Luminance8>(from, count, to);
    case UnpackLayout::kAlpha8:
      return unpack_all<Alpha8>(from, count, to);
    case UnpackLayout::kRgb565:
      return unpack_all<Rgb565>(from, count, to);
    case UnpackLayout::kRgba4444:
      return unpack_all<Rgba4444>(from, count, to);
    case UnpackLayout::kRgba5551:
      return unpack_all<Rgba5551>(from, count, to);
  }
}

}  // namespace clearpipe::pipeline::unpack::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace clearpipe::pipeline {
namespace unpack {

// Texels lie in memory as R, G, B, A: lanes are stored as they are.
static_assert(std::endian::native == std::endian::little);

HWY_EXPORT(UnpackPixels);

using UnpackFunction = void (*)(UnpackLayout, const uint8_t*, size_t, uint32_t*);

static UnpackFunction resolve() {
  select_simd_target();
  return static_cast<UnpackFunction>(HWY_DYNAMIC_DISPATCH(UnpackPixels));
}

namespace {

void unpack_rows(UnpackLayout layout, const UnpackRectangle& r, int begin, int end) {
  for (int y = begin; y < end; ++y) {
    unpack_pixels(layout, static_cast<const uint8_t*>(r.from) + y * r.row_bytes,
                  static_cast<size_t>(r.width), r.to + y * r.row_texels);
  }
}

}  // namespace
}  // namespace unpack

size_t bytes_of(UnpackLayout layout) {
  switch (layout) {
    case UnpackLayout::kRgba8:
    case UnpackLayout::kBgra8:
      return 4;
    case UnpackLayout::kRgb8:
      return 3;
    case UnpackLayout::kLuminance8:
    case UnpackLayout::kAlpha8:
      return 1;
    default:
      return 2;
  }
}

void unpack_pixels(UnpackLayout layout, const void* from, size_t count, uint32_t* to) {
  static const unpack::UnpackFunction function = unpack::resolve();
  if (count != 0) function(layout, static_cast<const uint8_t*>(from), count, to);
}

void unpack_rectangle(UnpackLayout layout, const UnpackRectangle& r) {
  if (r.width <= 0 || r.height <= 0) return;
  // Below this, waking threads costs more than they save.
  constexpr int64_t kManyTexels = 256 * 1024, kTexelsAtOnce = 32 * 1024;
  if (int64_t{r.width} * r.height < kManyTexels) {
    unpack::unpack_rows(layout, r, 0, r.height);
    return;
  }
  const int at_once = static_cast<int>(std::max<int64_t>(kTexelsAtOnce / r.width, 1));
  const int pieces = (r.height + at_once - 1) / at_once;
  run_pieces(static_cast<size_t>(pieces), [&](size_t i) {
    const int first = static_cast<int>(i) * at_once;
    unpack::unpack_rows(layout, r, first, std::min(first + at_once, r.height));
  });
}

}  // namespace clearpipe::pipeline
#endif
