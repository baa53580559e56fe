#pragma once

// UnroundedInterval: the baseline that shows why outward rounding is needed.
//
// Interval arithmetic whose ends are rounded to nearest, as a program that ignores rounding would have it. It
// encloses nothing for certain: [1,1]/[3,3] is one double, which is not 1/3. Elementary functions round the
// exact ends to nearest by MPFR, so that results do not depend on libm. Domains, empty and unbounded
// intervals are as in the rigorous types.

#include "interval/interval.h"
#include "interval/number_traits.h"
#include "interval/rational.h"
#include "interval/rounding.h"

namespace gcslab {

class UnroundedInterval {
 public:
  /// The empty set.
  UnroundedInterval() = default;
  explicit UnroundedInterval(const Interval& x);

  const Interval& interval() const { return ends_; }

 private:
  Interval ends_;
};

UnroundedInterval operator-(const UnroundedInterval& x);
UnroundedInterval operator+(const UnroundedInterval& x, const UnroundedInterval& y);
UnroundedInterval operator-(const UnroundedInterval& x, const UnroundedInterval& y);
UnroundedInterval operator*(const UnroundedInterval& x, const UnroundedInterval& y);
UnroundedInterval operator/(const UnroundedInterval& x, const UnroundedInterval& y);
UnroundedInterval sqr(const UnroundedInterval& x);
UnroundedInterval pow(const UnroundedInterval& x, int n);
UnroundedInterval pow(const UnroundedInterval& x, const Rational& exponent);
UnroundedInterval sqrt(const UnroundedInterval& x);
UnroundedInterval cbrt(const UnroundedInterval& x);
UnroundedInterval exp(const UnroundedInterval& x);
UnroundedInterval log(const UnroundedInterval& x);
UnroundedInterval sin(const UnroundedInterval& x);
UnroundedInterval cos(const UnroundedInterval& x);
UnroundedInterval tan(const UnroundedInterval& x);
UnroundedInterval asin(const UnroundedInterval& x);
UnroundedInterval acos(const UnroundedInterval& x);
UnroundedInterval atan(const UnroundedInterval& x);
UnroundedInterval abs(const UnroundedInterval& x);
UnroundedInterval min(const UnroundedInterval& x, const UnroundedInterval& y);
UnroundedInterval max(const UnroundedInterval& x, const UnroundedInterval& y);

template <>
struct NumberTraits<UnroundedInterval> {
  struct Scope {
    explicit Scope(int /*bits*/ = 53) {}
    NearestRounding nearest;
  };
  static UnroundedInterval from_rational(const Rational& value);
  static UnroundedInterval from_interval(const Interval& x) { return UnroundedInterval(x); }
  static UnroundedInterval pi();
  static Interval enclosure(const UnroundedInterval& x) { return x.interval(); }
  static constexpr Promise promise = Promise::baseline;
  static constexpr bool is_set = true;
};

}  // namespace gcslab
