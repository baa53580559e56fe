#include "experiments/reporting/plot_axis.h"

#include <gtest/gtest.h>
#include <limits>

namespace gcslab {
namespace {

std::vector<std::string> texts(const PlotAxis& axis) {
  std::vector<std::string> result;
  for (const auto& [value, words] : axis.tics) result.push_back(words);
  return result;
}

using Texts = std::vector<std::string>;

TEST(PlotAxis, LinearRangesEndOnTics) {
  const PlotAxis axis = linear_axis({-0.25, 0.75, 1}, 5);
  EXPECT_EQ(texts(axis), (Texts{"-0.5", "0.0", "0.5", "1.0"}));
  EXPECT_EQ(axis.low, -0.5);
  EXPECT_EQ(axis.high, 1);
}

TEST(PlotAxis, LogarithmicTicsArePowersOfTenWhereTwoFit) {
  EXPECT_EQ(texts(logarithmic_axis({1e-5, 2e-2})), (Texts{"10⁻⁵", "10⁻⁴", "10⁻³", "10⁻²"}));
  EXPECT_EQ(texts(logarithmic_axis({0.6, 2.4})), (Texts{"0.5", "1", "2"}));
}

TEST(PlotAxis, NothingToShowStillHasARange) {
  for (const PlotAxis& axis :
       {linear_axis({}), logarithmic_axis({0, -1}), whole_number_axis({}), exact_axis(2, 2)}) {
    EXPECT_LT(axis.low, axis.high);
    EXPECT_FALSE(axis.tics.empty());
  }
  EXPECT_LT(linear_axis({3, 3}).low, 3);
  EXPECT_LT(logarithmic_axis({3, std::numeric_limits<double>::infinity()}).high, 10);
}

TEST(PlotAxis, FewWholeNumbersHaveATicEach) {
  EXPECT_EQ(texts(whole_number_axis({2, 4, 10})), (Texts{"2", "4", "10"}));
  EXPECT_LE(whole_number_axis({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 30}).tics.size(), 10U);
}

}  // namespace
}  // namespace gcslab
