#include <cmath>
#include <gtest/gtest.h>

#include "spline/curve_intersection.h"
#include "spline/power_form.h"
#include "spline/subdivision.h"
#include "support/error_text.h"
#include "support/fuzz.h"
#include "support/random_spline.h"

namespace gcslab {
namespace {

using Rows = std::vector<std::vector<double>>;
using random_spline::report_curve;

BSplineCurve<double> bezier(const Rows& rows) {
  std::vector<double> knots(rows.size(), 0);
  knots.insert(knots.end(), rows.size(), 1);
  return BSplineCurve<double>(KnotVector<double>(static_cast<int>(rows.size()) - 1, knots),
                              matrix_of_rows(rows));
}

/// The polygon through the points, with knots 0, 1, 2, ....
BSplineCurve<double> polygon(const Rows& rows) {
  return BSplineCurve<double>(
      clamped_uniform_knots(1, rows.size() - 1, 0.0, static_cast<double>(rows.size() - 1)),
      matrix_of_rows(rows));
}

Rows transposed(Rows rows) {
  for (auto& row : rows) std::swap(row[0], row[1]);
  return rows;
}

void expect_on_both(const CurveIntersections& found, const BSplineCurve<double>& a,
                    const BSplineCurve<double>& b) {
  for (const CurveIntersection& at : found.points) {
    const auto p = evaluate(a, midpoint(at.first));
    const auto q = evaluate(b, midpoint(at.second));
    for (std::size_t c = 0; c < 2; ++c) {
      EXPECT_NEAR(p[c], midpoint(at.point[c]), 1e-12);
      EXPECT_NEAR(q[c], midpoint(at.point[c]), 1e-12);
      EXPECT_LE(width(at.point[c]), 1e-12);
    }
  }
}

void expect_distinct(const CurveIntersections& found) {
  for (std::size_t i = 0; i < found.points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_TRUE(disjoint(found.points[i].first, found.points[j].first) ||
                  disjoint(found.points[i].second, found.points[j].second));
  }
}

TEST(Intersections, OfACubicAndItsTransposeAreNine) {
  // y = 4 x^3 - 3 x, and the same with x and y exchanged: cos 9 a = cos a at x = cos a, nine numbers, of
  // which x = 1 and -1 are ends of both curves.
  const Rows rows = {{-1, -1}, {-1.0 / 3, 5}, {1.0 / 3, -5}, {1, 1}};
  const auto a = bezier(rows);
  const auto b = bezier(transposed(rows));
  const auto found = intersections(a, b);
  EXPECT_TRUE(found.is_complete());
  ASSERT_EQ(found.points.size(), 9U);
  std::vector<double> expected;
  for (int k = 0; k <= 4; ++k) expected.push_back(std::cos(k * std::numbers::pi / 4));
  for (int k = 1; k <= 4; ++k) expected.push_back(std::cos(k * std::numbers::pi / 5));
  std::ranges::sort(expected);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(midpoint(found.points[i].point[0]), expected[i], 1e-14);
  expect_on_both(found, a, b);
}

TEST(Intersections, StayTheSameNineWhenTheCurvesAreCutIntoPieces) {
  const Rows rows = {{-1, -1}, {-1.0 / 3, 5}, {1.0 / 3, -5}, {1, 1}};
  // Knots at 1/2, where both curves pass through (0, 0), and elsewhere.
  const auto a = refined(bezier(rows), {0.25, 0.5, 0.5, 0.5, 0.75});
  const auto b = refined(bezier(transposed(rows)), {0.125, 0.5, 0.5});
  const auto found = intersections(a, b);
  EXPECT_TRUE(found.is_complete());
  EXPECT_EQ(found.points.size(), 9U);
}

TEST(Intersections, AtVerticesAndKnotsAreCountedOnce) {
  const auto count = [](const Rows& a, const Rows& b) {
    const auto found = intersections(polygon(a), polygon(b));
    EXPECT_TRUE(found.is_complete());
    return found.points.size();
  };
  EXPECT_EQ(count({{0, 0}, {1, 1}, {2, 2}}, {{0, 2}, {1, 1}, {2, 0}}), 1U);  // two vertices cross
  EXPECT_EQ(count({{-1, 1}, {0, 0}, {1, 1}}, {{-2, 0}, {2, 0}}), 1U);        // a vertex touches a side
  EXPECT_EQ(count({{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}), 1U);                  // ends meet
  EXPECT_EQ(count({{0, 0}, {1, 0}, {1, 1}, {0, 0}}, {{0, 0}, {-1, -2}}),
            2U);  // a closed one: parameters 0 and 3
  EXPECT_EQ(count({{0, 0}, {3, 1}, {0, 2}, {3, 3}}, {{1, -1}, {1, 4}}), 3U);
}

TEST(Intersections, NextToAKnotAreCountedOnce) {
  // The curve passes through the line's middle up to rounding: before, after or at the knot u = 1.
  const auto curve = report_curve<double>();
  for (const double turn : {0.0, 0.5, 1.0, 2.0, 2.5}) {
    const auto p = evaluate(curve, 1.0);
    const double x = std::cos(turn) / 16;
    const double y = std::sin(turn) / 16;
    const auto line = polygon({{p[0] - x, p[1] - y}, {p[0] + x, p[1] + y}});
    const auto found = intersections(curve, line);
    EXPECT_TRUE(found.is_complete());
    ASSERT_EQ(found.points.size(), 1U) << turn;
    EXPECT_NEAR(midpoint(found.points[0].first), 1, 1e-14);
  }
}

TEST(Intersections, OfDisjointCurvesAreNone) {
  const auto curve = report_curve<double>();
  const auto above = polygon({{0, 2}, {2, 2}});
  EXPECT_TRUE(intersections(curve, above).points.empty());
  EXPECT_TRUE(intersections(curve, above).is_complete());
  // Control polygons cross, the curves do not: parabolas 1/64 apart at their vertices.
  const auto found = intersections(bezier({{-1, 1}, {0, -1}, {1, 1}}),
                                   bezier({{-1, -1 - 1.0 / 64}, {0, 1 - 1.0 / 64}, {1, -1 - 1.0 / 64}}));
  EXPECT_TRUE(found.points.empty());
  EXPECT_TRUE(found.is_complete());
}

TEST(Intersections, OfTangentCurvesAreUndecidedAtTheTangency) {
  const auto a = bezier({{-1, 1}, {0, -1}, {1, 1}});   // y = x^2
  const auto b = bezier({{-1, -1}, {0, 1}, {1, -1}});  // y = -x^2
  const auto found = intersections(a, b);
  EXPECT_FALSE(found.is_complete());
  EXPECT_TRUE(found.points.empty());
  for (const UndecidedIntersection& left : found.undecided) {
    EXPECT_NEAR(midpoint(left.first), 0.5, 1e-3);
    EXPECT_NEAR(midpoint(left.second), 0.5, 1e-3);
  }
  EXPECT_TRUE(std::ranges::any_of(found.undecided, [](const auto& left) {
    return contains(left.first, 0.5) && contains(left.second, 0.5);
  }));
}

TEST(Intersections, OfACommonArcAreUndecided) {
  const auto curve = bezier({{-1, 1}, {0, -1}, {1, 1}});
  const auto found = intersections(curve, curve);
  EXPECT_EQ(found.points.size(), 2U);  // the ends
  ASSERT_EQ(found.undecided.size(), 1U);
  EXPECT_EQ(found.undecided[0].reason, "the two pieces lie on one curve: they may have an arc in common");
  EXPECT_EQ(found.undecided[0].first, Interval(0, 1));
  // Parts of one curve that meet in an arc: [1/4, 3/4] and [1/2, 1], both without rounding.
  const auto exact = converted<Rational>(curve);
  const auto part = [&](long from, long to) {
    return converted<double>(restricted(exact, Rational(Rational(from) / 4), Rational(Rational(to) / 4)));
  };
  const auto parts = intersections(part(1, 3), part(2, 4));
  ASSERT_EQ(parts.undecided.size(), 1U);
  EXPECT_TRUE(subset(Interval(0.5, 0.75), parts.undecided[0].first));
  EXPECT_TRUE(subset(Interval(0.5, 0.75), parts.undecided[0].second));
  EXPECT_EQ(parts.points.size(), 2U);
  // The report's curve with itself: an arc a span, and no more.
  const auto report = report_curve<double>();
  const auto itself = intersections(report, report);
  EXPECT_FALSE(itself.is_complete());
  for (const UndecidedIntersection& left : itself.undecided)
    EXPECT_NEAR(midpoint(left.first), midpoint(left.second), 0.1);
}

/// How often the curve crosses a segment: the roots of its signed distance, exactly.
std::size_t crossings(const BSplineCurve<double>& curve, const std::vector<double>& from,
                      const std::vector<double>& to) {
  const Rational dx = rational_from_double(to[0]) - rational_from_double(from[0]);
  const Rational dy = rational_from_double(to[1]) - rational_from_double(from[1]);
  const Rational x0 = rational_from_double(from[0]);
  const Rational y0 = rational_from_double(from[1]);
  std::size_t count = 0;
  for (const ExactPiece& piece : exact_pieces(converted<Rational>(curve))) {
    const auto& forms = piece.coordinates;
    const auto combination = [&](const Rational& a, const Rational& b) {  // a (x - x0) + b (y - y0)
      return sum(sum(product(forms[0], {a}), product(forms[1], {b})), {Rational(-a * x0 - b * y0)});
    };
    for (const RationalInterval& t : unit_roots(combination(dy, Rational(-dx)), 80)) {
      const RationalInterval along = range_on(combination(dx, dy), t);
      if (along.lower > 0 && along.upper < dx * dx + dy * dy) ++count;
    }
  }
  return count;
}

TEST(Intersections, WithSegmentsAreAsManyAsTheRootsOfTheDistance) {
  Random random(fuzz_seed(), "segments");
  for (std::size_t i = 0; i < fuzz_cases(40); ++i) {
    const int degree = static_cast<int>(random.integer(2, 5));
    const auto curve =
        converted<double>(random_spline::curve(random, degree, 1 + static_cast<int>(random.below(2))));
    const std::vector<double> from = {random.uniform(-4, 4), random.uniform(-4, 4)};
    const std::vector<double> to = {random.uniform(-4, 4), random.uniform(-4, 4)};
    const auto line = polygon({from, to});
    const auto found = intersections(curve, line);
    EXPECT_TRUE(found.is_complete()) << i;
    EXPECT_EQ(found.points.size(), crossings(curve, from, to)) << i;
    expect_on_both(found, curve, line);
  }
}

/// Crossings of fine polygons along two curves.
std::vector<std::pair<double, double>> sampled_crossings(const BSplineCurve<double>& a,
                                                         const BSplineCurve<double>& b) {
  constexpr int kSides = 400;
  const auto samples = [](const BSplineCurve<double>& curve) {
    std::vector<std::vector<double>> result;
    for (int i = 0; i <= kSides; ++i) result.push_back(evaluate(curve, 3.0 * i / kSides));
    return result;
  };
  const auto p = samples(a);
  const auto q = samples(b);
  const auto turn = [](const auto& x, const auto& y, const auto& z) {
    return (y[0] - x[0]) * (z[1] - x[1]) - (y[1] - x[1]) * (z[0] - x[0]);
  };
  std::vector<std::pair<double, double>> result;
  for (std::size_t i = 0; i < kSides; ++i) {
    for (std::size_t j = 0; j < kSides; ++j) {
      if (turn(p[i], p[i + 1], q[j]) * turn(p[i], p[i + 1], q[j + 1]) < 0 &&
          turn(q[j], q[j + 1], p[i]) * turn(q[j], q[j + 1], p[i + 1]) < 0)
        result.emplace_back(3.0 * (static_cast<double>(i) + 0.5) / kSides,
                            3.0 * (static_cast<double>(j) + 0.5) / kSides);
    }
  }
  return result;
}

TEST(Intersections, OfRandomCubicSplinesLeaveOutNoneOfFinePolygons) {
  Random random(fuzz_seed(), "splines");
  for (std::size_t i = 0; i < fuzz_cases(8); ++i) {
    const auto make = [&] {
      const auto points = random_spline::points(random, 6, 2);
      return converted<double>(BSplineCurve<Rational>(report_curve<Rational>().knots, points));
    };
    const auto a = make();
    const auto b = make();
    const auto found = intersections(a, b);
    EXPECT_TRUE(found.is_complete()) << i;
    expect_on_both(found, a, b);
    const auto sampled = sampled_crossings(a, b);
    EXPECT_GE(found.points.size(), sampled.size()) << i;
    expect_distinct(found);
    for (const auto& [u, v] : sampled) {
      EXPECT_TRUE(std::ranges::any_of(found.points,
                                      [&, u = u, v = v](const CurveIntersection& at) {
                                        return std::fabs(midpoint(at.first) - u) < 0.02 &&
                                               std::fabs(midpoint(at.second) - v) < 0.02;
                                      }))
          << i << ": " << u << ' ' << v;
    }
  }
}

/// The circle about (x, 0) by four quarters of weights (1, 1, 2), all of it exact in doubles.
RationalCurve<double> circle(double x) {
  Matrix<double> rows(9, 3);
  const double corners[9][3] = {{1, 0, 1},   {1, 1, 1},  {0, 2, 2},  {-1, 1, 1}, {-1, 0, 1},
                                {-1, -1, 1}, {0, -2, 2}, {1, -1, 1}, {1, 0, 1}};
  for (std::size_t i = 0; i < 9; ++i) {
    rows(i, 0) = corners[i][0] + x * corners[i][2];
    rows(i, 1) = corners[i][1];
    rows(i, 2) = corners[i][2];
  }
  return RationalCurve<double>(
      BSplineCurve<double>(KnotVector<double>(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}), rows));
}

TEST(Intersections, OfRationalCirclesAreKnown) {
  const auto two = intersections(circle(0), circle(1));
  EXPECT_TRUE(two.is_complete());
  ASSERT_EQ(two.points.size(), 2U);
  for (const CurveIntersection& at : two.points) {
    EXPECT_NEAR(midpoint(at.point[0]), 0.5, 1e-14);
    EXPECT_NEAR(std::fabs(midpoint(at.point[1])), std::sqrt(0.75), 1e-14);
  }
  EXPECT_TRUE(intersections(circle(0), circle(2.25)).points.empty());
  const auto diagonal = intersections(circle(0), polygon({{-2, -2}, {2, 2}}));
  EXPECT_TRUE(diagonal.is_complete());
  ASSERT_EQ(diagonal.points.size(), 2U);
  for (const CurveIntersection& at : diagonal.points)
    EXPECT_NEAR(std::fabs(midpoint(at.point[0])), std::sqrt(0.5), 1e-14);
  // Through ends of arcs: (1, 0) is met at parameters 0 and 4, (-1, 0) at 2.
  const auto axis = intersections(circle(0), polygon({{-2, 0}, {2, 0}}));
  EXPECT_TRUE(axis.is_complete());
  EXPECT_EQ(axis.points.size(), 3U);
}

TEST(Intersections, AreAskedOfPlaneCurves) {
  const BSplineCurve<double> space(KnotVector<double>(1, {0, 0, 1, 1}), Matrix<double>(2, 3));
  EXPECT_EQ(error_text([&] { intersections(space, space); }),
            "intersection: a curve has 3 coordinates, expected 2");
}

}  // namespace
}  // namespace gcslab
