#pragma once

// Polynomial pieces exactly, as power series in the local parameter t of [0, 1], and their roots.

#include "spline/bezier_pieces.h"
#include "univariate/real_roots.h"

namespace gcslab {

/// sum_k c_k t^k, exactly; the last coefficients may be 0.
using PowerForm = std::vector<Rational>;

/// One a coordinate: c_k = binomial(d, k) times the k-th forward difference of the Bernstein coefficients at
/// 0.
std::vector<PowerForm> power_forms(const BezierPiece<Rational>& piece);

PowerForm product(const PowerForm& a, const PowerForm& b);
PowerForm sum(const PowerForm& a, const PowerForm& b);
PowerForm derivative(const PowerForm& a);
Rational value(const PowerForm& a, const Rational& t);
bool is_zero(const PowerForm& a);

/// The real roots of a polynomial in [0, 1], each in an interval no wider than 2^-bits; the ends of [0, 1]
/// are told exactly. None for the zero polynomial.
std::vector<RationalInterval> unit_roots(const PowerForm& a, int bits);

/// An interval that contains the values of the polynomial at the numbers between the two, which lie in
/// [-1, 1]: about the middle, by a bound of the derivative there.
RationalInterval range_on(const PowerForm& a, const RationalInterval& t);

/// A double interval around it, rounded outward.
Interval rounded(const RationalInterval& x);

}  // namespace gcslab
