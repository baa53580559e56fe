#include "homotopy/bordered_matrix.h"

#include <cmath>
#include <gtest/gtest.h>

#include "base/random.h"

namespace gcslab {
namespace {

/// A matrix of full rank, as far as probability tells: entries on two diagonals, some elsewhere, and a full
/// last column, as t has one.
struct SparseExample {
  explicit SparseExample(std::uint64_t seed, std::size_t m = 40) : jacobian(m, m + 1), border(m + 1) {
    Random random(seed, "bordered_matrix_test");
    for (std::size_t row = 0; row < m; ++row) {
      std::vector<bool> is_met(m + 1, false);
      is_met[row] = is_met[row + 1] = is_met[m] = true;
      for (int k = 0; k < 3; ++k) is_met[random.below(m + 1)] = true;
      pattern.emplace_back();
      for (std::size_t column = 0; column <= m; ++column) {
        if (!is_met[column]) continue;
        pattern.back().push_back(static_cast<std::uint32_t>(column));
        jacobian(row, column) = random.uniform(-1, 1);
      }
      values.push_back(random.uniform(-1, 1));
    }
    for (double& x : border) x = random.uniform(-1, 1);
  }

  SparsityPattern pattern;
  Matrix<double> jacobian;
  std::vector<double> border, values;
};

TEST(BorderedMatrix, SparseAndDenseFactorsAgree) {
  int positive = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const SparseExample example(seed);
    const std::size_t n = example.border.size();
    BorderedMatrix dense, sparse(&example.pattern);
    ASSERT_TRUE(dense.factorise(example.jacobian, example.border));
    ASSERT_TRUE(sparse.factorise(example.jacobian, example.border));
    EXPECT_EQ(sparse.determinant_sign(), dense.determinant_sign()) << seed;
    positive += dense.determinant_sign() > 0 ? 1 : 0;
    EXPECT_GE(sparse.pivot_ratio(), 1);
    std::vector<double> x(n);
    sparse.solve(example.values, 2, x);
    double last = -2;
    for (std::size_t i = 0; i < n; ++i) last += example.border[i] * x[i];
    double size = 1;
    for (const double each : x) size = std::max(size, std::abs(each));
    EXPECT_LT(std::abs(last), 1e-11 * size);
    for (std::size_t row = 0; row + 1 < n; ++row) {
      double residual = -example.values[row];
      for (std::size_t i = 0; i < n; ++i) residual += example.jacobian(row, i) * x[i];
      EXPECT_LT(std::abs(residual), 1e-11 * size) << seed;
    }
  }
  EXPECT_GT(positive, 50);
  EXPECT_LT(positive, 150);
}

TEST(BorderedMatrix, ASingularMatrixIsRefusedByBothFactors) {
  SparseExample example(1);
  for (std::size_t i = 0; i < example.border.size(); ++i) example.border[i] = example.jacobian(7, i);
  for (const SparsityPattern* pattern : {static_cast<const SparsityPattern*>(nullptr),
                                         static_cast<const SparsityPattern*>(&example.pattern)}) {
    BorderedMatrix matrix(pattern);
    EXPECT_FALSE(matrix.factorise(example.jacobian, example.border));
  }
  example.border[3] = NAN;
  BorderedMatrix matrix(&example.pattern);
  EXPECT_FALSE(matrix.factorise(example.jacobian, example.border));
}

}  // namespace
}  // namespace gcslab
