// Vertex fetch: attributes from arrays or constants into SoA lanes (2.8, table 2.7).
//
// Elements are gathered one by one, since each may lie anywhere and at any alignment; conversion to
// floating point then works on whole lanes. An index beyond the last element of a buffer object
// reads the last element, so nothing outside the buffer is ever touched.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_VERTEX_FETCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_VERTEX_FETCH_INL_H_
#undef CLEARPIPE_VERTEX_FETCH_INL_H_
#else
#define CLEARPIPE_VERTEX_FETCH_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "pipeline/vertex/vertex_batch.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::vertex::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Components of type T become floats of the same value.
template <typename T, int kSize>
HWY_INLINE void gather_components(const AttributeSource& source, const uint32_t* elements,
                                  size_t count, Lane* out) {
  for (size_t i = 0; i < count; ++i) {
    const size_t element = std::min(elements[i], source.max_index);
    T value[kSize];
    std::memcpy(value, source.pointer + element * source.stride, sizeof(value));
    for (int c = 0; c < kSize; ++c) {
      out[c][i] = static_cast<float>(value[c]);
    }
  }
}

// Elements of three or four floats: moved as they are, and made lanes of a vector at a time.
template <int kSize>
HWY_INLINE void gather_floats(const AttributeSource& source, const uint32_t* elements, size_t count,
                              Lane* out) {
  const hn::ScalableTag<float> d;
  HWY_ALIGN float moved[4 * kVertexBatch];
  for (size_t i = 0; i < count; ++i) {
    const size_t element = std::min(elements[i], source.max_index);
    std::memcpy(moved + 4 * i, source.pointer + element * source.stride, kSize * sizeof(float));
  }
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    hn::Vec<decltype(d)> x, y, z, w;
    hn::LoadInterleaved4(d, moved + 4 * i, x, y, z, w);
    hn::Store(x, d, out[0] + i);
    hn::Store(y, d, out[1] + i);
    hn::Store(z, d, out[2] + i);
    if (kSize == 4) hn::Store(w, d, out[3] + i);
  }
}

// The same of four bytes.
HWY_INLINE void gather_bytes(const AttributeSource& source, const uint32_t* elements, size_t count,
                             Lane* out) {
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  HWY_ALIGN int32_t moved[kVertexBatch];
  for (size_t i = 0; i < count; ++i) {
    const size_t element = std::min(elements[i], source.max_index);
    std::memcpy(moved + i, source.pointer + element * source.stride, sizeof(moved[i]));
  }
  for (int c = 0; c < 4; ++c) {
    for (size_t i = 0; i < count; i += hn::Lanes(d)) {
      const auto bytes = hn::ShiftRightSame(hn::Load(di, moved + i), 8 * c);
      hn::Store(hn::ConvertTo(d, hn::And(bytes, hn::Set(di, 0xff))), d, out[c] + i);
    }
  }
}

template <typename T>
void gather_sized(const AttributeSource& source, const uint32_t* elements, size_t count,
                  Lane* out) {
  if constexpr (std::is_same_v<T, float>) {
    if (source.size == 3) return gather_floats<3>(source, elements, count, out);
    if (source.size == 4) return gather_floats<4>(source, elements, count, out);
  }
  if constexpr (std::is_same_v<T, uint8_t>) {
    if (source.size == 4) return gather_bytes(source, elements, count, out);
  }
  switch (source.size) {
    case 1:
      return gather_components<T, 1>(source, elements, count, out);
    case 2:
      return gather_components<T, 2>(source, elements, count, out);
    case 3:
      return gather_components<T, 3>(source, elements, count, out);
    default:
      return gather_components<T, 4>(source, elements, count, out);
  }
}

// (factor * c + offset) / divisor, the conversions of table 2.7.
HWY_INLINE void convert_lane(float* lane, size_t count, float factor, float offset, float divisor) {
  const hn::ScalableTag<float> d;
  const auto scale = hn::Set(d, factor), add = hn::Set(d, offset), divide = hn::Set(d, divisor);
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto c = hn::Load(d, lane + i);
    hn::Store(hn::Div(hn::Add(hn::Mul(c, scale), add), divide), d, lane + i);
  }
}

// Fetches `count` elements into lanes that are padded to whole vectors (the padding holds numbers
// left from earlier batches and is never written out). Components the array lacks keep the values
// fill_constant_lanes gave them.
HWY_INLINE void fetch_array(const AttributeSource& source, const uint32_t* elements, size_t count,
                            Lane* out) {
  float factor = 1, offset = 0, divisor = 1;
  switch (source.type) {
    case ComponentType::kByte:
      gather_sized<int8_t>(source, elements, count, out);
      if (source.normalized) {
        factor = 2;
        offset = 1;
        divisor = 255;
      }
      break;
    case ComponentType::kUnsignedByte:
      gather_sized<uint8_t>(source, elements, count, out);
      if (source.normalized) {
        divisor = 255;
      }
      break;
    case ComponentType::kShort:
      gather_sized<int16_t>(source, elements, count, out);
      if (source.normalized) {
        factor = 2;
        offset = 1;
        divisor = 65535;
      }
      break;
    case ComponentType::kFixed:
      gather_sized<int32_t>(source, elements, count, out);
      divisor = 65536;
      break;
    case ComponentType::kFloat:
      gather_sized<float>(source, elements, count, out);
      break;
  }
  if (divisor != 1) {
    for (int c = 0; c < source.size; ++c) {
      convert_lane(out[c], count, factor, offset, divisor);
    }
  }
}

// Whether the attribute has an array to read; otherwise its lanes stay constant.
HWY_INLINE bool reads_array(const AttributeSource& source) {
  return source.is_array && source.pointer != nullptr;
}

// Once per job, for batches of up to `count` vertices: the current value for constant attributes,
// (0,0,0,1) below arrays.
HWY_INLINE void fill_constant_lanes(const AttributeSource& source, Lane* out,
                                    size_t count = kVertexBatch) {
  const Vec4 value = source.is_array ? Vec4{0, 0, 0, 1} : source.constant;
  const float component[4] = {value.x, value.y, value.z, value.w};
  for (int c = 0; c < 4; ++c) {
    std::fill_n(out[c], count, component[c]);
  }
}

}  // namespace clearpipe::pipeline::vertex::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CLEARPIPE_VERTEX_FETCH_INL_H_
