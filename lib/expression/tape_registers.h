#pragma once

// The registers of a tape over a number type, and the run that fills them.
//
// Promise: over a set-valued number type each register encloses the values of its node over those of its
// operands.

#include <vector>

#include "base/check.h"
#include "expression/tape.h"
#include "interval/number_traits.h"
#include "interval/point_numbers.h"

namespace gcslab {

template <class T>
class TapeRegisters {
 public:
  /// Converts the constants of the tape, which must outlive it.
  explicit TapeRegisters(const Tape& tape)
      : tape_(&tape), registers_(tape.registers(), NumberTraits<T>::from_rational(0)) {
    for (std::size_t i = 0; i < tape.constants().size(); ++i) {
      registers_[tape.first_constant() + i] =
          tape.is_pi(i) ? NumberTraits<T>::pi() : NumberTraits<T>::from_rational(tape.constants()[i]);
    }
  }

  const Tape& tape() const { return *tape_; }
  T& operator[](std::size_t i) { return registers_[i]; }
  const T& operator[](std::size_t i) const { return registers_[i]; }
  /// The result of the first instruction; those of the others follow.
  const T* results() const { return registers_.data() + tape_->first_instruction(); }

  /// Every instruction in turn, from the variables as they are.
  void run() {
    T* result = registers_.data() + tape_->first_instruction();
    for (const Instruction& instruction : tape_->instructions()) *result++ = value_of(instruction);
  }

  static T power(const T& base, const Rational& exponent) {
    if (exponent.get_den() == 1) return pow(base, static_cast<int>(exponent.get_num().get_si()));
    return pow(base, exponent);
  }

 private:
  T value_of(const Instruction& instruction) const;

  const Tape* tape_;
  std::vector<T> registers_;
};

template <class T>
T TapeRegisters<T>::value_of(const Instruction& instruction) const {
  const T& a = registers_[instruction.a];
  switch (instruction.operation) {
    case Operation::add:
      return a + registers_[instruction.b];
    case Operation::subtract:
      return a - registers_[instruction.b];
    case Operation::multiply:
      return a * registers_[instruction.b];
    case Operation::divide:
      return a / registers_[instruction.b];
    case Operation::negate:
      return -a;
    case Operation::sqr:
      return sqr(a);
    case Operation::power_integer:
      return pow(a, static_cast<int>(tape_->exponents()[instruction.b].get_num().get_si()));
    case Operation::power_rational:
      return pow(a, tape_->exponents()[instruction.b]);
    case Operation::sqrt:
      return sqrt(a);
    case Operation::cbrt:
      return cbrt(a);
    case Operation::exp:
      return exp(a);
    case Operation::log:
      return log(a);
    case Operation::sin:
      return sin(a);
    case Operation::cos:
      return cos(a);
    case Operation::tan:
      return tan(a);
    case Operation::asin:
      return asin(a);
    case Operation::acos:
      return acos(a);
    case Operation::atan:
      return atan(a);
    case Operation::abs:
      return abs(a);
    case Operation::min:
      return min(a, registers_[instruction.b]);
    case Operation::max:
      return max(a, registers_[instruction.b]);
    case Operation::constant:
    case Operation::pi:
    case Operation::variable:
      break;
  }
  GCSLAB_CHECK(false);
}

}  // namespace gcslab
