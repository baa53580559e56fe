// Figures whose frame is a line or a point: refused where a user draws them, turned somehow on a path.

#include <cmath>
#include <gtest/gtest.h>

#include "base/error.h"
#include "geometry/constraint_system_reader.h"
#include "geometry/sketch.h"

namespace gcslab {
namespace {

ConstraintSystem four_points() {
  return read_constraint_system(YamlNode::parse(
      "kind: constraint_system\nname: test\nuniverse: 3d\npoints: [A, B, C, D]\nconstraints:\n"
      "  - {distance: [A, B], parameter: a}\nvaluations: {wanted: {a: 1}}\norigin: test\n"
      "licence: test\n",
      "test.yaml"));
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

TEST(FrameOnALine, IsTurnedWithoutChangingTheFigure) {
  const ConstraintSystem system = four_points();
  const Frame frame = {0, 1, 2};
  const Figure figures[] = {
      {{1, 2, 3}, {2, 4, 5}, {4, 8, 9}, {0, 1, -2}},  // A, B, C on a line
      {{1, 2, 3}, {1, 2, 3}, {4, 8, 9}, {0, 1, -2}},  // A = B
      {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {0, 1, -2}},  // A = B = C
      {{1, 2, 3}, {2, 4, 5}, {4, 8, 9}, {3, 6, 7}},   // all on a line
  };
  for (const Figure& figure : figures) {
    EXPECT_TRUE(is_frame_flat(frame, figure));
    EXPECT_THROW(in_frame(system, frame, figure), InputError);
    const Figure turned = in_frame_or_on_line(system, frame, figure);
    for (std::size_t p = 0; p < figure.size(); ++p) {
      for (std::size_t q = 0; q < p; ++q)
        EXPECT_NEAR(distance(turned[p], turned[q]), distance(figure[p], figure[q]), 1e-12);
    }
    for (std::size_t p = 0; p < frame.size(); ++p) {
      for (std::size_t axis = p; axis < 3; ++axis) EXPECT_EQ(turned[p][axis], 0);
    }
    EXPECT_NEAR(turned[3][2], 0, 1e-12);  // in the plane that the frame leaves free
  }
}

TEST(FrameOnALine, IsNothingToAFrameThatHolds) {
  const ConstraintSystem system = four_points();
  const Figure figure = {{1, 2, 3}, {2, 4, 5}, {4, 8, 0}, {0, 1, -2}};
  EXPECT_FALSE(is_frame_flat({0, 1, 2}, figure));
  EXPECT_EQ(in_frame_or_on_line(system, {0, 1, 2}, figure), in_frame(system, {0, 1, 2}, figure));
}

}  // namespace
}  // namespace gcslab
