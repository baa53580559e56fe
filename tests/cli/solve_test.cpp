// What a user asks of `gcslab solve`, hostile questions included, and what is answered.

#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/gcslab_shell.h"

namespace gcslab {
namespace {

using Json = nlohmann::json;

class Solve : public GcslabShell {
 protected:
  /// Writes a problem file; `variables` such as "x, y".
  void problem(const std::string& name, const std::string& variables, const std::string& equations,
               const std::string& box, const std::string& more = "") const {
    write(name, "kind: system\nname: test\nvariables: [" + variables + "]\nequations: [" + equations +
                    "]\nbox: {" + box + "}\n" + more + "origin: test\nlicence: none\n");
  }

  Json solved(const std::string& file, const std::string& options = "", int exit_code = 0) const {
    const Answer answer = shell("$gcslab solve " + file + " --json - " + options);
    EXPECT_EQ(answer.exit_code, exit_code) << answer.err;
    return Json::parse(answer.out, nullptr, false);
  }

  static double number(const Json& text) { return std::strtod(text.get<std::string>().c_str(), nullptr); }
};

TEST_F(Solve, FindsEverySolutionWithACertificateAroundIt) {
  problem("p.yaml", "x, y", "\"x^2 + y^2 = 1\", \"y - x^2\"", "x: [-2, 2], y: [\"-sqrt(2)\", 2]");
  const Json result = solved("p.yaml");
  EXPECT_EQ(result["status"], "complete");
  EXPECT_EQ(result["completeness"], "proved");
  ASSERT_EQ(result["solutions"].size(), 2u);
  const double y = (std::sqrt(5.0) - 1) / 2;
  for (const Json& solution : result["solutions"]) {
    EXPECT_NEAR(solution["point"][1].get<double>(), y, 1e-14);
    EXPECT_NEAR(std::fabs(solution["point"][0].get<double>()), std::sqrt(y), 1e-14);
    EXPECT_EQ(solution["certificate"]["claim"], "unique");
    EXPECT_EQ(solution["isolated"], "proved");
    for (const std::size_t i : {0u, 1u}) {
      EXPECT_LE(number(solution["box"][i][0]), solution["point"][i].get<double>());
      EXPECT_GE(number(solution["box"][i][1]), solution["point"][i].get<double>());
      EXPECT_LE(number(solution["uniqueness_box"][i][0]), number(solution["box"][i][0]));
      EXPECT_GE(number(solution["uniqueness_box"][i][1]), number(solution["box"][i][1]));
    }
  }
}

TEST_F(Solve, KeepsToTheInequalities) {
  problem("p.yaml", "x, y", "\"x^2 + y^2 = 1\", \"y - x^2\"", "x: [-2, 2], y: [-2, 2]",
          "inequalities: [\"x <= 1/2\"]\n");
  const Json result = solved("p.yaml");
  ASSERT_EQ(result["solutions"].size(), 1u);
  EXPECT_LT(result["solutions"][0]["point"][0].get<double>(), 0);
  EXPECT_EQ(result["solutions"][0]["inequalities"], "proved");
}

TEST_F(Solve, ListsARootOnTheBorderAndNoneBeyond) {
  problem("p.yaml", "x", "\"(x - 1)*(x - 2)*(x + 3)\"", "x: [1, 2]");
  EXPECT_EQ(solved("p.yaml")["solutions"].size(), 2u);
  problem("q.yaml", "x", "\"(x - 1)*(x - 2)*(x + 3)\"", "x: [1.0001, 1.9999]");
  EXPECT_EQ(solved("q.yaml")["solutions"].size(), 0u);
}

TEST_F(Solve, SeparatesCloseRoots) {
  problem("three.yaml", "x", "\"(x - 0.0001)*(x - 0.0005)*(x - 0.0009)\"", "x: [-1, 1]");
  EXPECT_EQ(solved("three.yaml")["solutions"].size(), 3u);
  problem("steep.yaml", "x, y", "\"y = 1000*x^2\", \"y = 1000*x^3 + 0.0001\"", "x: [-1, 1], y: [-1, 1]");
  EXPECT_EQ(solved("steep.yaml")["solutions"].size(), 2u);
  // Expanded, so that double precision sees only rounding errors around both: (x - 1/3)^2 - (5e-13)^2.
  problem("pair.yaml", "x", "\"x^2 - 2*x/3 + 1/9 - 25e-26\"", "x: [-1, 1]");
  const Json result = solved("pair.yaml");
  EXPECT_EQ(result["status"], "complete");
  EXPECT_EQ(result["solutions"].size(), 2u);
}

TEST_F(Solve, SaysOfSingularRootsThatTheyAreUndecided) {
  problem("double.yaml", "x", "\"x^2\"", "x: [-1, 1]");
  const Json result = solved("double.yaml");
  EXPECT_EQ(result["status"], "partial");
  EXPECT_EQ(result["completeness"], "proved");
  EXPECT_EQ(result["solutions"].size(), 0u);
  ASSERT_GE(result["undecided"].size(), 1u);
  bool covered = false;
  for (const Json& entry : result["undecided"])
    covered = covered || (number(entry["box"][0][0]) <= 0 && number(entry["box"][0][1]) >= 0);
  EXPECT_TRUE(covered);
  double volume = 0;
  for (const Json& entry : result["undecided"])
    volume += number(entry["box"][0][1]) - number(entry["box"][0][0]);
  EXPECT_GE(result["statistics"]["undecided_volume"].get<double>(), volume);
  EXPECT_LE(result["statistics"]["undecided_volume"].get<double>(), 1.001 * volume);
}

TEST_F(Solve, DecidesWhatIsAlmostSingular) {
  problem("none.yaml", "x", "\"x^2 + 1e-12\"", "x: [-1, 1]");
  EXPECT_EQ(solved("none.yaml")["solutions"].size(), 0u);
  EXPECT_EQ(solved("none.yaml")["status"], "complete");
  problem("two.yaml", "x", "\"x^2 - 1e-12\"", "x: [-1, 1]");
  EXPECT_EQ(solved("two.yaml")["solutions"].size(), 2u);
}

TEST_F(Solve, CoversWhatIsNoPoint) {
  problem("identity.yaml", "x", "\"x - x\"", "x: [0, 1]");
  const Json identity = solved("identity.yaml");
  EXPECT_EQ(identity["status"], "partial");
  EXPECT_EQ(identity["solutions"].size(), 0u);
  EXPECT_GE(identity["undecided"].size(), 1u);
  EXPECT_GE(identity["statistics"]["undecided_volume"].get<double>(), 1);
  problem("circle.yaml", "x, y", "\"x^2 + y^2 = 1\"", "x: [-2, 2], y: [-2, 2]");
  const Json circle = solved("circle.yaml");
  EXPECT_EQ(circle["solutions"].size(), 0u);
  for (int k = 0; k < 64; ++k) {  // every point of the circle lies in a box
    const double x = std::cos(0.1 * k);
    const double y = std::sin(0.1 * k);
    bool covered = false;
    for (const Json& entry : circle["undecided"]) {
      const Json& box = entry["box"];
      covered = covered || (number(box[0][0]) <= x + 1e-15 && x - 1e-15 <= number(box[0][1]) &&
                            number(box[1][0]) <= y + 1e-15 && y - 1e-15 <= number(box[1][1]));
    }
    EXPECT_TRUE(covered) << x << " " << y;
  }
}

TEST_F(Solve, ProvesThatThereIsNone) {
  problem("constant.yaml", "x", "\"1 = 0\"", "x: [0, 1]");
  EXPECT_EQ(solved("constant.yaml")["status"], "complete");
  problem("over.yaml", "x", "\"x - 1/2\", \"x^2 - 1/3\"", "x: [0, 1]");
  const Json over = solved("over.yaml");
  EXPECT_EQ(over["status"], "complete");
  EXPECT_EQ(over["solutions"].size(), 0u);
}

TEST_F(Solve, TakesAnUnboundedBox) {
  problem("p.yaml", "x, y", "\"x^2 + y^2 = 1\", \"y - x^2\"", "x: [-inf, inf], y: [-inf, inf]");
  const Json result = solved("p.yaml");
  EXPECT_EQ(result["status"], "complete");
  EXPECT_EQ(result["solutions"].size(), 2u);
}

TEST_F(Solve, TakesTwoHundredVariables) {
  std::string variables, equations, box;
  for (int i = 0; i < 200; ++i) {
    const std::string x = "x" + std::to_string(i);
    const std::string next = "x" + std::to_string((i + 1) % 200);
    variables += (i == 0 ? "" : ", ") + x;
    equations += (i == 0 ? "\"" : ", \"") + x + " = 1/2 + sqr(" + next + ")/4\"";
    box += (i == 0 ? "" : ", ") + x + ": [0, 1]";
  }
  problem("chain.yaml", variables, equations, box);
  const Json result = solved("chain.yaml");
  EXPECT_EQ(result["status"], "complete");
  ASSERT_EQ(result["solutions"].size(), 1u);
  EXPECT_NEAR(result["solutions"][0]["point"][7].get<double>(), 2 - std::sqrt(2.0), 1e-12);
}

TEST_F(Solve, RefinesToTheDigitsAskedFor) {
  problem("p.yaml", "x", "\"x^2 - 2\"", "x: [0, 2]");
  const Json result = solved("p.yaml", "--precision 200");
  EXPECT_TRUE(result["solutions"][0]["refined_reached"]);
  EXPECT_EQ(result["solutions"][0]["decimal"][0],
            "1.41421356237309504880168872420969807856967187537694807317668");
}

TEST_F(Solve, AnswersTheSameWithTwoThreads) {
  problem("p.yaml", "x, y, z", "\"x^2 + y^2 + z^2 = 3\", \"x*y + z = 2*z^3\", \"x + y^3 - z = 1\"",
          "x: [-3, 3], y: [-3, 3], z: [-3, 3]");
  const Json one = solved("p.yaml", "--threads 1");
  const Json two = solved("p.yaml", "--threads 2");
  EXPECT_GE(one["solutions"].size(), 1u);
  EXPECT_EQ(one["solutions"], two["solutions"]);
  EXPECT_EQ(one["undecided"], two["undecided"]);
  EXPECT_EQ(one["statistics"]["boxes"], two["statistics"]["boxes"]);
}

TEST_F(Solve, GoesOnWhereABudgetStoppedIt) {
  problem("p.yaml", "x, y, z", "\"x^2 + y^2 + z^2 = 3\", \"x*y + z = 2*z^3\", \"x + y^3 - z = 1\"",
          "x: [-3, 3], y: [-3, 3], z: [-3, 3]");
  const Json whole = solved("p.yaml");
  const Json part = solved("p.yaml", "--set maximum_boxes=2 --pending left.json", 3);
  EXPECT_EQ(part["status"], "budget_exhausted");
  EXPECT_GE(part["undecided"].size(), 1u);
  const Json rest = solved("p.yaml", "--resume left.json");
  EXPECT_EQ(rest["status"], "complete");
  EXPECT_EQ(rest["solutions"].size(), whole["solutions"].size());
}

TEST_F(Solve, RefusesAPendingFileOfAnotherProblemOrAnEditedOne) {
  problem("p.yaml", "x", "\"x^3 - x\"", "x: [-3, 3]");
  problem("q.yaml", "x", "\"x^3 - 2*x\"", "x: [-3, 3]");
  solved("p.yaml", "--set maximum_boxes=1 --pending left.json", 3);
  const Answer other = shell("$gcslab solve q.yaml --resume left.json");
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_TRUE(has(other.err, "another problem")) << other.err;
  const Answer edited = shell("sed -i 's/0x1/0x2/' left.json && $gcslab solve p.yaml --resume left.json");
  EXPECT_EQ(edited.exit_code, 2);
  EXPECT_TRUE(has(edited.err, "changed")) << edited.err;
}

TEST_F(Solve, SaysWhatIsWrongWithAFile) {
  problem("no-box.yaml", "x, y", "\"x - y\", \"x + y\"", "x: [0, 1]");
  const Answer no_box = shell("$gcslab solve no-box.yaml");
  EXPECT_EQ(no_box.exit_code, 2);
  EXPECT_TRUE(has(no_box.err, "no-box.yaml:5")) << no_box.err;
  EXPECT_TRUE(has(no_box.err, "'y'")) << no_box.err;
  EXPECT_EQ(lines(no_box.err), 1u);
  problem("bad.yaml", "x", "\"x +* 2\"", "x: [0, 1]");
  EXPECT_EQ(shell("$gcslab solve bad.yaml").exit_code, 2);
  problem("good.yaml", "x", "\"x - 2\"", "x: [0, 3]");
  EXPECT_EQ(shell("$gcslab solve good.yaml --method adaptve").exit_code, 2);
  const Answer misspelt = shell("$gcslab solve good.yaml --set contractor=hul");
  EXPECT_EQ(misspelt.exit_code, 2);
  EXPECT_TRUE(has(misspelt.err, "hull")) << misspelt.err;
  EXPECT_EQ(shell("$gcslab solve good.yaml --json /nowhere/result.json").exit_code, 2);
}

TEST_F(Solve, StopsInTimeAndListsWhatIsLeft) {
  problem("p.yaml", "x, y", "\"x^2 + y^2 = 1\", \"x^2 + y^2 = 1\"", "x: [-2, 2], y: [-2, 2]");
  const Json result = solved("p.yaml", "--timeout 0.3", 3);
  EXPECT_EQ(result["status"], "budget_exhausted");
  EXPECT_GE(result["undecided"].size(), 1u);
}

TEST_F(Solve, WritesResultsAndProofsThatVerifyAcceptsUntilTheyAreEdited) {
  problem("p.yaml", "x, y", "\"x^2 + y^2 = 1\", \"y - x^2\"", "x: [-2, 2], y: [-2, 2]");
  ASSERT_EQ(shell("$gcslab solve p.yaml --json r.json --proof r.proof").exit_code, 0);
  const Answer accepted = shell("$gcslab verify r.json --proof r.proof");
  EXPECT_EQ(accepted.exit_code, 0) << accepted.err;
  EXPECT_TRUE(has(accepted.out, "nothing is missing")) << accepted.out;
  const Answer edited = shell("sed 's/\"real\"/\"complex\"/' r.json > e.json && $gcslab verify e.json");
  EXPECT_EQ(edited.exit_code, 1) << edited.out;
  const Answer shortened = shell("head -n 8 r.proof > s.proof && $gcslab verify r.json --proof s.proof");
  EXPECT_EQ(shortened.exit_code, 1) << shortened.out;
  EXPECT_EQ(shell("$gcslab verify p.yaml").exit_code, 2);
}

/// Around one of its roots, which the Jacobian hardly determines, boxes multiply before the root is found.
TEST_F(Solve, FindsEveryRootOfAnIllConditionedSystem) {
  const Answer found =
      shell("$gcslab solve polynomial_systems/chandra-6 --set cluster_boxes=1000 --json r.json");
  EXPECT_EQ(found.exit_code, 0) << found.err;
  EXPECT_TRUE(has(found.out, "32 solutions, 0 undecided boxes, complete, completeness proved")) << found.out;
}

TEST_F(Solve, ReadsWhatExportWrites) {
  problem("p.yaml", "x, y", "\"x^2 + y^2 = 1\", \"y - x^2\"", "x: [-2, 2], y: [-2, 2]");
  ASSERT_EQ(shell("$gcslab export p.yaml --to minibex --out p.mbx").exit_code, 0);
  ASSERT_EQ(shell("$gcslab export p.yaml --to phc --out p.phc").exit_code, 0);
  EXPECT_EQ(solved("p.mbx")["solutions"].size(), 2u);
  EXPECT_EQ(solved("p.phc")["solutions"].size(), 2u);  // on the whole plane
  const Answer misspelt = shell("$gcslab export p.yaml --to minibx");
  EXPECT_EQ(misspelt.exit_code, 2);
  EXPECT_TRUE(has(misspelt.err, "minibex")) << misspelt.err;
  problem("t.yaml", "x", "\"exp(x) - 2\"", "x: [0, 1]");
  EXPECT_EQ(shell("$gcslab export t.yaml --to phc").exit_code, 4);
}

TEST_F(Solve, DrawsAllBoxesOfASearch) {
  problem("p.yaml", "x, y", "\"x^2 + y^2 = 1\", \"y - x^2\"", "x: [-2, 2], y: [-2, 2]");
  const Answer drawn = shell("$gcslab solve p.yaml --method interval_newton --figure p.svg");
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_TRUE(has(text_of(folder_ / "p.svg"), "</svg>"));
  EXPECT_TRUE(has(text_of(folder_ / "p.svg"), " boxes, ")) << "the counts";
  EXPECT_TRUE(has(text_of(folder_ / "p.dat"), "boxes taken")) << "the data beside it";
  EXPECT_TRUE(has(text_of(folder_ / "p.dat"), "equation 2"));
  problem("q.yaml", "x, y, z", "\"x^2 + y^2 + z^2 = 1\", \"x = y\", \"y = z\"",
          "x: [-2, 2], y: [-2, 2], z: [-2, 3]");
  EXPECT_EQ(shell("$gcslab solve q.yaml --figure q.pdf --figure-variables z,x").exit_code, 0);
  EXPECT_TRUE(has(text_of(folder_ / "q.pdf"), "%%EOF"));
}

TEST_F(Solve, SaysWhatItCannotDraw) {
  problem("p.yaml", "x", "\"x^2 - 2\"", "x: [0, 2]");
  problem("q.yaml", "x, y", "\"x^2 + y^2 = 1\", \"y - x^2\"", "x: [-inf, inf], y: [-2, 2]");
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"p.yaml --figure p.svg", "two or three unknowns"},
      {"q.yaml --figure q.svg", "--box"},
      {"q.yaml --figure q.png", ".svg or .pdf"},
      {"q.yaml --figure q.svg --figure-variables x,z", "'z'"},
      {"q.yaml --figure-variables x,y", "--figure"}};
  for (const auto& [arguments, words] : cases) {
    const Answer answer = shell("$gcslab solve " + arguments);
    EXPECT_EQ(answer.exit_code, 2) << arguments;
    EXPECT_TRUE(has(answer.err, words)) << answer.err;
    EXPECT_EQ(lines(answer.err), 1u) << answer.err;
  }
}

TEST_F(Solve, ReportsTheBoxesOfAnExperiment) {
  problem("p.yaml", "x, y", "\"x^2 + y^2 = 1\", \"y - x^2\"", "x: [-2, 2], y: [-2, 2]");
  write(
      "boxes.yaml",
      "experiment: boxes\ntask: solve\nproblems: [p.yaml]\nmethods: [{name: lp_reduction}, {name: "
      "interval_newton}]\nparameters: {recorded_boxes: 100}\nreport:\n  - figure: {file: boxes, kind: boxes, "
      "rows: "
      "method, columns: problem}\n  - table: {file: counts, rows: problem, columns: method, values: [boxes, "
      "reductions]}\n");
  const Answer run = shell("$gcslab validate boxes.yaml && $gcslab run boxes.yaml --out runs");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Answer report =
      shell("$gcslab report boxes.yaml --runs runs --out reports --reference none --format svg,md");
  EXPECT_EQ(report.exit_code, 0) << report.err;
  EXPECT_TRUE(has(text_of(folder_ / "reports/boxes/boxes.svg"), "reductions, 2 roots"));
  EXPECT_TRUE(has(text_of(folder_ / "reports/boxes/counts.md"), "reductions"));
}

}  // namespace
}  // namespace gcslab
