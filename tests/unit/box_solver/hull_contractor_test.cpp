// Known answers of forward-backward propagation. That no root is lost is the contract suite's business.

#include "box_solver/hull_contractor.h"

#include <gtest/gtest.h>
#include <numbers>
#include <optional>

#include "interval/fast_interval.h"
#include "support/planted_system.h"

namespace gcslab {
namespace {

using planted::system_of;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What hull consistency leaves of a box; nothing when it shows that there is no solution.
std::optional<Box> contracted(const EquationSystem& system, Box box) {
  const SystemFunctions functions(system);
  const auto contractor = make_hull_contractor<FastInterval>(functions, 0.1);
  ProofTrace trace;
  if (!contractor->contract(box, trace)) return std::nullopt;
  return box;
}

void expect_near(const Interval& found, const Interval& wanted) {
  EXPECT_NEAR(found.lower, wanted.lower, 1e-12);
  EXPECT_NEAR(found.upper, wanted.upper, 1e-12);
}

TEST(HullContractor, SolvesForEachVariable) {
  const auto circle = contracted(system_of({"x", "y"}, {"x^2 + y^2 = 1"}), {{0, 2}, {-3, 3}});
  ASSERT_TRUE(circle);
  expect_near((*circle)[0], {0, 1});
  expect_near((*circle)[1], {-1, 1});
  const auto hyperbola = contracted(system_of({"x", "y"}, {"x*y = 1"}), {{1, 2}, {-9, 9}});
  ASSERT_TRUE(hyperbola);
  expect_near((*hyperbola)[1], {0.5, 1});
  const auto wave = contracted(system_of({"x"}, {"sin(x) = 1/2"}), {{0, 1}});
  ASSERT_TRUE(wave);
  expect_near((*wave)[0], std::numbers::pi / 6);
}

TEST(HullContractor, TakesUnboundedBoxes) {
  const auto left = contracted(system_of({"x", "y"}, {"x^2 + y^2 = 4", "exp(x) = y"}),
                               {Interval::entire(), {0, kInfinity}});
  ASSERT_TRUE(left);
  EXPECT_TRUE(subset((*left)[0], Interval(-2.1, 2.1)));
  EXPECT_TRUE(subset((*left)[1], Interval(0, 2.1)));
}

TEST(HullContractor, UsesInequalities) {
  const auto left =
      contracted(system_of({"x", "y"}, {"x + y = 1"}, {"x <= 1/4", "y >= x"}), {{0, 1}, {0, 1}});
  ASSERT_TRUE(left);
  expect_near((*left)[0], {0, 0.25});
  expect_near((*left)[1], {0.75, 1});
  EXPECT_FALSE(contracted(system_of({"x"}, {"x^2 = 1"}, {"x <= -2"}), {{-9, 9}}));
}

TEST(HullContractor, ShowsThatThereIsNoSolution) {
  EXPECT_FALSE(contracted(system_of({"x", "y"}, {"x^2 + y^2 = 1"}), {{2, 3}, {-3, 3}}));
  EXPECT_FALSE(contracted(system_of({"x"}, {"sqrt(x) = 1"}), {{-3, -1}}));
  EXPECT_FALSE(contracted(system_of({"x"}, {"exp(x) = -1"}), {Interval::entire()}));
  EXPECT_FALSE(contracted(system_of({"x"}, {"3 = 0"}), {{0, 1}}));
}

TEST(HullContractor, LeavesItsConstantsAlone) {
  // The equation narrows the enclosures of 1/3 and pi; a second box must find them as they were.
  const SystemFunctions functions(system_of({"x", "y"}, {"x*(1/3) + pi*y = 0"}));
  const auto contractor = make_hull_contractor<FastInterval>(functions, 0.1);
  ProofTrace trace;
  const Box box = {{-1, 1}, {-5, 5}};
  Box first = box, thin = {{0.3, 0.3}, {-1, 1}}, second = box;
  ASSERT_TRUE(contractor->contract(first, trace));
  ASSERT_TRUE(contractor->contract(thin, trace));
  ASSERT_TRUE(contractor->contract(second, trace));
  EXPECT_EQ(first, second);
}

}  // namespace
}  // namespace gcslab
