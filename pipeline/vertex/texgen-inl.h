// Generated texture coordinates (OES_texture_cube_map, 2.11.4): the reflection vector of the eye at
// the vertex, or the normal.
//
//   r = u - 2 n (n . u)
//
// u is the unit vector from the origin to the vertex, n the normal as lighting has it (2.10.3),
// both in eye coordinates. A vertex whose w is negative lies in the direction opposite to (x, y,
// z). SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_VERTEX_TEXGEN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_VERTEX_TEXGEN_INL_H_
#undef CLEARPIPE_VERTEX_TEXGEN_INL_H_
#else
#define CLEARPIPE_VERTEX_TEXGEN_INL_H_
#endif

#include <hwy/highway.h>

#include "pipeline/vertex/lighting-inl.h"
#include "pipeline/vertex/transform-inl.h"
#include "pipeline/vertex/vertex_batch.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::vertex::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE void reflection_vector(const Lane* eye, const Lane* normal, size_t count, Lane* out) {
  const FloatTag d;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto sign = hn::CopySign(hn::Set(d, 1.0f), hn::Load(d, eye[3] + i));
    const Direction to_vertex = {hn::Mul(sign, hn::Load(d, eye[0] + i)),
                                 hn::Mul(sign, hn::Load(d, eye[1] + i)),
                                 hn::Mul(sign, hn::Load(d, eye[2] + i))};
    FloatVector unused;
    const Direction u = unit_vector(d, to_vertex, unused);
    const auto nx = hn::Load(d, normal[0] + i);
    const auto ny = hn::Load(d, normal[1] + i);
    const auto nz = hn::Load(d, normal[2] + i);
    const auto n_dot_u = dot3(nx, ny, nz, u.x, u.y, u.z);
    const auto twice = hn::Add(n_dot_u, n_dot_u);
    hn::Store(hn::Sub(u.x, hn::Mul(twice, nx)), d, out[0] + i);
    hn::Store(hn::Sub(u.y, hn::Mul(twice, ny)), d, out[1] + i);
    hn::Store(hn::Sub(u.z, hn::Mul(twice, nz)), d, out[2] + i);
  }
}

}  // namespace clearpipe::pipeline::vertex::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CLEARPIPE_VERTEX_TEXGEN_INL_H_
