#include "interval/elementary.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "interval/rounding.h"

namespace gcslab {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kPi = std::numbers::pi;  // below pi
const double kAbovePi = std::nextafter(kPi, 4);

double successor(double x) { return std::nextafter(x, kInfinity); }

TEST(Elementary, ExactValuesAreSingletons) {
  EXPECT_EQ(elementary::exp(0), Interval(1));
  EXPECT_EQ(elementary::log(1), Interval(0));
  EXPECT_EQ(elementary::sin(0), Interval(0));
  EXPECT_EQ(elementary::cos(0), Interval(1));
  EXPECT_EQ(elementary::tan(0), Interval(0));
  EXPECT_EQ(elementary::atan(0), Interval(0));
  EXPECT_EQ(elementary::acos(1), Interval(0));
  EXPECT_EQ(elementary::sqrt(4), Interval(2));
  EXPECT_EQ(elementary::cbrt(-27), Interval(-3));
  EXPECT_EQ(elementary::pow(8, Rational(1, 3)), Interval(2));
  EXPECT_EQ(elementary::pow(4, Rational(3, 2)), Interval(8));
  EXPECT_EQ(elementary::pow(4, Rational(-1, 2)), Interval(0.5));
  EXPECT_EQ(elementary::pow(-32, Rational(3, 5)), Interval(-8));
}

TEST(Elementary, InexactValuesLieBetweenNeighbours) {
  const Interval e = elementary::exp(1);
  EXPECT_EQ(e, Interval(std::numbers::e, successor(std::numbers::e)));
  EXPECT_EQ(elementary::pi(), Interval(kPi, kAbovePi));
  EXPECT_EQ(elementary::enclosing(Rational(1, 3)), Interval(1.0 / 3.0, successor(1.0 / 3.0)));
  EXPECT_EQ(elementary::enclosing(Rational(1, 4)), Interval(0.25));
  EXPECT_EQ(elementary::enclosing(Rational(1) / Rational("1" + std::string(400, '0'))),
            Interval(0, std::numeric_limits<double>::denorm_min()));
}

/// Digits of atan(1/128 - 2^-60) by MPFR; the reduction by 1/64 must not round this argument to 1/128.
TEST(Elementary, AtanBeforeTheFirstTableMiddleIsEnclosed) {
  const Interval expected(0x1.fffd555bbba96p-8, 0x1.fffd555bbba97p-8);
  const double x = std::nextafter(1.0 / 128, 0.0);
  EXPECT_EQ(elementary::atan(x), expected);
  EXPECT_EQ(elementary::atan(-x), Interval(-expected.upper, -expected.lower));
  EXPECT_EQ(elementary::atan(x, elementary::Ends::to_nearest), Interval(expected.lower));
}

TEST(Elementary, OperandsAreCutToTheDomain) {
  EXPECT_EQ(elementary::sqrt({-4, 4}), Interval(0, 2));
  EXPECT_TRUE(is_empty(elementary::sqrt({-4, -1})));
  EXPECT_EQ(elementary::log({-1, 1}), Interval(-kInfinity, 0));
  EXPECT_TRUE(is_empty(elementary::log({-1, 0})));
  EXPECT_EQ(elementary::asin({-9, 0}), Interval(-successor(kPi / 2), 0));
  EXPECT_TRUE(is_empty(elementary::acos({2, 3})));
  EXPECT_EQ(elementary::acos({-3, 3}), Interval(0, kAbovePi));
  EXPECT_TRUE(is_empty(elementary::pow({-2, -1}, Rational(1, 2))));
  EXPECT_TRUE(is_empty(elementary::pow(0, Rational(-1, 3))));
  EXPECT_EQ(elementary::pow({-8, 8}, Rational(1, 3)), Interval(-2, 2));
  EXPECT_EQ(elementary::pow({-8, 1}, Rational(2, 3)), Interval(0, 4));
  EXPECT_EQ(elementary::pow({-8, 1}, Rational(-1, 3)), Interval::entire());
  EXPECT_EQ(elementary::pow({-8, 0}, Rational(-1, 3)), Interval(-kInfinity, -0.5));
  EXPECT_EQ(elementary::pow({-8, 1}, Rational(-2, 3)), Interval(0.25, kInfinity));
  EXPECT_EQ(elementary::pow({-8, 1}, Rational(0)), Interval(1));
}

TEST(Elementary, UnboundedOperandsGiveLimits) {
  EXPECT_EQ(elementary::exp(Interval::entire()), Interval(0, kInfinity));
  EXPECT_EQ(elementary::log({0, kInfinity}), Interval::entire());
  EXPECT_EQ(elementary::atan(Interval::entire()), Interval(-successor(kPi / 2), successor(kPi / 2)));
  EXPECT_EQ(elementary::sin({0, kInfinity}), Interval(-1, 1));
  EXPECT_EQ(elementary::tan({-kInfinity, 0}), Interval::entire());
  EXPECT_EQ(elementary::sqrt({4, kInfinity}), Interval(2, kInfinity));
  EXPECT_EQ(elementary::pow({2, kInfinity}, Rational(-1, 2)).lower, 0);
}

TEST(Elementary, OverflowAndUnderflowStayEnclosed) {
  EXPECT_EQ(elementary::exp(1e6), Interval(kLargest, kInfinity));
  EXPECT_EQ(elementary::exp(-1e6), Interval(0, std::numeric_limits<double>::denorm_min()));
  EXPECT_EQ(elementary::sin(0x1p-1074), Interval(0, 0x1p-1074));
  EXPECT_EQ(elementary::pow(1e300, Rational(5, 3)), Interval(kLargest, kInfinity));
}

TEST(Elementary, ExtremaOfSineAndCosineAreFound) {
  EXPECT_EQ(elementary::sin({0, kAbovePi}).upper, 1);
  EXPECT_EQ(elementary::sin({0, 10}), Interval(-1, 1));
  EXPECT_EQ(elementary::sin({1.5, 1.6}).upper, 1);
  EXPECT_LT(elementary::sin({1.5, 1.57}).upper, 1);
  EXPECT_EQ(elementary::cos({-1, 1}).upper, 1);
  EXPECT_EQ(elementary::cos({3, 4}).lower, -1);
  EXPECT_GT(elementary::cos({3, 3.14}).lower, -1);
  EXPECT_EQ(elementary::sin({-2, -1}).lower, -1);
  EXPECT_EQ(elementary::cos({0, 1}).upper, 1);
}

/// pi/2 lies between these neighbours: only the interval of both contains the extremum or the pole.
TEST(Elementary, TheNeighboursOfPiOverTwoAreTold) {
  const double below = kPi / 2;
  const double above = successor(below);
  EXPECT_TRUE(is_bounded(elementary::tan(below)));
  EXPECT_GT(elementary::tan(below).lower, 1e16);
  EXPECT_LT(elementary::tan(above).upper, -1e15);
  EXPECT_EQ(elementary::tan({below, above}), Interval::entire());
  EXPECT_EQ(elementary::tan({-above, -below}), Interval::entire());
  EXPECT_TRUE(is_bounded(elementary::tan({-below, below})));
}

/// The double nearest to a multiple of pi/2 (Kahan; Muller 2016, table 11.1): 6381956970095103 * 2^797.
TEST(Elementary, HugeArgumentsAreReducedExactly) {
  const double hard = std::ldexp(6381956970095103.0, 797);
  const Interval cosine = elementary::cos(hard);
  EXPECT_TRUE(contains(cosine, -4.6871659242546276e-19));
  EXPECT_LT(width(cosine), 1e-34);
  EXPECT_EQ(elementary::sin({hard, successor(hard)}), Interval(-1, 1));
  EXPECT_EQ(elementary::tan({hard, successor(hard)}), Interval::entire());
  EXPECT_TRUE(contains(elementary::sin(1e22), -0.8522008497671888));
  EXPECT_TRUE(contains(elementary::cos(kLargest), -0.9999876894265599));
}

TEST(Elementary, ResultsDoNotDependOnTheRoundingMode) {
  const Interval x(0.3, 700.7);
  const Interval before[] = {elementary::exp(0.3),
                             elementary::log(x),
                             elementary::sin({100.3, 100.4}),
                             elementary::tan(1e5),
                             elementary::pow(x, Rational(3, 7)),
                             elementary::enclosing(Rational(1, 7))};
  const UpwardRounding upward;
  EXPECT_EQ(elementary::exp(0.3), before[0]);
  EXPECT_EQ(elementary::log(x), before[1]);
  EXPECT_EQ(elementary::sin({100.3, 100.4}), before[2]);
  EXPECT_EQ(elementary::tan(1e5), before[3]);
  EXPECT_EQ(elementary::pow(x, Rational(3, 7)), before[4]);
  EXPECT_EQ(elementary::enclosing(Rational(1, 7)), before[5]);
}

TEST(Elementary, ExponentsOfAnySizeAreEnclosed) {
  const Rational huge("1000000000000000000000/999999999999999999999");
  const Interval power = elementary::pow(2, huge);
  EXPECT_LE(power.lower, 2);
  EXPECT_GT(power.upper, 2);
  EXPECT_LT(width(power), 1e-14);
  EXPECT_EQ(elementary::pow(1, huge), Interval(1));
  EXPECT_TRUE(contains(elementary::pow(0.5, huge), 0.5) || elementary::pow(0.5, huge).upper <= 0.5);
}

TEST(Elementary, RoundingToNearestGivesOneEndOfTheEnclosure) {
  for (const double x : {0.3, 1.7, 2.9}) {
    const Interval enclosure = elementary::exp(x);
    const Interval nearest = elementary::exp(x, elementary::Ends::to_nearest);
    EXPECT_TRUE(is_singleton(nearest));
    EXPECT_TRUE(nearest.lower == enclosure.lower || nearest.lower == enclosure.upper);
  }
}

}  // namespace
}  // namespace gcslab
