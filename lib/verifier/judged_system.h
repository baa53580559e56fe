#pragma once

// A system of equations and inequalities as the verifier evaluates it: its own programs, its own polynomials.

#include <optional>
#include <span>
#include <vector>

#include "expression/equation_system.h"
#include "verifier/box_relations.h"
#include "verifier/polynomial_terms.h"
#include "verifier/program.h"

namespace gcslab::verifier {

/// Rows of numbers.
using RangeMatrix = std::vector<std::vector<Range>>;

struct JudgedFunction {
  Expression expression;
  Program program;
  std::optional<PolynomialTerms> polynomial;
  int degree;  ///< of the polynomial; -1 without one
};

class JudgedSystem {
 public:
  explicit JudgedSystem(const EquationSystem& system);

  std::size_t variables() const { return variables_; }
  bool is_square() const { return equations_.size() == variables_; }
  std::vector<JudgedFunction>& equations() { return equations_; }        ///< each is to vanish
  std::vector<JudgedFunction>& inequalities() { return inequalities_; }  ///< each is to be <= 0

  /// Slopes of an equation from points of `centre` to points of `box`: f(p) - f(c) = S (p - c). For degree 2
  /// and less they are the gradient at (p + c) / 2. False where the equation may be undefined or
  /// discontinuous.
  [[nodiscard]] bool slopes(std::size_t equation, std::span<const Range> box, std::span<const Range> centre,
                            std::vector<Range>& row);
  [[nodiscard]] bool slopes(std::span<const Range> box, std::span<const Range> centre, RangeMatrix& rows);

 private:
  std::size_t variables_;
  std::vector<JudgedFunction> equations_;
  std::vector<JudgedFunction> inequalities_;
  RangeBox between_;
};

}  // namespace gcslab::verifier
