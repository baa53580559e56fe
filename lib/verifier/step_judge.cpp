#include "verifier/step_judge.h"

#include <algorithm>
#include <limits>

#include "verifier/projection.h"

namespace gcslab::verifier {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

StepJudge::StepJudge(JudgedSystem& system)
    : system_(&system),
      expansion_(system),
      rows_(system.variables()),
      terms_(system),
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

ExpansionBox StepJudge::expansion_about(const Box& box, Box terms) {
  return {++last_expansion_, box, std::move(terms)};
}

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
CombinedRow& StepJudge::combined(const ExpansionBox& expansion, std::size_t variable, const EquationSum& sum,
                                 const Box& box) {
  expand(expansion);
  scale(expansion.number, box);
  KeptRow& kept = rows_[variable];
  if (kept.expansion != expansion.number || kept.sum != sum) {
    forget_propagation();
    kept.expansion = expansion.number;
    kept.sum = sum;
    kept.row.combine(expansion_, sum);
  }
  return kept.row;
}

Range StepJudge::unscaled(const Expansion& about, std::size_t variable, const Range& z, const Box& box) {
  const Range x = Range(about.midpoints()[variable]) + z * Range(about.radii()[variable]);
  return intersection(x, Range(box[variable]));
}

Range StepJudge::expansion_row(const ExpansionBox& expansion, std::size_t variable, const EquationSum& sum,
                               const Box& box) {
  const CombinedRow& row = combined(expansion, variable, sum, box);
  return unscaled(expansion_, variable, row.solve(expansion_, variable, z_), box);
}

Range StepJudge::square_row(const ExpansionBox& expansion, std::size_t variable, const EquationSum& sum,
                            const Box& box) {
  const CombinedRow& row = combined(expansion, variable, sum, box);
  return unscaled(expansion_, variable, row.solve_square(expansion_, variable, z_), box);
}

Range StepJudge::polytope(const ExpansionBox& expansion, std::size_t variable, const PolytopeSum& sum,
                          const Box& box) {
  if (expansion.terms.empty()) expand(expansion);
  forget_propagation();
  Expansion& about = expansion.terms.empty() ? expansion_ : expand_lifted(expansion);
  return unscaled(about, variable, polytope_range(about, variable, sum, terms_), box);
}

Expansion& StepJudge::expand_lifted(const ExpansionBox& expansion) {
  if (!lifted_expansion_) lifted_expansion_.emplace(terms_.system());
  if (lifted_expanded_ != expansion.number) {
    Box lifted = expansion.box;
    lifted.insert(lifted.end(), expansion.terms.begin(), expansion.terms.end());
    lifted_expansion_->expand(lifted);
  }
  lifted_expanded_ = expansion.number;
  return *lifted_expansion_;
}

JudgedSystem& StepJudge::expanded_system(const ExpansionBox& expansion) {
  return expansion.terms.empty() ? *system_ : terms_.system();
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
