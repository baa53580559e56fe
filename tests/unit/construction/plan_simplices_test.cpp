// The methods on single branches of a plan, against the octahedron's known figures.

#include "construction/plan_simplices.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "base/error.h"
#include "construction/plan_homotopy.h"
#include "construction/plan_newton.h"
#include "support/corpus_figure.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

struct Planned {
  Planned(const char* name, std::optional<std::uint64_t> seed = std::nullopt)
      : figure(corpus_figure(name)),
        sketched(figure.homotopy(seed ? figure.random_sketch(*seed) : *sketch_of(figure.system))),
        plan(figure.system, figure.frame, figure.equations, sketched, PlanKind::least),
        map(plan.motion()) {}

  /// |F| there, on a branch at t = 1; infinite outside of the domain.
  double error(const Branch& branch, std::vector<double> guides) {
    std::vector<double> values(map.guides());
    guides.push_back(1);
    if (!map.values(branch, guides, values).is_inside) return HUGE_VAL;
    double largest = 0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    return largest;
  }

  CorpusFigure figure;
  SketchHomotopy sketched;
  PlanHomotopy plan;
  BranchMap map;
};

TEST(BranchMap, HasTheDerivativesThatDifferencesShow) {
  Planned octahedron("polyhedra/octahedron", fuzz_seed());
  BranchMap& map = octahedron.map;
  std::vector<double> v = octahedron.plan.start().guides;
  for (double& guide : v) guide /= map.unit();
  v.push_back(0);
  Branch branch;
  for (const double height : octahedron.plan.start().heights) branch.push_back(height < 0);
  std::vector<double> values(1), above(1), below(1);
  Matrix<double> derivatives(1, 2);
  ASSERT_TRUE(map.jacobian(branch, v, values, derivatives).is_inside);
  EXPECT_NEAR(values[0], 0, 1e-9);
  for (std::size_t j = 0; j < 2; ++j) {
    constexpr double kStep = 1e-7;
    const double x = v[j];
    v[j] = x + kStep;
    ASSERT_TRUE(map.values(branch, v, above).is_inside);
    v[j] = x - kStep;
    ASSERT_TRUE(map.values(branch, v, below).is_inside);
    v[j] = x;
    const double slope = (above[0] - below[0]) / (2 * kStep);
    EXPECT_NEAR(derivatives(0, j), slope, 1e-4 * (1 + std::abs(slope)));
  }
}

TEST(BranchMap, SaysWhichChoiceTheBorderIsOf) {
  Planned octahedron("polyhedra/octahedron");
  std::vector<double> values(1);
  const BranchMap::Domain domain =
      octahedron.map.values(Branch(4, false), std::vector<double>{100, 1}, values);
  EXPECT_FALSE(domain.is_inside);
  EXPECT_EQ(domain.border, 1U);  // of P3, whose distance from P0 is the guide
}

TEST(PlanSimplices, FollowTheOctahedronsPathFromBranchToBranch) {
  Planned octahedron("polyhedra/octahedron");
  for (const double mesh : {0.01, 0.002}) {
    const PlanSimplexPath path =
        follow_plan_simplices(octahedron.map, octahedron.plan.start(), {.mesh = mesh});
    EXPECT_EQ(path.end, PathEnd::cycle) << path.failure;
    EXPECT_EQ(path.crossings.size(), 4U);
    EXPECT_GT(path.changes.size(), 2U);
    for (const BranchCrossing& crossing : path.crossings) {
      std::vector<double> guides = crossing.v;
      guides.pop_back();
      EXPECT_LT(octahedron.error(crossing.branch, guides), 1e-12);
    }
  }
}

/// Each simplex shares a face with the one before it, or is the mirror image of its neighbour on a new
/// branch.
TEST(PlanSimplices, TellWhatTheyPass) {
  Planned octahedron("polyhedra/octahedron");
  constexpr double kMesh = 0.005;
  std::vector<std::vector<double>> before;
  Branch branch;
  std::size_t told = 0, changes = 0, across = 0;
  const auto watch = [&](const PassedSimplex& simplex) {
    ++told;
    EXPECT_EQ(simplex.direction, 1);
    const bool is_whole = std::ranges::count(simplex.is_inside, true) == 3;
    across += is_whole ? 0 : 1;
    EXPECT_EQ(simplex.border.has_value(), !is_whole);
    if (is_whole) {
      EXPECT_EQ(simplex.exit, simplex.on_curve);
      EXPECT_EQ(simplex.curve_branch, simplex.branch);
    }
    if (told > 1 && branch == simplex.branch) {
      EXPECT_EQ(std::ranges::count_if(simplex.vertices,
                                      [&](const auto& v) { return std::ranges::count(before, v) > 0; }),
                2);
    } else if (told > 1) {
      ++changes;
    }
    before = simplex.vertices;
    branch = simplex.branch;
  };
  const PlanSimplexPath path =
      follow_plan_simplices(octahedron.map, octahedron.plan.start(), {.mesh = kMesh}, {}, watch);
  EXPECT_EQ(path.end, PathEnd::cycle);
  EXPECT_EQ(told, path.simplices);
  EXPECT_EQ(changes, path.changes.size());
  EXPECT_GT(across, changes);
}

TEST(PlanSimplices, StopAtTheFirstCrossingWhereAsked) {
  Planned octahedron("polyhedra/octahedron");
  PlanSimplexOptions options{.mesh = 0.005};
  const PlanSimplexPath whole = follow_plan_simplices(octahedron.map, octahedron.plan.start(), options);
  options.is_to_first_crossing = true;
  const PlanSimplexPath first = follow_plan_simplices(octahedron.map, octahedron.plan.start(), options);
  ASSERT_EQ(first.crossings.size(), 1U);
  EXPECT_EQ(first.crossings[0].v, whole.crossings[0].v);
  EXPECT_LT(first.simplices, whole.simplices);
  EXPECT_LT(std::abs(first.length - first.crossings[0].length), 4 * options.mesh);
}

TEST(PlanSimplices, SayWhyAChangeOfBranchFails) {
  Planned disulfide("molecules/disulfide-distances");
  const PlanSimplexPath path = follow_plan_simplices(disulfide.map, disulfide.plan.start(), {.mesh = 0.01});
  EXPECT_EQ(path.end, PathEnd::stuck);
  EXPECT_FALSE(path.failure.empty());
}

TEST(BranchSearch, FindsZerosOfTheRemovedConstraints) {
  Planned octahedron("polyhedra/octahedron");
  const BranchSearch sampled = sample_branches(octahedron.map, 10, 2000);
  EXPECT_GE(sampled.solutions.size(), 8U);  // 4 figures and their mirror images, for each side of P2
  for (const BranchSolution& solution : sampled.solutions)
    EXPECT_LT(octahedron.error(solution.branch, solution.guides), 1e-9);
  // Newton's iteration from beside a zero comes to it.
  std::vector<double> beside = sampled.solutions.front().guides;
  beside[0] += 1e-4;
  const BranchSearch newton = newton_on_branches(octahedron.map, beside);
  EXPECT_TRUE(std::ranges::any_of(newton.solutions, [&](const BranchSolution& solution) {
    return std::abs(solution.guides[0] - sampled.solutions.front().guides[0]) < 1e-9;
  }));
  for (const BranchSolution& solution : newton.solutions)
    EXPECT_LT(octahedron.error(solution.branch, solution.guides), 1e-11);
}

TEST(BranchSearch, SamplesOneGuideOnly) {
  Planned pentahedron("polyhedra/pentahedron");
  EXPECT_THROW(sample_branches(pentahedron.map, 10, 10), NotApplicable);
}

}  // namespace
}  // namespace gcslab
