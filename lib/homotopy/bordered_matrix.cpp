#include "homotopy/bordered_matrix.h"

namespace gcslab {

bool BorderedMatrix::factorise(const Matrix<double>& jacobian, std::span<const double> border) {
  constexpr double kSingular = 1e14;
  const auto rows = static_cast<Eigen::Index>(jacobian.rows());
  matrix_.resize(rows + 1, rows + 1);
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  matrix_.topRows(rows) = Eigen::Map<const RowMajor>(jacobian.data(), rows, rows + 1);
  matrix_.row(rows) = Eigen::Map<const Eigen::RowVectorXd>(border.data(), rows + 1);
  lu_.compute(matrix_);
  const auto pivots = lu_.matrixLU().diagonal().cwiseAbs();
  return pivots.maxCoeff() < kSingular * pivots.minCoeff();
}

void BorderedMatrix::solve(std::span<const double> values, double last, std::span<double> result) {
  const auto rows = static_cast<Eigen::Index>(values.size());
  right_.resize(rows + 1);
  right_.head(rows) = Eigen::Map<const Eigen::VectorXd>(values.data(), rows);
  right_[rows] = last;
  Eigen::Map<Eigen::VectorXd>(result.data(), rows + 1) = lu_.solve(right_);
}

}  // namespace gcslab
