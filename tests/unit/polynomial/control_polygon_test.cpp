// Crossings of control polygons against exact rational geometry and polynomials with known zeros.

#include "polynomial/control_polygon.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "interval/elementary.h"
#include "polynomial/exact_conversion.h"
#include "support/fuzz.h"
#include "support/random_polynomial.h"

namespace gcslab {
namespace {

struct RationalPoint {
  Rational t, value;
};

/// The part of the axis in the convex hull of points, by all segments between two of them.
std::vector<Rational> exact_crossings(const std::vector<RationalPoint>& points) {
  std::vector<Rational> crossings;
  for (const RationalPoint& p : points) {
    for (const RationalPoint& q : points) {
      if (p.value == 0) crossings.push_back(p.t);
      if (p.value > 0 && q.value < 0)
        crossings.push_back(p.t + (q.t - p.t) * Rational(p.value / (p.value - q.value)));
    }
  }
  if (crossings.empty()) return {};
  const auto [least, largest] = std::minmax_element(crossings.begin(), crossings.end());
  return {*least, *largest};
}

TEST(ControlPolygon, HullCrossingsAreTheExactOnesRoundedOutward) {
  Random random(fuzz_seed(), "hull_crossings");
  for (std::size_t i = 0; i < fuzz_cases(5000); ++i) {
    const int degree = static_cast<int>(random.integer(1, 6));
    std::vector<Interval> coefficients;
    std::vector<RationalPoint> points;
    for (int j = 0; j <= degree; ++j) {
      const double a =
          random.below(3) == 0 ? static_cast<double>(random.integer(-2, 2)) : random.uniform(-1, 2);
      const double b = random.below(2) == 0 ? a : a + random.unit();
      coefficients.emplace_back(a, b);
      Rational t(j, degree);
      t.canonicalize();
      points.push_back({t, rational_from_double(a)});
      points.push_back({t, rational_from_double(b)});
    }
    const Interval found = hull_crossings(coefficients);
    const std::vector<Rational> exact = exact_crossings(points);
    ASSERT_EQ(is_empty(found), exact.empty());
    if (exact.empty()) continue;
    ASSERT_TRUE(encloses(found, exact.front()) && encloses(found, exact.back()));
    ASSERT_NEAR(found.lower, exact.front().get_d(), 1e-13);
    ASSERT_NEAR(found.upper, exact.back().get_d(), 1e-13);
  }
}

std::vector<Interval> enclosed(const std::vector<Rational>& exact) {
  std::vector<Interval> result;
  for (const Rational& value : exact) result.push_back(elementary::enclosing(value));
  return result;
}

TEST(ControlPolygon, PolynomialCrossingsKeepEveryZeroAndReachTheOuterOnes) {
  Random random(fuzz_seed(), "polynomial_crossings");
  for (std::size_t i = 0; i < fuzz_cases(2000); ++i) {
    Polynomial p = Polynomial::constant(1, 1);
    std::vector<Rational> zeros;
    for (std::int64_t k = random.integer(1, 4); k > 0; --k) {
      zeros.emplace_back(Rational(random.integer(0, 96)) / 96);
      p = p * (Polynomial::variable(1, 0) - Polynomial::constant(1, zeros.back()));
    }
    const auto coefficients = enclosed(exact_bernstein_coefficients(p, {{0, 1}}).coefficients());
    const Interval found = polynomial_crossings(coefficients);
    for (const Rational& zero : zeros) ASSERT_TRUE(encloses(found, zero)) << to_string(found);
    ASSERT_TRUE(subset(found, hull_crossings(coefficients)));
    const auto [least, largest] = std::minmax_element(zeros.begin(), zeros.end());
    ASSERT_LT(least->get_d() - found.lower, 0.2);
    ASSERT_LT(found.upper - largest->get_d(), 0.2);
    ASSERT_TRUE(zeros.size() > 1 || width(found) < 1e-14) << to_string(found);
  }
}

TEST(ControlPolygon, WithoutASignChangeThereIsNoCrossing) {
  const std::vector<Interval> positive = {{1, 2}, {0.25, 3}, {0.5, 0.5}};
  EXPECT_TRUE(is_empty(hull_crossings(positive)));
  EXPECT_TRUE(is_empty(polynomial_crossings(positive)));
  // x^2 - x + 5/16 has no zero, but its coefficients 5/16, -3/16, 5/16 change their sign.
  const std::vector<Interval> dipping = {5.0 / 16, -3.0 / 16, 5.0 / 16};
  EXPECT_FALSE(is_empty(hull_crossings(dipping)));
  EXPECT_TRUE(is_empty(polynomial_crossings(dipping)));
}

TEST(ControlPolygon, OneCoefficientAndUnboundedOnes) {
  for (const auto crossings : {&hull_crossings, &polynomial_crossings}) {
    EXPECT_EQ(crossings(std::vector<Interval>{{-1, 1}}), Interval(0, 1));
    EXPECT_TRUE(is_empty(crossings(std::vector<Interval>{{1, 2}})));
    EXPECT_EQ(crossings(std::vector<Interval>{{1, 2}, Interval::entire()}), Interval(0, 1));
  }
}

}  // namespace
}  // namespace gcslab
