#include "spline/rational_curve.h"

#include <cmath>
#include <gtest/gtest.h>

#include "interval/fast_interval.h"
#include "support/error_text.h"
#include "support/fuzz.h"
#include "support/random_spline.h"

namespace gcslab {
namespace {

/// A quarter of the unit circle with rational weights: (1 - t^2, 2t) / (1 + t^2) (Piegl, Tiller 1997, 7.2).
template <class T>
RationalCurve<T> quarter_circle() {
  const auto n = [](long x) { return whole_number<T>(x); };
  return rational_curve<T>(KnotVector<T>(2, {n(0), n(0), n(0), n(1), n(1), n(1)}),
                           matrix_of_rows<T>({{n(1), n(0)}, {n(1), n(1)}, {n(0), n(1)}}), {n(1), n(1), n(2)});
}

/// The unit circle by four arcs with weights 1 and sqrt(1/2).
RationalCurve<double> circle() {
  const double w = std::sqrt(0.5);
  return rational_curve<double>(
      KnotVector<double>(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}),
      matrix_of_rows<double>({{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}}),
      {1, w, 1, w, 1, w, 1, w, 1});
}

RationalCurve<Rational> random_rational_curve(Random& random, const BSplineCurve<Rational>& curve) {
  std::vector<Rational> weights;
  for (std::size_t i = 0; i < curve.points.rows(); ++i) {
    weights.emplace_back(static_cast<long>(random.integer(1, 32)), 8);
    weights.back().canonicalize();
  }
  return rational_curve(curve.knots, curve.points, weights);
}

TEST(RationalCurve, IsAnExactCircle) {
  const auto quarter = quarter_circle<Rational>();
  for (int i = 0; i <= 12; ++i) {
    Rational u(i, 12);
    u.canonicalize();
    const std::vector<Rational> p = evaluate(quarter, u);
    EXPECT_EQ(p[0] * p[0] + p[1] * p[1], 1);
    EXPECT_EQ(p[0] * (1 + u * u), 1 - u * u);
  }
}

TEST(RationalCurve, IsACircleUpToRoundingInDoubles) {
  const auto curve = circle();
  for (int i = 0; i <= 4000; ++i) {
    const std::vector<double> p = evaluate(curve, i / 1000.0);
    ASSERT_NEAR(std::hypot(p[0], p[1]), 1, 8 * 0x1p-53);
  }
  std::vector<double> parameters;
  for (int i = 0; i <= 4000; ++i) parameters.push_back(i / 1000.0);
  const Matrix<double> values = evaluate_on_grid<double>(curve, parameters);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    ASSERT_NEAR(std::hypot(values(i, 0), values(i, 1)), 1, 8 * 0x1p-53);
    ASSERT_NEAR(values(i, 0), evaluate(curve, parameters[i])[0], 16 * 0x1p-53);
  }
}

TEST(RationalCurve, EnclosesTheCircleInIntervals) {
  const NumberTraits<FastInterval>::Scope scope;
  const auto quarter = quarter_circle<FastInterval>();
  const std::vector<FastInterval> p = evaluate(quarter, FastInterval(0.25, 0.26));
  EXPECT_TRUE(contains(p[0].interval(), (1 - 0.0625) / (1 + 0.0625)));
  EXPECT_TRUE(contains(p[1].interval(), 0.5 / (1 + 0.0625)));
  EXPECT_LE(width(p[0].interval()), 0.2);
}

TEST(RationalCurve, HasTheDerivativesOfTheCircle) {
  const Matrix<Rational> rows = derivatives(quarter_circle<Rational>(), Rational(1, 2), 3);
  // x = 2 / (1 + t^2) - 1 has x' = -4t / (1 + t^2)^2, x'' = 4 (3t^2 - 1) / (1 + t^2)^3, x''' = 48 t (1 - t^2)
  // / (1 + t^2)^4.
  EXPECT_EQ(rows(1, 0), Rational(-32, 25));
  EXPECT_EQ(rows(2, 0), Rational(-64, 125));
  EXPECT_EQ(rows(3, 0), Rational(4608, 625));
  EXPECT_EQ(rows(0, 0) * rows(1, 0) + rows(0, 1) * rows(1, 1), 0);  // a tangent of the circle
}

TEST(RationalCurve, StaysWhereItIsWhenKnotsAndDegreeChange) {
  Random random(fuzz_seed(), "rational_curve");
  random_spline::for_every_multiplicity(random, 1, [&](const BSplineCurve<Rational>& plain) {
    const auto curve = random_rational_curve(random, plain);
    const Rational u = plain.knots.interior().front().value;
    const auto [left, right] = subdivided(curve, u);
    const auto higher = elevated(curve);
    const auto finer = refined(curve, std::vector<Rational>{plain.knots.lower() + Rational(1, 64)});
    for (const Rational& at : random_spline::sample_parameters(plain.knots)) {
      const std::vector<Rational> value = evaluate(curve, at);
      ASSERT_EQ(value, evaluate(higher, at));
      ASSERT_EQ(value, evaluate(finer, at));
      ASSERT_EQ(value, evaluate(at < u ? left : right, at));
    }
    ASSERT_EQ(evaluate(restricted(curve, plain.knots.lower(), u), plain.knots.lower()),
              evaluate(curve, plain.knots.lower()));
  });
}

TEST(RationalCurve, WithEqualWeightsIsThePolynomialOne) {
  Random random(fuzz_seed(), "equal_weights");
  const auto plain = random_spline::curve(random, 4, 2);
  const auto curve = rational_curve(plain.knots, plain.points, std::vector<Rational>(plain.points.rows(), 3));
  for (const Rational& u : random_spline::sample_parameters(plain.knots)) {
    const Matrix<Rational> a = derivatives(plain, u, 3);
    const Matrix<Rational> b = derivatives(curve, u, 3);
    EXPECT_TRUE(std::equal(a.data(), a.data() + 8, b.data()));
  }
}

TEST(RationalCurve, RefusesBadWeights) {
  const KnotVector<double> knots(1, {0, 0, 1, 1});
  const Matrix<double> points(2, 2);
  const auto with = [&](const std::vector<double>& weights) {
    return error_text([&] { rational_curve(knots, points, weights); });
  };
  EXPECT_EQ(with({1, 0}), "weight 1 is 0, expected a positive number");
  EXPECT_EQ(with({-2, 1}), "weight 0 is -2, expected a positive number");
  EXPECT_EQ(with({1}), "1 weights given, expected 2, one a control point");
  EXPECT_EQ(with({1, std::nan("")}), "control point 1: coordinate 0 is nan, expected a finite number");
  EXPECT_EQ(error_text([] { evaluate(circle(), 4.5); }), "parameter 4.5 is outside of the domain [0, 4]");
}

}  // namespace
}  // namespace gcslab
