#pragma once

// What a linear programming solver answers, in numbers that are rounded and prove nothing by themselves.
//
// Signs. The program is: minimise c.x subject to L <= A x <= U and the column bounds. Multipliers y (one a
// row) and reduced costs z (one a column) satisfy c = A^T y + z; where a multiplier is positive the lower
// side holds with equality, where it is negative the upper side does. So min c.x = sum_i (y_i > 0 ? y_i L_i :
// y_i U_i) + the same for z and the column bounds. A ray is a multiplier vector for c = 0 whose value so
// computed is positive: no x satisfies all rows (Farkas 1902). safe_bound.h turns either into proofs.

#include <string_view>
#include <vector>

namespace gcslab {

enum class LpStatus {
  optimal,          ///< primal, multipliers, reduced costs and basis are of an optimal vertex
  infeasible,       ///< `ray` says why; empty when the solver gives no reason
  iteration_limit,  ///< multipliers may still give a bound
  failed            ///< the solver gave up
};

std::string_view name_of(LpStatus status);

/// Where a column or row stands at a vertex. As many are not `free` as there are columns.
enum class LpActivity : unsigned char {
  free,      ///< basic: determined by the others
  at_lower,  ///< held at the lower bound or side
  at_upper   ///< held at the upper bound or side
};

/// A vertex, named by what holds it: enough to compute it anew in any arithmetic.
struct LpBasis {
  std::vector<LpActivity> columns;
  std::vector<LpActivity> rows;
};

struct LpSolution {
  LpStatus status = LpStatus::failed;
  double objective = 0;
  std::vector<double> primal;         ///< one a column
  std::vector<double> multipliers;    ///< one a row
  std::vector<double> reduced_costs;  ///< one a column
  std::vector<double> ray;            ///< one a row when infeasible; may be empty
  LpBasis basis;                      ///< when optimal; some solvers also say where infeasibility showed
  long iterations = 0;                ///< of this call
};

}  // namespace gcslab
