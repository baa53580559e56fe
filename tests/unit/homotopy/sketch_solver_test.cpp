// Solutions on paths: certified where they are regular, told from continua, explained.

#include "homotopy/sketch_solver.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "homotopy/path_explanation.h"
#include "support/corpus_figure.h"

namespace gcslab {
namespace {

SketchSolutions solved(const CorpusFigure& figured, SketchHomotopy& homotopy,
                       const std::string& valuation = "") {
  const SystemFunctions functions(figured.equation_system(valuation));
  return solve_along_path(homotopy.curve(), homotopy.curve(), homotopy.start(), functions, {},
                          "krawczyk_slopes+kantorovich");
}

/// The hexahedron has flat figures, a one-dimensional family of them, where the path passes through it.
TEST(SketchSolver, TellsFiguresOnAContinuumFromIsolatedOnes) {
  const CorpusFigure hexahedron = corpus_figure("polyhedra/hexahedron");
  SketchHomotopy homotopy = hexahedron.homotopy(*sketch_of(hexahedron.system));
  SketchSolutions found = solved(hexahedron, homotopy);
  EXPECT_EQ(found.path.end, PathEnd::cycle);
  std::size_t flat = 0;
  for (const SketchSolution& solution : found.solutions) {
    double height = 0;
    const Figure figure = figure_at(hexahedron.equations, solution.unknowns);
    for (const auto& point : figure) height = std::max(height, std::abs(point[2]));
    const bool is_flat = height < 1e-6;
    EXPECT_EQ(solution.root.has_value(), !is_flat);
    EXPECT_EQ(solution.is_on_continuum, is_flat);
    EXPECT_EQ(solution.rank, homotopy.curve().size() - (is_flat ? 1 : 0));
    if (is_flat) ++flat;
  }
  EXPECT_GT(flat, 0U);
  EXPECT_GT(found.solutions.size(), flat);
  const PathExplanation explanation =
      explain(found.path, hexahedron.system, hexahedron.equations, homotopy.curve(), homotopy.extent());
  ASSERT_EQ(explanation.branch_points.size(), found.path.branch_points.size());
  ASSERT_FALSE(explanation.branch_points.empty());
  for (const std::string& text : explanation.branch_points) EXPECT_EQ(text, "all points are coplanar");
  for (const BranchPoint& point : found.path.branch_points) EXPECT_NEAR(point.v.back(), 1, 1e-9);
}

/// With coplanarities held all along, paths of the pentahedron pass through flat figures, where branches
/// cross.
TEST(SketchSolver, ExplainsBranchPointsOfKeptBooleans) {
  const CorpusFigure pentahedron = corpus_figure("polyhedra/pentahedron");
  std::size_t explained = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SketchHomotopy homotopy =
        pentahedron.homotopy(pentahedron.random_sketch(seed), {.booleans = Booleans::kept});
    Path path = follow_path(homotopy.curve(), homotopy.start(), {});
    EXPECT_EQ(path.end, PathEnd::cycle) << seed;
    const PathExplanation explanation =
        explain(path, pentahedron.system, pentahedron.equations, homotopy.curve(), homotopy.extent());
    for (const std::string& text : explanation.branch_points) {
      if (text.find("coplanar") != std::string::npos) ++explained;
    }
  }
  EXPECT_GT(explained, 0U);
}

TEST(SketchSolver, NamesTheThreeKindsOfPaths) {
  const CorpusFigure figured = corpus_figure("polyhedra/6p7d3a2c");
  for (const auto& [valuation, end, text] : {std::tuple("cycle", PathEnd::cycle, ""),
                                             {"to_infinity", PathEnd::to_infinity, "P3 goes to infinity"},
                                             {"to_undefined", PathEnd::to_undefined, "P2, P3 coincide"}}) {
    SketchHomotopy homotopy = figured.homotopy(*sketch_of(figured.system),
                                               {.interpolation = Interpolation::compact_support}, valuation);
    SketchSolutions found = solved(figured, homotopy, valuation);
    const PathExplanation explanation =
        explain(found.path, figured.system, figured.equations, homotopy.curve(), homotopy.extent());
    EXPECT_EQ(found.path.end, end) << valuation;
    EXPECT_EQ(found.path.other_end, end) << valuation;
    EXPECT_NE(explanation.end.find(text), std::string::npos) << explanation.end;
  }
}

TEST(SketchSolver, ReportsNoSolutionTwice) {
  for (const std::string name : {"polyhedra/octahedron", "polyhedra/pentahedron", "polyhedra/hexahedron",
                                 "molecules/disulfide-distances"}) {
    const CorpusFigure figured = corpus_figure(name);
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      SketchHomotopy homotopy = figured.homotopy(figured.random_sketch(seed));
      const SketchSolutions found = solved(figured, homotopy);
      ASSERT_EQ(found.solution_of_crossing.size(), found.path.crossings.size());
      for (std::size_t a = 0; a < found.solutions.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b)
          EXPECT_GT(distance(found.solutions[a].unknowns, found.solutions[b].unknowns), 1e-7)
              << name << " seed " << seed;
      }
      for (const Crossing& crossing : found.path.crossings)
        EXPECT_LT(homotopy.curve().residual(crossing.v), 1e-10) << name << " seed " << seed;
    }
  }
}

}  // namespace
}  // namespace gcslab
