// Paths in the coordinates of a construction plan are those of the constraint system itself.

#include "construction/plan_curve.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "construction/plan_homotopy.h"
#include "homotopy/sketch_solver.h"
#include "support/corpus_figure.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

constexpr const char* kCertifier = "krawczyk_slopes+kantorovich";

TEST(PlanCurve, HasTheDerivativesThatDifferencesShow) {
  for (const char* name : {"polyhedra/octahedron", "polyhedra/pentahedron", "polyhedra/6p7d3a2c",
                           "polyhedra/icosahedron", "kinematics/planar-platform"}) {
    const CorpusFigure figure = corpus_figure(name);
    const SketchHomotopy sketched = figure.homotopy(figure.random_sketch(fuzz_seed()));
    PlanHomotopy plan(figure.system, figure.frame, figure.equations, sketched, PlanKind::least);
    PlanCurve& curve = plan.curve();
    const std::size_t m = curve.size();
    std::vector<double> v = curve.start(), values(m), above(m), below(m);
    Matrix<double> derivatives(m, m + 1);
    ASSERT_TRUE(curve.jacobian(v, values, derivatives));
    for (std::size_t k = 0; k < m; ++k) EXPECT_NEAR(values[k], 0, 1e-9) << name;
    for (std::size_t j = 0; j <= m; ++j) {
      constexpr double kStep = 1e-6;
      const double x = v[j];
      v[j] = x + kStep;
      ASSERT_TRUE(curve.values(v, above));
      v[j] = x - kStep;
      ASSERT_TRUE(curve.values(v, below));
      v[j] = x;
      for (std::size_t k = 0; k < m; ++k) {
        const double slope = (above[k] - below[k]) / (2 * kStep);
        EXPECT_NEAR(derivatives(k, j), slope, 1e-5 * (1 + std::abs(slope))) << name << " " << k << " " << j;
      }
    }
  }
}

TEST(PlanCurve, StartsAtTheSketch) {
  for (const char* name : {"polyhedra/octahedron", "polyhedra/hexahedron"}) {
    const CorpusFigure figure = corpus_figure(name);
    const SketchHomotopy sketched = figure.homotopy(figure.random_sketch(fuzz_seed()));
    const PlanHomotopy plan(figure.system, figure.frame, figure.equations, sketched, PlanKind::gao);
    const std::vector<double> there = plan.curve().unknowns(plan.curve().start());
    const std::vector<double> sketch = sketched.curve().unknowns(sketched.start());
    for (std::size_t i = 0; i < sketch.size(); ++i) EXPECT_NEAR(there[i], sketch[i], 1e-9) << name;
  }
}

/// The classes of solutions on the path, by their distances.
std::size_t solutions_along(FigureCurve& curve, const std::vector<double>& start,
                            const CorpusFigure& figure) {
  const EquationSystem equations = figure.equation_system();
  const SystemFunctions functions(equations);
  const SketchSolutions found = solve_along_path(curve, curve, start, functions, {}, kCertifier);
  EXPECT_EQ(found.path.end, PathEnd::cycle);
  for (const SketchSolution& solution : found.solutions) EXPECT_TRUE(solution.root.has_value());
  return found.solutions.size();
}

TEST(PlanCurve, CrossesWhatThePathOfTheSketchCrosses) {
  for (const char* name : {"polyhedra/octahedron", "kinematics/planar-platform"}) {
    const CorpusFigure figure = corpus_figure(name);
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      SketchHomotopy sketched = figure.homotopy(figure.random_sketch(seed));
      const std::size_t usual = solutions_along(sketched.curve(), sketched.start(), figure);
      for (const PlanKind kind : {PlanKind::least, PlanKind::henneberg}) {
        PlanHomotopy plan(figure.system, figure.frame, figure.equations, sketched, kind);
        EXPECT_EQ(solutions_along(plan.curve(), plan.curve().start(), figure), usual) << name << " " << seed;
      }
    }
  }
}

}  // namespace
}  // namespace gcslab
