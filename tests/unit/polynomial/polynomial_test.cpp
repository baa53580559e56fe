#include "polynomial/polynomial.h"

#include <gtest/gtest.h>

#include "support/random_polynomial.h"

namespace gcslab {
namespace {

Polynomial x() { return Polynomial::variable(2, 0); }
Polynomial y() { return Polynomial::variable(2, 1); }
Polynomial number(const Rational& value) { return Polynomial::constant(2, value); }

TEST(Polynomial, HoldsNoZeroCoefficient) {
  EXPECT_TRUE((x() - x()).is_zero());
  EXPECT_TRUE((x() * Rational(0)).is_zero());
  EXPECT_TRUE(number(0).is_zero());
  EXPECT_EQ((x() + y() - x()).terms().size(), 1U);
}

TEST(Polynomial, ExpandsProductsExactly) {
  const Polynomial square = (x() + y()) * (x() + y());
  EXPECT_EQ(square, pow(x(), 2) + Rational(2) * x() * y() + pow(y(), 2));
  EXPECT_EQ((x() - y()) * (x() + y()), pow(x(), 2) - pow(y(), 2));
  EXPECT_EQ(pow(x() + number(1), 3).coefficient({2, 0}), 3);
  EXPECT_EQ(pow(Rational(1, 2) * x() * y(), 3).coefficient({3, 3}), Rational(1, 8));
  EXPECT_EQ(pow(x() + y(), 0), number(1));
}

TEST(Polynomial, SurvivesArithmeticWithItself) {
  Polynomial p = x() + number(2);
  const Polynomial& same = p;
  p += same;
  EXPECT_EQ(p, Rational(2) * x() + number(4));
  p -= same;
  EXPECT_TRUE(p.is_zero());
}

TEST(Polynomial, KnowsItsDegrees) {
  const Polynomial p = pow(x(), 3) + x() * pow(y(), 4) + number(7);
  EXPECT_EQ(p.degrees(), (Exponents{3, 4}));
  EXPECT_EQ(p.total_degree(), 5);
  EXPECT_EQ(Polynomial(2).degrees(), (Exponents{0, 0}));
  EXPECT_EQ(Polynomial(2).total_degree(), 0);
}

TEST(Polynomial, DifferentiatesTermByTerm) {
  const Polynomial p = pow(x(), 3) * y() + Rational(5) * y();
  EXPECT_EQ(p.derivative(0), Rational(3) * pow(x(), 2) * y());
  EXPECT_EQ(p.derivative(1), pow(x(), 3) + number(5));
  EXPECT_TRUE(number(3).derivative(0).is_zero());
}

TEST(Polynomial, RestrictionAgreesWithEvaluation) {
  Random random(1, "restrict");
  for (int i = 0; i < 100; ++i) {
    const Polynomial p = random_polynomial(random, 3, 4, 8);
    const std::vector<Rational> point{random_fraction(random), random_fraction(random),
                                      random_fraction(random)};
    const Polynomial q = p.restrict(1, point[1]);
    EXPECT_EQ(q.degrees()[1], 0);
    EXPECT_EQ(q.evaluate(point), p.evaluate(point));
  }
}

TEST(Polynomial, EvaluationIsARingHomomorphism) {
  Random random(1, "ring");
  for (int i = 0; i < 100; ++i) {
    const Polynomial p = random_polynomial(random, 2, 4, 6);
    const Polynomial q = random_polynomial(random, 2, 4, 6);
    const std::vector<Rational> point{random_fraction(random), random_fraction(random)};
    EXPECT_EQ((p + q).evaluate(point), p.evaluate(point) + q.evaluate(point));
    EXPECT_EQ((p - q).evaluate(point), p.evaluate(point) - q.evaluate(point));
    EXPECT_EQ((p * q).evaluate(point), p.evaluate(point) * q.evaluate(point));
    EXPECT_EQ((p * q).derivative(0), p.derivative(0) * q + p * q.derivative(0));
  }
}

TEST(Polynomial, WithoutVariablesIsANumber) {
  const Polynomial p = Polynomial::constant(0, 5);
  EXPECT_EQ(p.evaluate(std::vector<Rational>{}), 5);
  EXPECT_EQ(p.total_degree(), 0);
}

}  // namespace
}  // namespace gcslab
