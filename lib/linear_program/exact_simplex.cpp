#include "linear_program/exact_simplex.h"

#include <algorithm>

#include "base/check.h"

namespace gcslab {
namespace {

using Vector = std::vector<Rational>;

LpActivity activity_of(int inward) { return inward < 0 ? LpActivity::at_upper : LpActivity::at_lower; }

}  // namespace

ExactSolution ExactSimplex::minimise(std::span<const LinearTerm> objective, const LpBasis& start,
                                     long step_limit) {
  steps_ = 0;
  step_limit_ = step_limit;
  hold_basis(start);
  const Vector cost = program_.cost(objective);
  const Outcome outcome = solve(cost);
  ExactSolution solution;
  solution.steps = steps_;
  if (outcome == Outcome::done) {
    write(cost, solution);
  } else if (outcome == Outcome::infeasible) {
    solution.status = LpStatus::infeasible;
    solution.multipliers = ray_;
  } else {
    solution.status = LpStatus::iteration_limit;
  }
  return solution;
}

/// Dual steps where the start is optimal but violates something, primal ones where it is feasible but not
/// optimal.
ExactSimplex::Outcome ExactSimplex::solve(const Vector& cost) {
  const bool is_optimal = is_dual_feasible(factorise().solve_transposed(cost));
  const Outcome outcome = mend_violations(is_optimal ? cost : own_objective());
  return outcome == Outcome::done ? walk_down(cost) : outcome;
}

// The start.

void ExactSimplex::hold_basis(const LpBasis& basis) {
  held_.clear();
  const auto add = [&](std::size_t constraint, LpActivity activity) {
    if (activity == LpActivity::free || constraint >= program_.constraints().size()) return;
    const ExactConstraint& data = program_.constraints()[constraint];
    if (!data.lower && !data.upper) return;
    held_.push_back({constraint, inward_for(constraint, activity == LpActivity::at_upper)});
  };
  for (std::size_t j = 0; j < basis.columns.size(); ++j) add(j, basis.columns[j]);
  for (std::size_t i = 0; i < basis.rows.size(); ++i) add(program_.columns() + i, basis.rows[i]);
  complete();
}

/// Lets go of constraints that depend on others and holds columns that nothing determines.
void ExactSimplex::complete() {
  const ExactFactorisation factors = factorise();
  std::vector<Held> independent;
  for (std::size_t slot = 0; slot < held_.size(); ++slot) {
    const auto& dependent = factors.dependent_rows();
    if (std::find(dependent.begin(), dependent.end(), slot) == dependent.end()) {
      independent.push_back(held_[slot]);
    }
  }
  for (const std::size_t column : factors.missing_columns()) {
    independent.push_back({column, inward_for(column, false)});
  }
  held_ = independent;
  GCSLAB_CHECK(held_.size() == program_.columns());
}

int ExactSimplex::inward_for(std::size_t constraint, bool at_upper) const {
  const ExactConstraint& data = program_.constraints()[constraint];
  if (data.is_equation()) return 0;
  return (at_upper && data.upper) || !data.lower ? -1 : 1;
}

// Linear algebra.

ExactFactorisation ExactSimplex::factorise() const {
  std::vector<ExactFactorisation::SparseRow> rows;
  for (const Held& held : held_) rows.push_back(program_.constraints()[held.constraint].normal);
  return ExactFactorisation(std::move(rows), program_.columns());
}

const Rational& ExactSimplex::side(const Held& held) const {
  const ExactConstraint& data = program_.constraints()[held.constraint];
  return held.inward < 0 ? *data.upper : *data.lower;
}

Vector ExactSimplex::dense_normal(std::size_t constraint) const {
  Vector result(program_.columns());
  for (const auto& [column, value] : program_.constraints()[constraint].normal) result[column] = value;
  return result;
}

Vector ExactSimplex::point(const ExactFactorisation& factors) const {
  Vector sides;
  for (const Held& held : held_) sides.push_back(side(held));
  return factors.solve(std::move(sides));
}

/// The sum of the inward normals, for which the vertex is optimal with multipliers 1.
Vector ExactSimplex::own_objective() const {
  Vector result(program_.columns());
  for (const Held& held : held_) {
    for (const auto& [column, value] : program_.constraints()[held.constraint].normal) {
      result[column] += held.inward * value;
    }
  }
  return result;
}

bool ExactSimplex::is_dual_feasible(const Vector& multipliers) const {
  for (std::size_t slot = 0; slot < held_.size(); ++slot) {
    if (held_[slot].inward * sgn(multipliers[slot]) < 0) return false;
  }
  return true;
}

bool ExactSimplex::is_held(std::size_t constraint) const {
  return std::any_of(held_.begin(), held_.end(),
                     [&](const Held& held) { return held.constraint == constraint; });
}

// Dual steps.

ExactSimplex::Outcome ExactSimplex::mend_violations(const Vector& cost) {
  for (; steps_ < step_limit_; ++steps_) {
    const ExactFactorisation factors = factorise();
    int direction = 0;
    const std::size_t violated = first_violated(point(factors), direction);
    if (direction == 0) return Outcome::done;
    const Vector along = factors.solve_transposed(dense_normal(violated));
    const std::size_t slot = slot_to_leave(along, factors.solve_transposed(cost), direction);
    if (slot == held_.size()) {
      note_ray(violated, direction, along);
      return Outcome::infeasible;
    }
    held_[slot] = {violated, inward_for(violated, direction < 0)};
  }
  return Outcome::step_limit;
}

/// The first constraint that the point violates, and the direction that mends it: 1 upward, -1 downward, 0
/// for none.
std::size_t ExactSimplex::first_violated(const Vector& point, int& direction) const {
  const auto& constraints = program_.constraints();
  for (std::size_t k = 0; k < constraints.size(); ++k) {
    const Rational value = constraints[k].value(point);
    if (constraints[k].lower && value < *constraints[k].lower) direction = 1;
    if (constraints[k].upper && value > *constraints[k].upper) direction = -1;
    if (direction != 0) return k;
  }
  return constraints.size();
}

/// The slot whose multiplier first reaches zero; of several, the one with the first constraint (Bland).
std::size_t ExactSimplex::slot_to_leave(const Vector& along, const Vector& multipliers, int direction) const {
  std::size_t best = held_.size();
  Rational best_ratio;
  for (std::size_t slot = 0; slot < held_.size(); ++slot) {
    if (direction * held_[slot].inward * sgn(along[slot]) <= 0) continue;
    const Rational ratio = abs(multipliers[slot]) / abs(along[slot]);
    const bool is_tie = best != held_.size() && ratio == best_ratio;
    if (best != held_.size() && ratio > best_ratio) continue;
    if (is_tie && held_[slot].constraint > held_[best].constraint) continue;
    best = slot;
    best_ratio = ratio;
  }
  return best;
}

void ExactSimplex::note_ray(std::size_t constraint, int direction, const Vector& along) {
  ray_.assign(program_.constraints().size() - program_.columns(), Rational(0));
  const auto add = [&](std::size_t k, const Rational& multiplier) {
    if (k >= program_.columns()) ray_[k - program_.columns()] += multiplier;
  };
  add(constraint, direction);
  for (std::size_t slot = 0; slot < held_.size(); ++slot) {
    add(held_[slot].constraint, -direction * along[slot]);
  }
}

// Primal steps.

ExactSimplex::Outcome ExactSimplex::walk_down(const Vector& cost) {
  for (; steps_ < step_limit_; ++steps_) {
    const ExactFactorisation factors = factorise();
    const std::size_t slot = first_improving(factors.solve_transposed(cost));
    if (slot == held_.size()) return Outcome::done;
    step_along(factors, slot);
  }
  return Outcome::step_limit;
}

/// Of the edges along which the objective falls, that of the first constraint (Bland).
std::size_t ExactSimplex::first_improving(const Vector& multipliers) const {
  std::size_t best = held_.size();
  for (std::size_t slot = 0; slot < held_.size(); ++slot) {
    if (held_[slot].inward * sgn(multipliers[slot]) >= 0) continue;
    if (best == held_.size() || held_[slot].constraint < held_[best].constraint) best = slot;
  }
  return best;
}

void ExactSimplex::step_along(const ExactFactorisation& factors, std::size_t slot) {
  Vector unit(program_.columns());
  unit[slot] = held_[slot].inward;
  const Vector edge = factors.solve(std::move(unit));
  const Vector here = point(factors);
  const auto& constraints = program_.constraints();
  Held blocking{constraints.size(), 0};
  Rational shortest;
  for (std::size_t k = 0; k < constraints.size(); ++k) {
    if (is_held(k) && k != held_[slot].constraint) continue;
    const Rational rate = constraints[k].value(edge);
    const std::optional<Rational>& ahead = rate > 0 ? constraints[k].upper : constraints[k].lower;
    if (rate == 0 || !ahead) continue;
    const Rational step = (*ahead - constraints[k].value(here)) / rate;
    if (blocking.constraint != constraints.size() && step >= shortest) continue;
    shortest = step;
    blocking = {k, inward_for(k, rate > 0)};
  }
  GCSLAB_CHECK(blocking.constraint != constraints.size());  // columns are bounded
  held_[slot] = blocking;
}

void ExactSimplex::write(const Vector& cost, ExactSolution& solution) const {
  const ExactFactorisation factors = factorise();
  const Vector multipliers = factors.solve_transposed(cost);
  const std::size_t rows = program_.constraints().size() - program_.columns();
  solution.status = LpStatus::optimal;
  solution.primal = point(factors);
  solution.multipliers.assign(rows, Rational(0));
  solution.reduced_costs.assign(program_.columns(), Rational(0));
  solution.basis.columns.assign(program_.columns(), LpActivity::free);
  solution.basis.rows.assign(rows, LpActivity::free);
  for (std::size_t slot = 0; slot < held_.size(); ++slot) {
    const std::size_t k = held_[slot].constraint;
    const bool is_column = k < program_.columns();
    (is_column ? solution.reduced_costs[k] : solution.multipliers[k - program_.columns()]) =
        multipliers[slot];
    (is_column ? solution.basis.columns[k] : solution.basis.rows[k - program_.columns()]) =
        activity_of(held_[slot].inward);
  }
  for (std::size_t j = 0; j < cost.size(); ++j) solution.objective += cost[j] * solution.primal[j];
}

}  // namespace gcslab
