#include "linear_program/exact_factorisation.h"

#include <limits>

#include "base/check.h"

namespace gcslab {

ExactFactorisation::ExactFactorisation(std::vector<SparseRow> rows, std::size_t columns)
    : columns_(columns), rows_(std::move(rows)), column_count_(columns, 0) {
  for (const SparseRow& row : rows_) {
    for (const auto& entry : row) ++column_count_[entry.first];
  }
  std::vector<char> is_done(rows_.size(), 0);
  std::vector<char> has_pivot(columns, 0);
  std::size_t row = 0;
  std::size_t column = 0;
  while (choose_pivot(is_done, row, column)) {
    is_done[row] = 1;
    has_pivot[column] = 1;
    steps_.push_back(eliminate(is_done, row, column));
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (!is_done[i]) dependent_rows_.push_back(i);
  }
  for (std::size_t j = 0; j < columns; ++j) {
    if (!has_pivot[j]) missing_columns_.push_back(j);
  }
}

bool ExactFactorisation::choose_pivot(const std::vector<char>& is_done, std::size_t& row,
                                      std::size_t& column) const {
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (std::size_t i = 0; i < rows_.size() && least > 0; ++i) {
    if (is_done[i]) continue;
    for (const auto& entry : rows_[i]) {
      const std::size_t products = (rows_[i].size() - 1) * (column_count_[entry.first] - 1);
      if (products >= least) continue;
      least = products;
      row = i;
      column = entry.first;
    }
  }
  return least != std::numeric_limits<std::size_t>::max();
}

ExactFactorisation::Step ExactFactorisation::eliminate(const std::vector<char>& is_done, std::size_t row,
                                                       std::size_t column) {
  Step step{row, column, rows_[row].at(column), {}, {}};
  for (const auto& entry : rows_[row]) {
    --column_count_[entry.first];
    if (entry.first != column) step.upper.push_back(entry);
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (is_done[i]) continue;
    const auto found = rows_[i].find(column);
    if (found == rows_[i].end()) continue;
    const Rational multiple = found->second / step.pivot;
    rows_[i].erase(found);
    --column_count_[column];
    for (const auto& [j, value] : step.upper) {
      const auto [place, is_new] = rows_[i].try_emplace(j, 0);
      if (is_new) ++column_count_[j];
      place->second -= multiple * value;
      if (place->second != 0) continue;
      rows_[i].erase(place);
      --column_count_[j];
    }
    step.lower.emplace_back(i, multiple);
  }
  return step;
}

std::vector<Rational> ExactFactorisation::solve(std::vector<Rational> right_side) const {
  GCSLAB_CHECK(is_regular() && right_side.size() == columns_);
  for (const Step& step : steps_) {
    for (const auto& [row, multiple] : step.lower) right_side[row] -= multiple * right_side[step.row];
  }
  std::vector<Rational> x(columns_);
  for (auto step = steps_.rbegin(); step != steps_.rend(); ++step) {
    Rational rest = right_side[step->row];
    for (const auto& [column, value] : step->upper) rest -= value * x[column];
    x[step->column] = rest / step->pivot;
  }
  return x;
}

std::vector<Rational> ExactFactorisation::solve_transposed(std::vector<Rational> right_side) const {
  GCSLAB_CHECK(is_regular() && right_side.size() == columns_);
  std::vector<Rational> y(columns_);
  for (const Step& step : steps_) {
    y[step.row] = right_side[step.column] / step.pivot;
    for (const auto& [column, value] : step.upper) right_side[column] -= value * y[step.row];
  }
  for (auto step = steps_.rbegin(); step != steps_.rend(); ++step) {
    for (const auto& [row, multiple] : step->lower) y[step->row] -= multiple * y[row];
  }
  return y;
}

}  // namespace gcslab
