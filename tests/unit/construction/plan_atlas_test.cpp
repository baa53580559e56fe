// Paths that change from plan to plan are those of the constraint system itself.

#include "construction/plan_atlas.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "construction/plan_singularity.h"
#include "homotopy/sketch_solver.h"
#include "support/corpus_figure.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

constexpr const char* kCertifier = "krawczyk_slopes+kantorovich";

/// The solutions up to isometry, one each.
std::vector<FigureBox> figures_of(const SketchSolutions& found, const CorpusFigure& figure) {
  constexpr double kUncertified = 1e-7;
  std::vector<FigureBox> boxes;
  for (const SketchSolution& solution : found.solutions) {
    Box box;
    for (const double x : solution.unknowns) box.emplace_back(x - kUncertified, x + kUncertified);
    boxes.push_back(figure_box(figure.equations, box));
  }
  std::vector<FigureBox> result;
  for (const auto& members : congruence_classes(figure.equations.sorts, figure.equations.universe, boxes))
    result.push_back(boxes[members.front()]);
  return result;
}

struct Followed {
  SketchSolutions found;
  std::vector<FigureBox> figures;
};

Followed along_sketch(const CorpusFigure& figure, SketchHomotopy& sketched,
                      const SystemFunctions& functions) {
  Homotopy& curve = sketched.curve();
  SketchSolutions found = solve_along_path(curve, curve, sketched.start(), functions, {}, kCertifier);
  std::vector<FigureBox> figures = figures_of(found, figure);
  return {std::move(found), std::move(figures)};
}

Followed along_plans(const CorpusFigure& figure, SketchHomotopy& sketched, const SystemFunctions& functions) {
  PlanAtlas atlas(figure.system, figure.frame, figure.equations, sketched, PlanKind::least);
  Path path = follow_path(atlas, atlas.begin(), {}, {}, {.charts = &atlas});
  SketchSolutions found = solutions_of(std::move(path), sketched.curve(), functions, kCertifier);
  std::vector<FigureBox> figures = figures_of(found, figure);
  return {std::move(found), std::move(figures)};
}

TEST(PlanAtlas, FollowsTheWholePathWhereOnePlanBecomesSingular) {
  std::uint64_t changes = 0;
  for (const char* name : {"polyhedra/pentahedron", "polyhedra/6p7d3a2c", "polyhedra/octahedron"}) {
    const CorpusFigure figure = corpus_figure(name);
    const EquationSystem equations = figure.equation_system();
    const SystemFunctions functions(equations);
    for (std::uint64_t k = 0; k < fuzz_cases(8); ++k) {
      const std::uint64_t seed = fuzz_seed() + k;
      SketchHomotopy sketched = figure.homotopy(figure.random_sketch(seed));
      const Followed usual = along_sketch(figure, sketched, functions);
      const Followed planned = along_plans(figure, sketched, functions);
      const std::string text = std::string(name) + ", sketch " + std::to_string(seed);
      EXPECT_EQ(planned.found.path.end, usual.found.path.end) << text;
      EXPECT_EQ(planned.figures.size(), usual.figures.size()) << text;
      std::vector<FigureBox> all = usual.figures;
      all.insert(all.end(), planned.figures.begin(), planned.figures.end());
      EXPECT_EQ(congruence_classes(figure.equations.sorts, figure.equations.universe, all).size(),
                usual.figures.size())
          << text << ": a solution that is not on the path of the sketch";
      changes += planned.found.path.chart_changes;
    }
  }
  EXPECT_GT(changes, 0U);
}

TEST(PlanAtlas, CarriesPointsOverToAnotherPlan) {
  const CorpusFigure figure = corpus_figure("polyhedra/pentahedron");
  const SketchHomotopy sketched = figure.homotopy(figure.random_sketch(fuzz_seed()));
  PlanAtlas atlas(figure.system, figure.frame, figure.equations, sketched, PlanKind::least);
  const std::vector<double> start = atlas.begin();
  const std::vector<double> before = atlas.chartless(start);
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(before[i], sketched.start()[i], 1e-9);
  // Only a better chart is taken, so that from the best one of this place none is left.
  std::vector<double> v = start;
  while (atlas.change_at(v, true)) {
    v = atlas.carried_over(v);
    const std::vector<double> after = atlas.chartless(v);
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i], before[i], 1e-9);
    std::vector<double> values(atlas.size());
    ASSERT_TRUE(atlas.values(v, values));
    for (const double value : values) EXPECT_NEAR(value, 0, 1e-8);
    const auto there = atlas.start();
    ASSERT_TRUE(there.has_value());
    for (std::size_t i = 0; i < v.size(); ++i) EXPECT_NEAR((*there)[i], v[i], 1e-9);
  }
  EXPECT_EQ(atlas.begin(), start);
}

TEST(PlanSingularity, SeesThePlaneOfThreePointsOnALine) {
  // P3 lies in the plane of P0, P1 and P2, which is none where P2 comes to the line of the two others.
  const CorpusFigure figure = corpus_figure("polyhedra/pentahedron");
  Figure points = figure.random_sketch(fuzz_seed());
  const Plan plan = make_plan(figure.system, {0, 1, 4, 5, 2, 3}, PlanKind::least, points);
  const PlanProgram program(figure.system, plan);
  const std::vector<double> wanted = figure.wanted();
  double last = 1;
  for (const double off : {1e-1, 1e-2, 1e-4, 1e-6}) {
    Figure near = points;
    const Figure& p = points;
    for (std::size_t i = 0; i < 3; ++i) near[2][i] = p[0][i] + 1.7 * (p[1][i] - p[0][i]) + off * p[3][i];
    const auto least = least_general_step(program, in_frame(figure.system, plan, near), wanted);
    ASSERT_TRUE(least.has_value());
    EXPECT_LE(least->sine, last);
    EXPECT_LE(least->sine, 100 * off);
    last = least->sine;
  }
  EXPECT_LT(last, 1e-4);
}

}  // namespace
}  // namespace gcslab
