#include "verifier/real_matrix.h"

#include <algorithm>

namespace gcslab::verifier {
namespace {

std::size_t largest_pivot(const RealMatrix& matrix, std::size_t column) {
  std::size_t best = column;
  for (std::size_t i = column + 1; i < matrix.size(); ++i) {
    if (mpfr_cmpabs(matrix[i][column].get(), matrix[best][column].get()) > 0) best = i;
  }
  return best;
}

/// row -= factor * other.
void subtract(std::vector<Real>& row, const Real& factor, const std::vector<Real>& other) {
  Real product;
  for (std::size_t j = 0; j < row.size(); ++j) {
    if (mpfr_zero_p(other[j].get()) != 0) continue;
    mpfr_mul(product.get(), factor.get(), other[j].get(), MPFR_RNDN);
    mpfr_sub(row[j].get(), row[j].get(), product.get(), MPFR_RNDN);
  }
}

/// Rounds the numbers of a row to multiples of 2^-150 times the largest one. Numbers that ought to be small
/// integers or 0 become so; linear equations then leave no residual, and exact roots stay exact.
void settle(std::vector<Real>& row) {
  mpfr_exp_t largest = mpfr_get_emin();
  for (const Real& x : row) {
    if (mpfr_regular_p(x.get()) != 0) largest = std::max(largest, mpfr_get_exp(x.get()));
  }
  for (Real& x : row) {
    if (mpfr_regular_p(x.get()) == 0) continue;
    mpfr_mul_2si(x.get(), x.get(), 150 - largest, MPFR_RNDN);
    mpfr_rint(x.get(), x.get(), MPFR_RNDN);
    mpfr_mul_2si(x.get(), x.get(), largest - 150, MPFR_RNDN);
  }
}

}  // namespace

bool invert(RealMatrix matrix, RealMatrix& inverse) {
  const std::size_t n = matrix.size();
  inverse.assign(n, std::vector<Real>(n));
  for (std::size_t i = 0; i < n; ++i) inverse[i][i] = Real(1);
  for (std::size_t column = 0; column < n; ++column) {
    const std::size_t pivot = largest_pivot(matrix, column);
    std::swap(matrix[column], matrix[pivot]);
    std::swap(inverse[column], inverse[pivot]);
    if (mpfr_regular_p(matrix[column][column].get()) == 0) return false;
    for (std::size_t i = 0; i < n; ++i) {
      if (i == column || mpfr_zero_p(matrix[i][column].get()) != 0) continue;
      Real factor;
      mpfr_div(factor.get(), matrix[i][column].get(), matrix[column][column].get(), MPFR_RNDN);
      subtract(matrix[i], factor, matrix[column]);
      subtract(inverse[i], factor, inverse[column]);
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (Real& x : inverse[i]) mpfr_div(x.get(), x.get(), matrix[i][i].get(), MPFR_RNDN);
    settle(inverse[i]);
  }
  return true;
}

RealMatrix middles(const RangeMatrix& matrix) {
  RealMatrix result(matrix.size());
  for (std::size_t k = 0; k < matrix.size(); ++k) {
    for (const Range& entry : matrix[k]) result[k].push_back(middle(entry));
  }
  return result;
}

bool is_regular(const RealMatrix& matrix, const RealMatrix& inverse) {
  const std::size_t n = matrix.size();
  for (std::size_t i = 0; i < n; ++i) {
    Range norm;
    for (std::size_t j = 0; j < n; ++j) {
      Range entry(i == j ? 1.0 : 0.0);
      for (std::size_t k = 0; k < n; ++k) entry = entry - Range(inverse[i][k]) * Range(matrix[k][j]);
      norm = norm + abs(entry);
    }
    if (mpfr_cmp_ui(norm.upper(), 1) >= 0) return false;
  }
  return true;
}

}  // namespace gcslab::verifier
