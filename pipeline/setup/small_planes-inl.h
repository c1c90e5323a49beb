// The attribute planes of small primitives: make_planes (planes.cpp) with the four components of an
// attribute in a vector. The arithmetic is the same, operation by operation; primitives of fewer
// than three vertices repeat the first.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_SETUP_SMALL_PLANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_SETUP_SMALL_PLANES_INL_H_
#undef CLEARPIPE_SETUP_SMALL_PLANES_INL_H_
#else
#define CLEARPIPE_SETUP_SMALL_PLANES_INL_H_
#endif

#include <hwy/highway.h>

#include "pipeline/setup/small.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::setup::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

using Tag4 = hn::FixedTag<float, 4>;
using Vec4f = hn::Vec<Tag4>;

// Four planes at once.
struct Planes4 {
  Vec4f value, dx, dy;
};

// The gradients of a function, as in planes.cpp; those of a point are 0.
struct SmallBasis {
  float x1 = 0, x2 = 0, y1 = 0, y2 = 0;

  HWY_INLINE Planes4 planes(Vec4f a0, Vec4f a1, Vec4f a2) const {
    const Tag4 d;
    const Vec4f d1 = hn::Sub(a1, a0), d2 = hn::Sub(a2, a0);
    return {a0, hn::Add(hn::Mul(d1, hn::Set(d, x1)), hn::Mul(d2, hn::Set(d, x2))),
            hn::Add(hn::Mul(d1, hn::Set(d, y1)), hn::Mul(d2, hn::Set(d, y2)))};
  }
};

HWY_INLINE float window_up(float mirror_height, const float* window) {
  return mirror_height > 0 ? mirror_height - window[1] : window[1];
}

// Equation 3.6.
HWY_INLINE SmallBasis triangle_basis(float mirror_height, const float* w0, const float* w1,
                                     const float* w2) {
  const float x10 = w1[0] - w0[0], x20 = w2[0] - w0[0];
  const float y0 = window_up(mirror_height, w0);
  const float y10 = window_up(mirror_height, w1) - y0, y20 = window_up(mirror_height, w2) - y0;
  const float area = x10 * y20 - x20 * y10;
  if (area == 0) return {};
  const float inverse = 1.0f / area;
  return {y20 * inverse, -y10 * inverse, -x20 * inverse, x10 * inverse};
}

// 3.4.1: along the major axis.
HWY_INLINE SmallBasis line_basis(float mirror_height, bool x_major, const float* w0,
                                 const float* w1) {
  if (x_major) return {1.0f / (w1[0] - w0[0]), 0, 0, 0};
  return {0, 0, 1.0f / (window_up(mirror_height, w1) - window_up(mirror_height, w0)), 0};
}

HWY_INLINE void store_planes(const Planes4& planes, SmallPlanes::Four& out) {
  const Tag4 d;
  hn::Store(planes.value, d, out.value);
  hn::Store(planes.dx, d, out.dx);
  hn::Store(planes.dy, d, out.dy);
}

template <PrimitiveKind kKind>
HWY_INLINE void make_planes_of(const SetupState& state, const PlaneSource& p, SmallPlanes& out) {
  const Tag4 d;
  const float* v0 = p.vertex[0];
  const float* v1 = kKind == PrimitiveKind::kPoint ? v0 : p.vertex[1];
  const float* v2 = kKind == PrimitiveKind::kTriangle ? p.vertex[2] : v0;
  const float* w0 = v0 + vertex_record::kWindow;
  const float* w1 = v1 + vertex_record::kWindow;
  const float* w2 = v2 + vertex_record::kWindow;
  const float mirror_height = static_cast<float>(state.mirror_height);
  SmallBasis basis;
  if constexpr (kKind == PrimitiveKind::kTriangle) {
    basis = triangle_basis(mirror_height, w0, w1, w2);
  } else if constexpr (kKind == PrimitiveKind::kLine) {
    basis = line_basis(mirror_height, p.size > 0, w0, w1);
  }
  out.x_ref = w0[0];
  out.y_ref = window_up(mirror_height, w0);
  out.perspective = w0[3] != w1[3] || w0[3] != w2[3];
  if (state.inputs.depth || out.perspective) {
    store_planes(basis.planes(hn::LoadU(d, w0), hn::LoadU(d, w1), hn::LoadU(d, w2)), out.window);
  }
  Vec4f s0 = hn::Set(d, 1.0f), s1 = s0, s2 = s0;
  if (out.perspective) {
    s0 = hn::Set(d, w0[3]);
    s1 = hn::Set(d, w1[3]);
    s2 = hn::Set(d, w2[3]);
  }
  const auto varying = [&](Vec4f a0, Vec4f a1, Vec4f a2) HWY_ATTR {
    return basis.planes(hn::Mul(a0, s0), hn::Mul(a1, s1), hn::Mul(a2, s2));
  };
  const auto varying_at = [&](int offset) HWY_ATTR {
    return varying(hn::LoadU(d, v0 + offset), hn::LoadU(d, v1 + offset), hn::LoadU(d, v2 + offset));
  };
  if (state.inputs.colour) {
    const int offset =
        p.back_facing && state.two_sided ? state.layout.back_colour_offset : vertex_record::kColour;
    const Vec4f a0 = hn::LoadU(d, v0 + offset), a1 = hn::LoadU(d, v1 + offset);
    const Vec4f a2 = hn::LoadU(d, v2 + offset);
    out.flat_colour = state.raster.flat_shade || kKind == PrimitiveKind::kPoint ||
                      hn::AllTrue(d, hn::And(hn::Eq(a0, a1), hn::Eq(a0, a2)));
    const Vec4f provoking = kKind == PrimitiveKind::kTriangle ? a2 : a1;
    Planes4 colour =
        out.flat_colour ? Planes4{provoking, hn::Zero(d), hn::Zero(d)} : varying(a0, a1, a2);
    const Vec4f one = hn::Set(d, float{kColourOne});
    colour = {hn::Mul(colour.value, one), hn::Mul(colour.dx, one), hn::Mul(colour.dy, one)};
    store_planes(colour, out.colour);
  }
  if (state.inputs.fog) store_planes(varying_at(vertex_record::kOutcode), out.fog_group);
  for (int unit = 0; state.inputs.texture_units >> unit != 0; ++unit) {
    if ((state.inputs.texture_units >> unit & 1) == 0) continue;
    store_planes(varying_at(state.layout.texture_offset[unit]), out.texture[unit]);
  }
}

#endif  // HWY_TARGET != HWY_SCALAR

// What is rare, as make_planes does it: polygon offset, coordinates of sprites.
HWY_INLINE void small_planes(const SetupState& state, const PlaneSource& p, SmallPlanes& out) {
#if HWY_TARGET != HWY_SCALAR
  switch (p.kind) {
    case PrimitiveKind::kTriangle:
      if (state.raster.offset_fill) break;
      return make_planes_of<PrimitiveKind::kTriangle>(state, p, out);
    case PrimitiveKind::kLine:
      return make_planes_of<PrimitiveKind::kLine>(state, p, out);
    case PrimitiveKind::kPoint:
      if (state.raster.point_sprite) break;
      return make_planes_of<PrimitiveKind::kPoint>(state, p, out);
  }
#endif
  make_small_planes(state, p, out);
}

}  // namespace clearpipe::pipeline::setup::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
