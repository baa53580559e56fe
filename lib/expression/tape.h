#pragma once

// A tape is a list of expressions compiled to straight-line code over numbered registers.
//
// Registers: first the variables, then the constants, then one register an instruction. Common subexpressions
// are computed once. A tape knows nothing of numbers: tape_evaluator.h runs it over any number type.

#include <cstdint>
#include <span>
#include <vector>

#include "expression/expression.h"

namespace gcslab {

struct Instruction {
  Operation operation;
  std::uint32_t a = 0;  ///< register of the first operand
  std::uint32_t b = 0;  ///< register of the second operand; for powers: index of the exponent
};

class Tape {
 public:
  /// Compiles expressions of one graph in `variables` variables.
  Tape(std::span<const Expression> outputs, int variables);
  Tape(Expression output, int variables) : Tape(std::span<const Expression>(&output, 1), variables) {}

  std::size_t variables() const { return variables_; }
  std::size_t registers() const { return first_instruction() + instructions_.size(); }
  std::size_t first_constant() const { return variables_; }
  std::size_t first_instruction() const { return variables_ + constants_.size(); }

  const std::vector<Rational>& constants() const { return constants_; }
  /// True when constant number i stands for pi instead of a rational.
  bool is_pi(std::size_t i) const { return pi_constant_ == static_cast<std::ptrdiff_t>(i); }
  const std::vector<Instruction>& instructions() const { return instructions_; }
  const std::vector<Rational>& exponents() const { return exponents_; }
  /// Registers of the compiled expressions, in their order.
  const std::vector<std::uint32_t>& outputs() const { return outputs_; }

 private:
  std::size_t variables_;
  std::vector<Rational> constants_;
  std::ptrdiff_t pi_constant_ = -1;
  std::vector<Rational> exponents_;
  std::vector<Instruction> instructions_;
  std::vector<std::uint32_t> outputs_;
};

}  // namespace gcslab
