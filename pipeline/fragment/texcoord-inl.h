// Texture coordinates of a unit (3.7.7): the projective division, and the level of detail from the
// fragment's 2x2 quad.
//
// Quads are counted from the surface's first row, which window-system surfaces have at the top:
// there the quad's corner is its upper row, and the second row lies below it.
//
// The planes are already divided by w_clip, so s = S / Q needs no w. The derivative of a coordinate
// is its difference between neighbours of the quad that the fragment belongs to. rho is the longer
// of the two derivative vectors (equation 3.19), and its logarithm is the reference's, which is
// linear between powers of two: for rho^2 = m * 2^e with m in [1, 2), lambda = (e + (m - 1)) / 2.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_TEXCOORD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_TEXCOORD_INL_H_
#undef CLEARPIPE_FRAGMENT_TEXCOORD_INL_H_
#else
#define CLEARPIPE_FRAGMENT_TEXCOORD_INL_H_
#endif

#include <hwy/highway.h>

#include "pipeline/fragment/batch.h"
#include "pipeline/fragment/interpolate-inl.h"
#include "pipeline/fragment/sample.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Here and below, planes are four of Plane, or of planes that differ by lane.
template <class D, class P, class V = hn::Vec<D>>
HWY_INLINE void coordinate_at(D d, const P* planes, V x, V y, V& s, V& t) {
  const V reciprocal_q = hn::Div(hn::Set(d, 1.0f), evaluate(d, planes[3], x, y));
  s = hn::Mul(evaluate(d, planes[0], x, y), reciprocal_q);
  t = hn::Mul(evaluate(d, planes[1], x, y), reciprocal_q);
}

inline void texture_coordinates(const Plane* planes, FragmentBatch& batch) {
  const hn::ScalableTag<float> d;
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    hn::Vec<decltype(d)> s, t;
    coordinate_at(d, planes, hn::Load(d, batch.x + i), hn::Load(d, batch.y + i), s, t);
    hn::Store(s, d, batch.s + i);
    hn::Store(t, d, batch.t + i);
  }
}

template <class V>
HWY_INLINE V length_squared(V x, V y) {
  return hn::Add(hn::Mul(x, x), hn::Mul(y, y));
}

// rho^2 as a positive normal number; anything else is taken as far magnified.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V positive_number(D d, V rho_squared) {
  const V least = hn::Set(d, 1e-30f), most = hn::Set(d, 1e30f);
  return hn::IfThenElse(hn::And(hn::Gt(rho_squared, least), hn::Lt(rho_squared, most)), rho_squared,
                        least);
}

// lambda from rho^2.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V half_log2(D d, V rho_squared) {
  const hn::RebindToSigned<D> di;
  const auto bits = hn::BitCast(di, rho_squared);
  const V exponent = hn::ConvertTo(d, hn::Sub(hn::ShiftRight<23>(bits), hn::Set(di, 127)));
  const auto mantissa = hn::Or(hn::And(bits, hn::Set(di, 0x7fffff)), hn::Set(di, 0x3f800000));
  const V fraction = hn::Sub(hn::BitCast(d, mantissa), hn::Set(d, 1.0f));
  return hn::Mul(hn::Set(d, 0.5f), hn::Add(exponent, fraction));
}

// EXT_texture_filter_anisotropic: N = ceil(Pmax / Pmin), but not more than the sampler allows, nor
// than the footprint is texels long: more would see nothing new. At least 1.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V probe_count(D d, V longer_squared, V shorter_squared, V most) {
  const V one = hn::Set(d, 1.0f);
  const V shorter = hn::IfThenElse(hn::Gt(shorter_squared, hn::Set(d, 1e-30f)), shorter_squared,
                                   hn::Set(d, 1e-30f));
  const V ratio = hn::Sqrt(hn::Div(longer_squared, shorter));
  const V probes = hn::Ceil(hn::Min(ratio, hn::Sqrt(longer_squared)));
  return hn::Max(hn::Min(probes, hn::Floor(most)), one);
}

// The corner's row of the quad that has the row y of the window.
inline int quad_row(const Tile& tile, int y) {
  if (tile.mirror_height == 0) return y & ~1;
  const int last = tile.mirror_height - 1;
  return last - ((last - y) & ~1);
}

// The same of rows of the tile.
template <class V>
HWY_INLINE V quad_rows(const Tile& tile, V row) {
  const hn::DFromV<V> d;
  const V one = hn::Set(d, 1), y = hn::Add(row, hn::Set(d, tile.y));
  if (tile.mirror_height == 0) return hn::AndNot(one, y);
  const V last = hn::Set(d, tile.mirror_height - 1);
  return hn::Sub(last, hn::AndNot(one, hn::Sub(last, y)));
}

// The footprint of a quad in a level: the derivatives of (s, t) along x and y, and the squares of
// their lengths in texels.
template <class V>
struct Footprint {
  V s_x, t_x, s_y, t_y;
  V along_x, along_y;
};

// 1 / q at the pixels of a quad that derivatives need: its corner and the neighbours along x and y.
template <class V>
struct QuadReciprocals {
  V corner, along_x, along_y;
};

inline float next_quad_row(const Tile& tile) { return tile.mirror_height == 0 ? 1.0f : -1.0f; }

// Of the quads whose corners have their centres at (x, y).
template <class D, class P, class V = hn::Vec<D>>
HWY_INLINE QuadReciprocals<V> quad_reciprocals(D d, const P& q, const Tile& tile, V x, V y) {
  const V one = hn::Set(d, 1.0f);
  const V next_row = hn::Set(d, next_quad_row(tile));
  return {hn::Div(one, evaluate(d, q, x, y)), hn::Div(one, evaluate(d, q, hn::Add(x, one), y)),
          hn::Div(one, evaluate(d, q, x, hn::Add(y, next_row)))};
}

template <class D, class P, class V = hn::Vec<D>>
HWY_INLINE Footprint<V> quad_footprint(D d, const P* planes, const SampleLevel& level,
                                       const Tile& tile, V x, V y,
                                       const QuadReciprocals<V>& reciprocals) {
  const V width = hn::Set(d, static_cast<float>(level.width));
  const V height = hn::Set(d, static_cast<float>(level.height));
  const V right = hn::Add(x, hn::Set(d, 1.0f)), up = hn::Add(y, hn::Set(d, next_quad_row(tile)));
  const QuadReciprocals<V>& r = reciprocals;
  const V s0 = hn::Mul(evaluate(d, planes[0], x, y), r.corner);
  const V t0 = hn::Mul(evaluate(d, planes[1], x, y), r.corner);
  const V s1 = hn::Mul(evaluate(d, planes[0], right, y), r.along_x);
  const V t1 = hn::Mul(evaluate(d, planes[1], right, y), r.along_x);
  const V s2 = hn::Mul(evaluate(d, planes[0], x, up), r.along_y);
  const V t2 = hn::Mul(evaluate(d, planes[1], x, up), r.along_y);
  Footprint<V> f{hn::Sub(s1, s0), hn::Sub(t1, t0), hn::Sub(s2, s0), hn::Sub(t2, t0), {}, {}};
  f.along_x = length_squared(hn::Mul(f.s_x, width), hn::Mul(f.t_x, height));
  f.along_y = length_squared(hn::Mul(f.s_y, width), hn::Mul(f.t_y, height));
  return f;
}

template <class D, class P, class V = hn::Vec<D>>
HWY_INLINE Footprint<V> quad_footprint(D d, const P* planes, const SampleLevel& level,
                                       const Tile& tile, V x, V y) {
  return quad_footprint(d, planes, level, tile, x, y, quad_reciprocals(d, planes[3], tile, x, y));
}

// Without anisotropic filtering.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V level_of_detail(D d, const Footprint<V>& f) {
  const auto x_is_longer = hn::Gt(f.along_x, f.along_y);
  return half_log2(d, positive_number(d, hn::IfThenElse(x_is_longer, f.along_x, f.along_y)));
}

// The level of detail of a vector of fragments, and what anisotropic filtering needs, as
// FragmentBatch has them.
struct LevelArrays {
  float *lod, *probes, *along_s, *along_t;
};
template <class D, class V = hn::Vec<D>>
HWY_INLINE void store_level_of_detail(D d, const Footprint<V>& f, const SampleState& sample,
                                      const LevelArrays& to, int at) {
  if (sample.sampler.max_anisotropy <= 1) {
    hn::StoreU(level_of_detail(d, f), d, to.lod + at);
    return;
  }
  const auto x_is_longer = hn::Gt(f.along_x, f.along_y);
  V rho_squared = positive_number(d, hn::IfThenElse(x_is_longer, f.along_x, f.along_y));
  const V shorter = hn::IfThenElse(x_is_longer, f.along_y, f.along_x);
  const V probes = probe_count(d, rho_squared, shorter, hn::Set(d, sample.sampler.max_anisotropy));
  hn::StoreU(probes, d, to.probes + at);
  hn::StoreU(hn::IfThenElse(x_is_longer, f.s_x, f.s_y), d, to.along_s + at);
  hn::StoreU(hn::IfThenElse(x_is_longer, f.t_x, f.t_y), d, to.along_t + at);
  rho_squared = positive_number(d, hn::Div(rho_squared, hn::Mul(probes, probes)));
  hn::StoreU(half_log2(d, rho_squared), d, to.lod + at);
}

// The level of detail into batch.lod, and what anisotropic filtering needs.
inline void level_of_detail(const PrimitivePlanes& primitive, const Plane* planes,
                            const SampleState& sample, const Tile& tile, FragmentBatch& batch) {
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  using V = hn::Vec<decltype(d)>;
  const SampleLevel& level = sample.levels[sample.first_level];
  alignas(64) int32_t column[kBatchSize], row[kBatchSize];
  for (int i = 0; i < batch.count; ++i) {
    column[i] = tile.x + (batch.offset[i] % kTileWidth & ~1);
    row[i] = quad_row(tile, tile.y + batch.offset[i] / kTileWidth);
  }
  const V to_x = hn::Set(d, 0.5f - primitive.x_ref);
  const V to_y = hn::Set(d, 0.5f - primitive.y_ref);
  const LevelArrays to = {batch.lod, batch.probes, batch.along_s, batch.along_t};
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    const V x = hn::Add(hn::ConvertTo(d, hn::Load(di, column + i)), to_x);
    const V y = hn::Add(hn::ConvertTo(d, hn::Load(di, row + i)), to_y);
    store_level_of_detail(d, quad_footprint(d, planes, level, tile, x, y), sample, to, i);
  }
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
