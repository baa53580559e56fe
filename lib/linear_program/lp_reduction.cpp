#include "linear_program/lp_reduction.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linear_program/exact_bound.h"
#include "linear_program/exact_simplex.h"

namespace gcslab {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// minimise +x for a lower bound, -x for an upper one.
LinearTerm objective_of(const LpGoal& goal) {
  return {goal.column, goal.side == BoundSide::lower ? 1.0 : -1.0};
}

std::vector<double> nearest(const std::vector<Rational>& values) {
  std::vector<double> result;
  for (const Rational& value : values) result.push_back(nearest_double(value));
  return result;
}

double sum_of_magnitudes(std::span<const double> values) {
  double total = 0;
  for (const double value : values) total += std::abs(value);
  return total;
}

}  // namespace

std::vector<LpGoal> both_sides(int count) {
  std::vector<LpGoal> goals;
  for (int column = 0; column < count; ++column) {
    goals.push_back({column, BoundSide::lower});
    goals.push_back({column, BoundSide::upper});
  }
  return goals;
}

const LpReductionResult& LpReduction::reduce(const LpModel& model, std::span<const LpGoal> goals) {
  start(model, goals);
  backend_.load(model);
  int fruitless = 0;
  while (!goals_.empty() && !result_.infeasible) {
    if (options_.fruitless_limit > 0 && fruitless >= options_.fruitless_limit) break;
    const std::size_t place = next_goal();
    const LpGoal goal = goals_[place];
    goals_.erase(goals_.begin() + static_cast<std::ptrdiff_t>(place));
    fruitless = answer(goal) ? 0 : fruitless + 1;
    if (result_.unproved > 0) break;
  }
  if (!result_.infeasible) result_.abandoned += static_cast<long>(goals_.size());
  return result_;
}

void LpReduction::start(const LpModel& model, std::span<const LpGoal> goals) {
  model_ = &model;
  goals_.assign(goals.begin(), goals.end());
  point_.clear();
  result_ = {};
  proofs_.resize(2 * at(model.columns()));
  for (std::vector<double>& proof : proofs_) proof.clear();
  for (int column = 0; column < model.columns(); ++column) result_.bounds.push_back(model.column(column));
}

/// How far a point is from the bound of a goal.
double LpReduction::distance(const LpGoal& goal, std::span<const double> point) const {
  const Interval& bounds = model_->column(goal.column);
  const double value = point[at(goal.column)];
  return goal.side == BoundSide::lower ? value - bounds.lower : bounds.upper - value;
}

std::size_t LpReduction::next_goal() const {
  if (!options_.nearest_first || point_.empty()) return 0;
  const auto nearer = [&](const LpGoal& a, const LpGoal& b) {
    return distance(a, point_) < distance(b, point_);
  };
  return static_cast<std::size_t>(std::min_element(goals_.begin(), goals_.end(), nearer) - goals_.begin());
}

void LpReduction::drop_goals_touched_by(std::span<const double> point) {
  const auto touched = [&](const LpGoal& goal) {
    const Interval& bounds = model_->column(goal.column);
    return distance(goal, point) <= options_.negligible_gain * (bounds.upper - bounds.lower);
  };
  const auto kept = std::remove_if(goals_.begin(), goals_.end(), touched);
  result_.skipped += goals_.end() - kept;
  goals_.erase(kept, goals_.end());
}

/// Solves one program; true when it moved its bound by more than is negligible, or settled infeasibility.
bool LpReduction::answer(const LpGoal& goal) {
  const LinearTerm objective = objective_of(goal);
  const LpSolution& solution = backend_.minimise({&objective, 1});
  ++result_.solved;
  result_.iterations += solution.iterations;
  if (solution.status == LpStatus::infeasible) {
    settle_infeasible(solution);
    return result_.infeasible;
  }
  const bool is_optimal = solution.status == LpStatus::optimal;
  const bool has_multipliers = is_optimal || solution.status == LpStatus::iteration_limit;
  if (!is_optimal && !(has_multipliers && options_.safety == LpSafety::dual)) {
    ++result_.abandoned;
    return false;
  }
  const bool gained = move_bound(goal, bound_from(solution, objective));
  if (is_optimal) {
    point_ = solution.primal;
    drop_goals_touched_by(point_);
  }
  return gained;
}

/// A lower bound of the objective, and in multipliers_ what proves it.
double LpReduction::bound_from(const LpSolution& solution, const LinearTerm& objective) {
  multipliers_ = solution.multipliers;
  switch (options_.safety) {
    case LpSafety::dual:
      return safe_bound_.lower(*model_, {&objective, 1}, multipliers_);
    case LpSafety::exact:
      return exact_bound_from(solution.basis, objective);
    case LpSafety::tolerance: {
      const Interval& bounds = model_->column(objective.column);
      return solution.objective - options_.tolerance * (bounds.upper - bounds.lower);
    }
    case LpSafety::unprotected:
      break;
  }
  return solution.objective;
}

double LpReduction::exact_bound_from(const LpBasis& basis, const LinearTerm& objective) {
  const ExactSolution exact = ExactSimplex(*model_).minimise({&objective, 1}, basis);
  if (exact.status != LpStatus::optimal) return -kInfinity;
  multipliers_ = nearest(exact.multipliers);
  return rounded_down(exact_lower_bound(*model_, {&objective, 1}, exact.multipliers));
}

/// True when the bound moved by more than is negligible, or crossed the other one.
bool LpReduction::move_bound(const LpGoal& goal, double value) {
  Interval& bounds = result_.bounds[at(goal.column)];
  const bool is_lower = goal.side == BoundSide::lower;
  const double bound = is_lower ? value : -value;
  const double gain = is_lower ? bound - bounds.lower : bounds.upper - bound;
  if (!(gain > 0)) return false;
  const bool crosses = is_lower ? bound > bounds.upper : bound < bounds.lower;
  if (crosses) {
    settle_crossing(goal);
    return result_.infeasible;
  }
  (is_lower ? bounds.lower : bounds.upper) = bound;
  const Interval& before = model_->column(goal.column);
  keep_proof(goal);
  return gain > options_.negligible_gain * (before.upper - before.lower);
}

std::size_t LpReduction::place_of(const LpGoal& goal) {
  return 2 * at(goal.column) + (goal.side == BoundSide::lower ? 0 : 1);
}

void LpReduction::keep_proof(const LpGoal& goal) {
  if (!is_rigorous()) return;
  proofs_[place_of(goal)] = multipliers_;
  if (!options_.keep_certificates) return;
  const LinearTerm objective = objective_of(goal);
  const double value = safe_bound_.lower(*model_, {&objective, 1}, multipliers_);
  BoundCertificate certificate{goal, goal.side == BoundSide::lower ? value : -value, {}};
  for (std::size_t row = 0; row < multipliers_.size(); ++row) {
    if (multipliers_[row] != 0) certificate.multipliers.push_back({static_cast<int>(row), multipliers_[row]});
  }
  result_.certificates.push_back(std::move(certificate));
}

bool LpReduction::is_rigorous() const {
  return options_.safety == LpSafety::dual || options_.safety == LpSafety::exact;
}

void LpReduction::settle_infeasible(const LpSolution& solution) {
  switch (options_.safety) {
    case LpSafety::dual:
      return accept_ray(solution.ray);
    case LpSafety::exact: {
      const ExactSolution exact = ExactSimplex(*model_).minimise({}, solution.basis);
      if (exact.status == LpStatus::infeasible) return accept_exact_ray(exact.multipliers);
      ++result_.unproved;
      return;
    }
    case LpSafety::tolerance:
      result_.infeasible = solution.ray.empty() || unsafe_bound(*model_, {}, solution.ray) >
                                                       options_.tolerance * sum_of_magnitudes(solution.ray);
      if (!result_.infeasible) ++result_.unproved;
      return;
    case LpSafety::unprotected:
      result_.infeasible = true;
  }
}

void LpReduction::accept_ray(const std::vector<double>& ray) {
  result_.infeasible = !ray.empty() && safe_bound_.proves_infeasible(*model_, ray);
  if (result_.infeasible) {
    result_.ray = ray;
  } else {
    ++result_.unproved;
  }
}

void LpReduction::accept_exact_ray(const std::vector<Rational>& ray) {
  if (exact_lower_bound(*model_, {}, ray) <= 0) {
    ++result_.unproved;
    return;
  }
  result_.infeasible = true;
  const std::vector<double> rounded = nearest(ray);
  if (safe_bound_.proves_infeasible(*model_, rounded)) result_.ray = rounded;
}

/// x_j >= a by one set of multipliers and x_j <= b < a by another, or by the column's own bound: their sum is
/// a ray.
void LpReduction::settle_crossing(const LpGoal& goal) {
  if (!is_rigorous()) {
    result_.infeasible = true;
    return;
  }
  const LpGoal other{goal.column, goal.side == BoundSide::lower ? BoundSide::upper : BoundSide::lower};
  const std::vector<double>& opposite = proofs_[place_of(other)];
  for (std::size_t row = 0; row < opposite.size(); ++row) multipliers_[row] += opposite[row];
  accept_ray(multipliers_);
}

}  // namespace gcslab
