// Multipliers are those of the least squares problem, also where rows are nearly dependent.

#include "box_solver/least_squares.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "base/random.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

struct Row {
  std::vector<double> entries;
  double constant = 0;
  double spread = 0;
};

LeastSquaresMultipliers system_of_rows(const std::vector<Row>& rows, std::size_t linear) {
  LeastSquaresMultipliers system;
  system.reset(rows.size(), rows[0].entries.size(), linear);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (std::size_t c = 0; c < rows[k].entries.size(); ++c) system.set(k, c, rows[k].entries[c]);
    system.set_constant(k, rows[k].constant, rows[k].spread);
  }
  EXPECT_TRUE(system.solve());
  return system;
}

double combined(const std::vector<Row>& rows, std::span<const double> multipliers, std::size_t column) {
  double sum = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) sum += multipliers[k] * rows[k].entries[column];
  return sum;
}

TEST(LeastSquaresMultipliers, InvertARegularSquareMatrix) {
  Random random(fuzz_seed(), "least_squares");
  for (std::size_t i = 0; i < fuzz_cases(200); ++i) {
    const std::size_t n = 1 + random.below(6);
    std::vector<Row> rows(n);
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t c = 0; c < n; ++c) {
        const double diagonal = k == c ? 2.0 * static_cast<double>(n) : 0;
        rows[k].entries.push_back(diagonal + random.uniform(-1, 1));
      }
    }
    const LeastSquaresMultipliers system = system_of_rows(rows, n);
    for (std::size_t c = 0; c < n; ++c) {
      for (std::size_t j = 0; j < n; ++j)
        ASSERT_NEAR(combined(rows, system.multipliers(c), j), c == j ? 1 : 0, 1e-12);
    }
  }
}

TEST(LeastSquaresMultipliers, TellNearlyDependentRowsApart) {
  // The Gram matrix of these rows is [2 2; 2 2] in doubles, but for the digits that tell them apart.
  for (const double small : {1e-5, 1e-7, 1e-9}) {
    const std::vector<Row> rows = {{{1, 1}}, {{1, 1 + small}}};
    const LeastSquaresMultipliers system = system_of_rows(rows, 2);
    for (std::size_t c = 0; c < 2; ++c) {
      for (std::size_t j = 0; j < 2; ++j)
        EXPECT_NEAR(combined(rows, system.multipliers(c), j), c == j ? 1 : 0, 1e-4) << small;
    }
  }
}

TEST(LeastSquaresMultipliers, TakeEqualRowsAndRowsOfZeros) {
  const std::vector<Row> rows = {{{2, 0}}, {{2, 0}}, {{0, 0}}, {{0, 4}}};
  const LeastSquaresMultipliers system = system_of_rows(rows, 2);
  EXPECT_NEAR(combined(rows, system.multipliers(0), 0), 1, 1e-9);
  EXPECT_NEAR(combined(rows, system.multipliers(1), 1), 1, 1e-9);
  EXPECT_EQ(system.multipliers(0)[2], 0);
}

TEST(LeastSquaresMultipliers, AvoidRowsOfWhichLittleIsKnown) {
  const std::vector<Row> rows = {{{1, 0}, 0, 0}, {{1, 0}, 0, 10}, {{0, 1}, 0, 0}};
  const LeastSquaresMultipliers system = system_of_rows(rows, 2);
  EXPECT_NEAR(system.multipliers(0)[0], 1, 0.02);
  EXPECT_NEAR(system.multipliers(0)[1], 0, 0.02);
}

TEST(LeastSquaresMultipliers, FindTheCombinationThatIsAConstant) {
  // 1 + z_0 - z_1, z_0 + z_1 and 3 z_1 together are 1.
  const std::vector<Row> rows = {{{1, -1}, 1}, {{1, 1}, 0}, {{0, 3}, 0}};
  const LeastSquaresMultipliers system = system_of_rows(rows, 2);
  std::vector<double> multipliers(3);
  ASSERT_TRUE(system.solve_for_constant(multipliers));
  const double constant = multipliers[0];
  EXPECT_GT(std::fabs(constant), 0);
  for (std::size_t c = 0; c < 2; ++c)
    EXPECT_LT(std::fabs(combined(rows, multipliers, c)), 1e-6 * std::fabs(constant));
}

TEST(LeastSquaresMultipliers, RefuseNumbersThatAreNotFinite) {
  LeastSquaresMultipliers system;
  system.reset(1, 1, 1);
  system.set(0, 0, std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(system.solve());
}

}  // namespace
}  // namespace gcslab
