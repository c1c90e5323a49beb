// Bilinear samples of a whole row of a tile at once, of a texture that repeats powers of two, where
// the pixels of each vector find their texels close together: in two rows of texels that follow
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

  // How many vectors a window takes for coordinates without a q; 0: texels are too far apart.
  static int window(FusedSampler sampler, const SampleLevel& level, const Plane& s,
                    const Plane& t) {
    if (sampler != FusedSampler::kLinearRepeatPowerOfTwoRepeatPowerOfTwo) return 0;
    // From the first pixel of a vector to its last.
    const float columns = std::fabs(s.dx) * static_cast<float>(level.width * (kLanes - 1));
    const float rows = std::fabs(t.dx) * static_cast<float>(level.height * (kLanes - 1));
    constexpr float kMostRows = 1.1f;  // mostly in two
    if (!(rows < kMostRows && columns < 2 * kLanes - 2)) return 0;
    return columns < kLanes - 2 ? 1 : 2;
  }

  // False, and nothing is sampled, if the texels are not all so close.
  static HWY_INLINE bool sample(int window, const SampleLevel& level, const SplitPlane& s_plane,
                                const SplitPlane& t_plane, int row, RowPixels& out) {
    const SplitRow s(s_plane, row), t(t_plane, row);
    return window == 1 ? sample<1>(level, s, t, out) : sample<2>(level, s, t, out);
  }

 private:
  // With windows of so many vectors.
  template <int kWide>
  static HWY_NOINLINE bool sample(const SampleLevel& level, const SplitRow& s, const SplitRow& t,
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
    const uint32_t* from[kVectors];
    uint32_t far = 0;
    int beyond = 0;
    for (int v = 0; v < kVectors; ++v) {
      x0[v] = fixed(s[v * kLanes + least_s], scale_s);
      y0[v] = fixed(t[v * kLanes + least_t], scale_t);
      const int column = x0[v] >> 8 & (width - 1), row = y0[v] >> 8 & (height - 1);
      far |= (static_cast<uint32_t>(x0[v]) - kNear) | (static_cast<uint32_t>(y0[v]) - kNear);
      // The window ends where the level does.
      const int first_column = std::min(column, width - kColumns);
      x0[v] = (x0[v] & -256) - ((column - first_column) << 8);
      beyond |= first_column | (height - 3 - row);
      from[v] = level.texels + row * width + first_column;
    }
    if (far >= kReach || beyond < 0) return false;
    VecI x[kVectors], y[kVectors], in_x[kVectors], in_y[kVectors];
    VecI outside = hn::Zero(d);
    for (int v = 0; v < kVectors; ++v) {
      x[v] = fixed(s.at(v * kLanes), scale_s);
      y[v] = fixed(t.at(v * kLanes), scale_t);
      // From the window's first texel.
      in_x[v] = hn::Sub(x[v], hn::Set(d, x0[v]));
      in_y[v] = hn::Sub(y[v], hn::Set(d, y0[v] & -256));
      const VecI next_x = hn::Add(in_x[v], hn::Set(d, 256));
      outside =
          hn::Or(outside, hn::AndNot(hn::Set(d, 256 * kColumns - 1), hn::Or(in_x[v], next_x)));
      outside = hn::Or(outside, hn::AndNot(hn::Set(d, 256 * 2 - 1), in_y[v]));
    }
    if (!hn::AllTrue(d, hn::Eq(outside, hn::Zero(d)))) return false;
    const VecI one = hn::Set(d, 1);
    for (int v = 0; v < kVectors; ++v) {
      VecI texels[2][2];  // rows: first texels and second ones
      if constexpr (kWide == 1) {
        // Places in two rows.
        const VecI upper = hn::And(hn::ShiftLeft<4>(in_y[v]), hn::Set(d, 256 * kLanes));
        const VecI first = hn::ShiftRight<8>(hn::Or(in_x[v], upper)), second = hn::Add(first, one);
        const VecI row0 = load(from[v]), row1 = load(from[v] + width);
        const VecI row2 = load(from[v] + 2 * width);
        texels[0][0] = lookup(row0, row1, first);
        texels[0][1] = lookup(row0, row1, second);
        texels[1][0] = lookup(row1, row2, first);
        texels[1][1] = lookup(row1, row2, second);
      } else {
        const VecI first = hn::ShiftRight<8>(in_x[v]), second = hn::Add(first, one);
        const auto lower = hn::Lt(in_y[v], hn::Set(d, 256));
        VecI row[3][2];
        for (int r = 0; r < 3; ++r) {
          const VecI left = load(from[v] + r * width), right = load(from[v] + r * width + kLanes);
          row[r][0] = lookup(left, right, first);
          row[r][1] = lookup(left, right, second);
        }
        for (int r = 0; r < 2; ++r) {
          for (int i = 0; i < 2; ++i) {
            texels[r][i] = hn::IfThenElse(lower, row[r][i], row[r + 1][i]);
          }
        }
      }
      const Weight a = spread<false>(x[v]), b = spread<false>(y[v]);
      const Colours below = lerp(a, unpack(texels[0][0]), unpack(texels[0][1]));
      const Colours above = lerp(a, unpack(texels[1][0]), unpack(texels[1][1]));
      hn::Store(hn::BitCast(TagU(), pack(lerp(b, below, above))), TagU(), out.pixel + v * kLanes);
    }
    return true;
  }

  static constexpr int kLanes = static_cast<int>(hn::MaxLanes(TagI()));
  static constexpr int kVectors = kTileWidth / kLanes;

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
  static HWY_INLINE VecI load(const uint32_t* from) {
    return hn::BitCast(TagI(), hn::LoadU(TagU(), from));
  }
  // By an instruction that Highway 1.0.3 does not have.
  static HWY_INLINE VecI lookup(VecI lower, VecI upper, VecI index) {
    return VecI{_mm512_permutex2var_epi32(lower.raw, index.raw, upper.raw)};
  }
};

#endif  // HWY_TARGET <= HWY_AVX3

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
