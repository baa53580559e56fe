#include "interval/unrounded_interval.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "interval/elementary.h"
#include "interval/point_numbers.h"

namespace gcslab {
namespace {

using elementary::Ends;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();

UnroundedInterval made(double lower, double upper) { return UnroundedInterval(Interval(lower, upper)); }

/// The product of two ends, where 0 * inf is 0.
double product(double x, double y) { return x == 0 || y == 0 ? 0 : x * y; }

UnroundedInterval quotient_by_positive(const Interval& x, const Interval& y) {
  const double lower = x.lower < 0 ? x.lower / y.lower : x.lower / y.upper;
  const double upper = x.upper > 0 ? x.upper / y.lower : x.upper / y.upper;
  return made(lower, upper);
}

}  // namespace

/// Overflow may give an end that no nonempty interval has; it becomes the largest double.
UnroundedInterval::UnroundedInterval(const Interval& x) : ends_(x) {
  if (x.lower == kInfinity && x.upper == kInfinity) ends_.lower = kLargest;
  if (x.lower == -kInfinity && x.upper == -kInfinity) ends_.upper = -kLargest;
}

UnroundedInterval operator-(const UnroundedInterval& x) {
  const Interval& a = x.interval();
  return is_empty(a) ? x : made(0.0 - a.upper, 0.0 - a.lower);
}

UnroundedInterval operator+(const UnroundedInterval& x, const UnroundedInterval& y) {
  const Interval& a = x.interval();
  const Interval& b = y.interval();
  if (is_empty(a) || is_empty(b)) return {};
  return made(a.lower + b.lower, a.upper + b.upper);
}

UnroundedInterval operator-(const UnroundedInterval& x, const UnroundedInterval& y) { return x + (-y); }

UnroundedInterval operator*(const UnroundedInterval& x, const UnroundedInterval& y) {
  const Interval& a = x.interval();
  const Interval& b = y.interval();
  if (is_empty(a) || is_empty(b)) return {};
  const auto [lower, upper] = std::minmax({product(a.lower, b.lower), product(a.lower, b.upper),
                                           product(a.upper, b.lower), product(a.upper, b.upper)});
  return made(lower, upper);
}

UnroundedInterval operator/(const UnroundedInterval& x, const UnroundedInterval& y) {
  const Interval& a = x.interval();
  const Interval& b = y.interval();
  if (is_empty(a) || is_empty(b) || (b.lower == 0 && b.upper == 0)) return {};
  if (a.lower == 0 && a.upper == 0) return x;
  if (b.lower < 0 && b.upper > 0) return UnroundedInterval(Interval::entire());
  if (b.upper <= 0) return (-x) / (-y);
  return quotient_by_positive(a, {b.lower + 0.0, b.upper});
}

UnroundedInterval sqr(const UnroundedInterval& x) {
  const Interval& a = x.interval();
  if (is_empty(a)) return {};
  return made(sqr(mignitude(a)), sqr(magnitude(a)));
}

UnroundedInterval pow(const UnroundedInterval& x, int n) {
  const Interval& a = x.interval();
  if (is_empty(a)) return {};
  if (n == 0) return made(1, 1);
  if (n < 0) {
    const UnroundedInterval power = n == std::numeric_limits<int>::min() ? sqr(pow(x, -(n / 2))) : pow(x, -n);
    return made(1, 1) / power;
  }
  if (n % 2 == 0) return made(pow(mignitude(a), n), pow(magnitude(a), n));
  return made(pow(a.lower, n), pow(a.upper, n));
}

UnroundedInterval pow(const UnroundedInterval& x, const Rational& exponent) {
  return UnroundedInterval(elementary::pow(x.interval(), exponent, Ends::to_nearest));
}

UnroundedInterval sqrt(const UnroundedInterval& x) {
  return UnroundedInterval(elementary::sqrt(x.interval(), Ends::to_nearest));
}
UnroundedInterval cbrt(const UnroundedInterval& x) {
  return UnroundedInterval(elementary::cbrt(x.interval(), Ends::to_nearest));
}
UnroundedInterval exp(const UnroundedInterval& x) {
  return UnroundedInterval(elementary::exp(x.interval(), Ends::to_nearest));
}
UnroundedInterval log(const UnroundedInterval& x) {
  return UnroundedInterval(elementary::log(x.interval(), Ends::to_nearest));
}
UnroundedInterval sin(const UnroundedInterval& x) {
  return UnroundedInterval(elementary::sin(x.interval(), Ends::to_nearest));
}
UnroundedInterval cos(const UnroundedInterval& x) {
  return UnroundedInterval(elementary::cos(x.interval(), Ends::to_nearest));
}
UnroundedInterval tan(const UnroundedInterval& x) {
  return UnroundedInterval(elementary::tan(x.interval(), Ends::to_nearest));
}
UnroundedInterval asin(const UnroundedInterval& x) {
  return UnroundedInterval(elementary::asin(x.interval(), Ends::to_nearest));
}
UnroundedInterval acos(const UnroundedInterval& x) {
  return UnroundedInterval(elementary::acos(x.interval(), Ends::to_nearest));
}
UnroundedInterval atan(const UnroundedInterval& x) {
  return UnroundedInterval(elementary::atan(x.interval(), Ends::to_nearest));
}

UnroundedInterval abs(const UnroundedInterval& x) {
  const Interval& a = x.interval();
  return is_empty(a) ? x : made(mignitude(a), magnitude(a));
}

UnroundedInterval min(const UnroundedInterval& x, const UnroundedInterval& y) {
  const Interval& a = x.interval();
  const Interval& b = y.interval();
  if (is_empty(a) || is_empty(b)) return {};
  return made(std::min(a.lower, b.lower), std::min(a.upper, b.upper));
}

UnroundedInterval max(const UnroundedInterval& x, const UnroundedInterval& y) {
  const Interval& a = x.interval();
  const Interval& b = y.interval();
  if (is_empty(a) || is_empty(b)) return {};
  return made(std::max(a.lower, b.lower), std::max(a.upper, b.upper));
}

UnroundedInterval NumberTraits<UnroundedInterval>::from_rational(const Rational& value) {
  return UnroundedInterval(Interval(nearest_double(value)));
}

UnroundedInterval NumberTraits<UnroundedInterval>::pi() {
  return UnroundedInterval(elementary::pi(Ends::to_nearest));
}

}  // namespace gcslab
