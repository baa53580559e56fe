#pragma once

// The data of a linear program as our simplex method wants them: columns and rows as one list of constraints
// lower <= v <= upper on v = (x, A x), rows scaled by powers of two to largest coefficients in [1, 2), and
// the matrix by rows and by columns. Rows with many entries, as products of many bound factors have, are kept
// as a dense matrix in blocks of lanes beside the sparse columns of the others.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "linear_program/lp_model.h"

namespace gcslab {

/// Bounds on every constraint: columns first, then rows; padded to a multiple of four by constraints that
/// always hold.
struct ConstraintSides {
  std::vector<double> lower;
  std::vector<double> upper;
};

class SimplexProgram {
 public:
  /// Copies the midpoints. True when the structure is that of the model before.
  bool load(const LpModel& model);

  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return rows_; }
  std::size_t constraints() const { return columns_ + rows_; }
  /// The number of doubles that an array over the constraints needs.
  std::size_t stride() const { return stride_; }

  /// The program's own sides.
  const ConstraintSides& sides() const { return sides_; }
  /// The sides moved outward by small different amounts, so that no more constraints meet in a point than
  /// must (Charnes 1952, perturbation). Equations stay.
  const ConstraintSides& moved_sides() const { return moved_; }
  /// Constraints whose sides agree up to rounding hold on both at once.
  bool is_equation(std::size_t constraint) const { return is_equation_[constraint] != 0; }

  std::span<const int> row_columns(std::size_t row) const { return part(row_column_, row); }
  std::span<const double> row_values(std::size_t row) const { return part(row_value_, row); }
  /// What a multiplier of the scaled row is for the row as given.
  double row_scale(std::size_t row) const { return row_scale_[row]; }

  /// vector += factor * (the normal of a constraint).
  void add_normal(std::size_t constraint, double factor, std::span<double> vector) const;

  /// v[columns + i] = row i times the point v[0 .. columns).
  void fill_rows(double* v) const;
  /// The same for a sparse direction: rows that it does not meet become 0.
  void fill_rows_of_sparse(double* v) const;

 private:
  template <class T>
  std::span<const T> part(const std::vector<T>& all, std::size_t row) const {
    return {all.data() + row_start_[row], row_start_[row + 1] - row_start_[row]};
  }
  void make_structure(const LpModel& model);
  void choose_dense_rows();
  void sort_by_columns();
  void find_moving(const double* v) const;
  void fill_dense_rows(double* v) const;
  void copy_row(const LpModel& model, std::size_t row);
  void move_sides();

  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::size_t stride_ = 0;
  std::uint64_t structure_ = 0;
  ConstraintSides sides_;
  ConstraintSides moved_;
  std::vector<double> shift_;
  std::vector<char> is_equation_;
  std::vector<double> row_scale_;
  std::vector<std::size_t> row_start_;
  std::vector<int> row_column_;
  std::vector<double> row_value_;
  std::vector<char> is_dense_;  ///< one a row
  std::vector<std::size_t>
      place_in_columns_;  ///< of each entry of row_value_ in column_value_ or dense_value_
  std::vector<std::size_t> column_start_;
  std::vector<int> column_row_;
  std::vector<double> column_value_;
  std::vector<std::size_t> dense_rows_;
  std::vector<double> dense_value_;  ///< by blocks of kLanes dense rows, columns, lanes
  // Of the vector worked on: the columns where it is not zero, first.
  mutable std::vector<std::size_t> moving_;
  mutable std::size_t moving_count_ = 0;
};

}  // namespace gcslab
