#include "box_solver/least_squares.h"

#include <algorithm>
#include <cmath>

namespace gcslab {

void LeastSquaresMultipliers::reset(std::size_t rows, std::size_t columns, std::size_t linear) {
  linear_ = linear;
  if (f_.rows() != rows || f_.columns() != columns) {
    f_ = Matrix<double>(rows, columns);
    gram_ = Matrix<double>(rows, rows);
    multipliers_ = Matrix<double>(linear, rows);
    scales_.resize(rows);
  }
  f_.fill(0);
}

void LeastSquaresMultipliers::scale_rows() {
  for (std::size_t k = 0; k < f_.rows(); ++k) {
    double largest = 0;
    for (const double entry : f_.row(k)) largest = std::max(largest, std::fabs(entry));
    scales_[k] = largest > 0 && std::isfinite(largest) ? 1 / largest : 0;
    for (double& entry : f_.row(k)) entry *= scales_[k];
  }
}

/// The Cholesky factor of F F^T + eps I, row by row.
bool LeastSquaresMultipliers::factorise() {
  constexpr double kRegularisation = 1e-10;
  const std::size_t m = f_.rows();
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const double* a = f_.row(i).data();
      const double* b = f_.row(j).data();
      double sum = i == j ? kRegularisation : 0;
      for (std::size_t c = 0; c < f_.columns(); ++c) sum += a[c] * b[c];
      for (std::size_t c = 0; c < j; ++c) sum -= gram_(i, c) * gram_(j, c);
      if (i == j) {
        if (!(sum > 0) || !std::isfinite(sum)) return false;
        gram_(i, i) = std::sqrt(sum);
      } else {
        gram_(i, j) = sum / gram_(j, j);
      }
    }
  }
  return true;
}

bool LeastSquaresMultipliers::solve() {
  scale_rows();
  if (!factorise()) return false;
  const std::size_t m = f_.rows();
  for (std::size_t i = 0; i < linear_; ++i) {
    const std::span<double> x = multipliers_.row(i);
    for (std::size_t k = 0; k < m; ++k) {
      double sum = f_(k, i);
      for (std::size_t j = 0; j < k; ++j) sum -= gram_(k, j) * x[j];
      x[k] = sum / gram_(k, k);
    }
    for (std::size_t k = m; k-- > 0;) {
      double sum = x[k];
      for (std::size_t j = k + 1; j < m; ++j) sum -= gram_(j, k) * x[j];
      x[k] = sum / gram_(k, k);
    }
    for (std::size_t k = 0; k < m; ++k) x[k] *= scales_[k];
    if (!std::ranges::all_of(x, [](double v) { return std::isfinite(v); })) return false;
  }
  return true;
}

}  // namespace gcslab
