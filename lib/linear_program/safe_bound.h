#pragma once

// Proofs from multipliers: rigorous bounds and rigorous infeasibility, whatever solver the multipliers come
// from.
//
// For ANY multipliers y (one a row), any objective c in C and any feasible point x of the model,
//   c.x = sum_i y_i (a_i.x) + (c - sum_i y_i a_i).x
//      >= sum_i (y_i > 0 ? y_i L_i : y_i U_i) + min over the column box of (C - sum_i y_i A_i).x,
// and the right side, computed with outward rounding, is a proved bound (Neumaier, Shcherbina 2004, "Safe
// bounds in linear and mixed-integer linear programming", Math. Program. 99, section 3). With c = 0 a
// positive value proves that no point is feasible (Farkas 1902). The functions need nothing but the
// multipliers: a proof that stores them can be checked by whoever has the model. Multipliers that are not
// finite, or whose sign asks for an infinite side, count as 0, so that every vector is valid and only its
// quality differs.

#include <span>
#include <vector>

#include "interval/fast_interval.h"
#include "linear_program/lp_model.h"

namespace gcslab {

/// A number <= c.x for every feasible x and every c in the objective. Works in its own rounding scope.
/// `multipliers` has one a row; `work` is reused memory.
class SafeBound {
 public:
  double lower(const LpModel& model, std::span<const LinearTerm> objective,
               std::span<const double> multipliers);
  /// True only when the model has no feasible point.
  bool proves_infeasible(const LpModel& model, std::span<const double> ray) {
    return lower(model, {}, ray) > 0;
  }

 private:
  std::vector<FastInterval> rest_;  ///< C - sum_i y_i A_i
};

/// The same without memory to reuse.
double safe_lower_bound(const LpModel& model, std::span<const LinearTerm> objective,
                        std::span<const double> multipliers);
bool proves_infeasible(const LpModel& model, std::span<const double> ray);

}  // namespace gcslab
