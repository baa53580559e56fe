// Algorithms that leave the curve where it is: exactly so in rationals, up to rounding in doubles.

#include <cmath>
#include <gtest/gtest.h>

#include "spline/degree.h"
#include "support/error_text.h"
#include "support/fuzz.h"
#include "support/random_spline.h"

namespace gcslab {
namespace {

using random_spline::for_every_multiplicity;
using random_spline::is_same_curve;
using random_spline::report_curve;
using Exact = BSplineCurve<Rational>;

/// Same knots and points.
bool equals(const Exact& a, const Exact& b) {
  return a.knots.knots() == b.knots.knots() && a.degree() == b.degree() && a.dimension() == b.dimension() &&
         std::equal(a.points.data(), a.points.data() + a.points.rows() * a.dimension(), b.points.data());
}

/// The largest distance of control points in a coordinate.
double distance(const BSplineCurve<double>& a, const Exact& b) {
  double result = 0;
  EXPECT_EQ(a.points.rows(), b.points.rows());
  for (std::size_t i = 0; i < a.points.rows() * a.dimension(); ++i)
    result = std::max(result, std::fabs(a.points.data()[i] - nearest_double(b.points.data()[i])));
  return result;
}

constexpr double kSize = 4;  // of the control polygons
constexpr double kUlp = 0x1p-52;

/// Random knots that a curve can take, sorted.
template <class T>
std::vector<T> insertable_knots(Random& random, const Exact& curve) {
  std::vector<Rational> knots;
  for (const DistinctKnot<Rational>& knot : curve.knots.interior()) {
    const int room = curve.degree() + 1 - knot.multiplicity;
    for (int i = static_cast<int>(random.integer(0, room)); i > 0; --i) knots.push_back(knot.value);
  }
  const Rational u = random_spline::parameter(random, curve.knots);
  if (curve.knots.multiplicity(u) == 0) {
    for (int i = static_cast<int>(random.integer(1, curve.degree() + 1)); i > 0; --i) knots.push_back(u);
  }
  std::vector<T> result;
  for (const Rational& knot : knots) result.push_back(converted_number<T>(knot));
  return result;
}

TEST(KnotInsertion, LeavesTheCurveWhereItIs) {
  Random random(fuzz_seed(), "insertion");
  for_every_multiplicity(random, 2, [&](const Exact& curve) {
    const std::vector<Rational> knots = insertable_knots<Rational>(random, curve);
    const Exact finer = refined(curve, knots);
    ASSERT_EQ(finer.points.rows(), curve.points.rows() + knots.size());
    ASSERT_TRUE(is_same_curve(curve, finer));
    Exact one_by_one = curve;
    for (const Rational& knot : knots) one_by_one = with_knot(one_by_one, knot);
    ASSERT_TRUE(equals(finer, one_by_one));
    std::vector<double> rounded;
    for (const Rational& knot : knots) rounded.push_back(nearest_double(knot));
    const double operations = static_cast<double>(knots.size());
    ASSERT_LE(distance(refined(converted<double>(curve), rounded), finer),
              4 * curve.degree() * (1 + operations) * kUlp * kSize);
  });
}

TEST(KnotInsertion, TakesKnotsAtTheEndsOfTheDomain) {
  Random random(fuzz_seed(), "clamping");
  for_every_multiplicity(random, 2, [&](const Exact& curve) {
    const Exact result = clamped(curve);
    ASSERT_TRUE(result.knots.is_clamped());
    ASSERT_TRUE(is_same_curve(curve, result));
    ASSERT_EQ(evaluate(curve, curve.knots.upper()), evaluate(result, curve.knots.upper()));
  });
}

TEST(KnotInsertion, RefusesWhatIsOutsideOrTooOften) {
  const auto curve = report_curve<double>();
  EXPECT_EQ(error_text([&] { with_knot(curve, 4.0); }), "parameter 4 is outside of the domain [0, 3]");
  EXPECT_EQ(error_text([&] { with_knot(curve, 1.0, 4); }), "knot 1 would occur 5 times, degree 3 allows 4");
  EXPECT_EQ(error_text([&] { with_knot(curve, 1.0, -1); }),
            "knot 1 to be inserted -1 times: expected 0 or more");
  EXPECT_EQ(error_text([&] { refined(curve, {std::nan("")}); }), "knots to insert: expected finite numbers");
}

TEST(Subdivision, GivesTheTwoPartsOfTheCurve) {
  Random random(fuzz_seed(), "subdivision");
  for_every_multiplicity(random, 2, [&](const Exact& curve) {
    Rational u = random_spline::parameter(random, curve.knots);
    if (random.below(2) == 0 || u == curve.knots.lower() || u == curve.knots.upper())
      u = curve.knots.interior().front().value;
    const auto [left, right] = subdivided(curve, u);
    ASSERT_EQ(left.knots.upper(), u);
    ASSERT_EQ(right.knots.lower(), u);
    ASSERT_TRUE(is_same_curve(curve, left) && is_same_curve(curve, right));
    const auto rounded = subdivided(converted<double>(curve), nearest_double(u));
    ASSERT_LE(distance(rounded.first, left), 4 * curve.degree() * (1 + 2 * curve.degree()) * kUlp * kSize);
  });
  EXPECT_EQ(error_text([] { subdivided(report_curve<double>(), 3.0); }),
            "subdivision at 3: expected a parameter strictly inside of the domain [0, 3]");
}

TEST(Subdivision, AtTheMiddleOfASingleSpanIsThatOfTheReport) {
  const auto [left, right] = subdivided(report_curve<Rational>(), Rational(5, 2));
  EXPECT_EQ(left.knots.knots().size(), 10U);  // k + d + 2 knots, k = 5
  EXPECT_EQ(right.knots.knots().size(), 8U);
}

TEST(BezierPieces, AreTheCurveAndGiveItBack) {
  Random random(fuzz_seed(), "bezier");
  for_every_multiplicity(random, 2, [&](const Exact& curve) {
    const auto pieces = bezier_pieces(curve);
    ASSERT_EQ(pieces.size(), curve.knots.spans().size());
    for (const auto& piece : pieces) ASSERT_TRUE(is_same_curve(curve, curve_of_piece(piece)));
    const auto back = curve_from_pieces<Rational>(pieces, 0);
    ASSERT_EQ(back.error_bound, 0);
    ASSERT_TRUE(equals(back.curve, clamped(curve)));
    const auto rounded = curve_from_pieces<double>(bezier_pieces(converted<double>(curve)), 1e-11);
    ASSERT_EQ(rounded.curve.knots.knots().size(), back.curve.knots.knots().size());
    ASSERT_LE(distance(rounded.curve, back.curve), 4 * curve.degree() * (1 + rounded.removed) * kUlp * kSize);
  });
}

TEST(KnotRemoval, UndoesInsertion) {
  Random random(fuzz_seed(), "removal");
  for_every_multiplicity(random, 2, [&](const Exact& curve) {
    Rational u = random_spline::parameter(random, curve.knots);
    if (u == curve.knots.lower() || u == curve.knots.upper()) u = curve.knots.interior().front().value;
    const int times = curve.degree() + 1 - curve.knots.multiplicity(u);
    const Exact finer = with_knot(curve, u, times);
    const auto back = without_knot<Rational>(finer, u, times, 0);
    ASSERT_EQ(back.removed, times);
    ASSERT_EQ(back.error_bound, 0);
    ASSERT_TRUE(equals(back.curve, curve));
    const auto rounded = without_knot(with_knot(converted<double>(curve), nearest_double(u), times),
                                      nearest_double(u), times, 1e-11);
    ASSERT_EQ(rounded.removed, times);
    ASSERT_LE(distance(rounded.curve, curve), 4 * curve.degree() * (1 + times) * kUlp * kSize);
  });
}

TEST(KnotRemoval, StaysWithinItsErrorBound) {
  Random random(fuzz_seed(), "removal_error");
  for_every_multiplicity(random, 1, [&](const Exact& curve) {
    const auto knot = curve.knots.interior().front();
    const auto coarser = without_knot<Rational>(curve, knot.value, knot.multiplicity, 1000);
    ASSERT_GT(coarser.removed, 0);
    ASSERT_EQ(coarser.curve.knots.knots().size() + static_cast<std::size_t>(coarser.removed),
              curve.knots.knots().size());
    for (const Rational& u : random_spline::sample_parameters(curve.knots)) {
      const std::vector<Rational> before = evaluate(curve, u);
      const std::vector<Rational> after = evaluate(coarser.curve, u);
      for (std::size_t c = 0; c < 2; ++c) ASSERT_LE(abs(Rational(before[c] - after[c])), coarser.error_bound);
    }
    const auto nothing = without_knot<Rational>(curve, knot.value, knot.multiplicity, 0);
    ASSERT_EQ(nothing.error_bound, 0);
  });
  EXPECT_EQ(error_text([] { without_knot(report_curve<double>(), 0.0, 1, 1.0); }),
            "removal of 0: expected a knot strictly inside of the domain [0, 3]");
  EXPECT_EQ(without_knot(report_curve<double>(), 1.0, 1, 1e-3).removed, 0);
}

TEST(DegreeElevation, LeavesTheCurveWhereItIsAndRaisesEachMultiplicity) {
  Random random(fuzz_seed(), "elevation");
  for_every_multiplicity(random, 1, [&](const Exact& curve) {
    const int by = static_cast<int>(random.integer(1, 3));
    const Exact higher = elevated(curve, by);
    ASSERT_EQ(higher.degree(), curve.degree() + by);
    ASSERT_TRUE(is_same_curve(curve, higher));
    ASSERT_TRUE(higher.knots.is_clamped());
    const auto before = curve.knots.interior();
    const auto after = higher.knots.interior();
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i)
      ASSERT_EQ(after[i].multiplicity, before[i].multiplicity + by);
    const double operations = static_cast<double>(by * (curve.degree() + by));
    ASSERT_LE(distance(elevated(converted<double>(curve), by), higher),
              4 * curve.degree() * operations * kUlp * kSize);
  });
  EXPECT_EQ(error_text([] { elevated(report_curve<double>(), -1); }),
            "degree elevation by -1: expected 0 or more");
}

TEST(DegreeElevation, OfTheReportsCurveFourTimesHasTheKnotsOfTheReport) {
  const Exact higher = elevated(report_curve<Rational>(), 4);
  EXPECT_EQ(higher.degree(), 7);
  EXPECT_EQ(higher.points.rows(), 18U);  // 6 points and 3 more an elevation
}

TEST(DegreeReduction, UndoesElevation) {
  Random random(fuzz_seed(), "reduction");
  for_every_multiplicity(random, 1, [&](const Exact& curve) {
    const auto back = reduced<Rational>(elevated(curve), 0);
    ASSERT_EQ(back.error_bound, 0);
    ASSERT_TRUE(equals(back.curve, clamped(curve)));
    const auto rounded = reduced(elevated(converted<double>(curve)), 1e-11);
    ASSERT_LE(distance(rounded.curve, back.curve), 4 * curve.degree() * (1 + rounded.removed) * kUlp * kSize);
  });
}

TEST(DegreeReduction, StaysWithinItsErrorBound) {
  Random random(fuzz_seed(), "reduction_error");
  for_every_multiplicity(random, 1, [&](const Exact& curve) {
    if (curve.degree() < 2) return;
    const auto lower = reduced<Rational>(curve, Rational(random.integer(0, 4)));
    ASSERT_EQ(lower.curve.degree(), curve.degree() - 1);
    for (const Rational& u : random_spline::sample_parameters(curve.knots)) {
      const std::vector<Rational> before = evaluate(curve, u);
      const std::vector<Rational> after = evaluate(lower.curve, u);
      for (std::size_t c = 0; c < 2; ++c) ASSERT_LE(abs(Rational(before[c] - after[c])), lower.error_bound);
    }
  });
  const BSplineCurve<double> line(KnotVector<double>(1, {0, 0, 1, 1}), Matrix<double>(2, 1));
  EXPECT_EQ(error_text([&] { reduced(line, 0.0); }),
            "degree reduction: the curve has degree 1, expected 2 at least");
}

}  // namespace
}  // namespace gcslab
