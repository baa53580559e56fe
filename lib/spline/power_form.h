#pragma once

// Pieces of curves exactly, as polynomials in the local parameter t of [0, 1] in the power basis, and roots
// of such polynomials.

#include "spline/rational_curve.h"
#include "univariate/real_roots.h"

namespace gcslab {

/// sum_k c_k t^k, exactly; the last coefficients may be 0.
using PowerForm = std::vector<Rational>;

PowerForm product(const PowerForm& a, const PowerForm& b);
PowerForm sum(const PowerForm& a, const PowerForm& b);
PowerForm scaled(const PowerForm& a, const Rational& factor);
PowerForm derivative(const PowerForm& a);
Rational value(const PowerForm& a, const Rational& t);
bool is_zero(const PowerForm& a);

/// The real roots of a polynomial in [0, 1], each in an interval no wider than 2^-bits; the ends of [0, 1]
/// are told exactly. None for the zero polynomial.
std::vector<RationalInterval> unit_roots(const PowerForm& a, int bits);

/// Whether it vanishes at any real number; zero does.
bool has_real_root(const PowerForm& a);

/// An interval that contains the values of the polynomial at the numbers between the two, which lie in
/// [-1, 1]: about the middle, by a bound of the derivative there.
RationalInterval range_on(const PowerForm& a, const RationalInterval& t);

/// The same of a / b, where b is positive on that interval, which must be narrow enough for it to show.
RationalInterval range_on(const PowerForm& a, const PowerForm& b, const RationalInterval& t);

/// A double interval around it, rounded outward.
Interval rounded(const RationalInterval& x);

/// One polynomial or rational piece of a curve, exactly: coordinates[c](t) / weight(t), t in [0, 1].
struct ExactPiece {
  Rational start;  ///< parameters of the curve at t = 0
  Rational end;    ///< and at t = 1
  std::vector<PowerForm> coordinates;
  PowerForm weight;         ///< positive; the number 1 for polynomial ones
  Matrix<Rational> points;  ///< control points, one a row: the piece lies in their convex hull

  std::size_t dimension() const { return coordinates.size(); }
  std::span<const Rational> first() const { return points.row(0); }
  std::span<const Rational> last() const { return points.row(points.rows() - 1); }
  Rational parameter(const Rational& t) const { return start + (end - start) * t; }
  RationalInterval parameters(const RationalInterval& t) const {
    return {parameter(t.lower), parameter(t.upper)};
  }
  /// The box of its control points.
  RationalBox box() const;
};

/// One a non-empty span, from left to right. Coefficient k is binomial(d, k) times the k-th forward
/// difference of the Bernstein coefficients.
std::vector<ExactPiece> exact_pieces(const BSplineCurve<Rational>& curve);
std::vector<ExactPiece> exact_pieces(const RationalCurve<Rational>& curve);

}  // namespace gcslab
