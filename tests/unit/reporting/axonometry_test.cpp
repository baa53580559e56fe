// Views are rigid motions followed by leaving out the depth; what passes behind is interrupted where plane
// geometry says.

#include "experiments/reporting/axonometry.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "base/random.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

using Line = std::vector<SeenPoint>;

double paper_distance(const SeenPoint& a, const SeenPoint& b) { return std::hypot(a.x - b.x, a.y - b.y); }

TEST(View, IsARigidMotion) {
  Random random(fuzz_seed(), "view");
  for (std::size_t n = 0; n < fuzz_cases(200); ++n) {
    const View view{random.uniform(-180, 180), random.uniform(-90, 90)};
    const std::vector<double> p = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const std::vector<double> q = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const SeenPoint a = view.seen(p), b = view.seen(q);
    EXPECT_NEAR(std::hypot(a.x - b.x, a.y - b.y, a.away - b.away),
                std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), 1e-14);
  }
}

TEST(View, IsTurnedAndRaised) {
  const std::vector<double> x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
  const View straight{0, 0}, left{90, 0}, above{0, 90};
  EXPECT_EQ(straight.seen(x).x, 1);
  EXPECT_EQ(straight.seen(z).y, 1);
  EXPECT_EQ(straight.seen(y).away, 1);
  EXPECT_NEAR(left.seen(y).x, 1, 1e-15);
  EXPECT_NEAR(left.seen(x).away, -1, 1e-15);
  EXPECT_NEAR(above.seen(y).y, 1, 1e-15);
  EXPECT_NEAR(above.seen(z).away, -1, 1e-15);  // upwards is towards the reader
  const SeenPoint in_plane = View{30, 40}.seen(std::vector<double>{3, 4});
  EXPECT_EQ(in_plane.x, 3);
  EXPECT_EQ(in_plane.y, 4);
}

TEST(BestView, KeepsThePointsOfACubeApart) {
  Wireframe cube;
  for (int k = 0; k < 8; ++k) {
    cube.names.push_back(std::to_string(k));
    cube.points.push_back({double(k & 1), double((k >> 1) & 1), double(k >> 2)});
    for (int bit = 1; bit < 8; bit *= 2) {
      if ((k & bit) == 0)
        cube.edges.push_back({static_cast<std::size_t>(k), static_cast<std::size_t>(k + bit)});
    }
  }
  const auto least_distance = [&](const View& view) {
    const Line points = seen_points(view, cube.points);
    double least = 1e300;
    for (std::size_t p = 0; p < 8; ++p) {
      for (std::size_t q = 0; q < p; ++q) least = std::min(least, paper_distance(points[p], points[q]));
    }
    return least;
  };
  EXPECT_GT(least_distance(best_view({cube})), 0.2);
  EXPECT_LT(least_distance({45, 35}), 0.02);  // along a diagonal two corners are one
}

TEST(VisibleParts, InterruptWhatPassesBehind) {
  const Line front = {{-1, 0, 0}, {1, 0, 0}}, rear = {{0, -1, 5}, {0, 1, 5}};
  const auto parts = visible_parts({rear, front}, 0.1);
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[0].line, 0U);
  EXPECT_NEAR(parts[0].points.back().y, -0.1, 1e-15);
  EXPECT_NEAR(parts[1].points.front().y, 0.1, 1e-15);
  EXPECT_EQ(parts[1].points.back().y, 1);
  EXPECT_EQ(parts[2].line, 1U);
  EXPECT_EQ(parts[2].points.front().x, -1);
  EXPECT_EQ(parts[2].points.back().x, 1);
}

TEST(VisibleParts, HaveLongerGapsWhereTheyCrossObliquely) {
  const Line front = {{-1, 0, 0}, {1, 0, 0}};
  const double sine = 0.8;
  const Line oblique = {{-0.6, -sine, 1}, {0.6, sine, 1}};  // the crossing is in the middle
  const auto parts = visible_parts({front, oblique}, 0.1);
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_NEAR(paper_distance(parts[1].points.back(), parts[2].points.front()), 2 * 0.1 / sine, 1e-14);
  const Line almost_parallel = {{-1, -0.01, 1}, {1, 0.01, 1}};
  const auto others = visible_parts({front, almost_parallel}, 0.1);
  ASSERT_EQ(others.size(), 3U);
  EXPECT_NEAR(paper_distance(others[1].points.back(), others[2].points.front()), 4 * 0.1, 1e-14);
}

TEST(VisibleParts, AreWholeWhereLinesMeet) {
  const Line one = {{0, 0, 0}, {2, 0, 0}};
  EXPECT_EQ(visible_parts({one, {{1, -1, -1}, {1, 1, 1}}}, 0.1).size(), 2U);  // they cross in space
  EXPECT_EQ(visible_parts({one, {{0, 0, 0}, {1, 1, 3}}}, 0.1).size(), 2U);    // a common end
  EXPECT_EQ(visible_parts({one, {{0, 1, 4}, {2, 1, 4}}}, 0.1).size(), 2U);    // parallel
  EXPECT_EQ(visible_parts({{{0, 0, 0}, {1, 0, 1}, {1, 1, 2}, {2, 3, 1}}}, 0.1).size(), 1U);
}

TEST(VisibleParts, OfACurveThatCrossesItselfAreInterruptedAcrossItsCorners) {
  Line loop;  // a figure of eight that goes away: at the origin for 0 and, behind that and across it, for pi
  constexpr int kParts = 400;
  for (int k = 0; k <= kParts; ++k) {
    const double s = -0.25 + 6 * static_cast<double>(k) / kParts;
    loop.push_back({std::sin(s), std::sin(s) * std::cos(s), s});
  }
  const auto parts = visible_parts({loop}, 0.05);
  ASSERT_EQ(parts.size(), 2U);
  const SeenPoint &before = parts[0].points.back(), &after = parts[1].points.front();
  EXPECT_NEAR(paper_distance(before, after), 0.1, 1e-3);
  EXPECT_NEAR((before.x + after.x) / 2, 0, 1e-3);
  EXPECT_NEAR((before.away + after.away) / 2, std::acos(-1), 1e-3);
  EXPECT_EQ(parts.front().points.front().away, loop.front().away);
  EXPECT_EQ(parts.back().points.back().away, loop.back().away);
}

}  // namespace
}  // namespace gcslab
