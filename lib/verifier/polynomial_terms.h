#pragma once

// An expression multiplied out into the monomials of its variables, exactly.

#include <map>
#include <optional>
#include <vector>

#include "expression/expression.h"
#include "interval/rational.h"

namespace gcslab::verifier {

/// Coefficients, none of them 0, by exponents, one a variable.
using PolynomialTerms = std::map<std::vector<int>, Rational>;

/// The terms of an expression made of rational constants, variables, + - *, division by a constant and powers
/// >= 0. Nothing for other expressions, and for those that grow beyond what the proof format expands: 2000
/// terms, degree 200, coefficients of 20,000 bits, 200,000 products of terms on the way.
std::optional<PolynomialTerms> polynomial_terms(Expression expression, std::size_t variables);

/// The same for a polynomial with irrational coefficients: its constants, expressions without variables, have
/// the exponents after those of the variables.
struct TermsWithConstants {
  PolynomialTerms terms;
  std::vector<Expression> constants;
};
std::optional<TermsWithConstants> terms_with_constants(Expression expression, std::size_t variables);

/// The largest sum of exponents; 0 without terms.
int total_degree(const PolynomialTerms& terms);

}  // namespace gcslab::verifier
