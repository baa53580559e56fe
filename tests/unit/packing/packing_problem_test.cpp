#include "packing/packing_problem.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "base/error.h"
#include "packing/random_triangulation.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

Triangulation drawn(int inner, std::uint64_t seed) {
  return random_triangulation({.inner_vertices = inner, .flips = 200, .seed = seed});
}

EquationSystem system_of(const Triangulation& graph) {
  return packing_system(graph, standard_outer_discs(), Rational(1, 1000));
}

std::string refusal(const EquationSystem& system) {
  try {
    static_cast<void>(recognise_packing(SystemFunctions(system)));
  } catch (const NotApplicable& error) {
    return error.what();
  }
  return "";
}

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

TEST(PackingSystem, IsSquareWithARelationForEachPair) {
  for (const int inner : {1, 3, 9, 20}) {
    const Triangulation graph = drawn(inner, fuzz_seed());
    const EquationSystem system = system_of(graph);
    const std::size_t n = static_cast<std::size_t>(inner);
    EXPECT_EQ(system.variables.size(), 3 * n);
    EXPECT_EQ(system.equations.size(), 3 * n);
    EXPECT_EQ(system.equations.size() + system.inequalities.size(), n * (n - 1) / 2 + 3 * n);
    EXPECT_EQ(system.box[0], Interval(0, 1.8));
    EXPECT_EQ(system.box[1], Interval(0, 1.6));
    EXPECT_NEAR(system.box[2].upper, 6.0 / 23, 1e-15);
    EXPECT_GE(rational_from_double(system.box[2].upper), Rational(6, 23));
  }
}

TEST(RecognisePacking, GivesBackGraphAndOuterDiscs) {
  const std::uint64_t seed = fuzz_seed();
  for (std::uint64_t i = 0; i < 5; ++i) {
    const Triangulation graph = drawn(12, seed + i);
    const EquationSystem system = system_of(graph);
    const PackingProblem problem = recognise_packing(SystemFunctions(system));
    // The outer discs may come in another order: where they lie tells them apart.
    std::vector<int> number(static_cast<std::size_t>(graph.vertices()));
    for (int v = 0; v < graph.vertices(); ++v) number[static_cast<std::size_t>(v)] = v;
    for (std::size_t v = 0; v < 3; ++v) {
      const auto& outer = standard_outer_discs();
      number[v] = static_cast<int>(std::ranges::find(outer, problem.outer[v]) - outer.begin());
    }
    for (const auto& [u, v] : problem.graph.edges())
      EXPECT_TRUE(graph.has_edge(number[static_cast<std::size_t>(u)], number[static_cast<std::size_t>(v)]));
    EXPECT_EQ(problem.graph.edges().size(), graph.edges().size());
    EXPECT_EQ(problem.kept_apart.size(), system.inequalities.size());
    EXPECT_FALSE(uniqueness_gap(problem, system.box));
  }
}

TEST(RecognisePacking, TakesEquationsInAnyOrderAndScale) {
  EquationSystem system = system_of(drawn(5, fuzz_seed()));
  std::ranges::reverse(system.equations);
  system.equations[0] = system.graph->constant(Rational(-7, 3)) * system.equations[0];
  system.inequalities[0] = system.graph->constant(5) * system.inequalities[0];
  const PackingProblem problem = recognise_packing(SystemFunctions(system));
  EXPECT_FALSE(uniqueness_gap(problem, system.box));
}

TEST(RecognisePacking, RefusesOtherSystemsWithTheReason) {
  const EquationSystem packing = system_of(drawn(4, fuzz_seed()));
  EquationSystem other = packing;
  other.equations[3] = other.equations[3] + other.graph->constant(1);
  EXPECT_TRUE(has(refusal(other), "does not say that two discs"));
  other = packing;
  other.equations[3] = other.equations[4];
  EXPECT_TRUE(has(refusal(other), "two equations for discs"));
  other = packing;
  other.equations.pop_back();
  EXPECT_TRUE(has(refusal(other), "not as many equations"));
}

TEST(UniquenessGap, NamesWhatTheTheoremLacks) {
  const EquationSystem packing = system_of(drawn(6, fuzz_seed()));
  const auto gap = [](const EquationSystem& system) {
    return uniqueness_gap(recognise_packing(SystemFunctions(system)), system.box).value_or("");
  };
  EXPECT_EQ(gap(packing), "");
  EquationSystem lacking = packing;
  lacking.inequalities.pop_back();
  EXPECT_TRUE(has(gap(lacking), "apart"));
  lacking = packing;
  lacking.inequalities[0] = -lacking.inequalities[0];
  EXPECT_TRUE(has(gap(lacking), "apart")) << "an inequality that wants an overlap keeps nothing apart";
  lacking = packing;
  lacking.box[2].lower = 0;
  EXPECT_TRUE(has(gap(lacking), "not positive"));
  lacking = packing;
  lacking.box[0].lower = -1;
  lacking.box[1].lower = -1;
  EXPECT_TRUE(has(gap(lacking), "outside"));
  lacking.box[1].lower = 0;  // (0, 0), (3, 0) and (0, 4) are on the border of [-1, 3] x [0, 4] again
  EXPECT_EQ(gap(lacking), "");
}

}  // namespace
}  // namespace gcslab
