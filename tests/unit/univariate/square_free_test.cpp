#include "univariate/square_free.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

IntegerPolynomial power(const IntegerPolynomial& base, int exponent) {
  IntegerPolynomial result({1});
  for (int i = 0; i < exponent; ++i) result = result * base;
  return result;
}

/// Primitive, of degree 1 to 3.
IntegerPolynomial random_factor(Random& random) {
  std::vector<mpz_class> coefficients;
  const auto degree = random.integer(1, 3);
  for (std::int64_t k = 0; k < degree; ++k)
    coefficients.emplace_back(static_cast<long>(random.integer(-30, 30)));
  coefficients.emplace_back(static_cast<long>(random.integer(1, 9)));
  return primitive_part(IntegerPolynomial(std::move(coefficients)));
}

TEST(GreatestCommonDivisor, FindsAPlantedFactor) {
  Random random(fuzz_seed(), "greatest_common_divisor");
  for (std::size_t i = 0; i < fuzz_cases(300); ++i) {
    const IntegerPolynomial common = random_factor(random);
    const IntegerPolynomial a = random_factor(random) * IntegerPolynomial({6});
    const IntegerPolynomial b = random_factor(random);
    const IntegerPolynomial divisor = greatest_common_divisor(a * common, b * common);
    EXPECT_EQ(divisor, primitive_part(greatest_common_divisor(a, b) * common));
    EXPECT_NO_THROW(exact_quotient(a * common, divisor));
    EXPECT_NO_THROW(exact_quotient(b * common, divisor));
  }
}

TEST(GreatestCommonDivisor, IsNotMisledByAPrimeThatDividesCoefficients) {
  const mpz_class prime("2147483647");
  const mpz_class other("2147483629");
  // Modulo either prime one is a multiple of the other, or its degree falls.
  const IntegerPolynomial a({1, prime * other});
  const IntegerPolynomial b({1 + prime * other, 0, prime * other});
  EXPECT_EQ(greatest_common_divisor(a, b), IntegerPolynomial({1}));
  EXPECT_EQ(greatest_common_divisor(a * b, a), a);
  EXPECT_TRUE(greatest_common_divisor({}, {}).is_zero());
}

TEST(SquareFreeDecomposition, GivesThePlantedPowersBack) {
  Random random(fuzz_seed(), "square_free");
  for (std::size_t i = 0; i < fuzz_cases(200); ++i) {
    IntegerPolynomial p({static_cast<long>(random.integer(1, 7)) * (random.below(2) == 0 ? 1 : -1)});
    for (int factor = 0; factor < 3; ++factor)
      p = p * power(random_factor(random), static_cast<int>(random.integer(1, 4)));
    IntegerPolynomial product({1});
    for (const SquareFreeFactor& factor : square_free_decomposition(p)) {
      EXPECT_EQ(greatest_common_divisor(factor.polynomial, factor.polynomial.derivative()).degree(), 0);
      EXPECT_EQ(greatest_common_divisor(factor.polynomial, product).degree(), 0);
      product = product * power(factor.polynomial, factor.multiplicity);
    }
    EXPECT_EQ(product, primitive_part(p));
  }
}

TEST(SquareFreeDecomposition, OfAConstantHasNoFactors) {
  EXPECT_TRUE(square_free_decomposition(IntegerPolynomial({-5})).empty());
}

}  // namespace
}  // namespace gcslab
