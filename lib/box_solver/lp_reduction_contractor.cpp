#include "box_solver/lp_reduction_contractor.h"

#include <algorithm>
#include <optional>

#include "base/error.h"
#include "box_solver/term_ranges.h"
#include "interval/fast_interval.h"
#include "linear_program/lp_registry.h"

namespace gcslab {
namespace {

Expansion<FastInterval> made_in_scope(const ExpansionPlan& plan) {
  const NumberTraits<FastInterval>::Scope scope;
  return Expansion<FastInterval>(plan);
}

class LpReductionContractor final : public Contractor {
 public:
  LpReductionContractor(const SystemFunctions& functions, const LpReductionSettings& settings)
      : system_(functions),
        terms_(system_),
        plan_(system_.functions(), ExpandedFunctions::constraints),
        expansion_(made_in_scope(plan_)),
        backend_(lp_registry().at(settings.backend)),
        products_(settings.products),
        options_{.safety = settings.safety, .negligible_gain = 1e-3},
        strips_(terms_.graphs().size()) {}

  /// Two programs a variable, each with steps in proportion to the columns; a step updates an inverse, in
  /// plain vector arithmetic.
  double cost() const override {
    constexpr double kStepsPerColumn = 2;
    constexpr double kVectorised = 0.1;
    const auto columns = static_cast<double>(BernsteinPolytope::columns_for(plan_));
    const double step = columns * columns;
    return kVectorised * 2 * static_cast<double>(variables()) * kStepsPerColumn * columns * step;
  }

  double last_cost() const override { return last_cost_; }

  bool contract(Box& box, ProofTrace& trace) override {
    last_cost_ = 0;
    if (!std::ranges::all_of(box, is_bounded)) return true;
    const Box lifted = terms_.lift(box);
    if (!std::ranges::all_of(lifted, is_bounded)) return true;
    fill_polytope(lifted);
    trace.add(
        {.argument = Argument::expansion, .terms = Box(lifted.begin() + std::ssize(box), lifted.end())});
    options_.keep_certificates = trace.wanted();
    // A solver of its own for each box: one that starts from an earlier box's basis would answer differently
    // after other boxes.
    const std::unique_ptr<LpBackend> solver = backend_.make_with();
    LpReduction reduction(*solver, options_);
    const LpReductionResult& result =
        reduction.reduce(polytope_->model(), both_sides(static_cast<int>(box.size())));
    last_cost_ = static_cast<double>(result.iterations) * cost_of_step();
    if (result.infeasible) {
      tell_empty(result.ray, trace);
      return false;
    }
    return take_over(result, box, trace);
  }

 private:
  /// Of a step of the simplex method, fitted to times on polytopes of 18 to 679 columns.
  double cost_of_step() const {
    const auto columns = static_cast<double>(polytope_->model().columns());
    const auto entries = static_cast<double>(polytope_->model().entries());
    return 550 + 0.22 * columns * columns + 0.5 * entries;
  }

  void fill_polytope(const Box& lifted) {
    {
      const NumberTraits<FastInterval>::Scope scope;
      expansion_.expand(lifted);
    }
    if (!polytope_) polytope_.emplace(plan_, products_, terms_.graphs());
    polytope_->refill(expansion_);
    for (std::size_t g = 0; g < terms_.graphs().size(); ++g) {
      strips_[g] = terms_.strips(g, lifted);
      polytope_->refill_strips(g, strips_[g], expansion_);
    }
  }

  bool take_over(const LpReductionResult& result, Box& box, ProofTrace& trace) {
    for (std::size_t i = 0; i < box.size(); ++i) {
      const Interval z = result.bounds[i];
      const Interval side = is_empty(z) ? Interval::empty() : intersection(box[i], unscaled(i, z));
      tell_sides(i, side, result, box[i], trace);
      if (is_empty(side)) return false;
      box[i] = side;
    }
    return true;
  }

  /// m_i + r_i z.
  Interval unscaled(std::size_t i, const Interval& z) const {
    const NumberTraits<FastInterval>::Scope scope;
    const FastInterval x =
        FastInterval(expansion_.midpoints()[i]) + FastInterval(expansion_.radii()[i]) * FastInterval(z);
    return x.interval();
  }

  /// One step for each end that moved.
  void tell_sides(std::size_t i, const Interval& side, const LpReductionResult& result, Interval before,
                  ProofTrace& trace) const {
    if (!trace.wanted() || side == before) return;
    for (const BoundCertificate& certificate : result.certificates) {
      if (certificate.goal.column != static_cast<int>(i)) continue;
      if (certificate.goal.side == BoundSide::lower) before.lower = std::max(before.lower, side.lower);
      if (certificate.goal.side == BoundSide::upper) before.upper = std::min(before.upper, side.upper);
      ProofStep step{Argument::polytope, 0, static_cast<std::uint32_t>(i), is_empty(side) ? side : before};
      step.multipliers.assign(plan_.rows(), 0);
      for (const auto& [row, multiplier] : certificate.multipliers) add_row(row, multiplier, step);
      trace.add(std::move(step));
    }
  }

  void tell_empty(const std::vector<double>& ray, ProofTrace& trace) const {
    if (!trace.wanted()) return;
    ProofStep step{Argument::polytope};
    step.multipliers.assign(plan_.rows(), 0);
    for (std::size_t row = 0; row < ray.size(); ++row) add_row(static_cast<int>(row), ray[row], step);
    trace.add(std::move(step));
  }

  void add_row(int row, double multiplier, ProofStep& step) const {
    const auto number = static_cast<std::size_t>(row);
    // Multipliers of the wrong sign ask for a side that is not there, and count as 0.
    if (number < plan_.rows()) {
      if (!plan_.is_inequality(number) || multiplier < 0)
        step.multipliers[number] = multiplier * polytope_->scale(number);
    } else if (number >= polytope_->first_strip()) {
      add_strip(number, multiplier, step);
    } else if (multiplier > 0) {
      const ProductRow& product = polytope_->products()[number - plan_.rows()];
      ProductMultiplier proof{{}, product.is_square, multiplier};
      for (const auto& [column, sign] : product.factors)
        proof.factors.push_back({sign, variables_of(column)});
      step.products.push_back(std::move(proof));
    }
  }

  void add_strip(std::size_t row, double multiplier, ProofStep& step) const {
    if (multiplier == 0) return;
    const std::size_t strip = row - polytope_->first_strip();
    const std::size_t graph = strip / kStripsOfGraph;
    const std::size_t term = terms_.graphs()[graph].value - variables();
    step.strips.push_back({static_cast<std::uint32_t>(term), strips_[graph][strip % kStripsOfGraph].slope,
                           multiplier * polytope_->scale(row)});
  }

  std::vector<std::uint32_t> variables_of(std::size_t column) const {
    std::vector<std::uint32_t> result;
    for (const auto& [variable, power] : plan_.columns()[column].factors)
      result.insert(result.end(), static_cast<std::size_t>(power), variable);
    return result;
  }

  std::size_t variables() const { return system_.variables(); }

  LiftedSystem system_;
  TermRanges terms_;
  ExpansionPlan plan_;
  Expansion<FastInterval> expansion_;
  std::optional<BernsteinPolytope> polytope_;  ///< made when first needed
  const LpBackendVariant& backend_;
  BoundProducts products_;
  LpReductionOptions options_;
  double last_cost_ = 0;
  std::vector<StripsOfGraph> strips_;  ///< one entry a graph
};

}  // namespace

std::unique_ptr<Contractor> make_lp_reduction_contractor(const SystemFunctions& functions,
                                                         const LpReductionSettings& settings) {
  return std::make_unique<LpReductionContractor>(functions, settings);
}

LpSafety lp_safety_from_name(const std::string& name) {
  if (name == "dual") return LpSafety::dual;
  if (name == "exact") return LpSafety::exact;
  if (name == "tolerance") return LpSafety::tolerance;
  if (name == "unprotected") return LpSafety::unprotected;
  throw InputError("lp_safety is '" + name + "'; expected one of dual, exact, tolerance, unprotected");
}

}  // namespace gcslab
