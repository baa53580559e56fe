#pragma once

// The least-squares multipliers of an expansion.

#include <cmath>

#include "box_solver/expansion.h"
#include "box_solver/least_squares.h"

namespace gcslab {

/// Multipliers for the middles of the coefficients; rows without a bounded constant take no part. False when
/// the numbers are beyond doubles.
template <class T>
bool compute_multipliers(const Expansion<T>& expansion, LeastSquaresMultipliers& system) {
  const ExpansionPlan& plan = expansion.plan();
  const auto squared_radius = [](const Interval& x) {
    const double radius = 0.5 * x.upper - 0.5 * x.lower;
    return radius * radius;
  };
  system.reset(plan.rows(), plan.columns().size(), plan.functions().variables());
  for (std::size_t k = 0; k < plan.rows(); ++k) {
    const ExpansionRow<T>& row = expansion.row(k);
    const Interval constant = NumberTraits<T>::enclosure(row.constant);
    if (!is_bounded(constant)) continue;
    double spread = squared_radius(constant);
    for (std::size_t c = 0; c < row.columns.size(); ++c) {
      const Interval value = NumberTraits<T>::enclosure(row.values[c]);
      system.set(k, row.columns[c], 0.5 * value.lower + 0.5 * value.upper);
      spread += squared_radius(value);
    }
    system.set_constant(k, 0.5 * constant.lower + 0.5 * constant.upper, std::sqrt(spread));
  }
  return system.solve();
}

}  // namespace gcslab
