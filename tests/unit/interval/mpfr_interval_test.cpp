#include "interval/mpfr_interval.h"

#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "base/check.h"

namespace gcslab {
namespace {

using Traits = NumberTraits<MpfrInterval>;

double width_exponent(const MpfrInterval& x) {
  MpfrNumber width;
  mpfr_sub(width.get(), x.upper(), x.lower(), MPFR_RNDU);
  return static_cast<double>(mpfr_get_exp(width.get()));
}

TEST(MpfrIntervals, HaveThePrecisionOfTheInnermostScope) {
  const Traits::Scope outer(100);
  EXPECT_EQ(mpfr_get_prec(Traits::pi().lower()), 100);
  {
    const Traits::Scope inner(300);
    EXPECT_EQ(mpfr_get_prec(Traits::pi().lower()), 300);
    EXPECT_LT(width_exponent(Traits::from_rational(Rational(1, 3))), -295);
  }
  EXPECT_EQ(mpfr_get_prec(Traits::pi().lower()), 100);
  EXPECT_THROW(Traits::Scope(1), InvariantError);
}

TEST(MpfrIntervals, MayBeCopiedMovedAndAssigned) {
  const Traits::Scope scope(80);
  MpfrInterval x = Traits::from_interval({1, 2});
  MpfrInterval copy = x;
  const MpfrInterval moved = std::move(x);
  EXPECT_EQ(moved.interval(), Interval(1, 2));
  copy = copy + copy;
  EXPECT_EQ(copy.interval(), Interval(2, 4));
  MpfrInterval& alias = copy;
  copy = alias;
  EXPECT_EQ(copy.interval(), Interval(2, 4));
  std::vector<MpfrInterval> many;
  for (int i = 0; i < 20; ++i) many.push_back(moved);
  many.erase(many.begin());
  std::swap(many.front(), many.back());
  EXPECT_EQ(many.front().interval(), Interval(1, 2));
}

TEST(MpfrIntervals, RoundOutwardFromOnePrecisionToAnother) {
  const auto precise = [] {
    const Traits::Scope scope(200);
    return Traits::from_rational(Rational(1, 3));
  }();
  const Traits::Scope coarse(20);
  const MpfrInterval negated = -precise;
  EXPECT_EQ(mpfr_get_prec(negated.lower()), 20);
  EXPECT_GT(width_exponent(negated), -30);
  EXPECT_TRUE(contains(negated.interval(), -1.0 / 3.0));
  EXPECT_TRUE(contains(min(precise, precise).interval(), 1.0 / 3.0));
}

TEST(MpfrIntervals, DoNotOverflowLikeDoubles) {
  const Traits::Scope scope(60);
  const MpfrInterval large = Traits::from_interval(1e300);
  const MpfrInterval product = large * large;
  EXPECT_TRUE(mpfr_number_p(product.upper()));
  EXPECT_EQ(product.interval(),
            Interval(std::numeric_limits<double>::max(), std::numeric_limits<double>::infinity()));
  EXPECT_TRUE(contains((product / large).interval(), 1e300));
}

TEST(MpfrIntervals, AreSharpAtHighPrecision) {
  const Traits::Scope scope(500);
  const MpfrInterval two = Traits::from_interval(2);
  EXPECT_LT(width_exponent(sqr(sqrt(two)) - two), -490);
  EXPECT_LT(width_exponent(exp(log(two)) - two), -490);
  EXPECT_LT(width_exponent(pow(pow(two, Rational(2, 7)), Rational(7, 2)) - two), -490);
}

}  // namespace
}  // namespace gcslab
