#pragma once

// The Bernstein polytope of a box (polytope.h) as exact half-spaces in one coordinate a monomial of the
// unknowns themselves, as Tahari 2011, section 5.1, writes and draws it: for x in [0, 1] and y for x^2 the
// triangle y >= 0, y >= 2x - 1, y <= x. The equations are left out.

#include "box_solver/polytope.h"
#include "linear_program/exact_polytope.h"
#include "polynomial/polynomial.h"

namespace gcslab {

/// Which of the solver's inequalities are taken.
enum class PolytopeParts {
  products,   ///< products of two bound factors: triangles and tetrahedra
  published,  ///< and (x_i - mid_i)^2 >= 0, (x_i - x_j)^2 >= 0 in the scaled unknowns, as in the source
  all         ///< and (x_i + x_j)^2 >= 0 in them, and the bounds of monomials of higher degree
};

struct MonomialPolytope {
  std::vector<Exponents> monomials;  ///< of the coordinates: the unknowns first
  std::vector<HalfSpace> half_spaces;
};

/// `polytope` must have been refilled from `expansion`.
MonomialPolytope monomial_polytope(const BernsteinPolytope& polytope,
                                   const Expansion<FastInterval>& expansion, PolytopeParts parts);

/// The simplex of the Bernstein polynomials of degree d over an interval, B_i >= 0, in the coordinates x, ...
/// , x^d: its vertices are the control points of the curve (x, ..., x^d).
MonomialPolytope bernstein_simplex(const Rational& lower, const Rational& upper, int degree);

}  // namespace gcslab
