// Coverage against exact arithmetic: every pixel of random polygons, and the partition of the plane
// by triangles that share edges (3.5.1). Runs on the SIMD target that CLEARPIPE_SIMD selects.
// SPDX-License-Identifier: MIT
#include "pipeline/raster/coverage.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

namespace clearpipe::pipeline {
namespace {

constexpr int kSize = 192;  // three tiles by six

SetupState test_state() {
  SetupState state;
  state.bounds = {0, 0, kSize, kSize};
  return state;
}

std::vector<int> count_hits(const std::vector<PrimitiveRecord>& primitives) {
  std::vector<int> hits(kSize * kSize);
  for (const PrimitiveRecord& primitive : primitives) {
    for (int ty = 0; ty < kSize; ty += kTileHeight) {
      for (int tx = 0; tx < kSize; tx += kTileWidth) {
        Coverage coverage;
        if (!cover_tile(primitive, tx, ty, coverage)) continue;
        for (int row = coverage.first_row; row < coverage.last_row; ++row) {
          for (int x = 0; x < kTileWidth; ++x) {
            hits[(ty + row) * kSize + tx + x] += coverage.rows[row] >> x & 1;
          }
        }
      }
    }
  }
  return hits;
}

// The rule by exact arithmetic: positive, or zero on an edge that is left or bottom.
bool inside(const SnappedPoint* corners, int count, int px, int py) {
  int64_t area = 0;
  for (int i = 0; i < count; ++i) {
    const SnappedPoint &p = corners[i], &q = corners[(i + 1) % count];
    area += int64_t{p.x} * q.y - int64_t{q.x} * p.y;
  }
  for (int i = 0; i < count; ++i) {
    SnappedPoint p = corners[i], q = corners[(i + 1) % count];
    if (area < 0) std::swap(p, q);
    const int64_t dx = q.x - p.x, dy = q.y - p.y;
    const int64_t value = dx * (int64_t{py} * 256 - p.y) - dy * (int64_t{px} * 256 - p.x);
    const bool owned = dy < 0 || (dy == 0 && dx > 0);
    if (value < 0 || (value == 0 && !owned)) return false;
  }
  return true;
}

TEST(Coverage, EqualsExactArithmeticForRandomPolygons) {
  std::mt19937 random(1);
  const SetupState state = test_state();
  for (int round = 0; round < 400; ++round) {
    const int range = round % 3 == 0 ? 20000 : (round % 3 == 1 ? kSize * 256 : 6000000);
    std::uniform_int_distribution<int> coordinate(-range / 4, range);
    SnappedPoint corners[3];
    for (SnappedPoint& corner : corners) corner = {coordinate(random), coordinate(random)};
    PrimitiveRecord primitive;
    std::vector<int> hits(kSize * kSize);
    if (set_polygon(state, corners, 3, primitive)) hits = count_hits({primitive});
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        ASSERT_EQ(hits[y * kSize + x], inside(corners, 3, x, y) ? 1 : 0)
            << "round " << round << " pixel " << x << "," << y;
      }
    }
  }
}

TEST(Coverage, SharedEdgesHaveNoGapAndNoDoubleHit) {
  std::mt19937 random(2);
  const SetupState state = test_state();
  constexpr int kCells = 7;
  std::uniform_int_distribution<int> jitter(-1500, 1500);
  for (int round = 0; round < 20; ++round) {
    SnappedPoint grid[kCells + 1][kCells + 1];
    for (int j = 0; j <= kCells; ++j) {
      for (int i = 0; i <= kCells; ++i) {
        const bool border = i == 0 || j == 0 || i == kCells || j == kCells;
        grid[j][i] = {(i * kSize * 256) / kCells - 128 + (border ? 0 : jitter(random)),
                      (j * kSize * 256) / kCells - 128 + (border ? 0 : jitter(random))};
      }
    }
    std::vector<PrimitiveRecord> primitives;
    for (int j = 0; j < kCells; ++j) {
      for (int i = 0; i < kCells; ++i) {
        const SnappedPoint a[3] = {grid[j][i], grid[j][i + 1], grid[j + 1][i]};
        const SnappedPoint b[3] = {grid[j + 1][i], grid[j][i + 1], grid[j + 1][i + 1]};
        PrimitiveRecord primitive;
        if (set_polygon(state, a, 3, primitive)) primitives.push_back(primitive);
        if (set_polygon(state, b, 3, primitive)) primitives.push_back(primitive);
      }
    }
    for (const int hits : count_hits(primitives)) ASSERT_EQ(hits, 1) << "round " << round;
  }
}

TEST(Coverage, StaysInsideTheScissor) {
  SetupState state = test_state();
  state.bounds = {10, 20, 75, 61};
  const SnappedPoint corners[3] = {{-100000, -100000}, {400000, -100000}, {-100000, 400000}};
  PrimitiveRecord primitive;
  ASSERT_TRUE(set_polygon(state, corners, 3, primitive));
  const std::vector<int> hits = count_hits({primitive});
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      ASSERT_EQ(hits[y * kSize + x], x >= 10 && x < 75 && y >= 20 && y < 61 ? 1 : 0);
    }
  }
}

}  // namespace
}  // namespace clearpipe::pipeline
