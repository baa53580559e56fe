#pragma once

// The Jacobian of a curve with one more row, factorised.

#include <Eigen/Dense>
#include <span>

#include "base/matrix.h"

namespace gcslab {

/// (J; border) for an m by m + 1 matrix J: regular where J has rank m and its kernel is not orthogonal to the
/// border.
class BorderedMatrix {
 public:
  /// False when it is singular, as far as rounding errors tell.
  bool factorise(const Matrix<double>& jacobian, std::span<const double> border);
  /// Solves for the right side (values; last); the result has m + 1 entries.
  void solve(std::span<const double> values, double last, std::span<double> result);

 private:
  Eigen::MatrixXd matrix_;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
  Eigen::VectorXd right_;
};

}  // namespace gcslab
