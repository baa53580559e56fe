#pragma once

// Multipliers C = F_lin^T (F F^T + D)^-1 in plain doubles: the rows of C are the least squares solutions c of
// F^T c = e_i, where D, diagonal, penalises rows of which little is known (Tikhonov 1963, with a weight a
// row). They are suggestions: nothing rests on their accuracy.
//
// The triangular factor L with L L^T = F F^T + D comes from the Gram matrix by Cholesky's method; where rows
// are so nearly dependent that the Gram matrix, which squares the condition, has lost what tells them apart,
// from the rows of [F, sqrt(D)] themselves by orthogonalisation (modified Gram-Schmidt; Bjorck 1967: L is
// then as good as that of a backward stable QR decomposition).

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
  /// The constant of a row, and the root of the sum of the squares of how far its entries, and the constant,
  /// may be from what is set. Both 0 until set.
  void set_constant(std::size_t row, double value, double spread) {
    constants_[row] = value;
    spreads_[row] = spread;
  }

  /// Computes the multipliers of the linear columns. Rows are first scaled to largest entry 1. False when
  /// that broke down (numbers that are not finite).
  [[nodiscard]] bool solve();

  /// The multipliers of the combination made for a variable, one an equation.
  std::span<const double> multipliers(std::size_t variable) const { return multipliers_.row(variable); }

  /// After `solve`: the multipliers of the combination nearest to another column alone. False as for solve.
  [[nodiscard]] bool solve_for(std::size_t column, std::span<double> multipliers) const;

  /// After `solve`: those of the combination in which the constant outweighs the columns most. False as for
  /// solve.
  [[nodiscard]] bool solve_for_constant(std::span<double> multipliers) const;

 private:
  void scale_rows();
  bool skip_zero_row(std::size_t i);
  bool factorise_gram();
  bool orthogonalise_rows();
  void forward_substitute(std::span<double> x) const;
  bool back_substitute(std::span<double> x) const;

  std::size_t linear_ = 0;
  Matrix<double> f_;
  std::vector<double> constants_, spreads_;
  std::vector<double> scales_;
  Matrix<double> factor_;       ///< L, in the lower triangle
  Matrix<double> orthogonal_;   ///< the rows of L^-1 [F, sqrt(D)]
  bool is_orthogonal_ = false;  ///< how L was made
  Matrix<double> multipliers_;
};

}  // namespace gcslab
