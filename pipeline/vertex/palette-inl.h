// Vertex skinning (OES_matrix_palette): eye coordinates and normals as weighted sums over a few
// matrices, which each vertex picks from a palette.
//
//   eye = sum over the vertex units i of w_i * M_i * object        M_i = palette[index_i]
//   n'  = (sum over i of w_i * N_i) * n                            N_i = transposed inverse of M_i
//
// of the two ways the extension gives for normals, the one that inverts no matrix for a vertex.
// Sums are taken from left to right, one rounding per operation. SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_VERTEX_PALETTE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_VERTEX_PALETTE_INL_H_
#undef CLEARPIPE_VERTEX_PALETTE_INL_H_
#else
#define CLEARPIPE_VERTEX_PALETTE_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "pipeline/vertex/math-inl.h"
#include "pipeline/vertex/transform-inl.h"
#include "pipeline/vertex/vertex_batch.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::vertex::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// What the units of a vertex have: indices and weights, by lane.
struct PaletteInputs {
  const Lane* index;
  const Lane* weight;
  int units;
};

// A weight that the array does not have is zero.
HWY_INLINE PaletteInputs palette_inputs(const DrawCommand& draw, const VertexBatch& batch) {
  const auto index = static_cast<size_t>(Attribute::kMatrixIndex);
  const auto weight = static_cast<size_t>(Attribute::kWeight);
  return {batch.attribute[index], batch.attribute[weight],
          std::min<int>(draw.attributes[index].size, draw.attributes[weight].size)};
}

// The same of one vector of vertices. Whatever an index is, the matrix is one of the palette.
template <class D, class V = hn::Vec<D>>
struct PaletteUnits {
  using VI = hn::Vec<hn::RebindToSigned<D>>;
  VI matrix[kVertexUnits];
  V weight[kVertexUnits];
  int count;

  HWY_INLINE PaletteUnits(D d, const PaletteInputs& in, size_t i) : count(in.units) {
    const V last = hn::Set(d, static_cast<float>(kPaletteMatrices - 1));
    for (int unit = 0; unit < count; ++unit) {
      const V index = at_most(hn::Load(d, in.index[unit] + i), last);
      matrix[unit] = hn::ConvertTo(hn::RebindToSigned<D>(), index);
      weight[unit] = hn::Load(d, in.weight[unit] + i);
    }
  }

  // Element k of the matrix that a unit picks from matrices of `size` floats.
  HWY_INLINE V element(D d, int unit, const float* matrices, int size, int k) const {
    const VI offset = hn::Mul(matrix[unit], hn::Set(hn::RebindToSigned<D>(), size));
    return hn::GatherIndex(d, matrices + k, offset);
  }
};

HWY_INLINE void skin_position(const MatrixPalette& palette, const PaletteInputs& in,
                              const Lane* object, size_t count, Lane* eye) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const PaletteUnits units(d, in, i);
    for (int row = 0; row < 4; ++row) {
      V sum = hn::Zero(d);
      for (int unit = 0; unit < units.count; ++unit) {
        V product = hn::Zero(d);
        for (int column = 0; column < 4; ++column) {
          const V m = units.element(d, unit, palette.matrix.data(), 16, 4 * column + row);
          const V term = hn::Mul(m, hn::Load(d, object[column] + i));
          product = column == 0 ? term : hn::Add(product, term);
        }
        product = hn::Mul(units.weight[unit], product);
        sum = unit == 0 ? product : hn::Add(sum, product);
      }
      hn::Store(sum, d, eye[row] + i);
    }
  }
}

// As transform_normal, with a matrix of its own for each vertex, and hence a factor of
// RESCALE_NORMAL of its own: that of the third row of the inverse (2.10.3).
HWY_INLINE void skin_normal(const VertexState& state, const PaletteInputs& in, const Lane* object,
                            size_t count, Lane* out) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  const float* matrices = state.palette->normal_matrix.data();
  const V one = hn::Set(d, 1.0f);
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const PaletteUnits units(d, in, i);
    V m[9];
    for (int k = 0; k < 9; ++k) {
      m[k] = hn::Zero(d);
      for (int unit = 0; unit < units.count; ++unit) {
        const V term = hn::Mul(units.weight[unit], units.element(d, unit, matrices, 9, k));
        m[k] = unit == 0 ? term : hn::Add(m[k], term);
      }
    }
    const V square = dot3(m[6], m[7], m[8], m[6], m[7], m[8]);
    const auto usable = hn::Gt(square, hn::Set(d, 1e-12f));
    const V rescale = hn::IfThenElse(usable, hn::Div(one, hn::Sqrt(square)), one);
    const V x = hn::Load(d, object[0] + i), y = hn::Load(d, object[1] + i);
    const V z = hn::Load(d, object[2] + i);
    store_normal(d, state, rescale, dot3(m[0], m[3], m[6], x, y, z),
                 dot3(m[1], m[4], m[7], x, y, z), dot3(m[2], m[5], m[8], x, y, z), out, i);
  }
}

}  // namespace clearpipe::pipeline::vertex::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CLEARPIPE_VERTEX_PALETTE_INL_H_
