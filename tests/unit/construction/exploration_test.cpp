// New sketches from solutions find the published numbers of solutions.

#include "construction/exploration.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "support/corpus_figure.h"

namespace gcslab {
namespace {

Exploration explored(const CorpusFigure& figure, const std::string& valuation,
                     const ExplorationOptions& options) {
  const EquationSystem equations = figure.equation_system(valuation);
  const SystemFunctions functions(equations);
  return explore(figure.system, figure.frame, figure.equations, figure.wanted(valuation),
                 *sketch_of(figure.system), functions, options);
}

std::size_t regular(const Exploration& exploration) {
  return static_cast<std::size_t>(std::ranges::count_if(
      exploration.solutions, [](const SketchSolution& solution) { return solution.root.has_value(); }));
}

TEST(Exploration, FindsThePublishedFigures) {
  struct Case {
    std::string problem, valuation;
    std::size_t classes;
  };
  // Imbach 2013, sections 3.2, 3.4 and 4.2; complete by the proofs of the box solver.
  for (const auto& [problem, valuation, classes] :
       {Case{"polyhedra/octahedron", "", 4}, Case{"polyhedra/pentahedron", "", 9},
        Case{"polyhedra/pentahedron", "table_4_1", 7}}) {
    for (const PlanKind plan : {PlanKind::henneberg, PlanKind::least, PlanKind::gao}) {
      ExplorationOptions options;
      options.plan = plan;
      const Exploration found = explored(corpus_figure(problem), valuation, options);
      EXPECT_TRUE(found.is_finished);
      EXPECT_EQ(regular(found), classes) << problem << " " << valuation;
      EXPECT_EQ(found.solutions.size(), classes) << problem << " " << valuation;
    }
  }
}

TEST(Exploration, KeepsToTheBranchesAndTheBudgetThatItIsGiven) {
  const CorpusFigure octahedron = corpus_figure("polyhedra/octahedron");
  ExplorationOptions options;
  options.maximum_paths = 1;
  const Exploration one = explored(octahedron, "", options);
  EXPECT_EQ(one.paths.size(), 1U);
  EXPECT_FALSE(one.is_finished);
  options.maximum_paths = 1000;
  options.branches = {"+++-"};
  const Exploration chosen = explored(octahedron, "", options);
  EXPECT_TRUE(chosen.is_finished);
  EXPECT_GT(chosen.paths.size(), 1U);
  for (const ExploredPath& path : chosen.paths) {
    if (path.sketch.solution) {
      EXPECT_EQ(text_of(path.sketch.branch), "+++-");
    }
  }
}

}  // namespace
}  // namespace gcslab
