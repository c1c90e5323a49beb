// Coordinates of a cube map (OES_texture_cube_map, 3.8.10): the face a direction points to, where
// it meets it, and the level of detail there.
//
// The direction is (s, t, r), with perspective but without q, which would only scale it. Of two
// coordinates as large as each other r wins over t, and t over s.
//
//   direction   +x   -x   +y   -y   +z   -z        s' = (sc / |ma| + 1) / 2
//   sc          -r   +r   +s   +s   +s   -s        t' = (tc / |ma| + 1) / 2
//   tc          -t   -t   +r   -r   -t   -t
//   ma           s    s    t    t    r    r
//
// The face changes from pixel to pixel, so the derivatives of s' and t' come from those of s, t and
// r on the fragment's own face: ds' = (dsc - sc dma / ma) / (2 ma).
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_CUBE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_CUBE_INL_H_
#undef CLEARPIPE_FRAGMENT_CUBE_INL_H_
#else
#define CLEARPIPE_FRAGMENT_CUBE_INL_H_
#endif

#include <hwy/highway.h>

#include "pipeline/fragment/batch.h"
#include "pipeline/fragment/interpolate-inl.h"
#include "pipeline/fragment/sample.h"
#include "pipeline/fragment/texcoord-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class V>
struct Direction {
  V s, t, r;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE Direction<V> direction_at(D d, const PrimitivePlanes& primitive, const Plane* planes,
                                     V x, V y) {
  Direction<V> v = {evaluate(d, planes[0], x, y), evaluate(d, planes[1], x, y),
                    evaluate(d, planes[2], x, y)};
  if (primitive.perspective) {
    const V w = hn::Div(hn::Set(d, 1.0f), evaluate(d, primitive.inv_w, x, y));
    v = {hn::Mul(v.s, w), hn::Mul(v.t, w), hn::Mul(v.r, w)};
  }
  return v;
}

template <class V>
HWY_INLINE Direction<V> difference(const Direction<V>& a, const Direction<V>& b) {
  return {hn::Sub(a.s, b.s), hn::Sub(a.t, b.t), hn::Sub(a.r, b.r)};
}

// The face that one direction selects, and the minor and major coordinates of others on it.
template <class D, class V = hn::Vec<D>>
class Face {
 public:
  HWY_INLINE Face(D d, const Direction<V>& v) {
    const V s = hn::Abs(v.s), t = hn::Abs(v.t), r = hn::Abs(v.r);
    is_x_ = hn::Gt(s, t);
    is_z_ = hn::Ge(r, hn::IfThenElse(is_x_, s, t));
    sign_ = hn::And(ma(v), hn::Set(d, -0.0f));
  }
  HWY_INLINE V sc(const Direction<V>& v) const {
    return choose(hn::Xor(sign_, hn::Neg(v.r)), v.s, hn::Xor(sign_, v.s));
  }
  HWY_INLINE V tc(const Direction<V>& v) const {
    const V down = hn::Neg(v.t);
    return choose(down, hn::Xor(sign_, v.r), down);
  }
  HWY_INLINE V ma(const Direction<V>& v) const { return choose(v.s, v.t, v.r); }
  HWY_INLINE hn::Vec<hn::RebindToSigned<D>> key(D d) const {
    const hn::RebindToSigned<D> di;
    const auto axis = [&](int face) { return hn::BitCast(d, hn::Set(di, face * kFaceKey)); };
    const auto positive = hn::BitCast(di, choose(axis(0), axis(2), axis(4)));
    const auto negative = hn::BroadcastSignBit(hn::BitCast(di, sign_));
    return hn::Add(positive, hn::And(negative, hn::Set(di, kFaceKey)));
  }

 private:
  HWY_INLINE V choose(V x, V y, V z) const {
    return hn::IfThenElse(is_z_, z, hn::IfThenElse(is_x_, x, y));
  }
  hn::Mask<D> is_x_, is_z_;  // z goes before the others
  V sign_;                   // of ma
};

// The level of detail from the derivatives of the direction along x and y.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V cube_level_of_detail(D d, const Face<D>& face, const Direction<V>& v,
                                  const Direction<V>& along_x, const Direction<V>& along_y,
                                  V size) {
  const V inverse = hn::Div(hn::Set(d, 1.0f), face.ma(v));
  const V half = hn::Mul(hn::Set(d, 0.5f), inverse);
  const V sc = face.sc(v), tc = face.tc(v);
  const auto squared = [&](const Direction<V>& along) HWY_ATTR {
    const V scaled = hn::Mul(face.ma(along), inverse);
    const V ds = hn::Mul(hn::Sub(face.sc(along), hn::Mul(scaled, sc)), half);
    const V dt = hn::Mul(hn::Sub(face.tc(along), hn::Mul(scaled, tc)), half);
    return length_squared(hn::Mul(ds, size), hn::Mul(dt, size));
  };
  return half_log2(d, positive_number(d, hn::Max(squared(along_x), squared(along_y))));
}

// Fills batch.s, batch.t, batch.face and batch.lod.
inline void cube_coordinates(const PrimitivePlanes& primitive, const Plane* planes,
                             const SampleState& sample, const Tile& tile, FragmentBatch& batch) {
  using D = hn::ScalableTag<float>;
  using V = hn::Vec<D>;
  const D d;
  const hn::RebindToSigned<D> di;
  const V size = hn::Set(d, static_cast<float>(sample.levels[sample.first_level].width));
  const V zero = hn::Zero(d), half = hn::Set(d, 0.5f), one = hn::Set(d, 1.0f);
  alignas(64) int32_t column[kBatchSize], row[kBatchSize];
  for (int i = 0; i < batch.count; ++i) {
    column[i] = tile.x + (batch.offset[i] % kTileWidth & ~1);
    row[i] = quad_row(tile, tile.y + batch.offset[i] / kTileWidth);
  }
  const V to_x = hn::Set(d, 0.5f - primitive.x_ref);
  const V to_y = hn::Set(d, 0.5f - primitive.y_ref);
  const V next_row = hn::Set(d, tile.mirror_height == 0 ? 1.0f : -1.0f);
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    const V x = hn::Load(d, batch.x + i), y = hn::Load(d, batch.y + i);
    const auto at = [&](V px, V py) HWY_ATTR { return direction_at(d, primitive, planes, px, py); };
    const Direction<V> v = at(x, y);
    const Face<D> face(d, v);
    const V length = hn::Abs(face.ma(v));
    const V scale = hn::IfThenElse(hn::Gt(length, zero), hn::Div(half, length), zero);
    hn::Store(hn::Add(hn::Mul(face.sc(v), scale), half), d, batch.s + i);
    hn::Store(hn::Add(hn::Mul(face.tc(v), scale), half), d, batch.t + i);
    hn::Store(face.key(d), di, batch.face + i);
    if (!sample.needs_lod) {
      hn::Store(zero, d, batch.lod + i);
      continue;
    }
    const V x0 = hn::Add(hn::ConvertTo(d, hn::Load(di, column + i)), to_x);
    const V y0 = hn::Add(hn::ConvertTo(d, hn::Load(di, row + i)), to_y);
    const Direction<V> along_x = difference(at(hn::Add(x0, one), y), at(x0, y));
    const Direction<V> along_y = difference(at(x, hn::Add(y0, next_row)), at(x, y0));
    hn::Store(cube_level_of_detail(d, face, v, along_x, along_y, size), d, batch.lod + i);
  }
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
