#include "spline/curve.h"

#include <cmath>
#include <gtest/gtest.h>

#include "interval/fast_interval.h"
#include "interval/mpfr_interval.h"
#include "spline/curve_grid.h"
#include "support/error_text.h"
#include "support/fuzz.h"
#include "support/random_spline.h"

namespace gcslab {
namespace {

using random_spline::for_every_multiplicity;
using random_spline::report_curve;
using random_spline::sample_parameters;

/// N_i^p(u) by the recurrence of Cox and de Boor as it is written, 0 / 0 = 0: the oracle.
Rational cox_de_boor(const std::vector<Rational>& knots, std::size_t i, std::size_t p, const Rational& u) {
  if (p == 0) return knots[i] <= u && u < knots[i + 1] ? 1 : 0;
  Rational sum = 0;
  if (knots[i + p] != knots[i])
    sum += (u - knots[i]) / (knots[i + p] - knots[i]) * cox_de_boor(knots, i, p - 1, u);
  if (knots[i + p + 1] != knots[i + 1])
    sum += (knots[i + p + 1] - u) / (knots[i + p + 1] - knots[i + 1]) * cox_de_boor(knots, i + 1, p - 1, u);
  return sum;
}

TEST(BasisFunctions, AreThoseOfTheRecurrenceAndSumToOne) {
  Random random(fuzz_seed(), "basis");
  for_every_multiplicity(random, 1, [&](const BSplineCurve<Rational>& curve) {
    const Rational u = sample_parameters(curve.knots)[random.below(2)];
    const BasisFunctions<Rational> basis = basis_functions(curve.knots, u);
    Rational sum = 0;
    for (std::size_t j = 0; j < basis.derivatives.columns(); ++j) {
      ASSERT_EQ(basis.derivatives(0, j), cox_de_boor(curve.knots.knots(), basis.first + j,
                                                     static_cast<std::size_t>(curve.degree()), u));
      ASSERT_GE(basis.derivatives(0, j), 0);
      sum += basis.derivatives(0, j);
    }
    ASSERT_EQ(sum, 1);
  });
}

TEST(BasisFunctions, HaveDerivativesThatSumToZeroAndVanishBeyondTheDegree) {
  Random random(fuzz_seed(), "basis_derivatives");
  for_every_multiplicity(random, 1, [&](const BSplineCurve<Rational>& curve) {
    const Rational u = random_spline::parameter(random, curve.knots);
    const Matrix<Rational> rows = basis_functions(curve.knots, u, curve.degree() + 2).derivatives;
    for (std::size_t r = 1; r < rows.rows(); ++r) {
      Rational sum = 0;
      for (const Rational& value : rows.row(r)) {
        ASSERT_TRUE(r <= static_cast<std::size_t>(curve.degree()) || value == 0);
        sum += value;
      }
      ASSERT_EQ(sum, 0);
    }
  });
}

TEST(Curve, OfDeBoorIsTheSumOfBasisFunctions) {
  Random random(fuzz_seed(), "de_boor");
  for_every_multiplicity(random, 2, [&](const BSplineCurve<Rational>& curve) {
    for (const Rational& u : {random_spline::parameter(random, curve.knots), curve.knots.lower(),
                              curve.knots.upper(), curve.knots.interior().front().value}) {
      const std::vector<Rational> value = evaluate(curve, u);
      const Matrix<Rational> sums = derivatives(curve, u, 0);
      ASSERT_TRUE(std::equal(value.begin(), value.end(), sums.row(0).begin()));
    }
  });
}

TEST(Curve, HasTheHodographsOfAllOrdersAsDerivatives) {
  Random random(fuzz_seed(), "hodograph");
  for_every_multiplicity(random, 1, [&](const BSplineCurve<Rational>& curve) {
    BSplineCurve<Rational> derivative = curve;
    for (int r = 1; r <= curve.degree(); ++r) {
      derivative = hodograph(derivative);
      ASSERT_EQ(derivative.degree(), curve.degree() - r);
      ASSERT_TRUE(derivative.knots.lower() == curve.knots.lower() &&
                  derivative.knots.upper() == curve.knots.upper());
      for (const Rational& u : sample_parameters(curve.knots)) {
        const auto row = static_cast<std::size_t>(r);
        const Matrix<Rational> all = derivatives(curve, u, r);
        const std::vector<Rational> value = evaluate(derivative, u);
        ASSERT_TRUE(std::equal(value.begin(), value.end(), all.row(row).begin()))
            << curve.degree() << ' ' << r;
      }
    }
  });
}

TEST(Curve, OfJetsHasTheHodographAsSlope) {
  Random random(fuzz_seed(), "jets");
  for_every_multiplicity(random, 1, [&](const BSplineCurve<Rational>& exact) {
    const auto curve = converted<Jet<1>>(exact);
    const Rational u = random_spline::parameter(random, exact.knots);
    const std::vector<Jet<1>> value = evaluate(curve, Jet<1>{nearest_double(u), {1}});
    const Matrix<Rational> expected = derivatives(exact, u, 1);
    for (std::size_t c = 0; c < 2; ++c) {
      ASSERT_NEAR(value[c].value, nearest_double(expected(0, c)), 1e-13);
      ASSERT_NEAR(value[c].slopes[0], nearest_double(expected(1, c)),
                  1e-12 * (1 + std::fabs(nearest_double(expected(1, c)))));
    }
  });
}

template <class T>
void expect_enclosures() {
  const typename NumberTraits<T>::Scope scope(80);
  Random random(fuzz_seed(), "enclosures");
  for_every_multiplicity(random, 1, [&](const BSplineCurve<Rational>& dyadic) {
    BSplineCurve<Rational> exact = dyadic;
    for (std::size_t i = 0; i < exact.points.rows(); ++i) exact.points(i, 0) /= 3;
    const auto curve = converted<T>(exact);
    const Rational a = random_spline::parameter(random, exact.knots);
    const Rational b = random_spline::parameter(random, exact.knots);
    const T wide =
        NumberTraits<T>::from_interval({nearest_double(std::min(a, b)), nearest_double(std::max(a, b))});
    const std::vector<T> thin_value = evaluate(curve, NumberTraits<T>::from_rational(a));
    const std::vector<T> wide_value = evaluate(curve, wide);
    const Matrix<T> wide_slopes = derivatives(curve, wide, 1);
    for (int i = 0; i <= 4; ++i) {
      const Rational u = a + (b - a) * Rational(i) / 4;
      const Matrix<Rational> value = derivatives(exact, u, 1);
      for (std::size_t c = 0; c < 2; ++c) {
        const double near = nearest_double(value(0, c));
        ASSERT_TRUE(contains(NumberTraits<T>::enclosure(wide_value[c]), near));
        ASSERT_TRUE(contains(NumberTraits<T>::enclosure(wide_slopes(1, c)), nearest_double(value(1, c))));
        if (i == 0) {
          const Interval thin = NumberTraits<T>::enclosure(thin_value[c]);
          ASSERT_TRUE(rational_from_double(thin.lower) <= value(0, c) &&
                      value(0, c) <= rational_from_double(thin.upper));
          ASSERT_LE(width(thin), 1e-12);
        }
      }
    }
  });
}

TEST(Curve, OfFastIntervalsContainsTheExactValue) { expect_enclosures<FastInterval>(); }
TEST(Curve, OfMpfrIntervalsContainsTheExactValue) { expect_enclosures<MpfrInterval>(); }

TEST(Curve, RefusesWrongCountsAndNumbers) {
  const KnotVector<double> knots(1, {0, 0, 1, 1});
  EXPECT_EQ(error_text([&] { BSplineCurve<double>(knots, Matrix<double>(3, 2)); }),
            "curve: 3 control points given, expected 2 (4 knots - degree 1 - 1)");
  EXPECT_EQ(error_text([&] { BSplineCurve<double>(knots, Matrix<double>(2, 0)); }),
            "curve: control points have no coordinates, expected 1 at least");
  EXPECT_EQ(error_text([&] { BSplineCurve<double>(knots, Matrix<double>(2, 1, std::nan(""))); }),
            "control point 0: coordinate 0 is nan, expected a finite number");
  EXPECT_EQ(error_text([] {
              matrix_of_rows<double>({{1, 2}, {3}});
            }),
            "point 1 has 1 coordinates, expected 2 as of point 0");
  EXPECT_EQ(error_text([] { return evaluate(report_curve<double>(), 3.5); }),
            "parameter 3.5 is outside of the domain [0, 3]");
  EXPECT_EQ(error_text([] { return derivatives(report_curve<double>(), 1.0, -2); }),
            "derivative of order -2: expected 0 or more");
  const BSplineCurve<double> constant(KnotVector<double>(0, {0, 1}), Matrix<double>(1, 1));
  EXPECT_EQ(error_text([&] { return hodograph(constant); }),
            "hodograph: the curve has degree 0, expected 1 at least");
}

TEST(Curve, OfTheReportStartsAndEndsAtItsEndPoints) {
  const auto curve = report_curve<double>();
  EXPECT_EQ(evaluate(curve, 0.0), (std::vector<double>{0.41705, 0.10673}));
  EXPECT_EQ(evaluate(curve, 3.0), (std::vector<double>{1.477, 0.13012}));
  const Matrix<double> start = derivatives(curve, 0.0, 1);
  EXPECT_NEAR(start(1, 0), 3 * (0.28802 - 0.41705), 1e-15);  // d / (u_{d+1} - u_1) (P_1 - P_0)
  EXPECT_NEAR(start(1, 1), 3 * (0.60088 - 0.10673), 1e-15);
}

TEST(CurveGrid, IsExactlyDeBoorInRationals) {
  Random random(fuzz_seed(), "grid");
  for_every_multiplicity(random, 1, [&](const BSplineCurve<Rational>& curve) {
    std::vector<Rational> parameters = sample_parameters(curve.knots);
    for (const auto& knot : curve.knots.interior()) parameters.push_back(knot.value);
    parameters.push_back(curve.knots.lower());
    parameters.push_back(curve.knots.upper());
    std::ranges::sort(parameters);
    const Matrix<Rational> values = evaluate_on_grid<Rational>(curve, parameters);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const std::vector<Rational> value = evaluate(curve, parameters[i]);
      ASSERT_TRUE(std::equal(value.begin(), value.end(), values.row(i).begin()));
    }
  });
}

TEST(CurveGrid, IsDeBoorUpToRoundingInDoubles) {
  Random random(fuzz_seed(), "grid_rounding");
  for_every_multiplicity(random, 1, [&](const BSplineCurve<Rational>& exact) {
    const auto curve = converted<double>(exact);
    std::vector<double> parameters;
    for (const Rational& u : sample_parameters(exact.knots)) parameters.push_back(nearest_double(u));
    const Matrix<double> values = evaluate_on_grid<double>(curve, parameters);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const std::vector<Rational> value = evaluate(exact, rational_from_double(parameters[i]));
      for (std::size_t c = 0; c < 2; ++c)
        ASSERT_NEAR(values(i, c), nearest_double(value[c]), 8 * curve.degree() * 4 * 0x1p-52);
    }
  });
}

TEST(CurveGrid, EnclosesWhateverSpansAParameterMeets) {
  const NumberTraits<FastInterval>::Scope scope;
  const auto curve = report_curve<FastInterval>();
  const std::vector<FastInterval> parameters = {FastInterval(0.5), FastInterval(0.75, 1.25), FastInterval(3)};
  const Matrix<FastInterval> values = evaluate_on_grid<FastInterval>(curve, parameters);
  const auto exact = report_curve<double>();
  for (const double u : {0.75, 0.9, 1.0, 1.25})
    EXPECT_TRUE(contains(values(1, 0).interval(), evaluate(exact, u)[0])) << u;
  EXPECT_TRUE(contains(values(0, 1).interval(), evaluate(exact, 0.5)[1]));
}

TEST(CurveGrid, RefusesDisorderAndParametersOutside) {
  const auto curve = report_curve<double>();
  const auto on = [&](const std::vector<double>& parameters) {
    return error_text([&] { return evaluate_on_grid<double>(curve, parameters); });
  };
  EXPECT_EQ(on({0.5, 0.25}), "parameter 1 is 0.25 after 0.5: expected parameters that do not decrease");
  EXPECT_EQ(on({0.5, 4}), "parameter 4 is outside of the domain [0, 3]");
  EXPECT_EQ(on({0.5, std::nan("")}), "parameter nan is outside of the domain [0, 3]");
  EXPECT_EQ(on({}), "no error");
}

}  // namespace
}  // namespace gcslab
