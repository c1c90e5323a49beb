// Fixed point and matrices against double precision.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "api/fixed.h"
#include "api/matrix.h"

namespace clearpipe::api {
namespace {

TEST(Fixed, ConvertsAndSaturates) {
  EXPECT_EQ(from_fixed(0x10000), 1.0f);
  EXPECT_EQ(from_fixed(-0x8000), -0.5f);
  EXPECT_EQ(to_fixed(1.5f), 0x18000);
  EXPECT_EQ(to_fixed(1e9f), INT32_MAX);
  EXPECT_EQ(to_fixed(-1e9f), INT32_MIN);
  EXPECT_EQ(to_fixed(std::nanf("")), 0);
}

TEST(Matrix, SineAndCosineAreCloseToTheLastBit) {
  for (int i = -7200; i <= 7200; ++i) {
    const double angle = i * 0.1 * 3.14159265358979323846 / 180.0;
    double sine, cosine;
    sin_cos(angle, sine, cosine);
    EXPECT_NEAR(sine, std::sin(angle), 1e-15) << i;
    EXPECT_NEAR(cosine, std::cos(angle), 1e-15) << i;
  }
}

TEST(Matrix, RotationAgreesWithRodriguesInDouble) {
  const double axis[3] = {0.3, -0.7, 0.5};
  const double length = std::sqrt(0.3 * 0.3 + 0.7 * 0.7 + 0.5 * 0.5);
  const double angle = 77.0 * 3.14159265358979323846 / 180.0, c = std::cos(angle),
               s = std::sin(angle);
  Mat4 m;
  ASSERT_TRUE(rotate(m, 77, 0.3f, -0.7f, 0.5f));
  const double skew[3][3] = {
      {0, -axis[2], axis[1]}, {axis[2], 0, -axis[0]}, {-axis[1], axis[0], 0}};
  for (size_t row = 0; row < 3; ++row) {
    for (size_t col = 0; col < 3; ++col) {
      const double expected = (row == col ? c : 0) +
                              (1 - c) * axis[row] * axis[col] / (length * length) +
                              s * skew[row][col] / length;
      EXPECT_NEAR(m.m[4 * col + row], expected, 3e-7);
    }
  }
}

TEST(Matrix, RotationAboutOneAxisLeavesTheOtherEntriesExact) {
  for (const float sign : {1.0f, -1.0f}) {
    Mat4 m;
    rotate(m, 90, 0, 0, sign);
    EXPECT_EQ(m.m[1], sign);
    EXPECT_EQ(m.m[4], -sign);
    EXPECT_EQ(m.m[10], 1.0f);
    EXPECT_EQ(m.m[8], 0.0f);
  }
  Mat4 unchanged;
  EXPECT_FALSE(rotate(unchanged, 30, 0, 0, 0));
  EXPECT_TRUE(is_identity(unchanged));
}

TEST(Matrix, InverseTimesMatrixIsTheIdentity) {
  Mat4 m = frustum(-1, 2, -1.5f, 1, 1, 20);
  rotate(m, 33, 1, 2, 3);
  translate(m, 4, -5, 6);
  scale(m, 2, 3, 0.5f);
  const Mat4 product = multiply(invert(m), m);
  for (size_t i = 0; i < 16; ++i) EXPECT_NEAR(product.m[i], i % 5 == 0 ? 1 : 0, 2e-5);
  EXPECT_TRUE(is_identity(invert(Mat4{{0}})));
}

TEST(Matrix, OrthoMapsItsPlanesToTheUnitCube) {
  const Mat4 m = ortho(-2, 4, -1, 3, 1, 9);
  const Vec4 corner = transform(m, {4, 3, -9, 1});
  EXPECT_NEAR(corner.x, 1, 1e-6);
  EXPECT_NEAR(corner.y, 1, 1e-6);
  EXPECT_NEAR(corner.z, 1, 1e-6);
}

}  // namespace
}  // namespace clearpipe::api
