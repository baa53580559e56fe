#include "interval/univariate_function.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "interval/elementary.h"
#include "interval/quadrant.h"

namespace gcslab {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kPi = std::numbers::pi;

using elementary::Ends;

const FastInterval kOne(1.0);

/// The nearest integer, in any rounding mode.
double whole(double x) { return std::floor(x + 0.5); }

double sign_of(const Interval& x) { return x.lower >= 0 ? 1 : -1; }

/// Curvature of an odd function that is `right` on the positive numbers.
Curvature odd_curvature(const Interval& x, Curvature right) {
  const Curvature left = right == Curvature::convex ? Curvature::concave : Curvature::convex;
  if (x.lower >= 0) return right;
  return x.upper <= 0 ? left : Curvature::mixed;
}

/// The quadrants that the interior of x meets: an upper end 0 is the only end that can be a multiple of pi/2.
elementary::QuadrantSpan open_span(const Interval& x) {
  elementary::QuadrantSpan span = elementary::quadrant_span(x.lower, x.upper);
  if (x.upper == 0 && x.lower < 0) --span.crossings;
  return span;
}

/// Whether x lies in the quadrants `first` and first + 1.
bool lies_in_two(const elementary::QuadrantSpan& span, int first) {
  if (span.first == first) return span.crossings <= 1;
  return span.first == (first + 1) % 4 && span.crossings == 0;
}

/// A point of slope `slope` on sin(x + phase), which is concave around pi/2 - phase and convex around -pi/2 -
/// phase.
double sine_tangent_point(double slope, const Interval& x, double phase, Curvature curvature) {
  if (!(std::fabs(slope) <= 1)) return kNaN;
  const double side = curvature == Curvature::concave ? 1 : -1;
  const double centre = side * kPi / 2 - phase;
  const double turns = whole((midpoint(x) - centre) / (2 * kPi));
  const double tilt = elementary::asin(slope, Ends::to_nearest).lower;
  return centre + 2 * kPi * turns - side * tilt;
}

class Exponential final : public UnivariateFunction {
 public:
  FastInterval value(FastInterval x) const override { return exp(x); }
  FastInterval derivative(FastInterval x) const override { return exp(x); }
  Curvature curvature(const Interval&) const override { return Curvature::convex; }
  double tangent_point(double slope, const Interval&) const override {
    return slope > 0 ? elementary::log(slope, Ends::to_nearest).lower : kNaN;
  }
};

class Logarithm final : public UnivariateFunction {
 public:
  FastInterval value(FastInterval x) const override { return log(x); }
  FastInterval derivative(FastInterval x) const override { return kOne / x; }
  Interval domain() const override { return {0, kInfinity}; }
  Curvature curvature(const Interval&) const override { return Curvature::concave; }
  double tangent_point(double slope, const Interval&) const override { return 1 / slope; }
};

class Sine final : public UnivariateFunction {
 public:
  FastInterval value(FastInterval x) const override { return sin(x); }
  FastInterval derivative(FastInterval x) const override { return cos(x); }
  Curvature curvature(const Interval& x) const override {
    const elementary::QuadrantSpan span = open_span(x);
    if (lies_in_two(span, 0)) return Curvature::concave;
    return lies_in_two(span, 2) ? Curvature::convex : Curvature::mixed;
  }
  double tangent_point(double slope, const Interval& x) const override {
    return sine_tangent_point(slope, x, 0, curvature(x));
  }
};

class Cosine final : public UnivariateFunction {
 public:
  FastInterval value(FastInterval x) const override { return cos(x); }
  FastInterval derivative(FastInterval x) const override { return -sin(x); }
  Curvature curvature(const Interval& x) const override {
    const elementary::QuadrantSpan span = open_span(x);
    if (lies_in_two(span, 3)) return Curvature::concave;
    return lies_in_two(span, 1) ? Curvature::convex : Curvature::mixed;
  }
  double tangent_point(double slope, const Interval& x) const override {
    return sine_tangent_point(slope, x, kPi / 2, curvature(x));
  }
};

class Tangent final : public UnivariateFunction {
 public:
  FastInterval value(FastInterval x) const override { return tan(x); }
  FastInterval derivative(FastInterval x) const override { return kOne + sqr(tan(x)); }
  Curvature curvature(const Interval& x) const override {
    const elementary::QuadrantSpan span = open_span(x);
    if (span.crossings > 0) return Curvature::mixed;
    return span.first % 2 == 0 ? Curvature::convex : Curvature::concave;
  }
  double tangent_point(double slope, const Interval& x) const override {
    const double zero = kPi * whole(midpoint(x) / kPi);
    const double distance = elementary::atan(std::sqrt(slope - 1), Ends::to_nearest).lower;
    return midpoint(x) >= zero ? zero + distance : zero - distance;
  }
};

/// asin, and acos as its mirror image.
class Arcsine : public UnivariateFunction {
 public:
  FastInterval value(FastInterval x) const override { return asin(x); }
  FastInterval derivative(FastInterval x) const override { return kOne / sqrt(kOne - sqr(x)); }
  Interval domain() const override { return {-1, 1}; }
  Curvature curvature(const Interval& x) const override { return odd_curvature(x, Curvature::convex); }
  double tangent_point(double slope, const Interval& x) const override {
    return sign_of(x) * std::sqrt(1 - 1 / (slope * slope));
  }
};

class Arccosine final : public Arcsine {
 public:
  FastInterval value(FastInterval x) const override { return acos(x); }
  FastInterval derivative(FastInterval x) const override { return -Arcsine::derivative(x); }
  Curvature curvature(const Interval& x) const override { return odd_curvature(x, Curvature::concave); }
};

class Arctangent final : public UnivariateFunction {
 public:
  FastInterval value(FastInterval x) const override { return atan(x); }
  FastInterval derivative(FastInterval x) const override { return kOne / (kOne + sqr(x)); }
  Curvature curvature(const Interval& x) const override { return odd_curvature(x, Curvature::concave); }
  double tangent_point(double slope, const Interval& x) const override {
    return sign_of(x) * std::sqrt(1 / slope - 1);
  }
};

template <class Function>
const UnivariateFunction& the() {
  static const Function function;
  return function;
}

}  // namespace

const UnivariateFunction& sqrt_function() {
  static const RationalPower function(Rational(1, 2));
  return function;
}

const UnivariateFunction& cbrt_function() {
  static const RationalPower function(Rational(1, 3));
  return function;
}

const UnivariateFunction& exp_function() { return the<Exponential>(); }
const UnivariateFunction& log_function() { return the<Logarithm>(); }
const UnivariateFunction& sin_function() { return the<Sine>(); }
const UnivariateFunction& cos_function() { return the<Cosine>(); }
const UnivariateFunction& tan_function() { return the<Tangent>(); }
const UnivariateFunction& asin_function() { return the<Arcsine>(); }
const UnivariateFunction& acos_function() { return the<Arccosine>(); }
const UnivariateFunction& atan_function() { return the<Arctangent>(); }

FastInterval IntegerPower::value(FastInterval x) const { return n_ == 2 ? sqr(x) : pow(x, n_); }

FastInterval IntegerPower::derivative(FastInterval x) const {
  const FastInterval factor(static_cast<double>(n_));
  if (n_ == 2) return factor * x;
  if (n_ > std::numeric_limits<int>::min()) return factor * pow(x, n_ - 1);
  return factor * (pow(x, n_) / x);
}

Curvature IntegerPower::curvature(const Interval& x) const {
  if (n_ % 2 != 0) return odd_curvature(x, Curvature::convex);
  return n_ > 0 || x.lower >= 0 || x.upper <= 0 ? Curvature::convex : Curvature::mixed;
}

double IntegerPower::tangent_point(double slope, const Interval& x) const {
  const double size = std::fabs(slope / n_);
  const bool straddles = x.lower < 0 && x.upper > 0;
  const double sign = straddles ? std::copysign(1.0, slope) : sign_of(x);
  if (n_ == 2) return sign * size;
  if (n_ == 3) return sign * std::sqrt(size);
  if (n_ == -1) return sign / std::sqrt(size);
  const Rational inverse = 1 / (Rational(n_) - 1);
  return sign * elementary::pow(size, inverse, Ends::to_nearest).lower;
}

FastInterval RationalPower::value(FastInterval x) const {
  return exponent_ == Rational(1, 2) ? sqrt(x) : pow(x, exponent_);
}

FastInterval RationalPower::derivative(FastInterval x) const {
  if (exponent_ == Rational(1, 2)) return kOne / (FastInterval(2.0) * sqrt(x));
  return FastInterval(elementary::enclosing(exponent_)) * pow(x, exponent_ - 1);
}

Interval RationalPower::domain() const {
  return mpz_even_p(exponent_.get_den_mpz_t()) ? Interval(0, kInfinity) : Interval::entire();
}

Curvature RationalPower::curvature(const Interval& x) const {
  const Curvature right = exponent_ < 0 || exponent_ > 1 ? Curvature::convex : Curvature::concave;
  if (!mpz_even_p(exponent_.get_num_mpz_t())) return odd_curvature(x, right);
  return x.lower >= 0 || x.upper <= 0 ? right : Curvature::mixed;
}

double RationalPower::tangent_point(double slope, const Interval& x) const {
  const double size = std::fabs(slope / exponent_.get_d());
  if (exponent_ == Rational(1, 2)) return 1 / (4 * slope * slope);
  const Rational inverse = 1 / Rational(exponent_ - 1);
  return sign_of(x) * elementary::pow(size, inverse, Ends::to_nearest).lower;
}

}  // namespace gcslab
