#pragma once

// Linear programs over a box with interval data: what the polytope of a box is handed over as.
//
// Columns x_j have finite bounds. A row has sparse interval coefficients A_i and sides [L_i, U_i], either of
// which may be infinite. A point x of the column box SATISFIES row i when L_i <= a.x <= U_i for SOME a in
// A_i, and is feasible when it satisfies every row, each with a choice of its own. So data that are known up
// to rounding are written as intervals around the true ones, and every rigorous statement of this library
// ("no feasible point", "c.x >= 0.3 on the feasible points") holds for the true program too. Numeric solvers
// see the midpoints of the coefficients, which prove nothing.
//
// Made to be refilled: the next box of a search has other numbers at the same places, and the set_ functions
// write them without allocating.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "interval/interval.h"

namespace gcslab {

/// coefficient * x_column.
struct LinearTerm {
  int column;
  Interval coefficient;
};

class LpModel {
 public:
  /// Takes away all rows and columns.
  void clear();
  /// Returns the new column's index. The bounds must be finite and in order.
  int add_column(const Interval& bounds);
  /// Returns the new row's index. Columns must exist and occur once; coefficients must be bounded.
  int add_row(std::span<const LinearTerm> terms, const Interval& sides);

  void set_column(int column, const Interval& bounds);
  void set_sides(int row, const Interval& sides);
  /// New coefficients for the columns that the row has, in the order of add_row; zeros are allowed.
  void set_coefficients(int row, std::span<const Interval> coefficients);

  int columns() const { return static_cast<int>(columns_.size()); }
  int rows() const { return static_cast<int>(sides_.size()); }
  const Interval& column(int column) const { return columns_[at(column)]; }
  const Interval& sides(int row) const { return sides_[at(row)]; }
  std::span<const int> row_columns(int row) const { return part(column_of_entry_, row); }
  std::span<const Interval> row_coefficients(int row) const { return part(coefficients_, row); }
  std::span<const double> row_midpoints(int row) const { return part(midpoints_, row); }
  std::size_t entries() const { return column_of_entry_.size(); }
  /// Every coefficient is one number: then the midpoints are the model.
  bool is_thin() const;

  /// A number that only models with the same columns, rows and places of coefficients share.
  std::uint64_t structure() const { return structure_; }

 private:
  static std::size_t at(int index) { return static_cast<std::size_t>(index); }
  template <class T>
  std::span<const T> part(const std::vector<T>& all, int row) const {
    return {all.data() + row_start_[at(row)], row_start_[at(row) + 1] - row_start_[at(row)]};
  }
  void write_coefficient(std::size_t entry, const Interval& coefficient);
  void check_columns_occur_once(std::span<const LinearTerm> terms);

  std::vector<Interval> columns_;
  std::vector<Interval> sides_;
  std::vector<std::size_t> row_start_{0};
  std::vector<int> column_of_entry_;
  std::vector<Interval> coefficients_;
  std::vector<double> midpoints_;
  std::vector<int> last_row_of_column_;  ///< the row that a column was last seen in
  std::uint64_t structure_ = 0;
};

}  // namespace gcslab
