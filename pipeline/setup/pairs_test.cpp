// Which small triangles become one, and with which pixels. Runs on the SIMD target that
// CLEARPIPE_SIMD selects.
// SPDX-License-Identifier: MIT
#include "pipeline/setup/pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <random>
#include <vector>

namespace clearpipe::pipeline {
namespace {

constexpr size_t kMost = 512;

// Triangles from vertices of one depth and colour, if nothing else is said.
struct Triangles {
  SetupState state;
  std::vector<float> records;
  LaneSet<kMost> set;
  size_t count = 0;

  Triangles() {
    state.bounds = {0, 0, 400, 400};
    state.inputs.depth = state.inputs.colour = true;
    state.layout.back_colour_offset = vertex_record::kTexture;
    state.layout.stride = vertex_record::kTexture + 4;
  }

  int32_t vertex(float x, float y) {
    const size_t at = records.size();
    records.resize(at + state.layout.stride);
    float* const record = &records[at];
    record[vertex_record::kWindow] = x;
    record[vertex_record::kWindow + 1] = y;
    record[vertex_record::kWindow + 2] = 0.25f;
    record[vertex_record::kWindow + 3] = 1;
    std::fill_n(record + vertex_record::kColour, 4, 0.5f);
    return static_cast<int32_t>(at / state.layout.stride);
  }
  float& value(int32_t vertex, int offset) {
    return records[static_cast<size_t>(vertex) * state.layout.stride + static_cast<size_t>(offset)];
  }

  void triangle(int32_t a, int32_t b, int32_t c) {
    set.corner[0][count] = a;
    set.corner[1][count] = b;
    set.corner[2][count++] = c;
  }
  // The halves of a rectangle; returns its first vertex of four.
  int32_t rectangle(float x, float y, float width, float height) {
    const int32_t first = vertex(x, y);
    vertex(x + width, y);
    vertex(x, y + height);
    vertex(x + width, y + height);
    triangle(first, first + 1, first + 2);
    triangle(first + 2, first + 1, first + 3);
    return first;
  }

  void set_up() { setup_lanes(PrimitiveKind::kTriangle, state, job()); }
  void merge() { merge_pairs(state, job()); }
  LaneJob job() { return lane_job(records.data(), set, 0, count); }

  LaneFate fate(size_t i) const { return static_cast<LaneFate>(set.fate[i]); }
  int pixels(size_t i) const {
    if (fate(i) != LaneFate::kSmall && fate(i) != LaneFate::kSmallOther) return 0;
    int sum = 0;
    for (int s = 0; s < kSquaresOfLane; ++s) sum += std::popcount(set.mask(i, s));
    return sum;
  }
  // Whether squares other than the first have pixels, as setup says it.
  bool has_more(size_t i) const { return (set.mask(i, 1) | set.mask(i, 2) | set.mask(i, 3)) != 0; }
};

// After both steps, whether one triangle is left.
bool become_one(Triangles& triangles) {
  triangles.set_up();
  triangles.merge();
  return triangles.fate(0) != LaneFate::kNothing && triangles.fate(1) == LaneFate::kNothing;
}

TEST(Pairs, HalvesOfARectangleBecomeIt) {
  for (const float side : {3.0f, 7.0f, 12.0f}) {
    Triangles triangles;
    triangles.rectangle(20, 30, side, 5);
    ASSERT_TRUE(become_one(triangles)) << side;
    EXPECT_EQ(triangles.pixels(0), static_cast<int>(side) * 5);
    EXPECT_EQ(triangles.set.more[0] != 0, triangles.has_more(0));
  }
}

// The second reaches further than the first.
TEST(Pairs, NeedNotBeRectangles) {
  Triangles triangles;
  const int32_t first = triangles.rectangle(20, 30, 3, 5);
  triangles.count = 1;
  triangles.triangle(first + 2, first + 1, triangles.vertex(34, 35));
  triangles.set_up();
  const int pixels = triangles.pixels(0) + triangles.pixels(1);
  ASSERT_EQ(triangles.set.more[0], 0);
  triangles.merge();
  ASSERT_EQ(triangles.fate(1), LaneFate::kNothing);
  EXPECT_EQ(triangles.pixels(0), pixels);
  EXPECT_NE(triangles.set.more[0], 0);
}

TEST(Pairs, EndWithTheJob) {
  Triangles triangles;
  triangles.rectangle(20, 30, 6, 6);
  triangles.set_up();
  triangles.count = 1;
  triangles.merge();
  EXPECT_EQ(triangles.fate(1), LaneFate::kSmall);
}

TEST(Pairs, FacingAwayAsWell) {
  Triangles triangles;
  triangles.state.raster.front_is_clockwise = true;
  triangles.rectangle(20, 30, 6, 6);
  ASSERT_TRUE(become_one(triangles));
  EXPECT_EQ(triangles.fate(0), LaneFate::kSmallOther);
}

// Any value that differs at any vertex, where the state uses it.
TEST(Pairs, NotWhereSomethingIsInterpolated) {
  for (const int offset :
       {vertex_record::kWindow + 2, vertex_record::kWindow + 3, vertex_record::kColour,
        vertex_record::kColour + 3, vertex_record::kFog, vertex_record::kTexture + 1}) {
    for (int32_t corner = 0; corner < 4; ++corner) {
      Triangles triangles;
      triangles.state.inputs.fog = triangles.state.two_sided = true;
      triangles.value(triangles.rectangle(20, 30, 6, 6) + corner, offset) = 0.75f;
      EXPECT_FALSE(become_one(triangles)) << offset << " " << corner;
    }
  }
}

TEST(Pairs, WhatTheStateDoesNotUseMayDiffer) {
  Triangles triangles;
  const int32_t first = triangles.rectangle(20, 30, 6, 6);
  triangles.value(first, vertex_record::kFog) = 0.75f;
  triangles.value(first, vertex_record::kTexture) = 0.75f;  // the back colour
  EXPECT_TRUE(become_one(triangles));
}

TEST(Pairs, NotOneTriangleTwice) {
  Triangles triangles;
  const int32_t first = triangles.rectangle(20, 30, 6, 6);
  triangles.count = 1;
  triangles.triangle(first, first + 1, first + 2);
  EXPECT_FALSE(become_one(triangles));
  EXPECT_EQ(triangles.pixels(1), triangles.pixels(0));
}

TEST(Pairs, NotOfTwoFacings) {
  Triangles triangles;
  const int32_t first = triangles.rectangle(20, 30, 6, 6);
  triangles.count = 1;
  triangles.triangle(first + 1, first + 2, first + 3);
  EXPECT_FALSE(become_one(triangles));
}

TEST(Pairs, NotInDifferentBoxes) {
  for (const float x : {29.0f, 40.0f}) {
    Triangles triangles;
    triangles.rectangle(20, 30, 6, 6);
    triangles.count = 1;
    const int32_t other = triangles.rectangle(x, 30, 6, 6);
    triangles.count = 1;
    triangles.triangle(other + 2, other + 1, other + 3);
    EXPECT_FALSE(become_one(triangles));
    EXPECT_GT(triangles.pixels(1), 0);
  }
}

// One that is left to others has no place in the lanes.
TEST(Pairs, NotWithOneThatIsNotSettled) {
  Triangles triangles;
  triangles.rectangle(20, 30, 6, 6);
  triangles.set_up();
  triangles.set.fate[1] = static_cast<int32_t>(LaneFate::kGeneral);
  triangles.merge();
  EXPECT_EQ(triangles.fate(1), LaneFate::kGeneral);
  triangles.set.fate[0] = static_cast<int32_t>(LaneFate::kGeneral);
  triangles.merge();
  EXPECT_EQ(triangles.fate(1), LaneFate::kGeneral);
}

// Rectangles, some of which make no pair, and triangles between them: no pixel comes or goes.
TEST(Pairs, KeepAllPixels) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> place(1, 380), size(1, 14);
  for (int seed = 0; seed < 200; ++seed) {
    Triangles triangles;
    const size_t most = 1 + random() % 60;
    while (triangles.count < most) {
      const int32_t first =
          triangles.rectangle(place(random), place(random), size(random), size(random));
      if (random() % 4 == 0) triangles.value(first + 3, vertex_record::kColour) = 1;
      if (random() % 4 == 0) --triangles.count;
    }
    triangles.count = most;
    triangles.set_up();
    const auto all_pixels = [&triangles] {
      int sum = 0;
      for (size_t i = 0; i < triangles.count; ++i) sum += triangles.pixels(i);
      return sum;
    };
    const int before = all_pixels();
    triangles.merge();
    EXPECT_EQ(all_pixels(), before) << seed;
  }
}

// A mesh is not searched to its end.
TEST(Pairs, AreLookedForUntilThereAreNone) {
  Triangles triangles;
  for (int i = 0; i < 20; ++i) {
    const int32_t first = triangles.rectangle(20, 30, 6, 6);
    triangles.value(first, vertex_record::kColour) = 1;
  }
  triangles.rectangle(60, 30, 6, 6);
  triangles.set_up();
  triangles.merge();
  EXPECT_GT(triangles.pixels(41), 0);
}

}  // namespace
}  // namespace clearpipe::pipeline
