#include "interval/fast_interval.h"

#include <cmath>

#include "interval/elementary.h"

namespace gcslab {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Element by element, sign(x) |x|^n rounded upward; n >= 1.
__m128d signed_power(__m128d x, unsigned n) {
  const __m128d sign = _mm_set1_pd(-0.0);
  __m128d base = opaque(x);
  while ((n & 1U) == 0) {
    base = opaque(_mm_mul_pd(base, _mm_andnot_pd(sign, base)));
    n >>= 1U;
  }
  __m128d power = base;
  while (n >>= 1U) {
    base = opaque(_mm_mul_pd(base, _mm_andnot_pd(sign, base)));
    if (n & 1U) power = opaque(_mm_mul_pd(power, _mm_andnot_pd(sign, base)));
  }
  return power;
}

FastInterval positive_power(FastInterval x, unsigned n) {
  const bool even = n % 2 == 0;
  return FastInterval::from_raw(signed_power(even ? fast_detail::magnitudes(opaque(x.raw())) : x.raw(), n));
}

FastInterval quotient(double numerator, double denominator) {
  return FastInterval(numerator) / FastInterval(denominator);
}

}  // namespace

namespace fast_detail {

FastInterval divide_by_zero_or_straddling(__m128d x, __m128d y) {
  const FastInterval dividend = FastInterval::from_raw(x);
  const bool straddles = _mm_movemask_pd(_mm_cmpgt_pd(y, _mm_setzero_pd())) == 3;
  if (dividend.is_empty() || !straddles) return {};
  if (dividend.lower() == 0 && dividend.upper() == 0) return dividend;
  return {-kInfinity, kInfinity};
}

}  // namespace fast_detail

FastInterval pow(FastInterval x, int n) {
  if (n > 0) return positive_power(x, static_cast<unsigned>(n));
  if (n == 0) return x.is_empty() ? x : FastInterval(1.0);
  return FastInterval(1.0) / positive_power(x, 0U - static_cast<unsigned>(n));
}

FastInterval pow(FastInterval x, const Rational& exponent) {
  return FastInterval(elementary::pow(x.interval(), exponent));
}

FastInterval cbrt(FastInterval x) { return FastInterval(elementary::cbrt(x.interval())); }
FastInterval exp(FastInterval x) { return FastInterval(elementary::exp(x.interval())); }
FastInterval log(FastInterval x) { return FastInterval(elementary::log(x.interval())); }
FastInterval sin(FastInterval x) { return FastInterval(elementary::sin(x.interval())); }
FastInterval cos(FastInterval x) { return FastInterval(elementary::cos(x.interval())); }
FastInterval tan(FastInterval x) { return FastInterval(elementary::tan(x.interval())); }
FastInterval asin(FastInterval x) { return FastInterval(elementary::asin(x.interval())); }
FastInterval acos(FastInterval x) { return FastInterval(elementary::acos(x.interval())); }
FastInterval atan(FastInterval x) { return FastInterval(elementary::atan(x.interval())); }

FastInterval intersection(FastInterval x, FastInterval y) {
  const __m128d ends = _mm_min_pd(x.raw(), y.raw());
  const FastInterval common = FastInterval::from_raw(ends);
  return common.lower() <= common.upper() ? common : FastInterval();
}

FastInterval hull(FastInterval x, FastInterval y) {
  return FastInterval::from_raw(_mm_max_pd(x.raw(), y.raw()));
}

std::pair<FastInterval, FastInterval> extended_divide(FastInterval numerator, FastInterval denominator) {
  const Interval a = numerator.interval();
  const Interval b = denominator.interval();
  if (is_empty(a) || is_empty(b)) return {};
  if (!contains(b, 0)) return {numerator / denominator, {}};
  if (contains(a, 0)) return {{-kInfinity, kInfinity}, {}};
  if (b.lower == 0 || b.upper == 0) return {numerator / denominator, {}};
  const double near = a.lower > 0 ? a.lower : a.upper;  // the end nearest 0 has the innermost quotients
  const double left_divisor = a.lower > 0 ? b.lower : b.upper;
  const double right_divisor = a.lower > 0 ? b.upper : b.lower;
  const auto innermost = [near](double divisor) {
    return std::isinf(divisor) ? FastInterval(0.0) : quotient(near, divisor);
  };
  return {{-kInfinity, innermost(left_divisor).upper()}, {innermost(right_divisor).lower(), kInfinity}};
}

FastInterval NumberTraits<FastInterval>::from_rational(const Rational& value) {
  return FastInterval(elementary::enclosing(value));
}

FastInterval NumberTraits<FastInterval>::pi() { return FastInterval(elementary::pi()); }

}  // namespace gcslab
