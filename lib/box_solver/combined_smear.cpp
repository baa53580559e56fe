#include "box_solver/combined_smear.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "box_solver/expansion_multipliers.h"
#include "interval/fast_interval.h"

namespace gcslab {
namespace {

/// Adds numbers, scaled so that their sum is `share`; nothing when they have no finite sum.
void add_share(std::vector<double>& scores, const std::vector<double>& numbers, double share) {
  const double sum = std::accumulate(numbers.begin(), numbers.end(), 0.0);
  if (!(sum > 0) || !std::isfinite(sum)) return;
  for (std::size_t i = 0; i < scores.size(); ++i) scores[i] += share * numbers[i] / sum;
}

class CombinedSmear final : public ScoredBisection {
 public:
  explicit CombinedSmear(const SystemFunctions& functions)
      : plan_(functions, ExpandedFunctions::equations_and_multiples),
        expansion_(made(plan_)),
        equations_(make_relative_smear_sum(functions)),
        multipliers_(plan_.rows()) {}

  const std::vector<double>& scores(const Box& box) override {
    scores_.assign(box.size(), 0);
    add_share(scores_, equations_->scores(box), 1);
    if (!combine(box)) return scores_;
    losses_.assign(box.size(), 0);
    const double nearness = add_exclusion();
    add_share(scores_, losses_, nearness);
    losses_.assign(box.size(), 0);
    for (std::size_t i = 0; i < box.size(); ++i) add_losses(system_.multipliers(i));
    add_share(scores_, losses_, 1 - nearness);
    return scores_;
  }

 private:
  static Expansion<FastInterval> made(const ExpansionPlan& plan) {
    const NumberTraits<FastInterval>::Scope scope;
    return Expansion<FastInterval>(plan);
  }

  /// Expansion and multipliers; false where there are none.
  bool combine(const Box& box) {
    if (!std::ranges::all_of(box, is_bounded)) return false;
    const NumberTraits<FastInterval>::Scope scope;
    expansion_.expand(box);
    return compute_multipliers(expansion_, system_);
  }

  /// The combination that comes nearest to a constant, and how near: the root of what the constant is of its
  /// other terms, at most 1.
  double add_exclusion() {
    if (!system_.solve_for_constant(multipliers_)) return 0;
    double constant = 0;
    for (std::size_t k = 0; k < multipliers_.size(); ++k) {
      if (multipliers_[k] == 0) continue;
      const Interval value = expansion_.row(k).constant.interval();
      constant += multipliers_[k] * (0.5 * value.lower + 0.5 * value.upper);
    }
    const double part = std::fabs(constant) / add_losses(multipliers_);
    return part >= 0 ? std::sqrt(std::min(part, 1.0)) : 0;
  }

  /// What a combination loses when a side is halved, as parts of its size. Coefficients count with their
  /// middle for the monomial, and with their width for a linear column, which is that of a slope.
  /// Returns the size.
  double add_losses(std::span<const double> multipliers) {
    terms_.assign(plan_.columns().size(), 0);
    widths_.assign(losses_.size(), 0);
    for (std::size_t k = 0; k < multipliers.size(); ++k) {
      if (multipliers[k] == 0) continue;
      const ExpansionRow<FastInterval>& row = expansion_.row(k);
      for (std::size_t c = 0; c < row.columns.size(); ++c) {
        const std::uint32_t column = row.columns[c];
        const Interval value = row.values[c].interval();
        terms_[column] += multipliers[k] * (0.5 * value.lower + 0.5 * value.upper);
        if (column < widths_.size())
          widths_[column] += std::fabs(multipliers[k]) * (value.upper - value.lower);
      }
    }
    double size = std::accumulate(widths_.begin(), widths_.end(), 0.0);
    for (const double term : terms_) size += std::fabs(term);
    if (!(size > 0) || !std::isfinite(size)) return size;
    for (std::size_t c = 0; c < terms_.size(); ++c) {
      if (terms_[c] == 0) continue;
      for (const auto& [variable, power] : plan_.columns()[c].factors)
        losses_[variable] += std::fabs(terms_[c]) * (1 - std::ldexp(1.0, -power)) / size;
    }
    for (std::size_t j = 0; j < widths_.size(); ++j) losses_[j] += widths_[j] / (2 * size);
    return size;
  }

  ExpansionPlan plan_;
  Expansion<FastInterval> expansion_;
  std::unique_ptr<ScoredBisection> equations_;
  LeastSquaresMultipliers system_;
  std::vector<double> multipliers_;
  std::vector<double> terms_, widths_;  ///< of one combination
  std::vector<double> losses_, scores_;
};

}  // namespace

std::unique_ptr<Bisection> make_combined_smear(const SystemFunctions& functions) {
  return std::make_unique<CombinedSmear>(functions);
}

}  // namespace gcslab
