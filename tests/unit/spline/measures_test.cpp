// Lengths, curvatures, boxes, hulls and closest points.

#include <cmath>
#include <gtest/gtest.h>

#include "interval/fast_interval.h"
#include "spline/bounding_box.h"
#include "spline/closest_point.h"
#include "spline/curve_measures.h"
#include "support/error_text.h"
#include "support/fuzz.h"
#include "support/random_spline.h"

namespace gcslab {
namespace {

using random_spline::report_curve;

/// Clamped on [0, 1].
template <class T = double>
BSplineCurve<T> bezier(const std::vector<std::vector<T>>& rows) {
  std::vector<T> knots(rows.size(), whole_number<T>(0));
  knots.insert(knots.end(), rows.size(), whole_number<T>(1));
  return BSplineCurve<T>(KnotVector<T>(static_cast<int>(rows.size()) - 1, knots), matrix_of_rows(rows));
}

RationalCurve<double> circle_of_radius(double r) {
  const double w = std::sqrt(0.5);
  return rational_curve<double>(
      KnotVector<double>(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}),
      matrix_of_rows<double>({{r, 0}, {r, r}, {0, r}, {-r, r}, {-r, 0}, {-r, -r}, {0, -r}, {r, -r}, {r, 0}}),
      {1, w, 1, w, 1, w, 1, w, 1});
}

TEST(ArcLength, OfSegmentParabolaCuspAndCircleIsKnown) {
  EXPECT_NEAR(arc_length(bezier({{0, 0}, {3, 4}}), 1e-12).value, 5, 1e-14);
  // y = x^2 on [0, 1]: sqrt(5) / 2 + asinh(2) / 4.
  EXPECT_NEAR(arc_length(bezier({{0, 0}, {0.5, 0}, {1, 1}}), 1e-12).value,
              std::sqrt(5.0) / 2 + std::asinh(2.0) / 4, 1e-13);
  // (t^2, t^3), a cusp at an end: (13^1.5 - 8) / 27; |t| from -1 to 1, a cusp inside.
  EXPECT_NEAR(arc_length(bezier({{0, 0}, {0, 0}, {1.0 / 3, 0}, {1, 1}}), 1e-12).value,
              (std::pow(13, 1.5) - 8) / 27, 1e-13);
  EXPECT_NEAR(arc_length(bezier({{1, 0}, {-1, 0}, {1, 0}}), 1e-10).value, 2, 1e-10);
  EXPECT_NEAR(arc_length(circle_of_radius(2), 1e-12).value, 4 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(arc_length(circle_of_radius(2), 0.0, 1.0, 1e-12).value, std::numbers::pi, 1e-12);
}

TEST(ArcLength, IsAddedUpOfPartsAndStaysWithTheCurve) {
  const auto curve = report_curve<double>();
  const double whole = arc_length(curve, 1e-12).value;
  EXPECT_NEAR(arc_length(curve, 0.0, 1.3, 1e-12).value + arc_length(curve, 1.3, 3.0, 1e-12).value, whole,
              1e-12);
  EXPECT_NEAR(arc_length(elevated(curve, 2), 1e-12).value, whole, 1e-12);
  // Chords of a dense polygon fall short by O(h^2).
  double chords = 0;
  for (int i = 0; i < 10000; ++i) {
    const auto a = evaluate(curve, 3.0 * i / 10000);
    const auto b = evaluate(curve, 3.0 * (i + 1) / 10000);
    chords += std::hypot(a[0] - b[0], a[1] - b[1]);
  }
  EXPECT_LE(chords, whole);
  EXPECT_NEAR(chords, whole, 1e-6);
}

TEST(ArcLength, RefusesBadRequests) {
  const auto curve = report_curve<double>();
  EXPECT_EQ(error_text([&] { arc_length(curve, 0.0); }), "tolerance 0: expected a positive number");
  EXPECT_EQ(error_text([&] { arc_length(curve, 2.0, 1.0, 0.1); }),
            "length from 2 to 1: expected an end after its start");
  EXPECT_EQ(error_text([&] { arc_length(curve, 2.0, 4.0, 0.1); }),
            "parameter 4 is outside of the domain [0, 3]");
}

TEST(Curvature, OfACircleIsTheInverseRadius) {
  const auto circle = circle_of_radius(2);
  for (int i = 0; i <= 40; ++i) {
    EXPECT_NEAR(signed_curvature(circle, i / 10.0), 0.5, 1e-13);
    EXPECT_NEAR(curvature(circle, i / 10.0), 0.5, 1e-13);
  }
}

TEST(Curvature, OfParabolaTwistedCubicAndInflectionIsKnown) {
  const auto parabola = bezier({{-1, 1}, {0, -1}, {1, 1}});  // y = x^2
  EXPECT_NEAR(signed_curvature(parabola, 0.5), 2, 1e-14);
  EXPECT_NEAR(signed_curvature(bezier({{1, 1}, {0, -1}, {-1, 1}}), 0.5), -2, 1e-14);
  // (t, t^2, t^3) at 0: 2.
  EXPECT_NEAR(curvature(bezier({{0, 0, 0}, {1.0 / 3, 0, 0}, {2.0 / 3, 1.0 / 3, 0}, {1, 1, 1}}), 0.0), 2,
              1e-13);
  const NumberTraits<FastInterval>::Scope scope;
  const auto enclosed = converted<FastInterval>(parabola);
  EXPECT_TRUE(contains(signed_curvature(enclosed, FastInterval(0.5)).interval(), 2));
}

TEST(Curvature, IsNotDefinedWhereTheCurveStands) {
  EXPECT_EQ(error_text([] {
              curvature(bezier({{0, 0}, {0, 0}, {1, 0}, {1, 1}}), 0.0);
            }),
            "curvature at parameter 0: the first derivative vanishes there");
  EXPECT_EQ(error_text([] {
              signed_curvature(bezier({{0, 0, 0}, {1, 0, 0}}), 0.0);
            }),
            "signed curvature: the curve has 3 coordinates, expected 2");
}

TEST(BoundingBox, IsTightAndInsideOfTheControlBox) {
  Random random(fuzz_seed(), "bounding_box");
  random_spline::for_every_multiplicity(random, 1, [&](const BSplineCurve<Rational>& curve) {
    const Box tight = bounding_box(curve);
    const Box control = control_box(curve);
    Box seen(2);
    const auto rounded = converted<double>(curve);
    const double lower = rounded.knots.lower();
    const double length = rounded.knots.upper() - lower;
    for (int i = 0; i <= 2000; ++i) {
      const auto p = evaluate(rounded, std::min(lower + length * i / 2000, rounded.knots.upper()));
      for (std::size_t c = 0; c < 2; ++c) seen[c] = hull(seen[c], p[c]);
    }
    for (const auto& knot : rounded.knots.interior()) {  // both ends at jumps
      const auto before = evaluate(restricted(rounded, lower, knot.value), knot.value);
      const auto after = evaluate(rounded, knot.value);
      for (std::size_t c = 0; c < 2; ++c) seen[c] = hull(seen[c], hull(before[c], after[c]));
    }
    for (std::size_t c = 0; c < 2; ++c) {
      ASSERT_TRUE(subset(tight[c], control[c]));
      ASSERT_LE(tight[c].lower, seen[c].lower + 1e-13);
      ASSERT_GE(tight[c].upper, seen[c].upper - 1e-13);
      ASSERT_NEAR(tight[c].lower, seen[c].lower, 0.02);
      ASSERT_NEAR(tight[c].upper, seen[c].upper, 0.02);
    }
  });
}

TEST(BoundingBox, OfAParabolaIsExact) {
  const Box box = bounding_box(bezier({{-1, 1}, {0, -1}, {1, 1}}));
  EXPECT_EQ(box[0], Interval(-1, 1));
  EXPECT_EQ(box[1], Interval(0, 1));
}

TEST(BoundingBox, OfARationalCircleIsItsSquare) {
  const Box box = bounding_box(restricted(circle_of_radius(2), 0.5, 3.25));
  EXPECT_NEAR(box[0].lower, -2, 1e-15);
  EXPECT_EQ(box[1].upper, 2);
  EXPECT_EQ(box[1].lower, -2);
  EXPECT_NEAR(box[0].upper, std::sqrt(2.0), 1e-14);
}

TEST(ConvexHull, ContainsWhatItShould) {
  const auto square =
      matrix_of_rows<Rational>({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {Rational(1, 2), Rational(1, 2)}});
  const auto inside = [&](const Rational& x, const Rational& y) {
    return is_in_convex_hull(square, std::vector<Rational>{x, y});
  };
  EXPECT_TRUE(inside(Rational(1, 2), Rational(1, 3)));
  EXPECT_TRUE(inside(1, Rational(1, 3)));
  EXPECT_TRUE(inside(0, 0));
  EXPECT_FALSE(inside(Rational(1000001, 1000000), Rational(1, 2)));
  EXPECT_FALSE(inside(2, 0));
  const auto segment = matrix_of_rows<Rational>({{0, 0}, {1, 1}, {2, 2}});
  EXPECT_TRUE(is_in_convex_hull(segment, std::vector<Rational>{Rational(3, 2), Rational(3, 2)}));
  EXPECT_FALSE(is_in_convex_hull(segment, std::vector<Rational>{3, 3}));
}

TEST(ConvexHull, PropertyHoldsForEveryCurve) {
  Random random(fuzz_seed(), "convex_hull");
  random_spline::for_every_multiplicity(random, 1, [&](const BSplineCurve<Rational>& curve) {
    for (int i = 0; i < 4; ++i)
      ASSERT_TRUE(has_convex_hull_property(curve, random_spline::parameter(random, curve.knots)));
  });
}

TEST(ClosestPoint, IsNoFartherThanAnyOfDenseSamples) {
  Random random(fuzz_seed(), "closest");
  for (int degree = 1; degree <= 5; ++degree) {
    const auto curve = converted<double>(
        random_spline::curve(random, degree, 1 + static_cast<int>(random.below(3)) % degree));
    const std::vector<double> target = {random.uniform(-6, 6), random.uniform(-6, 6)};
    double sampled = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 20000; ++i) {
      const double u = std::min(curve.knots.lower() + (curve.knots.upper() - curve.knots.lower()) * i / 20000,
                                curve.knots.upper());
      const auto p = evaluate(curve, u);
      sampled = std::min(sampled, std::hypot(p[0] - target[0], p[1] - target[1]));
    }
    const auto found = closest_points(curve, target);
    ASSERT_FALSE(found.empty());
    for (const ClosestPoint& closest : found) {
      ASSERT_LE(closest.distance.lower, sampled + 1e-12);
      ASSERT_GE(closest.distance.upper, sampled - 1e-2);
      ASSERT_LE(width(closest.distance), 1e-12);
      if (curve.knots.multiplicity(midpoint(closest.parameter)) > degree) continue;  // before or after a jump
      const auto p = evaluate(curve, midpoint(closest.parameter));
      ASSERT_NEAR(p[0], midpoint(closest.point[0]), 1e-11);
      ASSERT_NEAR(std::hypot(p[0] - target[0], p[1] - target[1]), midpoint(closest.distance), 1e-11);
    }
  }
}

TEST(ClosestPoint, ListsAllThatAreEquallyClose) {
  const auto parabola = bezier({{-1, 1}, {0, -1}, {1, 1}});  // y = x^2
  const auto both = closest_points(parabola, std::vector<double>{0, 1});
  ASSERT_EQ(both.size(), 2U);  // x^2 = 1/2
  EXPECT_NEAR(midpoint(both[0].point[0]), -std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(midpoint(both[1].point[0]), std::sqrt(0.5), 1e-15);
  EXPECT_TRUE(contains(both[0].distance, std::sqrt(3.0) / 2));
  const auto vertex = closest_points(parabola, std::vector<double>{0, -1});
  ASSERT_EQ(vertex.size(), 1U);
  EXPECT_EQ(vertex[0].parameter, Interval(0.5));
  EXPECT_EQ(vertex[0].distance, Interval(1));
  // Within a tolerance the vertex and both ends count too: 1 against sqrt(3) / 2.
  EXPECT_EQ(closest_points(parabola, std::vector<double>{0, 1}, 0.13).size(), 2U);
  EXPECT_EQ(closest_points(parabola, std::vector<double>{0, 1}, 0.14).size(), 5U);
}

TEST(ClosestPoint, OfARationalCircleLiesOnTheRay) {
  const auto found = closest_points(circle_of_radius(2), std::vector<double>{3, 4});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(midpoint(found[0].distance), 3, 1e-14);
  EXPECT_NEAR(midpoint(found[0].point[0]), 1.2, 1e-14);
  EXPECT_NEAR(midpoint(found[0].point[1]), 1.6, 1e-14);
}

TEST(ClosestPoint, AtAPointOfTheCurveHasDistanceZeroOnce) {
  const auto curve = report_curve<double>();
  const auto at_knot = closest_points(bezier({{0, 0}, {1, 2}}), std::vector<double>{0, 0});
  ASSERT_EQ(at_knot.size(), 1U);
  EXPECT_EQ(at_knot[0].distance, Interval(0));
  const auto near = closest_points(curve, evaluate(curve, 1.0));
  ASSERT_EQ(near.size(), 1U);
  EXPECT_NEAR(midpoint(near[0].parameter), 1.0, 1e-14);
}

TEST(ClosestPoint, RefusesBadRequests) {
  const auto curve = report_curve<double>();
  EXPECT_EQ(error_text([&] { closest_points(curve, std::vector<double>{1}); }),
            "closest point: the point has 1 coordinates, expected 2 as the curve");
  EXPECT_EQ(error_text([&] {
              closest_points(curve, std::vector<double>{1, std::nan("")});
            }),
            "closest point: coordinate nan, expected a finite number");
  EXPECT_EQ(error_text([&] {
              closest_points(curve, std::vector<double>{1, 1}, -1);
            }),
            "tolerance -1: expected 0 or more");
}

}  // namespace
}  // namespace gcslab
