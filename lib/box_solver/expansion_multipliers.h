#pragma once

// The least-squares multipliers of an expansion.

#include <cmath>

#include "box_solver/expansion.h"
#include "box_solver/least_squares.h"

namespace gcslab {

/// Multipliers for the middles of the coefficients. Rows take no part of which some number is unbounded, or
/// so large that its square is. False when the numbers are beyond doubles all the same.
template <class T>
bool compute_multipliers(const Expansion<T>& expansion, LeastSquaresMultipliers& system) {
  const ExpansionPlan& plan = expansion.plan();
  const auto squared_radius = [](const T& x) {
    const Interval range = NumberTraits<T>::enclosure(x);
    const double radius = 0.5 * range.upper - 0.5 * range.lower;
    return radius * radius;
  };
  const auto middle = [](const T& x) {
    const Interval range = NumberTraits<T>::enclosure(x);
    return 0.5 * range.lower + 0.5 * range.upper;
  };
  system.reset(plan.rows(), plan.columns().size(), plan.functions().variables());
  for (std::size_t k = 0; k < plan.rows(); ++k) {
    const ExpansionRow<T>& row = expansion.row(k);
    double spread = squared_radius(row.constant);
    for (const T& value : row.values) spread += squared_radius(value);
    if (!std::isfinite(spread)) continue;
    for (std::size_t c = 0; c < row.columns.size(); ++c) system.set(k, row.columns[c], middle(row.values[c]));
    system.set_constant(k, middle(row.constant), std::sqrt(spread));
  }
  return system.solve();
}

}  // namespace gcslab
