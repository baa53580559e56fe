#include "spline/knot_vector.h"

#include <gtest/gtest.h>
#include <limits>

#include "interval/fast_interval.h"
#include "support/error_text.h"
#include "support/fuzz.h"
#include "support/random_spline.h"

namespace gcslab {
namespace {

using Doubles = std::vector<double>;

std::string complaint(int degree, const Doubles& knots) {
  return error_text([&] { KnotVector<double>(degree, knots); });
}

TEST(KnotVector, RefusesBadKnotsWithPlaceAndRemedy) {
  EXPECT_EQ(complaint(-1, {0, 1}), "degree -1: expected 0 at least");
  EXPECT_EQ(complaint(2, {0, 0, 0, 1, 1}), "knots: 5 given, expected at least 2d + 2 = 6 for degree 2");
  EXPECT_EQ(complaint(1, {0, 0, 2, 1, 3, 3}), "knot 3 is 1 after 2: expected knots that do not decrease");
  EXPECT_EQ(complaint(1, {0, 0, 1, 1, 1, 2, 2}),
            "knot 4: 1 occurs more than 2 times, the most that degree 1 allows");
  EXPECT_EQ(complaint(1, {0, 0, std::numeric_limits<double>::quiet_NaN(), 1}),
            "knot 2 is nan: expected a finite number");
  EXPECT_EQ(complaint(1, {0, 0, 1, std::numeric_limits<double>::infinity()}),
            "knot 3 is inf: expected a finite number");
  EXPECT_EQ(complaint(2, {0, 1, 2, 2, 3, 4}),
            "knots: the domain [2, 2] from knot 2 to knot 3 is empty: expected an end after its start");
}

TEST(KnotVector, RefusesSetsWithoutAnOrder) {
  const NumberTraits<FastInterval>::Scope scope;
  const auto complaint = error_text([] {
    KnotVector<FastInterval>(1, {FastInterval(0), FastInterval(0), FastInterval(0.5, 2), FastInterval(1),
                                 FastInterval(3), FastInterval(3)});
  });
  EXPECT_EQ(complaint, "knot 3 is [1, 1] after [0.5, 2]: expected knots that do not decrease");
}

TEST(KnotVector, RefusesParametersOutsideOfTheDomain) {
  const KnotVector<double> knots(1, {0, 0, 0.5, 1, 1});
  EXPECT_EQ(error_text([&] { return knots.find_span(1.5); }),
            "parameter 1.5 is outside of the domain [0, 1]");
  EXPECT_EQ(error_text([&] { return knots.find_span(-0.25); }),
            "parameter -0.25 is outside of the domain [0, 1]");
  EXPECT_EQ(error_text([&] { return knots.find_span(std::numeric_limits<double>::quiet_NaN()); }),
            "parameter nan is outside of the domain [0, 1]");
}

TEST(KnotVector, FindsTheSpanOfEveryParameter) {
  Random random(fuzz_seed(), "find_span");
  random_spline::for_every_multiplicity(random, 2, [&](const BSplineCurve<Rational>& curve) {
    const KnotVector<Rational>& knots = curve.knots;
    std::vector<Rational> parameters = random_spline::sample_parameters(knots);
    for (const auto& knot : knots.interior()) parameters.push_back(knot.value);
    for (const Rational& u : parameters) {
      const std::size_t k = knots.find_span(u);
      ASSERT_TRUE(knots[k] <= u && u < knots[k + 1]);
    }
    const std::size_t last = knots.find_span(knots.upper());
    ASSERT_TRUE(knots[last] < knots.upper() && knots[last + 1] == knots.upper());
  });
}

TEST(KnotVector, KnowsItsDistinctKnotsAndItsSpans) {
  const KnotVector<double> knots(3, {0, 0, 0, 0, 1, 2, 2, 3, 3, 3, 3});
  EXPECT_EQ(knots.size(), 7U);
  EXPECT_TRUE(knots.is_clamped());
  EXPECT_EQ(knots.spans(), (std::vector<std::size_t>{3, 4, 6}));
  ASSERT_EQ(knots.distinct().size(), 4U);
  EXPECT_EQ(knots.distinct()[2].multiplicity, 2);
  EXPECT_EQ(knots.distinct()[2].first, 5U);
  EXPECT_EQ(knots.interior().size(), 2U);
  EXPECT_EQ(knots.multiplicity(3.0), 4);
}

TEST(KnotVector, IsMadeUniformClampedOrNot) {
  EXPECT_EQ(clamped_uniform_knots(2, 2, 0.0, 1.0).knots(), (Doubles{0, 0, 0, 0.5, 1, 1, 1}));
  const KnotVector<double> uniform = uniform_knots(2, 3, 0.0, 1.0);
  EXPECT_EQ(uniform.knots(), (Doubles{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_FALSE(uniform.is_clamped());
  EXPECT_EQ(uniform.spans().size(), 3U);
  EXPECT_EQ(error_text([] { return clamped_uniform_knots(2, 0, 0.0, 1.0); }),
            "knots: 0 spans asked for, expected 1 at least");
}

TEST(KnotVector, HasGrevilleAbscissaeThatReproduceTheParameter) {
  Random random(fuzz_seed(), "greville");
  random_spline::for_every_multiplicity(random, 1, [&](const BSplineCurve<Rational>& curve) {
    Matrix<Rational> abscissae(curve.knots.size(), 1);
    const std::vector<Rational> greville = curve.knots.greville();
    std::copy(greville.begin(), greville.end(), abscissae.data());
    const BSplineCurve<Rational> identity(curve.knots, abscissae);
    for (const Rational& u : random_spline::sample_parameters(curve.knots))
      ASSERT_EQ(evaluate(identity, u)[0], u);
  });
}

}  // namespace
}  // namespace gcslab
