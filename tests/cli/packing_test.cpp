// What a user does with circle packings: generated problems, the method angle_sum, verify.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/gcslab_shell.h"

namespace gcslab {
namespace {

using Json = nlohmann::json;

class Packing : public GcslabShell {};

TEST_F(Packing, OfSixtyUnknownsIsProvedTheOnlyOneAndVerifyAgrees) {
  const Answer answer =
      shell("$gcslab solve packings/random-60 --method angle_sum --json r.json --proof r.proof");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_TRUE(has(answer.out, "1 solution, 0 undecided boxes, complete, completeness proved")) << answer.out;
  const Json result = Json::parse(text_of(folder_ / "r.json"), nullptr, false);
  ASSERT_EQ(result["solutions"].size(), 1u);
  EXPECT_EQ(result["solutions"][0]["inequalities"], "proved");
  EXPECT_EQ(result["solutions"][0]["certificate"]["evidence"][0]["type"], "angle_sum");
  const Answer accepted = shell("$gcslab verify r.json --proof r.proof");
  EXPECT_EQ(accepted.exit_code, 0) << accepted.err;
  EXPECT_TRUE(has(accepted.out, "nothing is missing")) << accepted.out;
  const Answer otherwise =
      shell("$gcslab verify r.json --proof r.proof --problem packings/icosahedron-graph");
  EXPECT_EQ(otherwise.exit_code, 1) << otherwise.out;
}

TEST_F(Packing, IsFoundBySearchAndByAngleSumsAlike) {
  for (const char* method : {"adaptive", "angle_sum"}) {
    const Answer answer = shell("$gcslab solve packings/random-9 --json - --method " + std::string(method));
    ASSERT_EQ(answer.exit_code, 0) << answer.err;
    const Json result = Json::parse(answer.out, nullptr, false);
    EXPECT_EQ(result["status"], "complete") << method;
    EXPECT_EQ(result["solutions"].size(), 1u) << method;
  }
}

TEST_F(Packing, WithoutInequalitiesLeavesTheBoxUndecided) {
  const Answer answer = shell(
      "$gcslab solve packings/octahedron-graph-equations --method angle_sum --json r.json --proof r.proof");
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_TRUE(has(answer.out, "no inequality keeps discs")) << answer.out;
  EXPECT_EQ(shell("$gcslab verify r.json --proof r.proof").exit_code, 0);
}

TEST_F(Packing, MethodTakesNothingElseAndSaysWhy) {
  const Answer answer = shell("$gcslab solve separation/circle-parabola --method angle_sum");
  EXPECT_EQ(answer.exit_code, 4);
  EXPECT_TRUE(has(answer.err, "no circle packing")) << answer.err;
}

TEST_F(Packing, GeneratorSaysWhatIsWrongWithAFile) {
  const auto problem = [this](const std::string& generator, const std::string& more = "") {
    write("p.yaml",
          "kind: system\nname: p\n" + more + "generator: {" + generator + "}\norigin: test\nlicence: none\n");
    return shell("$gcslab solve p.yaml --method angle_sum");
  };
  const std::string good = "name: circle_packing, inner_discs: 4, flips: 10, seed: 1, least_radius: 0.001";
  EXPECT_EQ(problem(good).exit_code, 0);
  const Answer boxed = problem(good, "box: {x3: [0, 1]}\n");
  EXPECT_EQ(boxed.exit_code, 2);
  EXPECT_TRUE(has(boxed.err, "leave it out")) << boxed.err;
  const Answer misspelt = problem("name: circle_paking, inner_discs: 4");
  EXPECT_EQ(misspelt.exit_code, 2);
  EXPECT_TRUE(has(misspelt.err, "did you mean 'circle_packing'")) << misspelt.err;
  const Answer large = problem("name: circle_packing, inner_discs: 4, flips: 10, seed: 1, least_radius: 1");
  EXPECT_EQ(large.exit_code, 2);
  EXPECT_TRUE(has(large.err, "p.yaml:3")) << large.err;
  EXPECT_EQ(problem("name: circle_packing, inner_discs: -1, flips: 10, seed: 1, least_radius: 0.1").exit_code,
            2);
}

}  // namespace
}  // namespace gcslab
