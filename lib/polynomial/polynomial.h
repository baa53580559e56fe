#pragma once

// Sparse multivariate polynomials with exact rational coefficients.
//
// A polynomial in n variables maps exponent vectors of length n to nonzero coefficients, in lexicographic
// order of the exponents. All operations are exact. Operands of one operation have the same number of
// variables.

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "expression/expression.h"
#include "interval/rational.h"

namespace gcslab {

/// The exponent (or the degree) of each variable; none is negative.
using Exponents = std::vector<int>;

class Polynomial {
 public:
  using Terms = std::map<Exponents, Rational>;

  /// The zero polynomial in that many variables.
  explicit Polynomial(int variables);
  static Polynomial constant(int variables, const Rational& value);
  static Polynomial variable(int variables, int number);

  int variables() const { return variables_; }
  const Terms& terms() const { return terms_; }
  bool is_zero() const { return terms_.empty(); }
  /// The coefficient of that monomial, 0 when it does not occur.
  Rational coefficient(const Exponents& exponents) const;
  /// The degree in each variable; all 0 for the zero polynomial.
  Exponents degrees() const;
  /// The largest sum of exponents; 0 for the zero polynomial.
  int total_degree() const;

  /// Adds coefficient * x^exponents.
  void add_term(const Exponents& exponents, const Rational& coefficient);
  Polynomial& operator+=(const Polynomial& other);
  Polynomial& operator-=(const Polynomial& other);
  Polynomial& operator*=(const Rational& factor);

  /// The partial derivative.
  Polynomial derivative(int variable) const;
  /// The exact value at a point, one coordinate a variable.
  Rational evaluate(std::span<const Rational> point) const;
  /// The polynomial with `value` put for a variable, which stays in the list but no longer occurs.
  Polynomial restrict(int variable, const Rational& value) const;
  /// The expanded sum of monomials, highest first, as an expression.
  Expression to_expression(ExpressionGraph& graph) const;

  friend bool operator==(const Polynomial&, const Polynomial&) = default;

 private:
  int variables_;
  Terms terms_;
};

Polynomial operator+(Polynomial a, const Polynomial& b);
Polynomial operator-(Polynomial a, const Polynomial& b);
Polynomial operator-(Polynomial a);
Polynomial operator*(const Polynomial& a, const Polynomial& b);
Polynomial operator*(Polynomial a, const Rational& factor);
Polynomial operator*(const Rational& factor, Polynomial a);
/// base^exponent, exponent >= 0. By repeated multiplication, which for sparse polynomials takes fewer steps
/// than repeated squaring (Fateman 1974).
Polynomial pow(const Polynomial& base, int exponent);

/// x^exponents as an expression: a product of powers, sqr for squares; 1 when all are 0.
Expression monomial_expression(ExpressionGraph& graph, const Exponents& exponents);

}  // namespace gcslab
