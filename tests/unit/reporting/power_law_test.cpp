#include "experiments/reporting/power_law.h"

#include <cmath>
#include <gtest/gtest.h>

namespace gcslab {
namespace {

TEST(PowerLaw, IsFoundAgainInPointsOfOne) {
  std::vector<std::pair<double, double>> points;
  for (const double x : {1.0, 2.0, 4.0, 8.0, 16.0, 32.0}) points.emplace_back(x, 0.25 * std::pow(x, 3.5));
  const auto law = fitted_power_law(points);
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->exponent, 3.5, 1e-12);
  EXPECT_NEAR(law->factor, 0.25, 1e-12);
  EXPECT_NEAR(law->at(64), 0.25 * std::pow(64, 3.5), 1e-6);
  EXPECT_NEAR(law->from, 8, 1e-12);
  EXPECT_NEAR(law->to, 32, 1e-12);
}

TEST(PowerLaw, IsThatOfLargePoints) {
  std::vector<std::pair<double, double>> points;
  for (double x = 1; x <= 1e6; x *= 10) points.emplace_back(x, 1000 + x * x);
  const auto law = fitted_power_law(points);
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->exponent, 2, 0.01);
}

TEST(PowerLaw, NeedsThreePointsWithLogarithms) {
  EXPECT_FALSE(fitted_power_law({}));
  EXPECT_FALSE(fitted_power_law({{1, 1}, {2, 4}}));
  EXPECT_FALSE(fitted_power_law({{2, 1}, {2, 4}, {2, 8}}));
  EXPECT_FALSE(fitted_power_law({{4, 1}, {5, 0}, {6, -1}, {0, 4}, {-1, 8}}));
}

}  // namespace
}  // namespace gcslab
