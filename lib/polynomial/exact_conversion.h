#pragma once

// Coefficients of a polynomial on a box, exactly, in the Bernstein and in the power basis.
//
// Everything is integer arithmetic over one common denominator, so that no step cancels fractions: with x = X
// / Q, the polynomial becomes a form in (X, Z), Z = 1, in which the box is put by Taylor shifts.

#include "polynomial/polynomial.h"
#include "polynomial/rational_box.h"
#include "polynomial/tensor.h"

namespace gcslab {

/// Bernstein coefficients b with p(u + (v - u) t) = sum b_i B_i(t), t in [0, 1]^n. `degrees` may exceed those
/// of the polynomial; when empty, they are those of the polynomial. Throws NotApplicable when there are too
/// many.
Tensor<Rational> exact_bernstein_coefficients(const Polynomial& polynomial, const RationalBox& box,
                                              Exponents degrees = {});

/// Coefficients a with p((u + v)/2 + (v - u)/2 z) = sum a_k z^k, z in [-1, 1]^n.
Tensor<Rational> exact_power_coefficients(const Polynomial& polynomial, const RationalBox& box);

}  // namespace gcslab
