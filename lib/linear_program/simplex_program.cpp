#include "linear_program/simplex_program.h"

#include <algorithm>
#include <cmath>
#include <immintrin.h>
#include <limits>

#include "base/random.h"

namespace gcslab {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Sides nearer than this are one: the width of rounding, far below the tolerance of feasibility.
constexpr double kEquationWidth = 1e-10;
/// How far sides are moved: far above the tolerance of feasibility, far below what matters to a bound before
/// it is computed from the true sides.
constexpr double kShift = 1e-6;

constexpr std::size_t kLanes = 16;  // four registers of sums hide the latency of an addition

/// Four rows of one column, which differ: all are read before the first is written.
void add_to_four(double* rows, const int* row, const double* coefficient, double value) {
  const double first = std::fma(coefficient[0], value, rows[row[0]]);
  const double second = std::fma(coefficient[1], value, rows[row[1]]);
  const double third = std::fma(coefficient[2], value, rows[row[2]]);
  const double fourth = std::fma(coefficient[3], value, rows[row[3]]);
  rows[row[0]] = first;
  rows[row[1]] = second;
  rows[row[2]] = third;
  rows[row[3]] = fourth;
}

std::size_t at(int index) { return static_cast<std::size_t>(index); }

double power_of_two_scale(std::span<const double> values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest > 0 ? std::ldexp(1.0, -std::ilogb(largest)) : 1.0;
}

}  // namespace

bool SimplexProgram::load(const LpModel& model) {
  const bool known = structure_ == model.structure();
  if (!known) make_structure(model);
  for (std::size_t j = 0; j < columns_; ++j) {
    const Interval& bounds = model.column(static_cast<int>(j));
    sides_.lower[j] = bounds.lower;
    sides_.upper[j] = bounds.upper;
  }
  for (std::size_t i = 0; i < rows_; ++i) copy_row(model, i);
  move_sides();
  return known;
}

void SimplexProgram::make_structure(const LpModel& model) {
  structure_ = model.structure();
  columns_ = at(model.columns());
  rows_ = at(model.rows());
  stride_ = (constraints() + 3) / 4 * 4;
  sides_.lower.assign(stride_, -kInfinity);
  sides_.upper.assign(stride_, kInfinity);
  is_equation_.assign(stride_, 0);
  row_scale_.assign(rows_, 1.0);
  row_start_.assign(1, 0);
  row_column_.clear();
  for (int i = 0; i < model.rows(); ++i) {
    for (const int column : model.row_columns(i)) row_column_.push_back(column);
    row_start_.push_back(row_column_.size());
  }
  row_value_.assign(row_column_.size(), 0.0);
  moving_.assign(columns_, 0);
  choose_dense_rows();
  sort_by_columns();
  Random random(1, "simplex sides");
  shift_.resize(stride_);
  for (double& shift : shift_) shift = kShift * random.uniform(0.5, 1);
}

/// From an eighth of the entries on a product with all of a dense row costs less than one with its entries.
void SimplexProgram::choose_dense_rows() {
  dense_rows_.clear();
  is_dense_.assign(rows_, 0);
  for (std::size_t i = 0; i < rows_; ++i) {
    if (8 * (row_start_[i + 1] - row_start_[i]) < columns_) continue;
    is_dense_[i] = 1;
    dense_rows_.push_back(i);
  }
  const std::size_t blocks = (dense_rows_.size() + kLanes - 1) / kLanes;
  dense_value_.assign(blocks * columns_ * kLanes, 0.0);
}

/// The place of every entry in the matrix by columns (counting sort), or in the dense one.
void SimplexProgram::sort_by_columns() {
  column_start_.assign(columns_ + 1, 0);
  std::size_t sparse = 0;
  for (std::size_t i = 0; i < rows_; ++i) {
    if (is_dense_[i] != 0) continue;
    sparse += row_start_[i + 1] - row_start_[i];
    for (const int column : part(row_column_, i)) ++column_start_[at(column) + 1];
  }
  for (std::size_t j = 0; j < columns_; ++j) column_start_[j + 1] += column_start_[j];
  column_value_.assign(sparse, 0.0);
  column_row_.assign(sparse, 0);
  place_in_columns_.assign(row_column_.size(), 0);
  std::vector<std::size_t> next(column_start_.begin(), column_start_.end());
  std::size_t dense = 0;
  for (std::size_t i = 0; i < rows_; ++i) {
    for (std::size_t k = row_start_[i]; k < row_start_[i + 1]; ++k) {
      const std::size_t column = at(row_column_[k]);
      if (is_dense_[i] != 0) {
        place_in_columns_[k] = (dense / kLanes * columns_ + column) * kLanes + dense % kLanes;
      } else {
        place_in_columns_[k] = next[column]++;
        column_row_[place_in_columns_[k]] = static_cast<int>(i);
      }
    }
    if (is_dense_[i] != 0) ++dense;
  }
}

void SimplexProgram::copy_row(const LpModel& model, std::size_t row) {
  const auto values = model.row_midpoints(static_cast<int>(row));
  const Interval& sides = model.sides(static_cast<int>(row));
  const double scale = power_of_two_scale(values);
  row_scale_[row] = scale;
  sides_.lower[columns_ + row] = scale * sides.lower;
  sides_.upper[columns_ + row] = scale * sides.upper;
  std::size_t entry = row_start_[row];
  double* by_columns = is_dense_[row] != 0 ? dense_value_.data() : column_value_.data();
  for (const double value : values) {
    row_value_[entry] = scale * value;
    by_columns[place_in_columns_[entry]] = scale * value;
    ++entry;
  }
}

void SimplexProgram::move_sides() {
  moved_ = sides_;
  for (std::size_t k = 0; k < constraints(); ++k) {
    is_equation_[k] = sides_.upper[k] - sides_.lower[k] <= kEquationWidth ? 1 : 0;
    if (is_equation(k)) continue;
    moved_.lower[k] -= shift_[k];
    moved_.upper[k] += shift_[k];
  }
}

void SimplexProgram::add_normal(std::size_t constraint, double factor, std::span<double> vector) const {
  if (constraint < columns_) {
    vector[constraint] += factor;
    return;
  }
  const std::size_t row = constraint - columns_;
  for (std::size_t k = row_start_[row]; k < row_start_[row + 1]; ++k) {
    vector[at(row_column_[k])] += factor * row_value_[k];
  }
}

void SimplexProgram::fill_rows(double* v) const {
  for (std::size_t i = 0; i < rows_; ++i) {
    if (is_dense_[i] != 0) continue;
    double total = 0;
    for (std::size_t k = row_start_[i]; k < row_start_[i + 1]; ++k) {
      total += row_value_[k] * v[row_column_[k]];
    }
    v[columns_ + i] = total;
  }
  find_moving(v);
  fill_dense_rows(v);
}

void SimplexProgram::fill_rows_of_sparse(double* v) const {
  double* rows = v + columns_;
  const int* row = column_row_.data();
  const double* coefficient = column_value_.data();
  std::fill_n(rows, rows_, 0.0);
  find_moving(v);
  for (std::size_t n = 0; n < moving_count_; ++n) {
    const std::size_t j = moving_[n];
    const double value = v[j];
    const std::size_t end = column_start_[j + 1];
    std::size_t k = column_start_[j];
    for (; k + 4 <= end; k += 4) add_to_four(rows, row + k, coefficient + k, value);
    for (; k < end; ++k) rows[row[k]] += coefficient[k] * value;
  }
  fill_dense_rows(v);
}

/// Without a branch, which could not be foretold.
void SimplexProgram::find_moving(const double* v) const {
  moving_count_ = 0;
  for (std::size_t j = 0; j < columns_; ++j) {
    moving_[moving_count_] = j;
    moving_count_ += v[j] != 0 ? 1U : 0U;
  }
}

void SimplexProgram::fill_dense_rows(double* v) const {
  for (std::size_t first = 0; first < dense_rows_.size(); first += kLanes) {
    const double* block = dense_value_.data() + first * columns_;
    __m256d sums[kLanes / 4];
    for (__m256d& sum : sums) sum = _mm256_setzero_pd();
    for (std::size_t n = 0; n < moving_count_; ++n) {
      const std::size_t j = moving_[n];
      const __m256d factor = _mm256_set1_pd(v[j]);
      const double* values = block + j * kLanes;
      for (std::size_t q = 0; q < kLanes / 4; ++q)
        sums[q] = _mm256_fmadd_pd(factor, _mm256_loadu_pd(values + 4 * q), sums[q]);
    }
    alignas(32) double lanes[kLanes];
    for (std::size_t q = 0; q < kLanes / 4; ++q) _mm256_store_pd(lanes + 4 * q, sums[q]);
    const std::size_t count = std::min(kLanes, dense_rows_.size() - first);
    for (std::size_t lane = 0; lane < count; ++lane) v[columns_ + dense_rows_[first + lane]] = lanes[lane];
  }
}

}  // namespace gcslab
