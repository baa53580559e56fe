// The theorem that no solution is missing where planes and spheres meet, on a triangle of sides 3, 4, 5 and
// on what spoils its proof.

#include <gtest/gtest.h>

#include "unit/verifier/hand_written_proof.h"

namespace gcslab {
namespace {

Box around(const std::vector<double>& point, double radius) {
  Box box;
  for (const double x : point) box.emplace_back(x - radius, x + radius);
  return box;
}

/// B = (b, 0) at distance 5 of the origin, and C = (x, y) at 4 of it and 3 of B.
HandWritten triangle(const std::vector<std::string>& equations = {"b^2 - 25", "x^2 + y^2 = sqrt(256)",
                                                                  "(x - b)^2 + y^2 - 9"}) {
  const Box search_box = around({0, 0, 0}, 10);
  HandWritten proof{system_of({"b", "x", "y"}, equations, search_box), {}, {}};
  Json solutions = Json::array();
  for (const double side : {1.0, -1.0}) {
    for (const double up : {1.0, -1.0}) {
      const std::vector<double> point = {5 * side, 3.2 * side, 2.4 * up};
      solutions.push_back(solution_of(around(point, 1e-9), around(point, 1e-3)));
    }
  }
  proof.result = result_of(proof.system, solutions);
  std::string box = "box";
  for (const Interval& side : search_box) box += " " + bounds(side.lower, side.upper);
  proof.lines = {"gcslab-proof 1", box, "theorem loci_intersection 1 0 0 2 1 2 1 2", "end"};
  return proof;
}

TEST(LociTheorem, ShowsThatNothingIsMissing) { EXPECT_TRUE(triangle().proves_completeness()); }

TEST(LociTheorem, IsRefusedWhenItsHypothesesFail) {
  const Spoiled spoiled[] = {
      {"a solution is left out", 3, [](HandWritten& p) { p.result["solutions"].erase(2); }},
      {"a variable is in no block", 3,
       [](HandWritten& p) { replace(p, 3, "theorem loci_intersection 1 0 0"); }},
      {"a variable is in two blocks", 3,
       [](HandWritten& p) { replace(p, 3, "theorem loci_intersection 1 0 0 1 0 0 2 1 2 1 2"); }},
      {"a variable is twice in its block", 3,
       [](HandWritten& p) { replace(p, 3, "theorem loci_intersection 1 0 0 2 1 1 1 2 1 2 1"); }},
      {"the block of B comes last", 3,
       [](HandWritten& p) { replace(p, 3, "theorem loci_intersection 2 1 2 1 2 1 0 0"); }},
      {"an equation says nothing more", 3,
       [](HandWritten& p) { replace(p, 3, "theorem loci_intersection 1 0 0 2 1 2 1 1"); }},
      {"there is no such equation", 3,
       [](HandWritten& p) { replace(p, 3, "theorem loci_intersection 1 0 0 2 1 2 1 3"); }},
      {"the line ends too soon", 3,
       [](HandWritten& p) { replace(p, 3, "theorem loci_intersection 1 0 0 2 1 2 1"); }},
      {"a number too many", 3,
       [](HandWritten& p) { replace(p, 3, "theorem loci_intersection 1 0 0 2 1 2 1 2 0"); }},
  };
  for (const Spoiled& of : spoiled) {
    HandWritten proof = triangle();
    of.spoil(proof);
    EXPECT_EQ(proof.refused_line(), of.refused_line) << of.what;
    EXPECT_FALSE(proof.proves_completeness()) << of.what;
  }
}

TEST(LociTheorem, TakesNoOtherSurfaces) {
  for (const char* equation : {"x^2 + 2 * y^2 = 16 + 2.4^2", "x^2 + y^2 + x * y = 16 + 3.2 * 2.4",
                               "x^3 = 3.2^3", "b * (x^2 + y^2) = 16 * b", "abs(x) = 3.2"}) {
    HandWritten proof = triangle({"b^2 - 25", equation, "(x - b)^2 + y^2 - 9"});
    EXPECT_EQ(proof.refused_line(), 3) << equation;
  }
}

TEST(LociTheorem, TakesTouchingLociForUndecided) {
  HandWritten proof = triangle({"b^2 - 25", "x^2 + y^2 - 4", "(x - b)^2 + y^2 - 9"});
  proof.result["solutions"].clear();
  EXPECT_EQ(proof.refused_line(), 3);
  for (const double side : {1.0, -1.0})
    proof.result["undecided"].push_back(
        {{"box", box_json(around({5 * side, 2 * side, 0}, 1e-9))}, {"reason", "touching"}});
  proof.result["status"] = "partial";
  EXPECT_TRUE(proof.proves_completeness());
}

TEST(LociTheorem, ProvesThatConcentricCirclesAreApart) {
  HandWritten proof = triangle({"b^2", "x^2 + y^2 - 4", "(x - b)^2 + y^2 - 9"});
  proof.result["solutions"].clear();
  EXPECT_TRUE(proof.proves_completeness());
  // One circle: its points are neither listed nor undecided.
  HandWritten same = triangle({"b^2", "x^2 + y^2 - 4", "(x - b)^2 + y^2 - 4"});
  same.result["solutions"].clear();
  EXPECT_EQ(same.refused_line(), 3);
}

TEST(LociTheorem, TakesPlanesAlone) {
  // x = b + 1, y = x - b: (6, 1) and (-4, 1).
  HandWritten proof = triangle({"b^2 - 25", "x - b = 1", "y - x + b"});
  proof.result["solutions"] = Json::array({solution_of(around({5, 6, 1}, 1e-9), around({5, 6, 1}, 1e-3))});
  EXPECT_EQ(proof.refused_line(), 3);
  proof.result["solutions"].push_back(solution_of(around({-5, -4, 1}, 1e-9), around({-5, -4, 1}, 1e-3)));
  EXPECT_TRUE(proof.proves_completeness());
  HandWritten parallel = triangle({"b^2 - 25", "x - y = 1", "2 * x - 2 * y = 2"});
  parallel.result["solutions"].clear();
  EXPECT_EQ(parallel.refused_line(), 3);
}

}  // namespace
}  // namespace gcslab
