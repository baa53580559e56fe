#include "verifier/root_counter.h"

#include <gtest/gtest.h>
#include <limits>
#include <map>

#include "base/random.h"
#include "support/fuzz.h"

namespace gcslab::verifier {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

PolynomialTerms product(const PolynomialTerms& a, const PolynomialTerms& b) {
  PolynomialTerms result;
  for (const auto& [i, x] : a) {
    for (const auto& [k, y] : b) result[{i[0] + k[0]}] += x * y;
  }
  std::erase_if(result, [](const auto& term) { return term.second == 0; });
  return result;
}

PolynomialTerms linear(const Rational& root) {
  PolynomialTerms result = {{{1}, 1}};
  if (root != 0) result[{0}] = -root;
  return result;
}

TEST(RootCounter, CountsPlantedRootsAndTheirMultiplicities) {
  Random random(fuzz_seed(), "root_counter");
  for (std::size_t i = 0; i < fuzz_cases(300); ++i) {
    std::map<double, int> planted;
    PolynomialTerms p = {{{0}, Rational(-2, 3)}};
    for (int k = 0; k < 5; ++k) {
      const double root = static_cast<double>(random.integer(-6, 6)) / 4;
      ++planted[root];
      p = product(p, linear(Rational(root)));
    }
    if (random.below(2) == 0) p = product(p, {{{2}, 1}, {{0}, 3}});  // no real roots
    const RootCounter counter(p);
    const double lower = static_cast<double>(random.integer(-6, 6)) / 4;
    const double upper = lower + static_cast<double>(random.integer(0, 6)) / 4;
    int inside = 0;
    for (const auto& [root, multiplicity] : planted) {
      if (root >= lower && root <= upper) ++inside;
      EXPECT_EQ(counter.multiplicity({root - 0.1, root + 0.1}), multiplicity);
      EXPECT_EQ(counter.multiplicity({root, root}), multiplicity);
    }
    EXPECT_EQ(counter.count({lower, upper}), inside);
    EXPECT_EQ(counter.count(Interval::entire()), static_cast<int>(planted.size()));
    EXPECT_EQ(counter.count({-kInfinity, lower}) + counter.count({lower, kInfinity}),
              static_cast<int>(planted.size()) + (planted.contains(lower) ? 1 : 0));
  }
}

TEST(RootCounter, CountsRootsOfOverlappingIntervalsOnce) {
  const RootCounter counter(product(linear(0), product(linear(1), linear(2))));
  EXPECT_EQ(counter.count_in_union({{-1, 1}, {0, 2}, {1, 1}}), 3);
  EXPECT_EQ(counter.count_in_union({{0, 0.5}, {0.5, 1}}), 2);
  EXPECT_EQ(counter.count_in_union({{1.5, 3}, {-1, -0.5}}), 1);
  EXPECT_EQ(counter.count_in_union(std::vector<Interval>{}), 0);
  EXPECT_EQ(counter.multiplicity({0, 1}), 0);  // there are two
}

TEST(RootCounter, OfAConstantCountsNothing) {
  EXPECT_EQ(RootCounter(PolynomialTerms{{{0}, -7}}).count(Interval::entire()), 0);
}

}  // namespace
}  // namespace gcslab::verifier
