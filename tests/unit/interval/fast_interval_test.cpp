#include "interval/fast_interval.h"

#include <cmath>
#include <gtest/gtest.h>
#include <type_traits>
#include <vector>

namespace gcslab {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();

class FastIntervalTest : public ::testing::Test {
 protected:
  const NumberTraits<FastInterval>::Scope scope_;
};

FastInterval fast(double lower, double upper) { return {lower, upper}; }

TEST_F(FastIntervalTest, IsTwoPlainDoubles) {
  static_assert(std::is_trivially_copyable_v<FastInterval>);
  const std::vector<FastInterval> array = {fast(1, 2), fast(-3, 4)};
  const double* raw = reinterpret_cast<const double*>(array.data());
  EXPECT_EQ(raw[0], -1);
  EXPECT_EQ(raw[1], 2);
  EXPECT_EQ(raw[2], 3);
  EXPECT_EQ(raw[3], 4);
  EXPECT_EQ(FastInterval::from_raw(array[1].raw()).interval(), Interval(-3, 4));
}

TEST_F(FastIntervalTest, EmptyOperandsGiveTheOneEmptyRepresentation) {
  const FastInterval empty;
  const std::vector<FastInterval> others = {fast(1, 2),          fast(-kInfinity, kInfinity), fast(0, 0),
                                            fast(-1, kInfinity), fast(-kInfinity, 3),         empty};
  for (const FastInterval& other : others) {
    for (const FastInterval& result : {empty + other, other - empty, empty * other, other * empty,
                                       empty / other, other / empty, min(empty, other), max(other, empty)}) {
      EXPECT_EQ(result.interval(), Interval::empty());
      EXPECT_TRUE(result.is_empty());
    }
  }
  for (const FastInterval& result :
       {-empty, sqr(empty), abs(empty), sqrt(empty), pow(empty, 3), pow(empty, 2), pow(empty, 0),
        pow(empty, -1), exp(empty), sin(empty), tan(empty)}) {
    EXPECT_EQ(result.interval(), Interval::empty());
  }
}

TEST_F(FastIntervalTest, OverflowGivesUnboundedIntervalsThatAreNotEmpty) {
  const FastInterval large(kLargest);
  EXPECT_EQ((large + large).interval(), Interval(kLargest, kInfinity));
  EXPECT_EQ((large * -large).interval(), Interval(-kInfinity, -kLargest));
  EXPECT_EQ(sqr(large).interval(), Interval(kLargest, kInfinity));
  EXPECT_EQ(pow(large, 3).interval(), Interval(kLargest, kInfinity));
  EXPECT_EQ(pow(-large, 3).interval(), Interval(-kInfinity, -kLargest));
  EXPECT_EQ(exp(large).interval(), Interval(kLargest, kInfinity));
}

TEST_F(FastIntervalTest, ZeroTimesUnboundedIsZero) {
  EXPECT_EQ((fast(0, 0) * fast(-kInfinity, kInfinity)).interval(), Interval(0));
  EXPECT_EQ((fast(0, 1) * fast(2, kInfinity)).interval(), Interval(0, kInfinity));
  EXPECT_EQ((fast(-1, 0) * fast(2, kInfinity)).interval(), Interval(-kInfinity, 0));
}

TEST_F(FastIntervalTest, ZeroEndsCarryNoSign) {
  const FastInterval one = fast(1, 1);
  for (const Interval& x :
       {(fast(-1, 0) * fast(1, 2)).interval(), (-fast(0, 1)).interval(), (-fast(-1, 0)).interval(),
        sqr(fast(-1, 0)).interval(), (one - fast(1, 1)).interval()}) {
    EXPECT_FALSE(x.lower == 0 && std::signbit(x.lower)) << to_string(x);
    EXPECT_FALSE(x.upper == 0 && std::signbit(x.upper)) << to_string(x);
  }
}

/// mulRevToPair of IEEE 1788: {z : b z in numerator for some b in denominator}.
TEST_F(FastIntervalTest, ExtendedDivisionGivesTwoPieces) {
  const auto pieces = [](const Interval& a, const Interval& b) {
    const auto [left, right] = extended_divide(FastInterval(a), FastInterval(b));
    return std::pair(left.interval(), right.interval());
  };
  using Pair = std::pair<Interval, Interval>;
  const Interval none = Interval::empty();
  EXPECT_EQ(pieces({1, 2}, {-1, 2}), Pair({-kInfinity, -1}, {0.5, kInfinity}));
  EXPECT_EQ(pieces({-2, -1}, {-4, 2}), Pair({-kInfinity, -0.5}, {0.25, kInfinity}));
  EXPECT_EQ(pieces({1, 2}, Interval::entire()), Pair({-kInfinity, 0}, {0, kInfinity}));
  EXPECT_EQ(pieces({1, 2}, {2, 4}), Pair({0.25, 1}, none));
  EXPECT_EQ(pieces({1, 2}, {0, 4}), Pair({0.25, kInfinity}, none));
  EXPECT_EQ(pieces({1, 2}, {-4, 0}), Pair({-kInfinity, -0.25}, none));
  EXPECT_EQ(pieces({1, 2}, 0), Pair(none, none));
  EXPECT_EQ(pieces({-1, 2}, 0), Pair(Interval::entire(), none));
  EXPECT_EQ(pieces({0, 2}, {-1, 1}), Pair(Interval::entire(), none));
  EXPECT_EQ(pieces({1, kInfinity}, {-1, 2}), Pair({-kInfinity, -1}, {0.5, kInfinity}));
  EXPECT_EQ(pieces(none, {-1, 2}), Pair(none, none));
}

TEST_F(FastIntervalTest, IntersectionAndHullAreThoseOfTheData) {
  EXPECT_EQ(intersection(fast(1, 3), fast(2, 4)).interval(), Interval(2, 3));
  EXPECT_TRUE(intersection(fast(1, 2), fast(3, 4)).is_empty());
  EXPECT_TRUE(intersection(fast(1, 2), FastInterval()).is_empty());
  EXPECT_EQ(hull(fast(1, 2), fast(4, 5)).interval(), Interval(1, 5));
  EXPECT_EQ(hull(fast(1, 2), FastInterval()).interval(), Interval(1, 2));
}

TEST_F(FastIntervalTest, PowersOfExtremeExponents) {
  EXPECT_EQ(pow(fast(1, 1), std::numeric_limits<int>::min()).interval(), Interval(1));
  EXPECT_EQ(pow(fast(-1, 1), std::numeric_limits<int>::min()).interval(), Interval(1, kInfinity));
  EXPECT_EQ(pow(fast(0.5, 2), std::numeric_limits<int>::max()).interval(), Interval(0, kInfinity));
}

}  // namespace
}  // namespace gcslab
