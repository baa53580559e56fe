#pragma once

// Random polynomials with a coefficient law that spreads the zero set over the whole box.
//
// Law `kostlan`: the coefficient of x^a is u * sqrt(d! / (a_1! ... a_n! (d - |a|)!)) with u uniform over the
// multiples of 2^-20 in [-1, 1]. With normal u this is the one Gaussian law that is invariant under rotations
// of projective space (Kostlan 1993), so zeros do not crowd near the border as with equal variances. Law
// `uniform`: the coefficient is u. The weight is the square root rounded to double and the coefficient is
// that double product, taken exactly: the same rational on every machine.

#include <cstdint>
#include <string>

#include "base/yaml_reader.h"
#include "expression/equation_system.h"
#include "polynomial/polynomial.h"

namespace gcslab {

struct RandomPolynomialOptions {
  int variables = 2;
  int total_degree = 10;
  std::string law = "kostlan";
  std::uint64_t seed = 1;
};

/// Every monomial of total degree at most `total_degree` gets a coefficient; monomials are drawn in
/// lexicographic order.
Polynomial random_polynomial(const RandomPolynomialOptions& options);

/// Reads a problem file whose key `generator` is {name: random_polynomial, total_degree, law, seed} in place
/// of `equations`.
EquationSystem read_random_polynomial(const YamlNode& problem, const YamlNode& generator);

}  // namespace gcslab
