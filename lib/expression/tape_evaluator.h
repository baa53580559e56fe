#pragma once

// Runs a tape over a number type, with first derivatives by the forward and by the reverse mode.
//
// Promise: over a set-valued number type every output encloses {f(p) : p in the box, f defined at p}, and a
// gradient encloses slopes: for all p, q in the box there are s_i in its entries with f(p) - f(q) = sum s_i
// (p_i - q_i). That supposes that f is defined and continuous on the whole box (`defined_everywhere`); kinks
// and infinite derivatives are allowed. Derivative modes: Griewank, Walther, Evaluating Derivatives (2008),
// chapters 3.1 and 3.2.
//
// Compiled for the number types listed at the end of tape_evaluator.cpp; a new number type is one line there.
// A NumberTraits<T>::Scope must be alive, with the same precision, from construction to the last call.

#include <span>
#include <vector>

#include "expression/tape_registers.h"

namespace gcslab {

template <class T>
class TapeEvaluator {
 public:
  /// Converts the constants of the tape. The tape must outlive the evaluator.
  explicit TapeEvaluator(const Tape& tape);

  /// Runs the tape at `point`, one value a variable.
  void evaluate(std::span<const T> point);

  /// Value of output number `output` at the last evaluated point.
  const T& value(std::size_t output = 0) const { return registers_[tape_->outputs()[output]]; }

  /// True when every operation of the last evaluation was defined and continuous on its whole operand (sqrt
  /// of a set with negative members is not), so that mean value theorems apply.
  bool defined_everywhere() const;

  /// Gradient of an output at the last evaluated point: one backward sweep.
  std::span<const T> reverse_gradient(std::size_t output = 0);

  /// Gradient of an output at the last evaluated point: one forward sweep with a tangent a variable.
  std::span<const T> forward_gradient(std::size_t output = 0);

 private:
  void add_adjoints(const Instruction& instruction, const T& value, const T& adjoint);
  T outer_derivative(const Instruction& instruction, const T& value) const;

  const Tape* tape_;
  TapeRegisters<T> registers_;
  std::vector<T> adjoints_;
  std::vector<bool> has_adjoint_;
  std::vector<T> gradient_;
  T zero_, one_;
};

}  // namespace gcslab
