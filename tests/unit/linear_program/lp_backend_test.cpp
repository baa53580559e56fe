// What backends share: claims of multipliers, and rays of solvers that give no reason or no sign.

#include "linear_program/lp_backend.h"

#include <gtest/gtest.h>
#include <limits>

namespace gcslab {
namespace {

/// x in [0, 1], y in [-1, 1]; x + 2 y >= 3 - gap, which the box meets by gap.
LpModel one_row(double gap) {
  LpModel model;
  model.add_column({0, 1});
  model.add_column({-1, 1});
  model.add_row(std::vector<LinearTerm>{{0, 1.0}, {1, 2.0}},
                {3 - gap, std::numeric_limits<double>::infinity()});
  return model;
}

TEST(UnsafeBound, IsTheBoundThatMultipliersClaim) {
  const std::vector<LinearTerm> objective{{0, 1.0}};
  // x = (x + 2 y) - 2 y >= 2.5 - 2
  EXPECT_EQ(unsafe_bound(one_row(0.5), objective, std::vector<double>{1.0}), 0.5);
  EXPECT_EQ(unsafe_bound(one_row(0.5), objective, std::vector<double>{-1.0}), 0);
}

TEST(SingleRowRay, NamesTheRowThatTheBoxMisses) {
  EXPECT_TRUE(single_row_ray(one_row(0.5)).empty());
  EXPECT_TRUE(single_row_ray(one_row(0)).empty());
  const std::vector<double> ray = single_row_ray(one_row(-0.5));
  ASSERT_EQ(ray.size(), 1U);
  EXPECT_EQ(unsafe_bound(one_row(-0.5), {}, ray), 0.5);
}

TEST(OrientRay, TakesTheSignThatClaimsMoreAndLeavesNoReasonAlone) {
  std::vector<double> ray{-2};
  orient_ray(one_row(-0.5), ray);
  EXPECT_EQ(ray, std::vector<double>{2});
  std::vector<double> none;
  orient_ray(one_row(-0.5), none);
  EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace gcslab
