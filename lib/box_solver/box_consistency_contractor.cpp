#include "box_solver/box_consistency_contractor.h"

#include <algorithm>
#include <cmath>

#include "interval/arithmetic.h"

namespace gcslab {
namespace {

/// The variables that more than one operand of the tape refers to.
std::vector<std::size_t> repeated_variables(const SystemFunction& function) {
  std::vector<int> uses(function.tape.registers(), 0);
  for (const Instruction& instruction : function.tape.instructions()) {
    ++uses[instruction.a];
    if (info(instruction.operation).operands == 2) ++uses[instruction.b];
  }
  std::vector<std::size_t> result;
  for (const std::size_t i : function.variables) {
    if (uses[i] > 1) result.push_back(i);
  }
  return result;
}

template <class T>
class BoxConsistencyContractor final : public Contractor {
 public:
  BoxConsistencyContractor(const SystemFunctions& functions, const BoxConsistencyOptions& options)
      : options_(options) {
    const typename NumberTraits<T>::Scope scope(options_.bits);
    add(functions.equations(), Argument::hull_of_equation);
    add(functions.inequalities(), Argument::hull_of_inequality);
  }

  bool contract(Box& box, ProofTrace& trace) override {
    const typename NumberTraits<T>::Scope scope(options_.bits);
    values_.clear();
    for (const Interval& side : box) values_.push_back(NumberTraits<T>::from_interval(side));
    for (Function& function : functions_) {
      for (const std::size_t i : function.variables) {
        if (!std::isfinite(width(box[i]))) continue;
        if (!sweep_up(function, i, box[i], trace) || !sweep_down(function, i, box[i], trace)) return false;
      }
    }
    return true;
  }

 private:
  struct Function {
    Argument argument;
    std::uint32_t number;
    std::vector<std::size_t> variables;
    TapeEvaluator<T> evaluator;
  };

  void add(const std::vector<SystemFunction>& functions, Argument argument) {
    for (std::size_t k = 0; k < functions.size(); ++k) {
      functions_.push_back({argument, static_cast<std::uint32_t>(k), repeated_variables(functions[k]),
                            TapeEvaluator<T>(functions[k].tape)});
    }
  }

  /// Whether the function has no root, or is positive if it is an inequality's, where variable i lies in the
  /// slice and the others in the box.
  bool refutes(Function& function, std::size_t i, const Interval& slice) {
    values_[i] = NumberTraits<T>::from_interval(slice);
    function.evaluator.evaluate(values_);
    const Interval value = NumberTraits<T>::enclosure(function.evaluator.value());
    if (is_empty(value) || value.lower > 0) return true;
    return function.argument == Argument::hull_of_equation && value.upper < 0;
  }

  /// Moves the lower end of the side upward. False: nothing is left.
  bool sweep_up(Function& function, std::size_t i, Interval& side, ProofTrace& trace) {
    const double whole = width(side);
    double step = options_.first_slice * whole;
    while (step >= options_.precision * whole) {
      const double border = std::min(side.lower + step, side.upper);
      if (!(border > side.lower)) break;
      const bool is_refuted = refutes(function, i, {side.lower, border});
      if (is_refuted) {
        if (border == side.upper) return refuted(function, i, trace);
        tell(function, i, border, Half::lower, trace);
        side.lower = border;
      }
      step *= is_refuted ? kGrowth : 1 / kGrowth;
    }
    values_[i] = NumberTraits<T>::from_interval(side);
    return true;
  }

  /// Moves the upper end of the side downward. False: nothing is left.
  bool sweep_down(Function& function, std::size_t i, Interval& side, ProofTrace& trace) {
    const double whole = width(side);
    double step = options_.first_slice * whole;
    while (step >= options_.precision * whole) {
      const double border = std::max(side.upper - step, side.lower);
      if (!(border < side.upper)) break;
      const bool is_refuted = refutes(function, i, {border, side.upper});
      if (is_refuted) {
        if (border == side.lower) return refuted(function, i, trace);
        tell(function, i, border, Half::upper, trace);
        side.upper = border;
      }
      step *= is_refuted ? kGrowth : 1 / kGrowth;
    }
    values_[i] = NumberTraits<T>::from_interval(side);
    return true;
  }

  enum class Half { lower, upper };
  static constexpr double kGrowth = 2;

  static ProofStep refutation(const Function& function, std::size_t i) {
    return {function.argument, function.number, static_cast<std::uint32_t>(i), Interval::empty()};
  }

  static bool refuted(const Function& function, std::size_t i, ProofTrace& trace) {
    trace.add(refutation(function, i));
    return false;
  }

  static void tell(const Function& function, std::size_t i, double border, Half refuted_half,
                   ProofTrace& trace) {
    if (!trace.wanted()) return;
    trace.add({Argument::cases, 0, static_cast<std::uint32_t>(i), Interval(border)});
    if (refuted_half == Half::lower) trace.add(refutation(function, i));
    trace.add({Argument::otherwise});
    if (refuted_half == Half::upper) trace.add(refutation(function, i));
    trace.add({Argument::join});
  }

  BoxConsistencyOptions options_;
  std::vector<Function> functions_;
  std::vector<T> values_;
};

}  // namespace

template <class T>
std::unique_ptr<Contractor> make_box_consistency_contractor(const SystemFunctions& functions,
                                                            const BoxConsistencyOptions& options) {
  return std::make_unique<BoxConsistencyContractor<T>>(functions, options);
}

template std::unique_ptr<Contractor> make_box_consistency_contractor<FastInterval>(
    const SystemFunctions&, const BoxConsistencyOptions&);
template std::unique_ptr<Contractor> make_box_consistency_contractor<BoostInterval>(
    const SystemFunctions&, const BoxConsistencyOptions&);
template std::unique_ptr<Contractor> make_box_consistency_contractor<MpfrInterval>(
    const SystemFunctions&, const BoxConsistencyOptions&);
template std::unique_ptr<Contractor> make_box_consistency_contractor<UnroundedInterval>(
    const SystemFunctions&, const BoxConsistencyOptions&);

}  // namespace gcslab
