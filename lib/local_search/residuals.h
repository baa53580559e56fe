#pragma once

// The equations of a system and their derivatives at a point, in plain doubles, with the measures by which
// local searches end.

#include <Eigen/Core>
#include <optional>
#include <span>

#include "certification/system_functions.h"

namespace gcslab {

class Residuals {
 public:
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// `functions` must outlive it. `start` tells the size of points that are near 0.
  Residuals(const SystemFunctions& functions, std::span<const double> start);

  /// Values and Jacobian at a point. False where an equation is undefined or has no finite derivative; the
  /// values are then still those of the point.
  [[nodiscard]] bool evaluate(std::span<const double> point);
  /// The sum of the squares of the equations at another point; infinite where undefined.
  double sum_of_squares(std::span<const double> point);

  /// Of the last evaluated point.
  Eigen::Map<const Eigen::VectorXd> values() const;
  Eigen::Map<const RowMajor> jacobian() const;
  /// max |f_i|; NaN where undefined.
  double largest() const;
  /// max |f_i| / (max_j |df_i/dx_j| size), where size is the largest coordinate of the point or the start:
  /// the part of its size by which the point has to move, at least and to first order, for each equation to
  /// vanish. It does not change when equations or all unknowns are multiplied by numbers.
  double relative() const;
  /// Whether the gradient of the sum of squares is so small that a move by the whole size would change the
  /// sum by a ten-thousandth, to first order; invariant as above.
  bool is_stationary() const;

 private:
  SystemEvaluator<double> evaluator_;
  std::vector<double> values_, other_;
  Matrix<double> jacobian_;
  double start_size_, size_ = 0;
};

}  // namespace gcslab
