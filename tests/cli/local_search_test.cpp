// What a user sees of the methods that go from the sketch to one solution.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/gcslab_shell.h"

namespace gcslab {
namespace {

using Json = nlohmann::json;

constexpr auto kMethods = {"newton_from_sketch", "levenberg_marquardt_from_sketch", "bfgs_from_sketch"};

class LocalSearchMethods : public GcslabShell {
 protected:
  Json result() const { return Json::parse(text_of(folder_ / "r.json"), nullptr, false); }

  Answer solve(const std::string& problem, const std::string& method, const std::string& more = "") {
    return shell("$gcslab solve " + problem + " --method " + method + " --json r.json " + more);
  }

  void triangle(const std::string& valuation, const std::string& sketch, const std::string& more = "") {
    write("t.yaml",
          "kind: constraint_system\nname: triangle\nuniverse: 2d\npoints: [A, B, C]\nconstraints:\n"
          "  - {distance: [A, B], parameter: c}\n  - {distance: [B, C], parameter: a}\n"
          "  - {distance: [C, A], parameter: b}\n" +
              more + "valuations: {wanted: {" + valuation + "}}\nsketch: {" + sketch +
              "}\norigin: test\nlicence: none\n");
  }
};

TEST_F(LocalSearchMethods, FindOneCertifiedFigureOfTheOctahedron) {
  for (const std::string method : kMethods) {
    const Answer answer = solve("polyhedra/octahedron", method);
    ASSERT_EQ(answer.exit_code, 0) << method << answer.err;
    const Json found = result();
    EXPECT_EQ(found["status"], "partial") << method;
    EXPECT_EQ(found["completeness"], "none") << method;
    ASSERT_EQ(found["solutions"].size(), 1U) << method;
    EXPECT_EQ(found["solutions"][0]["certificate"]["claim"], "unique") << method;
    EXPECT_EQ(found["figures"].size(), 1U) << method;
    EXPECT_GT(found["statistics"]["steps"].get<int>(), 0) << method;
    EXPECT_FALSE(found.contains("reason")) << method;
    EXPECT_EQ(shell("$gcslab verify r.json").exit_code, 0) << method;
  }
}

TEST_F(LocalSearchMethods, SayHowASearchWithoutSolutionEnds) {
  triangle("a: 1, b: 1, c: 3", "A: [0, 0], B: [2, 0], C: [0.9, 0.7]");
  for (const std::string method : kMethods) {
    const Answer answer = solve("t.yaml", method);
    ASSERT_EQ(answer.exit_code, 0) << method << answer.err;
    const Json found = result();
    EXPECT_EQ(found["status"], "partial") << method;
    EXPECT_TRUE(found["solutions"].empty()) << method;
    const std::string reason = found["reason"];
    EXPECT_TRUE(has(reason, "iterations") && has(reason, "residual")) << reason;
    EXPECT_TRUE(has(answer.err, reason)) << answer.err;
    EXPECT_EQ(has(reason, "stationary point of the sum of squares that is no root"),
              method != "newton_from_sketch")
        << reason;
  }
  triangle("a: 3, b: 4, c: 5", "A: [0, 0], B: [4, 0], C: [3, 2]");
  ASSERT_EQ(solve("t.yaml", "newton_from_sketch", "--box C_y=[-3,0]").exit_code, 0);
  EXPECT_TRUE(has(result()["reason"], "outside of the box")) << result()["reason"];
  ASSERT_EQ(solve("polyhedra/octahedron", "newton_from_sketch", "--set maximum_iterations=1").exit_code, 0);
  EXPECT_TRUE(has(result()["reason"], "after 1 iteration without convergence")) << result()["reason"];
}

TEST_F(LocalSearchMethods, NewtonSaysThatASketchIsSingular) {
  triangle("a: 3, b: 4, c: 5", "A: [0, 0], B: [1, 0], C: [2, 0]");
  ASSERT_EQ(solve("t.yaml", "newton_from_sketch").exit_code, 0);
  EXPECT_TRUE(result()["solutions"].empty());
  EXPECT_TRUE(has(result()["reason"], "after 0 iterations where the Jacobian is singular"))
      << result()["reason"];
}

TEST_F(LocalSearchMethods, ListASingularSolutionWithoutCertificate) {
  triangle("a: 1, b: 2, c: 3", "A: [0, 0], B: [2.9, 0], C: [2.1, 0.5]");  // flat: C_y is a double root
  ASSERT_EQ(solve("t.yaml", "newton_from_sketch").exit_code, 0);
  ASSERT_EQ(result()["solutions"].size(), 1U) << result();
  EXPECT_EQ(result()["solutions"][0]["certificate"]["claim"], "none");
  EXPECT_NEAR(result()["figures"][0]["C"][1].get<double>(), 0, 1e-4);
}

TEST_F(LocalSearchMethods, LeastSquaresTakeConstraintsThatAreNotIndependent) {
  triangle("a: 3, b: 4, c: 5, s: 6", "A: [0, 0], B: [4, 0], C: [3, 2]",
           "  - {area: [A, B, C], parameter: s}\n");
  EXPECT_EQ(solve("t.yaml", "newton_from_sketch").exit_code, 4);
  for (const std::string method : {"levenberg_marquardt_from_sketch", "bfgs_from_sketch"}) {
    ASSERT_EQ(solve("t.yaml", method).exit_code, 0) << method;
    ASSERT_EQ(result()["solutions"].size(), 1U) << method;
    EXPECT_EQ(result()["solutions"][0]["certificate"]["claim"], "none") << method;
    EXPECT_NEAR(result()["figures"][0]["C"][1].get<double>(), 2.4, 1e-6) << method;
  }
}

TEST_F(LocalSearchMethods, AreListedDescribedAndRefuseWhatTheyCannotDo) {
  const std::string list = shell("$gcslab list methods --kind solve").out;
  for (const std::string method : kMethods) {
    EXPECT_TRUE(has(list, method));
    const std::string description = shell("$gcslab describe " + method).out;
    EXPECT_TRUE(has(description, "maximum_iterations")) << description;
    EXPECT_TRUE(has(description, "tolerance")) << description;
    EXPECT_EQ(has(description, "damping"), method == "newton_from_sketch") << description;
    EXPECT_EQ(solve("polyhedra/octahedron-equations", method).exit_code, 4);
    const Answer proof = solve("polyhedra/octahedron", method, "--proof o.proof");
    EXPECT_EQ(proof.exit_code, 2);
    EXPECT_TRUE(has(proof.err, "goes from the sketch to one solution")) << proof.err;
  }
}

}  // namespace
}  // namespace gcslab
