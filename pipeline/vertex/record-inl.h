// From lanes to records: what the stages computed, one vertex after the other, in the layout of
// vertex_stage.h.
//
// Four lanes at a time become groups of four floats,
//   x0 x1 x2 ..  y0 y1 y2 ..  z0 z1 z2 ..  w0 w1 w2 ..  ->  x0 y0 z0 w0  x1 y1 z1 w1  ...
// and each group goes to its place in its record.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_VERTEX_RECORD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_VERTEX_RECORD_INL_H_
#undef CLEARPIPE_VERTEX_RECORD_INL_H_
#else
#define CLEARPIPE_VERTEX_RECORD_INL_H_
#endif

#include <hwy/highway.h>

#include <cstring>

#include "pipeline/vertex/texcoord-inl.h"
#include "pipeline/vertex/vertex_batch.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::vertex::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// `out` is the place of the group in the first record, `stride` the length of a record.
HWY_INLINE void store_group(const float* x, const float* y, const float* z, const float* w,
                            size_t count, float* out, size_t stride) {
  const hn::ScalableTag<float> d;
  const size_t lanes = hn::Lanes(d);
  HWY_ALIGN float group[4 * hn::MaxLanes(d)];
  for (size_t i = 0; i < count; i += lanes) {
    hn::StoreInterleaved4(hn::Load(d, x + i), hn::Load(d, y + i), hn::Load(d, z + i),
                          hn::Load(d, w + i), d, group);
    const size_t in_use = count - i < lanes ? count - i : lanes;
    for (size_t v = 0; v < in_use; ++v) {
      std::memcpy(out + (i + v) * stride, group + 4 * v, 4 * sizeof(float));
    }
  }
}

HWY_INLINE void store_group(const Lane* lanes, size_t count, float* out, size_t stride) {
  store_group(lanes[0], lanes[1], lanes[2], lanes[3], count, out, stride);
}

HWY_INLINE void store_records(const VertexState& state, const VertexLayout& layout,
                              const VertexBatch& batch, size_t count, float* records) {
  const size_t stride = layout.stride;
  store_group(batch.clip, count, records + vertex_record::kClip, stride);
  store_group(batch.window, count, records + vertex_record::kWindow, stride);
  store_group(batch.outcode, batch.point_size, batch.fog, batch.point_alpha, count,
              records + vertex_record::kOutcode, stride);
  store_group(batch.colour, count, records + vertex_record::kColour, stride);
  for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
    if ((layout.texture_units >> unit & 1) != 0) {
      store_group(texture_lanes(state, batch, unit), count, records + layout.texture_offset[unit],
                  stride);
    }
  }
  if (layout.back_colour_offset != 0) {
    store_group(batch.back_colour, count, records + layout.back_colour_offset, stride);
  }
  if (layout.clip_distance_offset != 0) {
    store_group(batch.clip_distance, count, records + layout.clip_distance_offset, stride);
    store_group(batch.clip_distance + 4, count, records + layout.clip_distance_offset + 4, stride);
  }
}

}  // namespace clearpipe::pipeline::vertex::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CLEARPIPE_VERTEX_RECORD_INL_H_
