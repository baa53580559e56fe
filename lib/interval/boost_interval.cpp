#include "interval/boost_interval.h"

#include <cmath>

#include "interval/elementary.h"

namespace gcslab {

namespace boost_detail {

double UpwardArithmetic::sqrt_down(double x) {
  const RoundingScope<RoundingMode::downward> downward;
  return opaque(std::sqrt(opaque(x)));
}

double UpwardArithmetic::sqrt_up(double x) { return opaque(std::sqrt(opaque(x))); }

}  // namespace boost_detail

Interval BoostInterval::interval() const {
  if (boost::numeric::empty(value_)) return Interval::empty();
  return {value_.lower() + 0.0, value_.upper() + 0.0};  // no -0
}

BoostInterval operator/(const BoostInterval& x, const BoostInterval& y) {
  const boost_detail::Value quotient = x.value() / y.value();
  if (!boost::numeric::zero_in(y.value())) return BoostInterval(quotient);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto nonnegative = [](const BoostInterval& z) { return z.value().lower() >= 0; };
  const auto nonpositive = [](const BoostInterval& z) { return z.value().upper() <= 0; };
  const bool positive = (nonnegative(x) && nonnegative(y)) || (nonpositive(x) && nonpositive(y));
  const bool negative = (nonnegative(x) && nonpositive(y)) || (nonpositive(x) && nonnegative(y));
  const boost_detail::Value sign(negative ? -kInfinity : 0, positive ? kInfinity : 0);
  return BoostInterval(positive || negative ? boost::numeric::intersect(quotient, sign) : quotient);
}

BoostInterval pow(const BoostInterval& x, int n) {
  if (n == 0) return boost::numeric::empty(x.value()) ? x : BoostInterval(Interval(1));
  if (n > 0) return BoostInterval(boost::numeric::pow(x.value(), n));
  const BoostInterval half = pow(x, -(n / 2));  // n itself may have no negative
  const BoostInterval power = n % 2 == 0 ? sqr(half) : pow(x, -n);
  return BoostInterval(Interval(1)) / power;
}

BoostInterval pow(const BoostInterval& x, const Rational& exponent) {
  return BoostInterval(elementary::pow(x.interval(), exponent));
}

BoostInterval cbrt(const BoostInterval& x) { return BoostInterval(elementary::cbrt(x.interval())); }
BoostInterval exp(const BoostInterval& x) { return BoostInterval(elementary::exp(x.interval())); }
BoostInterval log(const BoostInterval& x) { return BoostInterval(elementary::log(x.interval())); }
BoostInterval sin(const BoostInterval& x) { return BoostInterval(elementary::sin(x.interval())); }
BoostInterval cos(const BoostInterval& x) { return BoostInterval(elementary::cos(x.interval())); }
BoostInterval tan(const BoostInterval& x) { return BoostInterval(elementary::tan(x.interval())); }
BoostInterval asin(const BoostInterval& x) { return BoostInterval(elementary::asin(x.interval())); }
BoostInterval acos(const BoostInterval& x) { return BoostInterval(elementary::acos(x.interval())); }
BoostInterval atan(const BoostInterval& x) { return BoostInterval(elementary::atan(x.interval())); }

BoostInterval NumberTraits<BoostInterval>::from_rational(const Rational& value) {
  return BoostInterval(elementary::enclosing(value));
}

BoostInterval NumberTraits<BoostInterval>::pi() { return BoostInterval(elementary::pi()); }

}  // namespace gcslab
