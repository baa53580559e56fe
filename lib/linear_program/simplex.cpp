#include "linear_program/simplex.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gcslab {
namespace {

constexpr double kFeasibility = 1e-9;
constexpr double kOptimality = 1e-10;
/// Smaller rates are noise.
constexpr double kSmallestPivot = 1e-8;
/// How far two ways to compute a pivot may differ, relative to it, before the edges count as worn out.
constexpr double kPivotAgreement = 1e-6;
/// Residuals of multipliers below this are as good as none.
constexpr double kExact = 1e-15;
constexpr int kAttempts = 4;
constexpr std::size_t kExchangesBeforeRebuild = 2000;

}  // namespace

void Simplex::load(const LpModel& model) {
  const bool known = program_.load(model);
  feasible_ = false;
  infeasible_ = false;
  cost_.assign(program_.columns(), 0.0);
  rate_.assign(program_.stride(), 0.0);
  residual_.assign(program_.columns(), 0.0);
  if (known && !options_.cold) {
    vertex_.rebuild(program_);
  } else {
    start_over();
  }
}

void Simplex::start_over() {
  feasible_ = false;
  vertex_.start_at_corner(program_);
  const std::size_t slots = vertex_.edges().stride();
  multiplier_.assign(slots, 0.0);
  along_.assign(slots, 0.0);
  edge_.assign(slots, 0.0);
}

void Simplex::minimise(std::span<const LinearTerm> objective, LpSolution& solution) {
  iterations_ = 0;
  std::fill(cost_.begin(), cost_.end(), 0.0);
  for (const LinearTerm& term : objective) {
    cost_[static_cast<std::size_t>(term.column)] = midpoint(term.coefficient);
  }
  if (options_.cold && !infeasible_) start_over();
  Walk outcome = infeasible_ ? Walk::infeasible : solve_moved();
  if (outcome == Walk::done) {
    outcome = solve_true(solution);
  } else if (outcome == Walk::iteration_limit) {
    write_vertex(solution);
  }
  infeasible_ = outcome == Walk::infeasible;
  if (infeasible_) {
    solution.ray = ray_;
    solution.basis = ray_basis_;
  }
  solution.status = status_of(outcome);
  solution.iterations = iterations_;
}

LpStatus Simplex::status_of(Walk outcome) {
  switch (outcome) {
    case Walk::done:
      return LpStatus::optimal;
    case Walk::infeasible:
      return LpStatus::infeasible;
    case Walk::iteration_limit:
      return LpStatus::iteration_limit;
    case Walk::inaccurate:
      break;
  }
  return LpStatus::failed;
}

/// A vertex on moved sides, whatever the objective: the objective is chosen so that the vertex there is
/// optimal.
Simplex::Walk Simplex::reach_feasibility() {
  vertex_.place(program_, program_.moved_sides());
  set_random_multipliers();
  const Walk outcome = mend_violations(program_.moved_sides());
  feasible_ = outcome == Walk::done;
  return outcome;
}

/// The optimum on moved sides. Edges that have become inaccurate are computed anew.
Simplex::Walk Simplex::solve_moved() {
  Walk outcome = Walk::inaccurate;
  for (int attempt = 0; attempt < kAttempts && outcome == Walk::inaccurate; ++attempt) {
    if (attempt > 0 || vertex_.exchanges_since_rebuild() > kExchangesBeforeRebuild) {
      vertex_.rebuild(program_);
      feasible_ = false;
    }
    if (!feasible_) pool_.clear();
    outcome = feasible_ ? Walk::done : reach_feasibility();
    if (outcome != Walk::done) continue;
    if (const SimplexVertex* nearer = pool_.best(cost_, cost_at(vertex_, cost_))) vertex_ = *nearer;
    set_multipliers();
    outcome = walk_along_edges(program_.moved_sides());
    if (outcome == Walk::done && !options_.cold) pool_.remember(vertex_);
  }
  return outcome;
}

/// The optimum on true sides near the vertex found, which is still optimal for the objective if feasible. The
/// walk goes on from the vertex on moved sides.
Simplex::Walk Simplex::solve_true(LpSolution& solution) {
  const ConstraintSides& sides = program_.sides();
  walk_values_.assign(vertex_.values(), vertex_.values() + program_.stride());
  vertex_.place(program_, sides);
  if (violation(sides).amount <= kFeasibility) {
    refine(cost_, multiplier_);
    write_vertex(solution);
    vertex_.set_values(walk_values_);
    return Walk::done;
  }
  walk_ = vertex_;
  walk_multiplier_ = multiplier_;
  const Walk outcome = mend_violations(sides);
  if (outcome != Walk::infeasible) {
    refine(cost_, multiplier_);
    write_vertex(solution);
  }
  std::swap(vertex_, walk_);
  std::swap(multiplier_, walk_multiplier_);
  vertex_.set_values(walk_values_);
  return outcome == Walk::inaccurate ? Walk::iteration_limit : outcome;
}

simplex_kernel::Violation Simplex::violation(const ConstraintSides& sides) const {
  return simplex_kernel::largest_violation(vertex_.values(), sides.lower.data(), sides.upper.data(),
                                           program_.stride());
}

// Primal: from vertex to vertex, downhill.

Simplex::Walk Simplex::walk_along_edges(const ConstraintSides& sides) {
  while (iterations_ < options_.iteration_limit) {
    const std::size_t slot = steepest_edge();
    if (slot == vertex_.slots()) return Walk::done;
    const Walk outcome = step_along_edge(slot, sides);
    if (outcome != Walk::done) return outcome;
    ++iterations_;
  }
  return Walk::iteration_limit;
}

/// The edge along which the objective falls most for its length; slots() when there is none.
std::size_t Simplex::steepest_edge() const {
  return simplex_kernel::steepest(vertex_.inward(), multiplier_.data(), vertex_.edges().squared_lengths(),
                                  vertex_.slots(), kOptimality);
}

Simplex::Walk Simplex::step_along_edge(std::size_t slot, const ConstraintSides& sides) {
  const double inward = vertex_.inward(slot);
  vertex_.follow_edge(program_, slot, rate_.data());
  std::copy_n(rate_.data(), vertex_.slots(), edge_.data());
  if (inward < 0) {
    for (double& rate : rate_) rate = -rate;
  }
  const auto blocking =
      simplex_kernel::ratio_test(vertex_.values(), rate_.data(), sides.lower.data(), sides.upper.data(),
                                 rate_.size(), kFeasibility, kSmallestPivot);
  if (!std::isfinite(blocking.step)) return Walk::inaccurate;
  if (blocking.constraint == vertex_.constraint(slot)) {
    vertex_.advance(rate_.data(), blocking.step);
    vertex_.flip(slot, sides);
    return Walk::done;
  }
  const double rate = rate_[blocking.constraint];
  vertex_.along_edges(program_, blocking.constraint, along_.data());
  if (!pivot_agrees(slot, inward * rate)) return Walk::inaccurate;
  vertex_.advance(rate_.data(), blocking.step);
  exchange(slot, blocking.constraint, rate < 0 ? 1 : -1, sides);
  return Walk::done;
}

bool Simplex::pivot_agrees(std::size_t slot, double rate) const {
  return std::abs(along_[slot] - rate) <= kPivotAgreement * std::abs(rate);
}

void Simplex::exchange(std::size_t slot, std::size_t constraint, double inward,
                       const ConstraintSides& sides) {
  const double multiplier = multiplier_[slot] / along_[slot];
  for (std::size_t t = 0; t < vertex_.slots(); ++t) multiplier_[t] -= multiplier * along_[t];
  multiplier_[slot] = multiplier;
  vertex_.exchange(program_, slot, constraint, inward, sides, along_.data(), edge_.data());
}

// Dual: from an optimum that violates constraints to one that does not.

Simplex::Walk Simplex::mend_violations(const ConstraintSides& sides) {
  while (iterations_ < options_.iteration_limit) {
    const simplex_kernel::Violation worst = violation(sides);
    if (worst.amount <= kFeasibility) return Walk::done;
    if (vertex_.slot_of(worst.constraint) != SimplexVertex::kFree) return Walk::inaccurate;
    const Walk outcome = mend(worst.constraint, sides);
    if (outcome != Walk::done) return outcome;
    ++iterations_;
  }
  return Walk::iteration_limit;
}

Simplex::Walk Simplex::mend(std::size_t constraint, const ConstraintSides& sides) {
  const double value = vertex_.values()[constraint];
  const double direction = value < sides.lower[constraint] ? 1 : -1;
  const double side = direction > 0 ? sides.lower[constraint] : sides.upper[constraint];
  vertex_.along_edges(program_, constraint, along_.data());
  const std::size_t slot = slot_to_leave(direction);
  if (slot == vertex_.slots()) {
    note_ray(constraint, direction);
    return Walk::infeasible;
  }
  vertex_.follow_edge(program_, slot, rate_.data());
  std::copy_n(rate_.data(), vertex_.slots(), edge_.data());
  if (!pivot_agrees(slot, rate_[constraint])) return Walk::inaccurate;
  vertex_.advance(rate_.data(), (side - value) / along_[slot]);
  exchange(slot, constraint, direction, sides);
  return Walk::done;
}

/// Of the slots whose leaving mends the violation; slots() when nothing mends it.
std::size_t Simplex::slot_to_leave(double direction) const {
  return simplex_kernel::first_to_reach_zero(vertex_.inward(), multiplier_.data(), along_.data(), direction,
                                             vertex_.slots(), kOptimality, kSmallestPivot);
}

/// The constraint's normal as a combination of those that hold: no point can do better than the vertex.
void Simplex::note_ray(std::size_t constraint, double direction) {
  write_basis(ray_basis_);
  std::vector<double> normal(program_.columns(), 0.0);
  program_.add_normal(constraint, direction, normal);
  std::vector<double> combination(vertex_.edges().stride(), 0.0);
  for (std::size_t slot = 0; slot < vertex_.slots(); ++slot) combination[slot] = direction * along_[slot];
  refine(normal, combination);
  write_multipliers(combination, ray_);
  for (double& multiplier : ray_) multiplier = -multiplier;
  if (constraint < program_.columns()) return;
  const std::size_t row = constraint - program_.columns();
  ray_[row] += direction * program_.row_scale(row);
}

void Simplex::set_multipliers() {
  std::fill(multiplier_.begin(), multiplier_.end(), 0.0);
  for (std::size_t j = 0; j < program_.columns(); ++j) {
    if (cost_[j] == 0) continue;
    const double* coordinate = vertex_.edges().coordinate(j);
    for (std::size_t slot = 0; slot < vertex_.slots(); ++slot) {
      multiplier_[slot] += cost_[j] * coordinate[slot];
    }
  }
}

void Simplex::set_random_multipliers() {
  for (std::size_t slot = 0; slot < vertex_.slots(); ++slot) {
    multiplier_[slot] = vertex_.inward(slot) * random_.uniform(1, 2);
  }
}

// Answers.

/// One step of iterative refinement of normal = sum over the slots of multiplier * normal of the slot.
void Simplex::refine(std::span<const double> normal, std::vector<double>& slot_multipliers) {
  std::copy(normal.begin(), normal.end(), residual_.begin());
  for (std::size_t slot = 0; slot < vertex_.slots(); ++slot) {
    if (slot_multipliers[slot] == 0) continue;
    program_.add_normal(vertex_.constraint(slot), -slot_multipliers[slot], residual_);
  }
  for (std::size_t j = 0; j < program_.columns(); ++j) {
    if (std::abs(residual_[j]) < kExact) continue;
    const double* coordinate = vertex_.edges().coordinate(j);
    for (std::size_t slot = 0; slot < vertex_.slots(); ++slot) {
      slot_multipliers[slot] += residual_[j] * coordinate[slot];
    }
  }
}

void Simplex::write_multipliers(std::span<const double> slot_multipliers, std::vector<double>& rows) const {
  rows.assign(program_.rows(), 0.0);
  for (std::size_t slot = 0; slot < vertex_.slots(); ++slot) {
    if (vertex_.constraint(slot) < program_.columns()) continue;
    const std::size_t row = vertex_.constraint(slot) - program_.columns();
    rows[row] = slot_multipliers[slot] * program_.row_scale(row);
  }
}

void Simplex::write_vertex(LpSolution& solution) const {
  write_multipliers(multiplier_, solution.multipliers);
  write_reduced_costs(solution.reduced_costs);
  write_basis(solution.basis);
  solution.primal.assign(vertex_.values(), vertex_.values() + program_.columns());
  solution.objective = cost_at(vertex_, cost_);
}

void Simplex::write_reduced_costs(std::vector<double>& reduced_costs) const {
  reduced_costs.assign(program_.columns(), 0.0);
  for (std::size_t slot = 0; slot < vertex_.slots(); ++slot) {
    const std::size_t constraint = vertex_.constraint(slot);
    if (constraint < program_.columns()) reduced_costs[constraint] = multiplier_[slot];
  }
}

void Simplex::write_basis(LpBasis& basis) const {
  basis.columns.assign(program_.columns(), LpActivity::free);
  basis.rows.assign(program_.rows(), LpActivity::free);
  for (std::size_t slot = 0; slot < vertex_.slots(); ++slot) {
    const LpActivity activity = vertex_.inward(slot) < 0 ? LpActivity::at_upper : LpActivity::at_lower;
    const std::size_t constraint = vertex_.constraint(slot);
    (constraint < program_.columns() ? basis.columns[constraint]
                                     : basis.rows[constraint - program_.columns()]) = activity;
  }
}

}  // namespace gcslab
