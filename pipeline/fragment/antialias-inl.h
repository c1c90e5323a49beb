// Antialiased points and lines: how much of a pixel's square the circle (3.3.1) or the rectangle
// (3.4.2) covers, and the application of that coverage to alpha (3.9, 3.10).
//
// The rectangle's share is exact but for rounding, the circle's within 1/200: chords are exact, and
// sixteen of them stand for the square.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_ANTIALIAS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_ANTIALIAS_INL_H_
#undef CLEARPIPE_FRAGMENT_ANTIALIAS_INL_H_
#else
#define CLEARPIPE_FRAGMENT_ANTIALIAS_INL_H_
#endif

#include <hwy/highway.h>

#include <cmath>

#include "pipeline/fragment/batch.h"
#include "pipeline/fragment/colour-inl.h"
#include "pipeline/fragment/program.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D, class V = hn::Vec<D>>
HWY_INLINE V clamp01(D d, V v) {
  return hn::Min(hn::Max(v, hn::Zero(d)), hn::Set(d, 1.0f));
}

// The area of the circle around the origin inside the unit square whose centre is (x, y).
//
// By symmetry the square lies at u >= v >= 0. Each chord runs along u, where the boundary is
// steepest, from -h to h, and counts as far as it lies inside the square:
//
//   sum over k of |[-h, h] and [u - 1/2, u + 1/2]| / 16,  h^2 = r^2 - (v + (k + 1/2)/16 - 1/2)^2
template <class D, class V = hn::Vec<D>>
HWY_INLINE V circle_coverage(D d, V radius, V x, V y) {
  constexpr int kChords = 16;
  const V u = hn::Max(hn::Abs(x), hn::Abs(y)), v = hn::Min(hn::Abs(x), hn::Abs(y));
  const V left = hn::Sub(u, hn::Set(d, 0.5f)), right = hn::Add(u, hn::Set(d, 0.5f));
  const V square = hn::Mul(radius, radius);
  V sum = hn::Zero(d);
  for (int k = 0; k < kChords; ++k) {
    const V at = hn::Add(v, hn::Set(d, (static_cast<float>(k) + 0.5f) / kChords - 0.5f));
    const V h = hn::Sqrt(hn::Max(hn::Sub(square, hn::Mul(at, at)), hn::Zero(d)));
    const V chord = hn::Sub(hn::Min(h, right), hn::Max(hn::Neg(h), left));
    sum = hn::Add(sum, hn::Max(chord, hn::Zero(d)));
  }
  return hn::Mul(sum, hn::Set(d, 1.0f / kChords));
}

// An edge from p to q, and how x changes with y along it.
template <class V>
struct AreaEdge {
  V px, py, qy, slope;
};

// The share of one edge, from p to q, in the area of a polygon inside the unit square whose lower
// left corner is (left, bottom): by Green's theorem the area is the sum over the edges of
//
//   integral of clamp(x - left, 0, 1) dy  over the edge's y in [bottom, bottom + 1].
//
// Along the edge x is linear in y, so the mean of the integrand is (F(u1) - F(u0)) / (u1 - u0) with
// u = x - left at the ends and F its antiderivative, F(u) = c * (u - c/2), c = clamp(u, 0, 1).
template <class D, class V = hn::Vec<D>>
HWY_INLINE V edge_share(D d, const AreaEdge<V>& edge, V left, V bottom) {
  const V half = hn::Set(d, 0.5f), slope = edge.slope;
  const V px = hn::Sub(edge.px, left), py = hn::Sub(edge.py, bottom);
  const V qy = hn::Sub(edge.qy, bottom);
  const V y0 = clamp01(d, py), y1 = clamp01(d, qy);
  const V u0 = hn::Add(px, hn::Mul(hn::Sub(y0, py), slope));
  const V u1 = hn::Add(px, hn::Mul(hn::Sub(y1, py), slope));
  const V c0 = clamp01(d, u0), c1 = clamp01(d, u1);
  const V f0 = hn::Mul(c0, hn::Sub(u0, hn::Mul(half, c0)));
  const V f1 = hn::Mul(c1, hn::Sub(u1, hn::Mul(half, c1)));
  // Nearly upright edges: the quotient would lose its digits, the middle is as good.
  const V du = hn::Sub(u1, u0);
  const auto upright = hn::Lt(hn::Abs(du), hn::Set(d, 1.0f / 1024));
  const V quotient = hn::Div(hn::Sub(f1, f0), hn::IfThenElse(upright, hn::Set(d, 1.0f), du));
  const V mean = hn::IfThenElse(upright, hn::Mul(hn::Add(u0, u1), half), quotient);
  return hn::Mul(hn::Sub(y1, y0), clamp01(d, mean));
}

// What a fragment's primitive covers (SmoothRegion).
template <class V>
struct SmoothShape {
  bool is_circle;
  V radius;
  AreaEdge<V> edge[4];  // of the rectangle, counter-clockwise
};

template <class V>
HWY_INLINE SmoothShape<V> smooth_shape(bool is_circle, V half_width, V dx, V dy) {
  SmoothShape<V> shape;
  shape.is_circle = is_circle;
  shape.radius = half_width;
  if (is_circle) return shape;
  const V length = hn::Sqrt(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)));
  const V scale = hn::Div(half_width, length);
  const V nx = hn::Mul(hn::Neg(dy), scale), ny = hn::Mul(dx, scale);
  const V x[4] = {hn::Neg(nx), hn::Sub(dx, nx), hn::Add(dx, nx), nx};
  const V y[4] = {hn::Neg(ny), hn::Sub(dy, ny), hn::Add(dy, ny), ny};
  for (int p = 0; p < 4; ++p) {
    const int q = (p + 1) % 4;
    const V slope = hn::Div(hn::Sub(x[q], x[p]), hn::Sub(y[q], y[p]));
    shape.edge[p] = {x[p], y[p], y[q], hn::IfThenElseZero(hn::Ne(y[q], y[p]), slope)};
  }
  return shape;
}

// That of each fragment of a vector, from those of primitives: `of` takes values of primitives to
// their fragments.
template <class V, class Of>
HWY_INLINE SmoothShape<V> shape_of_fragments(const SmoothShape<V>& shapes, const Of& of) {
  SmoothShape<V> shape;
  shape.is_circle = shapes.is_circle;
  if (shape.is_circle) {
    shape.radius = of(shapes.radius);
    return shape;
  }
  V y[4];
  for (int p = 0; p < 4; ++p) y[p] = of(shapes.edge[p].py);
  for (int p = 0; p < 4; ++p) {  // an edge begins where the last one ends
    shape.edge[p] = {of(shapes.edge[p].px), y[p], y[(p + 1) % 4], of(shapes.edge[p].slope)};
  }
  return shape;
}

// How much of the pixel around (x, y) is covered, relative to the region's reference.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Vec<hn::Rebind<int16_t, D>> covered_share(D d, const SmoothShape<V>& shape, V x,
                                                         V y) {
  V area = hn::Zero(d);
  if (shape.is_circle) {
    area = circle_coverage(d, shape.radius, x, y);
  } else {
    const V left = hn::Sub(x, hn::Set(d, 0.5f)), bottom = hn::Sub(y, hn::Set(d, 0.5f));
    for (const AreaEdge<V>& edge : shape.edge) {
      area = hn::Add(area, edge_share(d, edge, left, bottom));
    }
  }
  return to_colour(hn::Rebind<int16_t, D>(), d, area);
}

// Fragments with no coverage (less than half a step of a colour) are not produced.
HWY_INLINE void drop_uncovered(FragmentBatch& batch) {
  const hn::ScalableTag<int16_t> d;
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    const auto covered = hn::Gt(hn::Load(d, batch.coverage + i), hn::Zero(d));
    const auto live = hn::And(hn::Load(d, batch.live + i), hn::VecFromMask(d, covered));
    hn::Store(live, d, batch.live + i);
  }
}

// The coverage of each fragment of a primitive.
inline void smooth_coverage(const SmoothRegion& region, FragmentBatch& batch) {
  const hn::ScalableTag<float> d;
  const hn::Rebind<int16_t, decltype(d)> d16;
  const auto shape = smooth_shape(region.is_circle, hn::Set(d, region.half_width),
                                  hn::Set(d, region.dx), hn::Set(d, region.dy));
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    const auto x = hn::Load(d, batch.x + i), y = hn::Load(d, batch.y + i);
    hn::Store(covered_share(d, shape, x, y), d16, batch.coverage + i);
  }
  drop_uncovered(batch);
}

// 3.9: A = coverage * A.
inline void apply_coverage(FragmentBatch& batch) {
  const hn::ScalableTag<int16_t> d;
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    const auto alpha = hn::Load(d, batch.previous[3] + i);
    hn::Store(multiply(alpha, hn::Load(d, batch.coverage + i)), d, batch.previous[3] + i);
  }
}

// 3.10: A = fade * A.
inline void fade_point(float fade, FragmentBatch& batch) {
  const hn::ScalableTag<int16_t> d;
  const auto factor = hn::Set(d, static_cast<int16_t>(std::nearbyint(fade * float{kColourOne})));
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    const auto alpha = hn::Load(d, batch.previous[3] + i);
    hn::Store(multiply(alpha, factor), d, batch.previous[3] + i);
  }
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
