#pragma once

// FastInterval: intervals of two doubles with outward rounding, made for speed.
//
// Promise: inside a Scope (NumberTraits<FastInterval>::Scope, or UpwardRounding) every operation encloses the
// exact set of results; + - * / sqr sqrt and the elementary functions give the tightest enclosing interval of
// doubles. An interval is stored as (-lower, upper) in one SSE register, so that rounding upward rounds both
// ends outward and no operation changes the rounding mode (Lambov 2008, "Interval arithmetic using SSE-2").
// Each operation passes its operands and result through `opaque` (rounding.h), so that no compiler moves it
// out of its scope. An array of n FastIntervals is an array of 2n doubles (-lower, upper, -lower, upper,
// ...), which vector code may work on directly under upward rounding. The empty set is (-inf, -inf) and
// nothing else; NaN never occurs. An upper end -inf or lower end +inf belongs to the empty set alone; 0 * inf
// is 0, the product of their members.

#include <immintrin.h>
#include <limits>
#include <utility>

#include "interval/interval.h"
#include "interval/number_traits.h"
#include "interval/rational.h"
#include "interval/rounding.h"

namespace gcslab {

class FastInterval {
 public:
  /// The empty set.
  FastInterval() : ends_(_mm_set1_pd(-std::numeric_limits<double>::infinity())) {}
  /// The set of one finite number.
  explicit FastInterval(double point) : ends_(_mm_set_pd(point, -point)) {}
  FastInterval(double lower, double upper) : ends_(_mm_set_pd(upper, -lower)) {}
  explicit FastInterval(const Interval& x) : FastInterval(x.lower, x.upper) {}

  /// The register (-lower, upper), low element first.
  __m128d raw() const { return ends_; }
  static FastInterval from_raw(__m128d ends) {
    FastInterval result;
    result.ends_ = ends;
    return result;
  }

  double lower() const { return 0.0 - _mm_cvtsd_f64(ends_); }
  double upper() const { return 0.0 + _mm_cvtsd_f64(_mm_unpackhi_pd(ends_, ends_)); }
  Interval interval() const { return {lower(), upper()}; }
  bool is_empty() const { return _mm_cvtsd_f64(ends_) == -std::numeric_limits<double>::infinity(); }

 private:
  __m128d ends_;
};

static_assert(sizeof(FastInterval) == 2 * sizeof(double));

namespace fast_detail {

inline __m128d minus_infinity() { return _mm_set1_pd(-std::numeric_limits<double>::infinity()); }
inline __m128d swapped(__m128d x) { return _mm_shuffle_pd(x, x, 1); }
inline __m128d negated(__m128d x) { return _mm_xor_pd(x, _mm_set1_pd(-0.0)); }

/// A result whose NaN elements, which only empty operands cause, are made -inf: the empty set.
inline FastInterval settled(__m128d ends) {
  return FastInterval::from_raw(opaque(_mm_max_pd(ends, minus_infinity())));
}

/// The ends, or the empty set where an operand was empty: where the smaller of its ends is -inf.
inline FastInterval unless_empty(__m128d ends, __m128d smaller) {
  const __m128d empty = _mm_cmpeq_pd(smaller, minus_infinity());
  return FastInterval::from_raw(opaque(_mm_blendv_pd(ends, minus_infinity(), empty)));
}

/// (-mignitude, magnitude).
inline __m128d magnitudes(__m128d x) {
  const __m128d other = swapped(x);
  const __m128d magnitude = _mm_max_pd(x, other);
  const __m128d minus_mignitude = _mm_min_pd(_mm_min_pd(x, other), _mm_setzero_pd());
  return _mm_move_sd(magnitude, minus_mignitude);
}

FastInterval divide_by_zero_or_straddling(__m128d x, __m128d y);

}  // namespace fast_detail

inline FastInterval operator-(FastInterval x) {
  return FastInterval::from_raw(fast_detail::swapped(x.raw()));
}

inline FastInterval operator+(FastInterval x, FastInterval y) {
  return fast_detail::settled(_mm_add_pd(opaque(x.raw()), opaque(y.raw())));
}

inline FastInterval operator-(FastInterval x, FastInterval y) { return x + (-y); }

/// All four products, each rounded upward for the upper end and, negated, for the lower end; then the
/// largest.
inline FastInterval operator*(FastInterval a, FastInterval b) {
  const __m128d x = opaque(a.raw());
  const __m128d y = opaque(b.raw());
  const __m256d signs = _mm256_set_pd(0.0, -0.0, -0.0, 0.0);
  const __m256d xs = _mm256_permute4x64_pd(_mm256_castpd128_pd256(x), 0b01010000);
  const __m256d ys = _mm256_set_m128d(y, y);
  const __m256d for_upper = _mm256_xor_pd(xs, signs);
  const __m256d for_lower = _mm256_xor_pd(for_upper, _mm256_set1_pd(-0.0));
  __m256d upper = _mm256_mul_pd(opaque(for_upper), ys);
  __m256d lower = _mm256_mul_pd(opaque(for_lower), ys);
  upper = _mm256_and_pd(upper, _mm256_cmp_pd(upper, upper, _CMP_ORD_Q));  // 0 * inf is 0
  lower = _mm256_and_pd(lower, _mm256_cmp_pd(lower, lower, _CMP_ORD_Q));
  const __m256d pairs = _mm256_max_pd(_mm256_unpacklo_pd(lower, upper), _mm256_unpackhi_pd(lower, upper));
  const __m128d ends = _mm_max_pd(_mm256_castpd256_pd128(pairs), _mm256_extractf128_pd(pairs, 1));
  return fast_detail::unless_empty(ends, _mm_min_pd(x, y));
}

/// A divisor of one sign is made nonnegative; then each end v of the dividend has its extreme quotient at the
/// divisor's upper end when v <= 0 and at its lower end otherwise.
inline FastInterval operator/(FastInterval a, FastInterval b) {
  __m128d x = opaque(a.raw());
  __m128d y = opaque(b.raw());
  const int positive = _mm_movemask_pd(_mm_cmpgt_pd(y, _mm_setzero_pd()));
  if (positive == 0 || positive == 3) return fast_detail::divide_by_zero_or_straddling(x, y);
  if (positive == 1) {
    x = fast_detail::swapped(x);
    y = fast_detail::swapped(y);
  }
  const __m128d lower = _mm_sub_pd(_mm_setzero_pd(), _mm_unpacklo_pd(y, y));  // +0 rather than -0
  const __m128d upper = _mm_unpackhi_pd(y, y);
  const __m128d divisor = _mm_blendv_pd(lower, upper, _mm_cmple_pd(x, _mm_setzero_pd()));
  return fast_detail::settled(_mm_div_pd(x, divisor));
}

inline FastInterval sqr(FastInterval x) {
  const __m128d ends = fast_detail::magnitudes(opaque(x.raw()));
  // The second factor's upper element is >= 0, so that the empty set gives -inf * 0 = NaN, which settles to
  // -inf.
  const __m128d factor = _mm_move_sd(_mm_max_pd(ends, _mm_setzero_pd()), fast_detail::negated(ends));
  return fast_detail::settled(_mm_mul_pd(opaque(ends), factor));
}

/// The root rounded upward is the upper end; the lower end is its predecessor unless the root is exact, which
/// the sign of root^2 - x, exact by the fused multiplication, tells.
inline FastInterval sqrt(FastInterval x) {
  const __m128d ends = opaque(x.raw());
  const __m128d bounds = _mm_move_sd(ends, fast_detail::negated(ends));
  if (!(_mm_cvtsd_f64(_mm_unpackhi_pd(ends, ends)) >= 0)) return {};
  const __m128d squares = opaque(_mm_max_pd(bounds, _mm_setzero_pd()));
  const __m128d roots = opaque(_mm_sqrt_pd(squares));
  const __m128d inexact = _mm_cmpgt_pd(_mm_fmsub_pd(roots, roots, squares), _mm_setzero_pd());
  const __m128d step = _mm_and_pd(inexact, _mm_set1_pd(std::numeric_limits<double>::denorm_min()));
  const __m128d lower = _mm_add_pd(fast_detail::negated(roots), step);
  return FastInterval::from_raw(opaque(_mm_move_sd(roots, lower)));
}

inline FastInterval abs(FastInterval x) {
  return FastInterval::from_raw(opaque(fast_detail::magnitudes(opaque(x.raw()))));
}

inline FastInterval min(FastInterval a, FastInterval b) {
  const __m128d x = opaque(a.raw());
  const __m128d y = opaque(b.raw());
  const __m128d smaller = _mm_min_pd(x, y);
  return fast_detail::unless_empty(_mm_move_sd(smaller, _mm_max_pd(x, y)), smaller);
}

inline FastInterval max(FastInterval a, FastInterval b) {
  const __m128d x = opaque(a.raw());
  const __m128d y = opaque(b.raw());
  const __m128d smaller = _mm_min_pd(x, y);
  return fast_detail::unless_empty(_mm_move_sd(_mm_max_pd(x, y), smaller), smaller);
}

/// x^n; x^0 is 1, a negative n divides by the power.
FastInterval pow(FastInterval x, int n);
/// As elementary::pow.
FastInterval pow(FastInterval x, const Rational& exponent);

// As in elementary.h: the tightest enclosing intervals.
FastInterval cbrt(FastInterval x);
FastInterval exp(FastInterval x);
FastInterval log(FastInterval x);
FastInterval sin(FastInterval x);
FastInterval cos(FastInterval x);
FastInterval tan(FastInterval x);
FastInterval asin(FastInterval x);
FastInterval acos(FastInterval x);
FastInterval atan(FastInterval x);

FastInterval intersection(FastInterval x, FastInterval y);
FastInterval hull(FastInterval x, FastInterval y);

/// {z : b z in numerator for some b in denominator} in at most two pieces, left before right; a missing piece
/// is empty. That is mulRevToPair of IEEE 1788: unlike the quotient it is entire when both contain 0, as
/// interval Newton needs.
std::pair<FastInterval, FastInterval> extended_divide(FastInterval numerator, FastInterval denominator);

template <>
struct NumberTraits<FastInterval> {
  struct Scope {
    explicit Scope(int /*bits*/ = 53) {}
    UpwardRounding upward;
  };
  static FastInterval from_rational(const Rational& value);
  static FastInterval from_interval(const Interval& x) { return FastInterval(x); }
  static FastInterval pi();
  static Interval enclosure(FastInterval x) { return x.interval(); }
  static constexpr Promise promise = Promise::rigorous;
  static constexpr bool is_set = true;
};

}  // namespace gcslab
