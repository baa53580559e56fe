#include "spline/surface.h"

#include <gtest/gtest.h>

#include "interval/fast_interval.h"
#include "support/error_text.h"
#include "support/fuzz.h"
#include "support/random_spline.h"

namespace gcslab {
namespace {

using Exact = BSplineSurface<Rational>;

Exact random_surface(Random& random, int degree_u, int degree_v) {
  const auto multiplicity = [&](int degree) { return static_cast<int>(random.integer(1, degree + 1)); };
  auto u = random_spline::knots(random, degree_u, multiplicity(degree_u));
  auto v = random_spline::knots(random, degree_v, multiplicity(degree_v));
  auto points = random_spline::points(random, u.size() * v.size(), 3);
  return Exact(std::move(u), std::move(v), std::move(points));
}

template <class F>
void for_random_surfaces(const char* name, const F& f) {
  Random random(fuzz_seed(), name);
  for (int degree_u = 1; degree_u <= 4; ++degree_u) {
    for (int degree_v = 1; degree_v <= 3; ++degree_v) f(random, random_surface(random, degree_u, degree_v));
  }
}

/// The same values at some points of the domain of b.
bool agree(Random& random, const Exact& a, const Exact& b) {
  for (int i = 0; i < 6; ++i) {
    const Rational u = random_spline::parameter(random, b.u);
    const Rational v = random_spline::parameter(random, b.v);
    if (u == b.u.upper() || v == b.v.upper()) continue;  // of a the value after a jump
    if (evaluate(a, u, v) != evaluate(b, u, v)) return false;
  }
  return true;
}

/// The sum of all products of basis functions and points: the oracle.
std::vector<Rational> tensor_sum(const Exact& surface, const Rational& u, const Rational& v) {
  const auto n = basis_functions(surface.u, u);
  const auto m = basis_functions(surface.v, v);
  std::vector<Rational> sum(3, Rational(0));
  for (std::size_t i = 0; i < surface.u.size(); ++i) {
    for (std::size_t j = 0; j < surface.v.size(); ++j) {
      if (i < n.first || i >= n.first + n.derivatives.columns()) continue;
      if (j < m.first || j >= m.first + m.derivatives.columns()) continue;
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += n.derivatives(0, i - n.first) * m.derivatives(0, j - m.first) *
                  surface.points(i * surface.v.size() + j, c);
    }
  }
  return sum;
}

TEST(Surface, IsTheTensorProductAndItsIsoCurvesLieOnIt) {
  for_random_surfaces("surface", [](Random& random, const Exact& surface) {
    const Rational u = random_spline::parameter(random, surface.u);
    const Rational v = random_spline::parameter(random, surface.v);
    const std::vector<Rational> value = tensor_sum(surface, u, v);
    ASSERT_EQ(evaluate(surface, u, v), value);
    ASSERT_EQ(evaluate(iso_curve(surface, Direction::u, u), v), value);
    ASSERT_EQ(evaluate(iso_curve(surface, Direction::v, v), u), value);
  });
}

TEST(Surface, OnAGridIsItselfAtEachParameter) {
  for_random_surfaces("surface_grid", [](Random& random, const Exact& surface) {
    const auto parameters = [&](const KnotVector<Rational>& knots, std::size_t count) {
      std::vector<Rational> result{knots.lower(), knots.upper()};
      while (result.size() < count) result.push_back(random_spline::parameter(random, knots));
      std::ranges::sort(result);
      return result;
    };
    const auto u = parameters(surface.u, 4);
    const auto v = parameters(surface.v, 6);
    const Matrix<Rational> values = evaluate_on_grid<Rational>(surface, u, v);
    for (std::size_t i = 0; i < u.size(); ++i) {
      for (std::size_t j = 0; j < v.size(); ++j)
        ASSERT_TRUE(std::ranges::equal(values.row(i * v.size() + j), evaluate(surface, u[i], v[j])));
    }
    ASSERT_EQ(evaluate_on_grid<Rational>(surface, u, {}).rows(), 0U);
    ASSERT_EQ(evaluate_on_grid<Rational>(surface, {}, v).rows(), 0U);
  });
}

TEST(Surface, HasThePartialDerivativesOfItsIsoCurves) {
  for_random_surfaces("partials", [](Random& random, const Exact& surface) {
    const Rational u = random_spline::parameter(random, surface.u);
    const Rational v = random_spline::parameter(random, surface.v);
    const auto along_u = derivatives(iso_curve(surface, Direction::v, v), u, 2);
    const auto along_v = derivatives(iso_curve(surface, Direction::u, u), v, 2);
    for (int r = 1; r <= 2; ++r) {
      const auto row = static_cast<std::size_t>(r);
      ASSERT_TRUE(std::ranges::equal(partial_derivative(surface, u, v, r, 0), along_u.row(row)));
      ASSERT_TRUE(std::ranges::equal(partial_derivative(surface, u, v, 0, r), along_v.row(row)));
    }
    // Mixed: the u-derivative of the curve of v-derivatives.
    BSplineCurve<Rational> wide = curve_in_direction(surface, Direction::v);
    const Matrix<Rational> slopes = derivatives(wide, v, 1);
    Matrix<Rational> points(surface.u.size(), 3);
    std::copy(slopes.row(1).begin(), slopes.row(1).end(), points.data());
    const auto mixed = derivatives(BSplineCurve<Rational>(surface.u, points), u, 1);
    ASSERT_TRUE(std::ranges::equal(partial_derivative(surface, u, v, 1, 1), mixed.row(1)));
  });
}

TEST(Surface, StaysWhereItIsWhenKnotsAndDegreesChange) {
  for_random_surfaces("surface_identities", [](Random& random, const Exact& surface) {
    for (const Direction direction : {Direction::u, Direction::v}) {
      const KnotVector<Rational>& knots = direction == Direction::u ? surface.u : surface.v;
      const Rational at = knots.interior().front().value;
      const Rational fresh = knots.lower() + Rational(1, 64);
      const Exact finer = refined(surface, direction, {fresh, fresh});
      ASSERT_EQ(finer.u.size() + finer.v.size(), surface.u.size() + surface.v.size() + 2);
      ASSERT_TRUE(agree(random, surface, finer));
      const Exact higher = elevated(surface, direction, 2);
      ASSERT_EQ(higher.u.degree() + higher.v.degree(), surface.u.degree() + surface.v.degree() + 2);
      ASSERT_TRUE(agree(random, surface, higher));
      const auto [before, after] = subdivided(surface, direction, at);
      ASSERT_TRUE(agree(random, surface, before) && agree(random, surface, after));
      ASSERT_EQ((direction == Direction::u ? before.u : before.v).upper(), at);
    }
  });
}

TEST(Surface, OfDoublesIsTheExactOneUpToRounding) {
  for_random_surfaces("surface_rounding", [](Random& random, const Exact& surface) {
    Matrix<double> points(surface.points.rows(), 3);
    for (std::size_t i = 0; i < points.rows() * 3; ++i)
      points.data()[i] = nearest_double(surface.points.data()[i]);
    const BSplineSurface<double> rounded(converted<double>(surface.u), converted<double>(surface.v), points);
    const Rational u = random_spline::parameter(random, surface.u);
    const Rational v = random_spline::parameter(random, surface.v);
    const auto exact = evaluate(surface, u, v);
    const auto value = evaluate(rounded, nearest_double(u), nearest_double(v));
    for (std::size_t c = 0; c < 3; ++c)
      ASSERT_NEAR(value[c], nearest_double(exact[c]),
                  8 * (surface.u.degree() + surface.v.degree()) * 4 * 0x1p-52);
  });
}

TEST(Surface, OfIntervalsContainsWhatItsParametersReach) {
  const NumberTraits<FastInterval>::Scope scope;
  Random random(fuzz_seed(), "surface_interval");
  const Exact exact = random_surface(random, 3, 2);
  Matrix<FastInterval> points(exact.points.rows(), 3);
  for (std::size_t i = 0; i < points.rows() * 3; ++i)
    points.data()[i] = converted_number<FastInterval>(exact.points.data()[i]);
  const BSplineSurface<FastInterval> surface(converted<FastInterval>(exact.u),
                                             converted<FastInterval>(exact.v), points);
  const auto all = [](const KnotVector<Rational>& knots) {
    return FastInterval(nearest_double(knots.lower()), nearest_double(knots.upper()));
  };
  const auto value = evaluate(surface, all(exact.u), all(exact.v));
  for (int i = 0; i < 50; ++i) {
    const auto inside =
        evaluate(exact, random_spline::parameter(random, exact.u), random_spline::parameter(random, exact.v));
    for (std::size_t c = 0; c < 3; ++c) EXPECT_TRUE(contains(value[c].interval(), nearest_double(inside[c])));
  }
}

TEST(Surface, RationalOnesAreExactSpheres) {
  // An octant: the quarter circle (1 - t^2, 2t, 1 + t^2) turned about the axis by another one.
  const std::vector<std::vector<Rational>> arc = {{1, 0}, {1, 1}, {0, 1}};
  const std::vector<Rational> weight = {1, 1, 2};
  Matrix<Rational> points(9, 3);
  std::vector<Rational> weights;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      points(3 * i + j, 0) = arc[i][0] * arc[j][0];
      points(3 * i + j, 1) = arc[i][0] * arc[j][1];
      points(3 * i + j, 2) = arc[i][1];
      weights.emplace_back(weight[i] * weight[j]);
    }
  }
  const KnotVector<Rational> knots(2, {0, 0, 0, 1, 1, 1});
  const auto sphere = rational_surface(knots, knots, points, weights);
  for (int i = 0; i <= 5; ++i) {
    for (int j = 0; j <= 5; ++j) {
      const std::vector<Rational> p = evaluate(sphere, Rational(Rational(i) / 5), Rational(Rational(j) / 5));
      EXPECT_EQ(p[0] * p[0] + p[1] * p[1] + p[2] * p[2], 1);
    }
  }
  EXPECT_EQ(error_text([&] { rational_surface(knots, knots, points, std::vector<Rational>(9, 0)); }),
            "weight 0 is 0, expected a positive number");
}

TEST(Surface, RefusesWrongCountsAndParameters) {
  const KnotVector<double> knots(1, {0, 0, 1, 1});
  EXPECT_EQ(error_text([&] { BSplineSurface<double>(knots, knots, Matrix<double>(3, 3)); }),
            "surface: 3 control points given, expected 2 x 2 = 4");
  const BSplineSurface<double> flat(knots, knots, Matrix<double>(4, 3));
  EXPECT_EQ(error_text([&] { evaluate(flat, 0.5, 2.0); }), "parameter 2 is outside of the domain [0, 1]");
  EXPECT_EQ(error_text([&] { iso_curve(flat, Direction::u, -1.0); }),
            "parameter -1 is outside of the domain [0, 1]");
}

}  // namespace
}  // namespace gcslab
