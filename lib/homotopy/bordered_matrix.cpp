#include "homotopy/bordered_matrix.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "homotopy/sparse_factors.h"

namespace gcslab {
namespace {

/// Of the quotient of pivots.
constexpr double kSingular = 1e14;

}  // namespace

BorderedMatrix::BorderedMatrix(const SparsityPattern* pattern) {
  if (pattern != nullptr) sparse_ = std::make_unique<SparseFactors>(*pattern);
}

BorderedMatrix::BorderedMatrix(BorderedMatrix&&) noexcept = default;
BorderedMatrix& BorderedMatrix::operator=(BorderedMatrix&&) noexcept = default;
BorderedMatrix::~BorderedMatrix() = default;

bool BorderedMatrix::factorise(const Matrix<double>& jacobian, std::span<const double> border) {
  if (sparse_) {
    if (!sparse_->factorise(jacobian, border)) return false;
    determinant_sign_ = sparse_->determinant_sign();
    pivot_ratio_ = sparse_->pivot_ratio();
    return pivot_ratio_ < kSingular;
  }
  n_ = border.size();
  entries_.resize(n_ * n_);
  inverse_pivots_.resize(n_);
  order_.resize(n_);
  scales_.resize(n_);
  for (std::size_t row = 0; row + 1 < n_; ++row) {
    double largest = 0;
    for (std::size_t column = 0; column < n_; ++column)
      largest = std::max(largest, std::abs(jacobian(row, column)));
    const double scale = scales_[row] = largest > 0 ? 1 / largest : 1;
    for (std::size_t column = 0; column < n_; ++column)
      entries_[column * n_ + row] = scale * jacobian(row, column);
  }
  for (std::size_t column = 0; column < n_; ++column) entries_[column * n_ + n_ - 1] = border[column];
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  return eliminate();
}

bool BorderedMatrix::eliminate() {
  double largest_pivot = 0, least_pivot = HUGE_VAL;
  determinant_sign_ = 1;
  for (std::size_t k = 0; k < n_; ++k) {
    double* const pivot_column = entries_.data() + k * n_;
    std::size_t best = k;
    for (std::size_t row = k + 1; row < n_; ++row) {
      if (std::abs(pivot_column[row]) > std::abs(pivot_column[best])) best = row;
    }
    const double pivot = pivot_column[best];
    if (pivot == 0 || !std::isfinite(pivot)) return false;
    largest_pivot = std::max(largest_pivot, std::abs(pivot));
    least_pivot = std::min(least_pivot, std::abs(pivot));
    if (pivot < 0) determinant_sign_ = -determinant_sign_;
    if (best != k) {
      for (std::size_t column = 0; column < n_; ++column)
        std::swap(entries_[column * n_ + k], entries_[column * n_ + best]);
      std::swap(order_[k], order_[best]);
      determinant_sign_ = -determinant_sign_;
    }
    const double inverse = inverse_pivots_[k] = 1 / pivot;
    for (std::size_t row = k + 1; row < n_; ++row) pivot_column[row] *= inverse;
    for (std::size_t column = k + 1; column < n_; ++column) {
      double* const target = entries_.data() + column * n_;
      const double factor = target[k];
      if (factor == 0) continue;
      for (std::size_t row = k + 1; row < n_; ++row) target[row] -= factor * pivot_column[row];
    }
  }
  pivot_ratio_ = largest_pivot / least_pivot;
  return pivot_ratio_ < kSingular;
}

void BorderedMatrix::solve(std::span<const double> values, double last, std::span<double> result) const {
  if (sparse_) {
    sparse_->solve(values, last, result);
    return;
  }
  for (std::size_t k = 0; k < n_; ++k)
    result[k] = order_[k] + 1 < n_ ? scales_[order_[k]] * values[order_[k]] : last;
  for (std::size_t k = 0; k < n_; ++k) {
    const double* const column = entries_.data() + k * n_;
    const double known = result[k];
    if (known == 0) continue;
    for (std::size_t row = k + 1; row < n_; ++row) result[row] -= known * column[row];
  }
  for (std::size_t k = n_; k-- > 0;) {
    const double* const column = entries_.data() + k * n_;
    const double known = result[k] *= inverse_pivots_[k];
    for (std::size_t row = 0; row < k; ++row) result[row] -= known * column[row];
  }
}

}  // namespace gcslab
