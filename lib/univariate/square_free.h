#pragma once

// Greatest common divisors and the square-free decomposition, exactly.

#include <vector>

#include "univariate/integer_polynomial.h"

namespace gcslab {

/// The primitive greatest common divisor; zero when both are zero. Coprime polynomials are mostly recognised
/// modulo a prime that does not divide a leading coefficient: the degree of the common divisor can only grow
/// there. Otherwise by pseudo-remainders made primitive (Collins 1967).
IntegerPolynomial greatest_common_divisor(const IntegerPolynomial& a, const IntegerPolynomial& b);

/// A factor whose roots are simple roots of it and roots of the whole of the given multiplicity.
struct SquareFreeFactor {
  IntegerPolynomial polynomial;  ///< primitive, of degree 1 at least
  int multiplicity;
};

/// The factors g_k of p = c prod g_k^k, by ascending k, without those that are constant: Yun's algorithm
/// (1976). They are square-free and have no common roots. p is not zero.
std::vector<SquareFreeFactor> square_free_decomposition(const IntegerPolynomial& p);

}  // namespace gcslab
