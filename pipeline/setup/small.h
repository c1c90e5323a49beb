// Small primitives: those whose pixels lie in a square of 8x8, which then are one 64-bit mask.
//
// A mesh is made of them, and what a tile does for each primitive - edge functions, planes, a loop
// over rows - costs more than their pixels. So their coverage is found before they are binned (what
// covers nothing goes no further), and a tile shades the pixels of many of them at once
// (fragment/small-inl.h). Only of primitives that are covered by centres (3.5.1), not by samples.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "pipeline/raster/tile.h"
#include "pipeline/setup/primitive.h"

namespace clearpipe::pipeline {

inline constexpr int kSmallSide = 8;

struct SmallPrimitive {
  uint64_t mask;  // bit 8 * j + i: pixel (x + i, y + j) is covered
  int16_t x, y;
  uint32_t vertex[3];  // numbers of vertex records in the range; points use one, lines two
  float size;          // as in PrimitiveRecord
  uint16_t range;      // number in the packet's ranges
  PrimitiveKind kind;
  bool back_facing;
};

// The pixels of a small primitive that lie in a tile: bit 8 * j + i is pixel (column + i, row + j)
// of the tile. All bits that are set are inside the tile. The square must touch the tile.
struct SmallCoverage {
  uint64_t mask;
  int column, row;
};

inline SmallCoverage small_coverage(uint64_t mask, int x, int y, int tile_x, int tile_y) {
  constexpr uint64_t kEachRow = 0x0101010101010101u;
  int column = x - tile_x, row = y - tile_y;
  if (column < 0) {
    mask = mask >> -column & kEachRow * (0xffu >> -column);
    column = 0;
  } else if (column > kTileWidth - kSmallSide) {
    mask &= kEachRow * (0xffu >> (column - (kTileWidth - kSmallSide)));
  }
  if (row < 0) {
    mask >>= kSmallSide * -row;
    row = 0;
  } else if (row > kTileHeight - kSmallSide) {
    mask &= ~uint64_t{0} >> (kSmallSide * (row - (kTileHeight - kSmallSide)));
  }
  return {mask, column, row};
}

// Whether the box of a primitive after setup is small enough.
inline bool is_small(const PrimitiveRecord& primitive) {
  return primitive.x1 - primitive.x0 <= kSmallSide && primitive.y1 - primitive.y0 <= kSmallSide;
}

// Makes a small primitive of one whose box is small and whose pixels are decided by their centres;
// false when it covers none. The vertices and the range are left to the caller.
bool make_small(const PrimitiveRecord& primitive, SmallPrimitive& out);

// The planes of a small primitive (PrimitivePlanes, fragment/program.h), those of an attribute's
// components beside each other.
struct SmallPlanes {
  struct Four {
    alignas(16) float value[4], dx[4], dy[4];

    Plane plane(int i) const { return {value[i], dx[i], dy[i]}; }
  };

  float x_ref = 0, y_ref = 0;
  bool perspective = false, flat_colour = false;
  Four window;     // x, y, z, 1/w: the last two are used
  Four fog_group;  // the group of the vertex record that the fog coordinate is in
  Four colour;
  Four texture[kMaxTextureUnits];
};
inline constexpr int kDepthPlane = 2, kInverseWPlane = 3;                        // of window
inline constexpr int kFogPlane = vertex_record::kFog - vertex_record::kOutcode;  // of fog_group

// What planes are made of.
struct PlaneSource {
  const float* vertex[3];  // vertex records, as many as the kind has
  float size;
  PrimitiveKind kind;
  bool back_facing;
};

// `records` are the vertex records of the range.
inline PlaneSource plane_source(const SmallPrimitive& p, const float* records, size_t stride) {
  const auto vertex = [&](int i) { return records + p.vertex[i] * stride; };
  const bool line = p.kind == PrimitiveKind::kLine, triangle = p.kind == PrimitiveKind::kTriangle;
  return {{vertex(0), line || triangle ? vertex(1) : nullptr, triangle ? vertex(2) : nullptr},
          p.size,
          p.kind,
          p.back_facing};
}

inline PlaneSource plane_source(const PrimitiveRecord& p) {
  return {{p.vertex[0], p.vertex[1], p.vertex[2]}, p.size, p.kind, p.back_facing};
}

// As make_planes (primitive.h) has them.
void make_small_planes(const SetupState& state, const PlaneSource& source, SmallPlanes& out);

}  // namespace clearpipe::pipeline
