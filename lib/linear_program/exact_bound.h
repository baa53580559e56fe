#pragma once

// The bound of safe_bound.h in exact rational arithmetic: what a verifier recomputes, and the test of the
// fast one.

#include <span>
#include <vector>

#include "interval/rational.h"
#include "linear_program/lp_model.h"

namespace gcslab {

/// The largest number that the multipliers prove: sum_i (y_i > 0 ? y_i L_i : y_i U_i) + min over the column
/// box of (C - sum_i y_i A_i).x, exactly. Multipliers whose sign asks for an infinite side count as 0.
Rational exact_lower_bound(const LpModel& model, std::span<const LinearTerm> objective,
                           std::span<const Rational> multipliers);

/// The doubles as rationals; those that are not finite become 0.
std::vector<Rational> exact_multipliers(std::span<const double> multipliers);

/// The largest double <= value.
double rounded_down(const Rational& value);

}  // namespace gcslab
