// The coverage of antialiased points and lines against areas in double precision, read back as the
// alpha of white fragments. ctest runs it on each SIMD target.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "pipeline/fragment/own_tile.h"
#include "pipeline/fragment/program.h"

namespace clearpipe::pipeline {
namespace {

struct Place {
  double x, y;
};

// A tile of white fragments with alpha 1, each with the coverage of the region as its alpha.
OwnTile shade_region(const SmoothRegion& region, float x, float y, int tile_x = 0) {
  OwnTile tile;
  tile.x = tile_x;
  PrimitivePlanes planes;
  planes.x_ref = x;
  planes.y_ref = y;
  planes.region = region;
  planes.flat_colour = true;
  for (Plane& plane : planes.colour) plane = {kColourOne, 0, 0};
  Coverage coverage;
  std::fill(std::begin(coverage.rows), std::end(coverage.rows), ~uint64_t{0});
  coverage.first_row = 0;
  coverage.last_row = kTileHeight;
  const std::unique_ptr<FragmentProgram, void (*)(FragmentProgram*)> program(
      make_fragment_program({}, {}, FragmentCoverage::kSmooth), destroy_fragment_program);
  shade(*program, planes, coverage, tile);
  return tile;
}

double alpha(const Tile& tile, int x, int y) { return tile.colour[y * kTileWidth + x] >> 24; }

// Cuts a convex polygon at a * x + b * y + c >= 0.
std::vector<Place> cut(const std::vector<Place>& polygon, double a, double b, double c) {
  std::vector<Place> kept;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Place& p = polygon[i];
    const Place& q = polygon[(i + 1) % polygon.size()];
    const double dp = a * p.x + b * p.y + c, dq = a * q.x + b * q.y + c;
    if (dp >= 0) kept.push_back(p);
    if ((dp >= 0) != (dq >= 0)) {
      const double t = dp / (dp - dq);
      kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  return kept;
}

double area_in_square(std::vector<Place> polygon, int x, int y) {
  polygon = cut(polygon, 1, 0, -x);
  polygon = cut(polygon, -1, 0, x + 1);
  polygon = cut(polygon, 0, 1, -y);
  polygon = cut(polygon, 0, -1, y + 1);
  double doubled = 0;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Place& p = polygon[i];
    const Place& q = polygon[(i + 1) % polygon.size()];
    doubled += p.x * q.y - q.x * p.y;
  }
  return std::fabs(doubled) / 2;
}

TEST(Antialias, LinesCoverTheirRectangle) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-30, 90), width_of(1, 12);
  for (int round = 0; round < 500; ++round) {
    const float x = static_cast<float>(place(random)), y = static_cast<float>(place(random));
    float dx = static_cast<float>(place(random)) - x, dy = static_cast<float>(place(random)) - y;
    if (round % 5 == 1) dx = 0;
    if (round % 5 == 2) dy = 0;
    if (round % 5 == 3) dy = dx * 1e-4f;
    if (round % 5 == 4) dx = dy * 1e-5f;
    const float width = round % 2 == 0 ? 1.0f : static_cast<float>(width_of(random));
    const OwnTile tile = shade_region({false, 0.5f * width, dx, dy}, x, y);
    const double length = std::hypot(dx, dy);
    const double nx = -dy / length * width / 2, ny = dx / length * width / 2;
    const std::vector<Place> rectangle = {
        {x - nx, y - ny}, {x + dx - nx, y + dy - ny}, {x + dx + nx, y + dy + ny}, {x + nx, y + ny}};
    for (int j = 0; j < kTileHeight; ++j) {
      for (int i = 0; i < kTileWidth; ++i) {
        ASSERT_NEAR(alpha(tile, i, j), 255 * area_in_square(rectangle, i, j), 0.6)
            << round << ": " << i << "," << j << " line " << x << "," << y << " + " << dx << ","
            << dy << " width " << width;
      }
    }
  }
}

// The area by many chords along y.
double circle_in_square(double cx, double cy, double radius, int x, int y) {
  constexpr int kSteps = 2000;
  double sum = 0;
  for (int k = 0; k < kSteps; ++k) {
    const double at = x + (k + 0.5) / kSteps - cx;
    if (std::fabs(at) > radius) continue;
    const double h = std::sqrt(radius * radius - at * at);
    sum += std::max(0.0, std::min(cy + h, y + 1.0) - std::max(cy - h, double(y)));
  }
  return sum / kSteps;
}

TEST(Antialias, PointsCoverTheirCircle) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> place(-5, 40), width_of(1, 255);
  for (int round = 0; round < 120; ++round) {
    const float x = static_cast<float>(place(random)), y = static_cast<float>(place(random));
    const float width = round % 3 == 0   ? 1.0f
                        : round % 3 == 1 ? 1 + static_cast<float>(width_of(random)) / 40
                                         : static_cast<float>(width_of(random));
    const OwnTile tile = shade_region({true, 0.5f * width, 0, 0}, x, y);
    for (int j = 0; j < kTileHeight; ++j) {
      for (int i = 0; i < kTileWidth; ++i) {
        ASSERT_NEAR(alpha(tile, i, j), 255 * circle_in_square(x, y, width / 2, i, j),
                    255 / 200.0 + 0.5)
            << round << ": " << i << "," << j << " point " << x << "," << y << " size " << width;
      }
    }
  }
}

TEST(Antialias, WhatIsNotCoveredIsNotTested) {
  FragmentState state;
  state.depth_test = true;
  state.depth_func = CompareFunc::kAlways;
  state.colour_mask = 0;
  PrimitivePlanes planes;
  planes.x_ref = planes.y_ref = 10;
  planes.region = {true, 4, 0, 0};
  planes.depth = {1, 0, 0};
  OwnTile tile;
  Coverage coverage;
  std::fill(std::begin(coverage.rows), std::end(coverage.rows), ~uint64_t{0});
  coverage.first_row = 0;
  coverage.last_row = kTileHeight;
  const std::unique_ptr<FragmentProgram, void (*)(FragmentProgram*)> program(
      make_fragment_program(state, {true, true}, FragmentCoverage::kSmooth),
      destroy_fragment_program);
  shade(*program, planes, coverage, tile);
  for (int j = 0; j < kTileHeight; ++j) {
    for (int i = 0; i < kTileWidth; ++i) {
      const bool touched = circle_in_square(10, 10, 4, i, j) > 1e-3;
      ASSERT_EQ(tile.depth_stencil[j * kTileWidth + i], touched ? 0xffffff00u : 0u)
          << i << " " << j;
    }
  }
}

}  // namespace
}  // namespace clearpipe::pipeline
