// Bounds of a tile's depths: see tile_depth.h.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/tile_depth.h"

#include <algorithm>
#include <cmath>

namespace clearpipe::pipeline {

DepthRange depth_range(const Plane& plane, float x_ref, float y_ref,
                       const PrimitiveRecord& primitive, const Tile& tile, float one) {
  const auto centre = [](int pixel) { return static_cast<double>(pixel) + 0.5; };
  const double x0 = centre(std::max<int>(primitive.x0, tile.x)) - x_ref;
  const double x1 = centre(std::min<int>(primitive.x1, tile.x + kTileWidth) - 1) - x_ref;
  const double y0 = centre(std::max<int>(primitive.y0, tile.y)) - y_ref;
  const double y1 = centre(std::min<int>(primitive.y1, tile.y + kTileHeight) - 1) - y_ref;
  const double across0 = plane.dx * x0, across1 = plane.dx * x1;
  const double up0 = plane.dy * y0, up1 = plane.dy * y1;
  const double least = plane.value + std::min(across0, across1) + std::min(up0, up1);
  const double most = plane.value + std::max(across0, across1) + std::max(up0, up1);
  // Of six roundings in single precision, each is off by 2^-24 of the largest term at most.
  const double size = std::fabs(plane.value) + std::max(std::fabs(across0), std::fabs(across1)) +
                      std::max(std::fabs(up0), std::fabs(up1));
  const double slack = size * 0x1p-20;
  if (!std::isfinite(size)) return {0, static_cast<uint32_t>(one)};
  const double low = std::clamp(least - slack, 0.0, 1.0), high = std::clamp(most + slack, 0.0, 1.0);
  return {static_cast<uint32_t>(std::max(std::floor(low * one) - 1, 0.0)),
          static_cast<uint32_t>(std::min(std::ceil(high * one) + 1, static_cast<double>(one)))};
}

TileDepth::TileDepth(const TilePlane& plane) {
  if (plane.is_uniform()) stored_.least = stored_.most = plane.uniform_value() >> 8;
}

void TileDepth::cleared(uint32_t depth, bool whole_tile) {
  if (whole_tile) {
    stored_ = {depth, depth};
  } else {
    stored_ = {std::min(stored_.least, depth), std::max(stored_.most, depth)};
  }
}

bool TileDepth::hides(CompareFunc func, const DepthRange& fragments) const {
  switch (func) {
    case CompareFunc::kNever:
      return true;
    case CompareFunc::kLess:
      return fragments.least >= stored_.most;
    case CompareFunc::kLessEqual:
      return fragments.least > stored_.most;
    case CompareFunc::kGreater:
      return fragments.most <= stored_.least;
    case CompareFunc::kGreaterEqual:
      return fragments.most < stored_.least;
    case CompareFunc::kEqual:
      return fragments.least > stored_.most || fragments.most < stored_.least;
    default:
      return false;
  }
}

bool TileDepth::may_hide(const DepthRule& rule) const {
  if (!rule.test || !rule.traceless) return false;
  switch (rule.func) {
    case CompareFunc::kLess:
    case CompareFunc::kLessEqual:
      return stored_.most < static_cast<uint32_t>(rule.one);
    case CompareFunc::kGreater:
    case CompareFunc::kGreaterEqual:
      return stored_.least > 0;
    case CompareFunc::kNever:
      return true;
    case CompareFunc::kEqual:
      return stored_.least > 0 || stored_.most < static_cast<uint32_t>(rule.one);
    default:
      return false;
  }
}

void TileDepth::drawn(const DepthRule& rule) { drawn(rule, {}, false); }

void TileDepth::drawn(const DepthRule& rule, const DepthRange& fragments, bool whole_tile) {
  if (!rule.write) return;
  // What is stored is the lesser of both, the greater, or any.
  const bool lesser = rule.func == CompareFunc::kLess || rule.func == CompareFunc::kLessEqual;
  const bool greater =
      rule.func == CompareFunc::kGreater || rule.func == CompareFunc::kGreaterEqual;
  const bool all = whole_tile && !rule.discards;
  if (all && rule.func == CompareFunc::kAlways) {
    stored_ = fragments;
    return;
  }
  if (!greater && rule.func != CompareFunc::kEqual) {
    stored_.least = std::min(stored_.least, fragments.least);
  }
  if (!lesser && rule.func != CompareFunc::kEqual) {
    stored_.most = std::max(stored_.most, fragments.most);
  }
  if (all && lesser) stored_.most = std::min(stored_.most, fragments.most);
  if (all && greater) stored_.least = std::max(stored_.least, fragments.least);
}

}  // namespace clearpipe::pipeline
