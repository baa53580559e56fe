#include "homotopy/sparse_factors.h"

#include <algorithm>
#include <cmath>

namespace gcslab {

double SparseFactors::Elimination::pivot_ratio() const {
  double largest = 0, least = HUGE_VAL;
  for (Eigen::Index column = 0; column < cols(); ++column) {
    for (SCMatrix::InnerIterator entry(m_Lstore, column); entry; ++entry) {
      if (entry.index() != column) continue;
      largest = std::max(largest, std::abs(entry.value()));
      least = std::min(least, std::abs(entry.value()));
      break;
    }
  }
  return largest / least;
}

SparseFactors::SparseFactors(const SparsityPattern& pattern) : pattern_(&pattern) {
  const auto n = static_cast<Eigen::Index>(pattern.size()) + 1;
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t row = 0; row < pattern.size(); ++row) {
    for (const std::uint32_t column : pattern[row])
      entries.emplace_back(static_cast<int>(column), static_cast<int>(row), 1.0);
  }
  for (Eigen::Index k = 0; k < n; ++k)
    entries.emplace_back(static_cast<int>(k), static_cast<int>(n) - 1, 1.0);
  transposed_.resize(n, n);
  transposed_.setFromTriplets(entries.begin(), entries.end());
  transposed_.makeCompressed();
  lu_.analyzePattern(transposed_);
  right_.resize(n);
}

bool SparseFactors::factorise(const Matrix<double>& jacobian, std::span<const double> border) {
  double* entry = transposed_.valuePtr();
  for (std::size_t row = 0; row < pattern_->size(); ++row) {
    for (const std::uint32_t column : (*pattern_)[row]) *entry++ = jacobian(row, column);
  }
  std::ranges::copy(border, entry);
  if (!transposed_.coeffs().isFinite().all()) return false;
  lu_.factorize(transposed_);
  return lu_.info() == Eigen::Success;
}

void SparseFactors::solve(std::span<const double> values, double last, std::span<double> result) {
  std::ranges::copy(values, right_.data());
  right_[right_.size() - 1] = last;
  const Eigen::VectorXd solution = lu_.transpose().solve(right_);
  std::ranges::copy(solution, result.begin());
}

}  // namespace gcslab
