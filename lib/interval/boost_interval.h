#pragma once

// BoostInterval: intervals of two doubles by Boost.Interval (Brönnimann, Melquiond, Pion 2006, "The design of
// the Boost interval arithmetic library"), the independent counterpart of FastInterval.
//
// Promise: inside a Scope every operation encloses the exact set of results. Boost's own rounding policies
// rely on the compiler to leave directed operations alone; here its arithmetic is given a policy whose
// operations pass barriers (rounding.h) and which expects upward rounding, so that no operation changes the
// mode except the square root. Boost's transcendental functions miss the true value (its std rounding trusts
// libm): those here are elementary.h's. Boost stores the empty set as NaN ends.

#include <boost/numeric/interval/arith.hpp>
#include <boost/numeric/interval/arith2.hpp>
#include <boost/numeric/interval/checking.hpp>
#include <boost/numeric/interval/interval.hpp>
#include <boost/numeric/interval/policies.hpp>
#include <boost/numeric/interval/utility.hpp>
#include <limits>

#include "interval/interval.h"
#include "interval/number_traits.h"
#include "interval/rational.h"
#include "interval/rounding.h"

namespace gcslab {

namespace boost_detail {

/// Boost's rounding concept in upward mode: downward operations are upward ones of negated operands.
struct UpwardArithmetic {
  void init() {}
  double conv_down(double x) { return x; }
  double conv_up(double x) { return x; }
  double add_down(double x, double y) { return -rounded_add(-x, -y); }
  double add_up(double x, double y) { return rounded_add(x, y); }
  double sub_down(double x, double y) { return -rounded_subtract(y, x); }
  double sub_up(double x, double y) { return rounded_subtract(x, y); }
  double mul_down(double x, double y) { return -rounded_multiply(-x, y); }
  double mul_up(double x, double y) { return rounded_multiply(x, y); }
  double div_down(double x, double y) { return -rounded_divide(-x, y); }
  double div_up(double x, double y) { return rounded_divide(x, y); }
  double sqrt_down(double x);
  double sqrt_up(double x);
};

using Policies = boost::numeric::interval_lib::policies<UpwardArithmetic,
                                                        boost::numeric::interval_lib::checking_base<double>>;
using Value = boost::numeric::interval<double, Policies>;

}  // namespace boost_detail

class BoostInterval {
 public:
  /// The empty set.
  BoostInterval() : value_(boost_detail::Value::empty()) {}
  explicit BoostInterval(const boost_detail::Value& value) : value_(value) {}
  explicit BoostInterval(const Interval& x)
      : value_(is_empty(x) ? boost_detail::Value::empty() : boost_detail::Value(x.lower, x.upper)) {}

  const boost_detail::Value& value() const { return value_; }
  Interval interval() const;

 private:
  boost_detail::Value value_;
};

inline BoostInterval operator-(const BoostInterval& x) { return BoostInterval(-x.value()); }
inline BoostInterval operator+(const BoostInterval& x, const BoostInterval& y) {
  return BoostInterval(x.value() + y.value());
}
inline BoostInterval operator-(const BoostInterval& x, const BoostInterval& y) {
  return BoostInterval(x.value() - y.value());
}
inline BoostInterval operator*(const BoostInterval& x, const BoostInterval& y) {
  return BoostInterval(x.value() * y.value());
}
/// Boost's quotient, cut to the sign that the operands give it: Boost has [-1, 0] / [0, 1] entire.
BoostInterval operator/(const BoostInterval& x, const BoostInterval& y);
inline BoostInterval sqr(const BoostInterval& x) { return BoostInterval(boost::numeric::square(x.value())); }
inline BoostInterval sqrt(const BoostInterval& x) { return BoostInterval(boost::numeric::sqrt(x.value())); }
inline BoostInterval abs(const BoostInterval& x) { return BoostInterval(boost::numeric::abs(x.value())); }
inline BoostInterval min(const BoostInterval& x, const BoostInterval& y) {
  return BoostInterval((boost::numeric::min)(x.value(), y.value()));
}
inline BoostInterval max(const BoostInterval& x, const BoostInterval& y) {
  return BoostInterval((boost::numeric::max)(x.value(), y.value()));
}

/// x^n; x^0 is 1, a negative n divides by the power.
BoostInterval pow(const BoostInterval& x, int n);

// As in elementary.h.
BoostInterval pow(const BoostInterval& x, const Rational& exponent);
BoostInterval cbrt(const BoostInterval& x);
BoostInterval exp(const BoostInterval& x);
BoostInterval log(const BoostInterval& x);
BoostInterval sin(const BoostInterval& x);
BoostInterval cos(const BoostInterval& x);
BoostInterval tan(const BoostInterval& x);
BoostInterval asin(const BoostInterval& x);
BoostInterval acos(const BoostInterval& x);
BoostInterval atan(const BoostInterval& x);

template <>
struct NumberTraits<BoostInterval> {
  struct Scope {
    explicit Scope(int /*bits*/ = 53) {}
    UpwardRounding upward;
  };
  static BoostInterval from_rational(const Rational& value);
  static BoostInterval from_interval(const Interval& x) { return BoostInterval(x); }
  static BoostInterval pi();
  static Interval enclosure(const BoostInterval& x) { return x.interval(); }
  static constexpr Promise promise = Promise::rigorous;
  static constexpr bool is_set = true;
};

}  // namespace gcslab
