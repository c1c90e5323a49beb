// A texture unit of the fused loop: its coordinates along a row, its sampler, its environment.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_FUSED_UNIT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_FUSED_UNIT_INL_H_
#undef CLEARPIPE_FRAGMENT_FUSED_UNIT_INL_H_
#else
#define CLEARPIPE_FRAGMENT_FUSED_UNIT_INL_H_
#endif

#include <hwy/highway.h>

#include <cstring>
#include <type_traits>

#include "pipeline/fragment/fused.h"
#include "pipeline/fragment/group-inl.h"
#include "pipeline/fragment/interpolate-inl.h"
#include "pipeline/fragment/sample-inl.h"
#include "pipeline/fragment/texcoord-inl.h"
#include "pipeline/fragment/texenv-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

// A plane on one row: what is left of `evaluate` when y is known.
struct RowPlane {
  VecF start, dx;

  RowPlane() = default;
  HWY_INLINE RowPlane(const Plane& plane, VecF y) {
    const TagF d;
    start = hn::Add(hn::Set(d, plane.value), hn::Mul(hn::Set(d, plane.dy), y));
    dx = hn::Set(d, plane.dx);
  }
  HWY_INLINE VecF at(VecF x) const { return hn::Add(start, hn::Mul(dx, x)); }
  HWY_INLINE Pair<VecF> at(const Pair<VecF>& x) const { return {at(x.lower), at(x.upper)}; }
};

HWY_INLINE Pair<VecF> multiply(const Pair<VecF>& a, const Pair<VecF>& b) {
  return {hn::Mul(a.lower, b.lower), hn::Mul(a.upper, b.upper)};
}
HWY_INLINE Pair<VecF> reciprocal(const Pair<VecF>& v) {
  const VecF one = hn::Set(TagF(), 1.0f);
  return {hn::Div(one, v.lower), hn::Div(one, v.upper)};
}

constexpr sampling::HWY_NAMESPACE::WrapKind fused_wrap(FusedSampler sampler) {
  return sampler == FusedSampler::kNearestRepeat || sampler == FusedSampler::kLinearRepeat
             ? sampling::HWY_NAMESPACE::WrapKind::kRepeatPowerOfTwo
             : sampling::HWY_NAMESPACE::WrapKind::kClampToEdge;
}

constexpr bool fused_linear(FusedSampler sampler) {
  return sampler == FusedSampler::kLinearRepeat || sampler == FusedSampler::kLinearClamp;
}

// One texture unit: its coordinates on the row at hand, and its environment.
template <FusedSampler kSampler>
class FusedUnit {
 public:
  FusedUnit(const FragmentProgram& program, const PrimitivePlanes& planes, const Tile& tile,
            int unit)
      : unit_(program.unit[unit]), planes_(planes), tile_(tile), index_(unit) {
    const Plane& q = planes.texture[unit][3];
    const Plane& w = planes.inv_w;
    q_is_one_ = q.value == 1 && q.dx == 0 && q.dy == 0;
    q_is_inv_w_ = planes.perspective && std::memcmp(&q, &w, sizeof(Plane)) == 0;
  }

  HWY_INLINE void set_row(int row, VecF y) {
    row_ = row;
    const Plane* planes = planes_.texture[index_];
    s_ = RowPlane(planes[0], y);
    t_ = RowPlane(planes[1], y);
    q_ = RowPlane(planes[3], y);
  }

  // The texture's colour of a group; `column` is its first pixel in the tile.
  HWY_INLINE Colour16 sample(int column, const Pair<VecF>& x, const Pair<VecF>& w) {
    Pair<VecF> s = s_.at(x), t = t_.at(x);
    if (!q_is_one_) {  // a division by one changes nothing
      const Pair<VecF> reciprocal_q = q_is_inv_w_ ? w : reciprocal(q_.at(x));
      s = multiply(s, reciprocal_q);
      t = multiply(t, reciprocal_q);
    }
    if constexpr (kSampler == FusedSampler::kAny) {
      return sample_any(column, s, t);
    } else {
      using Axes = sampling::HWY_NAMESPACE::FixedAxes<fused_wrap(kSampler), fused_wrap(kSampler)>;
      const Axes axes(unit_.sample);
      const SampleLevel& level = unit_.sample.levels[unit_.sample.first_level];
      return narrow_sample(sample_half(axes, level, s.lower, t.lower),
                           sample_half(axes, level, s.upper, t.upper));
    }
  }

  // 3.7.12 for MODULATE and REPLACE, which select_fused has made sure of.
  HWY_INLINE void apply_environment(const Colour16& texture, Colour16& colour) const {
    for (int c = 0; c < 4; ++c) {
      switch (c < 3 ? unit_.combiner.rgb : unit_.combiner.alpha) {
        case Combine::kModulate:
          colour.channel[c] = multiply_16(texture.channel[c], colour.channel[c]);
          break;
        default:
          if (c < 3 || unit_.combiner.alpha_argument[0].source != CombineSource::kPrevious) {
            colour.channel[c] = texture.channel[c];
          }
          break;
      }
    }
  }

 private:
  static HWY_INLINE Vec16 multiply_16(Vec16 a, Vec16 b) {
    return combine<Combine::kModulate>(Tag16(), a, b, b);
  }

  template <class Axes>
  HWY_INLINE sampling::HWY_NAMESPACE::Colours sample_half(const Axes& axes,
                                                          const SampleLevel& level, VecF s,
                                                          VecF t) const {
    if constexpr (fused_linear(kSampler)) {
      return widen(sampling::HWY_NAMESPACE::sample_linear<Axes, false>(axes, level, s, t));
    } else {
      return widen(sampling::HWY_NAMESPACE::sample_nearest<Axes, false>(axes, level, s, t));
    }
  }

  // Through the program's sample function, on a batch of one group.
  HWY_NOINLINE Colour16 sample_any(int column, const Pair<VecF>& s, const Pair<VecF>& t) {
    const TagF d;
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(TagF()));
    batch_.count = 2 * kLanes;
    hn::Store(s.lower, d, batch_.s);
    hn::Store(s.upper, d, batch_.s + kLanes);
    hn::Store(t.lower, d, batch_.t);
    hn::Store(t.upper, d, batch_.t + kLanes);
    if (unit_.sample.needs_lod) {
      for (int i = 0; i < batch_.count; ++i) {
        batch_.offset[i] = static_cast<uint16_t>(row_ * kTileWidth + column + i);
      }
      level_of_detail(planes_, planes_.texture[index_], unit_.sample, tile_, batch_);
    }
    unit_.sample_function(unit_.sample, batch_, index_);
    const TagI di;
    const hn::Rebind<int16_t, TagI> half;
    Colour16 result;
    for (int c = 0; c < 4; ++c) {
      const int16_t* values = batch_.texture[index_][c];
      result.channel[c] = narrow({hn::PromoteTo(di, hn::Load(half, values)),
                                  hn::PromoteTo(di, hn::Load(half, values + kLanes))});
    }
    return result;
  }

  const UnitProgram& unit_;
  const PrimitivePlanes& planes_;
  const Tile& tile_;
  const int index_;
  bool q_is_one_, q_is_inv_w_;
  int row_ = 0;
  RowPlane s_, t_, q_;
  std::conditional_t<kSampler == FusedSampler::kAny, FragmentBatch, char> batch_;
};

#endif  // HWY_TARGET != HWY_SCALAR

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
