#pragma once

// Multivariate Horner forms: a polynomial written so that it repeats its variables less often.
//
// Promise: the expression equals the polynomial. Over intervals its natural extension tends to be tighter
// than that of the expanded sum, and it needs fewer multiplications.
//
// Scheme: the variable that occurs in most terms is factored out of them, with the largest monomial m that
// they share: p = m q + r, and q and r are treated alike. (The greedy algorithm of Ceberio and Kreinovich,
// 2000, takes out one variable; taking the common monomial gives the same form with fewer steps.)
// Because m is the largest shared monomial, even powers stay even: x^4 + 2x^2 + 1 becomes x^2 (x^2 + 2) + 1,
// where x^2 is never negative, and not x (x (x^2 + 2)) + 1.

#include "polynomial/polynomial.h"

namespace gcslab {

Expression horner_form(const Polynomial& polynomial, ExpressionGraph& graph);

}  // namespace gcslab
