// What the engine says with each certifier is proved again; what it does not say is refused when written in.

#include <algorithm>
#include <gtest/gtest.h>

#include "certification/root_certifier.h"
#include "unit/verifier/solved_system.h"

namespace gcslab {
namespace {

std::vector<std::string> certifiers() {
  std::vector<std::string> names = {"miranda+elber_kim", "krawczyk_slopes+miranda",
                                    "elber_kim+miranda+krawczyk"};
  for (const CertifierName& entry : certifier_names()) names.push_back(entry.name);
  return names;
}

/// Those that can show that a root exists and is alone.
bool certifies(const std::string& certifier) { return certifier != "miranda" && certifier != "elber_kim"; }

std::vector<EquationSystem> systems() {
  return {
      system_of({"x"}, {"x^2 - 2"}, {{-3, 3}}),
      system_of({"x"}, {"x^3 - x/3 + 1/30"}, {{-2, 2}}),
      system_of({"x", "y"}, {"x^2 + y^2 = 1", "y - x^2"}, {{-2, 2}, {-2, 2}}, {"x <= 1/2"}),
      system_of({"x", "y"}, {"sin(3*x) + cos(2*y) = 1/2", "exp(x) - y^2 - 1/3"}, {{-2, 2}, {-2, 2}}),
      system_of({"x", "y", "z"}, {"x^2 + y^2 + z^2 = 3", "x*y + z = 1", "x - y*z + 1/5"},
                {{-2, 2}, {-2, 2}, {-2, 2}}),
      system_of({"x"}, {"(x - 1/3)*(x - 1/3 - 1e-7)"}, {{-2, 2}}),  // a cluster
      system_of({"x"}, {"x^2 - 1"}, {{-1, 1}}),                     // on the border
  };
}

class CertifierProof : public testing::TestWithParam<std::string> {};

TEST_P(CertifierProof, IsAccepted) {
  for (const EquationSystem& system : systems()) {
    const SolvedSystem run = solved(system, "hull+multipliers", 3000, GetParam());
    const SolvedSystem reference = solved(system);
    const VerificationReport report = run.verified();
    EXPECT_TRUE(report.accepted()) << refusals_of(report) << run.result.dump(1);
    EXPECT_TRUE(report.completeness_proved);
    if (certifies(GetParam())) {
      EXPECT_EQ(run.result["status"], "complete");
      EXPECT_EQ(run.result["solutions"].size(), reference.result["solutions"].size());
    } else {
      EXPECT_EQ(run.result["status"], "partial");
      EXPECT_FALSE(run.result["undecided"].empty());
    }
    for (const Json& solution : run.result["solutions"])
      EXPECT_EQ(solution["certificate"]["claim"], certifies(GetParam()) ? "unique" : "exists");
  }
}

TEST_P(CertifierProof, SaysNothingOfADoubleRootOrANearMiss) {
  for (const char* text : {"x^2", "x^2 + 1e-30"}) {
    const SolvedSystem run = solved(system_of({"x"}, {text}, {{-1, 2}}), "hull", 3000, GetParam());
    EXPECT_TRUE(run.result["solutions"].empty()) << text;
    EXPECT_TRUE(run.verified().accepted()) << refusals_of(run.verified());
  }
}

TEST_P(CertifierProof, IsRefusedOnceEdited) {
  SolvedSystem run = solved(systems()[2], "hull+multipliers", 3000, GetParam());
  if (run.result["solutions"].empty()) return;  // elber_kim
  const auto refuses = [&](const auto& edit) {
    SolvedSystem copy = run;
    edit(copy.result["solutions"][0]);
    copy.sign();
    return !copy.verified().accepted();
  };
  ASSERT_TRUE(run.verified().accepted());
  EXPECT_TRUE(refuses([](Json& s) { s["certificate"]["evidence"][0]["type"] = "oracle"; }));
  EXPECT_TRUE(refuses([](Json& s) { s["certificate"]["evidence"][0]["claim"] = "at_most_one"; }) ||
              GetParam().starts_with("elber_kim"));
  EXPECT_TRUE(refuses([](Json& s) {
    s["certificate"]["evidence"][0]["box"] = box_json({{0.1, 0.2}, {0, 1}});
  }));
  EXPECT_TRUE(refuses([](Json& s) { s["box"] = box_json({{0.1, 0.2}, {0, 1}}); }));
  if (!certifies(GetParam())) return;  // a root does exist there
  EXPECT_TRUE(refuses([](Json& s) {
    for (Json& evidence : s["certificate"]["evidence"]) evidence["box"] = box_json({{-2, 2}, {-2, 2}});
  }));
}

std::string name_of_choice(const testing::TestParamInfo<std::string>& choice) {
  std::string name = choice.param;
  std::ranges::replace(name, '+', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Every, CertifierProof, testing::ValuesIn(certifiers()), name_of_choice);

TEST(ExistenceAlone, OfATripleRootIsProvedAndNotCalledSingle) {
  // No theorem that shows a single root applies; the equation changes its sign all the same.
  const EquationSystem system = system_of({"x", "y"}, {"(x - 1/3)^3", "y - 1/2 - x/8"}, {{-1, 2}, {-1, 2}});
  for (const char* certifier : {"miranda", "krawczyk_slopes+miranda"}) {
    SolvedSystem run = solved(system, "hull", 3000, certifier);
    ASSERT_EQ(run.result["solutions"].size(), 1u) << certifier << run.result.dump(1);
    EXPECT_EQ(run.result["solutions"][0]["certificate"]["claim"], "exists");
    EXPECT_EQ(run.result["status"], "partial");
    EXPECT_TRUE(run.verified().accepted()) << refusals_of(run.verified());
    run.result["solutions"][0]["certificate"]["claim"] = "unique";
    run.sign();
    EXPECT_FALSE(run.verified().accepted());
  }
}

}  // namespace
}  // namespace gcslab
