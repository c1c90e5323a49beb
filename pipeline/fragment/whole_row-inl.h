// Bilinear samples of a whole row of a tile at once, of a texture that repeats powers of two, where
// the pixels of each vector find their texels close together: in a few rows of texels that follow
// each other, each no longer than a vector or two. All vectors go through each step side by side,
// and what is to be known of them is asked once; row by row, and vector by vector, see
// sample_row-inl.h. SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_WHOLE_ROW_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_WHOLE_ROW_INL_H_
#undef CLEARPIPE_FRAGMENT_WHOLE_ROW_INL_H_
#else
#define CLEARPIPE_FRAGMENT_WHOLE_ROW_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "pipeline/fragment/row_sampler-inl.h"
#include "pipeline/fragment/sample_colours-inl.h"
#include "pipeline/fragment/split_plane-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET <= HWY_AVX3

class WholeRow {
 public:
  static constexpr Halves kHalves = (Halves{1} << 2 * kRowGroups) - 1;

  // Samples a row for coordinates without a q. Returns the halves whose texels are not so close:
  // they are left as anything.
  using Sampler = Halves (*)(const SampleLevel& level, const SplitRow& s, const SplitRow& t,
                             RowPixels& out);

  // One for the level and planes; null: texels are too far apart.
  static Sampler sampler(FusedSampler fused, const SampleLevel& level, const Plane& s,
                         const Plane& t) {
    if (fused != FusedSampler::kLinearRepeatPowerOfTwoRepeatPowerOfTwo) return nullptr;
    // From the first pixel of a vector to its last.
    const float columns = std::fabs(s.dx) * static_cast<float>(level.width * (kLanes - 1));
    const float rows = std::fabs(t.dx) * static_cast<float>(level.height * (kLanes - 1));
    const int wide = columns < kLanes - 2 ? 1 : 2;
    if (!(columns < 2 * kLanes - 2) || level.width < wide * kLanes) return nullptr;
    // First texels in two rows, or three, mostly.
    const int tall = rows < 1.1f ? 2 : 3;
    if (!(rows < 2.1f) || level.height <= tall) return nullptr;
    if (tall == 2) return wide == 1 ? sample<1, 2> : sample<2, 2>;
    return wide == 1 ? sample<1, 3> : sample<2, 3>;
  }

 private:
  static constexpr int kLanes = static_cast<int>(hn::MaxLanes(TagI()));
  static constexpr int kVectors = kTileWidth / kLanes;

  // Texels that pixels find, and those that follow them.
  struct Pairs {
    VecI texel[2];
  };

  // With windows of kWide vectors, for first texels in kTall rows.
  template <int kWide, int kTall>
  static HWY_NOINLINE Halves sample(const SampleLevel& level, const SplitRow& s, const SplitRow& t,
                                    RowPixels& out) {
    const float scale_s = static_cast<float>(level.width) * 256;
    const float scale_t = static_cast<float>(level.height) * 256;
    using namespace sampling::HWY_NAMESPACE;
    const TagI d;
    const int width = level.width, height = level.height;
    constexpr int kColumns = kWide * kLanes;
    // Along a row coordinates go one way: the least of a vector are in its first lane or its last.
    const int least_s = s[0] <= s[kLanes - 1] ? 0 : kLanes - 1;
    const int least_t = t[0] <= t[kLanes - 1] ? 0 : kLanes - 1;
    int x0[kVectors], y0[kVectors];
    // The first texel of each vector's window; the row begins anew after so many.
    const uint32_t* from[kVectors];
    int until_edge[kVectors], nearest_edge = kColumns;
    uint32_t far = 0;
    for (int v = 0; v < kVectors; ++v) {
      x0[v] = fixed(s[v * kLanes + least_s], scale_s);
      y0[v] = fixed(t[v * kLanes + least_t], scale_t);
      far |= (static_cast<uint32_t>(x0[v]) - kNear) | (static_cast<uint32_t>(y0[v]) - kNear);
      const int column = x0[v] >> 8 & (width - 1), row = y0[v] >> 8 & (height - 1);
      // The window ends where the level does.
      const int first_row = std::min(row, height - 1 - kTall);
      y0[v] = (y0[v] & -256) - ((row - first_row) << 8);
      from[v] = level.texels + first_row * width + column;
      until_edge[v] = width - column;
      nearest_edge = std::min(nearest_edge, until_edge[v]);
    }
    if (far >= kReach) return kHalves;
    VecI x[kVectors], y[kVectors], in_x[kVectors], in_y[kVectors];
    Halves outside = 0;
    for (int v = 0; v < kVectors; ++v) {
      x[v] = fixed(s.at(v * kLanes), scale_s);
      y[v] = fixed(t.at(v * kLanes), scale_t);
      // From the window's first texel.
      in_x[v] = hn::Sub(x[v], hn::Set(d, x0[v] & -256));
      in_y[v] = hn::Sub(y[v], hn::Set(d, y0[v]));
      const auto beyond =
          hn::Or(is_above(in_x[v], 256 * (kColumns - 1) - 1), is_above(in_y[v], 256 * kTall - 1));
      if (!hn::AllFalse(d, beyond)) outside |= Halves{1} << v;
    }
    if (outside == kHalves) return kHalves;
    const auto interpolate = [&](const auto& load_at) HWY_ATTR {
      for (int v = 0; v < kVectors; ++v) {
        const auto load = [&](int r, int column) HWY_ATTR {
          return load_at(from[v] + r * width + column, until_edge[v] - column);
        };
        Pairs rows[2];
        take<kWide, kTall>(in_x[v], in_y[v], load, rows);
        const Weight a = spread<false>(x[v]), b = spread<false>(y[v]);
        const Colours below = lerp(a, unpack(rows[0].texel[0]), unpack(rows[0].texel[1]));
        const Colours above = lerp(a, unpack(rows[1].texel[0]), unpack(rows[1].texel[1]));
        hn::Store(hn::BitCast(TagU(), pack(lerp(b, below, above))), TagU(), out.pixel + v * kLanes);
      }
    };
    if (HWY_LIKELY(nearest_edge >= kColumns)) {
      interpolate([](const uint32_t* at, int) HWY_ATTR { return load(at); });
    } else {
      interpolate([width](const uint32_t* at, int edge)
                      HWY_ATTR { return load_around(at, edge, width); });
    }
    return outside;
  }

  // The texels of both rows that each pixel is between; load(row, column) is a vector of a window.
  template <int kWide, int kTall, class Load>
  static HWY_INLINE void take(VecI in_x, VecI in_y, const Load& load, Pairs (&rows)[2]) {
    const TagI d;
    const VecI one = hn::Set(d, 1);
    if constexpr (kWide == 1 && kTall == 2) {
      // Places in two rows.
      const VecI upper = hn::And(hn::ShiftLeft<4>(in_y), hn::Set(d, 256 * kLanes));
      const VecI first = hn::ShiftRight<8>(hn::Or(in_x, upper)), second = hn::Add(first, one);
      const VecI row[3] = {load(0, 0), load(1, 0), load(2, 0)};
      for (int r = 0; r < 2; ++r) {
        rows[r] = {{lookup(row[r], row[r + 1], first), lookup(row[r], row[r + 1], second)}};
      }
    } else {
      const VecI first = hn::ShiftRight<8>(in_x), second = hn::Add(first, one);
      Pairs row[kTall + 1];
      for (int r = 0; r <= kTall; ++r) {
        const VecI left = load(r, 0), right = kWide == 1 ? left : load(r, kLanes);
        row[r] = {{lookup(left, right, first), lookup(left, right, second)}};
      }
      const auto lowest = hn::Lt(in_y, hn::Set(d, 256)), low = hn::Lt(in_y, hn::Set(d, 512));
      for (int r = 0; r < 2; ++r) {
        for (int i = 0; i < 2; ++i) {
          VecI texel = row[r + 1].texel[i];
          if constexpr (kTall == 3) texel = hn::IfThenElse(low, texel, row[r + 2].texel[i]);
          rows[r].texel[i] = hn::IfThenElse(lowest, row[r].texel[i], texel);
        }
      }
    }
  }

  // A coordinate in 24.8 fixed point, less half a texel, by the rounding of an addition, as in
  // sample_row-inl.h: right in the lowest bits, and what lies above them does not matter, as long
  // as the coordinate is within kReach / 2 of 0.
  static constexpr float kRounding = 12582912.0f - 128.0f;
  static constexpr uint32_t kReach = 0x400000;
  static constexpr uint32_t kNear = 0x4b000000 + 0x400000 - kReach / 2;

  static HWY_INLINE VecI fixed(VecF v, float scale) {
    const TagF d;
    return hn::BitCast(TagI(), hn::Add(hn::Mul(v, hn::Set(d, scale)), hn::Set(d, kRounding)));
  }
  static HWY_INLINE int fixed(float v, float scale) {
    return std::bit_cast<int>(v * scale + kRounding);
  }
  // As unsigned numbers, which what is negative is above, too.
  static HWY_INLINE MaskI is_above(VecI v, int most) {
    const TagU d;
    return hn::RebindMask(TagI(),
                          hn::Gt(hn::BitCast(d, v), hn::Set(d, static_cast<uint32_t>(most))));
  }
  static HWY_INLINE VecI load(const uint32_t* from) {
    return hn::BitCast(TagI(), hn::LoadU(TagU(), from));
  }
  // The same where the row begins anew after so many texels, perhaps before the first.
  static HWY_INLINE VecI load_around(const uint32_t* from, int until_edge, int width) {
    const TagU d;
    const auto before = hn::FirstN(d, static_cast<size_t>(std::clamp(until_edge, 0, kLanes)));
    const VecU end = hn::MaskedLoad(before, d, from);
    const VecU start = hn::MaskedLoad(hn::Not(before), d, from - width);
    return hn::BitCast(TagI(), hn::Or(end, start));
  }
  // By an instruction that Highway 1.0.3 does not have: with two lookups and a choice units_four
  // took 4.20 ms instead of 3.90, texture_bilinear 0.76 instead of 0.71 (one thread, Zen 5).
  static HWY_INLINE VecI lookup(VecI lower, VecI upper, VecI index) {
    return VecI{_mm512_permutex2var_epi32(lower.raw, index.raw, upper.raw)};
  }
};

#endif  // HWY_TARGET <= HWY_AVX3

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
