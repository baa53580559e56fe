#pragma once

// A system as polynomials, with a variable of its own for each term that is none (Smith and Pantelides 1999,
// Comput. Chem. Eng. 23:457, "symbolic reformulation"; for a polytope: Tahari 2011, section 5, on exp).
//
// Terms are quotients, roots, negative powers, functions, pi, and the arguments of functions that are not
// variables. They follow the variables x_0 .. x_{n-1} as x_n, x_{n+1}, .., each after those inside it, and
// stand for their expression wherever it occurs. Further equations say what polynomials can say of a term t:
// t = e for an argument e, t^2 = e for sqrt(e), t d = e for e / d, t e^k = 1 for e^-k. A function of one
// argument is left to the strips around its graph (graph_strips.h).
//
// Promise: where x solves the system, x followed by the values of the terms at x solves the lifted one.

#include <optional>
#include <vector>

#include "certification/system_functions.h"

namespace gcslab {

/// Where an expression stands: an equation or inequality, and the numbers of the operands on the way down.
struct ExpressionPlace {
  bool is_equation;
  std::size_t function;
  std::vector<int> operands;
};

struct Term {
  Expression expression;  ///< in the variables of the system
  ExpressionPlace place;  ///< one of those where it occurs
  /// The variable of the lifted system of which it is a function.
  std::optional<std::size_t> argument;
};

/// The terms of a system, each after those inside it.
std::vector<Term> terms_of(const SystemFunctions& functions);

class LiftedSystem {
 public:
  /// `functions` must outlive it.
  explicit LiftedSystem(const SystemFunctions& functions);

  /// The number of variables of the system, before its terms.
  std::size_t variables() const { return original_->variables(); }
  const std::vector<Term>& terms() const { return terms_; }
  /// The polynomials: equations, then what they say of terms; inequalities. The system itself without terms.
  const SystemFunctions& functions() const { return lifted_ ? *lifted_ : *original_; }

 private:
  const SystemFunctions* original_;
  std::vector<Term> terms_;
  std::optional<SystemFunctions> lifted_;
};

}  // namespace gcslab
