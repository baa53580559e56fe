#include "linear_program/exact_basis.h"

#include <algorithm>

#include "linear_program/exact_bound.h"
#include "linear_program/exact_program.h"

namespace gcslab {
namespace {

struct Holding {
  std::vector<std::size_t> constraints;
  std::vector<Rational> sides;
};

/// The constraints that a basis holds, with their sides; false when one has no side there.
bool read_basis(const ExactProgram& program, const LpBasis& basis, Holding& holding) {
  std::vector<LpActivity> all = basis.columns;
  all.insert(all.end(), basis.rows.begin(), basis.rows.end());
  if (all.size() != program.constraints().size()) return false;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k] == LpActivity::free) continue;
    const ExactConstraint& data = program.constraints()[k];
    const auto& side = all[k] == LpActivity::at_upper ? data.upper : data.lower;
    if (!side) return false;
    holding.constraints.push_back(k);
    holding.sides.push_back(*side);
  }
  return true;
}

bool is_feasible(const ExactProgram& program, const std::vector<Rational>& point) {
  return std::all_of(program.constraints().begin(), program.constraints().end(),
                     [&](const ExactConstraint& constraint) {
                       const Rational value = constraint.value(point);
                       return (!constraint.lower || value >= *constraint.lower) &&
                              (!constraint.upper || value <= *constraint.upper);
                     });
}

/// A multiplier must be >= 0 at a lower side and <= 0 at an upper one; an equation has both.
bool has_valid_sign(const ExactConstraint& constraint, const Rational& side, const Rational& multiplier) {
  if (multiplier == 0) return true;
  const auto& wanted = multiplier > 0 ? constraint.lower : constraint.upper;
  return wanted && *wanted == side;
}

void write_multipliers(const ExactProgram& program, const Holding& holding,
                       const std::vector<Rational>& multipliers, ExactVertex& vertex) {
  vertex.dual_feasible = true;
  vertex.reduced_costs.assign(program.columns(), Rational(0));
  vertex.multipliers.assign(program.constraints().size() - program.columns(), Rational(0));
  for (std::size_t slot = 0; slot < multipliers.size(); ++slot) {
    const std::size_t k = holding.constraints[slot];
    if (!has_valid_sign(program.constraints()[k], holding.sides[slot], multipliers[slot])) {
      vertex.dual_feasible = false;
    }
    (k < program.columns() ? vertex.reduced_costs[k] : vertex.multipliers[k - program.columns()]) =
        multipliers[slot];
  }
}

}  // namespace

ExactVertex exact_vertex(const LpModel& model, std::span<const LinearTerm> objective, const LpBasis& basis) {
  const ExactProgram program(model);
  ExactVertex vertex;
  Holding holding;
  if (!read_basis(program, basis, holding) || holding.constraints.size() != program.columns()) return vertex;
  std::vector<ExactFactorisation::SparseRow> rows;
  for (const std::size_t k : holding.constraints) rows.push_back(program.constraints()[k].normal);
  const ExactFactorisation factors(std::move(rows), program.columns());
  if (!factors.is_regular()) return vertex;
  vertex.is_vertex = true;
  const std::vector<Rational> cost = program.cost(objective);
  vertex.primal = factors.solve(holding.sides);
  vertex.primal_feasible = is_feasible(program, vertex.primal);
  for (std::size_t j = 0; j < cost.size(); ++j) vertex.objective += cost[j] * vertex.primal[j];
  write_multipliers(program, holding, factors.solve_transposed(cost), vertex);
  return vertex;
}

bool is_exact_infeasibility_proof(const LpModel& model, std::span<const double> ray) {
  return exact_lower_bound(model, {}, exact_multipliers(ray)) > 0;
}

}  // namespace gcslab
