// What a user asks of one polynomial in one variable, and of pictures of surfaces.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/gcslab_shell.h"

namespace gcslab {
namespace {

using Json = nlohmann::json;

class Univariate : public GcslabShell {
 protected:
  void problem(const std::string& name, const std::string& variables, const std::string& equations,
               const std::string& box, const std::string& more = "") const {
    write(name, "kind: system\nname: test\nvariables: [" + variables + "]\nequations: [" + equations +
                    "]\nbox: {" + box + "}\n" + more + "origin: test\nlicence: none\n");
  }
  Answer solved(const std::string& options) const {
    return shell("$gcslab solve p.yaml --method univariate_bernstein --json r.json " + options);
  }
  Json result() const { return Json::parse(text_of(folder_ / "r.json"), nullptr, false); }
};

TEST_F(Univariate, MultipleRootsAreSolutionsThatVerifyCounts) {
  problem("p.yaml", "x", "\"(x - 1/3)^3*(x^2 - 2)*(x + 1)^2\"", "x: [-inf, inf]");
  const Answer answer = solved("");
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_TRUE(has(answer.out, "4 solutions, 0 undecided boxes, complete, completeness proved")) << answer.out;
  ASSERT_EQ(result()["solutions"].size(), 4u);
  EXPECT_EQ(result()["solutions"][1]["multiplicity"], 2);
  EXPECT_EQ(result()["solutions"][2]["multiplicity"], 3);
  const Answer verified = shell("$gcslab verify r.json");
  EXPECT_EQ(verified.exit_code, 0) << verified.err;
  EXPECT_TRUE(has(verified.out, "nothing is missing")) << verified.out;
  const Answer edited =
      shell("sed 's/\"multiplicity\": 3/\"multiplicity\": 1/' r.json > e.json && $gcslab verify e.json");
  EXPECT_EQ(edited.exit_code, 1);
  EXPECT_TRUE(has(edited.err, "/solutions/2/multiplicity")) << edited.err;
}

TEST_F(Univariate, AProofFileCoversRootsThatInequalitiesExclude) {
  problem("p.yaml", "x", "\"x*(x - 1)^2*(x - 3)\"", "x: [-5, 5]", "inequalities: [\"x <= 2\"]\n");
  EXPECT_EQ(solved("--proof r.proof").exit_code, 0);
  EXPECT_EQ(result()["solutions"].size(), 2u);
  const Answer verified = shell("$gcslab verify r.json --proof r.proof");
  EXPECT_EQ(verified.exit_code, 0) << verified.err;
  EXPECT_TRUE(has(verified.out, "nothing is missing")) << verified.out;
}

TEST_F(Univariate, MultipleRootsAreRefinedToTheDigitsAskedFor) {
  problem("p.yaml", "x", "\"(x^2 - 2)^2\"", "x: [0, 2]");
  EXPECT_EQ(solved("--precision 200").exit_code, 0);
  const Json solution = result()["solutions"][0];
  EXPECT_TRUE(solution["refined_reached"]);
  EXPECT_TRUE(has(solution["decimal"][0], "1.41421356237309504880168872420969807856967187537694"))
      << solution;
}

TEST_F(Univariate, SaysWhyAnotherProblemIsNotOfItsKind) {
  problem("p.yaml", "x, y", "\"x + y\", \"x - y\"", "x: [0, 1], y: [0, 1]");
  const Answer two = solved("");
  EXPECT_EQ(two.exit_code, 4);
  EXPECT_TRUE(has(two.err, "one equation in one variable")) << two.err;
  problem("p.yaml", "x", "\"sin(x)\"", "x: [0, 1]");
  const Answer sine = solved("");
  EXPECT_EQ(sine.exit_code, 4);
  EXPECT_TRUE(has(sine.err, "sin")) << sine.err;
}

TEST_F(Univariate, TheEquationZeroIsUndecided) {
  problem("p.yaml", "x", "\"(x + 1)^2 = x^2 + 2*x + 1\"", "x: [0, 1]");
  EXPECT_EQ(solved("").exit_code, 0);
  EXPECT_EQ(result()["status"], "partial");
  EXPECT_EQ(result()["undecided"].size(), 1u);
}

TEST_F(Univariate, RaysMakeAPictureWhoseEveryPixelIsProved) {
  write("disc.yaml",
        "kind: surface\nname: disc\nvariables: [x, y, z]\nequations: [\"x^2 + y^2 + 40000*z^2 - 1\"]\n"
        "box: {x: [-2, 2], y: [-2, 2], z: [-2, 2]}\norigin: test\nlicence: none\n");
  write("rays.yaml",
        "experiment: rays\ntask: ray_cast\nproblems: [disc.yaml]\n"
        "methods: [{name: first_root}, {name: marching, options: {steps: 20}}]\nparameters: {pixels: 24}\n"
        "report:\n  - figure: {file: disc, kind: ray_panels}\n"
        "  - table: {file: rays, rows: problem, columns: method, values: [hits, missed]}\n");
  EXPECT_EQ(shell("$gcslab run rays.yaml --out runs").exit_code, 0);
  const Answer report =
      shell("$gcslab report rays.yaml --runs runs --out reports --reference none --format md,svg");
  EXPECT_EQ(report.exit_code, 0) << report.err;
  const std::string script = text_of(folder_ / "reports/rays/disc.gp");
  EXPECT_TRUE(has(script, "with rgbimage")) << script;
  EXPECT_TRUE(has(script, "every ray proved")) << script;
  EXPECT_FALSE(has(script, " 0 missed")) << "the marching of 20 steps sees a disc of thickness 0.01";
}

}  // namespace
}  // namespace gcslab
