#include "box_solver/univariate_search.h"

#include <cmath>
#include <gtest/gtest.h>

#include "base/error.h"
#include "expression/parser.h"

namespace gcslab {
namespace {

SystemFunctions equation(const std::string& text, const Interval& side,
                         const std::vector<std::string>& inequalities = {}) {
  EquationSystem system;
  system.variables = {"x"};
  system.equations = {parse_equation(*system.graph, text, system.variables)};
  for (const std::string& inequality : inequalities)
    system.inequalities.push_back(parse_inequality(*system.graph, inequality, system.variables));
  system.box = {side};
  return SystemFunctions(system);
}

SearchResult searched(const SystemFunctions& functions) {
  return univariate_search(functions, functions.system().box, nullptr);
}

TEST(UnivariateSearch, GivesBoxesOfOneRootEachAndTheirMultiplicities) {
  const SearchResult found = searched(equation("(x - 1/3)^3*(x^2 - 2)*(x - 1)^2", Interval::entire()));
  ASSERT_EQ(found.solutions.size(), 4u);
  const double roots[] = {-std::sqrt(2.0), 1.0 / 3, 1, std::sqrt(2.0)};
  const int multiplicities[] = {1, 3, 2, 1};
  for (std::size_t i = 0; i < 4; ++i) {
    const CertifiedRoot& root = found.solutions[i].root;
    EXPECT_EQ(root.multiplicity, multiplicities[i]);
    EXPECT_TRUE(contains(root.box[0], roots[i]));
    EXPECT_LE(width(root.box[0]), 5e-16);
    EXPECT_TRUE(subset(root.box[0], root.uniqueness_box[0]));
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(contains(root.uniqueness_box[0], roots[k]), k == i);
    }
  }
  EXPECT_TRUE(is_singleton(found.solutions[2].root.box[0]));  // 1 is a double
  EXPECT_TRUE(found.undecided.empty());
}

TEST(UnivariateSearch, LeavesRootsUndecidedThatNoDoublesTellApart) {
  const SearchResult found = searched(equation("((x - 1/3)^2 - 1e-60)*(x + 1)", {-2, 2}));
  EXPECT_EQ(found.solutions.size(), 1u);
  ASSERT_EQ(found.undecided.size(), 1u);
  EXPECT_TRUE(contains(found.undecided[0].box[0], 1.0 / 3));
}

TEST(UnivariateSearch, KeepsToInequalitiesAndEnds) {
  EXPECT_EQ(searched(equation("x*(x - 1)*(x - 2)^2", {0, 2}, {"x <= 3/2"})).solutions.size(), 2u);
  EXPECT_EQ(searched(equation("x*(x - 1)*(x - 2)^2", {1e-300, std::nextafter(2.0, 0.0)})).solutions.size(),
            1u);
}

TEST(UnivariateSearch, SaysWhyItDoesNotApply) {
  EXPECT_THROW(searched(equation("sin(x)", {0, 1})), NotApplicable);
  EquationSystem two;
  two.variables = {"x", "y"};
  two.equations = {parse_equation(*two.graph, "x + y", two.variables)};
  two.box = {{0, 1}, {0, 1}};
  EXPECT_THROW(searched(SystemFunctions(two)), NotApplicable);
}

}  // namespace
}  // namespace gcslab
