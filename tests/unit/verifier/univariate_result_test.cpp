// Results of univariate_bernstein, which the verifier proves by counting roots.

#include <functional>
#include <gtest/gtest.h>

#include "box_solver/univariate_search.h"
#include "unit/verifier/solved_system.h"

namespace gcslab {
namespace {

SolvedSystem isolated(const std::string& equation, const Interval& side,
                      const std::vector<std::string>& inequalities = {}) {
  const EquationSystem system = system_of({"x"}, {equation}, {side}, inequalities);
  const SystemFunctions functions(system);
  std::ostringstream text;
  ProofLog log(text);
  const SearchResult found = univariate_search(functions, system.box, &log);
  Json solutions = Json::array();
  for (const Solution& solution : found.solutions) solutions.push_back(solution_json(system, solution));
  Json undecided = Json::array();
  for (const UndecidedBox& box : found.undecided)
    undecided.push_back({{"box", box_json(box.box)}, {"reason", box.reason}});
  SolvedSystem result{system,
                      {{"problem", "test"},
                       {"status", undecided.empty() ? "complete" : "partial"},
                       {"completeness", "proved"},
                       {"variables", system.variables},
                       {"solutions", solutions},
                       {"undecided", undecided}},
                      text.str()};
  result.sign();
  return result;
}

constexpr const char* kWithTriple = "(x - 1/3)^3*(x^2 - 2)*(x + 1)^2";

TEST(UnivariateResult, IsProvedCompleteWithoutAProofFile) {
  for (const Interval& side : {Interval(-2, 2), Interval(-1, 5), Interval::entire()}) {
    const SolvedSystem run = isolated(kWithTriple, side);
    const VerificationReport report = run.verified_without_proof();
    EXPECT_TRUE(report.accepted()) << refusals_of(report);
    EXPECT_TRUE(report.completeness_proved);
    EXPECT_TRUE(run.verified().accepted()) << refusals_of(run.verified());
    EXPECT_TRUE(run.verified().completeness_proved);
  }
}

TEST(UnivariateResult, OfClosePairsAndHighDegreesIsProved) {
  for (const char* equation : {"x^2 - x + 0.249999999999999999999999750", "x^12 - 2*(100*x - 1)^2",
                               "(x - 1/2)^20*(x - 3/4)^3", "x^31 - x", "x^2 - 2*x/3 + 1/9 - 1e-60"}) {
    const SolvedSystem run = isolated(equation, {-10, 10});
    const VerificationReport report = run.verified_without_proof();
    EXPECT_TRUE(report.accepted()) << equation << "\n" << refusals_of(report);
    EXPECT_TRUE(report.completeness_proved) << equation;
  }
}

TEST(UnivariateResult, WithRootsThatInequalitiesExcludeIsProvedByItsProofFile) {
  const SolvedSystem run = isolated(kWithTriple, {-2, 2}, {"x <= 1"});
  EXPECT_EQ(run.result["solutions"].size(), 3u);
  EXPECT_FALSE(run.verified_without_proof().completeness_proved);
  const VerificationReport report = run.verified();
  EXPECT_TRUE(report.accepted()) << refusals_of(report);
  EXPECT_TRUE(report.completeness_proved);
}

TEST(UnivariateResult, OfTheEquationZeroCoversTheBox) {
  const SolvedSystem run = isolated("x - x", {0, 1});
  EXPECT_EQ(run.result["status"], "partial");
  EXPECT_TRUE(run.verified().accepted()) << refusals_of(run.verified());
  EXPECT_TRUE(run.verified().completeness_proved);
}

struct Edited {
  const char* what;
  const char* refused_at;
  std::function<void(Json&)> edit;
};

const Edited kEdited[] = {
    {"a multiplicity too large", "/solutions/0/multiplicity",
     [](Json& r) { r["solutions"][0]["multiplicity"] = 3; }},
    {"a multiplicity too small", "/solutions/2/multiplicity",
     [](Json& r) { r["solutions"][2]["multiplicity"] = 1; }},
    {"a box beside its root", "/solutions/2/box",
     [](Json& r) {
       r["solutions"][2]["box"] = box_json({{0.3, 0.31}});
     }},
    {"a uniqueness box with two roots", "/solutions/2/uniqueness_box",
     [](Json& r) {
       r["solutions"][2]["uniqueness_box"] = box_json({{-1, 1}});
     }},
    {"evidence with two roots", "/solutions/0/certificate/evidence/0/box",
     [](Json& r) {
       r["solutions"][0]["certificate"]["evidence"][0]["box"] = box_json({{-2, 0}});
     }},
    {"a root listed twice", "/solutions", [](Json& r) { r["solutions"].push_back(r["solutions"][2]); }},
};

TEST(UnivariateResult, IsRefusedWhenEdited) {
  const SolvedSystem run = isolated(kWithTriple, {-2, 2});
  for (const Edited& edited : kEdited) {
    SolvedSystem changed = run;
    edited.edit(changed.result);
    changed.sign();
    EXPECT_TRUE(
        refusals_of(changed.verified_without_proof()).starts_with(std::string(edited.refused_at) + ": "))
        << edited.what << "\n"
        << refusals_of(changed.verified_without_proof());
  }
}

TEST(UnivariateResult, WithARootLeftOutIsNotProvedComplete) {
  SolvedSystem run = isolated(kWithTriple, {-2, 2});
  run.result["solutions"].erase(2);
  run.sign();
  EXPECT_FALSE(run.verified_without_proof().completeness_proved);
  EXPECT_FALSE(run.verified().accepted());
}

TEST(UnivariateResult, RefusesAProofThatExcludesARootWithoutReason) {
  SolvedSystem run = isolated(kWithTriple, {-2, 2}, {"x <= 1"});
  const std::size_t at = run.proof.find("end counted");
  ASSERT_NE(at, std::string::npos);
  run.proof.insert(run.proof.find('\n', at), " 0x0p+0 0x1p-1");
  run.proof = with_hash(run.proof);
  EXPECT_FALSE(run.verified().accepted());
}

}  // namespace
}  // namespace gcslab
