#pragma once

// The exact check of a final basis: where its vertex lies, what its multipliers are, and whether both are
// feasible, in rationals, over the midpoints of the model (for thin models, the model itself).

#include <span>
#include <vector>

#include "interval/rational.h"
#include "linear_program/lp_model.h"
#include "linear_program/lp_solution.h"

namespace gcslab {

struct ExactVertex {
  bool is_vertex = false;        ///< as many independent constraints hold as there are columns
  bool primal_feasible = false;  ///< the point satisfies every row and column bound
  bool dual_feasible = false;    ///< every multiplier has the sign of its side
  Rational objective;
  std::vector<Rational> primal;         ///< one a column
  std::vector<Rational> multipliers;    ///< one a row
  std::vector<Rational> reduced_costs;  ///< one a column

  /// Then `objective` is the minimum over the midpoints.
  bool is_optimal() const { return is_vertex && primal_feasible && dual_feasible; }
};

/// The vertex that a basis names. When it names none, only `is_vertex` is set.
ExactVertex exact_vertex(const LpModel& model, std::span<const LinearTerm> objective, const LpBasis& basis);

/// True only when the multipliers prove, in exact arithmetic and for all interval data, that no point is
/// feasible.
bool is_exact_infeasibility_proof(const LpModel& model, std::span<const double> ray);

}  // namespace gcslab
