#pragma once

// What it takes to enclose a function of one variable between two parallel lines: its values, derivative and
// curvature.

#include "interval/fast_interval.h"
#include "interval/interval.h"
#include "interval/rational.h"

namespace gcslab {

enum class Curvature { convex, concave, mixed };

/// A real function, differentiable in the interior of its domain. Evaluation needs upward rounding.
class UnivariateFunction {
 public:
  virtual ~UnivariateFunction() = default;
  /// Encloses the values over x.
  virtual FastInterval value(FastInterval x) const = 0;
  /// Encloses the derivatives at the points of x where the function is differentiable.
  virtual FastInterval derivative(FastInterval x) const = 0;
  /// A closed interval that contains all points where the function is defined.
  virtual Interval domain() const { return Interval::entire(); }
  /// `convex` and `concave` are proved on x, a bounded part of the domain on which the function is bounded.
  virtual Curvature curvature(const Interval& x) const = 0;
  /// Roughly the point of x where the derivative is `slope`; nothing rests on its accuracy, and it may be
  /// NaN.
  virtual double tangent_point(double slope, const Interval& x) const = 0;
};

const UnivariateFunction& sqrt_function();
const UnivariateFunction& cbrt_function();
const UnivariateFunction& exp_function();
const UnivariateFunction& log_function();
const UnivariateFunction& sin_function();
const UnivariateFunction& cos_function();
const UnivariateFunction& tan_function();
const UnivariateFunction& asin_function();
const UnivariateFunction& acos_function();
const UnivariateFunction& atan_function();

/// x^n, n neither 0 nor 1.
class IntegerPower final : public UnivariateFunction {
 public:
  explicit IntegerPower(int n) : n_(n) {}
  FastInterval value(FastInterval x) const override;
  FastInterval derivative(FastInterval x) const override;
  Curvature curvature(const Interval& x) const override;
  double tangent_point(double slope, const Interval& x) const override;

 private:
  int n_;
};

/// x^exponent as in elementary.h, the exponent not an integer.
class RationalPower final : public UnivariateFunction {
 public:
  explicit RationalPower(const Rational& exponent) : exponent_(exponent) {}
  FastInterval value(FastInterval x) const override;
  FastInterval derivative(FastInterval x) const override;
  Interval domain() const override;
  Curvature curvature(const Interval& x) const override;
  double tangent_point(double slope, const Interval& x) const override;

 private:
  Rational exponent_;
};

}  // namespace gcslab
