// Texture coordinates (2.10.2): generated ones (texgen-inl.h), then the texture matrix, of each
// unit that samples a texture. SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_VERTEX_TEXCOORD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_VERTEX_TEXCOORD_INL_H_
#undef CLEARPIPE_VERTEX_TEXCOORD_INL_H_
#else
#define CLEARPIPE_VERTEX_TEXCOORD_INL_H_
#endif

#include <hwy/highway.h>

#include <cstring>

#include "pipeline/vertex/transform-inl.h"
#include "pipeline/vertex/vertex_batch.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::vertex::HWY_NAMESPACE {

// The lanes that hold unit's final coordinates: those fetched when nothing changes them, else the
// batch's own, which transform_texture_coordinates fills.
HWY_INLINE const Lane* texture_lanes(const VertexState& state, const VertexBatch& batch, int unit) {
  return ((state.texture_matrix | state.reflection_map | state.normal_map) >> unit & 1) != 0
             ? batch.texture[unit]
             : batch.attribute[static_cast<int>(Attribute::kTexCoord0) + unit];
}

HWY_INLINE void transform_texture_coordinates(const VertexState& state, VertexBatch& batch,
                                              size_t count) {
  for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
    if ((state.texture_units >> unit & 1) == 0) continue;
    const Lane* given = batch.attribute[static_cast<int>(Attribute::kTexCoord0) + unit];
    const bool has_matrix = (state.texture_matrix >> unit & 1) != 0;
    if (((state.reflection_map | state.normal_map) >> unit & 1) != 0) {
      // q is not generated.
      const bool reflects = (state.reflection_map >> unit & 1) != 0;
      Lane* generated = has_matrix ? batch.generated : batch.texture[unit];
      std::memcpy(generated, reflects ? batch.reflection : batch.normal, 3 * sizeof(Lane));
      std::memcpy(generated[3], given[3], sizeof(Lane));
      given = generated;
    }
    if (has_matrix) {
      transform_position(state.texture_matrices[unit], given, count, batch.texture[unit]);
    }
  }
}

}  // namespace clearpipe::pipeline::vertex::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CLEARPIPE_VERTEX_TEXCOORD_INL_H_
