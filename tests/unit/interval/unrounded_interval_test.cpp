#include "interval/unrounded_interval.h"

#include <gtest/gtest.h>
#include <limits>

namespace gcslab {
namespace {

UnroundedInterval unrounded(const Interval& x) { return UnroundedInterval(x); }

TEST(UnroundedIntervals, GiveWhatRoundingToNearestGives) {
  const NumberTraits<UnroundedInterval>::Scope scope;
  EXPECT_EQ((unrounded(1) / unrounded(3)).interval(), Interval(1.0 / 3.0));
  EXPECT_EQ((unrounded(0.1) + unrounded(0.2)).interval(), Interval(0.1 + 0.2));
  EXPECT_EQ(sqr(unrounded({-0.1, 0.3})).interval(), Interval(0, 0.3 * 0.3));
  EXPECT_EQ(NumberTraits<UnroundedInterval>::from_rational(Rational(1, 10)).interval(), Interval(0.1));
}

TEST(UnroundedIntervals, OverflowToNonemptyIntervals) {
  const double largest = std::numeric_limits<double>::max();
  const UnroundedInterval large = unrounded(largest);
  EXPECT_FALSE(is_empty((large + large).interval()));
  EXPECT_EQ((large * large).interval().lower, largest);
  EXPECT_EQ((-large - large).interval().upper, -largest);
  EXPECT_FALSE(is_empty(exp(large).interval()));
}

TEST(UnroundedIntervals, AreABaseline) {
  EXPECT_EQ(NumberTraits<UnroundedInterval>::promise, Promise::baseline);
}

}  // namespace
}  // namespace gcslab
