// What constraint systems of the corpus say of the number of their figures is what a complete search finds.

#include <gtest/gtest.h>

#include "experiments/corpus/corpus.h"
#include "experiments/corpus/problem_loader.h"
#include "experiments/solving/figures_json.h"
#include "experiments/solving/solve_run.h"

namespace gcslab {
namespace {

SolveOutcome searched(const Problem& problem) {
  const SystemFunctions functions(problem.system);
  const SolverMethod& method = solver_method_registry().at("adaptive");
  const SolveSettings settings{"adaptive", Options(method.options(), {{"maximum_boxes", "400"}}, "adaptive")};
  return solve_system(functions, settings, std::nullopt, {});
}

TEST(CorpusFigures, HaveTheirKnownCountsWhereTheSearchCompletes) {
  std::size_t complete = 0;
  for (const CorpusEntry& entry : Corpus::standard().problems()) {
    if (kind_of_file(entry.path) != "constraint_system") continue;
    const Problem first = load_system(entry.name);
    if (first.system.variables.size() > 15) continue;
    for (const Valuation& valuation : first.geometry->system.valuations) {
      const Problem problem = load_system(entry.name, valuation.name);
      if (!problem.known.real_solutions || !problem.known.classes) continue;
      const SolveOutcome found = searched(problem);
      const auto solutions = static_cast<std::int64_t>(found.search.solutions.size());
      EXPECT_LE(solutions, *problem.known.real_solutions) << entry.name << " " << valuation.name;
      if (found.status != Status::complete) continue;
      ++complete;
      EXPECT_EQ(solutions, *problem.known.real_solutions) << entry.name << " " << valuation.name;
      Json result;
      add_figures(result, *problem.geometry, found.search);
      EXPECT_EQ(static_cast<std::int64_t>(result["classes"].size()), *problem.known.classes)
          << entry.name << " " << valuation.name;
    }
  }
  EXPECT_GE(complete, 12u);
}

}  // namespace
}  // namespace gcslab
