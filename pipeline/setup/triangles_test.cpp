// Setup of many triangles at once against setup of each by itself: what becomes a small primitive,
// with which pixels; and where those lie in tiles. Runs on the SIMD target that CLEARPIPE_SIMD
// selects.
// SPDX-License-Identifier: MIT
#include "pipeline/setup/triangles.h"

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

using Set = TriangleSet<kTriangles>;

struct Mesh {
  std::vector<float> records;
  Set set;

  void add_vertex(float x, float y, uint32_t outcode) {
    const size_t at = records.size();
    records.resize(at + vertex_record::kTexture);
    records[at + vertex_record::kWindow] = x;
    records[at + vertex_record::kWindow + 1] = y;
    std::memcpy(&records[at + vertex_record::kOutcode], &outcode, sizeof(outcode));
  }

  const float* vertex(int corner, size_t triangle) const {
    return &records[static_cast<size_t>(set.corner[corner][triangle]) * vertex_record::kTexture];
  }
};

// Triangles of all sizes around a random place; some are degenerate, have corners on the centres
// of pixels, or coordinates that mean nothing, which outcodes then say.
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
        default:
          break;
      }
      mesh.set.corner[k][t] = static_cast<int32_t>(3 * t + k);
      mesh.add_vertex(vx, vy, outcode);
    }
    if (random() % 16 == 0) mesh.set.corner[2][t] = mesh.set.corner[random() % 2][t];
  }
  for (auto& corner : mesh.set.corner) std::fill_n(corner.begin() + kTriangles, kTriangleLanes, 0);
  return mesh;
}

uint32_t outcode_of(const float* record) {
  uint32_t outcode;
  std::memcpy(&outcode, record + vertex_record::kOutcode, sizeof(outcode));
  return outcode;
}

// The fate that setup of one triangle alone gives; kSmallFront and kSmallBack with their pixels.
TriangleFate expected_fate(const SetupState& state, const Mesh& mesh, size_t t,
                           SmallPrimitive& small) {
  const float* v[3];
  uint32_t any = 0, all = ~0u;
  for (int k = 0; k < 3; ++k) {
    v[k] = mesh.vertex(k, t);
    any |= outcode_of(v[k]);
    all &= outcode_of(v[k]);
  }
  if ((all & ~uint32_t{kOutcodeGuard}) != 0) return TriangleFate::kNothing;
  if (any != 0) return TriangleFate::kGeneral;
  PrimitiveRecord record;
  if (!setup_triangle(state, v[0], v[1], v[2], record)) return TriangleFate::kNothing;
  if (!is_small(record)) return TriangleFate::kGeneral;
  if (!make_small(record, small)) return TriangleFate::kNothing;
  return record.back_facing ? TriangleFate::kSmallBack : TriangleFate::kSmallFront;
}

TriangleJob job_of(Mesh& mesh) {
  TriangleJob job;
  job.records = mesh.records.data();
  for (int k = 0; k < 3; ++k) job.corner[k] = mesh.set.corner[k].data();
  job.count = kTriangles;
  job.fate = mesh.set.fate.data();
  job.x = mesh.set.x.data();
  job.y = mesh.set.y.data();
  job.mask_low = mesh.set.mask_low.data();
  job.mask_high = mesh.set.mask_high.data();
  return job;
}

void expect_same(const SetupState& state, uint32_t seed) {
  Mesh mesh = random_mesh(seed);
  setup_triangles(state, job_of(mesh));
  size_t small_count = 0, general_count = 0;
  for (size_t t = 0; t < kTriangles; ++t) {
    SmallPrimitive small;
    const TriangleFate expected = expected_fate(state, mesh, t, small);
    const auto found = static_cast<TriangleFate>(mesh.set.fate[t]);
    // What many at once leave to the one by itself comes out right in any case.
    if (found == TriangleFate::kGeneral) {
      general_count += expected != TriangleFate::kGeneral;
      continue;
    }
    ASSERT_EQ(found, expected) << t;
    if (found == TriangleFate::kNothing) continue;
    ++small_count;
    const uint64_t mask = uint64_t{mesh.set.mask_high[t]} << 32 | mesh.set.mask_low[t];
    // The box may begin elsewhere, the pixels are the same.
    const int dx = small.x - mesh.set.x[t], dy = small.y - mesh.set.y[t];
    ASSERT_EQ(mask, small.mask << (dx + kSmallSide * dy)) << t;
  }
  EXPECT_GT(small_count, kTriangles / 16);
  EXPECT_LT(general_count, kTriangles / 3);
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
        expect_same(state_with(cull, clockwise, mirror_height), seed++);
      }
    }
  }
}

TEST(Triangles, NothingIsLeftOfBothFacesCulled) {
  Mesh mesh = random_mesh(99);
  setup_triangles(state_with(CullFace::kFrontAndBack, false, 0), job_of(mesh));
  for (size_t t = 0; t < kTriangles; ++t) {
    const auto fate = static_cast<TriangleFate>(mesh.set.fate[t]);
    ASSERT_TRUE(fate == TriangleFate::kNothing || fate == TriangleFate::kGeneral) << t;
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
