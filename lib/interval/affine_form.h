#pragma once

// AffineForm: affine arithmetic, which keeps first-order dependencies between values (Comba, Stolfi 1993; de
// Figueiredo, Stolfi 1997, "Self-validated numerical methods and applications", and 2004, "Affine arithmetic:
// concepts and applications").
//
// Promise: inside a Scope every operation encloses. Precisely: let the variables be what from_interval made
// in the scope. For every choice of their members at which an expression is defined there are values of the
// noise symbols in [-1, 1] at which each form that took part contains the exact value; and every form's range
// contains it as well. A value is carried as an affine sum together with an interval range, evaluated by
// FastInterval and intersected with the sum's, so that the enclosure is never wider than the natural one.
// Empty, unbounded and overflowing values have a range alone.
//
// Functions of one variable are enclosed between two parallel lines: Chebyshev's or those of least range
// (linear_enclosure.h). The two types differ in nothing else.

#include <optional>
#include <utility>

#include "interval/affine_sum.h"
#include "interval/interval.h"
#include "interval/linear_enclosure.h"
#include "interval/number_traits.h"
#include "interval/rational.h"

namespace gcslab {

/// A value of affine arithmetic, without the choice of approximation.
class AffineValue {
 public:
  /// The empty set.
  AffineValue() = default;
  /// The range cut to the sum's; without a finite sum, a bounded range becomes a sum of its own.
  AffineValue(const Interval& range, std::optional<AffineSum> sum);

  const Interval& range() const { return range_; }
  /// None when the value is empty or unbounded.
  const std::optional<AffineSum>& sum() const { return sum_; }

 private:
  Interval range_;
  std::optional<AffineSum> sum_;
};

namespace affine {

AffineValue constant(const Interval& x);
AffineValue variable(const Interval& x);
AffineValue negate(const AffineValue& x);
AffineValue add(const AffineValue& x, const AffineValue& y);
AffineValue subtract(const AffineValue& x, const AffineValue& y);
AffineValue multiply(const AffineValue& x, const AffineValue& y);
AffineValue divide(const AffineValue& x, const AffineValue& y, Approximation approximation);
AffineValue power(const AffineValue& x, int n, Approximation approximation);
AffineValue power(const AffineValue& x, const Rational& exponent, Approximation approximation);
AffineValue apply(const UnivariateFunction& f, const AffineValue& x, Approximation approximation);
AffineValue absolute_value(const AffineValue& x, Approximation approximation);
AffineValue minimum(const AffineValue& x, const AffineValue& y, Approximation approximation);
AffineValue maximum(const AffineValue& x, const AffineValue& y, Approximation approximation);

}  // namespace affine

template <Approximation approximation>
class AffineForm {
 public:
  /// The empty set.
  AffineForm() = default;
  explicit AffineForm(AffineValue value) : value_(std::move(value)) {}

  const AffineValue& value() const { return value_; }
  const Interval& range() const { return value_.range(); }

  friend AffineForm operator-(const AffineForm& x) { return AffineForm(affine::negate(x.value_)); }
  friend AffineForm operator+(const AffineForm& x, const AffineForm& y) {
    return AffineForm(affine::add(x.value_, y.value_));
  }
  friend AffineForm operator-(const AffineForm& x, const AffineForm& y) {
    return AffineForm(affine::subtract(x.value_, y.value_));
  }
  friend AffineForm operator*(const AffineForm& x, const AffineForm& y) {
    return AffineForm(affine::multiply(x.value_, y.value_));
  }
  friend AffineForm operator/(const AffineForm& x, const AffineForm& y) {
    return AffineForm(affine::divide(x.value_, y.value_, approximation));
  }
  friend AffineForm sqr(const AffineForm& x) { return pow(x, 2); }
  friend AffineForm pow(const AffineForm& x, int n) {
    return AffineForm(affine::power(x.value_, n, approximation));
  }
  friend AffineForm pow(const AffineForm& x, const Rational& exponent) {
    return AffineForm(affine::power(x.value_, exponent, approximation));
  }
  friend AffineForm sqrt(const AffineForm& x) { return x.applied(sqrt_function()); }
  friend AffineForm cbrt(const AffineForm& x) { return x.applied(cbrt_function()); }
  friend AffineForm exp(const AffineForm& x) { return x.applied(exp_function()); }
  friend AffineForm log(const AffineForm& x) { return x.applied(log_function()); }
  friend AffineForm sin(const AffineForm& x) { return x.applied(sin_function()); }
  friend AffineForm cos(const AffineForm& x) { return x.applied(cos_function()); }
  friend AffineForm tan(const AffineForm& x) { return x.applied(tan_function()); }
  friend AffineForm asin(const AffineForm& x) { return x.applied(asin_function()); }
  friend AffineForm acos(const AffineForm& x) { return x.applied(acos_function()); }
  friend AffineForm atan(const AffineForm& x) { return x.applied(atan_function()); }
  friend AffineForm abs(const AffineForm& x) {
    return AffineForm(affine::absolute_value(x.value_, approximation));
  }
  friend AffineForm min(const AffineForm& x, const AffineForm& y) {
    return AffineForm(affine::minimum(x.value_, y.value_, approximation));
  }
  friend AffineForm max(const AffineForm& x, const AffineForm& y) {
    return AffineForm(affine::maximum(x.value_, y.value_, approximation));
  }

 private:
  AffineForm applied(const UnivariateFunction& f) const {
    return AffineForm(affine::apply(f, value_, approximation));
  }

  AffineValue value_;
};

using ChebyshevAffine = AffineForm<Approximation::chebyshev>;
using MinRangeAffine = AffineForm<Approximation::min_range>;

template <Approximation approximation>
struct NumberTraits<AffineForm<approximation>> {
  using Form = AffineForm<approximation>;
  /// One scope an evaluation: see NoiseScope.
  struct Scope {
    explicit Scope(int /*bits*/ = 53) {}
    NoiseScope noise;
  };
  static Form from_rational(const Rational& value);
  /// Takes a new noise symbol: call it once a variable.
  static Form from_interval(const Interval& x) { return Form(affine::variable(x)); }
  static Form pi();
  static Interval enclosure(const Form& x) { return x.range(); }
  static constexpr Promise promise = Promise::rigorous;
  static constexpr bool is_set = true;
};

}  // namespace gcslab
