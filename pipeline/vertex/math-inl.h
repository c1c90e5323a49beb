// Arithmetic the vertex stages share: clamps, and log2, exp2 and pow with the same bits on every
// processor.
//
// The three functions take and give single precision. Inside they use plain double-precision
// additions, multiplications and one division, in a fixed order and without tables, so that y *
// log2(x) keeps enough bits for exponents up to 128: the relative error of pow is below 2^-20 as
// long as the result is a normal number.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_VERTEX_MATH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_VERTEX_MATH_INL_H_
#undef CLEARPIPE_VERTEX_MATH_INL_H_
#else
#define CLEARPIPE_VERTEX_MATH_INL_H_
#endif

#include <hwy/highway.h>

#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::vertex::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// max(x, low) that gives `low` for NaN.
template <class V>
HWY_INLINE V at_least(V x, V low) {
  return hn::IfThenElse(hn::Gt(x, low), x, low);
}

// min(x, high) that gives `high` for NaN.
template <class V>
HWY_INLINE V at_most(V x, V high) {
  return hn::IfThenElse(hn::Lt(x, high), x, high);
}

// Clamps to [0,1]; NaN becomes 0.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V clamp_to_unit(D d, V x) {
  return at_most(at_least(x, hn::Zero(d)), hn::Set(d, 1.0f));
}

// c[0] + c[1] x + c[2] x^2 + ..., by Horner's rule.
template <class D, size_t kTerms, class V = hn::Vec<D>>
HWY_INLINE V polynomial(D d, V x, const double (&c)[kTerms]) {
  V sum = hn::Set(d, c[kTerms - 1]);
  for (size_t i = kTerms - 1; i-- > 0;) {
    sum = hn::Add(hn::Mul(sum, x), hn::Set(d, c[i]));
  }
  return sum;
}

// log2 of positive normal floats. x = 2^e m with m in [1/sqrt 2, sqrt 2); with s = (m-1)/(m+1),
// ln m = 2 (s + s^3/3 + s^5/5 + ...), and |s| < 0.172 makes the first dropped term, s^13, less than
// 2^-35.
template <class DW, class DF, class VF = hn::Vec<DF>>
HWY_INLINE hn::Vec<DW> log2_wide(DW wide, DF d, VF x) {
  const hn::RebindToSigned<DF> di;
  // Subtracting the bits of sqrt(1/2) makes the exponent field count from there.
  const auto origin = hn::Set(di, 0x3f3504f3);
  const auto bits = hn::BitCast(di, x);
  const auto exponent = hn::ShiftRight<23>(hn::Sub(bits, origin));
  const auto mantissa = hn::BitCast(d, hn::Sub(bits, hn::ShiftLeft<23>(exponent)));
  const auto m = hn::PromoteTo(wide, mantissa);
  const auto e = hn::PromoteTo(wide, hn::ConvertTo(d, exponent));
  const auto one = hn::Set(wide, 1.0);
  const auto s = hn::Div(hn::Sub(m, one), hn::Add(m, one));
  constexpr double kTwoByLn2 = 2.8853900817779268147;
  constexpr double kSeries[] = {kTwoByLn2,     kTwoByLn2 / 3, kTwoByLn2 / 5,
                                kTwoByLn2 / 7, kTwoByLn2 / 9, kTwoByLn2 / 11};
  return hn::Add(e, hn::Mul(s, polynomial(wide, hn::Mul(s, s), kSeries)));
}

// 2^t: 0 below the smallest normal number, infinity beyond the largest. t = k + f with |f| <= 1/2
// and 2^f by its Taylor series; the first dropped term is less than 2^-32.
template <class DW, class DF, class VW = hn::Vec<DW>>
HWY_INLINE hn::Vec<DF> exp2_wide(DW wide, DF d, VW t) {
  const hn::RebindToSigned<DF> di;
  const auto inside = hn::IfThenElse(hn::Gt(t, hn::Set(wide, -160.0)), t, hn::Set(wide, -160.0));
  const auto bounded =
      hn::IfThenElse(hn::Lt(inside, hn::Set(wide, 160.0)), inside, hn::Set(wide, 160.0));
  const auto k = hn::Round(bounded);
  const auto f = hn::Sub(bounded, k);
  constexpr double kSeries[] = {1.0,
                                0.69314718055994530942,
                                0.24022650695910071233,
                                0.055504108664821579953,
                                0.0096181291076284771619,
                                0.0013333558146428443423,
                                0.00015403530393381609954,
                                0.000015252733804059840280};
  const auto fraction = hn::DemoteTo(d, polynomial(wide, f, kSeries));
  const auto exponent = hn::ConvertTo(di, hn::DemoteTo(d, k));
  const auto bits = hn::BitCast(di, fraction);
  const auto result = hn::BitCast(d, hn::Add(bits, hn::ShiftLeft<23>(exponent)));
  // The exponent field after the shift: 1..254 is a number, all else left the range.
  const auto field = hn::Add(hn::ShiftRight<23>(bits), exponent);
  const auto normal = hn::IfThenElseZero(
      hn::MaskFromVec(hn::BitCast(d, hn::VecFromMask(di, hn::Gt(field, hn::Zero(di))))), result);
  const auto overflow =
      hn::MaskFromVec(hn::BitCast(d, hn::VecFromMask(di, hn::Gt(field, hn::Set(di, 254)))));
  return hn::IfThenElse(overflow, hn::Set(d, std::numeric_limits<float>::infinity()), normal);
}

// x^y for x >= 0 on half a vector. x below the smallest normal number (NaN and negative numbers
// included) counts as 0; 0^0 is 1, as the lighting equation needs.
template <class DW, class DF, class VF = hn::Vec<DF>>
HWY_INLINE VF pow_half(DW wide, DF d, VF x, VF y) {
  const auto smallest = hn::Set(d, std::numeric_limits<float>::min());
  const auto positive = hn::Ge(x, smallest);
  const auto base = hn::IfThenElse(positive, x, hn::Set(d, 1.0f));
  const auto exponent = hn::Mul(log2_wide(wide, d, base), hn::PromoteTo(wide, y));
  const auto power = hn::IfThenElseZero(positive, exp2_wide(wide, d, exponent));
  return hn::IfThenElse(hn::Eq(y, hn::Zero(d)), hn::Set(d, 1.0f), power);
}

// Applies `function(wide, d, x, y)` to both halves of x and y.
template <class D, class F, class V = hn::Vec<D>>
HWY_INLINE V in_double(D d, F function, V x, V y) {
#if HWY_TARGET == HWY_SCALAR
  return function(hn::Rebind<double, D>(), d, x, y);
#else
  const hn::Half<D> half;
  const hn::Rebind<double, decltype(half)> wide;
  const auto low = function(wide, half, hn::LowerHalf(half, x), hn::LowerHalf(half, y));
  const auto high = function(wide, half, hn::UpperHalf(half, x), hn::UpperHalf(half, y));
  return hn::Combine(d, high, low);
#endif
}

// x^y, see pow_half.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V power(D d, V x, V y) {
  return in_double(
      d, [](auto wide, auto half, auto a, auto b) HWY_ATTR { return pow_half(wide, half, a, b); },
      x, y);
}

// log2(x) of positive normal numbers.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V log2(D d, V x) {
  return in_double(
      d,
      [](auto wide, auto half, auto a, auto)
          HWY_ATTR { return hn::DemoteTo(half, log2_wide(wide, half, a)); },
      x, x);
}

// 2^x.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V exp2(D d, V x) {
  return in_double(
      d,
      [](auto wide, auto half, auto a, auto)
          HWY_ATTR { return exp2_wide(wide, half, hn::PromoteTo(wide, a)); },
      x, x);
}

}  // namespace clearpipe::pipeline::vertex::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CLEARPIPE_VERTEX_MATH_INL_H_
