// Paths of sketches: what they cross are solutions, and of the octahedron those that its box solver's proof
// has.

#include "homotopy/path_tracker.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "base/random.h"
#include "homotopy/predictor.h"
#include "homotopy/smooth_step.h"
#include "support/corpus_figure.h"
#include "support/error_text.h"
#include "support/fuzz.h"
#include "support/plane_curve.h"

namespace gcslab {
namespace {

/// Of the figures at the crossings, up to isometry.
std::vector<std::vector<double>> distances_of(const CorpusFigure& figured, const SketchHomotopy& homotopy,
                                              const std::vector<Crossing>& crossings) {
  std::vector<std::vector<double>> classes;
  for (const Crossing& crossing : crossings) {
    const Figure figure = figure_at(figured.equations, homotopy.curve().unknowns(crossing.v));
    std::vector<double> distances;
    for (std::size_t p = 0; p < figure.size(); ++p) {
      for (std::size_t q = 0; q < p; ++q) {
        double sum = 0;
        for (std::size_t axis = 0; axis < figure[p].size(); ++axis)
          sum += std::pow(figure[p][axis] - figure[q][axis], 2);
        distances.push_back(std::sqrt(sum));
      }
    }
    const auto is_same = [&](const std::vector<double>& other) {
      for (std::size_t i = 0; i < other.size(); ++i) {
        if (std::abs(other[i] - distances[i]) > 1e-6) return false;
      }
      return true;
    };
    if (std::ranges::none_of(classes, is_same)) classes.push_back(distances);
  }
  return classes;
}

Path path_of(const CorpusFigure& figured, const Figure& sketch, const TrackerOptions& options = {}) {
  SketchHomotopy homotopy = figured.homotopy(sketch);
  return follow_path(homotopy.curve(), homotopy.start(), options);
}

TEST(PathTracker, OfTheOctahedronCrossesItsFiguresAndReturns) {
  const CorpusFigure octahedron = corpus_figure("polyhedra/octahedron");
  std::size_t most = 0;
  for (std::size_t seed = 0; seed < fuzz_cases(100); ++seed) {
    SketchHomotopy homotopy = octahedron.homotopy(octahedron.random_sketch(seed));
    const Path path = follow_path(homotopy.curve(), homotopy.start(), {});
    EXPECT_EQ(path.end, PathEnd::cycle) << "seed " << seed;
    EXPECT_EQ(path.crossings.size() % 2, 0U) << "seed " << seed;  // a closed curve
    const std::size_t classes = distances_of(octahedron, homotopy, path.crossings).size();
    EXPECT_LE(classes, 4U) << "seed " << seed;  // by the box solver's proof
    most = std::max(most, classes);
  }
  EXPECT_EQ(most, 4U);
}

/// However it is tracked, the path is the same curve.
TEST(PathTracker, CrossesTheSameWithEveryPredictorAndCorrector) {
  const CorpusFigure octahedron = corpus_figure("polyhedra/octahedron");
  for (std::uint64_t seed = 0; seed < fuzz_cases(10); ++seed) {
    const Figure sketch = octahedron.random_sketch(seed);
    const Path usual = path_of(octahedron, sketch);
    const auto expect_the_same = [&](const TrackerOptions& options, const std::string& what) {
      const Path path = path_of(octahedron, sketch, options);
      EXPECT_EQ(path.end, usual.end) << what << " seed " << seed;
      ASSERT_EQ(path.crossings.size(), usual.crossings.size()) << what << " seed " << seed;
      for (std::size_t k = 0; k < path.crossings.size(); ++k) {
        EXPECT_LT(distance(path.crossings[k].v, usual.crossings[k].v), 1e-9) << what << " seed " << seed;
        EXPECT_NEAR(path.crossings[k].length, usual.crossings[k].length, 0.1 * usual.length) << what;
      }
    };
    for (const PredictorKind& kind : predictor_registry().entries()) {
      for (const CorrectorKind corrector :
           {CorrectorKind::chord, CorrectorKind::newton, CorrectorKind::normal_flow})
        expect_the_same({.predictor = kind.name, .corrector = {.kind = corrector}}, kind.name);
    }
    expect_the_same({.predictor = "euler",
                     .corrector = {.kind = CorrectorKind::newton, .tolerance = 1e-10},
                     .step_control = StepControl::fixed,
                     .first_step = 0.02},
                    "fixed steps");
  }
}

TEST(PathTracker, CrossesTheSameWithDenseAndSparseFactors) {
  const CorpusFigure octahedron = corpus_figure("polyhedra/octahedron");
  for (std::uint64_t seed = 0; seed < fuzz_cases(10); ++seed) {
    const Figure sketch = octahedron.random_sketch(seed);
    SketchHomotopy dense = octahedron.homotopy(sketch, {.linear_algebra = LinearAlgebra::dense});
    SketchHomotopy sparse = octahedron.homotopy(sketch, {.linear_algebra = LinearAlgebra::sparse});
    EXPECT_EQ(dense.curve().pattern(), nullptr);
    ASSERT_NE(sparse.curve().pattern(), nullptr);
    const Path one = follow_path(dense.curve(), dense.start(), {});
    const Path other = follow_path(sparse.curve(), sparse.start(), {});
    EXPECT_EQ(one.end, other.end) << "seed " << seed;
    ASSERT_EQ(one.crossings.size(), other.crossings.size()) << "seed " << seed;
    for (std::size_t k = 0; k < one.crossings.size(); ++k)
      EXPECT_LT(distance(one.crossings[k].v, other.crossings[k].v), 1e-9) << "seed " << seed;
  }
}

TEST(PathTracker, OfASingularSketchIsRefusedWithTheReason) {
  const CorpusFigure octahedron = corpus_figure("polyhedra/octahedron");
  Figure flat(6, std::vector<double>(3, 0.0));
  Random random(fuzz_seed(), "flat sketch");
  for (auto& point : flat) {
    for (std::size_t axis = 0; axis < 2; ++axis) point[axis] = random.uniform(-1, 1);
  }
  EXPECT_NE(error_text([&] { path_of(octahedron, flat); }).find("singular"), std::string::npos);
}

TEST(PathTracker, GoesRoundACircle) {
  auto curve = circle();
  const Path path = follow_path(curve, {2, 0}, {});
  EXPECT_EQ(path.end, PathEnd::cycle);
  EXPECT_NEAR(path.length, 4 * std::acos(-1.0), 0.1);  // by chords
  ASSERT_EQ(path.crossings.size(), 2U);
  EXPECT_NEAR(std::abs(path.crossings[0].v[0]), std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(path.crossings[0].v[0], -path.crossings[1].v[0], 1e-14);
}

/// A lemniscate through (0, 1/2), where its branches cross: a figure of eight that the path goes round whole.
TEST(PathTracker, GoesStraightOnWhereBranchesCross) {
  auto eight = ovals(0);
  const Path path = follow_path(eight, {oval_start(0), 0}, {});
  EXPECT_EQ(path.end, PathEnd::cycle);
  ASSERT_EQ(path.branch_points.size(), 2U);
  for (const BranchPoint& point : path.branch_points) {
    EXPECT_NEAR(point.v[0], 0, 1e-8);
    EXPECT_NEAR(point.v[1], 0.5, 1e-8);
  }
  EXPECT_EQ(path.crossings.size(), 2U);
}

/// Two branches that come near and turn away: the path must not go straight on.
TEST(PathTracker, TurnsWhereBranchesOnlyComeNear) {
  for (const double gap : {1e-2, 1e-4, 1e-6, 1e-8}) {
    auto curve = ovals(gap);
    const Path path = follow_path(curve, {oval_start(gap), 0}, {});
    EXPECT_EQ(path.end, PathEnd::cycle) << gap;
    EXPECT_TRUE(path.branch_points.empty()) << gap;
    EXPECT_TRUE(path.crossings.empty()) << gap;  // the other oval's
  }
}

/// A curve that flat figures cross at a small angle, where t hardly moves: a long step would turn onto the
/// flat figures, which all have t = 1, without a sign that says so.
TEST(PathTracker, StaysOnItsBranchWhereAnotherCrossesAtASmallAngle) {
  const CorpusFigure hexahedron = corpus_figure("polyhedra/hexahedron");
  for (const std::uint64_t seed : {13U, 40U, 71U}) {
    SketchHomotopy homotopy =
        hexahedron.homotopy(hexahedron.random_sketch(seed), {.booleans = Booleans::projected});
    std::size_t flat = 0;
    const Path path = follow_path(homotopy.curve(), homotopy.start(), {.maximum_steps = 20'000}, {},
                                  {.observer = [&](const PathState& state) {
                                    if (std::abs(state.here.v.back() - 1) < 1e-8) ++flat;
                                  }});
    EXPECT_EQ(path.end, PathEnd::cycle) << "seed " << seed;
    EXPECT_LE(flat, path.crossings.size()) << "seed " << seed;
  }
}

/// Two lines that cross at an angle of about 0.2.
TEST(PathTracker, DistanceHalfWayTellsAStepToAnotherBranch) {
  constexpr double kAngle = 0.2;
  auto lines = PlaneCurve([]<class T>(const T& x, const T& t) {  // t = 0 and t = angle x
    const T b = t - T(kAngle) * x;
    return std::array<T, 3>{t * b, T(-kAngle) * t, b + t};
  });
  const auto point_at = [&](double x, double slope) {
    return CurvePoint{{x, slope * x}, {1 / std::hypot(1, slope), slope / std::hypot(1, slope)}, 0};
  };
  const CurvePoint before = point_at(-0.3, 0), straight = point_at(0.3, 0), astray = point_at(0.3, kAngle);
  const auto distance_to = [&](const CurvePoint& point) {
    TangentSolver tangents(lines);
    CurvePoint found = point;
    EXPECT_TRUE(tangents.find(found, point.tangent));
    return SmoothStep(lines).distance_half_way(tangents.matrix(), before, point);
  };
  EXPECT_LT(distance_to(straight), 1e-14);
  EXPECT_GT(distance_to(astray), 0.01 * kAngle * distance(before.v, astray.v));
}

TEST(PathTracker, TellsInfinityAndUndefinedPoints) {
  PlaneCurve hyperbola([]<class T>(const T& x, const T& t) {
    return std::array<T, 3>{x * (t + T(1)) - T(1), t + T(1), x};
  });
  const Path away = follow_path(hyperbola, {1, 0}, {});
  EXPECT_EQ(away.end, PathEnd::to_infinity);
  EXPECT_EQ(away.other_end, PathEnd::to_infinity);
  EXPECT_EQ(away.crossings.size(), 1U);
  PlaneCurve root([]<class T>(const T& x, const T& t) {
    return std::array<T, 3>{sqrt(T(2) - t) - x, T(-1), T(-0.5) / sqrt(T(2) - t)};
  });
  const Path ending = follow_path(root, {std::sqrt(2.0), 0}, {});
  EXPECT_TRUE(ending.end == PathEnd::to_undefined || ending.other_end == PathEnd::to_undefined);
}

TEST(PathTracker, GoesOnFromAStateAsIfItHadNotStopped) {
  const CorpusFigure octahedron = corpus_figure("polyhedra/octahedron");
  SketchHomotopy homotopy = octahedron.homotopy(octahedron.random_sketch(2));
  const std::vector<double>& start = homotopy.start();
  std::vector<PathState> states;
  const Path whole = follow_path(homotopy.curve(), start, {}, {},
                                 {.observer = [&](const PathState& state) { states.push_back(state); }});
  ASSERT_GT(states.size(), 20U);
  for (const std::size_t k : {std::size_t{0}, states.size() / 2, states.size() - 2}) {
    const Path rest = follow_path(homotopy.curve(), start, {}, {}, {.from = &states[k]});
    EXPECT_EQ(rest.end, whole.end);
    ASSERT_EQ(rest.crossings.size(), whole.crossings.size());
    for (std::size_t c = 0; c < whole.crossings.size(); ++c)
      EXPECT_LT(distance(rest.crossings[c].v, whole.crossings[c].v), 1e-12);
  }
}

}  // namespace
}  // namespace gcslab
