#include "linear_program/lp_model.h"

#include <gtest/gtest.h>

#include "base/check.h"

namespace gcslab {
namespace {

LpModel two_columns() {
  LpModel model;
  model.add_column({0, 1});
  model.add_column({-1, 1});
  return model;
}

TEST(LpModel, ReturnsWhatWasPutIn) {
  LpModel model = two_columns();
  const int row = model.add_row(std::vector<LinearTerm>{{1, Interval(1, 3)}, {0, -2.0}}, {-1, 4});
  EXPECT_EQ(model.columns(), 2);
  EXPECT_EQ(model.rows(), 1);
  EXPECT_EQ(model.row_columns(row)[0], 1);
  EXPECT_EQ(model.row_coefficients(row)[0], Interval(1, 3));
  EXPECT_EQ(model.row_midpoints(row)[0], 2);
  EXPECT_EQ(model.sides(row), Interval(-1, 4));
  EXPECT_FALSE(model.is_thin());
}

TEST(LpModel, RefillingKeepsTheStructureAndAddingChangesIt) {
  LpModel model = two_columns();
  const int row = model.add_row(std::vector<LinearTerm>{{0, 1.0}, {1, 1.0}}, {0, 1});
  const auto structure = model.structure();
  model.set_coefficients(row, std::vector<Interval>{0.0, 5.0});
  model.set_sides(row, {0, 0.5});
  model.set_column(0, {0.25, 0.5});
  EXPECT_EQ(model.structure(), structure);
  EXPECT_EQ(model.row_midpoints(row)[1], 5);
  const LpModel copy = model;
  EXPECT_EQ(copy.structure(), structure);
  model.add_column({0, 1});
  EXPECT_NE(model.structure(), structure);
  EXPECT_NE(two_columns().structure(), two_columns().structure());
}

TEST(LpModel, RefusesWhatSolversCouldNotTake) {
  LpModel model = two_columns();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(model.add_column({0, infinity}), InvariantError);
  EXPECT_THROW(model.add_column(Interval::empty()), InvariantError);
  EXPECT_THROW(model.add_row(std::vector<LinearTerm>{{2, 1.0}}, {0, 1}), InvariantError);
  EXPECT_THROW(model.add_row(std::vector<LinearTerm>{{-1, 1.0}}, {0, 1}), InvariantError);
  EXPECT_THROW(model.add_row(std::vector<LinearTerm>{{0, 1.0}, {0, 1.0}}, {0, 1}), InvariantError);
  EXPECT_THROW(model.add_row(std::vector<LinearTerm>{{0, 1.0}}, Interval::empty()), InvariantError);
  EXPECT_THROW(model.add_row(std::vector<LinearTerm>{{0, Interval::entire()}}, {0, 1}), InvariantError);
}

}  // namespace
}  // namespace gcslab
