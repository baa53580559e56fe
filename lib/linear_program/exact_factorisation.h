#pragma once

// Sparse Gaussian elimination over the rationals: solves with a square matrix and its transpose, exactly.
//
// Pivots are chosen by Markowitz's rule (1957), the fewest products (row count - 1)(column count - 1), so
// that rows of two or three coefficients are done before the few dense ones.

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "interval/rational.h"

namespace gcslab {

class ExactFactorisation {
 public:
  using SparseRow = std::map<std::size_t, Rational>;  ///< column to coefficient, without zeros

  /// Eliminates with the rows of a matrix of `columns` columns; rows that depend on others are left out.
  ExactFactorisation(std::vector<SparseRow> rows, std::size_t columns);

  bool is_regular() const { return steps_.size() == columns_ && dependent_rows_.empty(); }
  const std::vector<std::size_t>& dependent_rows() const { return dependent_rows_; }
  /// Columns without a pivot: unit rows there would complete the matrix.
  const std::vector<std::size_t>& missing_columns() const { return missing_columns_; }

  /// x with N x = b; the matrix must be regular.
  std::vector<Rational> solve(std::vector<Rational> right_side) const;
  /// y with N^T y = c.
  std::vector<Rational> solve_transposed(std::vector<Rational> right_side) const;

 private:
  struct Step {
    std::size_t row;
    std::size_t column;
    Rational pivot;
    std::vector<std::pair<std::size_t, Rational>> upper;  ///< the rest of the pivot row
    std::vector<std::pair<std::size_t, Rational>> lower;  ///< rows and the multiples taken from them
  };

  bool choose_pivot(const std::vector<char>& is_done, std::size_t& row, std::size_t& column) const;
  Step eliminate(const std::vector<char>& is_done, std::size_t row, std::size_t column);

  std::size_t columns_;
  std::vector<SparseRow> rows_;
  std::vector<std::size_t> column_count_;
  std::vector<Step> steps_;
  std::vector<std::size_t> dependent_rows_;
  std::vector<std::size_t> missing_columns_;
};

}  // namespace gcslab
