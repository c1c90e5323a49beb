// Coordinate transformations: clip and eye coordinates, normals (2.10, 2.10.3).
//
// Every sum is taken from left to right, one rounding per operation, so that positions round the
// way the reference's fixed-function vertex program rounds them: ((m0 x + m4 y) + m8 z) + m12 w.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_VERTEX_TRANSFORM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_VERTEX_TRANSFORM_INL_H_
#undef CLEARPIPE_VERTEX_TRANSFORM_INL_H_
#else
#define CLEARPIPE_VERTEX_TRANSFORM_INL_H_
#endif

#include <hwy/highway.h>

#include "pipeline/vertex/vertex_batch.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::vertex::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D, class V = hn::Vec<D>>
HWY_INLINE V dot4(D d, float a, float b, float c, float e, V x, V y, V z, V w) {
  const V ab = hn::Add(hn::Mul(hn::Set(d, a), x), hn::Mul(hn::Set(d, b), y));
  const V abc = hn::Add(ab, hn::Mul(hn::Set(d, c), z));
  return hn::Add(abc, hn::Mul(hn::Set(d, e), w));
}

template <class V>
HWY_INLINE V dot3(V ax, V ay, V az, V bx, V by, V bz) {
  return hn::Add(hn::Add(hn::Mul(ax, bx), hn::Mul(ay, by)), hn::Mul(az, bz));
}

// One row of matrix * vector, of `count` vertices from `first` on, which may be any: whole vectors
// are written, so what follows them must be transformed later, and `first + count` be followed by a
// vector's room.
HWY_INLINE void transform_row(const Mat4& matrix, int row, const Lane* in, size_t count, float* out,
                              size_t first = 0) {
  const hn::ScalableTag<float> d;
  const auto& m = matrix.m;
  for (size_t i = first; i < first + count; i += hn::Lanes(d)) {
    const auto result =
        dot4(d, m[row], m[4 + row], m[8 + row], m[12 + row], hn::LoadU(d, in[0] + i),
             hn::LoadU(d, in[1] + i), hn::LoadU(d, in[2] + i), hn::LoadU(d, in[3] + i));
    hn::StoreU(result, d, out + i);
  }
}

HWY_INLINE void transform_position(const Mat4& matrix, const Lane* in, size_t count, Lane* out,
                                   size_t first = 0) {
  for (int row = 0; row < 4; ++row) {
    transform_row(matrix, row, in, count, out[row], first);
  }
}

// Stores a vector of normals in eye coordinates, rescaled or normalised (2.10.3). Normalising makes
// a preceding rescale superfluous; a zero normal stays zero.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void store_normal(D d, const VertexState& state, V rescale, V nx, V ny, V nz, Lane* out,
                             size_t i) {
  if (state.normalize) {
    const auto square = dot3(nx, ny, nz, nx, ny, nz);
    const auto length = hn::Sqrt(square);
    const auto nonzero = hn::Gt(square, hn::Zero(d));
    nx = hn::IfThenElseZero(nonzero, hn::Div(nx, length));
    ny = hn::IfThenElseZero(nonzero, hn::Div(ny, length));
    nz = hn::IfThenElseZero(nonzero, hn::Div(nz, length));
  } else if (state.rescale_normal) {
    nx = hn::Mul(nx, rescale);
    ny = hn::Mul(ny, rescale);
    nz = hn::Mul(nz, rescale);
  }
  hn::StoreU(nx, d, out[0] + i);
  hn::StoreU(ny, d, out[1] + i);
  hn::StoreU(nz, d, out[2] + i);
}

HWY_INLINE void transform_normal(const VertexState& state, const Lane* in, size_t count, Lane* out,
                                 size_t first = 0) {
  const hn::ScalableTag<float> d;
  const auto& m = state.normal_matrix;
  const auto rescale = hn::Set(d, state.rescale);
  for (size_t i = first; i < first + count; i += hn::Lanes(d)) {
    const auto x = hn::LoadU(d, in[0] + i);
    const auto y = hn::LoadU(d, in[1] + i);
    const auto z = hn::LoadU(d, in[2] + i);
    store_normal(d, state, rescale,
                 dot3(hn::Set(d, m[0]), hn::Set(d, m[3]), hn::Set(d, m[6]), x, y, z),
                 dot3(hn::Set(d, m[1]), hn::Set(d, m[4]), hn::Set(d, m[7]), x, y, z),
                 dot3(hn::Set(d, m[2]), hn::Set(d, m[5]), hn::Set(d, m[8]), x, y, z), out, i);
  }
}

}  // namespace clearpipe::pipeline::vertex::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CLEARPIPE_VERTEX_TRANSFORM_INL_H_
