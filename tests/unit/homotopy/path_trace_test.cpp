// Traces of paths: on the unit circle x^2 + s^2 = 1 with t = s, points lie on the circle, in order.

#include "homotopy/path_trace.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace gcslab {
namespace {

/// A step of a walk along the circle from the angle `from` to the angle `to`.
PathState step(double from, double to, std::uint64_t number) {
  const double way = to > from ? 1 : -1;
  const auto at = [way](double angle) {
    return CurvePoint{{std::cos(angle), std::sin(angle)}, {-way * std::sin(angle), way * std::cos(angle)}};
  };
  PathState state;
  state.path.steps = number;
  state.direction = way > 0 ? 1 : -1;
  state.before = at(from);
  state.here = at(to);
  return state;
}

double angle_of(const std::vector<double>& v) { return std::atan2(v[1], v[0]); }

TEST(PathTrace, HasPointsBetweenStepsOnTheCurve) {
  PathTrace trace;
  const PathObserver observer = trace.observer();
  for (int k = 0; k < 4; ++k) observer(step(0.3 * k, 0.3 * (k + 1), static_cast<std::uint64_t>(k + 1)));
  const PathTrace::Samples samples = trace.samples(41);
  ASSERT_EQ(samples.points.size(), 41U);
  EXPECT_EQ(samples.start, 0U);
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    EXPECT_NEAR(std::hypot(samples.points[i][0], samples.points[i][1]), 1, 2e-4) << i;
    EXPECT_NEAR(angle_of(samples.points[i]), 0.03 * static_cast<double>(i), 1e-3) << i;
  }
}

TEST(PathTrace, PutsTheOtherDirectionBeforeTheStart) {
  PathTrace trace;
  const PathObserver observer = trace.observer();
  observer(step(0, 0.5, 1));
  observer(step(0, -0.5, 2));
  observer(step(-0.5, -1, 3));
  const PathTrace::Samples samples = trace.samples(4);
  ASSERT_EQ(samples.points.size(), 4U);
  EXPECT_EQ(samples.start, 2U);
  const std::vector<double> angles = {-1, -0.5, 0, 0.5};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(angle_of(samples.points[i]), angles[i], 1e-12);
}

TEST(PathTrace, IsThinnedAndKeepsItsEnds) {
  PathTrace trace;
  const PathObserver observer = trace.observer();
  for (int k = 0; k < 300; ++k) observer(step(0.01 * k, 0.01 * (k + 1), static_cast<std::uint64_t>(k + 1)));
  const PathTrace::Samples samples = trace.samples(50);
  ASSERT_EQ(samples.points.size(), 50U);
  EXPECT_NEAR(angle_of(samples.points.front()), 0, 1e-12);
  EXPECT_NEAR(angle_of(samples.points.back()), 3, 1e-12);
  for (std::size_t i = 1; i < 50; ++i)
    EXPECT_GT(angle_of(samples.points[i]), angle_of(samples.points[i - 1])) << i;
}

TEST(PathTrace, ForgetsAPathThatIsBegunAnew) {
  PathTrace trace;
  const PathObserver observer = trace.observer();
  observer(step(0, 2, 1));
  observer(step(0, 0.4, 1));
  observer(step(0.4, 0.9, 2));
  trace.end_at({std::cos(0.8), std::sin(0.8)});
  const PathTrace::Samples samples = trace.samples(3);
  ASSERT_EQ(samples.points.size(), 3U);
  EXPECT_NEAR(angle_of(samples.points[1]), 0.4, 1e-12);
  EXPECT_NEAR(angle_of(samples.points[2]), 0.8, 1e-12);
}

TEST(PathTrace, OfNoStepIsEmpty) { EXPECT_TRUE(PathTrace().samples(10).points.empty()); }

}  // namespace
}  // namespace gcslab
