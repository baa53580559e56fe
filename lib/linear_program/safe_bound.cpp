#include "linear_program/safe_bound.h"

#include <cmath>

#include "base/check.h"
#include "linear_program/multiplier.h"

namespace gcslab {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// y * coefficient. For one number y * a the two ends are the product of (-y, y) and (a, a), rounded upward.
FastInterval scaled(double y, const Interval& coefficient) {
  if (coefficient.lower != coefficient.upper) return FastInterval(y) * FastInterval(coefficient);
  const __m128d factor = opaque(_mm_set1_pd(coefficient.lower));
  return FastInterval::from_raw(opaque(_mm_mul_pd(opaque(FastInterval(y).raw()), factor)));
}

}  // namespace

double SafeBound::lower(const LpModel& model, std::span<const LinearTerm> objective,
                        std::span<const double> multipliers) {
  GCSLAB_CHECK(multipliers.size() == at(model.rows()));
  const NumberTraits<FastInterval>::Scope scope;
  rest_.assign(at(model.columns()), FastInterval(0.0));
  for (const LinearTerm& term : objective) {
    rest_[at(term.column)] = rest_[at(term.column)] + FastInterval(term.coefficient);
  }
  FastInterval bound(0.0);
  for (int row = 0; row < model.rows(); ++row) {
    const double multiplier = usable_multiplier(multipliers[at(row)], model.sides(row));
    if (multiplier == 0) continue;
    bound = bound + scaled(multiplier, held_side(multiplier, model.sides(row)));
    const auto columns = model.row_columns(row);
    const auto coefficients = model.row_coefficients(row);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      FastInterval& rest = rest_[at(columns[k])];
      rest = rest - scaled(multiplier, coefficients[k]);
    }
  }
  for (int column = 0; column < model.columns(); ++column) {
    bound = bound + rest_[at(column)] * FastInterval(model.column(column));
  }
  return bound.lower();
}

double safe_lower_bound(const LpModel& model, std::span<const LinearTerm> objective,
                        std::span<const double> multipliers) {
  return SafeBound().lower(model, objective, multipliers);
}

bool proves_infeasible(const LpModel& model, std::span<const double> ray) {
  return SafeBound().proves_infeasible(model, ray);
}

}  // namespace gcslab
