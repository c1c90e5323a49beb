// Matrix arithmetic: see matrix.h.
// SPDX-License-Identifier: MIT
#include "api/matrix.h"

#include <cmath>

namespace clearpipe::api {

Mat4 multiply(const Mat4& a, const Mat4& b) {
  Mat4 product;
  for (size_t row = 0; row < 4; ++row) {
    for (size_t col = 0; col < 4; ++col) {
      product.m[4 * col + row] = a.m[row] * b.m[4 * col] + a.m[4 + row] * b.m[4 * col + 1] +
                                 a.m[8 + row] * b.m[4 * col + 2] + a.m[12 + row] * b.m[4 * col + 3];
    }
  }
  return product;
}

void translate(Mat4& matrix, float x, float y, float z) {
  auto& m = matrix.m;
  for (size_t row = 0; row < 4; ++row) {
    m[12 + row] = m[row] * x + m[4 + row] * y + m[8 + row] * z + m[12 + row];
  }
}

void scale(Mat4& matrix, float x, float y, float z) {
  for (size_t row = 0; row < 4; ++row) {
    matrix.m[row] *= x;
    matrix.m[4 + row] *= y;
    matrix.m[8 + row] *= z;
  }
}

void sin_cos(double radians, double& sine, double& cosine) {
  if (!std::isfinite(radians)) {
    sine = cosine = radians - radians;
    return;
  }
  // pi/2 in three parts whose products with a quadrant number below 2^20 are exact.
  constexpr double kPart1 = 1.57079632673412561417e+00, kPart2 = 6.07710050630396597660e-11,
                   kPart3 = 2.02226624879595063154e-21;
  constexpr double kTwoPi = 6.28318530717958647692;
  if (std::fabs(radians) > 1.0e5) radians = std::fmod(radians, kTwoPi);
  const double quadrant = std::floor(radians * (4.0 / kTwoPi) + 0.5);
  const double x = ((radians - quadrant * kPart1) - quadrant * kPart2) - quadrant * kPart3;
  const double x2 = x * x;
  double s = 0, c = 0;  // the Taylor series up to x^19 and x^18
  for (int k = 9; k >= 1; --k) {
    s = (1.0 + s) * -x2 / ((2.0 * k) * (2.0 * k + 1.0));
    c = (1.0 + c) * -x2 / ((2.0 * k) * (2.0 * k - 1.0));
  }
  s = x + x * s;
  c = 1.0 + c;
  switch (static_cast<long long>(quadrant) & 3) {
    case 0:
      sine = s;
      cosine = c;
      break;
    case 1:
      sine = c;
      cosine = -s;
      break;
    case 2:
      sine = -s;
      cosine = -c;
      break;
    default:
      sine = -c;
      cosine = s;
      break;
  }
}

bool rotate(Mat4& matrix, float degrees, float x, float y, float z) {
  constexpr double kPi = 3.14159265358979323846;
  double sine, cosine;
  sin_cos(static_cast<double>(static_cast<float>(degrees * kPi / 180.0)), sine, cosine);
  const float s = static_cast<float>(sine), c = static_cast<float>(cosine);
  Mat4 r;
  auto at = [&r](size_t row, size_t col) -> float& { return r.m[4 * col + row]; };
  const int axes = (x != 0) + (y != 0) + (z != 0);
  if (axes == 1) {
    // About one axis: the turned plane is (i, j), the axis's sign gives the direction.
    const size_t axis = x != 0 ? 0 : y != 0 ? 1 : 2;
    const size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
    const float turned = x + y + z < 0 ? -s : s;
    at(i, i) = at(j, j) = c;
    at(i, j) = -turned;
    at(j, i) = turned;
  } else {
    const float length = std::sqrt(x * x + y * y + z * z);
    if (!(length > 1.0e-4f)) return false;
    x /= length;
    y /= length;
    z /= length;
    const float k = 1.0f - c, xs = x * s, ys = y * s, zs = z * s;
    at(0, 0) = k * (x * x) + c;
    at(0, 1) = k * (x * y) - zs;
    at(0, 2) = k * (z * x) + ys;
    at(1, 0) = k * (x * y) + zs;
    at(1, 1) = k * (y * y) + c;
    at(1, 2) = k * (y * z) - xs;
    at(2, 0) = k * (z * x) - ys;
    at(2, 1) = k * (y * z) + xs;
    at(2, 2) = k * (z * z) + c;
  }
  matrix = multiply(matrix, r);
  return true;
}

Mat4 frustum(float l, float r, float b, float t, float n, float f) {
  Mat4 p;
  p.m = {(2.0f * n) / (r - l),
         0,
         0,
         0,
         0,
         (2.0f * n) / (t - b),
         0,
         0,
         (r + l) / (r - l),
         (t + b) / (t - b),
         -(f + n) / (f - n),
         -1,
         0,
         0,
         -(2.0f * f * n) / (f - n),
         0};
  return p;
}

Mat4 ortho(float l, float r, float b, float t, float n, float f) {
  Mat4 p;
  p.m = {2.0f / (r - l),
         0,
         0,
         0,
         0,
         2.0f / (t - b),
         0,
         0,
         0,
         0,
         -2.0f / (f - n),
         0,
         -(r + l) / (r - l),
         -(t + b) / (t - b),
         -(f + n) / (f - n),
         1};
  return p;
}

Vec4 transform(const Mat4& matrix, const Vec4& v) {
  const auto& m = matrix.m;
  return {m[0] * v.x + m[4] * v.y + m[8] * v.z + m[12] * v.w,
          m[1] * v.x + m[5] * v.y + m[9] * v.z + m[13] * v.w,
          m[2] * v.x + m[6] * v.y + m[10] * v.z + m[14] * v.w,
          m[3] * v.x + m[7] * v.y + m[11] * v.z + m[15] * v.w};
}

Vec4 transform_plane(const Vec4& p, const Mat4& inverse) {
  const auto& m = inverse.m;
  return {p.x * m[0] + p.y * m[1] + p.z * m[2] + p.w * m[3],
          p.x * m[4] + p.y * m[5] + p.z * m[6] + p.w * m[7],
          p.x * m[8] + p.y * m[9] + p.z * m[10] + p.w * m[11],
          p.x * m[12] + p.y * m[13] + p.z * m[14] + p.w * m[15]};
}

Mat4 invert(const Mat4& matrix) {
  // Gauss-Jordan with row pivoting, in double precision. Columns before the pivot's are not looked
  // at again.
  double a[4][8] = {};
  for (size_t row = 0; row < 4; ++row) {
    for (size_t col = 0; col < 4; ++col) a[row][col] = static_cast<double>(matrix.m[4 * col + row]);
    a[row][4 + row] = 1;
  }
  for (size_t col = 0; col < 4; ++col) {
    size_t pivot = col;
    for (size_t row = col + 1; row < 4; ++row) {
      if (std::fabs(a[row][col]) > std::fabs(a[pivot][col])) pivot = row;
    }
    if (!(std::fabs(a[pivot][col]) > 0)) return {};
    if (pivot != col) {
      for (size_t k = col; k < 8; ++k) std::swap(a[col][k], a[pivot][k]);
    }
    const double factor = 1.0 / a[col][col];
    for (size_t k = col; k < 8; ++k) a[col][k] *= factor;
    for (size_t row = 0; row < 4; ++row) {
      if (row == col) continue;
      const double times = a[row][col];
      for (size_t k = col; k < 8; ++k) a[row][k] -= times * a[col][k];
    }
  }
  Mat4 inverse;
  for (size_t row = 0; row < 4; ++row) {
    for (size_t col = 0; col < 4; ++col)
      inverse.m[4 * col + row] = static_cast<float>(a[row][4 + col]);
  }
  return inverse;
}

bool is_identity(const Mat4& matrix) { return matrix.m == Mat4{}.m; }

}  // namespace clearpipe::api
