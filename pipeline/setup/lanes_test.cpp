// Setup of many primitives at once against setup of each by itself: what becomes a small primitive,
// with which pixels; and where those lie in tiles. Runs on the SIMD target that CLEARPIPE_SIMD
// selects.
// SPDX-License-Identifier: MIT
#include "pipeline/setup/lanes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "pipeline/raster/coverage.h"

namespace clearpipe::pipeline {
namespace {

constexpr int kSide = 200;
constexpr size_t kTriangles = 3000;

using Set = LaneSet<kTriangles>;

struct Mesh {
  std::vector<float> records;
  Set set;

  void add_vertex(float x, float y, uint32_t outcode, float point_size) {
    const size_t at = records.size();
    records.resize(at + vertex_record::kTexture);
    records[at + vertex_record::kWindow] = x;
    records[at + vertex_record::kWindow + 1] = y;
    std::memcpy(&records[at + vertex_record::kOutcode], &outcode, sizeof(outcode));
    records[at + vertex_record::kPointSize] = point_size;
  }

  const float* vertex(int corner, size_t triangle) const {
    return &records[static_cast<size_t>(set.corner[corner][triangle]) * vertex_record::kTexture];
  }
};

// Triangles, or lines and points that leave out further corners, of all sizes around a random
// place; some are degenerate, have corners on the centres or borders of pixels, or coordinates that
// mean nothing, which outcodes then say.
Mesh random_mesh(uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-4, kSide + 4), unit(-1, 1);
  constexpr float kSizes[] = {0.3f, 1, 2.5f, 4, 6, 9, 40};
  constexpr float kNonsense[] = {std::numeric_limits<float>::quiet_NaN(),
                                 std::numeric_limits<float>::infinity(), -1e30f, 3e9f};
  Mesh mesh;
  for (size_t t = 0; t < kTriangles; ++t) {
    const float size = kSizes[random() % std::size(kSizes)];
    const float x = place(random), y = place(random);
    for (int k = 0; k < 3; ++k) {
      const float last[2] = {k > 0 ? mesh.vertex(k - 1, t)[vertex_record::kWindow] : 0,
                             k > 0 ? mesh.vertex(k - 1, t)[vertex_record::kWindow + 1] : 0};
      float vx = x + size * unit(random), vy = y + size * unit(random);
      uint32_t outcode = 0;
      switch (random() % 24) {
        case 0:
          vx = std::floor(vx) + 0.5f;
          break;
        case 1:
          vx = std::floor(vx) + 0.5f;
          vy = std::floor(vy) + 0.5f;
          break;
        case 2:
          outcode = 1u << random() % 7;
          break;
        case 3:
          vx = kNonsense[random() % std::size(kNonsense)];
          outcode = kOutcodeGuard;
          break;
        case 4:  // to be set up, but far away
          vx += 17000;
          break;
        case 5:  // along an axis, when it is a line
        case 6:
          if (k > 0) {
            const int axis = static_cast<int>(random() % 2);
            (axis == 0 ? vx : vy) = last[axis];
          }
          break;
        case 7:
          vx = std::floor(vx);
          break;
        default:
          break;
      }
      mesh.set.corner[k][t] = static_cast<int32_t>(3 * t + k);
      // Of many sizes are some that are a whole number, or end in the middle of a pixel.
      const float point_size = random() % 3 == 0 ? 0.5f * static_cast<float>(random() % 40)
                                                 : 10 * std::abs(unit(random));
      mesh.add_vertex(vx, vy, outcode, point_size);
    }
    if (random() % 16 == 0) mesh.set.corner[2][t] = mesh.set.corner[random() % 2][t];
  }
  for (auto& corner : mesh.set.corner) std::fill_n(corner.begin() + kTriangles, kSetupLanes, 0);
  return mesh;
}

uint32_t outcode_of(const float* record) {
  uint32_t outcode;
  std::memcpy(&outcode, record + vertex_record::kOutcode, sizeof(outcode));
  return outcode;
}

// Whether the edges of a primitive after setup have a pixel inside.
bool covers(const PrimitiveRecord& record, int x, int y) {
  if (x < record.x0 || x >= record.x1 || y < record.y0 || y >= record.y1) return false;
  for (int e = 0; e < record.edge_count; ++e) {
    const Edge& edge = record.edges[e];
    if (edge.at(0, 0) + int64_t{edge.a} * x + int64_t{edge.b} * y < 0) return false;
  }
  return true;
}

// The fate that setup of one primitive alone gives, kGeneral when its outcodes leave it to others.
LaneFate expected_fate(const SetupState& state, int corners, const Mesh& mesh, size_t t,
                       PrimitiveRecord& record) {
  const float* v[3];
  uint32_t any = 0, all = ~0u;
  for (int k = 0; k < corners; ++k) {
    v[k] = mesh.vertex(k, t);
    any |= outcode_of(v[k]);
    all &= outcode_of(v[k]);
  }
  if ((all & ~uint32_t{kOutcodeGuard}) != 0) return LaneFate::kNothing;
  if (any != 0) return corners == 1 ? LaneFate::kNothing : LaneFate::kGeneral;
  bool visible = false, other = false;
  switch (corners) {
    case 1:
      visible = setup_point(state, v[0], record);
      break;
    case 2:
      visible = setup_line(state, v[0], v[1], record);
      other = record.size < 0;
      break;
    default:
      visible = setup_triangle(state, v[0], v[1], v[2], record);
      other = record.back_facing;
  }
  if (!visible) return LaneFate::kNothing;
  return other ? LaneFate::kSmallOther : LaneFate::kSmall;
}

// What is left of a line, with its corners: as setup of it alone.
void expect_same_line(const SetupState& state, const Mesh& mesh, size_t t, bool x_major) {
  const float *v0 = mesh.vertex(0, t), *v1 = mesh.vertex(1, t);
  SnappedPoint corners[4];
  for (int k = 0; k < 4; ++k) corners[k] = {mesh.set.snapped_x[k][t], mesh.set.snapped_y[k][t]};
  PrimitiveRecord alone, snapped;
  const bool visible = setup_line(state, v0, v1, alone);
  ASSERT_EQ(setup_snapped_line(state, v0, v1, x_major, corners, snapped), visible) << t;
  if (!visible) return;
  ASSERT_EQ(snapped.size, alone.size) << t;
  ASSERT_TRUE(snapped.x0 == alone.x0 && snapped.y0 == alone.y0 && snapped.x1 == alone.x1 &&
              snapped.y1 == alone.y1)
      << t;
  for (int e = 0; e < 4; ++e) {
    const Edge &a = snapped.edges[e], &b = alone.edges[e];
    ASSERT_TRUE(a.a == b.a && a.b == b.b && a.c == b.c) << t << " edge " << e;
  }
}

void expect_same(const SetupState& state, int corners, uint32_t seed) {
  Mesh mesh = random_mesh(seed);
  const LaneJob job = lane_job(mesh.records.data(), mesh.set, 0, kTriangles);
  setup_lanes(static_cast<PrimitiveKind>(corners - 1), state, job);
  size_t small_count = 0, general_count = 0;
  for (size_t t = 0; t < kTriangles; ++t) {
    PrimitiveRecord record;
    const LaneFate expected = expected_fate(state, corners, mesh, t, record);
    const auto found = static_cast<LaneFate>(mesh.set.fate[t]);
    if (found == LaneFate::kGeneral) {  // what is left to setup of one comes out right
      ++general_count;
      continue;
    }
    if (found == LaneFate::kSnapped || found == LaneFate::kSnappedOther) {
      expect_same_line(state, mesh, t, found == LaneFate::kSnapped);
      ++general_count;
      continue;
    }
    const bool small = found != LaneFate::kNothing;
    if (small || expected == LaneFate::kNothing || expected == LaneFate::kGeneral) {
      ASSERT_EQ(found, expected) << t;
    }
    if (expected == LaneFate::kNothing) continue;
    small_count += small;
    // What is said to be nothing covers nothing; else each pixel is in the mask of its square.
    constexpr int kWide = kLaneSquares * kSmallSide;
    for (int y = small ? mesh.set.y[t] - 1 : record.y0; y <= record.y1; ++y) {
      for (int x = small ? mesh.set.x[t] - 1 : record.x0; x <= record.x1; ++x) {
        bool in_mask = false;
        const int i = x - mesh.set.x[t], j = y - mesh.set.y[t];
        if (small && i >= 0 && i < kWide && j >= 0 && j < kWide) {
          const uint64_t mask = mesh.set.mask(t, j / kSmallSide * kLaneSquares + i / kSmallSide);
          in_mask = (mask >> (kSmallSide * (j % kSmallSide) + i % kSmallSide) & 1) != 0;
        }
        ASSERT_EQ(in_mask, covers(record, x, y)) << t << " pixel " << x << " " << y;
      }
    }
    for (int square = 0; small && square < kSquaresOfLane; ++square) {
      const int x = mesh.set.x[t] + square % kLaneSquares * kSmallSide;
      const int y = mesh.set.y[t] + square / kLaneSquares * kSmallSide;
      for (int bit = 0; bit < 64; ++bit) {
        if ((mesh.set.mask(t, square) >> bit & 1) == 0) continue;
        ASSERT_TRUE(covers(record, x + bit % kSmallSide, y + bit / kSmallSide)) << t;
      }
    }
  }
  EXPECT_GT(small_count, kTriangles / 12);
  EXPECT_LT(general_count, 2 * kTriangles / 3);
}

SetupState state_with(CullFace cull, bool clockwise, int mirror_height) {
  SetupState state;
  state.bounds = {3, 5, kSide - 2, kSide - 7};
  state.raster.cull = cull;
  state.raster.front_is_clockwise = clockwise;
  state.mirror_height = mirror_height;
  return state;
}

TEST(Triangles, EachIsAsSetUpAlone) {
  uint32_t seed = 1;
  for (const CullFace cull : {CullFace::kNone, CullFace::kFront, CullFace::kBack}) {
    for (const bool clockwise : {false, true}) {
      for (const int mirror_height : {0, kSide}) {
        SCOPED_TRACE(seed);
        expect_same(state_with(cull, clockwise, mirror_height), 3, seed++);
      }
    }
  }
}

TEST(Lines, EachIsAsSetUpAlone) {
  uint32_t seed = 50;
  for (const float width : {1.0f, 1.6f, 3.0f, 4.0f}) {
    for (const int mirror_height : {0, kSide}) {
      SCOPED_TRACE(seed);
      SetupState state = state_with(CullFace::kNone, false, mirror_height);
      state.raster.line_width = width;
      expect_same(state, 2, seed++);
    }
  }
}

TEST(Points, EachIsAsSetUpAlone) {
  uint32_t seed = 80;
  for (const bool sprite : {false, true}) {
    for (const int mirror_height : {0, kSide}) {
      SCOPED_TRACE(seed);
      SetupState state = state_with(CullFace::kNone, false, mirror_height);
      state.raster.point_sprite = sprite;
      expect_same(state, 1, seed++);
    }
  }
}

TEST(Triangles, NothingIsLeftOfBothFacesCulled) {
  Mesh mesh = random_mesh(99);
  setup_lanes(PrimitiveKind::kTriangle, state_with(CullFace::kFrontAndBack, false, 0),
              lane_job(mesh.records.data(), mesh.set, 0, kTriangles));
  for (size_t t = 0; t < kTriangles; ++t) {
    const auto fate = static_cast<LaneFate>(mesh.set.fate[t]);
    ASSERT_TRUE(fate == LaneFate::kNothing || fate == LaneFate::kGeneral) << t;
  }
}

// The pixels of a mask, in the tiles that share them, against the mask itself.
TEST(SmallCoverage, TilesShareThePixels) {
  std::mt19937 random(5);
  for (int i = 0; i < 20000; ++i) {
    const uint64_t mask =
        (uint64_t{random()} << 32 | random()) & (uint64_t{random()} << 32 | random());
    const int x = static_cast<int>(random() % 140), y = static_cast<int>(random() % 80);
    uint64_t found = 0;
    for (int ty = 0; ty < 96; ty += kTileHeight) {
      for (int tx = 0; tx < 192; tx += kTileWidth) {
        const bool touches =
            x < tx + kTileWidth && x + 7 >= tx && y < ty + kTileHeight && y + 7 >= ty;
        if (!touches) continue;
        const SmallCoverage part = small_coverage(mask, x, y, tx, ty);
        for (int bit = 0; bit < 64; ++bit) {
          if ((part.mask >> bit & 1) == 0) continue;
          const int column = part.column + bit % 8, row = part.row + bit / 8;
          ASSERT_TRUE(column >= 0 && column < kTileWidth && row >= 0 && row < kTileHeight);
          const uint64_t pixel = uint64_t{1} << (8 * (ty + row - y) + (tx + column - x));
          ASSERT_EQ(found & pixel, 0u);
          found |= pixel;
        }
      }
    }
    ASSERT_EQ(found, mask) << x << " " << y;
  }
}

// The mask that make_small finds, against the coverage of tiles.
TEST(SmallPrimitive, MaskIsTheCoverage) {
  std::mt19937 random(17);
  std::uniform_int_distribution<int32_t> place(0, 100 * kSubpixelOne), part(-1100, 1100);
  SetupState state;
  state.bounds = {0, 0, kSide, kSide};
  int small_count = 0;
  for (int i = 0; i < 5000; ++i) {
    const SnappedPoint centre = {place(random), place(random)};
    const int32_t dx = part(random), dy = part(random), nx = -dy / 3, ny = dx / 3;
    const SnappedPoint corners[4] = {{centre.x - dx - nx, centre.y - dy - ny},
                                     {centre.x + dx - nx, centre.y + dy - ny},
                                     {centre.x + dx + nx, centre.y + dy + ny},
                                     {centre.x - dx + nx, centre.y - dy + ny}};
    PrimitiveRecord record;
    if (!set_polygon(state, corners, 4, record) || !is_small(record)) continue;
    ++small_count;
    SmallPrimitive small;
    if (!make_small(record, small)) small.mask = 0;
    uint64_t found = 0;
    for (int ty = 0; ty < kSide; ty += kTileHeight) {
      for (int tx = 0; tx < kSide; tx += kTileWidth) {
        Coverage coverage;
        if (!cover_tile(record, tx, ty, coverage)) continue;
        for (int row = coverage.first_row; row < coverage.last_row; ++row) {
          for (int column = 0; column < kTileWidth; ++column) {
            if ((coverage.rows[row] >> column & 1) == 0) continue;
            found |= uint64_t{1} << (8 * (ty + row - record.y0) + (tx + column - record.x0));
          }
        }
      }
    }
    ASSERT_EQ(small.mask, found);
  }
  EXPECT_GT(small_count, 1000);
}

}  // namespace
}  // namespace clearpipe::pipeline
