// What a result file says without a proof: certificates, points, inequalities, summary.

#include <functional>
#include <gtest/gtest.h>

#include "unit/verifier/solved_system.h"

namespace gcslab {
namespace {

SolvedSystem circle_and_parabola() {
  return solved(system_of({"x", "y"}, {"x^2 + y^2 = 1", "y - x^2"}, {{-2, 2}, {-2, 2}}, {"x <= 1"}));
}

TEST(Result, IsAcceptedWithAndWithoutProof) {
  const SolvedSystem run = circle_and_parabola();
  ASSERT_EQ(run.result["solutions"].size(), 2u);
  EXPECT_TRUE(run.verified().accepted()) << refusals_of(run.verified());
  const VerificationReport report = run.verified_without_proof();
  EXPECT_TRUE(report.accepted()) << refusals_of(report);
  EXPECT_FALSE(report.completeness_proved);
}

TEST(Result, WithoutProofTheReportSaysThatCompletenessWasNotChecked) {
  const VerificationReport report = circle_and_parabola().verified_without_proof();
  const auto tells = [](const std::string& text) { return text.starts_with("/completeness"); };
  EXPECT_TRUE(std::ranges::any_of(report.not_checked, tells));
  EXPECT_FALSE(std::ranges::any_of(circle_and_parabola().verified().not_checked, tells));
}

TEST(Result, ChecksAreCounted) {
  std::map<std::string, std::uint64_t> counts;
  for (const auto& [claim, count] : circle_and_parabola().verified().checked) counts[claim] = count;
  EXPECT_EQ(counts["solutions: the box contains a root"], 2u);
  EXPECT_EQ(counts["solutions: the uniqueness box contains no other root"], 2u);
  EXPECT_EQ(counts["solutions: inequalities"], 2u);
  EXPECT_EQ(counts["pairs of solutions: different roots"], 1u);
  EXPECT_GT(counts["proof: boxes followed to their end"], 0u);
}

/// The bound moved by some units in the last place.
std::string moved(const Json& bound, int units) {
  double value = std::strtod(bound.get<std::string>().c_str(), nullptr);
  for (; units > 0; --units) value = std::nextafter(value, 1e300);
  for (; units < 0; ++units) value = std::nextafter(value, -1e300);
  return hexadecimal(value);
}

struct Edited {
  const char* what;
  const char* refused_at;  ///< JSON pointer
  std::function<void(Json&)> edit;
};

const Edited kEdited[] = {
    {"a box moved off its root", "/solutions/0/box",
     [](Json& r) {
       for (Json& bound : r["solutions"][0]["box"][0]) bound = moved(bound, 5);
     }},
    {"a box in which there is no root", "/solutions/0/box",
     [](Json& r) {
       r["solutions"][0]["box"] = box_json({{0, 1e-3}, {0, 1e-3}});
     }},
    {"a uniqueness box with two roots", "/solutions/0/uniqueness_box",
     [](Json& r) {
       r["solutions"][0]["uniqueness_box"] = box_json({{-2, 2}, {-2, 2}});
     }},
    {"a uniqueness box off the box", "/solutions/0/uniqueness_box",
     [](Json& r) {
       r["solutions"][0]["uniqueness_box"] = box_json({{1, 2}, {1, 2}});
     }},
    {"evidence for two roots", "/solutions/0/certificate/evidence/0/box",
     [](Json& r) {
       r["solutions"][0]["certificate"]["evidence"][0]["box"] = box_json({{-2, 2}, {-2, 2}});
     }},
    {"evidence elsewhere", "/solutions/0/certificate/evidence/0/box",
     [](Json& r) {
       r["solutions"][0]["certificate"]["evidence"][0]["box"] = box_json({{1, 2}, {1, 2}});
     }},
    {"evidence of an unknown claim", "/solutions/0/certificate/evidence/0/claim",
     [](Json& r) { r["solutions"][0]["certificate"]["evidence"][0]["claim"] = "sure"; }},
    {"evidence by a theorem that nobody knows", "/solutions/0/certificate/evidence/0/type",
     [](Json& r) { r["solutions"][0]["certificate"]["evidence"][0]["type"] = "oracle"; }},
    {"evidence that is more than its theorem shows", "/solutions/0/certificate/evidence/0/claim",
     [](Json& r) { r["solutions"][0]["certificate"]["evidence"][0]["type"] = "miranda"; }},
    {"evidence that is less than the claim", "/solutions/0/certificate/evidence",
     [](Json& r) {
       Json& evidence = r["solutions"][0]["certificate"]["evidence"];
       evidence = Json::array({evidence[0]});
       evidence[0]["type"] = "miranda";
       evidence[0]["claim"] = "exists";
     }},
    {"a solution twice", "/solutions", [](Json& r) { r["solutions"].push_back(r["solutions"][0]); }},
    {"a point outside of the box", "/solutions/0/point",
     [](Json& r) { r["solutions"][0]["point"][0] = 0.5; }},
    {"a point of three coordinates", "/solutions/0/point",
     [](Json& r) { r["solutions"][0]["point"].push_back(0.5); }},
    {"a residual that is too small", "/solutions/0/residual",
     [](Json& r) {
       // A wide box has room for a point with a residual.
       r["solutions"][0]["box"] = r["solutions"][0]["certificate"]["evidence"][0]["box"] =
           box_json({{0.78, 0.79}, {0.61, 0.62}});
       r["solutions"][0]["uniqueness_box"] = box_json({{0.77, 0.8}, {0.6, 0.63}});
       r["solutions"][0]["point"] = {0.7875, 0.6175};
       r["solutions"][0]["residual"] = 0;
     }},
    {"a residual that is too large", "/solutions/0/residual",
     [](Json& r) { r["solutions"][0]["residual"] = 1; }},
    {"a multiplicity", "/solutions/0/multiplicity", [](Json& r) { r["solutions"][0]["multiplicity"] = 2; }},
    {"a root that is not isolated", "/solutions/0/isolated",
     [](Json& r) { r["solutions"][0]["isolated"] = "no"; }},
    {"an unknown kind", "/solutions/0/kind", [](Json& r) { r["solutions"][0]["kind"] = "imaginary"; }},
    {"a certified complex solution", "/solutions/0", [](Json& r) { r["solutions"][0]["kind"] = "complex"; }},
    {"evidence without claim", "/solutions/0/certificate/evidence",
     [](Json& r) { r["solutions"][0]["certificate"]["claim"] = "none"; }},
    {"a box of decimal numbers", "/solutions/0/box/0/0",
     [](Json& r) { r["solutions"][0]["box"][0][0] = "-0.7861513777574234"; }},
    {"a box of numbers", "/solutions/0/box/0/0", [](Json& r) { r["solutions"][0]["box"][0][0] = -0.79; }},
    {"a box of one side", "/solutions/0/box", [](Json& r) { r["solutions"][0]["box"].erase(1); }},
    {"a box outside of the search box", "/solutions/0/box",
     [](Json& r) {
       r["solutions"][0]["box"] = box_json({{3, 4}, {3, 4}});
     }},
    {"other variables", "/variables",
     [](Json& r) {
       r["variables"] = {"y", "x"};
     }},
    {"an unknown status", "/status", [](Json& r) { r["status"] = "great"; }},
    {"complete without completeness", "/status", [](Json& r) { r["completeness"] = "none"; }},
    {"partial though complete", "/status", [](Json& r) { r["status"] = "partial"; }},
    {"complete with an undecided box", "/status",
     [](Json& r) {
       r["undecided"].push_back({{"box", box_json({{0, 1}, {0, 1}})}, {"reason", "?"}});
     }},
    {"an undecided box of one side", "/undecided/0/box",
     [](Json& r) {
       r["undecided"].push_back({{"box", box_json({{0, 1}})}, {"reason", "?"}});
     }},
    {"no solutions", "", [](Json& r) { r.erase("solutions"); }},
    {"no certificate", "/solutions/0", [](Json& r) { r["solutions"][0].erase("certificate"); }},
    {"solutions that are no list", "/solutions", [](Json& r) { r["solutions"] = "none"; }},
};

TEST(Result, IsRefusedWhereItIsEdited) {
  const SolvedSystem run = circle_and_parabola();
  for (const Edited& edited : kEdited) {
    SolvedSystem copy = run;
    edited.edit(copy.result);
    copy.sign();
    const VerificationReport report = copy.verified_without_proof();
    ASSERT_FALSE(report.accepted()) << edited.what;
    EXPECT_EQ(report.refusals.front().where, edited.refused_at) << edited.what << "\n" << refusals_of(report);
  }
}

TEST(Result, IsRefusedWhenItsHashIsNotThatOfItsContent) {
  SolvedSystem run = circle_and_parabola();
  run.result["statistics"] = {{"boxes", 1}};
  EXPECT_EQ(run.verified().refusals.front().where, "/content_hash");
  run.sign();
  EXPECT_TRUE(run.verified().accepted());
}

TEST(Result, ThatIsNoObjectIsRefused) {
  const EquationSystem system = system_of({"x"}, {"x"}, {{-1, 1}});
  EXPECT_FALSE(verify(system, system.box, Json::array()).accepted());
  EXPECT_FALSE(verify(system, system.box, Json()).accepted());
}

TEST(Result, InequalitiesAreProvedAtTheRoot) {
  SolvedSystem run = circle_and_parabola();
  run.system = system_of({"x", "y"}, {"x^2 + y^2 = 1", "y - x^2"}, {{-2, 2}, {-2, 2}}, {"x <= 0"});
  EXPECT_EQ(run.verified_without_proof().refusals.size(), 1u);  // one of the two roots has x > 0
  // x^4 + x^2 = 1 at the roots: the inequality holds with equality, which no enclosure proves.
  run.system = system_of({"x", "y"}, {"x^2 + y^2 = 1", "y - x^2"}, {{-2, 2}, {-2, 2}}, {"x^4 + x^2 <= 1"});
  EXPECT_EQ(run.verified_without_proof().refusals.size(), 2u);
  for (Json& solution : run.result["solutions"]) solution["inequalities"] = "undecided";
  run.sign();
  EXPECT_TRUE(run.verified_without_proof().accepted());
}

TEST(Result, SolutionsWithoutCertificateAreSaidToBeUnchecked) {
  SolvedSystem run = circle_and_parabola();
  Json& solution = run.result["solutions"][0];
  for (const char* key : {"uniqueness_box", "multiplicity", "isolated", "inequalities"}) solution.erase(key);
  solution["certificate"] = {{"claim", "none"}};
  run.result["completeness"] = "none";
  run.result["status"] = "partial";
  run.sign();
  const VerificationReport report = run.verified_without_proof();
  EXPECT_TRUE(report.accepted()) << refusals_of(report);
  EXPECT_EQ(std::ranges::count_if(report.not_checked,
                                  [](const std::string& text) { return text.starts_with("/solutions/0"); }),
            1);
  // The proof rests on the root that is no longer certified.
  EXPECT_FALSE(run.verified().accepted());
}

TEST(VerifyRoot, ProvesRootsOfEveryFormOfEquation) {
  const auto proves = [](const std::vector<std::string>& equations, const Box& box, const Box& uniqueness) {
    const std::vector<std::string> names = {"x", "y"};
    const std::vector<std::string> variables(names.begin(),
                                             names.begin() + static_cast<std::ptrdiff_t>(box.size()));
    return verify_root(system_of(variables, equations, uniqueness), box, uniqueness);
  };
  EXPECT_TRUE(proves({"x^2 - 2"}, {{1.4, 1.5}}, {{0.1, 10}}));
  EXPECT_FALSE(proves({"x^2 - 2"}, {{1.5, 1.6}}, {{0.1, 10}}));
  EXPECT_FALSE(proves({"x^2 - 2"}, {{1.4, 1.5}}, {{-1.5, 10}}));
  EXPECT_FALSE(proves({"x^2 - 2"}, {{1.4, 1.5}}, {{1.45, 10}}));
  EXPECT_FALSE(proves({"x^2 + 2"}, {{-1, 1}}, {{-1, 1}}));
  EXPECT_FALSE(proves({"x^2"}, {{-1, 1}}, {{-1, 1}}));  // a double root
  EXPECT_TRUE(proves({"sin(x)"}, {{3.1, 3.2}}, {{2, 4.2}}));
  EXPECT_FALSE(proves({"sin(x)"}, {{3.1, 3.2}}, {{-0.1, 4.2}}));
  EXPECT_TRUE(proves({"abs(x) - x/2 - 1", "y - x"}, {{1.9, 2.1}, {1.9, 2.1}}, {{0.5, 3}, {0.5, 3}}));
  EXPECT_FALSE(proves({"sqrt(x) - 1"}, {{0.9, 1.1}}, {{-1, 2}}));  // undefined in the uniqueness box
  EXPECT_TRUE(proves({"sqrt(x) - 1"}, {{0.9, 1.1}}, {{0.5, 1.5}}));
  EXPECT_FALSE(proves({"x - y"}, {{0, 1}, {0, 1}}, {{0, 1}, {0, 1}}));  // not square
}

TEST(VerifyRoot, ProvesExactRootsInBoxesOfOnePoint) {
  const Box box = {{2, 2}, {1, 1}};
  const Box around = {{1.5, 3}, {0.5, 1.5}};
  const std::vector<std::vector<std::string>> exact = {{"x + y - 3", "x - y - 1"}, {"x - 2", "x*y - 2"}};
  for (const auto& equations : exact) {
    const EquationSystem system = system_of({"x", "y"}, equations, around);
    EXPECT_TRUE(verify_root(system, box, around)) << equations[1];
    EXPECT_FALSE(verify_root(system, {{2, 2}, {std::nextafter(1, 2), std::nextafter(1, 2)}}, around));
  }
}

// Half of the coordinates are 0 and known to 2^-104, the others to a few units of the last place: the root of
// the Virasoro system (data/polynomial_systems/virasoro.yaml) at (1/16, 1/16, 1/16, 0, 0, 0, 0, 1/8).
TEST(VerifyRoot, ProvesRootsInBoxesWithSidesOfVeryDifferentWidths) {
  const std::vector<std::string> names = {"x1", "x2", "x3", "x4", "x5", "x6", "x7", "x8"};
  const std::vector<std::string> equations = {
      "8*x1^2 + 8*x1*x2 + 8*x1*x3 + 2*x1*x4 + 2*x1*x5 + 2*x1*x6 + 2*x1*x7 - 8*x2*x3 - 2*x4*x7 - 2*x5*x6 - x1",
      "8*x1*x2 - 8*x1*x3 + 8*x2^2 + 8*x2*x3 + 2*x2*x4 + 2*x2*x5 + 2*x2*x6 + 2*x2*x7 - 2*x4*x6 - 2*x5*x7 - x2",
      "-8*x1*x2 + 8*x1*x3 + 8*x2*x3 + 8*x3^2 + 2*x3*x4 + 2*x3*x5 + 2*x3*x6 + 2*x3*x7 - 2*x4*x5 - 2*x6*x7 - "
      "x3",
      "2*x1*x4 - 2*x1*x7 + 2*x2*x4 - 2*x2*x6 + 2*x3*x4 - 2*x3*x5 + 8*x4^2 + 8*x4*x5 + 2*x4*x6 + 2*x4*x7 + "
      "6*x4*x8 - 6*x5*x8 - x4",
      "2*x1*x5 - 2*x1*x6 + 2*x2*x5 - 2*x2*x7 - 2*x3*x4 + 2*x3*x5 + 8*x4*x5 - 6*x4*x8 + 8*x5^2 + 2*x5*x6 + "
      "2*x5*x7 + 6*x5*x8 - x5",
      "-2*x1*x5 + 2*x1*x6 - 2*x2*x4 + 2*x2*x6 + 2*x3*x6 - 2*x3*x7 + 2*x4*x6 + 2*x5*x6 + 8*x6^2 + 8*x6*x7 + "
      "6*x6*x8 - 6*x7*x8 - x6",
      "-2*x1*x4 + 2*x1*x7 - 2*x2*x5 + 2*x2*x7 - 2*x3*x6 + 2*x3*x7 + 2*x4*x7 + 2*x5*x7 + 8*x6*x7 - 6*x6*x8 + "
      "8*x7^2 + 6*x7*x8 - x7",
      "-6*x4*x5 + 6*x4*x8 + 6*x5*x8 - 6*x6*x7 + 6*x6*x8 + 6*x7*x8 + 8*x8^2 - x8"};
  const Interval first(0x1.ffffffffffff8p-5, 0x1.0000000000008p-4);
  const Interval last(2 * first.lower, 2 * first.upper);
  const Box box = {first,
                   first,
                   first,
                   {-0x1.36a3e9e85bd1dp-104, 0x1.36a3e9e85bd1dp-104},
                   {-0x1.39812bf9b037dp-104, 0x1.39812bf9b037dp-104},
                   {-0x1.413b95c7d78ebp-104, 0x1.413b95c7d78eap-104},
                   {-0x1.39efda2c9b256p-104, 0x1.39efda2c9b256p-104},
                   last};
  const EquationSystem system = system_of(names, equations, Box(8, Interval(-1, 1)));
  EXPECT_TRUE(verify_root(system, box, box));
  Box beside = box;
  beside[3] = Interval(0x1p-104, 0x1p-103);
  EXPECT_FALSE(verify_root(system, beside, beside));
}

}  // namespace
}  // namespace gcslab
