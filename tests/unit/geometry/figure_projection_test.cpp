// Figures moved to where boolean constraints hold and shared parameters agree.

#include "geometry/figure_projection.h"

#include <cmath>
#include <gtest/gtest.h>

#include "geometry/constraint_system_reader.h"
#include "geometry/frame.h"
#include "geometry/sketch.h"
#include "support/fuzz.h"
#include "unit/geometry/constraint_case.h"

namespace gcslab {
namespace {

ConstraintSystem read(const std::string& text) {
  return read_constraint_system(YamlNode::parse(text, "figure.yaml"));
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

TEST(FigureProjection, MakesConstraintsOfAParameterAgree) {
  const ConstraintSystem system = read(
      "universe: 3d\npoints: [A, B, C, D]\nconstraints:\n"
      "  - {distance: [A, B], parameter: e}\n  - {distance: [A, C], parameter: e}\n"
      "  - {distance: [A, D], parameter: e, interpretation: norm}\n  - {coplanar: [A, B, C, D]}\n"
      "  - {distance: [C, D], parameter: f}\nvaluations: {v: {e: 1, f: 1}}\n");
  const GeometricEquations equations = geometric_equations(system, {});
  Random random(fuzz_seed(), "figure projection");
  for (std::size_t n = 0; n < fuzz_cases(50); ++n) {
    const Figure drawn = random_figure(system, random);
    const FigureProjection moved = satisfy_common_equations(system, equations, unknowns_of(equations, drawn));
    ASSERT_TRUE(moved.holds);
    const Figure figure = figure_at(equations, moved.unknowns);
    const double e = distance(figure[0], figure[1]);
    ASSERT_NEAR(distance(figure[0], figure[2]), e, 1e-9);
    ASSERT_NEAR(distance(figure[0], figure[3]), e, 1e-9);
    std::vector<double> numbers = moved.unknowns;
    for (const double parameter : parameters_of(system, figure)) numbers.push_back(parameter);
    for (const double value : values_at(equations, numbers)) ASSERT_NEAR(value, 0, 1e-9);
  }
}

TEST(FigureProjection, LeavesAFigureThatHasNothingToSatisfy) {
  const ConstraintSystem system = read(
      "universe: 2d\npoints: [A, B]\nconstraints:\n  - {distance: [A, B], parameter: e}\n"
      "valuations: {v: {e: 1}}\n");
  const std::vector<double> unknowns = {1, 2, 3, 4};
  const FigureProjection same = satisfy_common_equations(system, geometric_equations(system, {}), unknowns);
  EXPECT_TRUE(same.holds);
  EXPECT_EQ(same.unknowns, unknowns);
}

/// Where P0 and P1 coincide the two faces that they share are flat; in the frame that is one equation.
TEST(FigureProjection, DoesNotLetPointsMeetThatHaveADistance) {
  const ConstraintSystem system = read_constraint_system(
      YamlNode::load_file(std::string(GCSLAB_SOURCE_DIR) + "/data/polyhedra/hexahedron.yaml"));
  const Frame frame = frame_of(system);
  const GeometricEquations equations = geometric_equations(system, frame);
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    ConstraintSystem drawn = system;
    drawn.sketch.reset();
    drawn.random_sketch = seed;
    const Figure sketch = in_frame(system, frame, *sketch_of(drawn));
    const FigureProjection moved =
        satisfy_common_equations(system, equations, unknowns_of(equations, sketch));
    ASSERT_TRUE(moved.holds) << seed;
    const Figure figure = figure_at(equations, moved.unknowns);
    for (const Constraint& constraint : system.constraints) {
      if (!constraint.parameter) continue;
      const std::size_t p = constraint.objects[0], q = constraint.objects[1];
      EXPECT_GT(distance(figure[p], figure[q]), 1e-4 * distance(sketch[p], sketch[q])) << seed;
    }
  }
}

/// Lines of length 1 cannot be parallel and perpendicular at once.
TEST(FigureProjection, NamesWhatNoFigureHas) {
  const ConstraintSystem system = read(
      "universe: 2d\npoints: [A]\nlines: [l, m]\nconstraints:\n  - {incidence: [A, l]}\n"
      "  - {parallel: [l, m]}\n  - {perpendicular: [l, m]}\n"
      "  - {distance: [A, m], parameter: e}\nvaluations: {v: {e: 1}}\n");
  const GeometricEquations equations = geometric_equations(system, {});
  Random random(fuzz_seed(), "impossible figures");
  for (std::size_t n = 0; n < fuzz_cases(20); ++n) {
    const FigureProjection none =
        satisfy_common_equations(system, equations, unknowns_of(equations, random_figure(system, random)));
    EXPECT_FALSE(none.holds);
    EXPECT_NE(none.worst_constraint, 3U);  // a distance of its own has any value
  }
}

}  // namespace
}  // namespace gcslab
