// Forms of degree at most 3, many at once: their values and derivatives against those of the polynomials.

#include "homotopy/cubic_forms.h"

#include <gtest/gtest.h>
#include <numeric>

#include "interval/rational.h"
#include "support/fuzz.h"
#include "support/random_polynomial.h"

namespace gcslab {
namespace {

/// At most cubic; now and then 0, constant or linear.
Polynomial random_form(Random& random, int variables) {
  Polynomial result(variables);
  const std::int64_t degree = random.integer(0, 3), terms = random.integer(0, 6);
  for (std::int64_t k = 0; k < terms; ++k) {
    Exponents exponents(static_cast<std::size_t>(variables));
    for (std::int64_t d = 0; d < degree; ++d) ++exponents[random.below(exponents.size())];
    result.add_term(exponents, random_fraction(random));
  }
  return result;
}

double value_at(const Polynomial& polynomial, const std::vector<Rational>& x) {
  return nearest_double(polynomial.evaluate(x));
}

TEST(CubicForms, HaveTheValuesAndTheDerivativesOfTheirPolynomials) {
  constexpr double kRounding = 1e-9;
  Random random(fuzz_seed(), "cubic forms");
  for (std::size_t n = 0; n < fuzz_cases(300); ++n) {
    const int variables = static_cast<int>(random.integer(1, 5));
    const auto size = static_cast<std::size_t>(variables);
    // The forms' variables are among more coordinates, in another order; their rows are every other one.
    std::vector<std::size_t> places(size), columns(2 * size);
    for (std::size_t i = 0; i < size; ++i) places[i] = 2 * (size - i) - 1;
    std::iota(columns.rbegin(), columns.rend(), std::size_t{0});
    std::vector<double> x(2 * size), speed(2 * size);
    for (double& coordinate : x) coordinate = random.uniform(-2, 2);
    for (double& factor : speed) factor = random.uniform(-2, 2);
    std::vector<Rational> exact;
    for (const std::size_t place : places) exact.push_back(rational_from_double(x[place]));

    CubicForms forms;
    std::vector<Polynomial> polynomials;
    for (std::size_t k = 0; k < 4; ++k) {
      polynomials.push_back(random_form(random, variables));
      forms.add(2 * k, polynomials.back(), places);
    }
    forms.scale(2, 0.75);
    polynomials[1] *= Rational(3) / Rational(4);

    std::vector<double> values(8, 7.0);
    Matrix<double> derivatives(8, 2 * size, 5.0);
    forms.values(x, values);
    forms.add_derivatives(x, speed, columns, derivatives);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(values[2 * k], value_at(polynomials[k], exact), kRounding);
      EXPECT_EQ(values[2 * k + 1], 7.0);
      for (int i = 0; i < variables; ++i) {
        const std::size_t place = places[static_cast<std::size_t>(i)];
        const double slope = value_at(polynomials[k].derivative(i), exact);
        EXPECT_NEAR(derivatives(2 * k, columns[place]), 5 + speed[place] * slope, kRounding);
        EXPECT_EQ(derivatives(2 * k + 1, columns[place]), 5.0);
      }
    }
  }
}

}  // namespace
}  // namespace gcslab
