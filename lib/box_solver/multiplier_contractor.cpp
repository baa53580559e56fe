#include "box_solver/multiplier_contractor.h"

#include <cmath>

#include "box_solver/combined_row.h"
#include "box_solver/expansion_multipliers.h"
#include "interval/arithmetic.h"

namespace gcslab {
namespace {

template <class T>
class MultiplierContractor final : public Contractor {
 public:
  MultiplierContractor(const SystemFunctions& functions, const MultiplierOptions& options)
      : options_(options),
        plan_(functions, ExpandedFunctions::equations_and_multiples),
        parts_(made(plan_, options)) {}

  /// A combination and its solution for each variable, and the factorisation.
  double cost() const override {
    const auto n = static_cast<double>(plan_.functions().variables());
    const auto m = static_cast<double>(plan_.rows());
    return (3 * n + m * m) * static_cast<double>(plan_.columns().size());
  }

  bool contract(Box& box, ProofTrace& trace) override {
    for (const Interval& side : box) {
      if (!is_bounded(side)) return true;
    }
    const typename NumberTraits<T>::Scope scope(options_.bits);
    Expansion<T>& expansion = parts_.expansion;
    expansion.expand(box);
    if (!compute_multipliers(expansion, system_)) return true;
    trace.add({Argument::expansion});
    scale_box(box);
    expansion.bound_columns(z_);
    if (!exclude(box, trace)) return false;
    for (int pass = 0; pass < options_.passes; ++pass) {
      if (pass > 0) expansion.bound_columns(z_);
      bool gained = false;
      for (std::size_t i = 0; i < box.size(); ++i) {
        const double before = width(box[i]);
        if (!solve_for(i, box, pass == 0, trace)) return false;
        gained = gained || width(box[i]) < kWorthAnotherPass * before;
      }
      if (!gained) return pass > 0 || solve_squares(box, trace);
    }
    return true;
  }

 private:
  static constexpr double kWorthAnotherPass = 0.9;

  struct Parts {
    Expansion<T> expansion;
    std::vector<CombinedRow<T>> rows;  ///< one a variable, kept for the second pass
  };

  static Parts made(const ExpansionPlan& plan, const MultiplierOptions& options) {
    const typename NumberTraits<T>::Scope scope(options.bits);
    return {Expansion<T>(plan),
            std::vector<CombinedRow<T>>(plan.functions().variables(), CombinedRow<T>(plan))};
  }

  void scale_box(const Box& box) {
    z_.clear();
    for (std::size_t i = 0; i < box.size(); ++i) z_.push_back(scaled_side(i, box[i]));
  }

  /// Encloses (side - m) / r; [-1, 1] for a point.
  T scaled_side(std::size_t i, const Interval& side) const {
    const double r = parts_.expansion.radii()[i];
    const T unit = NumberTraits<T>::from_interval(Interval(-1, 1));
    if (r == 0) return NumberTraits<T>::from_interval(Interval(0));
    const T offset = NumberTraits<T>::from_interval(side) -
                     NumberTraits<T>::from_interval(Interval(parts_.expansion.midpoints()[i]));
    return intersection(offset / NumberTraits<T>::from_interval(Interval(r)), unit);
  }

  bool solve_for(std::size_t i, Box& box, bool first_pass, ProofTrace& trace) {
    CombinedRow<T>& row = parts_.rows[i];
    const std::span<const double> multipliers = system_.multipliers(i);
    if (first_pass) row.combine(parts_.expansion, multipliers);
    return take_over(i, row.solve(i, z_, parts_.expansion), {Argument::expansion_row, multipliers}, box,
                     trace);
  }

  /// The combination that comes nearest to a constant, solved for the variable that it has most of: false
  /// where it shows that the box is empty.
  bool exclude(Box& box, ProofTrace& trace) {
    extra_multipliers_.resize(plan_.rows());
    if (!system_.solve_for_constant(extra_multipliers_)) return true;
    CombinedRow<T>& row = parts_.rows.front();
    row.combine(parts_.expansion, extra_multipliers_);
    const std::size_t i = row.dominant_variable();
    return take_over(i, row.solve(i, z_, parts_.expansion), {Argument::expansion_row, extra_multipliers_},
                     box, trace);
  }

  /// Where the linear parts determine nothing, as around a tangency, combinations in which a square
  /// dominates.
  bool solve_squares(Box& box, ProofTrace& trace) {
    extra_multipliers_.resize(plan_.rows());
    for (std::size_t i = 0; i < box.size(); ++i) {
      CombinedRow<T>& row = parts_.rows[i];
      const auto column = row.square_column(i);
      if (!column || !system_.solve_for(*column, extra_multipliers_)) continue;
      row.combine(parts_.expansion, extra_multipliers_);
      if (!take_over(i, row.solve_square(i, z_, parts_.expansion), {Argument::square_row, extra_multipliers_},
                     box, trace))
        return false;
    }
    return true;
  }

  struct Reason {
    Argument argument;
    std::span<const double> multipliers;
  };

  /// Takes a new range of z_i over into the box. False when nothing is left.
  bool take_over(std::size_t i, const T& solved, const Reason& reason, Box& box, ProofTrace& trace) {
    const Interval reduced = NumberTraits<T>::enclosure(solved);
    if (reduced == NumberTraits<T>::enclosure(z_[i])) return true;
    Interval side = Interval::empty();
    if (!is_empty(reduced)) {
      const T x = NumberTraits<T>::from_interval(Interval(parts_.expansion.midpoints()[i])) +
                  solved * NumberTraits<T>::from_interval(Interval(parts_.expansion.radii()[i]));
      side = intersection(box[i], NumberTraits<T>::enclosure(x));
    }
    if (side == box[i]) return true;
    tell(i, side, reason, trace);
    if (is_empty(side)) return false;
    box[i] = side;
    z_[i] = scaled_side(i, side);
    return true;
  }

  void tell(std::size_t i, const Interval& side, const Reason& reason, ProofTrace& trace) const {
    if (!trace.wanted()) return;
    const std::size_t equations = plan_.functions().equations().size();
    ProofStep step{reason.argument, 0, static_cast<std::uint32_t>(i), side};
    step.multipliers.assign(reason.multipliers.begin(),
                            reason.multipliers.begin() + static_cast<std::ptrdiff_t>(equations));
    for (std::size_t m = 0; m < plan_.multiples().size(); ++m) {
      const double multiplier = reason.multipliers[equations + m];
      if (multiplier != 0) step.multiples.push_back({plan_.multiples()[m], multiplier});
    }
    trace.add(std::move(step));
  }

  MultiplierOptions options_;
  ExpansionPlan plan_;
  Parts parts_;
  LeastSquaresMultipliers system_;
  std::vector<T> z_;
  std::vector<double> extra_multipliers_;
};

}  // namespace

template <class T>
std::unique_ptr<Contractor> make_multiplier_contractor(const SystemFunctions& functions,
                                                       const MultiplierOptions& options) {
  return std::make_unique<MultiplierContractor<T>>(functions, options);
}

template std::unique_ptr<Contractor> make_multiplier_contractor<FastInterval>(const SystemFunctions&,
                                                                              const MultiplierOptions&);
template std::unique_ptr<Contractor> make_multiplier_contractor<BoostInterval>(const SystemFunctions&,
                                                                               const MultiplierOptions&);
template std::unique_ptr<Contractor> make_multiplier_contractor<MpfrInterval>(const SystemFunctions&,
                                                                              const MultiplierOptions&);
template std::unique_ptr<Contractor> make_multiplier_contractor<UnroundedInterval>(const SystemFunctions&,
                                                                                   const MultiplierOptions&);

}  // namespace gcslab
