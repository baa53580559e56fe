#include "verifier/polytope_sum.h"

#include <algorithm>
#include <map>

namespace gcslab::verifier {
namespace {

Monomial times(const Monomial& a, const Monomial& b) {
  std::map<std::uint32_t, int> powers;
  for (const Monomial* factor : {&a, &b}) {
    for (const auto& [variable, power] : *factor) powers[variable] += power;
  }
  return {powers.begin(), powers.end()};
}

/// A polynomial in z by its monomials.
class MonomialSum {
 public:
  void add(const Monomial& monomial, const Range& coefficient) {
    const auto [place, is_new] = coefficients_.try_emplace(monomial, coefficient);
    if (!is_new) place->second = place->second + coefficient;
  }

  /// Each monomial bounded on its own over [-1, 1]^n.
  Range range_over_unit_box() const {
    Range sum;
    for (const auto& [monomial, coefficient] : coefficients_) {
      const bool is_even =
          std::ranges::all_of(monomial, [](const auto& factor) { return factor.second % 2 == 0; });
      const Range values = monomial.empty() ? Range(1.0) : Range(is_even ? Interval(0, 1) : Interval(-1, 1));
      sum = sum + coefficient * values;
    }
    return sum;
  }

 private:
  std::map<Monomial, Range> coefficients_;
};

/// The terms of a product or square, with their signs; not summed.
std::vector<std::pair<int, Monomial>> expanded(const PositiveProduct& product) {
  std::vector<std::pair<int, Monomial>> terms;
  if (product.is_square) {
    for (const auto& [s, a] : product.factors) {
      for (const auto& [t, b] : product.factors) terms.emplace_back(s * t, times(a, b));
    }
    return terms;
  }
  terms.emplace_back(1, Monomial());
  for (const auto& [sign, monomial] : product.factors) {
    const std::size_t count = terms.size();
    for (std::size_t i = 0; i < count; ++i)
      terms.emplace_back(terms[i].first * sign, times(terms[i].second, monomial));
  }
  return terms;
}

void subtract(const PositiveProduct& product, MonomialSum& sum) {
  for (const auto& [sign, monomial] : expanded(product)) sum.add(monomial, Range(-sign * product.multiplier));
}

void subtract(const ExpandedRow& row, double multiplier, const Expansion& about, MonomialSum& sum) {
  sum.add({}, scaled(-multiplier, row.constant));
  for (std::size_t c = 0; c < row.columns.size(); ++c)
    sum.add(about.columns()[row.columns[c]], scaled(-multiplier, row.values[c]));
}

/// With t - s x = (m_t + r_t z_t) - s (m_x + r_x z_x).
void subtract(const GraphStrip& strip, const Expansion& about, LiftedTerms& terms, MonomialSum& sum) {
  const std::size_t value = terms.size_before() + strip.term;
  const std::size_t argument = *terms.argument(strip.term);
  const Range slope(strip.slope);
  const Range range = terms.strip(strip.term, strip.slope, about.box()[argument]);
  if (range.is_empty() || !range.is_bounded()) return;  // says nothing
  const Range side(strip.multiplier > 0 ? range.lower_end() : range.upper_end());
  const auto add = [&](const Monomial& monomial, const Range& coefficient) {
    sum.add(monomial, scaled(-strip.multiplier, coefficient));
  };
  add({}, Range(about.midpoints()[value]) - slope * Range(about.midpoints()[argument]) - side);
  add({{static_cast<std::uint32_t>(value), 1}}, Range(about.radii()[value]));
  add({{static_cast<std::uint32_t>(argument), 1}}, -slope * Range(about.radii()[argument]));
}

}  // namespace

/// On solutions c_k f_k is 0 for equations and >= 0 for inequalities, where c_k <= 0; products are >= 0 on
/// [-1, 1]^n and so are strips, M (t - s x - lower) with M > 0 and M (t - s x - upper) with M < 0. So with R
/// = minus all these there is no solution where R > 0, and z_i >= min(R + z_i), z_i <= -min(R - z_i).
Range polytope_range(Expansion& about, std::size_t variable, const PolytopeSum& sum, LiftedTerms& terms) {
  MonomialSum rest;
  for (std::size_t k = 0; k < sum.multipliers.size(); ++k) {
    if (sum.multipliers[k] != 0) subtract(about.row(k), sum.multipliers[k], about, rest);
  }
  for (const PositiveProduct& product : sum.products) subtract(product, rest);
  for (const GraphStrip& strip : sum.strips) subtract(strip, about, terms, rest);
  const Monomial own{{static_cast<std::uint32_t>(variable), 1}};
  const auto least_with = [&](double coefficient) {
    MonomialSum with = rest;
    with.add(own, Range(coefficient));
    return with.range_over_unit_box();
  };
  if (rest.range_over_unit_box().is_positive()) return Range::empty();
  const Range above = hull(least_with(1), Range(1.0));     // z_i is at least the lower end
  const Range below = hull(-least_with(-1), Range(-1.0));  // and at most the upper end of this
  return intersection(intersection(above, below), Range(Interval(-1, 1)));
}

}  // namespace gcslab::verifier
