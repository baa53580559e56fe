#pragma once

// Multipliers C = F_lin^T (F F^T + eps I)^-1 in plain doubles. They are suggestions: nothing rests on their
// accuracy.

#include <cstddef>
#include <span>
#include <vector>

#include "base/matrix.h"

namespace gcslab {

class LeastSquaresMultipliers {
 public:
  /// Starts a zero matrix F of `rows` equations; its first `linear` columns are F_lin.
  void reset(std::size_t rows, std::size_t columns, std::size_t linear);
  void set(std::size_t row, std::size_t column, double value) { f_(row, column) = value; }

  /// Computes the multipliers of the linear columns. Rows are first scaled to largest entry 1. False when
  /// that broke down (numbers that are not finite).
  [[nodiscard]] bool solve();

  /// The multipliers of the combination made for a variable, one an equation.
  std::span<const double> multipliers(std::size_t variable) const { return multipliers_.row(variable); }

  /// After `solve`: the multipliers of the combination nearest to another column alone. False as for solve.
  [[nodiscard]] bool solve_for(std::size_t column, std::span<double> multipliers) const;

 private:
  void scale_rows();
  bool factorise();

  std::size_t linear_ = 0;
  Matrix<double> f_;
  std::vector<double> scales_;
  Matrix<double> gram_;  ///< lower triangle; after `factorise` the Cholesky factor
  Matrix<double> multipliers_;
};

}  // namespace gcslab
