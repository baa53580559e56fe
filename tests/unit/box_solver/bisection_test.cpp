// Every strategy cuts a side that may be cut; the combined one avoids variables that combinations cancel.

#include "box_solver/bisection.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <memory>

#include "support/fuzz.h"
#include "support/planted_system.h"

namespace gcslab {
namespace {

using planted::system_of;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class BisectionNamed : public ::testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<Bisection> made(const SystemFunctions& functions) const {
    return bisection_registry().at(GetParam()).make(functions);
  }
};

TEST_P(BisectionNamed, ChoosesAnOpenSideOfAnyBox) {
  const SystemFunctions systems[] = {
      SystemFunctions(system_of({"x", "y", "z"}, {"x*y - 1", "sin(z)*x - y", "x^3 - z"})),
      SystemFunctions(system_of({"x", "y", "z"}, {"x + y + z"})),
      SystemFunctions(system_of({"x", "y", "z"}, {"x/y - 1", "log(z)", "x*z", "y^2 - 2"})),
      SystemFunctions(system_of({"x", "y", "z"}, {}))};
  Random random(fuzz_seed(), "bisection");
  for (const SystemFunctions& functions : systems) {
    const std::unique_ptr<Bisection> bisection = made(functions);
    for (std::size_t i = 0; i < fuzz_cases(200); ++i) {
      Box box;
      for (int j = 0; j < 3; ++j) {
        const double lower = random.below(8) == 0 ? -kInfinity : random.uniform(-9, 9);
        const double reach = std::ldexp(random.unit(), static_cast<int>(random.integer(-40, 60)));
        box.emplace_back(lower, random.below(8) == 0 ? kInfinity : std::isinf(lower) ? reach : lower + reach);
      }
      std::vector<std::size_t> open;
      for (std::size_t j = 0; j < 3; ++j) {
        if (open.empty() ? j == 2 || random.below(2) == 0 : random.below(2) == 0) open.push_back(j);
      }
      const std::size_t chosen = bisection->choose(box, open, {box, random.below(3)});
      ASSERT_TRUE(std::ranges::count(open, chosen) == 1) << chosen << " of " << planted::to_text(box);
    }
  }
}

std::vector<std::string> names() { return bisection_registry().names(); }

INSTANTIATE_TEST_SUITE_P(Every, BisectionNamed, ::testing::ValuesIn(names()),
                         [](const auto& variant) { return variant.param; });

/// Gauss quadrature: combinations cancel the weights, which are linear, so that it pays to cut the knots even
/// where these are the narrower sides by far.
TEST(CombinedSmear, PrefersTheKnotsOfAQuadratureToItsWeights) {
  const SystemFunctions functions(
      system_of({"w1", "w2", "x1", "x2"},
                {"w1 + w2 - 1", "w1*x1 + w2*x2", "w1*x1^2 + w2*x2^2 - 2/3", "w1*x1^3 + w2*x2^3"}));
  const std::vector<std::size_t> open = {0, 1, 2, 3};
  const Box box = {{-1.02e7, -0.98e7}, {0.98e7, 1.02e7}, {99.5, 100.5}, {99.5, 100.5}};
  const auto chosen_by = [&](const char* name) {
    return bisection_registry().at(name).make(functions)->choose(box, open, {box, 0});
  };
  EXPECT_LT(chosen_by("relative_smear_sum"), 2U);
  EXPECT_GE(chosen_by("combined_smear"), 2U);
}

}  // namespace
}  // namespace gcslab
