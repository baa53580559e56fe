#include "expression/tape_evaluator.h"

#include <limits>

#include "base/check.h"
#include "interval/affine_form.h"
#include "interval/boost_interval.h"
#include "interval/fast_interval.h"
#include "interval/mpfr_interval.h"
#include "interval/number_traits.h"
#include "interval/point_numbers.h"
#include "interval/unrounded_interval.h"

namespace gcslab {

template <class T>
TapeEvaluator<T>::TapeEvaluator(const Tape& tape)
    : tape_(&tape),
      registers_(tape),
      zero_(NumberTraits<T>::from_rational(0)),
      one_(NumberTraits<T>::from_rational(1)) {}

template <class T>
void TapeEvaluator<T>::evaluate(std::span<const T> point) {
  GCSLAB_CHECK(point.size() == tape_->variables());
  for (std::size_t i = 0; i < point.size(); ++i) registers_[i] = point[i];
  registers_.run();
}

namespace {

/// Whether the operation is defined and continuous at every member of its operands.
bool is_defined_on(Operation operation, const Rational* exponent, const Interval& a, const Interval& b,
                   const Interval& result) {
  switch (operation) {
    case Operation::divide:
      return !contains(b, 0);
    case Operation::sqrt:
      return a.lower >= 0;
    case Operation::log:
      return a.lower > 0;
    case Operation::asin:
    case Operation::acos:
      return subset(a, Interval(-1, 1));
    case Operation::tan:
      return is_bounded(result);
    case Operation::power_integer:
      return *exponent >= 0 || !contains(a, 0);
    case Operation::power_rational: {
      const bool odd_root = mpz_odd_p(exponent->get_den_mpz_t()) != 0;
      if (*exponent < 0) return odd_root ? !contains(a, 0) : a.lower > 0;
      return odd_root || a.lower >= 0;
    }
    default:
      return true;
  }
}

bool has_exponent(Operation operation) {
  return operation == Operation::power_integer || operation == Operation::power_rational;
}

/// Where f is defined but its derivative nowhere (sqrt on {0}), the operand has one value, so that any slope
/// will do; the empty set would lose everything that it is multiplied with.
template <class T>
T nonempty_slope(const T& slope) {
  if constexpr (requires { NumberTraits<T>::from_interval(Interval::entire()); }) {
    if (is_empty(NumberTraits<T>::enclosure(slope)))
      return NumberTraits<T>::from_interval(Interval::entire());
  }
  return slope;
}

}  // namespace

template <class T>
bool TapeEvaluator<T>::defined_everywhere() const {
  const T* result = registers_.results();
  for (const Instruction& instruction : tape_->instructions()) {
    const OperationInfo& operation = info(instruction.operation);
    const T& value = *result++;
    if (operation.total) continue;
    const Rational* exponent =
        has_exponent(operation.operation) ? &tape_->exponents()[instruction.b] : nullptr;
    const Interval b =
        operation.operands == 2 ? NumberTraits<T>::enclosure(registers_[instruction.b]) : Interval();
    if (!is_defined_on(operation.operation, exponent, NumberTraits<T>::enclosure(registers_[instruction.a]),
                       b, NumberTraits<T>::enclosure(value))) {
      return false;
    }
  }
  return true;
}

/// An enclosure of the slopes of an operation of one operand: of (g(p) - g(q)) / (p - q) for p, q in the
/// operand. The operations are continuous on it (defined_everywhere), so that derivatives, infinite ones
/// included, enclose them.
template <class T>
T TapeEvaluator<T>::outer_derivative(const Instruction& instruction, const T& value) const {
  const T& a = registers_[instruction.a];
  switch (instruction.operation) {
    case Operation::negate:
      return -one_;
    case Operation::sqr:
      return a + a;
    case Operation::power_integer:
    case Operation::power_rational: {
      const Rational& exponent = tape_->exponents()[instruction.b];
      return nonempty_slope<T>(NumberTraits<T>::from_rational(exponent) *
                               TapeRegisters<T>::power(a, exponent - 1));
    }
    case Operation::sqrt:
      return nonempty_slope<T>(one_ / (value + value));
    case Operation::cbrt:
      return nonempty_slope<T>(one_ / (NumberTraits<T>::from_rational(3) * sqr(value)));
    case Operation::exp:
      return value;
    case Operation::log:
      return nonempty_slope<T>(one_ / a);
    case Operation::sin:
      return cos(a);
    case Operation::cos:
      return -sin(a);
    case Operation::tan:
      return one_ + sqr(value);
    case Operation::asin:
      return nonempty_slope<T>(one_ / sqrt(one_ - sqr(a)));
    case Operation::acos:
      return nonempty_slope<T>(-(one_ / sqrt(one_ - sqr(a))));
    case Operation::atan:
      return one_ / (one_ + sqr(a));
    case Operation::abs:
      return sign_enclosure(a);
    default:
      GCSLAB_CHECK(false);
  }
}

template <class T>
void TapeEvaluator<T>::add_adjoints(const Instruction& instruction, const T& value, const T& adjoint) {
  const auto add_to = [this](std::uint32_t place, const T& contribution) {
    adjoints_[place] = has_adjoint_[place] ? adjoints_[place] + contribution : contribution;
    has_adjoint_[place] = true;
  };
  const std::uint32_t a = instruction.a;
  const std::uint32_t b = instruction.b;
  switch (instruction.operation) {
    case Operation::add:
      add_to(a, adjoint), add_to(b, adjoint);
      return;
    case Operation::subtract:
      add_to(a, adjoint), add_to(b, -adjoint);
      return;
    case Operation::multiply:
      add_to(a, adjoint * registers_[b]), add_to(b, adjoint * registers_[a]);
      return;
    case Operation::divide: {
      const T quotient = adjoint / registers_[b];
      add_to(a, quotient), add_to(b, -(quotient * value));
      return;
    }
    case Operation::min: {
      const T first = less_enclosure(registers_[a], registers_[b]);
      add_to(a, adjoint * first), add_to(b, adjoint * (one_ - first));
      return;
    }
    case Operation::max: {
      const T first = less_enclosure(registers_[b], registers_[a]);
      add_to(a, adjoint * first), add_to(b, adjoint * (one_ - first));
      return;
    }
    default:
      add_to(a, adjoint * outer_derivative(instruction, value));
  }
}

template <class T>
std::span<const T> TapeEvaluator<T>::reverse_gradient(std::size_t output) {
  adjoints_.resize(tape_->registers(), zero_);
  has_adjoint_.assign(tape_->registers(), false);
  adjoints_[tape_->outputs()[output]] = one_;
  has_adjoint_[tape_->outputs()[output]] = true;
  const auto& instructions = tape_->instructions();
  for (std::size_t i = instructions.size(); i-- > 0;) {
    const std::size_t place = tape_->first_instruction() + i;
    if (has_adjoint_[place]) add_adjoints(instructions[i], registers_[place], adjoints_[place]);
  }
  gradient_.assign(tape_->variables(), zero_);
  for (std::size_t i = 0; i < gradient_.size(); ++i) {
    if (has_adjoint_[i]) gradient_[i] = adjoints_[i];
  }
  return gradient_;
}

template <class T>
std::span<const T> TapeEvaluator<T>::forward_gradient(std::size_t output) {
  const std::size_t n = tape_->variables();
  std::vector<std::vector<T>> tangents(tape_->registers());  // empty: zero
  for (std::size_t i = 0; i < n; ++i) {
    tangents[i].assign(n, zero_);
    tangents[i][i] = one_;
  }
  const auto add_scaled = [&](std::vector<T>& sum, std::uint32_t operand, const T& factor) {
    if (tangents[operand].empty()) return;
    if (sum.empty()) sum.assign(n, zero_);
    for (std::size_t k = 0; k < n; ++k) sum[k] = sum[k] + factor * tangents[operand][k];
  };
  for (std::size_t i = 0; i < tape_->instructions().size(); ++i) {
    const Instruction& instruction = tape_->instructions()[i];
    const std::size_t place = tape_->first_instruction() + i;
    const T& value = registers_[place];
    const T& a = registers_[instruction.a];
    std::vector<T>& sum = tangents[place];
    switch (instruction.operation) {
      case Operation::add:
        add_scaled(sum, instruction.a, one_), add_scaled(sum, instruction.b, one_);
        break;
      case Operation::subtract:
        add_scaled(sum, instruction.a, one_), add_scaled(sum, instruction.b, -one_);
        break;
      case Operation::multiply:
        add_scaled(sum, instruction.a, registers_[instruction.b]), add_scaled(sum, instruction.b, a);
        break;
      case Operation::divide:
        add_scaled(sum, instruction.a, one_ / registers_[instruction.b]);
        add_scaled(sum, instruction.b, -(value / registers_[instruction.b]));
        break;
      case Operation::min:
      case Operation::max: {
        const T& b = registers_[instruction.b];
        const T first = instruction.operation == Operation::min ? less_enclosure(a, b) : less_enclosure(b, a);
        add_scaled(sum, instruction.a, first), add_scaled(sum, instruction.b, one_ - first);
        break;
      }
      default:
        add_scaled(sum, instruction.a, outer_derivative(instruction, value));
    }
  }
  const std::vector<T>& result = tangents[tape_->outputs()[output]];
  gradient_ = result.empty() ? std::vector<T>(n, zero_) : result;
  return gradient_;
}

template class TapeEvaluator<float>;
template class TapeEvaluator<double>;
template class TapeEvaluator<Rational>;
template class TapeEvaluator<FastInterval>;
template class TapeEvaluator<BoostInterval>;
template class TapeEvaluator<MpfrInterval>;
template class TapeEvaluator<UnroundedInterval>;
template class TapeEvaluator<ChebyshevAffine>;
template class TapeEvaluator<MinRangeAffine>;

}  // namespace gcslab
