// The stencil and depth tests (4.1.4, 4.1.5) on packed values: depth << 8 | stencil.
//
// Depth is compared as the integer of 16 or 24 bits that the buffer holds, so signed comparison
// serves. A depth of 32 bits is the whole packed value; it is compared with its highest bit
// inverted, which makes signed numbers of the same order.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_DEPTH_STENCIL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_DEPTH_STENCIL_INL_H_
#undef CLEARPIPE_FRAGMENT_DEPTH_STENCIL_INL_H_
#else
#define CLEARPIPE_FRAGMENT_DEPTH_STENCIL_INL_H_
#endif

#include <hwy/highway.h>

#include <bit>
#include <cstring>

#include "pipeline/fragment/batch.h"
#include "pipeline/fragment/chain.h"
#include "pipeline/fragment/compare-inl.h"
#include "pipeline/fragment/interpolate-inl.h"
#include "pipeline/nearest_int-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct DepthState {
  bool test = false, write = false;
  CompareFunc func = CompareFunc::kAlways;
  float most = 16777215.0f;              // the value of depth 1
  bool whole = false;                    // 32 bits
  static constexpr bool inside = false;  // window depth may be outside [0, 1]
};

inline DepthState depth_state(const FragmentProgram& program) {
  return {program.depth_test, program.depth_write, program.depth_func,
          program.depth_bits == 16 ? 65535.0f : 16777215.0f, program.depth_bits == 32};
}

// Where 32 bits are known not to come, so that nothing asks.
struct NarrowDepthState : DepthState {
  explicit NarrowDepthState(const DepthState& state) : DepthState(state) {}
  static constexpr bool whole = false;
};

// What is known to the compiler of the states that programs mostly have.
template <CompareFunc kFunc, bool kInside>
struct KnownDepthState {
  static constexpr bool test = true, whole = false, inside = kInside;
  static constexpr CompareFunc func = kFunc;
  bool write;
  float most;
};
struct NoStencilState : StencilState {
  static constexpr bool enabled = false;
};

// The same as 32 bits, with the highest inverted. A depth has 24 significant bits, so those below
// 1/2 are exact or rounded as products, and what lies above 1/2 is exact.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> to_whole_depth_value(D d, V z) {
  const hn::RebindToSigned<D> di;
  const V half = hn::Set(d, 0.5f), scale = hn::Set(d, 4294967296.0f);
  const auto upper = hn::Ge(z, half);
  const V above = hn::IfThenElse(upper, hn::Sub(z, half), z);
  const V most = hn::Set(d, 2147483520.0f);  // the last number before the sign is reached
  const auto value = hn::NearestInt(hn::Min(hn::Mul(above, scale), most));
  const auto biased =
      hn::IfThenElse(hn::RebindMask(di, upper), value, hn::Add(value, hn::Set(di, INT32_MIN)));
  return hn::IfThenElse(hn::RebindMask(di, hn::Ge(z, hn::Set(d, 1.0f))), hn::Set(di, INT32_MAX),
                        biased);
}

// Window depth clamped to [0, 1], as the nearest value of the buffer (2.10.1). NaN becomes 0, as
// Max takes its second parameter then.
template <class D, class State, class V = hn::Vec<D>>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> to_depth_value(D d, const State& depth, V z) {
  if (!depth.inside) z = hn::Min(hn::Max(z, hn::Zero(d)), hn::Set(d, 1.0f));
  if (depth.whole) return to_whole_depth_value(d, z);
  return pipeline::HWY_NAMESPACE::nearest_int(d, hn::Mul(z, hn::Set(d, depth.most)));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> depth_value(D d, const DepthState& depth,
                                                      const Plane& plane, V x, V y) {
  return to_depth_value(d, depth, evaluate(d, plane, x, y));
}

// Table 4.2: what an operation makes of the stored stencil value. All are the same few steps with
// other constants, so that no vector asks which it is:
// clamp(((stored & keep) ^ flip) + add, least, most) & 255.
struct StencilSteps {
  int32_t keep, flip, add, least, most;
};

inline StencilSteps stencil_steps(StencilOp op, uint8_t reference) {
  constexpr int32_t kLeast = INT32_MIN, kMost = INT32_MAX;  // wrap: limited by the last step alone
  switch (op) {
    case StencilOp::kKeep:
      break;
    case StencilOp::kZero:
      return {0, 0, 0, kLeast, kMost};
    case StencilOp::kReplace:
      return {0, reference, 0, kLeast, kMost};
    case StencilOp::kIncrement:
      return {255, 0, 1, kLeast, 255};
    case StencilOp::kDecrement:
      return {255, 0, -1, 0, kMost};
    case StencilOp::kInvert:
      return {255, 255, 0, kLeast, kMost};
    case StencilOp::kIncrementWrap:
      return {255, 0, 1, kLeast, kMost};
    case StencilOp::kDecrementWrap:
      return {255, 0, -1, kLeast, kMost};
  }
  return {255, 0, 0, kLeast, kMost};
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE V stencil_operation(D d, StencilOp op, V stored, uint8_t reference) {
  const StencilSteps steps = stencil_steps(op, reference);
  const V flipped = hn::Xor(hn::And(stored, hn::Set(d, steps.keep)), hn::Set(d, steps.flip));
  const V sum = hn::Add(flipped, hn::Set(d, steps.add));
  const V clamped = hn::Min(hn::Max(sum, hn::Set(d, steps.least)), hn::Set(d, steps.most));
  return hn::And(clamped, hn::Set(d, 255));
}

// Both tests for one vector. `live` selects the fragments that take part; returns those that pass
// both, and the new packed values.
template <class D, class Stencil, class State, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> depth_stencil_test(D d, const Stencil& stencil, const State& depth,
                                          hn::Mask<D> live, V fragment_depth, V& packed) {
  const hn::RebindToUnsigned<D> du;
  const V highest = hn::Set(d, INT32_MIN);
  const V stored_depth = depth.whole ? hn::Xor(packed, highest)
                                     : hn::BitCast(d, hn::ShiftRight<8>(hn::BitCast(du, packed)));
  const V stored_stencil = hn::And(packed, hn::Set(d, 255));
  auto passes = live;
  V new_depth = stored_depth, new_stencil = stored_stencil;
  // What a state leaves alone is not worked out: the branches are the same for a whole draw.
  const bool stencil_fails = stencil.enabled && stencil.func != CompareFunc::kAlways;
  if (stencil_fails) {
    const V mask = hn::Set(d, stencil.value_mask);
    const V reference = hn::Set(d, stencil.reference & stencil.value_mask);
    passes = hn::And(passes, compare(d, stencil.func, reference, hn::And(stored_stencil, mask)));
    if (stencil.fail != StencilOp::kKeep) {
      const V failed = stencil_operation(d, stencil.fail, stored_stencil, stencil.reference);
      new_stencil = hn::IfThenElse(hn::AndNot(passes, live), failed, new_stencil);
    }
  }
  const auto stencil_passes = passes;
  if (depth.test) {
    passes = hn::And(passes, compare(d, depth.func, fragment_depth, stored_depth));
    if (depth.write) {
      new_depth = hn::IfThenElse(passes, fragment_depth, new_depth);
    }
  }
  if (stencil.enabled) {
    if (depth.test && stencil.depth_fail != StencilOp::kKeep) {
      const V failed = stencil_operation(d, stencil.depth_fail, stored_stencil, stencil.reference);
      new_stencil = hn::IfThenElse(hn::AndNot(passes, stencil_passes), failed, new_stencil);
    }
    if (stencil.pass != StencilOp::kKeep) {
      const V passed = stencil_operation(d, stencil.pass, stored_stencil, stencil.reference);
      new_stencil = hn::IfThenElse(passes, passed, new_stencil);
    }
    if (stencil.write_mask != 0xff) {
      const V writable = hn::Set(d, stencil.write_mask);
      new_stencil = hn::Or(hn::And(new_stencil, writable), hn::AndNot(writable, stored_stencil));
    }
  }
  packed =
      depth.whole ? hn::Xor(new_depth, highest) : hn::Or(hn::ShiftLeft<8>(new_depth), new_stencil);
  return passes;
}

// The tests over a batch on the values in stored_depth_stencil; what fails dies.
inline void depth_stencil_stage(const Plane& plane, const StencilState& stencil,
                                const DepthState& depth, FragmentBatch& batch, int16_t* lives) {
  const hn::ScalableTag<float> df;
  const hn::RebindToSigned<decltype(df)> d;
  const hn::Rebind<int16_t, decltype(d)> d16;
  auto* stored = reinterpret_cast<int32_t*>(batch.stored_depth_stencil);
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    const auto live = hn::Ne(hn::PromoteTo(d, hn::Load(d16, lives + i)), hn::Zero(d));
    auto value = hn::Zero(d);
    if (depth.test) {
      value = depth_value(df, depth, plane, hn::Load(df, batch.x + i), hn::Load(df, batch.y + i));
    }
    auto packed = hn::Load(d, stored + i);
    const auto passes = depth_stencil_test(d, stencil, depth, live, value, packed);
    hn::Store(packed, d, stored + i);
    hn::Store(hn::DemoteTo(d16, hn::VecFromMask(d, passes)), d16, lives + i);
  }
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
