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

double sqr(double x) { return x * x; }

}  // namespace

void LeastSquaresMultipliers::reset(std::size_t rows, std::size_t columns, std::size_t linear) {
  linear_ = linear;
  if (f_.rows() != rows || f_.columns() != columns) {
    f_ = Matrix<double>(rows, columns);
    factor_ = Matrix<double>(rows, rows);
    multipliers_ = Matrix<double>(linear, rows);
    scales_.resize(rows);
  }
  f_.fill(0);
  constants_.assign(rows, 0);
  spreads_.assign(rows, 0);
}

void LeastSquaresMultipliers::scale_rows() {
  for (std::size_t k = 0; k < f_.rows(); ++k) {
    double largest = 0;
    for (const double entry : f_.row(k)) largest = std::max(largest, std::fabs(entry));
    const bool is_usable = largest > 0 && std::isfinite(largest) && std::isfinite(1 / largest);
    scales_[k] = is_usable ? 1 / largest : 0;
    for (double& entry : f_.row(k)) entry *= scales_[k];
  }
}

/// A row of zeros takes no part: true, and its row of the factor is made.
bool LeastSquaresMultipliers::skip_zero_row(std::size_t i) {
  if (scales_[i] != 0) return false;
  std::ranges::fill(factor_.row(i), 0);
  factor_(i, i) = 1;
  return true;
}

/// False when the factor is not to be trusted.
bool LeastSquaresMultipliers::factorise_gram() {
  constexpr double kTrustedPivot = 1e-8;  // of rows scaled to largest entry 1: half the digits
  for (std::size_t i = 0; i < f_.rows(); ++i) {
    if (skip_zero_row(i)) continue;
    for (std::size_t j = 0; j <= i; ++j) {
      double entry = dot(f_.row(i).data(), f_.row(j).data(), f_.columns()) -
                     dot(factor_.row(i).data(), factor_.row(j).data(), j);
      if (i != j) {
        factor_(i, j) = entry / factor_(j, j);
        continue;
      }
      entry += sqr(scales_[i] * spreads_[i]);
      if (!(entry > kTrustedPivot) || !std::isfinite(entry)) return false;
      factor_(i, i) = std::sqrt(entry);
    }
  }
  return true;
}

/// False when the factor is not finite.
bool LeastSquaresMultipliers::orthogonalise_rows() {
  constexpr double kLeastSpread = 1e-12;  // of rows scaled as above: keeps L regular
  const std::size_t m = f_.rows();
  const std::size_t columns = f_.columns();
  if (orthogonal_.rows() != m || orthogonal_.columns() != columns + m)
    orthogonal_ = Matrix<double>(m, columns + m);
  for (std::size_t i = 0; i < m; ++i) {
    if (skip_zero_row(i)) continue;
    const std::span<double> row = orthogonal_.row(i);
    std::ranges::fill(row, 0);
    std::ranges::copy(f_.row(i), row.begin());
    row[columns + i] = kLeastSpread + scales_[i] * spreads_[i];
    for (std::size_t j = 0; j < i; ++j) {
      const std::span<const double> unit = orthogonal_.row(j);
      factor_(i, j) = dot(row.data(), unit.data(), row.size());
      for (std::size_t c = 0; c < row.size(); ++c) row[c] -= factor_(i, j) * unit[c];
    }
    factor_(i, i) = std::sqrt(dot(row.data(), row.data(), row.size()));
    if (!(factor_(i, i) > 0) || !std::isfinite(factor_(i, i))) return false;
    for (double& entry : row) entry /= factor_(i, i);
  }
  return true;
}

bool LeastSquaresMultipliers::solve_for(std::size_t column, std::span<double> x) const {
  if (is_orthogonal_) {
    for (std::size_t k = 0; k < f_.rows(); ++k) x[k] = orthogonal_(k, column);
  } else {
    for (std::size_t k = 0; k < f_.rows(); ++k) x[k] = f_(k, column);
    forward_substitute(x);
  }
  return back_substitute(x);
}

bool LeastSquaresMultipliers::solve_for_constant(std::span<double> x) const {
  for (std::size_t k = 0; k < f_.rows(); ++k) x[k] = scales_[k] * constants_[k];
  forward_substitute(x);
  return back_substitute(x);
}

/// x becomes L^-1 x.
void LeastSquaresMultipliers::forward_substitute(std::span<double> x) const {
  for (std::size_t k = 0; k < x.size(); ++k)
    x[k] = (x[k] - dot(factor_.row(k).data(), x.data(), k)) / factor_(k, k);
}

/// x becomes S L^-T x, with S the scales of the rows.
bool LeastSquaresMultipliers::back_substitute(std::span<double> x) const {
  for (std::size_t k = x.size(); k-- > 0;) {
    x[k] /= factor_(k, k);
    for (std::size_t j = 0; j < k; ++j) x[j] -= factor_(k, j) * x[k];
  }
  for (std::size_t k = 0; k < x.size(); ++k) x[k] *= scales_[k];
  return std::ranges::all_of(x, [](double v) { return std::isfinite(v); });
}

bool LeastSquaresMultipliers::solve() {
  scale_rows();
  is_orthogonal_ = !factorise_gram();
  if (is_orthogonal_ && !orthogonalise_rows()) return false;
  for (std::size_t i = 0; i < linear_; ++i) {
    if (!solve_for(i, multipliers_.row(i))) return false;
  }
  return true;
}

}  // namespace gcslab
