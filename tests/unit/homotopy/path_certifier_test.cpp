// Proofs by tubes: of whole paths, and never of what is not so.

#include "homotopy/path_certifier.h"

#include <cmath>
#include <gtest/gtest.h>

#include "homotopy/path_tracker.h"
#include "support/corpus_figure.h"
#include "support/fuzz.h"
#include "support/plane_curve.h"

namespace gcslab {
namespace {

/// The point of the curve near the guess, with the tangent on the side of `along`.
CurvePoint point_near(Curve& curve, std::vector<double> guess, const std::vector<double>& along) {
  CurvePoint result{std::move(guess), along};
  Corrector corrector(curve, {CorrectorKind::normal_flow, 1e-13, 50});
  EXPECT_EQ(corrector.correct(result, {}, 1, result.v).end, Correction::End::done);
  EXPECT_TRUE(TangentSolver(curve).find(result, along));
  return result;
}

template <class C>
Path proved_path(C& curve, const std::vector<double>& start) {
  PathCertifier certifier(curve, curve);
  return follow_path(curve, start, {}, {}, {.certifier = &certifier});
}

TEST(PathCertifier, ProvesAWholeCircle) {
  auto curve = circle();
  const Path path = proved_path(curve, {2, 0});
  EXPECT_EQ(path.end, PathEnd::cycle);
  EXPECT_TRUE(path.is_return_proved);
  EXPECT_EQ(path.unproved_steps, 0U);
  EXPECT_EQ(path.crossings.size(), 2U);
  EXPECT_GT(path.tubes, 10U);
}

TEST(PathCertifier, ProvesNothingAcrossBranchPoints) {
  auto eight = ovals(0);
  const Path path = proved_path(eight, {oval_start(0), 0});
  EXPECT_EQ(path.end, PathEnd::cycle);
  EXPECT_EQ(path.branch_points.size(), 2U);
  EXPECT_EQ(path.unproved_steps, 2U);
}

/// From one oval to the other, straight across the gap, there is no arc.
TEST(PathCertifier, ProvesNoJump) {
  for (const double gap : {1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 0.0}) {
    auto curve = ovals(gap);
    const std::vector<double> along = {2 / std::sqrt(5.0), 1 / std::sqrt(5.0)};
    for (const double far : {0.1, 0.3, 0.6}) {
      const CurvePoint here = point_near(curve, {-far, (1 - far) / 2}, along);
      const CurvePoint there = point_near(curve, {far, (1 + far) / 2}, along);
      PathCertifier certifier(curve, curve);
      ASSERT_TRUE(certifier.begin(here));
      EXPECT_FALSE(certifier.follow(there)) << gap << " " << far;
    }
  }
}

/// Parallel curves (x - sin 3 t) (x - sin 3 t - distance) = 0: no arc leads from one to the other, and arcs
/// along one are proved.
TEST(PathCertifier, StaysOnItsCurveBesideAnother) {
  for (const double apart : {1.0, 0.1, 1e-2, 1e-3}) {
    PlaneCurve curve([apart]<class T>(const T& x, const T& t) {
      const T a = x - sin(T(3) * t), b = a - T(apart), slope = T(-3) * cos(T(3) * t);
      return std::array<T, 3>{a * b, a + b, slope * (a + b)};
    });
    const auto at = [&](double t, double shift) {
      return point_near(curve, {std::sin(3 * t) + shift, t}, {0, 1});
    };
    PathCertifier certifier(curve, curve);
    ASSERT_TRUE(certifier.begin(at(0, 0))) << apart;
    EXPECT_FALSE(certifier.follow(at(0.2, apart))) << apart;
    const auto arc = certifier.follow(at(0.3, 0));
    ASSERT_TRUE(arc) << apart;
    EXPECT_EQ(arc->crossings, 0U);
    const auto further = certifier.follow(at(1.2, 0));
    ASSERT_TRUE(further) << apart;
    EXPECT_EQ(further->crossings, 1U);
    EXPECT_FALSE(further->passes_beginning);
  }
}

TEST(PathCertifier, ProvesPathsOfRandomSketches) {
  for (const std::string name : {"polyhedra/octahedron", "polyhedra/pentahedron"}) {
    const CorpusFigure figured = corpus_figure(name);
    for (std::uint64_t seed = 0; seed < fuzz_cases(5); ++seed) {
      SketchHomotopy homotopy = figured.homotopy(figured.random_sketch(seed));
      IntervalHomotopy enclosure(figured.equations, homotopy.curve());
      PathCertifier certifier(homotopy.curve(), enclosure);
      const Path proved = follow_path(homotopy.curve(), homotopy.start(), {}, {}, {.certifier = &certifier});
      EXPECT_EQ(proved.end, PathEnd::cycle) << name << " seed " << seed;
      EXPECT_TRUE(proved.is_return_proved) << name << " seed " << seed;
      EXPECT_EQ(proved.unproved_steps, 0U) << name << " seed " << seed;
      const Path usual = follow_path(homotopy.curve(), homotopy.start(), {});
      EXPECT_EQ(usual.crossings.size(), proved.crossings.size()) << name << " seed " << seed;
    }
  }
}

}  // namespace
}  // namespace gcslab
