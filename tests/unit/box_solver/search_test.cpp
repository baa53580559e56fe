// Whole searches: known roots are found and proved, none is lost whatever the contractor, and the answer does
// not depend on threads or on where a search was interrupted.

#include "box_solver/search.h"

#include <gtest/gtest.h>
#include <sstream>

#include "base/error.h"
#include "box_solver/contractor_registry.h"
#include "support/counted_system.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

using planted::CountedGenerator;
using planted::CountedSystem;
using planted::Point;
using planted::system_of;

ContractorMaker maker(const std::string& composition) {
  return [composition](const SystemFunctions& functions, int bits) {
    ContractorSettings settings;
    if (bits > 53) settings = {.arithmetic = Arithmetic::mpfr, .bits = bits};
    return make_contractor(composition, functions, settings);
  };
}

SearchResult solve(const SystemFunctions& functions, const Box& box, const std::string& composition,
                   const SearchOptions& options = {}) {
  return search(functions, box, {{box}}, maker(composition), options);
}

/// Whether a root lies in the box of a solution or in a box that was left undecided.
bool is_accounted_for(const SearchResult& result, const Point& root) {
  for (const Solution& solution : result.solutions) {
    if (planted::contains(solution.root.box, root)) return true;
  }
  for (const UndecidedBox& undecided : result.undecided) {
    if (planted::contains(undecided.box, root)) return true;
  }
  return std::ranges::any_of(result.pending, [&](const Box& box) { return planted::contains(box, root); });
}

class SearchWith : public testing::TestWithParam<std::string> {};

TEST_P(SearchWith, ProvesTheRootsOfACircleAndAParabola) {
  const SystemFunctions functions(system_of({"x", "y"}, {"x^2 + y^2 - 1", "y - x^2"}));
  const SearchResult result = solve(functions, {{-2, 2}, {-2, 2}}, GetParam());
  EXPECT_TRUE(result.undecided.empty() && result.pending.empty());
  ASSERT_EQ(result.solutions.size(), 2U);
  for (const Solution& solution : result.solutions) {
    EXPECT_NEAR(std::fabs(midpoint(solution.root.box[0])), 0.78615137775742328, 1e-12);
    EXPECT_NEAR(midpoint(solution.root.box[1]), 0.61803398874989485, 1e-12);
  }
}

TEST_P(SearchWith, LosesNoRootAndInventsNone) {
  Random random(fuzz_seed(), "search");
  CountedGenerator generator(random);
  SearchOptions options;
  options.maximum_boxes = 3000;
  std::size_t complete = 0;
  const std::size_t cases = fuzz_cases(200) / 4;
  for (std::size_t i = 0; i < cases; ++i) {
    const CountedSystem counted = generator.system(static_cast<int>(random.integer(1, 2)));
    const SystemFunctions functions(counted.system);
    const Box box(counted.system.variables.size(), Interval(-20, 20));
    SearchResult result;
    try {
      result = solve(functions, box, GetParam(), options);
    } catch (const NotApplicable&) {
      continue;
    }
    for (const Point& root : counted.roots) {
      if (!planted::contains(box, root)) continue;
      ASSERT_TRUE(is_accounted_for(result, root)) << planted::to_text(counted.system);
    }
    for (const Solution& solution : result.solutions) {
      const auto inside = std::ranges::count_if(
          counted.roots, [&](const Point& root) { return planted::contains(solution.root.box, root); });
      ASSERT_EQ(inside, 1) << planted::to_text(counted.system) << planted::to_text(solution.root.box);
      const auto near = std::ranges::count_if(counted.roots, [&](const Point& root) {
        return planted::contains(solution.root.uniqueness_box, root);
      });
      ASSERT_EQ(near, 1) << planted::to_text(counted.system)
                         << planted::to_text(solution.root.uniqueness_box);
    }
    complete += result.undecided.empty() && result.pending.empty() ? std::size_t{1} : 0;
  }
  // Double roots stay undecided, the rest must not.
  EXPECT_GT(complete, cases / 10);
}

std::vector<std::string> compositions() {
  std::vector<std::string> result;
  for (const std::string& name : contractor_registry().names()) {
    if (name != "hull") result.push_back("hull+" + name);
  }
  result.insert(result.end(), {"hull", "newton", "multipliers", "bernstein_projection", "mourrain_pavone"});
  return result;
}

std::string name_of_composition(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::ranges::replace(name, '+', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Every, SearchWith, testing::ValuesIn(compositions()), name_of_composition);

TEST(Search, AnswersAndProofsAreTheSameForAnyNumberOfThreads) {
  const SystemFunctions functions(
      system_of({"x", "y", "z"}, {"x^2 + y^2 + z^2 - 3", "x*y*z - 1/2", "x + y^3 - z"}));
  const Box box(3, Interval(-3, 3));
  std::vector<std::string> proofs;
  std::vector<std::size_t> boxes;
  for (const int threads : {1, 2, 5}) {
    std::ostringstream text;
    ProofLog log(text);
    SearchOptions options;
    options.threads = threads;
    options.proof = &log;
    const SearchResult result =
        solve(functions, box, "hull+adaptive_constructive_disjunction+newton", options);
    proofs.push_back(text.str());
    boxes.push_back(result.statistics.boxes);
  }
  EXPECT_GT(boxes[0], 10U);
  EXPECT_EQ(proofs[0], proofs[1]);
  EXPECT_EQ(proofs[0], proofs[2]);
}

TEST(Search, GoesOnWhereItWasInterrupted) {
  const SystemFunctions functions(system_of({"x", "y"}, {"sin(3*x) - y/2", "cos(2*y) - x/3"}));
  const Box box(2, Interval(-4, 4));
  const SearchResult whole = solve(functions, box, "hull+multipliers");
  SearchOptions options;
  options.maximum_boxes = 16;
  SearchResult part = solve(functions, box, "hull+multipliers", options);
  ASSERT_FALSE(part.pending.empty());
  const SearchResult rest = search(functions, box, {part.pending, part.roots, part.undecided},
                                   maker("hull+multipliers"), SearchOptions{});
  EXPECT_EQ(rest.solutions.size(), whole.solutions.size());
  EXPECT_GT(whole.solutions.size(), 5U);
  EXPECT_EQ(rest.undecided.size(), whole.undecided.size());
}

TEST(Search, KeepsOnlyRootsThatSatisfyTheInequalities) {
  const SystemFunctions functions(system_of({"x", "y"}, {"x^2 + y^2 - 1", "y - x^2"}, {"x <= 0"}));
  const SearchResult result = solve(functions, {{-2, 2}, {-2, 2}}, "hull+multipliers");
  ASSERT_EQ(result.solutions.size(), 1U);
  EXPECT_LT(result.solutions[0].root.box[0].upper, 0);
  EXPECT_EQ(result.solutions[0].inequalities, InequalityState::proved);
}

TEST(Search, GathersTheBoxesAroundAMultipleRoot) {
  // Two circles that touch from inside at (1, 0).
  const SystemFunctions functions(system_of({"x", "y"}, {"x^2 + y^2 - 1", "(x - 1/2)^2 + y^2 - 1/4"}));
  const Box box = {{-2, 2}, {-2, 2}};
  const SearchResult found = solve(functions, box, "hull+multipliers");
  EXPECT_TRUE(found.solutions.empty());
  ASSERT_EQ(found.undecided.size(), 1u);
  EXPECT_TRUE(contains(found.undecided[0].box[0], 1) && contains(found.undecided[0].box[1], 0));
}

TEST(Search, GivesUpWhereBoxesMultiply) {
  // A parabola and its circle of curvature: a fourfold root, along which the curves cannot be told apart.
  const SystemFunctions functions(system_of({"x", "y"}, {"y - x^2", "x^2 + y^2 - y"}));
  const Box box = {{-2, 2}, {-2, 2}};
  SearchOptions options;
  options.cluster_boxes = 1000;
  const SearchResult found = solve(functions, box, "hull+multipliers", options);
  EXPECT_TRUE(found.pending.empty());
  EXPECT_LT(found.statistics.boxes, 10'000u);
  EXPECT_LT(found.undecided.size(), 10u);
  EXPECT_TRUE(is_accounted_for(found, {0, 0}));
}

}  // namespace
}  // namespace gcslab
