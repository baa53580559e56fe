#include "interval/point_numbers.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "base/error.h"

namespace gcslab {
namespace {

TEST(PointNumbers, PowersFollowTheConventionsOfIntervals) {
  EXPECT_EQ(pow(2.0, 10), 1024);
  EXPECT_EQ(pow(2.0, -2), 0.25);
  EXPECT_EQ(pow(0.0, 0), 1);
  EXPECT_EQ(pow(-8.0, Rational(2)), 64);
  EXPECT_NEAR(pow(-8.0, Rational(1, 3)), -2, 1e-15);
  EXPECT_NEAR(pow(-8.0, Rational(2, 3)), 4, 1e-14);
  EXPECT_TRUE(std::isnan(pow(-8.0, Rational(1, 2))));
  EXPECT_EQ(pow(2.0F, Rational(3)), 8.0F);
  EXPECT_TRUE(std::isinf(pow(2.0, std::numeric_limits<int>::max())));
}

TEST(PointNumbers, EnclosuresOfInfinitiesAndNaN) {
  using Traits = NumberTraits<double>;
  EXPECT_EQ(Traits::enclosure(1.5), Interval(1.5));
  EXPECT_EQ(Traits::enclosure(std::numeric_limits<double>::infinity()).lower,
            std::numeric_limits<double>::max());
  EXPECT_TRUE(is_empty(Traits::enclosure(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_EQ(Traits::from_rational(Rational(1, 10)), 0.1);
  EXPECT_EQ(NumberTraits<float>::from_rational(Rational(1, 10)), 0.1F);
}

TEST(PointNumbers, DerivativesOfPiecewiseFunctions) {
  EXPECT_EQ(sign_enclosure(-2.0), -1);
  EXPECT_EQ(sign_enclosure(0.0), 0);
  EXPECT_EQ(less_enclosure(1.0, 2.0), 1);
  EXPECT_EQ(less_enclosure(2.0, 1.0), 0);
  EXPECT_EQ(sign_enclosure(Rational(-1, 2)), -1);
  EXPECT_EQ(less_enclosure(Rational(1, 3), Rational(1, 2)), 1);
}

TEST(ExactNumbers, ComputeExactly) {
  EXPECT_EQ(pow(Rational(2, 3), 3), Rational(8, 27));
  EXPECT_EQ(pow(Rational(-2, 3), -3), Rational(-27, 8));
  EXPECT_EQ(pow(Rational(2, 3), Rational(2)), Rational(4, 9));
  EXPECT_EQ(sqr(Rational(-1, 2)), Rational(1, 4));
  EXPECT_EQ(abs(Rational(-1, 2)), Rational(1, 2));
  EXPECT_EQ(min(Rational(1, 3), Rational(1, 2)), Rational(1, 3));
  EXPECT_EQ(max(Rational(1, 3), Rational(1, 2)), Rational(1, 2));
}

TEST(ExactNumbers, RefuseWhatIsNotRational) {
  EXPECT_THROW(exp(Rational(1)), NotApplicable);
  EXPECT_THROW(sqrt(Rational(4)), NotApplicable);
  EXPECT_THROW(pow(Rational(4), Rational(1, 2)), NotApplicable);
  EXPECT_THROW(pow(Rational(0), -1), NotApplicable);
  EXPECT_THROW(divide(Rational(1), Rational(0)), NotApplicable);
  EXPECT_THROW(NumberTraits<Rational>::pi(), NotApplicable);
}

}  // namespace
}  // namespace gcslab
