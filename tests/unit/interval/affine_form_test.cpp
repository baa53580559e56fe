#include "interval/affine_form.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace gcslab {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <class Form>
Form variable(double lower, double upper) {
  return NumberTraits<Form>::from_interval({lower, upper});
}

template <class Form>
class AffineForms : public ::testing::Test {
 protected:
  const typename NumberTraits<Form>::Scope scope_;
};

using Forms = ::testing::Types<ChebyshevAffine, MinRangeAffine>;
TYPED_TEST_SUITE(AffineForms, Forms);

TYPED_TEST(AffineForms, CancelWhatTheyShare) {
  const TypeParam x = variable<TypeParam>(1, 3);
  const TypeParam y = variable<TypeParam>(-1, 2);
  EXPECT_EQ((x - x).range(), Interval(0));
  EXPECT_EQ(((x + y) - y).range(), Interval(1, 3));
  const TypeParam product = x * y;
  EXPECT_EQ((product - product).range(), Interval(0));
}

TYPED_TEST(AffineForms, NeverExceedTheNaturalRange) {
  const TypeParam x = variable<TypeParam>(0, 2);
  const TypeParam y = variable<TypeParam>(0, 3);
  EXPECT_EQ((x * y).range(), Interval(0, 6));
  EXPECT_EQ(sqr(variable<TypeParam>(-1, 3)).range(), Interval(0, 9));
  EXPECT_EQ(sqrt(variable<TypeParam>(-1, 4)).range(), Interval(0, 2));
  EXPECT_EQ(abs(variable<TypeParam>(-1, 4)).range(), Interval(0, 4));
  EXPECT_TRUE(subset((x / variable<TypeParam>(1, 2)).range(), {0, 2}));
}

TYPED_TEST(AffineForms, EmptyAndUnboundedValuesHaveARangeAlone) {
  const TypeParam x = variable<TypeParam>(0, 2);
  const TypeParam empty = sqrt(variable<TypeParam>(-3, -1));
  EXPECT_TRUE(is_empty(empty.range()));
  EXPECT_TRUE(is_empty((x + empty).range()));
  EXPECT_TRUE(is_empty(exp(empty).range()));
  const TypeParam unbounded = log(x);
  EXPECT_EQ(unbounded.range().lower, -kInfinity);
  EXPECT_FALSE(unbounded.value().sum().has_value());
  const TypeParam bounded = exp(unbounded);
  EXPECT_TRUE(subset({1e-9, 2}, bounded.range()));
  EXPECT_TRUE(bounded.value().sum().has_value());
  EXPECT_EQ((x / variable<TypeParam>(-1, 1)).range(), Interval::entire());
}

TYPED_TEST(AffineForms, OverflowFallsBackToTheRange) {
  const TypeParam large = variable<TypeParam>(1e308, 1.5e308);
  EXPECT_TRUE(contains((large + large - large).range(), 1.2e308));
  EXPECT_EQ((large * large).range().upper, kInfinity);
  const TypeParam whole = variable<TypeParam>(-kInfinity, kInfinity);
  EXPECT_TRUE(subset({-1, 1}, sin(whole).range()));
  EXPECT_TRUE(is_bounded(atan(whole).range()));
}

TYPED_TEST(AffineForms, OfSmoothFunctionsConvergeQuadratically) {
  const auto excess = [](double radius) {
    const typename NumberTraits<TypeParam>::Scope scope;
    const TypeParam x = variable<TypeParam>(1 - radius, 1 + radius);
    const TypeParam f = exp(x) - sin(x) * log(x) + sqrt(x) / (x * x) - atan(x);
    // f' is near its value at 1, so that the range is 2 |f'(1)| radius up to a quadratic term.
    const double slope = std::exp(1.0) - std::sin(1.0) + 0.5 - 2.0 - 0.5;
    return width(f.range()) - 2 * std::fabs(slope) * radius;
  };
  EXPECT_LT(excess(0x1p-10), excess(0x1p-8) / 8);
  EXPECT_LT(excess(0x1p-12), excess(0x1p-10) / 8);
}

TEST(ChebyshevForms, HaveTheWidthOfTheBestLines) {
  const NumberTraits<ChebyshevAffine>::Scope scope;
  const ChebyshevAffine x = variable<ChebyshevAffine>(0, 1);
  // x^2 lies between x and x - 1/4, so x - x^2 in [0, 1/4] in exact arithmetic.
  EXPECT_EQ((x - sqr(x)).range(), Interval(0, 0.25));
  const ChebyshevAffine e = exp(x);
  const double slope = std::exp(1.0) - 1;
  const double band = 1 - (slope - slope * std::log(slope));
  EXPECT_NEAR(width((e - x * NumberTraits<ChebyshevAffine>::from_interval(slope)).range()), band, 1e-12);
}

TEST(MinRangeForms, HaveTheRangeOfTheFunction) {
  const NumberTraits<MinRangeAffine>::Scope scope;
  const AffineValue e = exp(variable<MinRangeAffine>(0, 1)).value();
  EXPECT_NEAR(e.sum()->range().lower, 1, 1e-15);
  EXPECT_NEAR(e.sum()->range().upper, std::exp(1.0), 1e-15);
  const AffineValue square = sqr(variable<MinRangeAffine>(1, 3)).value();
  EXPECT_EQ(square.sum()->range(), Interval(1, 9));
}

TEST(AffineSums, NumberTheirSymbolsInTheScope) {
  const NoiseScope outer;
  const AffineSum first = AffineSum::variable({0, 2});
  {
    const NoiseScope inner;
    EXPECT_EQ(AffineSum::variable({0, 2}).coefficient(0), 1);
  }
  const AffineSum second = AffineSum::variable({0, 4});
  EXPECT_EQ(first.coefficient(0), 1);
  EXPECT_EQ(second.coefficient(0), 0);
  EXPECT_EQ(second.coefficient(1), 2);
  EXPECT_TRUE(AffineSum::variable({5, 5}).is_constant());
}

TEST(AffineSums, RoundingErrorsAreNotShared) {
  const NoiseScope scope;
  const AffineSum x = AffineSum::variable({0.1, 0.3});
  const AffineSum tenth = AffineSum::constant({0.1, 0.1});
  const AffineSum scaled = AffineSum::product(tenth, x);
  EXPECT_GT(scaled.error(), 0);
  EXPECT_GT(AffineSum::difference(scaled, scaled).error(), scaled.error());
}

/// For x_1 = 1 + e_1, x_2 = 1 - e_1 the product is 1 - e_1^2: the squared symbol is at least 0.
TEST(AffineSums, ProductsKnowThatSquaresOfSymbolsAreNotNegative) {
  const NoiseScope scope;
  const AffineSum e = AffineSum::variable({-1, 1});
  const AffineSum one = AffineSum::constant(1);
  const AffineSum product = AffineSum::product(AffineSum::sum(one, e), AffineSum::difference(one, e));
  EXPECT_EQ(product.range(), Interval(0, 1));
}

}  // namespace
}  // namespace gcslab
