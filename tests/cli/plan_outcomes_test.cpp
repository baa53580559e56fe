// What a user is told of construction plans that solve a system, that cannot, and that degenerate on the way.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/gcslab_shell.h"

namespace gcslab {
namespace {

using Json = nlohmann::json;

class PlanOutcomes : public GcslabShell {
 protected:
  Json solved(const std::string& arguments, int exit_code = 0) {
    answer_ = shell("$gcslab solve " + arguments + " --json r.json");
    EXPECT_EQ(answer_.exit_code, exit_code) << answer_.err;
    return Json::parse(text_of(folder_ / "r.json"));
  }

  /// Circles around A and B of radii p and q meet in C, those around A and C of radii r and s in D.
  void write_chain(const std::string& values, const std::string& more = "") {
    write("chain.yaml",
          "kind: constraint_system\nname: chain\nuniverse: 2d\npoints: [A, B, C, D]\nconstraints:\n"
          "  - {distance: [A, B], parameter: b}\n  - {distance: [A, C], parameter: p}\n"
          "  - {distance: [B, C], parameter: q}\n  - {distance: [A, D], parameter: r}\n"
          "  - {distance: [C, D], parameter: s}\n" +
              more + "valuations: {wanted: {" + values +
              "}}\nframe: [A, B]\nsketch: {random: 1}\norigin: test\nlicence: test\n");
  }

  Answer answer_{};
};

constexpr const char* kEvaluation = "chain.yaml --method plan_evaluation --proof r.proof";

TEST_F(PlanOutcomes, OfASystemThatThePlanSolvesAreAllSolutionsWithProof) {
  write_chain("b: 5, p: 4, q: 3, r: 2, s: sqrt(7)");
  const Json result = solved(kEvaluation);
  EXPECT_EQ(result["status"], "complete");
  EXPECT_EQ(result["completeness"], "proved");
  EXPECT_EQ(result["solutions"].size(), 8U);
  EXPECT_EQ(result["classes"].size(), 2U);
  EXPECT_EQ(result["plan"]["guides"], 0);
  EXPECT_EQ(result["plan"]["branches"], 4);
  const Answer verified = shell("$gcslab verify r.json --proof r.proof");
  EXPECT_EQ(verified.exit_code, 0) << verified.out << verified.err;
  EXPECT_TRUE(has(verified.out, "nothing is missing")) << verified.out;
  // One solution less is noticed.
  EXPECT_EQ(shell("sed 's/loci_intersection 1 0 0/loci_intersection 1 0 1/' r.proof > bad.proof; "
                  "$gcslab verify r.json --proof bad.proof")
                .exit_code,
            1);
}

TEST_F(PlanOutcomes, AreThoseOfTheBoxSolverOnTheCorpus) {
  for (const std::string problem :
       {"sketches/triangle", "polyhedra/tetrahedron-volume", "figure_families/polygon-5",
        "figure_families/polygon-7", "figure_families/triangulated-polyhedron-4"}) {
    const Json found = solved(problem + " --method plan_evaluation --proof r.proof");
    EXPECT_EQ(found["status"], "complete") << problem;
    EXPECT_TRUE(has(shell("$gcslab verify r.json --proof r.proof").out, "nothing is missing")) << problem;
    const Json searched = solved(problem + " --method adaptive");
    EXPECT_EQ(searched["status"], "complete") << problem;
    EXPECT_EQ(found["solutions"].size(), searched["solutions"].size()) << problem;
    EXPECT_EQ(found["classes"].size(), searched["classes"].size()) << problem;
    for (const Json& solution : found["solutions"]) {
      const std::vector<double> point = solution["point"];
      EXPECT_TRUE(std::ranges::any_of(searched["solutions"], [&](const Json& other) {
        const std::vector<double> there = other["point"];
        return std::ranges::equal(point, there, [](double a, double b) { return std::abs(a - b) < 1e-9; });
      })) << problem;
    }
  }
}

TEST_F(PlanOutcomes, GoOnNoLongerThanTheyMay) {
  const Json result = solved("figure_families/polygon-20 --method plan_evaluation --timeout 1", 3);
  EXPECT_EQ(result["status"], "budget_exhausted");
  EXPECT_FALSE(result["undecided"].empty());
}

TEST_F(PlanOutcomes, OfLociThatMissEachOtherAreNoneWithProof) {
  write_chain("b: 5, p: 1, q: 3, r: 2, s: 2");
  const Json result = solved(kEvaluation);
  EXPECT_EQ(result["status"], "complete");
  EXPECT_TRUE(result["solutions"].empty());
  EXPECT_TRUE(has(shell("$gcslab verify r.json --proof r.proof").out, "nothing is missing"));
}

TEST_F(PlanOutcomes, OfDegenerateInstructionsStayUndecidedAndSayWhy) {
  const struct {
    const char* values;
    const char* reason;
  } cases[] = {
      {"b: 5, p: 2, q: 3, r: 3, s: 2", "the loci of C touch, or nearly, with 1024 bits"},
      {"b: 5, p: 0, q: 5, r: 2, s: 2", "the loci of D may meet in infinitely many points"},
      {"b: 0, p: 2, q: 2, r: 2, s: 2", "B may be at one place or on one line with the points before it"},
  };
  for (const auto& [values, reason] : cases) {
    write_chain(values);
    const Json result = solved(kEvaluation);
    EXPECT_EQ(result["status"], "partial") << values;
    ASSERT_FALSE(result["undecided"].empty()) << values;
    EXPECT_TRUE(has(result["undecided"][0]["reason"], reason)) << result["undecided"][0]["reason"];
    EXPECT_TRUE(has(answer_.out, reason)) << answer_.out;
    const Answer verified = shell("$gcslab verify r.json --proof r.proof");
    EXPECT_EQ(verified.exit_code, 0) << values << verified.out << verified.err;
  }
  // Coincident centres and radii that differ: no figure.
  write_chain("b: 5, p: 0, q: 5, r: 2, s: 3");
  EXPECT_EQ(solved(kEvaluation)["status"], "complete");
}

TEST_F(PlanOutcomes, OfAnOverConstrainedSystem) {
  const std::string more = "  - {distance: [B, D], parameter: x}\n";
  write_chain("b: 5, p: 4, q: 3, r: 4, s: 4.8, x: 1", more);
  const Json none = solved("chain.yaml --method plan_evaluation");
  EXPECT_EQ(none["status"], "complete");
  EXPECT_TRUE(none["solutions"].empty());
  EXPECT_TRUE(has(answer_.err, "over-constrained")) << answer_.err;
  write_chain("b: 5, p: 4, q: 3, r: 4, s: 4.8, x: 3", more);
  const Json fits = solved("chain.yaml --method plan_evaluation");
  EXPECT_EQ(fits["status"], "partial");
  ASSERT_FALSE(fits["undecided"].empty());
  EXPECT_TRUE(has(fits["undecided"][0]["reason"], "more equations than unknowns"));
  const Answer path = shell("$gcslab solve chain.yaml --method plan_path");
  EXPECT_EQ(path.exit_code, 4);
  EXPECT_TRUE(has(path.err, "over-constrained")) << path.err;
}

TEST_F(PlanOutcomes, SayWhatAPlanNeeds) {
  const auto expect = [&](const std::string& arguments, int exit_code, const std::string& text) {
    const Answer answer = shell("$gcslab solve " + arguments);
    EXPECT_EQ(answer.exit_code, exit_code) << arguments;
    EXPECT_TRUE(has(answer.err, text)) << answer.err;
  };
  expect("polyhedra/octahedron --method plan_evaluation", 4, "no construction plan places every point");
  expect("polyhedra/octahedron-equations --method plan_evaluation", 4, "only constraint systems");
  expect("sketches/apollonius --method plan_evaluation", 4, "construction plans place points");
  expect("sketches/triangle --method plan_pli", 4, "plan_evaluation lists all solutions");
  expect("sketches/triangle --method plan_newton", 4, "plan_evaluation lists all solutions");
  write_chain("b: 5, p: 4, q: 3, r: 2, s: 3");
  expect("chain.yaml --method plan_evaluation --set maximum_branches=1", 3, "");
}

TEST_F(PlanOutcomes, SayThatAGuideIsOutsideOfTheDomain) {
  // A quadrilateral of short sides, drawn large: its diagonal, which the angle is to tell, is a guide.
  write("far.yaml",
        "kind: constraint_system\nname: far\nuniverse: 2d\npoints: [A, B, C, D]\nconstraints:\n"
        "  - {distance: [A, B], parameter: a}\n  - {angle: [A, B, C], parameter: w}\n"
        "  - {distance: [B, C], parameter: b}\n  - {distance: [C, D], parameter: c}\n"
        "  - {distance: [A, D], parameter: d}\n"
        "valuations: {wanted: {a: 1, w: 60 deg, b: 1, c: 1, d: 1}}\nframe: [A, B]\n"
        "sketch: {A: [0, 0], B: [9, 0], C: [8, 9], D: [0, 8]}\norigin: test\nlicence: test\n");
  const Json result = solved("far.yaml --method plan_newton");
  EXPECT_TRUE(result["solutions"].empty());
  EXPECT_TRUE(has(answer_.err, "branches never inside of their domain (the loci of")) << answer_.err;
}

TEST_F(PlanOutcomes, NameWhereAPathGoesToInfinity) {
  const Json result = solved(
      "polyhedra/6p7d3a2c --method plan_path --set valuation=to_infinity interpolation=compact_support");
  ASSERT_EQ(result["plan"]["escapes"].size(), 1U);
  const Json escape = result["plan"]["escapes"][0];
  EXPECT_EQ(escape["objects"], Json::array({"P3"}));
  EXPECT_EQ(escape["guides"].size(), 2U);
  const Json path = result["paths"][0];
  EXPECT_EQ(path["type"], "to_infinity");
  const std::string met = path["escape"];
  EXPECT_TRUE(met.starts_with(escape["configuration"].get<std::string>())) << met;
  // Imbach 2013, section 4.2.2: both angles are flat there.
  EXPECT_TRUE(has(met, "angle P2 P3 P4 goes to 0 and angle P2 P3 P0 goes to 0")) << met;
  EXPECT_TRUE(has(answer_.out, "can go to infinity: P3 infinitely far")) << answer_.out;
  EXPECT_TRUE(has(answer_.out, "ends: P3 infinitely far")) << answer_.out;
  const Json tied = solved("polyhedra/octahedron --method plan_path");
  EXPECT_TRUE(tied["plan"]["escapes"].empty());
  EXPECT_FALSE(tied["paths"][0].contains("escape"));
  EXPECT_TRUE(has(answer_.out, "no point can go to infinity")) << answer_.out;
}

TEST_F(PlanOutcomes, NameWhereThePlanDegenerates) {
  std::string all;
  for (int seed = 1; seed <= 12; ++seed) {
    answer_ =
        shell("$gcslab solve polyhedra/hexahedron --method plan_path --json r.json --set random_sketch=" +
              std::to_string(seed));
    const Json path = Json::parse(text_of(folder_ / "r.json"))["paths"][0];
    if (path["type"] == "to_undefined") {
      EXPECT_TRUE(path.contains("plan_event") && path.contains("other_plan_event")) << path;
    }
    all += answer_.out;
  }
  EXPECT_TRUE(has(all, "ends: the points of the plan's frame, P0 P1 P2, are on a line")) << all;
  EXPECT_TRUE(has(all, "ends: the plan is singular at P4, whose loci are not in general position")) << all;
}

}  // namespace
}  // namespace gcslab
