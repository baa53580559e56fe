// Exact factorisation, vertices and optima against hand-made and multiplied-out answers.

#include <gtest/gtest.h>

#include "base/random.h"
#include "linear_program/exact_basis.h"
#include "linear_program/exact_bound.h"
#include "linear_program/exact_factorisation.h"
#include "linear_program/exact_simplex.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

using Rows = std::vector<ExactFactorisation::SparseRow>;

Rows random_matrix(Random& random, std::size_t size) {
  Rows rows(size);
  for (auto& row : rows) {
    for (std::size_t j = 0; j < size; ++j) {
      if (random.below(3) == 0) row[j] = Rational(random.integer(1, 9)) / random.integer(1, 9);
    }
  }
  return rows;
}

std::vector<Rational> random_vector(Random& random, std::size_t size) {
  std::vector<Rational> result;
  for (std::size_t j = 0; j < size; ++j) result.emplace_back(random.integer(-9, 9));
  return result;
}

TEST(ExactFactorisation, SolutionsSatisfyTheirEquations) {
  Random random(fuzz_seed(), "factorisation");
  int regular = 0;
  for (int i = 0; i < 300; ++i) {
    const std::size_t size = 1 + random.below(8);
    const Rows rows = random_matrix(random, size);
    const ExactFactorisation factors(rows, size);
    if (!factors.is_regular()) continue;
    ++regular;
    const auto b = random_vector(random, size);
    const auto x = factors.solve(b);
    const auto y = factors.solve_transposed(b);
    std::vector<Rational> transposed(size);
    for (std::size_t row = 0; row < size; ++row) {
      Rational product = 0;
      for (const auto& [column, value] : rows[row]) {
        product += value * x[column];
        transposed[column] += value * y[row];
      }
      EXPECT_EQ(product, b[row]);
    }
    EXPECT_EQ(transposed, b);
  }
  EXPECT_GT(regular, 50);
}

TEST(ExactFactorisation, NamesDependentRowsAndMissingColumns) {
  const Rows rows = {{{0, 1}, {1, 2}}, {{0, 2}, {1, 4}}, {{2, 1}}};
  const ExactFactorisation factors(rows, 3);
  EXPECT_FALSE(factors.is_regular());
  EXPECT_EQ(factors.dependent_rows().size(), 1U);
  ASSERT_EQ(factors.missing_columns().size(), 1U);
  EXPECT_LT(factors.missing_columns()[0], 2U);
}

/// min -x - y, x + 3 y <= 3/2 and 3 x + y <= 3/2 in [0, 1]^2: optimum -3/4 at (3/8, 3/8).
LpModel triangle() {
  const double infinity = std::numeric_limits<double>::infinity();
  LpModel model;
  model.add_column({0, 1});
  model.add_column({0, 1});
  model.add_row(std::vector<LinearTerm>{{0, 1.0}, {1, 3.0}}, {-infinity, 1.5});
  model.add_row(std::vector<LinearTerm>{{0, 3.0}, {1, 1.0}}, {-infinity, 1.5});
  return model;
}

const std::vector<LinearTerm> kDown = {{0, -1.0}, {1, -1.0}};

TEST(ExactVertex, TellsOptimalFromFeasibleFromNeither) {
  using enum LpActivity;
  const LpModel model = triangle();
  const ExactVertex optimum = exact_vertex(model, kDown, {{free, free}, {at_upper, at_upper}});
  EXPECT_TRUE(optimum.is_optimal());
  EXPECT_EQ(optimum.objective, Rational(-3, 4));
  EXPECT_EQ(optimum.multipliers[0], Rational(-1, 4));
  const ExactVertex corner = exact_vertex(model, kDown, {{at_lower, at_lower}, {free, free}});
  EXPECT_TRUE(corner.primal_feasible);
  EXPECT_FALSE(corner.dual_feasible);
  const ExactVertex outside = exact_vertex(model, kDown, {{at_upper, at_upper}, {free, free}});
  EXPECT_TRUE(outside.dual_feasible);
  EXPECT_FALSE(outside.primal_feasible);
  EXPECT_FALSE(exact_vertex(model, kDown, {{at_lower, free}, {free, free}}).is_vertex);
  EXPECT_FALSE(exact_vertex(model, kDown, {{free, free}, {at_lower, at_upper}}).is_vertex);
}

TEST(ExactSimplex, FindsTheOptimumFromEveryCorner) {
  using enum LpActivity;
  for (const auto x : {free, at_lower, at_upper}) {
    for (const auto y : {free, at_lower, at_upper}) {
      for (const auto row : {free, at_upper}) {
        const ExactSolution solution = ExactSimplex(triangle()).minimise(kDown, {{x, y}, {row, free}});
        ASSERT_EQ(solution.status, LpStatus::optimal);
        EXPECT_EQ(solution.objective, Rational(-3, 4));
      }
    }
  }
}

TEST(ExactSimplex, SaysInfeasibleWithAnExactReason) {
  LpModel model = triangle();
  model.add_row(std::vector<LinearTerm>{{0, 1.0}, {1, 1.0}}, {0.75 + 0x1p-52, 2});
  const ExactSolution solution = ExactSimplex(model).minimise(kDown, {});
  ASSERT_EQ(solution.status, LpStatus::infeasible);
  EXPECT_GT(exact_lower_bound(model, {}, solution.multipliers), 0);
}

TEST(ExactBound, RoundsDown) {
  EXPECT_EQ(rounded_down(Rational(1, 2)), 0.5);
  EXPECT_LT(rational_from_double(rounded_down(Rational(1, 3))), Rational(1, 3));
  EXPECT_LT(rational_from_double(rounded_down(Rational(-1, 3))), Rational(-1, 3));
}

}  // namespace
}  // namespace gcslab
