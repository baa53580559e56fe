#include "linear_program/lp_backend.h"

#include <algorithm>

#include "base/check.h"
#include "interval/rounding.h"
#include "linear_program/multiplier.h"

namespace gcslab {

std::string_view name_of(LpStatus status) {
  switch (status) {
    case LpStatus::optimal:
      return "optimal";
    case LpStatus::infeasible:
      return "infeasible";
    case LpStatus::iteration_limit:
      return "iteration_limit";
    case LpStatus::failed:
      break;
  }
  return "failed";
}

void LpBackend::check_thread_and_rounding() const {
  GCSLAB_CHECK(std::this_thread::get_id() == owner_);
  GCSLAB_CHECK(rounding_is_nearest());
}

void LpBackend::load(const LpModel& model) {
  check_thread_and_rounding();
  const NearestRounding nearest;
  columns_ = model.columns();
  load_model(model);
  GCSLAB_CHECK(rounding_is_nearest());
}

const LpSolution& LpBackend::minimise(std::span<const LinearTerm> objective) {
  check_thread_and_rounding();
  const NearestRounding nearest;
  for (const LinearTerm& term : objective) {
    GCSLAB_CHECK(term.column >= 0 && term.column < columns_ && is_bounded(term.coefficient));
  }
  solution_.status = LpStatus::failed;
  solution_.ray.clear();
  solution_.iterations = 0;
  solve(objective, solution_);
  GCSLAB_CHECK(rounding_is_nearest());
  return solution_;
}

double unsafe_bound(const LpModel& model, std::span<const LinearTerm> objective,
                    std::span<const double> multipliers) {
  GCSLAB_CHECK(multipliers.size() == static_cast<std::size_t>(model.rows()));
  std::vector<double> rest(static_cast<std::size_t>(model.columns()), 0.0);
  for (const LinearTerm& term : objective) {
    rest[static_cast<std::size_t>(term.column)] += midpoint(term.coefficient);
  }
  double value = 0;
  for (int row = 0; row < model.rows(); ++row) {
    const double multiplier = usable_multiplier(multipliers[static_cast<std::size_t>(row)], model.sides(row));
    if (multiplier == 0) continue;
    value += multiplier * held_side(multiplier, model.sides(row));
    const auto columns = model.row_columns(row);
    const auto midpoints = model.row_midpoints(row);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      rest[static_cast<std::size_t>(columns[k])] -= multiplier * midpoints[k];
    }
  }
  for (int column = 0; column < model.columns(); ++column) {
    const double slope = rest[static_cast<std::size_t>(column)];
    value += slope * (slope > 0 ? model.column(column).lower : model.column(column).upper);
  }
  return value;
}

std::vector<double> single_row_ray(const LpModel& model) {
  double largest_miss = 0;
  int missed = -1;
  for (int row = 0; row < model.rows(); ++row) {
    double least = 0;
    double largest = 0;
    for (std::size_t k = 0; k < model.row_columns(row).size(); ++k) {
      const Interval& bounds = model.column(model.row_columns(row)[k]);
      const double coefficient = model.row_midpoints(row)[k];
      least += std::min(coefficient * bounds.lower, coefficient * bounds.upper);
      largest += std::max(coefficient * bounds.lower, coefficient * bounds.upper);
    }
    const double miss = std::max(model.sides(row).lower - largest, least - model.sides(row).upper);
    if (miss <= largest_miss) continue;
    largest_miss = miss;
    missed = row;
  }
  if (missed < 0) return {};
  std::vector<double> ray(static_cast<std::size_t>(model.rows()), 0.0);
  ray[static_cast<std::size_t>(missed)] = 1;
  return ray;
}

void orient_ray(const LpModel& model, std::vector<double>& ray) {
  if (ray.empty()) return;
  std::vector<double> negated(ray.size());
  std::transform(ray.begin(), ray.end(), negated.begin(), [](double value) { return -value; });
  if (unsafe_bound(model, {}, negated) > unsafe_bound(model, {}, ray)) ray.swap(negated);
}

}  // namespace gcslab
