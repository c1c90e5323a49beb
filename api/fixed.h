// Conversions between the 16.16 fixed-point type and float (2.3), saturating where the
// specification leaves the value undefined.
// SPDX-License-Identifier: MIT
#pragma once

#include <GLES/gl.h>

#include <cmath>
#include <cstdint>

namespace clearpipe::api {

inline float from_fixed(GLfixed value) { return static_cast<float>(value) * (1.0f / 65536.0f); }

inline int32_t saturate_int(double value) {
  if (!(value > -2147483648.0)) return value != value ? 0 : INT32_MIN;
  return value < 2147483647.0 ? static_cast<int32_t>(value) : INT32_MAX;
}

inline int64_t saturate_int64(double value) {
  if (!(value > -9223372036854775808.0)) return value != value ? 0 : INT64_MIN;
  return value < 9223372036854775808.0 ? static_cast<int64_t>(value) : INT64_MAX;
}

inline GLfixed to_fixed(float value) {
  return saturate_int(std::floor(static_cast<double>(value) * 65536.0 + 0.5));
}

inline float clamp01(float value) { return value > 0 ? (value < 1 ? value : 1.0f) : 0.0f; }

}  // namespace clearpipe::api
