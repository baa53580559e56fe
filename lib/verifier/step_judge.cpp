#include "verifier/step_judge.h"

#include <algorithm>
#include <limits>
#include <map>

#include "verifier/projection.h"

namespace gcslab::verifier {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

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

}  // namespace

StepJudge::StepJudge(JudgedSystem& system)
    : system_(&system),
      expansion_(system),
      rows_(system.variables()),
      z_(system.variables()),
      forms_(system) {}

Range StepJudge::propagated(std::size_t variable, const Box& box) const {
  Range side(box[variable]);
  if (propagated_to_nothing_) return Range::empty();
  for (const std::size_t i : propagated_->variables()) {
    if (i == variable) return intersection(side, propagated_->narrowed(variable));
  }
  return side;
}

Range StepJudge::propagate(bool is_equation, std::size_t function, std::size_t variable, const Box& box,
                           const Interval& claim) {
  Program& program = (is_equation ? system_->equations() : system_->inequalities())[function].program;
  if (propagated_ == &program) {
    Range kept = propagated(variable, box);
    if (kept.is_within(claim)) return kept;
  }
  const Range target(is_equation ? Interval(0) : Interval(-kInfinity, 0));
  propagated_ = &program;
  propagated_to_nothing_ = !program.propagate(ranges_of(box), target);
  return propagated(variable, box);
}

ExpansionBox StepJudge::expansion_about(const Box& box) { return {++last_expansion_, box}; }

void StepJudge::expand(const ExpansionBox& expansion) {
  if (expanded_ == expansion.number) return;
  expanded_ = expansion.number;
  expansion_.expand(expansion.box);
  forget_propagation();
}

/// z = (x - m) / r, within [-1, 1] because the box lies in the expansion's.
void StepJudge::scale(std::uint64_t expansion, const Box& box) {
  const bool is_new = scaled_ != expansion;
  scaled_ = expansion;
  if (is_new) scaled_box_ = box;
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (!is_new && scaled_box_[i] == box[i]) continue;
    scaled_box_[i] = box[i];
    const double r = expansion_.radii()[i];
    const Range offset = Range(box[i]) - Range(expansion_.midpoints()[i]);
    z_[i] = r == 0 ? Range(0.0) : intersection(offset / Range(r), Range(Interval(-1, 1)));
  }
}

/// The combination of the rows about that box, kept for the next step that asks for it.
CombinedRow& StepJudge::combined(const ExpansionBox& expansion, std::size_t variable,
                                 const std::vector<double>& multipliers, const Box& box) {
  expand(expansion);
  scale(expansion.number, box);
  KeptRow& kept = rows_[variable];
  if (kept.expansion != expansion.number || kept.multipliers != multipliers) {
    forget_propagation();
    kept.expansion = expansion.number;
    kept.multipliers = multipliers;
    kept.row.combine(expansion_, multipliers);
  }
  return kept.row;
}

Range StepJudge::unscaled(std::size_t variable, const Range& z, const Box& box) const {
  const Range x = Range(expansion_.midpoints()[variable]) + z * Range(expansion_.radii()[variable]);
  return intersection(x, Range(box[variable]));
}

Range StepJudge::expansion_row(const ExpansionBox& expansion, std::size_t variable,
                               const std::vector<double>& multipliers, const Box& box) {
  const CombinedRow& row = combined(expansion, variable, multipliers, box);
  return unscaled(variable, row.solve(expansion_, variable, z_), box);
}

Range StepJudge::square_row(const ExpansionBox& expansion, std::size_t variable,
                            const std::vector<double>& multipliers, const Box& box) {
  const CombinedRow& row = combined(expansion, variable, multipliers, box);
  return unscaled(variable, row.solve_square(expansion_, variable, z_), box);
}

/// On solutions c_k f_k is 0 for equations and >= 0 for inequalities, where c_k <= 0; and the products are >=
/// 0 on [-1, 1]^n. So with R = -sum c_k f_k - sum of products there is no solution where R > 0, and z_i >=
/// min(R + z_i), z_i <= -min(R - z_i).
Range StepJudge::polytope(const ExpansionBox& expansion, std::size_t variable,
                          const std::vector<double>& multipliers,
                          const std::vector<PositiveProduct>& products, const Box& box) {
  expand(expansion);
  forget_propagation();
  MonomialSum rest;
  for (std::size_t k = 0; k < multipliers.size(); ++k) {
    if (multipliers[k] == 0) continue;
    const ExpandedRow& row = expansion_.row(k);
    rest.add({}, scaled(-multipliers[k], row.constant));
    for (std::size_t c = 0; c < row.columns.size(); ++c)
      rest.add(expansion_.columns()[row.columns[c]], scaled(-multipliers[k], row.values[c]));
  }
  for (const PositiveProduct& product : products) subtract(product, rest);
  const Monomial own{{static_cast<std::uint32_t>(variable), 1}};
  const auto least_with = [&](double coefficient) {
    MonomialSum sum = rest;
    sum.add(own, Range(coefficient));
    return sum.range_over_unit_box();
  };
  if (rest.range_over_unit_box().is_positive()) return Range::empty();
  const Range above = hull(least_with(1), Range(1.0));     // z_i is at least the lower end
  const Range below = hull(-least_with(-1), Range(-1.0));  // and at most the upper end of this
  return unscaled(variable, intersection(intersection(above, below), Range(Interval(-1, 1))), box);
}

std::string StepJudge::bernstein_refusal() const {
  return forms_.applies() ? "" : "the equations are no polynomials, or too large, for their Bernstein forms";
}

Range StepJudge::bernstein_row(const ExpansionBox& expansion, std::size_t variable,
                               const std::vector<double>& multipliers, const Interval& claim,
                               const Box& box) {
  if (converted_ != expansion.number) forms_.convert(expansion.box);
  converted_ = expansion.number;
  return intersection(forms_.zeros(variable, multipliers, claim), Range(box[variable]));
}

/// Values at the midpoint and slopes from there.
void StepJudge::compute_slopes(const ExpansionBox& expansion) {
  if (sloped_ == expansion.number) return;
  sloped_ = expansion.number;
  forget_propagation();
  centre_.clear();
  for (const Interval& side : expansion.box) centre_.emplace_back(midpoint(side));
  const RangeBox box = ranges_of(expansion.box);
  const std::size_t equations = system_->equations().size();
  values_.resize(equations);
  slopes_.resize(equations);
  is_defined_.resize(equations);
  for (std::size_t k = 0; k < equations; ++k) {
    values_[k] = system_->equations()[k].program.evaluate(centre_);
    is_defined_[k] = !values_[k].is_empty() && system_->slopes(k, box, centre_, slopes_[k]);
  }
}

/// With g = sum c_k f_k(m) and G = sum c_k S_k, every root has g + G (x - m) = 0: it lies in the quotient
/// m_i - (g + rest) / G_i of Gauss and Seidel and in m_i - g - rest + (1 - G_i) (x_i - m_i), Krawczyk's form.
Range StepJudge::mean_value_row(const ExpansionBox& expansion, std::size_t variable,
                                const std::vector<double>& multipliers, const Box& box) {
  Range side(box[variable]);
  compute_slopes(expansion);
  Range sum;
  RangeBox row(box.size());
  for (std::size_t k = 0; k < multipliers.size(); ++k) {
    if (multipliers[k] == 0) continue;
    if (!is_defined_[k]) return side;
    sum = sum + scaled(multipliers[k], values_[k]);
    for (std::size_t j = 0; j < box.size(); ++j) {
      if (!slopes_[k][j].is_zero()) row[j] = row[j] + scaled(multipliers[k], slopes_[k][j]);
    }
  }
  for (std::size_t j = 0; j < box.size(); ++j) {
    if (j != variable && !row[j].is_zero()) sum = sum + row[j] * (Range(box[j]) - centre_[j]);
  }
  const Range offset = side - centre_[variable];
  const Range quotient = project_factor(-sum, row[variable], offset);
  const Range krawczyk = (Range(1.0) - row[variable]) * offset - sum;
  return intersection(side, centre_[variable] + intersection(quotient, krawczyk));
}

}  // namespace gcslab::verifier
