// Expansions equal their equations, exactly at random rational points; combined rows keep every root.

#include "box_solver/expansion.h"

#include <gtest/gtest.h>

#include "box_solver/combined_row.h"
#include "support/fuzz.h"
#include "support/planted_system.h"
#include "support/random_polynomial.h"

namespace gcslab {
namespace {

using planted::Point;
using planted::system_of;

template <class T>
class ExpansionOf : public ::testing::Test {
 protected:
  const typename NumberTraits<T>::Scope scope_{90};
};

using Types = ::testing::Types<FastInterval, BoostInterval, MpfrInterval>;
TYPED_TEST_SUITE(ExpansionOf, Types);

Rational monomial_value(const ScaledMonomial& monomial, const Point& z) {
  Rational value = 1;
  for (const auto& [variable, exponent] : monomial.factors) value *= pow(z[variable], exponent);
  return value;
}

/// Encloses the row at a point of z.
template <class T>
T value_of(const ExpansionPlan& plan, const ExpansionRow<T>& row, const Point& z) {
  T sum = row.constant;
  for (std::size_t c = 0; c < row.columns.size(); ++c) {
    const Rational monomial = monomial_value(plan.columns()[row.columns[c]], z);
    sum = sum + row.values[c] * NumberTraits<T>::from_rational(monomial);
  }
  return sum;
}

Point random_scaled_point(Random& random, std::size_t size) {
  Point z;
  for (std::size_t i = 0; i < size; ++i) z.emplace_back(Rational(random.integer(-8, 8)) / 8);
  return z;
}

/// Of three sides within [-3, 4], some of them narrow.
Box random_box(Random& random) {
  Box box;
  for (int j = 0; j < 3; ++j) {
    const double lower = random.uniform(-3, 3);
    box.emplace_back(lower, lower + std::ldexp(random.unit(), -static_cast<int>(random.integer(0, 40))));
  }
  return box;
}

/// The point that z stands for.
template <class T>
Point unscaled(const Expansion<T>& expansion, const Point& z) {
  Point x;
  for (std::size_t j = 0; j < z.size(); ++j) {
    x.push_back(rational_from_double(expansion.midpoints()[j]) +
                rational_from_double(expansion.radii()[j]) * z[j]);
  }
  return x;
}

TYPED_TEST(ExpansionOf, EqualsItsEquationsInTheBox) {
  // The last two are no polynomials but have exact values.
  const SystemFunctions functions(
      system_of({"x", "y", "z"}, {"x^3*y - 2*x*z^2 + 1/3", "(x - y)^2*z + x - 7", "x + 2*y - z/3",
                                  "x*y/(z^2 + 1) - 1", "abs(x*y) + max(y, z)"}));
  const ExpansionPlan plan(functions);
  EXPECT_TRUE(plan.is_expanded(0) && plan.is_expanded(1) && plan.is_expanded(2));
  EXPECT_FALSE(plan.is_expanded(3) || plan.is_expanded(4));
  Expansion<TypeParam> expansion(plan);
  Random random(fuzz_seed(), "expansion");
  for (std::size_t i = 0; i < fuzz_cases(500); ++i) {
    const Box box = random_box(random);
    expansion.expand(box);
    const Point z = random_scaled_point(random, 3);
    const Point x = unscaled(expansion, z);
    if (!planted::contains(box, x)) continue;  // the radius is rounded up
    for (std::size_t k = 0; k < functions.equations().size(); ++k) {
      const Rational exact = planted::exact_value(functions.equations()[k].expression, x);
      ASSERT_TRUE(encloses(value_of(plan, expansion.row(k), z), exact)) << "equation " << k;
    }
  }
}

TYPED_TEST(ExpansionOf, QuotientsEqualTheirEquationsDividedByAVariable) {
  const SystemFunctions functions(system_of(
      {"x", "y", "z"}, {"x^3*y - 2*x*z^2 + 1/3", "x*y - 5/7", "x*y + y*z", "x^2 - 2", "x*y + z - 1"}));
  const ExpansionPlan plan(functions, ExpandedFunctions::equations_and_multiples);
  // Not the third, which has no constant, nor the fourth, which has nothing but x, nor the last.
  const std::vector<EquationMultiple>& multiples = plan.multiples();
  ASSERT_EQ(std::ranges::count_if(multiples, &EquationMultiple::is_quotient), 3);
  ASSERT_EQ(plan.rows(), 5 + multiples.size());
  Expansion<TypeParam> expansion(plan);
  Random random(fuzz_seed(), "quotients");
  std::size_t checked = 0;
  for (std::size_t i = 0; i < fuzz_cases(500); ++i) {
    const Box box = random_box(random);
    expansion.expand(box);
    const Point z = random_scaled_point(random, 3);
    const Point x = unscaled(expansion, z);
    if (!planted::contains(box, x)) continue;  // the radius is rounded up
    for (std::size_t q = 0; q < multiples.size(); ++q) {
      if (!multiples[q].is_quotient) continue;
      const std::uint32_t equation = multiples[q].equation, variable = multiples[q].variables[0];
      const ExpansionRow<TypeParam>& row = expansion.row(5 + q);
      ASSERT_EQ(contains(box[variable], 0), is_entire(NumberTraits<TypeParam>::enclosure(row.constant)));
      if (contains(box[variable], 0)) continue;
      const Rational exact =
          planted::exact_value(functions.equations()[equation].expression, x) / x[variable];
      ASSERT_TRUE(encloses(value_of(plan, row, z), exact)) << "quotient " << q;
      ++checked;
    }
  }
  EXPECT_GT(checked, 0U);
}

TYPED_TEST(ExpansionOf, ProductsEqualTheirEquationsTimesAMonomialThatBringsNoNewOnes) {
  const SystemFunctions functions(
      system_of({"x", "y"}, {"x - 2*y + 1/3", "x^2*y - 3*x*y^2 + x*y - 1", "y^2 + x*y - x^2 - y"}));
  const ExpansionPlan plan(functions, ExpandedFunctions::equations_and_multiples);
  std::vector<std::pair<std::uint32_t, std::vector<std::uint32_t>>> products;
  for (const EquationMultiple& multiple : plan.multiples()) {
    if (!multiple.is_quotient) products.emplace_back(multiple.equation, multiple.variables);
  }
  // x times the first needs x^2, x y, x; y times it x y, y^2, y; x y times it x^2 y, x y^2, x y. None of the
  // others has a multiple: x^2 y^2 or y^3 would be needed.
  const decltype(products) expected = {{0, {1}}, {0, {0}}, {0, {0, 1}}};
  EXPECT_TRUE(std::ranges::is_permutation(products, expected));
  Expansion<TypeParam> expansion(plan);
  Random random(fuzz_seed(), "products");
  std::size_t checked = 0;
  for (std::size_t i = 0; i < fuzz_cases(500); ++i) {
    Box box = random_box(random);
    box.pop_back();
    expansion.expand(box);
    const Point z = random_scaled_point(random, 2);
    const Point x = unscaled(expansion, z);
    for (std::size_t m = 0; m < plan.multiples().size(); ++m) {
      const auto& [equation, variables, is_quotient] = plan.multiples()[m];
      if (is_quotient) continue;
      Rational exact = planted::exact_value(functions.equations()[equation].expression, x);
      for (const std::uint32_t variable : variables) exact *= x[variable];
      ASSERT_TRUE(encloses(value_of(plan, expansion.row(3 + m), z), exact)) << "multiple " << m;
      ++checked;
    }
  }
  EXPECT_GT(checked, 0U);
}

TYPED_TEST(ExpansionOf, SaysNothingWhereAnEquationMayBeUndefined) {
  const SystemFunctions functions(system_of({"x"}, {"sqrt(x) - 1/2"}));
  const ExpansionPlan plan(functions);
  Expansion<TypeParam> expansion(plan);
  expansion.expand({{-1, 1}});
  EXPECT_TRUE(is_entire(NumberTraits<TypeParam>::enclosure(expansion.row(0).constant)));
  expansion.expand({{0, 1}});
  EXPECT_TRUE(is_bounded(NumberTraits<TypeParam>::enclosure(expansion.row(0).constant)));
}

TYPED_TEST(ExpansionOf, CombinedRowsKeepTheRoot) {
  // Each equation vanishes at (1/3, -1/7, 2/5).
  const SystemFunctions functions(
      system_of({"x", "y", "z"}, {"x^2 + y - z^2 - (1/9 - 1/7 - 4/25)", "x*y + z^3*x - (-1/21 + 8/375)",
                                  "y^2 - 2*z^2 + x - (1/49 - 8/25 + 1/3)"}));
  const Point root = {Rational(1, 3), Rational(-1, 7), Rational(2, 5)};
  const ExpansionPlan plan(functions);
  Expansion<TypeParam> expansion(plan);
  CombinedRow<TypeParam> row(plan);
  Random random(fuzz_seed(), "combined_row");
  planted::PlantedGenerator generator(random);
  for (std::size_t i = 0; i < fuzz_cases(2000); ++i) {
    const Box box = generator.box_around(root);
    if (!std::ranges::all_of(box, is_bounded) || !planted::contains(box, root)) continue;
    expansion.expand(box);
    std::vector<double> multipliers;
    for (int k = 0; k < 3; ++k) multipliers.push_back(random.below(4) == 0 ? 0 : random.uniform(-2, 2));
    row.combine(expansion, multipliers);
    std::vector<TypeParam> z;
    Point exact;
    for (std::size_t j = 0; j < 3; ++j) {
      const Rational radius = rational_from_double(expansion.radii()[j]);
      const Rational offset = root[j] - rational_from_double(expansion.midpoints()[j]);
      exact.push_back(radius == 0 ? Rational(0) : Rational(offset / radius));
      // Ends that are no doubles.
      const TypeParam centre = NumberTraits<TypeParam>::from_rational(exact.back());
      const TypeParam size = NumberTraits<TypeParam>::from_rational(Rational(random.integer(0, 9)) / 11);
      z.push_back(intersection(hull(centre - size, centre), NumberTraits<TypeParam>::from_interval({-1, 1})));
    }
    expansion.bound_columns(z);
    for (std::size_t j = 0; j < 3; ++j) {
      ASSERT_TRUE(encloses(row.solve(j, z, expansion), exact[j]))
          << planted::to_text(box) << " variable " << j;
      ASSERT_TRUE(encloses(row.solve_square(j, z, expansion), exact[j]))
          << planted::to_text(box) << " square of variable " << j;
    }
  }
}

TEST(CombinedRow, KnowsTheRangeOfASquareTermWhoseVertexLiesJustBesideTheBox) {
  // y starts 2^-100 above the vertex 1/3, but the double below that start lies farther off on the other side.
  const SystemFunctions functions(system_of({"x", "y"}, {"x + (y - 1/3)^2 - 3/2"}));
  const ExpansionPlan plan(functions);
  const NumberTraits<MpfrInterval>::Scope scope(240);
  Expansion<MpfrInterval> expansion(plan);
  expansion.expand({{-2, 2}, {-1, 1}});
  CombinedRow<MpfrInterval> row(plan);
  row.combine(expansion, std::vector<double>{1.0});
  const Rational offset = rational_from_double(0x1p-100);
  const MpfrInterval start = NumberTraits<MpfrInterval>::from_rational(Rational(1, 3) + offset);
  const std::vector<MpfrInterval> z = {MpfrInterval(Interval(-1, 1)), hull(start, MpfrInterval(Interval(1)))};
  expansion.bound_columns(z);
  const MpfrInterval solved = row.solve(0, z, expansion);  // x = 2 z_0
  EXPECT_TRUE(encloses(solved, Rational((Rational(3, 2) - offset * offset) / 2)));
  EXPECT_TRUE(encloses(solved, Rational(19, 36)));
}

}  // namespace
}  // namespace gcslab
