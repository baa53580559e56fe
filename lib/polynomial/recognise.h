#pragma once

// Recognises an expression as a polynomial, exactly.
//
// Promise: the polynomial equals the expression wherever the expression is defined, which is everywhere.
// Accepted are rational constants, variables, + - *, division by a constant, sqr and integer powers >= 0;
// anything else gives the reason. Cancellation is not looked for: x/x is refused, sin(x) - sin(x) too.

#include <cstddef>
#include <optional>
#include <string>

#include "polynomial/polynomial.h"

namespace gcslab {

/// How far an expression may be expanded before it is refused.
struct RecognitionLimits {
  std::size_t terms = 200'000;       ///< terms of any polynomial on the way
  std::size_t products = 4'000'000;  ///< products of terms in all
  int degree = 100'000;              ///< total degree
  std::size_t bits = 1'000'000;      ///< of any coefficient, numerator and denominator together
};

struct Recognition {
  std::optional<Polynomial> polynomial;
  std::string reason;  ///< why there is none, for example "contains sin"; empty when there is one
};

/// `variables` is the number of variables of the polynomial; the expression uses none beyond.
Recognition recognise_polynomial(Expression expression, int variables, const RecognitionLimits& limits = {});

}  // namespace gcslab
