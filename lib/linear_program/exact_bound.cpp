#include "linear_program/exact_bound.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "interval/fast_interval.h"

namespace gcslab {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

struct RationalInterval {
  Rational lower;
  Rational upper;
};

RationalInterval exact(const Interval& x) {
  return {rational_from_double(x.lower), rational_from_double(x.upper)};
}

/// x -= factor * y.
void subtract_scaled(RationalInterval& x, const Rational& factor, const RationalInterval& y) {
  x.lower -= factor * (factor > 0 ? y.upper : y.lower);
  x.upper -= factor * (factor > 0 ? y.lower : y.upper);
}

Rational least_product(const RationalInterval& x, const RationalInterval& y) {
  return std::min({Rational(x.lower * y.lower), Rational(x.lower * y.upper), Rational(x.upper * y.lower),
                   Rational(x.upper * y.upper)});
}

}  // namespace

Rational exact_lower_bound(const LpModel& model, std::span<const LinearTerm> objective,
                           std::span<const Rational> multipliers) {
  GCSLAB_CHECK(multipliers.size() == at(model.rows()));
  std::vector<RationalInterval> rest(at(model.columns()));
  for (const LinearTerm& term : objective) {
    subtract_scaled(rest[at(term.column)], -1, exact(term.coefficient));
  }
  Rational bound = 0;
  for (int row = 0; row < model.rows(); ++row) {
    const Rational& multiplier = multipliers[at(row)];
    const double side = multiplier > 0 ? model.sides(row).lower : model.sides(row).upper;
    if (multiplier == 0 || !std::isfinite(side)) continue;
    bound += multiplier * rational_from_double(side);
    const auto columns = model.row_columns(row);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      subtract_scaled(rest[at(columns[k])], multiplier, exact(model.row_coefficients(row)[k]));
    }
  }
  for (int column = 0; column < model.columns(); ++column) {
    bound += least_product(rest[at(column)], exact(model.column(column)));
  }
  return bound;
}

std::vector<Rational> exact_multipliers(std::span<const double> multipliers) {
  std::vector<Rational> result;
  for (const double value : multipliers) {
    result.push_back(std::isfinite(value) ? rational_from_double(value) : Rational(0));
  }
  return result;
}

double rounded_down(const Rational& value) {
  const NumberTraits<FastInterval>::Scope scope;
  return NumberTraits<FastInterval>::from_rational(value).lower();
}

}  // namespace gcslab
