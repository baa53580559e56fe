#include "verifier/projection.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace gcslab::verifier {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Range nonnegative(const Range& x) { return intersection(x, Range(Interval(0, kInfinity))); }

/// The part of x or of -x that lies within.
Range both_signs(const Range& x, const Range& within) {
  return hull(intersection(x, within), intersection(-x, within));
}

Range half_pi() { return Range::pi() * Range(Rational(1, 2)); }

/// {k period + offset : offset in z, k an integer} within `within`; `within` itself when the k are many.
Range repeated(const Range& z, const Range& period, const Range& within) {
  constexpr double kMaximumCopies = 8;
  if (z.is_empty() || within.is_empty()) return Range::empty();
  const Interval copies = ((within - z) / period).outward();
  if (!is_bounded(copies) || magnitude(copies) > 1e15 || width(copies) > kMaximumCopies) return within;
  Range result = Range::empty();
  const auto last = static_cast<std::int64_t>(std::floor(copies.upper));
  for (auto k = static_cast<std::int64_t>(std::ceil(copies.lower)); k <= last; ++k)
    result = hull(result, intersection(z + scaled(static_cast<double>(k), period), within));
  return result;
}

}  // namespace

Range project_factor(const Range& z, const Range& other, const Range& within) {
  if (z.is_empty() || other.is_empty() || within.is_empty()) return Range::empty();
  if (!other.contains_zero()) return intersection(z / other, within);
  if (z.contains_zero()) return within;
  // 0 is no divisor here: the quotients fall into those by the negative and those by the positive divisors.
  const Range negative = intersection(other, Range(Interval(-kInfinity, 0)));
  const Range positive = nonnegative(other);
  return hull(intersection(z / negative, within), intersection(z / positive, within));
}

Range project_sqr(const Range& z, const Range& within) { return both_signs(sqrt(z), within); }

Range project_power(const Range& z, const Rational& exponent, const Range& within) {
  if (exponent == 0) return within;
  const Rational inverse = 1 / exponent;
  const bool even_power = mpz_even_p(exponent.get_num_mpz_t()) != 0;
  const bool even_root = mpz_even_p(exponent.get_den_mpz_t()) != 0;
  if (even_power) return both_signs(power(nonnegative(z), inverse), within);
  return intersection(power(even_root ? nonnegative(z) : z, inverse), within);
}

Range project_abs(const Range& z, const Range& within) { return both_signs(nonnegative(z), within); }

Range project_sqrt(const Range& z, const Range& within) { return intersection(sqr(nonnegative(z)), within); }

Range project_sin(const Range& z, const Range& within) {
  const Range angle = asin(z);
  const Range period = scaled(2, Range::pi());
  return hull(repeated(angle, period, within), repeated(Range::pi() - angle, period, within));
}

Range project_cos(const Range& z, const Range& within) {
  const Range angle = acos(z);
  const Range period = scaled(2, Range::pi());
  return hull(repeated(angle, period, within), repeated(-angle, period, within));
}

Range project_tan(const Range& z, const Range& within) { return repeated(atan(z), Range::pi(), within); }

Range project_asin(const Range& z, const Range& within) {
  const Range values = hull(-half_pi(), half_pi());
  return intersection(sin(intersection(z, values)), within);
}

Range project_acos(const Range& z, const Range& within) {
  const Range values = hull(Range(0.0), Range::pi());
  return intersection(cos(intersection(z, values)), within);
}

Range project_atan(const Range& z, const Range& within) {
  const Range quarter = half_pi();
  Range inside = intersection(z, hull(-quarter, quarter));
  if (inside.is_empty()) return inside;
  // An end of z at a quarter turn stands for every argument beyond.
  const bool reaches_top = mpfr_greaterequal_p(inside.upper(), quarter.lower()) != 0;
  const bool reaches_bottom =
      mpfr_cmpabs(inside.lower(), quarter.lower()) >= 0 && mpfr_sgn(inside.lower()) < 0;
  if (reaches_top || reaches_bottom) return within;
  return intersection(tan(inside), within);
}

Range project_min(const Range& z, const Range& other, const Range& within) {
  if (z.is_empty() || other.is_empty()) return Range::empty();
  // When the other operand cannot be the smaller one, this one is.
  if (mpfr_less_p(z.upper(), other.lower()) != 0) return intersection(within, z);
  Range above = z;
  mpfr_set_inf(above.upper(), 1);
  return intersection(within, above);
}

}  // namespace gcslab::verifier
