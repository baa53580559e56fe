#include "box_solver/least_squares.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gcslab {
namespace {

/// The dot product in four sums, which the processor computes side by side.
double dot(const double* a, const double* b, std::size_t size) {
  std::array<double, 4> sums{};
  std::size_t i = 0;
  for (; i + 4 <= size; i += 4) {
    for (std::size_t lane = 0; lane < 4; ++lane) sums[lane] += a[i + lane] * b[i + lane];
  }
  double sum = sums[0] + sums[1] + (sums[2] + sums[3]);
  for (; i < size; ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

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
      const double entry = dot(f_.row(i).data(), f_.row(j).data(), f_.columns()) -
                           dot(gram_.row(i).data(), gram_.row(j).data(), j);
      if (i != j) {
        gram_(i, j) = entry / gram_(j, j);
        continue;
      }
      if (!(entry + kRegularisation > 0) || !std::isfinite(entry)) return false;
      gram_(i, i) = std::sqrt(entry + kRegularisation);
    }
  }
  return true;
}

bool LeastSquaresMultipliers::solve_for(std::size_t column, std::span<double> x) const {
  const std::size_t m = f_.rows();
  for (std::size_t k = 0; k < m; ++k)
    x[k] = (f_(k, column) - dot(gram_.row(k).data(), x.data(), k)) / gram_(k, k);
  for (std::size_t k = m; k-- > 0;) {
    x[k] /= gram_(k, k);
    for (std::size_t j = 0; j < k; ++j) x[j] -= gram_(k, j) * x[k];
  }
  for (std::size_t k = 0; k < m; ++k) x[k] *= scales_[k];
  return std::ranges::all_of(x, [](double v) { return std::isfinite(v); });
}

bool LeastSquaresMultipliers::solve() {
  scale_rows();
  if (!factorise()) return false;
  for (std::size_t i = 0; i < linear_; ++i) {
    if (!solve_for(i, multipliers_.row(i))) return false;
  }
  return true;
}

}  // namespace gcslab
