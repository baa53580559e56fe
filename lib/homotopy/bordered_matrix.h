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
/// Where the pattern is known and m is at least `sparse_from`, by sparse factors.
class BorderedMatrix {
 public:
  /// Measured by gcslab_benchmarks, bordered_matrix/<family>/<size>, one factorisation and solution at a
  /// sketch: dense and sparse factors take 7 and 15 to 20 us at 60 unknowns, 22 to 40 and 25 to 40 at 100, 65
  /// to 120 and 40 to 78 at 150, 118 to 272 and 57 to 118 at 200, 526 to 926 and 98 to 296 at 300. They cross
  /// between 100 (polygons, prisms) and 200 (polyhedra); whole steps, which have other costs, gain later.
  static constexpr std::size_t kSparseFrom = 250;

  BorderedMatrix() : BorderedMatrix(nullptr) {}
  /// The pattern of J, which must outlive this; nullptr where it is not known.
  explicit BorderedMatrix(const SparsityPattern* pattern, std::size_t sparse_from = kSparseFrom);
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
