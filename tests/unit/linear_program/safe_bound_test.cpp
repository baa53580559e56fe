#include "linear_program/safe_bound.h"

#include <gtest/gtest.h>

#include "interval/rounding.h"
#include "linear_program/exact_basis.h"
#include "linear_program/exact_bound.h"
#include "linear_program/exact_simplex.h"
#include "linear_program/lp_registry.h"
#include "support/fuzz.h"
#include "support/random_linear_program.h"

namespace gcslab {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<double> random_multipliers(Random& random, const LpModel& model) {
  std::vector<double> result;
  for (int row = 0; row < model.rows(); ++row) {
    const auto kind = random.below(8);
    result.push_back(kind == 0   ? std::numeric_limits<double>::quiet_NaN()
                     : kind == 1 ? kInfinity
                     : kind == 2 ? 0.0
                                 : random.uniform(-3, 3));
  }
  return result;
}

Rational value_at(const std::vector<LinearTerm>& objective, const std::vector<Rational>& point, bool upper) {
  Rational total = 0;
  for (const LinearTerm& term : objective) {
    total += rational_from_double(upper ? term.coefficient.upper : term.coefficient.lower) *
             point[static_cast<std::size_t>(term.column)];
  }
  return total;
}

TEST(SafeBound, LiesJustBelowTheExactBoundOfTheSameMultipliers) {
  Random random(fuzz_seed(), "safe bound");
  for (std::size_t i = 0; i < fuzz_cases(10000); ++i) {
    const ProgramWithPoint program = random_interval_program(random);
    const auto multipliers = random_multipliers(random, program.model);
    const Rational exact =
        exact_lower_bound(program.model, program.objective, exact_multipliers(multipliers));
    const double safe = safe_lower_bound(program.model, program.objective, multipliers);
    ASSERT_LE(rational_from_double(safe), exact);
    ASSERT_NEAR(safe, nearest_double(exact), 1e-12);
  }
}

TEST(SafeBound, OverflowOnlyLoosensIt) {
  Random random(fuzz_seed(), "overflow");
  int finite = 0;
  for (std::size_t i = 0; i < fuzz_cases(2000); ++i) {
    const ProgramWithPoint program = random_interval_program(random);
    std::vector<double> multipliers = random_multipliers(random, program.model);
    for (double& y : multipliers) y = std::ldexp(y, static_cast<int>(random.integer(-1070, 1023)));
    const double safe = safe_lower_bound(program.model, program.objective, multipliers);
    ASSERT_FALSE(proves_infeasible(program.model, multipliers));
    if (safe == -kInfinity) continue;
    ++finite;
    ASSERT_LE(rational_from_double(safe), value_at(program.objective, program.point, false));
  }
  EXPECT_GT(finite, 0);
}

TEST(SafeBound, HoldsAtEveryFeasiblePointForAnyMultipliers) {
  Random random(fuzz_seed(), "feasible points");
  for (std::size_t i = 0; i < fuzz_cases(10000); ++i) {
    const ProgramWithPoint program = random_interval_program(random);
    const auto multipliers = random_multipliers(random, program.model);
    const double safe = safe_lower_bound(program.model, program.objective, multipliers);
    ASSERT_LE(rational_from_double(safe), value_at(program.objective, program.point, false));
    ASSERT_LE(rational_from_double(safe), value_at(program.objective, program.point, true));
    ASSERT_FALSE(proves_infeasible(program.model, multipliers));
  }
}

/// The optimum is certified by weak duality, in rationals, before it serves as an oracle.
void expect_certified(const RandomProgram& program, const ExactSolution& exact) {
  if (exact.status == LpStatus::optimal) {
    const ExactVertex vertex = exact_vertex(program.model, program.objective, exact.basis);
    ASSERT_TRUE(vertex.is_optimal());
    ASSERT_EQ(vertex.objective, exact.objective);
    ASSERT_EQ(exact_lower_bound(program.model, program.objective, exact.multipliers), exact.objective);
  } else {
    ASSERT_EQ(exact.status, LpStatus::infeasible);
    ASSERT_GT(exact_lower_bound(program.model, {}, exact.multipliers), 0);
  }
}

void expect_safe(const RandomProgram& program, const LpSolution& solution, const ExactSolution& exact) {
  if (solution.status == LpStatus::infeasible && !solution.ray.empty()) {
    const bool proved = proves_infeasible(program.model, solution.ray);
    ASSERT_TRUE(!proved || is_exact_infeasibility_proof(program.model, solution.ray));
    ASSERT_TRUE(!proved || exact.status == LpStatus::infeasible);
  }
  if (solution.status != LpStatus::optimal || exact.status != LpStatus::optimal) return;
  const double safe = safe_lower_bound(program.model, program.objective, solution.multipliers);
  ASSERT_LE(rational_from_double(safe), exact.objective);
  ASSERT_NEAR(safe, nearest_double(exact.objective), 1e-6);
}

void compare_with_exact(const char* backend_name, std::size_t cases) {
  Random random(fuzz_seed(), "optimum");
  const auto backend = lp_registry().at(backend_name).make_with();
  int feasible = 0;
  int infeasible = 0;
  for (std::size_t i = 0; i < cases; ++i) {
    SCOPED_TRACE(i);
    const RandomProgram program = random_program(random);
    const ExactSolution exact = ExactSimplex(program.model).minimise(program.objective, {});
    ASSERT_NO_FATAL_FAILURE(expect_certified(program, exact));
    ++(exact.status == LpStatus::optimal ? feasible : infeasible);
    backend->load(program.model);
    ASSERT_NO_FATAL_FAILURE(expect_safe(program, backend->minimise(program.objective), exact));
  }
  EXPECT_GT(feasible, static_cast<int>(cases / 4));
  EXPECT_GT(infeasible, static_cast<int>(cases / 20));
}

TEST(SafeBound, NeverExceedsTheExactOptimumFromOurSimplex) {
  compare_with_exact("simplex", fuzz_cases(10000));
}
TEST(SafeBound, NeverExceedsTheExactOptimumFromGlpk) { compare_with_exact("glpk", fuzz_cases(2000)); }
TEST(SafeBound, NeverExceedsTheExactOptimumFromClp) { compare_with_exact("clp", fuzz_cases(2000)); }

TEST(SafeBound, MultipliersForInfiniteSidesCountAsZero) {
  LpModel model;
  model.add_column({0, 1});
  model.add_row(std::vector<LinearTerm>{{0, 1.0}}, {0.5, kInfinity});
  const std::vector<LinearTerm> objective{{0, 1.0}};
  EXPECT_EQ(safe_lower_bound(model, objective, std::vector<double>{1.0}), 0.5);
  EXPECT_EQ(safe_lower_bound(model, objective, std::vector<double>{-1.0}), 0);
}

TEST(SafeBound, LeavesTheRoundingModeAsItWas) {
  LpModel model;
  model.add_column({0, 1});
  static_cast<void>(safe_lower_bound(model, {}, {}));
  EXPECT_TRUE(rounding_is_nearest());
}

TEST(SafeBound, ProvesInfeasibleOnlyWithoutDoubt) {
  for (const double gap : {0x1p-60, 0x1p-40, 0.0, -0x1p-40}) {
    LpModel model;
    model.add_column({0, 1});
    model.add_column({0, 1});
    const std::vector<LinearTerm> row{{0, 0.1}, {1, 0.3}};
    model.add_row(row, {0.25 + gap, kInfinity});
    model.add_row(row, {-kInfinity, 0.25});
    EXPECT_EQ(proves_infeasible(model, std::vector<double>{1.0, -1.0}), 0.25 + gap > 0.25) << gap;
  }
}

}  // namespace
}  // namespace gcslab
