#include "verifier/combined_row.h"

#include <algorithm>

#include "verifier/projection.h"

namespace gcslab::verifier {
namespace {

bool is_square(const Monomial& monomial) { return monomial.size() == 1 && monomial[0].second == 2; }

/// Encloses {a z + q z^2 : z in `z`}: by its ends where it is monotone, with its vertex elsewhere.
Range quadratic_range(const Range& a, const Range& q, const Range& z) {
  Range lower_end;
  Range upper_end;
  mpfr_set(lower_end.lower(), z.lower(), MPFR_RNDN);
  mpfr_set(lower_end.upper(), z.lower(), MPFR_RNDN);
  mpfr_set(upper_end.lower(), z.upper(), MPFR_RNDN);
  mpfr_set(upper_end.upper(), z.upper(), MPFR_RNDN);
  Range ends = hull(lower_end * (a + q * lower_end), upper_end * (a + q * upper_end));
  if (!(a + scaled(2, q * z)).contains_zero()) return ends;
  Range direct = intersection(a * z + q * sqr(z), z * (a + q * z));
  if (q.contains_zero()) return direct;
  return intersection(direct, hull(ends, -(sqr(a) / scaled(4, q))));
}

}  // namespace

void CombinedRow::add_row(const ExpandedRow& row, double multiplier) {
  constant_ = constant_ + scaled(multiplier, row.constant);
  for (std::size_t c = 0; c < row.columns.size(); ++c) {
    Range& sum = values_[row.columns[c]];
    sum = sum + scaled(multiplier, row.values[c]);
  }
}

void CombinedRow::combine(Expansion& expansion, const EquationSum& sum) {
  constant_ = 0.0;
  values_.assign(expansion.columns().size(), Range());
  for (std::size_t k = 0; k < sum.multipliers.size(); ++k) {
    if (sum.multipliers[k] != 0) add_row(expansion.row(k), sum.multipliers[k]);
  }
  for (const auto& [multiple, multiplier] : sum.multiples) {
    if (multiplier != 0) add_row(expansion.row(multiple), multiplier);
  }
  squares_.assign(expansion.variables(), Range());
  mixed_.clear();
  for (std::uint32_t c = static_cast<std::uint32_t>(expansion.variables()); c < values_.size(); ++c) {
    const Monomial& monomial = expansion.columns()[c];
    if (is_square(monomial)) {
      squares_[monomial[0].first] = values_[c];
    } else if (!values_[c].is_zero()) {
      mixed_.push_back(c);
    }
  }
}

/// The linear and square columns.
void CombinedRow::add_powers(Parts& parts, std::size_t variable, const RangeBox& z) const {
  for (std::size_t j = 0; j < z.size(); ++j) {
    if (j == variable) continue;
    if (!squares_[j].is_zero()) {
      parts.rest = parts.rest + quadratic_range(values_[j], squares_[j], z[j]);
    } else if (!values_[j].is_zero()) {
      parts.rest = parts.rest + values_[j] * z[j];
    }
  }
}

void CombinedRow::add_mixed(Parts& parts, const Monomial& monomial, const Range& value, std::size_t variable,
                            const RangeBox& z) const {
  Range product(1.0);
  bool occurs = false;
  for (const auto& [factor, exponent] : monomial) {
    const bool is_variable = factor == variable;
    const int left = exponent - (is_variable ? 1 : 0);
    occurs = occurs || is_variable;
    if (left == 1) product = product * z[factor];
    if (left > 1) product = product * power(z[factor], left);
  }
  Range& sum = occurs ? parts.slope : parts.rest;
  sum = sum + value * product;
}

CombinedRow::Parts CombinedRow::parts(const Expansion& expansion, std::size_t variable,
                                      const RangeBox& z) const {
  Parts result{constant_, values_[variable], squares_[variable]};
  add_powers(result, variable, z);
  for (const std::uint32_t c : mixed_) add_mixed(result, expansion.columns()[c], values_[c], variable, z);
  return result;
}

/// z_i lies in -(rest + square z_i^2) / slope and in -rest / (slope + square z_i).
Range CombinedRow::solve(const Expansion& expansion, std::size_t variable, const RangeBox& z) const {
  const auto [rest, slope, square] = parts(expansion, variable, z);
  if (square.is_zero()) return project_factor(-rest, slope, z[variable]);
  const Range solved = project_factor(-(rest + square * sqr(z[variable])), slope, z[variable]);
  return project_factor(-rest, slope + square * z[variable], solved);
}

/// z_i^2 lies in -(rest + slope z_i) / square.
Range CombinedRow::solve_square(const Expansion& expansion, std::size_t variable, const RangeBox& z) const {
  const auto [rest, slope, square] = parts(expansion, variable, z);
  if (square.is_zero()) return z[variable];
  const Range squared = project_factor(-(rest + slope * z[variable]), square, sqr(z[variable]));
  return project_sqr(squared, z[variable]);
}

}  // namespace gcslab::verifier
