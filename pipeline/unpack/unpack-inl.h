// The layouts a vector of pixels at a time, on the SIMD target this is included for.
//
// Texels of components that fit 16-bit lanes are made of two such lanes, which are interleaved when
// they are stored:
//
//   lane    R | G<<8          B | A<<8
//   texel   R   G   B   A
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_UNPACK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_UNPACK_INL_H
#undef CLEARPIPE_UNPACK_INL_H
#else
#define CLEARPIPE_UNPACK_INL_H
#endif

#include <hwy/highway.h>

#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::unpack::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D8 = hn::ScalableTag<uint8_t>;
using D16 = hn::ScalableTag<uint16_t>;
using D32 = hn::ScalableTag<uint32_t>;
using V16 = hn::Vec<D16>;

constexpr D8 d8;
constexpr D16 d16;
constexpr D32 d32;

HWY_INLINE V16 bits(uint16_t value) { return hn::Set(d16, value); }

// 255 v / 31 and 255 v / 63, rounded to nearest, of a component that stands in the middle of a
// lane: the upper half of a product, with a bias below the component. That they are exact is found
// by trying all values (unpack_test.cpp).
HWY_INLINE V16 scaled(V16 s, uint16_t mask, uint16_t bias, uint16_t factor) {
  return hn::MulHigh(hn::Or(hn::And(s, bits(mask)), bits(bias)), bits(factor));
}
HWY_INLINE V16 scale_5_at_10(V16 s) { return scaled(s, 0x7c00, 46, 527); }
HWY_INLINE V16 scale_5_at_6(V16 s) { return scaled(s, 0x07c0, 4, 8422); }
HWY_INLINE V16 scale_6_at_5(V16 s) { return scaled(s, 0x07e0, 4, 8289); }

// Interleaving works within blocks of 128 bits. So that texels come out in order, the blocks' lower
// halves get the first half of the pixels, and the upper halves the second (of 256 bits, by
// quarters of a vector: 0 1 2 3 becomes 0 2 1 3).
#if HWY_TARGET == HWY_SCALAR
HWY_INLINE V16 halves_to_blocks(V16 v) { return v; }
HWY_INLINE void store_halves(V16 rg, V16 ba, uint32_t* to) {
  hn::StoreInterleaved2(rg, ba, d16, reinterpret_cast<uint16_t*>(to));
}
#else
HWY_INLINE V16 halves_to_blocks(V16 v) {
  const size_t lanes = hn::Lanes(d32);
  if (lanes <= 4) return v;
  HWY_ALIGN int32_t from[hn::MaxLanes(d32)];
  for (size_t i = 0; i < lanes; ++i) {
    from[i] = static_cast<int32_t>(i / 4 * 2 + i % 2 + (i % 4 / 2) * (lanes / 2));
  }
  return hn::BitCast(d16,
                     hn::TableLookupLanes(hn::BitCast(d32, v), hn::SetTableIndices(d32, from)));
}
HWY_INLINE void store_halves(V16 rg, V16 ba, uint32_t* to) {
  hn::StoreU(hn::BitCast(d32, hn::InterleaveLower(d16, rg, ba)), d32, to);
  hn::StoreU(hn::BitCast(d32, hn::InterleaveUpper(d16, rg, ba)), d32, to + hn::Lanes(d32));
}
#endif

HWY_INLINE V16 load_16(const uint8_t* from) {
  return halves_to_blocks(hn::LoadU(d16, reinterpret_cast<const uint16_t*>(from)));
}
HWY_INLINE V16 load_8(const uint8_t* from) {
  return halves_to_blocks(hn::PromoteTo(d16, hn::LoadU(hn::Rebind<uint8_t, D16>(), from)));
}

// Each layout unpacks lanes() pixels of kBytes bytes.
struct Rgb565 {
  static constexpr size_t kBytes = 2;
  static size_t lanes() { return hn::Lanes(d16); }
  static HWY_INLINE void run(const uint8_t* from, uint32_t* to) {
    const V16 s = load_16(from);
    const V16 r = scale_5_at_10(hn::ShiftRight<1>(s));
    const V16 g = scale_6_at_5(s);
    const V16 b = scale_5_at_10(hn::ShiftLeft<10>(s));
    store_halves(hn::Or(r, hn::ShiftLeft<8>(g)), hn::Or(b, bits(0xff00)), to);
  }
};

struct Rgba5551 {
  static constexpr size_t kBytes = 2;
  static size_t lanes() { return hn::Lanes(d16); }
  static HWY_INLINE void run(const uint8_t* from, uint32_t* to) {
    const V16 s = load_16(from);
    const V16 r = scale_5_at_10(hn::ShiftRight<1>(s));
    const V16 g = scale_5_at_6(s);
    const V16 b = scale_5_at_10(hn::ShiftLeft<9>(s));
    const V16 a = hn::Mul(hn::And(s, bits(1)), bits(0xff00));
    store_halves(hn::Or(r, hn::ShiftLeft<8>(g)), hn::Or(b, a), to);
  }
};

// 255 v / 15 = 17 v: the four bits, and the same again.
struct Rgba4444 {
  static constexpr size_t kBytes = 2;
  static size_t lanes() { return hn::Lanes(d16); }
  static HWY_INLINE void run(const uint8_t* from, uint32_t* to) {
    const V16 s = load_16(from);
    const V16 rg = hn::Or(hn::ShiftRight<12>(s), hn::And(s, bits(0x0f00)));
    const V16 ba =
        hn::Or(hn::And(hn::ShiftRight<4>(s), bits(15)), hn::ShiftLeft<8>(hn::And(s, bits(15))));
    store_halves(hn::Or(rg, hn::ShiftLeft<4>(rg)), hn::Or(ba, hn::ShiftLeft<4>(ba)), to);
  }
};

struct LuminanceAlpha8 {
  static constexpr size_t kBytes = 2;
  static size_t lanes() { return hn::Lanes(d16); }
  static HWY_INLINE void run(const uint8_t* from, uint32_t* to) {
    const V16 la = load_16(from);
    store_halves(hn::Mul(hn::And(la, bits(255)), bits(0x0101)), la, to);
  }
};

struct Luminance8 {
  static constexpr size_t kBytes = 1;
  static size_t lanes() { return hn::Lanes(d16); }
  static HWY_INLINE void run(const uint8_t* from, uint32_t* to) {
    const V16 l = load_8(from);
    store_halves(hn::Mul(l, bits(0x0101)), hn::Or(l, bits(0xff00)), to);
  }
};

struct Alpha8 {
  static constexpr size_t kBytes = 1;
  static size_t lanes() { return hn::Lanes(d16); }
  static HWY_INLINE void run(const uint8_t* from, uint32_t* to) {
    const V16 a = load_8(from);
    store_halves(hn::Zero(d16), hn::ShiftLeft<8>(a), to);
  }
};

struct Bgra8 {
  static constexpr size_t kBytes = 4;
  static size_t lanes() { return hn::Lanes(d32); }
  static HWY_INLINE void run(const uint8_t* from, uint32_t* to) {
    const auto p = hn::LoadU(d32, reinterpret_cast<const uint32_t*>(from));
    const auto low = hn::Set(d32, 255);
    const auto r = hn::And(hn::ShiftRight<16>(p), low);
    const auto b = hn::ShiftLeft<16>(hn::And(p, low));
    hn::StoreU(hn::Or(hn::And(p, hn::Set(d32, 0xff00ff00u)), hn::Or(r, b)), d32, to);
  }
};

struct Rgb8 {
  static constexpr size_t kBytes = 3;
  static size_t lanes() { return hn::Lanes(d8); }
  static HWY_INLINE void run(const uint8_t* from, uint32_t* to) {
    hn::Vec<D8> r, g, b;
    hn::LoadInterleaved3(d8, from, r, g, b);
    hn::StoreInterleaved4(r, g, b, hn::Set(d8, 255), d8, reinterpret_cast<uint8_t*>(to));
  }
};

// The last pixels go with some before them once more, or, where there are too few, through memory
// that has room for a vector.
template <typename Layout>
HWY_INLINE void unpack_all(const uint8_t* from, size_t count, uint32_t* to) {
  const size_t lanes = Layout::lanes();
  if (count >= lanes) {
    for (size_t i = 0; i < count - lanes; i += lanes)
      Layout::run(from + i * Layout::kBytes, to + i);
    const size_t last = count - lanes;
    return Layout::run(from + last * Layout::kBytes, to + last);
  }
  constexpr size_t kMost = HWY_MAX_BYTES;
  uint8_t pixels[kMost * Layout::kBytes] = {};
  uint32_t texels[kMost];
  std::memcpy(pixels, from, count * Layout::kBytes);
  Layout::run(pixels, texels);
  std::memcpy(to, texels, count * sizeof(uint32_t));
}

}  // namespace clearpipe::pipeline::unpack::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
