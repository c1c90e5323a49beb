// What is known of the depths of a tile while its primitives are drawn: bounds, so that a primitive
// that lies behind all of them is not shaded, nor even covered (4.1.5 lets no difference be seen).
//
// A cleared tile has one depth. A primitive that covers the tile brings the bounds together again;
// others move the bound that their comparison lets them pass.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "pipeline/fragment/program.h"
#include "pipeline/merge/merge.h"
#include "pipeline/setup/primitive.h"

namespace clearpipe::pipeline {

// Depths as the buffer holds them.
struct DepthRange {
  uint32_t least = 0, most = 0xffffff;
};

// Bounds of what `plane` is in the pixels of a tile that are in the primitive's box, whatever the
// rounding of its evaluation. `one` is the buffer's value of depth 1.
DepthRange depth_range(const Plane& plane, float x_ref, float y_ref,
                       const PrimitiveRecord& primitive, const Tile& tile, float one);

class TileDepth {
 public:
  // A tile whose depth/stencil plane is this.
  explicit TileDepth(const TilePlane& plane);

  // Depths are cleared, all of them or some.
  void cleared(uint32_t depth, bool whole_tile);

  // Whether no fragment of this range passes the test, wherever it is.
  bool hides(CompareFunc func, const DepthRange& fragments) const;

  // Whether the bounds are such that a primitive of some range may be hidden; one that lies at the
  // very end of the buffer's range aside.
  bool may_hide(const DepthRule& rule) const;

  // Primitives of unknown depth are drawn with the rule.
  void drawn(const DepthRule& rule);
  // One of the range is drawn; it covers the whole tile, or only some of it.
  void drawn(const DepthRule& rule, const DepthRange& fragments, bool whole_tile);

 private:
  DepthRange stored_;
};

}  // namespace clearpipe::pipeline
