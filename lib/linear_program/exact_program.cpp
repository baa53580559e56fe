#include "linear_program/exact_program.h"

#include <cmath>

namespace gcslab {
namespace {

std::optional<Rational> finite(double side) {
  if (!std::isfinite(side)) return std::nullopt;
  return rational_from_double(side);
}

}  // namespace

Rational ExactConstraint::value(const std::vector<Rational>& point) const {
  Rational total = 0;
  for (const auto& [column, coefficient] : normal) total += coefficient * point[column];
  return total;
}

ExactProgram::ExactProgram(const LpModel& model) : columns_(static_cast<std::size_t>(model.columns())) {
  for (int column = 0; column < model.columns(); ++column) {
    const Interval& bounds = model.column(column);
    constraints_.push_back(
        {{{static_cast<std::size_t>(column), Rational(1)}}, finite(bounds.lower), finite(bounds.upper)});
  }
  for (int row = 0; row < model.rows(); ++row) {
    ExactConstraint constraint{{}, finite(model.sides(row).lower), finite(model.sides(row).upper)};
    const auto columns = model.row_columns(row);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const double value = model.row_midpoints(row)[k];
      if (value != 0) {
        constraint.normal[static_cast<std::size_t>(columns[k])] = rational_from_double(value);
      }
    }
    constraints_.push_back(std::move(constraint));
  }
}

std::vector<Rational> ExactProgram::cost(std::span<const LinearTerm> objective) const {
  std::vector<Rational> result(columns_);
  for (const LinearTerm& term : objective) {
    result[static_cast<std::size_t>(term.column)] += rational_from_double(midpoint(term.coefficient));
  }
  return result;
}

}  // namespace gcslab
