#include "linear_program/lp_reduction.h"

#include <gtest/gtest.h>

#include "experiments/microbenchmarks/bernstein_polytope.h"
#include "linear_program/exact_basis.h"
#include "linear_program/exact_bound.h"
#include "linear_program/lp_registry.h"
#include "support/fuzz.h"
#include "support/parabola_polytope.h"

namespace gcslab {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

LpReductionOptions with(LpSafety safety) {
  LpReductionOptions options;
  options.safety = safety;
  return options;
}

/// 4 x^2 + x - 3 = 0 on [0, 1] (Tahari 2011, section 5): the polytope's shadow is [3/5, 7/9].
LpModel published_example() {
  LpModel model;
  model.add_column({0, 1});
  model.add_column({0, 1});
  model.add_row(std::vector<LinearTerm>{{0, -2.0}, {1, 1.0}}, {-1, kInfinity});
  model.add_row(std::vector<LinearTerm>{{0, 1.0}, {1, -1.0}}, {0, kInfinity});
  model.add_row(std::vector<LinearTerm>{{0, 1.0}, {1, 4.0}}, {3, 3});
  return model;
}

TEST(LpReduction, ReducesThePublishedExample) {
  for (const char* name : {"simplex", "glpk", "clp", "exact"}) {
    const auto backend = lp_registry().at(name).make_with();
    LpReduction reduction(*backend, {});
    const Interval bounds = reduction.reduce(published_example(), both_sides(1)).bounds[0];
    EXPECT_LE(rational_from_double(bounds.lower), Rational(3, 5)) << name;
    EXPECT_GE(rational_from_double(bounds.upper), Rational(7, 9)) << name;
    EXPECT_NEAR(bounds.lower, 0.6, 1e-8) << name;
    EXPECT_NEAR(bounds.upper, 7.0 / 9, 1e-8) << name;
  }
}

TEST(LpReduction, ExactSafetyGivesTheTightestDoubles) {
  const auto backend = lp_registry().at("simplex").make_with();
  LpReduction reduction(*backend, with(LpSafety::exact));
  const Interval bounds = reduction.reduce(published_example(), both_sides(1)).bounds[0];
  EXPECT_EQ(bounds.lower, rounded_down(Rational(3, 5)));
  EXPECT_EQ(bounds.upper, -rounded_down(Rational(-7, 9)));
}

/// How many of the random parabolas lose their root a.
int lost_roots(const std::string& backend_name, LpSafety safety, Data data) {
  Random random(fuzz_seed(), "parabola");
  const auto backend = lp_registry().at(backend_name).make_with();
  LpReduction reduction(*backend, with(safety));
  int lost = 0;
  for (const double width : {1e-2, 1e-4, 1e-6, 1e-8}) {
    for (int i = 0; i < 100; ++i) {
      const Parabola parabola = random_parabola(random, width);
      if (parabola.u < 0) continue;
      const auto& result = reduction.reduce(parabola_polytope(parabola, data), both_sides(1));
      lost += result.infeasible || !contains(result.bounds[0], parabola.a) ? 1 : 0;
    }
  }
  return lost;
}

TEST(LpReduction, UnprotectedSolversLoseRootsOfParabolas) {
  for (const char* backend : {"glpk", "simplex", "clp"}) {
    EXPECT_GT(lost_roots(backend, LpSafety::unprotected, Data::nearest), 0) << backend;
  }
}

TEST(LpReduction, ATolerancesWidthLosesRootsOfParabolasToo) {
  EXPECT_GT(lost_roots("simplex", LpSafety::tolerance, Data::nearest), 0);
}

TEST(LpReduction, SafeBoundsKeepRootsOfParabolas) {
  for (const char* backend : {"glpk", "simplex", "clp"}) {
    EXPECT_EQ(lost_roots(backend, LpSafety::dual, Data::enclosed), 0) << backend;
  }
  EXPECT_EQ(lost_roots("simplex", LpSafety::exact, Data::enclosed), 0);
}

TEST(LpReduction, ExactSolutionOfRoundedDataLosesRoots) {
  // Exactness of the solver is not enough: what must be enclosed is the data.
  EXPECT_GT(lost_roots("simplex", LpSafety::exact, Data::nearest), 0);
}

TEST(LpReduction, KeepsBothRootsAtTheEndsOfTheBox) {
  // x^2 - x = 0 on [0, 1]
  const LpModel model = parabola_polytope({0, 1, 0, 1}, Data::enclosed);
  for (const LpSafety safety : {LpSafety::dual, LpSafety::exact}) {
    const auto backend = lp_registry().at("simplex").make_with();
    LpReduction reduction(*backend, with(safety));
    EXPECT_EQ(reduction.reduce(model, both_sides(1)).bounds[0], Interval(0, 1));
  }
}

class PlantedRoots : public testing::TestWithParam<std::string> {};

TEST_P(PlantedRoots, StayInTheBoundsFromBoxToBox) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    RandomBernsteinPolytope polytope(6, 0.3, seed);
    const auto backend = lp_registry().at(GetParam()).make_with();
    LpReduction reduction(*backend, {});
    for (const double radius : {0.3, 0.1, 1e-2, 1e-4, 1e-7}) {
      polytope.move_box(radius);
      const auto& result = reduction.reduce(polytope.model(), both_sides(6));
      ASSERT_FALSE(result.infeasible);
      const std::vector<double> point = polytope.planted_point();
      for (std::size_t j = 0; j < 6; ++j) {
        const double rounding = 1e-15 / radius;  // of the test's own (root - centre) / radius
        EXPECT_LE(result.bounds[j].lower, point[j] + rounding);
        EXPECT_GE(result.bounds[j].upper, point[j] - rounding);
      }
      EXPECT_EQ(result.solved + result.skipped, 12);
      EXPECT_EQ(result.abandoned, 0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Backends, PlantedRoots, testing::Values("simplex", "glpk", "clp", "exact"));

void expect_certificates_hold(const LpModel& model, const LpReductionResult& result) {
  for (const BoundCertificate& certificate : result.certificates) {
    std::vector<double> multipliers(static_cast<std::size_t>(model.rows()), 0.0);
    for (const RowMultiplier& entry : certificate.multipliers) {
      multipliers[static_cast<std::size_t>(entry.row)] = entry.multiplier;
    }
    const bool is_lower = certificate.goal.side == BoundSide::lower;
    const LinearTerm objective{certificate.goal.column, is_lower ? 1.0 : -1.0};
    const Rational proved = exact_lower_bound(model, {&objective, 1}, exact_multipliers(multipliers));
    EXPECT_GE(proved, rational_from_double(is_lower ? certificate.bound : -certificate.bound));
    const Interval& bounds = result.bounds[static_cast<std::size_t>(certificate.goal.column)];
    EXPECT_NEAR(certificate.bound, is_lower ? bounds.lower : bounds.upper, 1e-12);
  }
}

TEST(LpReduction, CertificatesAndRaysProveItAgainInExactArithmetic) {
  int infeasible = 0;
  int certificates = 0;
  for (const LpSafety safety : {LpSafety::dual, LpSafety::exact}) {
    LpReductionOptions options = with(safety);
    options.keep_certificates = true;
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
      RandomBernsteinPolytope polytope(4, 0.2, seed);
      polytope.leave_root(0.4);
      const auto backend = lp_registry().at("simplex").make_with();
      LpReduction reduction(*backend, options);
      const auto& result = reduction.reduce(polytope.model(), both_sides(4));
      expect_certificates_hold(polytope.model(), result);
      certificates += static_cast<int>(result.certificates.size());
      if (!result.infeasible) continue;
      ++infeasible;
      EXPECT_TRUE(is_exact_infeasibility_proof(polytope.model(), result.ray));
    }
  }
  EXPECT_GT(infeasible, 0);
  EXPECT_GT(certificates, 0);
}

TEST(LpReduction, SkippedGoalsCouldNotHaveMovedTheirBound) {
  const RandomBernsteinPolytope polytope(10, 1.0, 2);
  LpReductionOptions every_goal;
  every_goal.negligible_gain = -1;
  const auto backend = lp_registry().at("simplex").make_with();
  const LpReductionResult all = LpReduction(*backend, every_goal).reduce(polytope.model(), both_sides(10));
  const LpReductionResult filtered = LpReduction(*backend, {}).reduce(polytope.model(), both_sides(10));
  EXPECT_EQ(all.skipped, 0);
  EXPECT_GT(filtered.skipped, 0);
  for (std::size_t j = 0; j < 10; ++j) {
    EXPECT_NEAR(all.bounds[j].lower, filtered.bounds[j].lower, 1e-8);
    EXPECT_NEAR(all.bounds[j].upper, filtered.bounds[j].upper, 1e-8);
  }
}

TEST(LpReduction, StopsWhenProgramsBearNoFruit) {
  const RandomBernsteinPolytope polytope(10, 1.0, 2);
  LpReductionOptions options;
  options.negligible_gain = 2;  // more than any bound can move
  options.fruitless_limit = 3;
  const auto backend = lp_registry().at("simplex").make_with();
  const LpReductionResult result = LpReduction(*backend, options).reduce(polytope.model(), both_sides(10));
  EXPECT_LE(result.solved, 3);
  EXPECT_EQ(result.solved + result.skipped + result.abandoned, 20);
}

}  // namespace
}  // namespace gcslab
