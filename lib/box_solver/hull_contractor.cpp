#include "box_solver/hull_contractor.h"

#include <cmath>

#include "base/check.h"
#include "interval/reverse_operations.h"

namespace gcslab {
namespace {

/// One function of the system with room for the values of its tape.
template <class T>
class HullFunction {
 public:
  HullFunction(const SystemFunction& function, bool is_equation)
      : function_(&function), registers_(function.tape) {
    const double infinity = std::numeric_limits<double>::infinity();
    target_ = NumberTraits<T>::from_interval(is_equation ? Interval(0) : Interval(-infinity, 0));
  }

  const std::vector<std::size_t>& variables() const { return function_->variables; }
  double operations() const { return 4.0 * static_cast<double>(function_->tape.instructions().size()); }
  const T& variable(std::size_t i) const { return registers_[i]; }

  /// Values of all registers over the box, then the same cut down to what the target leaves of them. False:
  /// no point of the box meets the target.
  bool propagate(const std::vector<T>& box) {
    for (const std::size_t i : function_->variables) registers_[i] = box[i];
    registers_.run();
    T& value = registers_[function_->tape.outputs()[0]];
    const Interval before = NumberTraits<T>::enclosure(value);
    value = intersection(value, target_);
    const Interval after = NumberTraits<T>::enclosure(value);
    if (is_empty(after)) return false;
    return after == before || backward();
  }

 private:
  bool narrow(const Instruction& instruction, const T& z);

  bool backward() {
    const Tape& tape = function_->tape;
    for (std::size_t i = tape.instructions().size(); i-- > 0;) {
      if (!narrow(tape.instructions()[i], registers_[tape.first_instruction() + i])) return false;
    }
    return true;
  }

  /// Stores a narrowed operand; false when it is empty. Constants keep their enclosure: narrowed ones would
  /// be wrong for the next box.
  bool replace(std::uint32_t place, const T& value) {
    const Tape& tape = function_->tape;
    const bool is_constant = place >= tape.first_constant() && place < tape.first_instruction();
    const bool is_nonempty = !is_empty(NumberTraits<T>::enclosure(value));
    if (!is_constant) registers_[place] = value;
    return is_nonempty;
  }

  const Rational& exponent(const Instruction& instruction) const {
    return function_->tape.exponents()[instruction.b];
  }

  const SystemFunction* function_;
  TapeRegisters<T> registers_;
  T target_;
};

/// Cuts the operands of z = op(a, b) down to what z leaves of them; false when that is nothing.
template <class T>
bool HullFunction<T>::narrow(const Instruction& instruction, const T& z) {
  const T& a = registers_[instruction.a];
  const auto unary = [&](const T& new_a) { return replace(instruction.a, new_a); };
  // The second operand's projection uses the first one as just narrowed.
  const auto binary = [&](const T& new_a, auto project_b) {
    return replace(instruction.a, new_a) && replace(instruction.b, project_b(registers_[instruction.b]));
  };
  switch (instruction.operation) {
    case Operation::add:
      return binary(intersection(a, z - registers_[instruction.b]),
                    [&](const T& b) { return intersection(b, z - a); });
    case Operation::subtract:
      return binary(intersection(a, z + registers_[instruction.b]),
                    [&](const T& b) { return intersection(b, a - z); });
    case Operation::multiply:
      return binary(reverse_multiply<T>(z, registers_[instruction.b], a),
                    [&](const T& b) { return reverse_multiply<T>(z, a, b); });
    case Operation::divide:
      return binary(reverse_dividend<T>(z, registers_[instruction.b], a),
                    [&](const T& b) { return reverse_divisor<T>(z, a, b); });
    case Operation::min:
      return binary(reverse_min<T>(z, registers_[instruction.b], a),
                    [&](const T& b) { return reverse_min<T>(z, a, b); });
    case Operation::max:
      return binary(reverse_max<T>(z, registers_[instruction.b], a),
                    [&](const T& b) { return reverse_max<T>(z, a, b); });
    case Operation::negate:
      return unary(intersection(a, -z));
    case Operation::sqr:
      return unary(reverse_sqr<T>(z, a));
    case Operation::power_integer:
    case Operation::power_rational:
      return unary(reverse_power<T>(z, exponent(instruction), a));
    case Operation::sqrt:
      return unary(reverse_sqrt<T>(z, a));
    case Operation::cbrt:
      return unary(reverse_cbrt<T>(z, a));
    case Operation::exp:
      return unary(reverse_exp<T>(z, a));
    case Operation::log:
      return unary(reverse_log<T>(z, a));
    case Operation::sin:
      return unary(reverse_sin<T>(z, a));
    case Operation::cos:
      return unary(reverse_cos<T>(z, a));
    case Operation::tan:
      return unary(reverse_tan<T>(z, a));
    case Operation::asin:
      return unary(reverse_asin<T>(z, a));
    case Operation::acos:
      return unary(reverse_acos<T>(z, a));
    case Operation::atan:
      return unary(reverse_atan<T>(z, a));
    case Operation::abs:
      return unary(reverse_abs<T>(z, a));
    case Operation::constant:
    case Operation::pi:
    case Operation::variable:
      break;
  }
  GCSLAB_CHECK(false);
}

template <class T>
class HullContractor final : public Contractor {
 public:
  HullContractor(const SystemFunctions& functions, double ratio, int bits) : ratio_(ratio), bits_(bits) {
    const typename NumberTraits<T>::Scope scope(bits_);
    for (const SystemFunction& f : functions.equations()) functions_.emplace_back(f, true);
    for (const SystemFunction& f : functions.inequalities()) functions_.emplace_back(f, false);
    equations_ = functions.equations().size();
    users_.resize(functions.variables());
    for (std::size_t k = 0; k < functions_.size(); ++k) {
      for (const std::size_t i : functions_[k].variables()) users_[i].push_back(k);
    }
    waiting_.resize(functions_.size());
  }

  double cost() const override {
    double operations = 0;
    for (const HullFunction<T>& function : functions_) operations += function.operations();
    return 3 * operations;  // propagated about three times, forth and back
  }

  bool contract(Box& box, ProofTrace& trace) override {
    const typename NumberTraits<T>::Scope scope(bits_);
    values_.clear();
    for (const Interval& side : box) values_.push_back(NumberTraits<T>::from_interval(side));
    queue_.clear();
    for (std::size_t k = 0; k < functions_.size(); ++k) queue_.push_back(k);
    waiting_.assign(functions_.size(), true);
    // A cap on the work: slow convergence is left to bisection.
    std::size_t left = kRounds * functions_.size();
    for (std::size_t next = 0; next < queue_.size() && left > 0; ++next, --left) {
      const std::size_t k = queue_[next];
      waiting_[k] = false;
      if (!functions_[k].propagate(values_)) {
        trace.add(step(k, 0, Interval()));
        return false;
      }
      take_over(k, box, trace);
    }
    return true;
  }

 private:
  static constexpr std::size_t kRounds = 10;

  ProofStep step(std::size_t function, std::size_t variable, const Interval& result) const {
    const bool is_equation = function < equations_;
    return {is_equation ? Argument::hull_of_equation : Argument::hull_of_inequality,
            static_cast<std::uint32_t>(is_equation ? function : function - equations_),
            static_cast<std::uint32_t>(variable), result};
  }

  /// Takes the narrowed variables of a function over into the box and wakes the functions that use them.
  void take_over(std::size_t k, Box& box, ProofTrace& trace) {
    for (const std::size_t i : functions_[k].variables()) {
      const Interval narrowed = intersection(box[i], NumberTraits<T>::enclosure(functions_[k].variable(i)));
      if (narrowed == box[i]) continue;
      const double old_width = width(box[i]);
      const bool matters =
          std::isinf(old_width) ? width(narrowed) < old_width : width(narrowed) <= (1 - ratio_) * old_width;
      box[i] = narrowed;
      values_[i] = NumberTraits<T>::from_interval(narrowed);
      trace.add(step(k, i, narrowed));
      if (!matters) continue;
      for (const std::size_t user : users_[i]) {
        if (waiting_[user] || user == k) continue;
        waiting_[user] = true;
        queue_.push_back(user);
      }
    }
  }

  double ratio_;
  int bits_;
  std::vector<HullFunction<T>> functions_;
  std::size_t equations_ = 0;
  std::vector<std::vector<std::size_t>> users_;  ///< functions that use a variable
  std::vector<T> values_;
  std::vector<std::size_t> queue_;
  std::vector<bool> waiting_;
};

}  // namespace

template <class T>
std::unique_ptr<Contractor> make_hull_contractor(const SystemFunctions& functions, double ratio, int bits) {
  return std::make_unique<HullContractor<T>>(functions, ratio, bits);
}

template std::unique_ptr<Contractor> make_hull_contractor<FastInterval>(const SystemFunctions&, double, int);
template std::unique_ptr<Contractor> make_hull_contractor<BoostInterval>(const SystemFunctions&, double, int);
template std::unique_ptr<Contractor> make_hull_contractor<MpfrInterval>(const SystemFunctions&, double, int);
template std::unique_ptr<Contractor> make_hull_contractor<UnroundedInterval>(const SystemFunctions&, double,
                                                                             int);

}  // namespace gcslab
