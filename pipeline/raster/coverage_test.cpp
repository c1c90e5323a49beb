// Coverage against exact arithmetic: every pixel of random polygons, and the partition of the plane
// by triangles that share edges (3.5.1); as rows and as squares. Runs on the SIMD target that
// CLEARPIPE_SIMD selects.
// SPDX-License-Identifier: MIT
#include "pipeline/raster/coverage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "pipeline/bin/bins.h"
#include "pipeline/raster/squares.h"

namespace clearpipe::pipeline {
namespace {

constexpr int kSize = 192;  // three tiles by six

SetupState test_state() {
  SetupState state;
  state.bounds = {0, 0, kSize, kSize};
  return state;
}

// Squares have the pixels that rows have, and none is empty.
void expect_same_squares(const PrimitiveRecord& primitive, int tx, int ty, const Coverage& rows) {
  CoveredSquares squares;
  if (!cover_squares(primitive, tx, ty, squares)) squares.count = 0;
  uint64_t covered[kTileHeight] = {};
  for (int i = 0; i < squares.count; ++i) {
    const SmallCoverage& square = squares.square[i];
    EXPECT_NE(square.mask, 0u);
    for (int j = 0; j < kSmallSide; ++j) {
      covered[square.row + j] |= (square.mask >> (kSmallSide * j) & 0xff) << square.column;
    }
  }
  for (int row = 0; row < kTileHeight; ++row) {
    const bool used = row >= rows.first_row && row < rows.last_row;
    ASSERT_EQ(covered[row], used ? rows.rows[row] : 0) << "tile " << tx << "," << ty;
  }
}

std::vector<int> count_hits(const std::vector<PrimitiveRecord>& primitives) {
  std::vector<int> hits(kSize * kSize);
  for (const PrimitiveRecord& primitive : primitives) {
    for (int ty = 0; ty < kSize; ty += kTileHeight) {
      for (int tx = 0; tx < kSize; tx += kTileWidth) {
        Coverage coverage;
        const bool covers = cover_tile(primitive, tx, ty, coverage);
        if (!primitive.is_circle) {
          expect_same_squares(primitive, tx, ty, covers ? coverage : Coverage());
        }
        if (!covers) continue;
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

// One bit per sample and pixel.
std::vector<int> hit_samples(const PrimitiveRecord& primitive) {
  std::vector<int> hits(kSize * kSize);
  for (int ty = 0; ty < kSize; ty += kTileHeight) {
    for (int tx = 0; tx < kSize; tx += kTileWidth) {
      Coverage coverage[kSampleCount];
      const bool any = cover_samples(primitive, tx, ty, coverage);
      EXPECT_FALSE(any && misses_tile(primitive, tx, ty));
      for (int s = 0; any && s < kSampleCount; ++s) {
        for (int row = coverage[s].first_row; row < coverage[s].last_row; ++row) {
          for (int x = 0; x < kTileWidth; ++x) {
            hits[(ty + row) * kSize + tx + x] |= static_cast<int>(coverage[s].rows[row] >> x & 1)
                                                 << s;
          }
        }
      }
    }
  }
  return hits;
}

// The rule by exact arithmetic: positive, or zero on an edge that is left or bottom.
bool inside(const SnappedPoint* corners, int count, int px, int py,
            const SamplePlace& place = kCentrePlace) {
  int64_t area = 0;
  for (int i = 0; i < count; ++i) {
    const SnappedPoint &p = corners[i], &q = corners[(i + 1) % count];
    area += int64_t{p.x} * q.y - int64_t{q.x} * p.y;
  }
  for (int i = 0; i < count; ++i) {
    SnappedPoint p = corners[i], q = corners[(i + 1) % count];
    if (area < 0) std::swap(p, q);
    const int64_t dx = q.x - p.x, dy = q.y - p.y;
    const int64_t value =
        dx * (int64_t{py} * 256 + place.y - p.y) - dy * (int64_t{px} * 256 + place.x - p.x);
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

TEST(Coverage, SamplesEqualExactArithmeticForRandomPolygons) {
  std::mt19937 random(4);
  SetupState state = test_state();
  state.coverage = FragmentCoverage::kMultisample;
  for (int round = 0; round < 300; ++round) {
    const int range = round % 3 == 0 ? 2000 : (round % 3 == 1 ? kSize * 256 : 6000000);
    std::uniform_int_distribution<int> coordinate(-range / 4, range);
    SnappedPoint corners[3];
    // Multiples of 32 put many samples exactly on edges.
    for (SnappedPoint& corner : corners) {
      corner = {coordinate(random), coordinate(random)};
      if (round % 2 == 0) corner = {corner.x & ~31, corner.y & ~31};
    }
    PrimitiveRecord primitive;
    std::vector<int> hits(kSize * kSize);
    if (set_polygon(state, corners, 3, primitive)) hits = hit_samples(primitive);
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        int expected = 0;
        for (int s = 0; s < kSampleCount; ++s) {
          expected |= static_cast<int>(inside(corners, 3, x, y, kSamplePlaces[s])) << s;
        }
        ASSERT_EQ(hits[y * kSize + x], expected) << "round " << round << " pixel " << x << "," << y;
      }
    }
  }
}

// A point as setup makes it: its record has y counted upwards when mirror_height is 0.
PrimitiveRecord round_point(const SetupState& state, float x, float y, float size, float* vertex) {
  vertex[vertex_record::kWindow] = x;
  vertex[vertex_record::kWindow + 1] = y;
  vertex[vertex_record::kPointSize] = size;
  PrimitiveRecord primitive;
  EXPECT_TRUE(setup_point(state, vertex, primitive));
  return primitive;
}

TEST(Coverage, SamplesOfRoundPointsLieInTheCircle) {
  std::mt19937 random(6);
  SetupState state = test_state();
  state.coverage = FragmentCoverage::kMultisamplePoint;
  for (int round = 0; round < 200; ++round) {
    // Exact in 1/256 pixel, so that snapping changes nothing.
    const float x = static_cast<float>(random() % (kSize * 256)) / 256;
    const float y = static_cast<float>(random() % (kSize * 256)) / 256;
    const int size = 1 + static_cast<int>(random() % (round % 2 == 0 ? 255 : 5));
    float vertex[vertex_record::kTexture] = {};
    const std::vector<int> hits =
        hit_samples(round_point(state, x, y, static_cast<float>(size), vertex));
    for (int j = 0; j < kSize; ++j) {
      for (int i = 0; i < kSize; ++i) {
        for (int s = 0; s < kSampleCount; ++s) {
          const double dx = i + 0.5 + kSamplePlaces[s].x / 256.0 - x;
          const double dy = j + 0.5 + kSamplePlaces[s].y / 256.0 - y;
          ASSERT_EQ(hits[j * kSize + i] >> s & 1, 4 * (dx * dx + dy * dy) <= size * size ? 1 : 0)
              << x << "," << y << " size " << size << " sample " << s;
        }
      }
    }
  }
}

// Every pixel whose square the region touches is there: what is too much costs time only.
TEST(Coverage, AntialiasedShapesReachEverySquareTheyTouch) {
  std::mt19937 random(7);
  SetupState state = test_state();
  state.coverage = FragmentCoverage::kSmooth;
  for (int round = 0; round < 200; ++round) {
    const auto number = [&](double low, double high) {
      return static_cast<float>(low + (high - low) * (random() % 65536) / 65536.0);
    };
    const float x0 = number(0, kSize), y0 = number(0, kSize);
    const float x1 = number(0, kSize), y1 = number(0, kSize);
    const float width = number(1, round % 2 == 0 ? 4 : 100);
    float v0[vertex_record::kTexture] = {}, v1[vertex_record::kTexture] = {};
    PrimitiveRecord primitive = round_point(state, x0, y0, width, v0);
    if (round % 4 > 1) {
      v1[vertex_record::kWindow] = x1;
      v1[vertex_record::kWindow + 1] = y1;
      state.raster.line_width = width;
      primitive = {};
      ASSERT_TRUE(setup_line(state, v0, v1, primitive));
    }
    const std::vector<int> hits = count_hits({primitive});
    const double length = std::hypot(x1 - x0, y1 - y0);
    for (int j = 0; j < kSize; ++j) {
      for (int i = 0; i < kSize; ++i) {
        bool touched = false;
        for (int k = 0; k < 25 && !touched; ++k) {
          const double dx = i + k % 5 / 4.0 - x0, dy = j + k / 5 / 4.0 - y0;
          const double along = (dx * (x1 - x0) + dy * (y1 - y0)) / length;
          const double across = (dy * (x1 - x0) - dx * (y1 - y0)) / length;
          touched = round % 4 > 1 ? along >= 0 && along <= length && std::fabs(across) <= width / 2
                                  : std::hypot(dx, dy) <= width / 2;
        }
        ASSERT_TRUE(!touched || hits[j * kSize + i] == 1) << round << ": " << i << "," << j;
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

// Bins walk from tile to tile; each tile by itself says the same.
TEST(Coverage, BinsNameTheTilesThatAreNotMissed) {
  std::mt19937 random(8);
  const SetupState state = test_state();
  const TileGrid grid = make_tile_grid(kSize, kSize);
  for (int round = 0; round < 2000; ++round) {
    const int range = round % 2 == 0 ? kSize * 256 : 6000000;
    std::uniform_int_distribution<int> coordinate(-range / 4, range);
    SnappedPoint corners[3];
    for (SnappedPoint& corner : corners) corner = {coordinate(random), coordinate(random)};
    if (round % 3 == 0) corners[2] = {corners[1].x + 200, corners[1].y - 100};
    PrimitiveRecord p;
    if (!set_polygon(state, corners, 3, p)) continue;
    BinScratch scratch;
    Arena arena;
    Bins bins;
    bins.reset(grid, scratch);
    bins.add(p, 0);
    bins.close(arena);
    std::vector<int> named(static_cast<size_t>(grid.count()));
    for (const Bins::List& list : bins.lists()) named[list.tile] = static_cast<int>(list.count);
    for (int row = p.y0 / kTileHeight; row <= (p.y1 - 1) / kTileHeight; ++row) {
      for (int column = p.x0 / kTileWidth; column <= (p.x1 - 1) / kTileWidth; ++column) {
        int& tile = named[static_cast<size_t>(row * grid.columns + column)];
        const bool missed = misses_tile(p, column * kTileWidth, row * kTileHeight);
        const bool tested = p.x0 / kTileWidth != (p.x1 - 1) / kTileWidth &&
                            p.y0 / kTileHeight != (p.y1 - 1) / kTileHeight;
        ASSERT_EQ(tile, tested && missed ? 0 : 1) << round << ": " << column << "," << row;
        tile = 0;
      }
    }
    for (const int count : named) ASSERT_EQ(count, 0) << round;
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
