#include "univariate/first_root.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "polynomial/exact_conversion.h"
#include "support/fuzz.h"
#include "support/sturm.h"

namespace gcslab {
namespace {

/// Few terms of degree 5 at most in three variables.
Polynomial random_surface(Random& random) {
  Polynomial result(3);
  for (int k = 0; k < 6; ++k) {
    const Exponents exponents = {static_cast<int>(random.below(3)), static_cast<int>(random.below(2)),
                                 static_cast<int>(random.below(3))};
    result.add_term(exponents, Rational(static_cast<long>(random.integer(-9, 9))) / 4);
  }
  return result;
}

std::vector<double> random_point(Random& random) {
  std::vector<double> point;
  for (int i = 0; i < 3; ++i) point.push_back(static_cast<double>(random.integer(-24, 24)) / 8);
  return point;
}

std::vector<Rational> exact(const std::vector<double>& point) { return {point.begin(), point.end()}; }

/// f(from + t (to - from)) by substitution in the power basis.
Polynomial along(const Polynomial& f, const std::vector<double>& from, const std::vector<double>& to) {
  std::vector<Polynomial> coordinates;
  for (std::size_t i = 0; i < 3; ++i) {
    Polynomial coordinate = Polynomial::constant(1, Rational(from[i]));
    coordinate += Rational(Rational(to[i]) - Rational(from[i])) * Polynomial::variable(1, 0);
    coordinates.push_back(coordinate);
  }
  Polynomial result(1);
  for (const auto& [exponents, coefficient] : f.terms()) {
    Polynomial term = Polynomial::constant(1, coefficient);
    for (std::size_t i = 0; i < 3; ++i) term = term * pow(coordinates[i], exponents[i]);
    result += term;
  }
  return result;
}

TEST(SegmentRestriction, IsThePolynomialAlongTheSegment) {
  Random random(fuzz_seed(), "segment_restriction");
  for (std::size_t i = 0; i < fuzz_cases(300); ++i) {
    const Polynomial f = random_surface(random);
    const std::vector<double> from = random_point(random), to = random_point(random);
    const SegmentRestriction<Rational> restriction(f);
    const std::vector<Rational> b = restriction.bernstein_coefficients(exact(from), exact(to));
    const Polynomial g = along(f, from, to);
    // The classical conversion of the same polynomial to the same degree.
    const Tensor<Rational> expected = exact_bernstein_coefficients(g, {{0, 1}}, {restriction.degree()});
    EXPECT_EQ(b, expected.coefficients());

    const NumberTraits<FastInterval>::Scope scope;
    std::vector<FastInterval> start(from.begin(), from.end()), end(to.begin(), to.end());
    const auto enclosures = SegmentRestriction<FastInterval>(f).bernstein_coefficients(start, end);
    for (std::size_t k = 0; k < b.size(); ++k) {
      EXPECT_LE(Rational(enclosures[k].lower()), b[k]);
      EXPECT_GE(Rational(enclosures[k].upper()), b[k]);
    }
  }
}

void expect_first(const FirstRoot& root, const Polynomial& g) {
  if (g.is_zero()) {
    EXPECT_TRUE(root.exists && root.t == Interval(0));
    return;
  }
  const SturmChain sturm(primitive_polynomial(g).coefficients());
  EXPECT_EQ(root.exists, sturm.count(0, 1) > 0);
  if (!root.exists) return;
  const Rational lower(root.t.lower), upper(root.t.upper);
  EXPECT_EQ(sturm.count(0, lower), sturm.count(lower, lower)) << "a root before the first one";
  EXPECT_GE(sturm.count(lower, upper), 1);
  EXPECT_LE(width(root.t), 1.0);
}

TEST(FirstRoot, IsTheFirstThatSturmCounts) {
  Random random(fuzz_seed(), "first_root");
  std::size_t hits = 0, exact_ones = 0;
  for (std::size_t i = 0; i < fuzz_cases(500); ++i) {
    const Polynomial f = random_surface(random);
    const std::vector<double> from = random_point(random), to = random_point(random);
    const Polynomial g = along(f, from, to);
    const FirstRootFinder finder(f);
    const FirstRoot root = finder.find(from, to);
    expect_first(root, g);
    expect_first(finder.find_exactly(from, to), g);
    hits += root.exists ? 1 : 0;
    exact_ones += root.was_exact ? 1 : 0;
  }
  EXPECT_GT(hits, 0u);
  EXPECT_LT(exact_ones, fuzz_cases(500) / 2);
}

/// x^2 + y^2 + z^2 = 1.
Polynomial sphere() {
  Polynomial f = Polynomial::constant(3, -1);
  for (int i = 0; i < 3; ++i) f += pow(Polynomial::variable(3, i), 2);
  return f;
}

TEST(FirstRoot, TellsATangentFromAMiss) {
  const FirstRootFinder finder(sphere());
  const auto ray = [&](double height) {
    return finder.find(std::vector<double>{-2, height, 0}, std::vector<double>{2, height, 0});
  };
  const FirstRoot tangent = ray(1);
  EXPECT_TRUE(tangent.exists && tangent.was_exact);
  EXPECT_TRUE(contains(tangent.t, 0.5));
  EXPECT_FALSE(ray(1 + 0x1p-40).exists);
  const FirstRoot grazing = ray(1 - 0x1p-40);
  EXPECT_TRUE(grazing.exists);
  EXPECT_LE(grazing.t.upper, 0.5);
}

TEST(FirstRoot, OnTheStartIsTheStart) {
  const FirstRootFinder finder(sphere());
  const FirstRoot root = finder.find(std::vector<double>{-1, 0, 0}, std::vector<double>{2, 0, 0});
  EXPECT_TRUE(root.exists);
  EXPECT_EQ(root.t, Interval(0));
  Polynomial plane = Polynomial::variable(3, 2);
  const FirstRoot inside =
      FirstRootFinder(plane).find(std::vector<double>{-1, 0, 0}, std::vector<double>{2, 5, 0});
  EXPECT_TRUE(inside.exists);
  EXPECT_EQ(inside.t, Interval(0));
}

TEST(FirstRoot, SeesASheetThinnerThanAnyStep) {
  const Polynomial near = Polynomial::variable(3, 0) - Polynomial::constant(3, Rational(1, 3));
  const Polynomial far = near - Polynomial::constant(3, Rational(1, 1'000'000'000));
  const FirstRoot root =
      FirstRootFinder(near * far).find(std::vector<double>{0, 0, 0}, std::vector<double>{1, 0, 0});
  ASSERT_TRUE(root.exists);
  EXPECT_LE(Rational(root.t.lower), Rational(1, 3));
  EXPECT_GE(Rational(root.t.upper), Rational(1, 3));
}

}  // namespace
}  // namespace gcslab
