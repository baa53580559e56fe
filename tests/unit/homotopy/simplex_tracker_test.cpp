// Paths through simplices: those of known curves, and of sketches.

#include "homotopy/simplex_tracker.h"

#include <cmath>
#include <gtest/gtest.h>

#include "base/error.h"
#include "support/corpus_figure.h"
#include "support/plane_curve.h"

namespace gcslab {
namespace {

TEST(SimplexTracker, ClosesACircleAtTheFaceWhereItSetOut) {
  auto curve = circle();
  for (const double mesh : {0.3, 0.1, 0.01}) {
    const Path path = follow_simplices(curve, {2, 0}, {.mesh = mesh});
    EXPECT_EQ(path.end, PathEnd::cycle);
    ASSERT_EQ(path.crossings.size(), 2U);
    for (const Crossing& crossing : path.crossings) {
      EXPECT_NEAR(std::abs(crossing.v[0]), std::sqrt(3), 1e-12);
      EXPECT_EQ(crossing.rank, 1U);
    }
    EXPECT_NEAR(path.length, 4 * 3.14159265358979, mesh);
    // Edges crossed: the variations of x, of t and of x - t along the circle, over the mesh.
    EXPECT_NEAR(static_cast<double>(path.steps) * mesh, 8 + 8 + 8 * std::sqrt(2), 10 * mesh);
  }
}

TEST(SimplexTracker, StaysOnItsOvalAndNeverFailsWhereBranchesCross) {
  auto apart = ovals(0.1), crossing = ovals(0);
  const Path one = follow_simplices(apart, {oval_start(0.1), 0}, {.mesh = 0.01});
  EXPECT_EQ(one.end, PathEnd::cycle);
  EXPECT_TRUE(one.crossings.empty() || one.crossings.size() % 2 == 0);
  const Path both = follow_simplices(crossing, {oval_start(0), 0}, {.mesh = 0.01});
  EXPECT_EQ(both.end, PathEnd::cycle);
}

TEST(SimplexTracker, CrossesWhatThePredictorAndCorrectorCross) {
  const CorpusFigure octahedron = corpus_figure("polyhedra/octahedron");
  SketchHomotopy homotopy = octahedron.homotopy(*sketch_of(octahedron.system));
  const Path path = follow_simplices(homotopy.curve(), homotopy.start(), {.mesh = 0.003});
  const Path usual = follow_path(homotopy.curve(), homotopy.start(), {});
  EXPECT_EQ(path.end, PathEnd::cycle);
  ASSERT_EQ(path.crossings.size(), usual.crossings.size());
  for (const Crossing& crossing : path.crossings) {
    double nearest = HUGE_VAL;
    for (const Crossing& other : usual.crossings) nearest = std::min(nearest, distance(crossing.v, other.v));
    EXPECT_LT(nearest, 1e-9);
  }
  EXPECT_NEAR(path.length, usual.length, 0.01 * usual.length);
}

TEST(SimplexTracker, SaysThatTheMeshIsTooCoarse) {
  const CorpusFigure octahedron = corpus_figure("polyhedra/octahedron");
  SketchHomotopy homotopy = octahedron.homotopy(*sketch_of(octahedron.system));
  EXPECT_THROW(follow_simplices(homotopy.curve(), homotopy.start(), {.mesh = 2}), NotApplicable);
}

TEST(SimplexTracker, EndsWithItsBudget) {
  auto curve = circle();
  const Path path = follow_simplices(curve, {2, 0}, {.mesh = 0.01, .maximum_simplices = 10});
  EXPECT_EQ(path.end, PathEnd::budget);
  EXPECT_EQ(path.steps, 10U);
}

}  // namespace
}  // namespace gcslab
