#include "interval/interval.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "interval/rounding.h"

namespace gcslab {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

const std::vector<Interval>& sample_intervals() {
  static const std::vector<Interval> samples = {Interval::empty(),
                                                Interval::entire(),
                                                {0, 0},
                                                {1, 1},
                                                {1, 2},
                                                {2, 3},
                                                {1, 3},
                                                {0, 4},
                                                {-2, 1},
                                                {-3, -1},
                                                {2, 2},
                                                {3, 4},
                                                {-1, 4},
                                                {1, kInfinity},
                                                {2, kInfinity},
                                                {-kInfinity, 2},
                                                {-kInfinity, 1},
                                                {4, kInfinity},
                                                {-3, 3},
                                                {0, 1}};
  return samples;
}

/// The members of x among the half integers in [-bound, bound]: enough to decide the relations of the
/// samples.
std::vector<double> members(const Interval& x, double bound) {
  std::vector<double> result;
  for (int halves = -static_cast<int>(2 * bound); halves <= static_cast<int>(2 * bound); ++halves) {
    const double member = 0.5 * halves;
    if (x.lower <= member && member <= x.upper) result.push_back(member);
  }
  return result;
}

/// Quantifiers of the standard's definitions; the inner set reaches further, as unbounded intervals do.
bool for_all_exists(const Interval& x, const Interval& y, const std::function<bool(double, double)>& holds) {
  for (const double a : members(x, 10)) {
    bool found = false;
    for (const double b : members(y, 20)) found = found || holds(a, b);
    if (!found) return false;
  }
  return true;
}

bool for_all(const Interval& x, const Interval& y, const std::function<bool(double, double)>& holds) {
  for (const double a : members(x, 10)) {
    for (const double b : members(y, 10)) {
      if (!holds(a, b)) return false;
    }
  }
  return true;
}

TEST(IntervalRelations, AgreeWithTheirDefinitionsByQuantifiers) {
  const auto equals = [](double a, double b) { return a == b; };
  const auto at_most = [](double a, double b) { return a <= b; };
  const auto at_least = [](double a, double b) { return a >= b; };
  const auto below = [](double a, double b) { return a < b; };
  const auto above = [](double a, double b) { return a > b; };
  const auto differs = [](double a, double b) { return a != b; };
  for (const Interval& x : sample_intervals()) {
    for (const Interval& y : sample_intervals()) {
      SCOPED_TRACE(to_string(x) + " and " + to_string(y));
      EXPECT_EQ(subset(x, y), for_all_exists(x, y, equals));
      EXPECT_EQ(x == y, for_all_exists(x, y, equals) && for_all_exists(y, x, equals));
      EXPECT_EQ(less(x, y), for_all_exists(x, y, at_most) && for_all_exists(y, x, at_least));
      EXPECT_EQ(strictly_less(x, y), for_all_exists(x, y, below) && for_all_exists(y, x, above));
      EXPECT_EQ(interior(x, y), for_all_exists(x, y, below) && for_all_exists(x, y, above));
      EXPECT_EQ(precedes(x, y), for_all(x, y, at_most));
      EXPECT_EQ(strictly_precedes(x, y), for_all(x, y, below));
      EXPECT_EQ(disjoint(x, y), for_all(x, y, differs));
    }
  }
}

TEST(IntervalRelations, InfiniteEndsAreNoMembers) {
  EXPECT_FALSE(contains(Interval::entire(), kInfinity));
  EXPECT_FALSE(contains(Interval::entire(), std::nan("")));
  EXPECT_TRUE(contains(Interval::entire(), kLargest));
  EXPECT_TRUE(interior(Interval::entire(), Interval::entire()));
}

TEST(IntervalKinds, TellEmptyEntireBoundedAndSingleton) {
  EXPECT_TRUE(is_empty(Interval()));
  EXPECT_FALSE(is_empty(Interval(0)));
  EXPECT_TRUE(is_entire(Interval::entire()));
  EXPECT_FALSE(is_bounded(Interval::empty()));
  EXPECT_FALSE(is_bounded(Interval(0, kInfinity)));
  EXPECT_TRUE(is_bounded(Interval(-kLargest, kLargest)));
  EXPECT_TRUE(is_singleton(Interval(2)));
  EXPECT_FALSE(is_singleton(Interval(1, 2)));
  EXPECT_FALSE(is_singleton(Interval::empty()));
}

TEST(IntervalSets, IntersectAndHullAreSetOperations) {
  for (const Interval& x : sample_intervals()) {
    for (const Interval& y : sample_intervals()) {
      const Interval common = intersection(x, y);
      const Interval both = hull(x, y);
      EXPECT_TRUE(subset(x, both) && subset(y, both));
      EXPECT_TRUE(subset(common, x) && subset(common, y));
      EXPECT_EQ(is_empty(common), disjoint(x, y));
      for (const double member : members(x, 10)) EXPECT_EQ(contains(common, member), contains(y, member));
    }
  }
  EXPECT_EQ(intersection({1, 2}, {2, 3}), Interval(2));
  EXPECT_EQ(hull(Interval::empty(), {1, 2}), Interval(1, 2));
  EXPECT_TRUE(is_empty(intersection({1, 2}, {3, 4})));
}

TEST(IntervalNumbers, MidpointIsAFiniteMember) {
  EXPECT_EQ(midpoint({1, 3}), 2);
  EXPECT_EQ(midpoint(Interval::entire()), 0);
  EXPECT_EQ(midpoint({5, kInfinity}), kLargest);
  EXPECT_EQ(midpoint({-kInfinity, 5}), -kLargest);
  EXPECT_TRUE(std::isnan(midpoint(Interval::empty())));
  EXPECT_EQ(midpoint({-kLargest, kLargest}), 0);
  EXPECT_EQ(midpoint(Interval(kLargest)), kLargest);
  EXPECT_EQ(midpoint({kLargest / 2, kLargest}), 0.75 * kLargest);
  EXPECT_EQ(midpoint(Interval(kSmallest)), kSmallest);
  EXPECT_TRUE(contains({kSmallest, 2 * kSmallest}, midpoint({kSmallest, 2 * kSmallest})));
  EXPECT_TRUE(contains({1, std::nextafter(1.0, 2.0)}, midpoint({1, std::nextafter(1.0, 2.0)})));
}

TEST(IntervalNumbers, DoNotDependOnTheRoundingMode) {
  const Interval x(0.1, 0.3);
  const double nearest = midpoint(x);
  const double nearest_width = width(x);
  const UpwardRounding upward;
  EXPECT_EQ(midpoint(x), nearest);
  EXPECT_EQ(width(x), nearest_width);
}

TEST(IntervalNumbers, WidthAndRadiusAreRoundedUp) {
  EXPECT_EQ(width({1, 3}), 2);
  EXPECT_EQ(width({-0x1p-60, 1}), std::nextafter(1.0, 2.0));
  EXPECT_EQ(width({-kLargest, kLargest}), kInfinity);
  EXPECT_EQ(width({0, kInfinity}), kInfinity);
  EXPECT_TRUE(std::isnan(width(Interval::empty())));
  EXPECT_EQ(radius({1, 3}), 1);
  EXPECT_EQ(radius(Interval::entire()), kInfinity);
  EXPECT_EQ(radius(Interval(0.1)), 0);
  const Interval neighbours(1, std::nextafter(1.0, 2.0));
  EXPECT_EQ(radius(neighbours), std::nextafter(1.0, 2.0) - 1);
  EXPECT_TRUE(rounding_is_nearest());
}

TEST(IntervalNumbers, MagnitudeAndMignitude) {
  EXPECT_EQ(magnitude({-3, 2}), 3);
  EXPECT_EQ(mignitude({-3, 2}), 0);
  EXPECT_EQ(mignitude({-3, -2}), 2);
  EXPECT_EQ(mignitude({2, kInfinity}), 2);
  EXPECT_EQ(magnitude({2, kInfinity}), kInfinity);
  EXPECT_TRUE(std::isnan(magnitude(Interval::empty())));
  EXPECT_TRUE(std::isnan(mignitude(Interval::empty())));
}

TEST(IntervalText, HasShortestDigitsThatRoundTrip) {
  EXPECT_EQ(to_string(Interval::empty()), "empty");
  EXPECT_EQ(to_string(Interval::entire()), "entire");
  EXPECT_EQ(to_string({0.1, kInfinity}), "[0.1, inf]");
  EXPECT_EQ(to_string({-0.0, 1e300}), "[0, 1e+300]");
}

}  // namespace
}  // namespace gcslab
