// The systems of the corpus, solved under a budget of boxes: never more roots than are known, and as many
// when the search says that it is complete.

#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "box_solver/solver_method.h"
#include "experiments/corpus/corpus.h"
#include "experiments/corpus/problem_loader.h"
#include "experiments/solving/solve_run.h"

namespace gcslab {
namespace {

constexpr const char* kBudget = "3000";

std::vector<std::string> systems() {
  std::vector<std::string> names;
  for (const CorpusEntry& entry : Corpus::standard().problems()) {
    if (kind_of_file(entry.path) == "system") names.push_back(entry.name);
  }
  return names;
}

SolveOutcome solved(const Problem& problem, const std::string& budget) {
  const SystemFunctions functions(problem.system);
  const SolverMethod& method = solver_method_registry().at("adaptive");
  const SolveSettings settings{"adaptive",
                               Options(method.options(), {{"maximum_boxes", budget}}, "adaptive")};
  return solve_system(functions, settings, std::nullopt, {});
}

/// Known counts are of distinct roots, singular ones included, which are never certified.
TEST(CorpusSystems, HaveTheirKnownRootsWhereTheSearchCompletes) {
  std::size_t complete = 0, compared = 0;
  for (const std::string& name : systems()) {
    const Problem problem = load_system(name);
    if (!problem.known.real_solutions || problem.system.variables.size() > 20) continue;
    const SolveOutcome found = solved(problem, kBudget);
    const auto count = static_cast<std::int64_t>(found.search.solutions.size());
    ++compared;
    EXPECT_LE(count, *problem.known.real_solutions) << name;
    if (found.status != Status::complete) continue;
    ++complete;
    EXPECT_EQ(count, *problem.known.real_solutions) << name;
  }
  EXPECT_GE(compared, 90u);
  EXPECT_GE(complete, 60u);
}

/// Completeness proved for systems of at most 6 unknowns with regular roots, such as these.
TEST(CorpusSystems, AreProvedCompleteWhenSmallAndRegular) {
  for (const char* name :
       {"molecules/cyclohexane-16-real", "kinematics/four-spheres-12-real", "polynomial_systems/brown-5",
        "polynomial_systems/caprasse", "separation/three-close-roots", "separation/steep-curves",
        "separation/gap-1e-12-expanded", "separation/wilkinson-20-expanded", "conics/ellipses-four",
        "conics/circles-nearly-tangent-two"}) {
    const Problem problem = load_system(name);
    const SolveOutcome found = solved(problem, "100000");
    EXPECT_EQ(found.status, Status::complete) << name;
    EXPECT_TRUE(found.search.undecided.empty()) << name;
    EXPECT_EQ(static_cast<std::int64_t>(found.search.solutions.size()), problem.known.real_solutions) << name;
  }
}

}  // namespace
}  // namespace gcslab
