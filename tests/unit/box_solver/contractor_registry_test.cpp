// What contractors refuse, and what they do beyond the contract.

#include "box_solver/contractor_registry.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/planted_system.h"

namespace gcslab {
namespace {

using planted::system_of;

std::string refusal(const std::string& name, const EquationSystem& system) {
  try {
    static_cast<void>(make_contractor(name, SystemFunctions(system), {}));
  } catch (const NotApplicable& reason) {
    return reason.what();
  }
  return "";
}

TEST(ContractorRegistry, RefusalsNameTheReason) {
  const EquationSystem wide = system_of({"x", "y"}, {"x + y"});
  EXPECT_NE(refusal("newton", wide).find("1 in 2"), std::string::npos) << refusal("newton", wide);
  EXPECT_NE(refusal("hull+krawczyk", wide), "");
  EXPECT_EQ(refusal("bernstein_projection", wide), "");
  const EquationSystem wave = system_of({"x", "y"}, {"x + y", "sin(x) - y"});
  EXPECT_NE(refusal("mourrain_pavone", wave).find("equation 2 contains sin"), std::string::npos)
      << refusal("mourrain_pavone", wave);
  EXPECT_THROW(static_cast<void>(make_contractor("hull+newtn", SystemFunctions(wide), {})), InputError);
}

TEST(ContractorRegistry, TensorsThatGrowTooLargeAreRefused) {
  std::vector<std::string> variables, equations;
  for (int i = 0; i < 13; ++i) variables.push_back("x" + std::to_string(i));
  for (int i = 0; i < 13; ++i)
    equations.push_back(variables[static_cast<std::size_t>(i)] + "^2 - " +
                        variables[static_cast<std::size_t>((i + 1) % 13)]);
  const std::string reason = refusal("bernstein_projection", system_of(variables, equations));
  EXPECT_NE(reason.find("coefficients"), std::string::npos) << reason;
}

Box contracted(const std::string& name, const EquationSystem& system, Box box) {
  const SystemFunctions functions(system);
  ProofTrace trace;
  EXPECT_TRUE(contractor_registry().at(name).make(functions, {})->contract(box, trace));
  return box;
}

TEST(ContractorRegistry, ALinearSystemIsSolvedInOneStep) {
  const EquationSystem linear = system_of({"x", "y"}, {"2*x + y - 1", "x - 3*y + 1/3"});
  for (const char* name : {"newton", "krawczyk", "multipliers", "bernstein_projection", "mourrain_pavone"}) {
    const Box box = contracted(name, linear, {{-1, 2}, {-1, 2}});
    EXPECT_LT(width(box[0]) + width(box[1]), 1e-8) << name;
    EXPECT_TRUE(contains(box[0], 8.0 / 21)) << name;
  }
}

TEST(ContractorRegistry, DisjunctionSeesWhatPropagationCannot) {
  // Every value of x has a y and every y an x, so that propagation is stuck; the slices of x are not.
  const EquationSystem system = system_of({"x", "y"}, {"x^2 - y^2", "x + y - 2*x*y - 1/8"});
  const Box whole = {{-1, 1}, {-1, 1}};
  const Box by_hull = contracted("hull", system, whole);
  for (const char* name : {"constructive_disjunction", "adaptive_constructive_disjunction"}) {
    const Box box = contracted(name, system, whole);
    EXPECT_LT(width(box[0]) + width(box[1]), width(by_hull[0]) + width(by_hull[1])) << name;
  }
}

TEST(ContractorRegistry, BoxConsistencySeesWhatPropagationCannot) {
  const EquationSystem system = system_of({"x"}, {"x^3 - x - 6"});  // only root 2
  const Box by_hull = contracted("hull", system, {{-1.5, 10}});
  const Box box = contracted("box_consistency", system, {{-1.5, 10}});
  EXPECT_LT(width(box[0]), 0.5 * width(by_hull[0]));
  EXPECT_TRUE(contains(box[0], 2));
}

TEST(ContractorRegistry, ControlPolynomialsReduceAtLeastAsMuchAsHulls) {
  const EquationSystem system = system_of({"x", "y"}, {"x^3 - x/2 - 1/8 + y/10", "y - x/20"});
  const Box whole = {{0.5, 2}, {0, 1}};
  const Box by_hull = contracted("bernstein_projection", system, whole);
  const Box by_roots = contracted("mourrain_pavone", system, whole);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_TRUE(subset(by_roots[i], by_hull[i]));
  EXPECT_LT(width(by_roots[0]), 0.5 * width(by_hull[0]));
}

}  // namespace
}  // namespace gcslab
