#pragma once

// The Jacobian of a curve with one more row, factorised.

#include <memory>
#include <span>
#include <vector>

#include "homotopy/curve.h"

namespace gcslab {

class SparseFactors;

/// (J; border) for an m by m + 1 matrix J: regular where J has rank m and its kernel is not orthogonal to the
/// border. Gauss's elimination with partial pivoting, rows scaled; columns that a pivot row does not meet
/// cost nothing.
/// Where its pattern is given, by sparse factors.
class BorderedMatrix {
 public:
  BorderedMatrix() : BorderedMatrix(nullptr) {}
  /// The pattern of J, which must outlive this; nullptr for dense factors.
  explicit BorderedMatrix(const SparsityPattern* pattern);
  BorderedMatrix(BorderedMatrix&&) noexcept;
  BorderedMatrix& operator=(BorderedMatrix&&) noexcept;
  ~BorderedMatrix();

  /// False when it is singular, as far as rounding errors tell.
  bool factorise(const Matrix<double>& jacobian, std::span<const double> border);
  /// Solves for the right side (values; last); the result has m + 1 entries.
  void solve(std::span<const double> values, double last, std::span<double> result) const;
  /// The sign of the determinant of what was factorised.
  int determinant_sign() const { return determinant_sign_; }
  /// The quotient of the largest and the least pivot, a rough measure of how singular it is.
  double pivot_ratio() const { return pivot_ratio_; }

 private:
  bool eliminate();

  std::unique_ptr<SparseFactors> sparse_;  ///< where they are used
  std::size_t n_ = 0;
  std::vector<double> entries_;  ///< column by column: below the diagonal L, the rest U
  std::vector<double> scales_;   ///< of the rows, so that their largest entries are 1
  std::vector<double> inverse_pivots_;
  std::vector<std::size_t> order_;  ///< the row of the matrix that is row k of L U
  int determinant_sign_ = 0;
  double pivot_ratio_ = 0;
};

}  // namespace gcslab
