// Plans, their branches, and reading them off figures.

#include "construction/plan.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "base/error.h"
#include "construction/branch.h"
#include "construction/plan_orders.h"
#include "support/corpus_figure.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

constexpr PlanKind kKinds[] = {PlanKind::forward, PlanKind::gao, PlanKind::least, PlanKind::henneberg};

const char* const kPointProblems[] = {"polyhedra/octahedron",       "polyhedra/pentahedron",
                                      "polyhedra/hexahedron",       "polyhedra/icosahedron",
                                      "polyhedra/6p7d3a2c",         "molecules/disulfide-distances",
                                      "kinematics/planar-platform", "sketches/triangle"};

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

TEST(Plan, OfAFigureGivesTheFigureBack) {
  for (const char* name : kPointProblems) {
    const CorpusFigure corpus = corpus_figure(name);
    for (const PlanKind kind : kKinds) {
      for (std::uint64_t k = 0; k < 5; ++k) {
        // With the constraints that the frame absorbs.
        const Figure drawn = figure_at(
            corpus.equations, unknowns_of(corpus.equations, in_frame(corpus.system, corpus.frame,
                                                                     corpus.random_sketch(fuzz_seed() + k))));
        const PlanProgram program(corpus.system, make_plan(corpus.system, kind, drawn));
        PlanEvaluator evaluator(program);
        const Figure figure = in_frame(corpus.system, program.plan(), drawn);
        const PlanValues values = evaluator.read(figure, parameters_of(corpus.system, drawn));
        const PlanPlace again = evaluator.evaluate(values, evaluator.branch(values));
        ASSERT_EQ(again.failure, PlanFailure::none) << name << " seed " << fuzz_seed() + k;
        for (std::size_t p = 0; p < figure.size(); ++p)
          EXPECT_LT(distance(again.figure[p], figure[p]), 1e-5) << name << " seed " << fuzz_seed() + k;
      }
    }
  }
}

TEST(Plan, BranchesGiveFiguresOfTheSameValues) {
  for (const char* name : {"polyhedra/octahedron", "molecules/disulfide-distances"}) {
    const CorpusFigure corpus = corpus_figure(name);
    const Figure drawn = corpus.random_sketch(fuzz_seed());
    const PlanProgram program(corpus.system, make_plan(corpus.system, PlanKind::least, drawn));
    PlanEvaluator evaluator(program);
    const std::vector<double> parameters = parameters_of(corpus.system, drawn);
    const PlanValues values = evaluator.read(in_frame(corpus.system, program.plan(), drawn), parameters);
    std::size_t all = 0, up_to_reflection = 0;
    std::vector<bool> is_removed(corpus.system.constraints.size());
    for (const std::size_t c : program.plan().removed) is_removed[c] = true;
    evaluator.each_branch(values, false, [&](const Branch& branch, const Figure& figure) {
      ++all;
      EXPECT_LT(distance(evaluator.evaluate(values, branch).figure.back(), figure.back()), 1e-9);
      for (std::size_t c = 0; c < is_removed.size(); ++c) {
        const Constraint& constraint = corpus.system.constraints[c];
        if (is_removed[c]) continue;
        EXPECT_NEAR(distance(figure[constraint.objects[0]], figure[constraint.objects[1]]),
                    parameters[*constraint.parameter], 1e-9);
      }
    });
    evaluator.each_branch(values, true, [&](const Branch&, const Figure&) { ++up_to_reflection; });
    EXPECT_GT(all, 1U);
    EXPECT_LE(all, std::size_t{1} << (program.plan().choices() - 1));  // but the frame's
    EXPECT_EQ(up_to_reflection, all / 2);
  }
}

TEST(Plan, NeedsTheLeastNumberOfGuides) {
  const auto guides = [](const char* name, PlanKind kind) {
    const CorpusFigure corpus = corpus_figure(name);
    return make_plan(corpus.system, kind, corpus.random_sketch(1)).guides.size();
  };
  // Imbach 2013, sections 4.3.1 and 4.3.3; the search among all orders proves that fewer do not do.
  EXPECT_EQ(guides("polyhedra/octahedron", PlanKind::least), 1U);
  EXPECT_EQ(guides("polyhedra/icosahedron", PlanKind::least), 3U);
  for (const char* name : kPointProblems) {
    for (const PlanKind kind : {PlanKind::forward, PlanKind::gao})
      EXPECT_GE(guides(name, kind), guides(name, PlanKind::least)) << name;
  }
}

/// Every order of the points, for the smallest problems.
TEST(PlanOrders, NoneNeedsFewerGuidesThanTheLeast) {
  for (const char* name : {"polyhedra/octahedron", "polyhedra/pentahedron", "kinematics/planar-platform"}) {
    const CorpusFigure corpus = corpus_figure(name);
    const PlacingConstraints constraints(corpus.system, FigureVariables(corpus.system), false);
    const std::size_t d = dimension(corpus.system.universe);
    std::vector<std::size_t> order(constraints.points());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    int least = 1000;
    do {
      least = std::min(least, guides_of(constraints, order));
    } while (std::ranges::next_permutation(order).found);
    EXPECT_EQ(guides_of(constraints, least_order(constraints, d)), least) << name;
  }
}

TEST(Plan, IsReadable) {
  const CorpusFigure octahedron = corpus_figure("polyhedra/octahedron");
  const Plan plan = make_plan(octahedron.system, PlanKind::least, *sketch_of(octahedron.system));
  EXPECT_EQ(text_of(plan, octahedron.system),
            "P0 = origin\n"
            "P1 = sphere(P0, h0)\n"
            "P2 = sphere(P0, h1) * sphere(P1, h2)\n"
            "P3 = sphere(P1, h5) * sphere(P2, h7) * sphere(P0, k0)\n"
            "P4 = sphere(P0, h3) * sphere(P3, h9) * sphere(P2, h8)\n"
            "P5 = sphere(P0, h4) * sphere(P1, h6) * sphere(P3, h11)\n"
            "guide k0 = distance P3 P0\n"
            "removed: constraint 11, distance P4 P5\n");
}

TEST(Plan, SaysWhichStepFailsAndHow) {
  const CorpusFigure octahedron = corpus_figure("polyhedra/octahedron");
  const Figure sketch = *sketch_of(octahedron.system);
  const PlanProgram program(octahedron.system, make_plan(octahedron.system, PlanKind::least, sketch));
  PlanEvaluator evaluator(program);
  PlanValues values =
      evaluator.read(in_frame(octahedron.system, program.plan(), sketch), octahedron.wanted());
  const Branch branch(program.plan().choices(), false);
  values.offsets.clear();  // constraints hold
  values.guides = {100};   // outside of the domain
  PlanPlace place = evaluator.evaluate(values, branch);
  EXPECT_EQ(place.failure, PlanFailure::no_intersection);
  EXPECT_EQ(place.step, 3U);
  values.guides = {1};
  values.parameters[0] = 0;  // P0 and P1 coincide: circles around one centre
  place = evaluator.evaluate(values, branch);
  EXPECT_EQ(place.step, 2U);
  EXPECT_EQ(place.failure, PlanFailure::many);
}

TEST(Plan, OfOtherObjectsThanPointsIsRefused) {
  const CorpusFigure apollonius = corpus_figure("sketches/apollonius");
  EXPECT_THROW(make_plan(apollonius.system, PlanKind::least, *sketch_of(apollonius.system)), NotApplicable);
}

}  // namespace
}  // namespace gcslab
