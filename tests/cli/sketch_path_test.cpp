// What a user does with the path of a sketch: stop and go on, ask for proof, draw badly.

#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/gcslab_shell.h"

namespace gcslab {
namespace {

using Json = nlohmann::json;

class SketchPaths : public GcslabShell {
 protected:
  Json result(const std::string& file = "r.json") const {
    return Json::parse(text_of(folder_ / file), nullptr, false);
  }

  /// Solves a triangle A B C in the plane with sides a = BC, b = CA, c = AB.
  Answer solve_triangle(const std::string& values, const std::string& sketch, const std::string& more = "") {
    write("t.yaml",
          "kind: constraint_system\nname: triangle\nuniverse: 2d\npoints: [A, B, C]\nconstraints:\n"
          "  - {distance: [A, B], parameter: c}\n  - {distance: [B, C], parameter: a}\n"
          "  - {distance: [C, A], parameter: b}\n" +
              more + "valuations: {wanted: {" + values + "}}\nsketch: " + sketch +
              "\norigin: test\nlicence: none\n");
    return shell("$gcslab solve t.yaml --json r.json");
  }
};

TEST_F(SketchPaths, StopAndGoOn) {
  ASSERT_EQ(shell("$gcslab solve polyhedra/icosahedron --json whole.json").exit_code, 0);
  const Answer stopped = shell(
      "$gcslab solve polyhedra/icosahedron --set maximum_steps=3000 --pending rest.json --json part.json");
  EXPECT_EQ(stopped.exit_code, 3) << stopped.err;
  ASSERT_EQ(shell("$gcslab solve polyhedra/icosahedron --resume rest.json --pending rest.json --json r.json")
                .exit_code,
            0);
  const Json whole = result("whole.json"), part = result("part.json"), resumed = result();
  EXPECT_EQ(part["status"], "budget_exhausted");
  EXPECT_LT(part["solutions"].size(), whole["solutions"].size());
  EXPECT_EQ(resumed["solutions"].size(), whole["solutions"].size());
  EXPECT_EQ(resumed["paths"][0]["type"], "cycle");
  EXPECT_GT(whole["solutions"].size(), 1000U);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "rest.json"));  // nothing is left
}

TEST_F(SketchPaths, GoOnWithTheSameProblemAndOptionsOnly) {
  ASSERT_EQ(
      shell("$gcslab solve polyhedra/icosahedron --set maximum_steps=500 --pending rest.json").exit_code, 3);
  for (const auto& [command, text] :
       {std::pair("solve polyhedra/octahedron --resume rest.json", "belongs to another problem"),
        {"solve polyhedra/icosahedron --set deviation=0.01 --resume rest.json",
         "was followed with other options"},
        {"solve polyhedra/icosahedron --method sketch_path_as_published --resume rest.json",
         "was followed with other options"},
        {"solve polyhedra/icosahedron --proof p --resume rest.json", "--proof: not with sketch_path"}}) {
    const Answer answer = shell(std::string("$gcslab ") + command);
    EXPECT_EQ(answer.exit_code, 2) << command;
    EXPECT_NE(answer.err.find(text), std::string::npos) << answer.err;
  }
  shell("sed -i 's/\"step\": [0-9.e-]*/\"step\": 0.25/' rest.json");
  const Answer changed = shell("$gcslab solve polyhedra/icosahedron --resume rest.json");
  EXPECT_EQ(changed.exit_code, 2);
  EXPECT_NE(changed.err.find("was changed after --pending wrote it"), std::string::npos) << changed.err;
}

TEST_F(SketchPaths, AreProvedByTubes) {
  ASSERT_EQ(
      shell("$gcslab solve polyhedra/octahedron --method certified_sketch_path --json r.json").exit_code, 0);
  const Json path = result()["paths"][0];
  EXPECT_EQ(path["type"], "cycle");
  EXPECT_EQ(path["return_proved"], true);
  EXPECT_EQ(path["unproved_steps"], 0);
  EXPECT_GT(path["tubes"], path["steps"]);
  EXPECT_EQ(shell("$gcslab verify r.json").exit_code, 0);
}

TEST_F(SketchPaths, OfTheHexahedronPassThroughFlatFigures) {
  const Answer answer = shell("$gcslab solve polyhedra/hexahedron --json r.json");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_NE(answer.out.find("singular, rank 16 of 17, others lie beside it"), std::string::npos);
  const Json found = result();
  ASSERT_FALSE(found["paths"][0]["critical"].empty());
  EXPECT_EQ(found["paths"][0]["critical"][0]["configuration"], "all points are coplanar");
  EXPECT_EQ(shell("$gcslab verify r.json").exit_code, 0);
}

/// Coplanarities name the plane of the top by three points; where these are on a line, they hold anyway.
TEST_F(SketchPaths, EndWhereConstraintsDependOnEachOther) {
  ASSERT_EQ(shell("$gcslab solve figure_families/prism-13 --set booleans=kept --json r.json").exit_code, 0);
  const Json path = result()["paths"][0];
  EXPECT_EQ(path["type"], "to_undefined");
  const std::string configuration = path["configuration"];
  EXPECT_NE(configuration.find("constraints depend on each other: P13, P17, P21 are collinear"),
            std::string::npos)
      << configuration;
}

TEST_F(SketchPaths, EndInANamedWayWhereNoFigureExists) {
  for (const char* seed : {"1", "2", "3"}) {
    const Answer answer =
        solve_triangle("a: 1, b: 1, c: 3", std::string("{random: ") + seed + "}");  // against the inequality
    ASSERT_EQ(answer.exit_code, 0) << answer.err;
    EXPECT_TRUE(result()["solutions"].empty());
    EXPECT_EQ(result()["paths"][0]["type"], "cycle");
  }
}

/// A flat triangle is a double root: the path touches t = 1; nearly flat ones are two that lie near.
TEST_F(SketchPaths, FindDoubleAndNearlyDoubleRoots) {
  ASSERT_EQ(solve_triangle("a: 1, b: 2, c: 3", "{random: 1}").exit_code, 0);
  ASSERT_EQ(result()["solutions"].size(), 1U);
  EXPECT_EQ(result()["solutions"][0]["certificate"]["claim"], "none");
  EXPECT_EQ(result()["solutions"][0]["jacobian_rank"], 2);
  EXPECT_EQ(result()["paths"][0]["crossings"][0]["touching"], true);
  ASSERT_EQ(solve_triangle("a: 2, b: 2, c: 3.999999999", "{random: 3}").exit_code, 0);
  ASSERT_EQ(result()["solutions"].size(), 2U);
  EXPECT_EQ(result()["solutions"][0]["certificate"]["claim"], "unique");
  ASSERT_EQ(solve_triangle("a: 2, b: 2, c: 4.000000001", "{random: 3}").exit_code, 0);
  EXPECT_TRUE(result()["solutions"].empty());
}

TEST_F(SketchPaths, TellAFigureThatMoves) {
  ASSERT_EQ(solve_triangle("a: 1, b: 1, c: 0", "{random: 1}").exit_code, 0);  // C moves around A = B
  const Json solutions = result()["solutions"];
  ASSERT_FALSE(solutions.empty());
  for (const Json& solution : solutions) {
    EXPECT_EQ(solution["certificate"]["claim"], "none");
    EXPECT_EQ(solution["on_continuum"], true);
  }
}

TEST_F(SketchPaths, DoNotDependOnTheUnitOfLength) {
  for (const char* power : {"e-12", "", "e9"}) {
    const std::string e = power;
    ASSERT_EQ(solve_triangle("a: 3" + e + ", b: 4" + e + ", c: 5" + e, "{random: 1}").exit_code, 0);
    EXPECT_EQ(result()["solutions"].size(), 2U) << power;
  }
  ASSERT_EQ(solve_triangle("a: 3e6, b: 4e6, c: 5e6", "{A: [0, 0], B: [1, 0], C: [0.3, 1]}").exit_code, 0);
  EXPECT_EQ(result()["solutions"].size(), 2U);  // a small sketch of a large figure
}

TEST_F(SketchPaths, BadSketchesAndConstraintsAreNamed) {
  const std::string good = "a: 3, b: 4, c: 5";
  const auto expect = [](const Answer& answer, int exit_code, const std::string& text) {
    EXPECT_EQ(answer.exit_code, exit_code) << answer.err;
    EXPECT_NE(answer.err.find(text), std::string::npos) << answer.err;
  };
  expect(solve_triangle(good, "{A: [0, 0], B: [0, 0], C: [1, 1]}"), 2,
         "points of the frame, A B, at one place");
  expect(solve_triangle(good, "{A: [0, 0], B: [1, 0], C: [1, 0]}"), 4, "the sketch is singular");
  expect(solve_triangle("a: 3, b: 4", "{random: 1}"), 2, "lacks the key 'c'");
  expect(solve_triangle("a: 3, b: 4, c: -5", "{random: 1}"), 2,
         "constraint 1, distance A B: c = -5 is impossible");
  expect(solve_triangle(good + ", d: 5", "{random: 1}", "  - {distance: [A, B], parameter: d}\n"), 4,
         "over-constrained: constraint 1, distance A B; constraint 4, distance A B");
  expect(solve_triangle(good, "{A: [0, 0], B: [1, 0]}"), 2, "C");
}

}  // namespace
}  // namespace gcslab
