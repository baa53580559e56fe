#include "linear_program/lp_model.h"

#include <algorithm>
#include <atomic>

#include "base/check.h"

namespace gcslab {
namespace {

std::uint64_t fresh_structure() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace

void LpModel::clear() {
  columns_.clear();
  sides_.clear();
  row_start_.assign(1, 0);
  column_of_entry_.clear();
  coefficients_.clear();
  midpoints_.clear();
  last_row_of_column_.clear();
  structure_ = fresh_structure();
}

int LpModel::add_column(const Interval& bounds) {
  GCSLAB_CHECK(is_bounded(bounds));
  columns_.push_back(bounds);
  last_row_of_column_.push_back(-1);
  structure_ = fresh_structure();
  return columns() - 1;
}

int LpModel::add_row(std::span<const LinearTerm> terms, const Interval& sides) {
  check_columns_occur_once(terms);
  sides_.emplace_back();
  set_sides(rows() - 1, sides);
  for (const LinearTerm& term : terms) {
    column_of_entry_.push_back(term.column);
    coefficients_.emplace_back();
    midpoints_.emplace_back();
    write_coefficient(entries() - 1, term.coefficient);
  }
  row_start_.push_back(entries());
  structure_ = fresh_structure();
  return rows() - 1;
}

void LpModel::check_columns_occur_once(std::span<const LinearTerm> terms) {
  for (const LinearTerm& term : terms) {
    GCSLAB_CHECK(term.column >= 0 && term.column < columns());
    GCSLAB_CHECK(last_row_of_column_[at(term.column)] != rows());
    last_row_of_column_[at(term.column)] = rows();
  }
}

void LpModel::set_column(int column, const Interval& bounds) {
  GCSLAB_CHECK(is_bounded(bounds));
  columns_[at(column)] = bounds;
}

void LpModel::set_sides(int row, const Interval& sides) {
  GCSLAB_CHECK(!is_empty(sides));
  sides_[at(row)] = sides;
}

void LpModel::set_coefficients(int row, std::span<const Interval> coefficients) {
  GCSLAB_CHECK(coefficients.size() == row_columns(row).size());
  std::size_t entry = row_start_[at(row)];
  for (const Interval& coefficient : coefficients) write_coefficient(entry++, coefficient);
}

void LpModel::write_coefficient(std::size_t entry, const Interval& coefficient) {
  GCSLAB_CHECK(is_bounded(coefficient));
  coefficients_[entry] = coefficient;
  midpoints_[entry] = is_singleton(coefficient) ? coefficient.lower : midpoint(coefficient);
}

bool LpModel::is_thin() const {
  return std::all_of(coefficients_.begin(), coefficients_.end(),
                     [](const Interval& coefficient) { return is_singleton(coefficient); });
}

}  // namespace gcslab
