#include "univariate/real_roots.h"

#include <cmath>
#include <gtest/gtest.h>
#include <map>

#include "base/error.h"
#include "base/random.h"
#include "support/fuzz.h"
#include "support/sturm.h"

namespace gcslab {
namespace {

IntegerPolynomial linear(const Rational& root) {
  return IntegerPolynomial({-root.get_num(), root.get_den()});
}

IntegerPolynomial power(const IntegerPolynomial& base, int exponent) {
  IntegerPolynomial result({1});
  for (int i = 0; i < exponent; ++i) result = result * base;
  return result;
}

Rational random_rational(Random& random, std::int64_t size, std::int64_t denominator) {
  Rational result(static_cast<long>(random.integer(-size, size)),
                  static_cast<long>(random.integer(1, denominator)));
  result.canonicalize();
  return result;
}

bool holds(const RealRoot& root, const Rational& x) {
  return root.is_exact() ? root.lower == x : root.lower < x && x < root.upper;
}

/// What Sturm's theorem says of a list of roots: one in each interval, as many as there are in all.
void expect_isolated(const IntegerPolynomial& p, const RealRoots& found, const Rational& lower,
                     const Rational& upper) {
  const SturmChain sturm(p.coefficients());
  EXPECT_EQ(static_cast<int>(found.roots().size()), sturm.count(lower, upper));
  for (std::size_t i = 0; i < found.roots().size(); ++i) {
    const RealRoot& root = found.roots()[i];
    EXPECT_EQ(sturm.count(root.lower, root.upper), 1);
    if (i == 0) continue;
    EXPECT_LT(found.roots()[i - 1].upper, root.lower);
  }
}

TEST(RealRoots, AreThePlantedOnesWithTheirMultiplicities) {
  Random random(fuzz_seed(), "planted_roots");
  for (std::size_t i = 0; i < fuzz_cases(300); ++i) {
    std::map<Rational, int> planted;
    IntegerPolynomial p({3});
    for (int k = 0; k < 4; ++k) {
      const Rational root = random_rational(random, 12, 6);
      const int multiplicity = static_cast<int>(random.integer(1, 3));
      planted[root] += multiplicity;
      p = p * power(linear(root), multiplicity);
    }
    p = p * power(IntegerPolynomial({5, 2, 1}), static_cast<int>(random.below(3)));  // no real roots
    // Ends are roots half of the time.
    const Rational lower = random.below(2) == 0 ? planted.begin()->first : random_rational(random, 12, 6);
    const Rational upper = random.below(2) == 0 ? std::max(lower, planted.rbegin()->first)
                                                : lower + abs(random_rational(random, 12, 6));
    RealRoots found(p, {lower, upper});
    std::size_t next = 0;
    for (const auto& [root, multiplicity] : planted) {
      if (root < lower || root > upper) continue;
      ASSERT_LT(next, found.roots().size());
      EXPECT_TRUE(holds(found.roots()[next], root));
      EXPECT_EQ(found.roots()[next].multiplicity, multiplicity);
      found.refine(next, Rational(1, 1000000));
      EXPECT_TRUE(holds(found.roots()[next], root));
      ++next;
    }
    EXPECT_EQ(next, found.roots().size());
    expect_isolated(p, found, lower, upper);
  }
}

TEST(RealRoots, OfRandomPolynomialsAreAsManyAsSturmCounts) {
  Random random(fuzz_seed(), "random_roots");
  for (std::size_t i = 0; i < fuzz_cases(200); ++i) {
    std::vector<mpz_class> coefficients;
    const auto degree = random.integer(1, 14);
    const std::int64_t size = random.below(2) == 0 ? 3 : 1'000'000;
    for (std::int64_t k = 0; k < degree; ++k)
      coefficients.emplace_back(static_cast<long>(random.integer(-size, size)));
    coefficients.emplace_back(1);
    const IntegerPolynomial p(coefficients);
    const Rational lower = random_rational(random, 4, 8);
    const Rational upper = lower + abs(random_rational(random, 8, 8));
    expect_isolated(p, RealRoots(p, {lower, upper}), lower, upper);
    const RealRoots everywhere(p, {});
    EXPECT_EQ(static_cast<int>(everywhere.roots().size()), SturmChain(coefficients).count());
    const auto right = RealRoots(p, {lower, std::nullopt}).roots().size();
    const auto left = RealRoots(p, {std::nullopt, lower}).roots().size();
    const bool is_root = SignEvaluator(p).sign(lower) == 0;
    EXPECT_EQ(left + right, everywhere.roots().size() + (is_root ? 1 : 0));
  }
}

TEST(RealRoots, AreSeparatedHoweverCloseTheyAre) {
  for (const unsigned long digits : {6UL, 12UL, 40UL, 300UL}) {
    mpz_class ten_power;
    mpz_ui_pow_ui(ten_power.get_mpz_t(), 10, digits);
    const Rational gap(1, ten_power);
    const Rational left(1, 3);
    const IntegerPolynomial p = linear(left) * linear(left + gap) * linear(-left);
    RealRoots found(p, {-1, 1});
    ASSERT_EQ(found.roots().size(), 3u);
    EXPECT_TRUE(holds(found.roots()[1], left));
    EXPECT_TRUE(holds(found.roots()[2], left + gap));
    // Nearly a double root, and yet none.
    IntegerPolynomial none({ten_power + 1, -2 * ten_power, ten_power});
    EXPECT_TRUE(RealRoots(none, {0, 2}).roots().empty());
  }
}

TEST(RealRoots, OfWilkinsonsPolynomialAreItsIntegers) {
  IntegerPolynomial p({1});
  for (int k = 1; k <= 20; ++k) p = p * linear(k);
  RealRoots found(p, {});
  ASSERT_EQ(found.roots().size(), 20u);
  for (std::size_t k = 0; k < 20; ++k)
    EXPECT_TRUE(holds(found.roots()[k], Rational(static_cast<long>(k + 1))));
  // Wilkinson's perturbation by 2^-23 of the coefficient of x^19 leaves 10 real roots (1959).
  std::vector<mpz_class> perturbed = p.coefficients();
  for (mpz_class& c : perturbed) c <<= 23;
  perturbed[19] -= 1;
  EXPECT_EQ(RealRoots(IntegerPolynomial(perturbed), {}).roots().size(), 10u);
}

TEST(RealRoots, OfMignottesPolynomialsAreFound) {
  for (const int degree : {5, 12, 41}) {  // x^d - 2 (100 x - 1)^2
    std::vector<mpz_class> c(static_cast<std::size_t>(degree) + 1);
    c[0] = -2;
    c[1] = 400;
    c[2] = -20000;
    c[static_cast<std::size_t>(degree)] += 1;
    const IntegerPolynomial p(c);
    const RealRoots found(p, {});
    EXPECT_EQ(found.roots().size(), degree % 2 == 0 ? 4u : 3u);
    expect_isolated(p, found, -20000, 20000);
  }
}

TEST(RealRoots, OfChebyshevsPolynomialsAreCosines) {
  IntegerPolynomial previous({1}), current({0, 1});
  for (int degree = 2; degree <= 50; ++degree) {
    IntegerPolynomial next = IntegerPolynomial({0, 2}) * current - previous;
    previous = std::move(current);
    current = std::move(next);
  }
  RealRoots found(current, {-1, 1});
  ASSERT_EQ(found.roots().size(), 50u);
  for (std::size_t k = 0; k < 50; ++k) {
    found.refine(k, Rational(1, 1UL << 60));
    const double cosine = std::cos((2 * (50 - static_cast<double>(k)) - 1) * M_PI / 100);
    EXPECT_NEAR(found.roots()[k].lower.get_d(), cosine, 1e-15);
  }
}

TEST(RealRoots, AtTheEndsBelongToTheClosedInterval) {
  const IntegerPolynomial p = linear(0) * power(linear(1), 2) * linear(Rational(1, 2)) * linear(2);
  EXPECT_EQ(RealRoots(p, {0, 1}).roots().size(), 3u);
  EXPECT_EQ(RealRoots(p, {1, 1}).roots().size(), 1u);
  EXPECT_EQ(RealRoots(p, {Rational(1, 3), Rational(1, 3)}).roots().size(), 0u);
  const Rational little(1, 1UL << 60);
  EXPECT_EQ(RealRoots(p, {little, 1 - little}).roots().size(), 1u);
  EXPECT_EQ(RealRoots(p, {-little, 1 + little}).roots().size(), 3u);
}

TEST(RealRoots, AreNoneOfAConstantAndUndefinedForZero) {
  EXPECT_TRUE(RealRoots(IntegerPolynomial({7}), {}).roots().empty());
  EXPECT_THROW(RealRoots(IntegerPolynomial(), {}), NotApplicable);
  EXPECT_THROW(RealRoots(IntegerPolynomial({0, 1}), {1, 0}), NotApplicable);
}

TEST(RealRoots, AreFoundBeyondTheRangeOfDoubles) {
  const mpz_class huge = mpz_class(1) << 5000;
  RealRoots found(IntegerPolynomial({-huge, 0, 1}) * IntegerPolynomial({-1, huge}), {});
  ASSERT_EQ(found.roots().size(), 3u);
  EXPECT_TRUE(holds(found.roots()[0], Rational(-(mpz_class(1) << 2500))));
  EXPECT_TRUE(holds(found.roots()[1], Rational(mpz_class(1), huge)));
  EXPECT_TRUE(holds(found.roots()[2], Rational(mpz_class(1) << 2500)));
}

TEST(RealRoots, AreRefinedToAnyWidth) {
  RealRoots found(power(IntegerPolynomial({-2, 0, 1}), 3), {0, std::nullopt});
  ASSERT_EQ(found.roots().size(), 1u);
  found.refine_relative(0, 3000);
  const RealRoot& root = found.roots()[0];
  EXPECT_EQ(root.multiplicity, 3);
  EXPECT_LT(root.lower * root.lower, 2);
  EXPECT_GT(root.upper * root.upper, 2);
  EXPECT_LE(root.upper - root.lower, Rational(mpz_class(2), mpz_class(1) << 3000));
}

TEST(RealRoots, ZeroBecomesExact) {
  RealRoots found(IntegerPolynomial({0, 0, -3, 1}), {-1, 5});
  ASSERT_EQ(found.roots().size(), 2u);
  found.refine_relative(0, 53);
  EXPECT_TRUE(found.roots()[0].is_exact());
  EXPECT_EQ(found.roots()[0].lower, 0);
  EXPECT_EQ(found.roots()[0].multiplicity, 2);
}

TEST(RealRoots, AreListedOrInWhatWasNotSearchedWhenStopped) {
  std::stop_source source;
  source.request_stop();
  const RealRoots stopped(linear(1) * linear(2), {0, 3}, source.get_token());
  EXPECT_TRUE(stopped.roots().empty());
  ASSERT_EQ(stopped.unsearched().size(), 1u);
  EXPECT_EQ(stopped.unsearched()[0].lower, 0);
  EXPECT_EQ(stopped.unsearched()[0].upper, 3);
}

TEST(RootBound, ExceedsEveryRoot) {
  Random random(fuzz_seed(), "root_bound");
  for (std::size_t i = 0; i < fuzz_cases(200); ++i) {
    IntegerPolynomial p({1});
    Rational largest = 0;
    for (int k = 0; k < 6; ++k) {
      const Rational root = random_rational(random, 100000, 1000);
      largest = std::max(largest, Rational(abs(root)));
      p = p * linear(root);
    }
    EXPECT_LT(largest, root_bound(p));
    EXPECT_LE(root_bound(p), 100 * largest + 1);  // and not by much
  }
}

}  // namespace
}  // namespace gcslab
