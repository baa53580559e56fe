#include "univariate/integer_polynomial.h"

#include <gtest/gtest.h>

#include "base/check.h"
#include "base/random.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

IntegerPolynomial random_polynomial(Random& random, int degree, std::int64_t size) {
  std::vector<mpz_class> coefficients;
  for (int k = 0; k <= degree; ++k) coefficients.emplace_back(static_cast<long>(random.integer(-size, size)));
  return IntegerPolynomial(std::move(coefficients));
}

TEST(IntegerPolynomial, QuotientsUndoProducts) {
  Random random(fuzz_seed(), "integer_polynomial");
  for (std::size_t i = 0; i < fuzz_cases(300); ++i) {
    const IntegerPolynomial a = random_polynomial(random, 6, 1000);
    const IntegerPolynomial b = random_polynomial(random, 4, 3);
    if (b.is_zero()) continue;
    EXPECT_EQ(exact_quotient(a * b, b), a);
  }
  EXPECT_THROW(exact_quotient(IntegerPolynomial({1, 0, 1}), IntegerPolynomial({1, 1})), InvariantError);
}

TEST(IntegerPolynomial, KeepsTheRootsOfARationalPolynomial) {
  Polynomial p(1);
  p.add_term({2}, Rational(-3, 4));
  p.add_term({0}, Rational(1, 3));
  EXPECT_EQ(primitive_polynomial(p), IntegerPolynomial({-4, 0, 9}));
  EXPECT_TRUE(primitive_polynomial(Polynomial(1)).is_zero());
}

TEST(SignEvaluator, TellsExactSignsWhereDoublesCannot) {
  const SignEvaluator square_root_of_two(IntegerPolynomial({-2, 0, 1}));
  const Rational near("6369051672525773/4503599627370496");  // the double nearest to the root
  EXPECT_EQ(square_root_of_two.sign(near), sgn(Rational(near * near - 2)));
  EXPECT_EQ(square_root_of_two.sign(near + Rational("1/1000000000000000000000000000000")),
            sgn(Rational(near * near - 2)));
  EXPECT_EQ(SignEvaluator(IntegerPolynomial({1, -6, 9})).sign(Rational(1, 3)), 0);
  const mpz_class huge = mpz_class(1) << 4000;
  EXPECT_EQ(SignEvaluator(IntegerPolynomial({-huge, 1})).sign(Rational(huge - 1)), -1);
}

TEST(SignEvaluator, AgreesWithExactEvaluationOfRandomPolynomials) {
  Random random(fuzz_seed(), "sign_evaluator");
  for (std::size_t i = 0; i < fuzz_cases(2000); ++i) {
    const IntegerPolynomial p = random_polynomial(random, 5, 4);
    const Rational x = Rational(static_cast<long>(random.integer(-12, 12))) / 6;
    EXPECT_EQ(SignEvaluator(p).sign(x), sgn(p.to_polynomial().evaluate({&x, 1})));
  }
}

}  // namespace
}  // namespace gcslab
