// What a user does with constraint systems: figures given by their constraints, solved through their
// equations.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/gcslab_shell.h"

namespace gcslab {
namespace {

using Json = nlohmann::json;

class Geometry : public GcslabShell {
 protected:
  Json result() const { return Json::parse(text_of(folder_ / "r.json"), nullptr, false); }

  void triangle(const std::string& valuations, const std::string& more = "", const std::string& sketch = "") {
    write("t.yaml",
          "kind: constraint_system\nname: triangle\nuniverse: 2d\npoints: [A, B, C]\nconstraints:\n"
          "  - {distance: [A, B], parameter: c}\n  - {distance: [B, C], parameter: a}\n"
          "  - {distance: [C, A], parameter: b}\n" +
              more + "valuations: {" + valuations + "}\n" + sketch + "origin: test\nlicence: none\n");
  }
};

TEST_F(Geometry, TriangleHasOneFigureUpToIsometry) {
  triangle("right: {a: 3, b: 4, c: 5}, impossible: {a: 1, b: 1, c: 3}");
  const Answer answer = shell("$gcslab solve t.yaml --method adaptive --json r.json --proof r.proof");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  const Json found = result();
  EXPECT_EQ(found["status"], "complete");
  ASSERT_EQ(found["solutions"].size(), 4u);  // signs of B_x and C_y
  ASSERT_EQ(found["classes"].size(), 1u);
  EXPECT_EQ(found["classes"][0].size(), 4u);
  ASSERT_EQ(found["figures"].size(), 4u);
  EXPECT_EQ(found["figures"][0]["A"], Json::array({0.0, 0.0}));
  EXPECT_NEAR(std::abs(found["figures"][0]["C"][1].get<double>()), 2.4, 1e-12);
  EXPECT_EQ(shell("$gcslab verify r.json --proof r.proof").exit_code, 0);
  ASSERT_EQ(
      shell("$gcslab solve t.yaml --method adaptive --set valuation=impossible --json r.json").exit_code, 0);
  EXPECT_EQ(result()["status"], "complete");
  EXPECT_TRUE(result()["solutions"].empty());
  EXPECT_EQ(shell("$gcslab verify r.json").exit_code, 0);  // of the valuation that the result names
}

TEST_F(Geometry, OctahedronAndPentahedronHaveThePublishedFigures) {
  for (const auto& [problem, solutions, classes] :
       {std::tuple("polyhedra/octahedron", 32u, 4u),
        {"polyhedra/pentahedron", 48u, 9u},
        {"polyhedra/pentahedron --set valuation=table_4_1", 48u, 7u}}) {
    const Answer answer =
        shell(std::string("$gcslab solve --method adaptive --json r.json --proof r.proof ") + problem);
    ASSERT_EQ(answer.exit_code, 0) << answer.err;
    EXPECT_EQ(result()["status"], "complete") << problem;
    EXPECT_EQ(result()["solutions"].size(), solutions) << problem;
    EXPECT_EQ(result()["classes"].size(), classes) << problem;
  }
}

/// The counts that their files derive by hand, of solutions in the frame and of figures.
TEST_F(Geometry, FiguresOfLinesPlanesCirclesAndSpheresAreAllFoundAndProved) {
  for (const auto& [problem, solutions, classes] :
       {std::tuple("sketches/line-at-distances", 16u, 2u),
        {"sketches/line-at-distances --set valuation=crossing", 8u, 1u},
        {"sketches/line-at-distances --set valuation=within", 0u, 0u},
        {"sketches/circle-touching-line-and-circle", 32u, 4u},
        {"sketches/circle-touching-line-and-circle --set valuation=eight", 64u, 8u},
        {"sketches/apollonius", 32u, 8u},
        {"sketches/circles-of-a-triangle", 128u, 4u},
        {"sketches/plane-touching-spheres", 64u, 4u},
        {"sketches/lines-touching-four-spheres", 192u, 12u}}) {
    const std::string named = problem;
    const Answer answer = shell("$gcslab solve --method adaptive --json r.json --proof r.proof " + named);
    ASSERT_EQ(answer.exit_code, 0) << answer.err;
    EXPECT_EQ(result()["status"], "complete") << problem;
    EXPECT_EQ(result()["solutions"].size(), solutions) << problem;
    EXPECT_EQ(result()["classes"].size(), classes) << problem;
    const bool is_quick = solutions < 100;  // to prove again
    EXPECT_EQ(shell(is_quick ? "$gcslab verify r.json --proof r.proof" : "$gcslab verify r.json").exit_code,
              0)
        << problem;
  }
}

/// A path finds some of them, each a solution that `verify` accepts, with no negative radius.
TEST_F(Geometry, SketchesOfLinesPlanesCirclesAndSpheresCarrySomeFigures) {
  for (const auto& [problem, classes] : {std::tuple("sketches/line-at-distances", 2u),
                                         {"sketches/circle-touching-line-and-circle", 4u},
                                         {"sketches/plane-touching-spheres", 4u},
                                         {"sketches/lines-touching-four-spheres", 12u}}) {
    shell(std::string("$gcslab solve --json r.json ") + problem);
    const Json found = result();
    EXPECT_EQ(found["method"]["name"], "sketch_path");
    EXPECT_GE(found["classes"].size(), 1u) << problem;
    EXPECT_LE(found["classes"].size(), classes) << problem;
    for (const Json& solution : found["solutions"]) EXPECT_EQ(solution["certificate"]["claim"], "unique");
    for (const Json& figure : found["figures"]) {
      if (!figure.contains("x")) continue;
      EXPECT_NEAR(figure["x"][2].get<double>(), 2, 1e-12);  // the radius that is wanted
    }
    EXPECT_EQ(shell("$gcslab verify r.json").exit_code, 0) << problem;
  }
}

TEST_F(Geometry, SketchOfTheOctahedronCarriesItsFigures) {
  const Answer answer = shell("$gcslab solve polyhedra/octahedron --json r.json");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  const Json found = result();
  EXPECT_EQ(found["method"]["name"], "sketch_path");
  EXPECT_EQ(found["status"], "partial");
  EXPECT_EQ(found["completeness"], "none");
  EXPECT_EQ(found["classes"].size(), 4u);
  for (const Json& solution : found["solutions"]) EXPECT_EQ(solution["certificate"]["claim"], "unique");
  ASSERT_EQ(found["paths"].size(), 1u);
  EXPECT_EQ(found["paths"][0]["type"], "cycle");
  EXPECT_EQ(found["paths"][0]["crossings"].size(), 4u);
  EXPECT_EQ(shell("$gcslab verify r.json").exit_code, 0);
  const Answer proof = shell("$gcslab solve polyhedra/octahedron --proof o.proof");
  EXPECT_EQ(proof.exit_code, 2);
  EXPECT_TRUE(has(proof.err, "follows a path")) << proof.err;
  triangle("right: {a: 3, b: 4, c: 5}");
  const Answer none = shell("$gcslab solve t.yaml");
  EXPECT_EQ(none.exit_code, 4);
  EXPECT_TRUE(has(none.err, "sketch")) << none.err;
  triangle("right: {a: 3, b: 4, c: 5}", "", "sketch: {A: [0, 0], B: [1, 0], C: [0, 1]}\n");
  ASSERT_EQ(shell("$gcslab solve t.yaml --json r.json").exit_code, 0);
  EXPECT_EQ(result()["classes"].size(), 1u);
  triangle("right: {a: 3, b: 4, c: 5}", "", "sketch: {A: [0, 0], B: [0, 0], C: [0, 1]}\n");
  const Answer together = shell("$gcslab solve t.yaml");
  EXPECT_EQ(together.exit_code, 2);
  EXPECT_TRUE(has(together.err, "one place")) << together.err;
  EXPECT_EQ(shell("$gcslab solve polyhedra/octahedron-equations --method sketch_path").exit_code, 4);
}

TEST_F(Geometry, OtherFormatsGetItsEquations) {
  const Answer phc = shell("$gcslab export polyhedra/octahedron --to phc --out o.phc");
  ASSERT_EQ(phc.exit_code, 0) << phc.err;
  EXPECT_TRUE(has(text_of(folder_ / "o.phc"), "P5_z"));
  const Answer table = shell("$gcslab export polyhedra/pentahedron --valuation table_4_1 --to minibex");
  EXPECT_EQ(table.exit_code, 0) << table.err;
  const Answer wrong = shell("$gcslab export polyhedra/pentahedron --valuation tabel --to minibex");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_TRUE(has(wrong.err, "tabel")) << wrong.err;
}

TEST_F(Geometry, SaysWhatIsWrong) {
  triangle("right: {a: 3, b: 4, c: -5}");
  const Answer negative = shell("$gcslab solve t.yaml --method adaptive");
  EXPECT_EQ(negative.exit_code, 2);
  EXPECT_TRUE(has(negative.err, "constraint 1, distance A B")) << negative.err;
  triangle("right: {a: 3, b: 4, c: 5}", "  - {equal_lengths: [A, B, C, C]}\n");
  const Answer twice = shell("$gcslab solve t.yaml --method adaptive");
  EXPECT_EQ(twice.exit_code, 2);
  EXPECT_TRUE(has(twice.err, "'C' twice")) << twice.err;
  triangle("equal: {a: 3, b: 4, c: 3}", "  - {equal_lengths: [A, B, B, C]}\n");
  EXPECT_EQ(shell("$gcslab solve t.yaml --method adaptive").exit_code, 0);
  triangle("right: {a: 3, b: 4, c: 5, s: 6}", "  - {area: [A, B, C], parameter: s}\n");
  const Answer over = shell("$gcslab solve t.yaml --method adaptive");
  EXPECT_EQ(over.exit_code, 0);
  EXPECT_TRUE(has(over.err, "over-constrained by 1; over-constrained: constraint 1, distance A B"))
      << over.err;
  triangle("right: {a: 3, b: 4, c: 5}", "", "box: {C_x: [0, 10], C_y: [0, inf]}\n");
  ASSERT_EQ(shell("$gcslab solve t.yaml --method adaptive --json r.json").exit_code, 0);
  EXPECT_EQ(result()["solutions"].size(), 1u);  // of the four
  for (const auto& [box, word] : {std::pair("{D_x: [0, 1]}", "D_x"), {"{C_x: [9, 10]}", "leaves nothing"}}) {
    triangle("right: {a: 3, b: 4, c: 5}", "", std::string("box: ") + box + "\n");
    const Answer elsewhere = shell("$gcslab solve t.yaml --method adaptive");
    EXPECT_EQ(elsewhere.exit_code, 2);
    EXPECT_TRUE(has(elsewhere.err, "t.yaml:10") && has(elsewhere.err, word)) << elsewhere.err;
  }
  const Answer none = shell("$gcslab solve polyhedra/octahedron-equations --set valuation=x");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_TRUE(has(none.err, "has no valuations")) << none.err;
  EXPECT_EQ(shell("$gcslab validate " GCSLAB_SOURCE_DIR "/data/polyhedra/pentahedron.yaml").exit_code, 0);
}

TEST_F(Geometry, FiguresAreDrawn) {
  ASSERT_EQ(shell("$gcslab solve polyhedra/octahedron --figure o.svg").exit_code, 0);
  const std::string octahedron = text_of(folder_ / "o.svg");
  for (const char* text : {">P5<", ">1 solution<", "octahedron, sketch_path"})
    EXPECT_TRUE(has(octahedron, text)) << text;
  triangle("right: {a: 3, b: 4, c: 5}, impossible: {a: 1, b: 1, c: 3}");
  ASSERT_EQ(shell("$gcslab solve t.yaml --method adaptive --figure t.svg").exit_code, 0);
  for (const char* text : {">A<", ">c = 5<", ">4 solutions<"})
    EXPECT_TRUE(has(text_of(folder_ / "t.svg"), text)) << text;
  ASSERT_EQ(
      shell("$gcslab solve t.yaml --method adaptive --set valuation=impossible --figure t.svg").exit_code, 0);
  EXPECT_TRUE(has(text_of(folder_ / "t.svg"), ">no figure was found<"));
  ASSERT_EQ(
      shell("$gcslab solve t.yaml --method adaptive --figure t.svg --figure-variables C_x,C_y").exit_code, 0);
  EXPECT_TRUE(has(text_of(folder_ / "t.svg"), ">C_y<"));  // the boxes of the search
}

TEST_F(Geometry, IsDescribed) {
  const Answer answer = shell("$gcslab describe polyhedra/pentahedron");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  for (const char* text :
       {"coplanar P0 P3 P4 P5", "table_4_1", "11 unknowns, 11 equations: well-constrained"})
    EXPECT_TRUE(has(answer.out, text)) << text << "\n" << answer.out;
  const Answer spheres = shell("$gcslab describe sketches/plane-touching-spheres");
  for (const char* text : {"planes: p", "spheres: u, v, w", "tangent p u",
                           "no part is over- or under-constrained", "rank 19 of 19 equations in 19 unknowns"})
    EXPECT_TRUE(has(spheres.out, text)) << text << "\n" << spheres.out;
  EXPECT_TRUE(has(shell("$gcslab list problems --kind constraint_system").out, "polyhedra/octahedron"));
}

TEST_F(Geometry, LargeMembersOfFamiliesAreSolvedToCertifiedFigures) {
  for (const auto& [problem, unknowns] : {std::pair("polygon-33", 63u),
                                          {"triangulated-polyhedron-24", 66u},
                                          {"prism-13 --set booleans=kept", 62u},
                                          {"triangulated-polyhedron-102", 300u}}) {
    const Answer answer = shell(std::string("$gcslab solve --method sketch_first_crossing --json r.json "
                                            "figure_families/") +
                                problem);
    ASSERT_EQ(answer.exit_code, 0) << problem << answer.err;
    const Json found = result();
    EXPECT_EQ(found["variables"].size(), unknowns) << problem;
    ASSERT_EQ(found["solutions"].size(), 1u) << problem;
    EXPECT_EQ(found["solutions"][0]["certificate"]["claim"], "unique") << problem;
  }
}

TEST_F(Geometry, GeneratedFigureThatSaysTooMuchIsRefused) {
  const auto refusal = [&](const std::string& generator, const std::string& more = "") {
    write("g.yaml", "kind: constraint_system\nname: g\ngenerator: {" + generator + "}\n" + more +
                        "origin: test\nlicence: none\n");
    const Answer answer = shell("$gcslab validate g.yaml");
    EXPECT_NE(answer.exit_code, 0) << generator << more;
    return answer.out + answer.err;
  };
  const std::string good = "name: polygon, vertices: 7, seed: 1, perturbation: 0.05";
  EXPECT_TRUE(has(refusal(good, "points: [A]\n"), "'points'"));
  EXPECT_TRUE(has(refusal("name: polygom, vertices: 7, seed: 1, perturbation: 0.05"), "polygon"));
  EXPECT_TRUE(has(refusal("name: prism, vertices: 7, seed: 1, perturbation: 0.05"), "vertices"));
  EXPECT_TRUE(has(refusal("name: polygon, vertices: 2, seed: 1, perturbation: 0.05"), "[3, 200]"));
  EXPECT_TRUE(has(refusal("name: polygon, vertices: 7, seed: 1, perturbation: 0.5"), "(0, 0.2]"));
}

}  // namespace
}  // namespace gcslab
