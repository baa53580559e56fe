#pragma once

// Sparse LU of (J; border), the border being dense.

#include <Eigen/SparseLU>
#include <span>

#include "homotopy/curve.h"

namespace gcslab {

/// Of the transposed matrix, in which the border is the last column: there it causes no fill. Left-looking
/// elimination with partial pivoting on columns in an order of little fill (Demmel, Eisenstat, Gilbert, Li,
/// Liu 1999), found once from the pattern.
class SparseFactors {
 public:
  /// The pattern of the m by m + 1 matrix J.
  explicit SparseFactors(const SparsityPattern& pattern);
  /// False where a pivot is 0 or not finite.
  bool factorise(const Matrix<double>& jacobian, std::span<const double> border);
  /// Solves for the right side (values; last).
  void solve(std::span<const double> values, double last, std::span<double> result);
  int determinant_sign() { return lu_.signDeterminant() < 0 ? -1 : 1; }
  /// The quotient of the largest and the least pivot.
  double pivot_ratio() const { return lu_.pivot_ratio(); }

 private:
  using SparseMatrix = Eigen::SparseMatrix<double>;
  class Elimination : public Eigen::SparseLU<SparseMatrix> {
   public:
    double pivot_ratio() const;
  };

  const SparsityPattern* pattern_;
  SparseMatrix transposed_;
  Elimination lu_;
  Eigen::VectorXd right_;
};

}  // namespace gcslab
