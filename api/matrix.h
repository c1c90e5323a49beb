// Matrix arithmetic of the matrix commands (2.10.2), in single precision and in one fixed order of
// operations, so that coverage is the same everywhere and equal to Mesa's.
// SPDX-License-Identifier: MIT
#pragma once

#include "pipeline/state.h"

namespace clearpipe::api {

using pipeline::Mat4;
using pipeline::Vec4;

Mat4 multiply(const Mat4& a, const Mat4& b);
void translate(Mat4& matrix, float x, float y, float z);
void scale(Mat4& matrix, float x, float y, float z);
// False if the axis has no direction: the matrix is then unchanged.
bool rotate(Mat4& matrix, float degrees, float x, float y, float z);
Mat4 frustum(float l, float r, float b, float t, float n, float f);
Mat4 ortho(float l, float r, float b, float t, float n, float f);

Vec4 transform(const Mat4& matrix, const Vec4& v);
// The inverse; the identity for a singular matrix.
Mat4 invert(const Mat4& matrix);
// Row vector times matrix: planes, with the inverse modelview (2.11).
Vec4 transform_plane(const Vec4& plane, const Mat4& inverse);

bool is_identity(const Mat4& matrix);

// Sine and cosine in double precision without the C library, whose last bits vary.
void sin_cos(double radians, double& sine, double& cosine);

}  // namespace clearpipe::api
